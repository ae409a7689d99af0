// What a flight says in numbers: its sentence, and the table of values.

import { unit_of } from "./curves.mjs";
import { FINISHED } from "./flight.mjs";
import { DEGREE } from "./instruments.mjs";
import { parts, shown, text } from "./texts.mjs";

const NMI_H = 1852 / 3600;

/** A time in the largest unit that fits. */
export function duration(time_s) {
    const [unit, size] = unit_of("time", time_s);
    return `${shown(time_s / size, 4)} ${unit}`;
}

/** How far the INS is from the truth at the end of a flight, as a sentence, or "". */
export function answer(now) {
    if (now?.state !== FINISHED || !now.record) return "";
    const error_m = Math.hypot(...now.record.navigation_errors.position_enu_m), [unit, size] = unit_of("length", error_m);
    return text("answer", duration(now.time_s), `${shown(error_m / size, 3)} ${unit}`);
}

/** The table of values: the name, then the solution and the truth; or one value. */
export function rows(now) {
    const names = parts("progress"), { record, accuracy } = now ?? {};
    if (!record) return [];
    const { truth, navigation, navigation_errors: errors, model_errors: model } = record;
    const several = (values, size, digits) => Array.from(values, (value) => (value / size).toFixed(digits).replace(/^-(0\.0*)$/, "$1")).join(" ");
    const both = (show) => [show(navigation), show(truth)];
    const attitude = ({ roll_rad, pitch_rad, heading_rad }) => several([roll_rad, pitch_rad, heading_rad], DEGREE, 2).replace(/ 360\.00$/, " 0.00");
    const is_known = (own) => (own.flags & 4) === 0; // SINS_ERRORS_NOT_COMPUTED
    const all = [
        [names[0], ...both((own) => (own.latitude_rad / DEGREE).toFixed(6))],
        [names[1], ...both((own) => (own.longitude_rad / DEGREE).toFixed(6))],
        [names[2], ...both((own) => own.height_m.toFixed(1))],
        [names[3], ...both((own) => several(own.velocity_enu_m_s, 1, 2))],
        [names[4], ...both(attitude)],
        [names[6], several(errors.position_enu_m, 1, 2)],
        is_known(model) && [names[7], several(model.position_enu_m, 1, 2)],
        [names[8], several(errors.velocity_enu_m_s, 1, 4)],
        [names[9], several(errors.misalignment_enu_rad, DEGREE / 60, 3)],
        accuracy && [names[10], several(accuracy.closure_position_enu_m, 1, 2)],
        accuracy?.has_rates && [names[11], shown(accuracy.cep_rate_m_s / NMI_H, 4)],
        accuracy?.has_rates && [names[12], shown(accuracy.radial_95_rate_m_s / NMI_H, 4)],
    ];
    return all.filter(Boolean);
}
