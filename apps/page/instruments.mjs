// The instruments: attitude indicators of the truth and of the INS, and the panel of the INS with its lamps, displays and buttons.

import { element, options, parts, text } from "./texts.mjs";

export const DEGREE = Math.PI / 180;
const KNOT = 1852 / 3600;
/** Degrees of pitch from the middle of an indicator to its rim. */
const RIM = 35 * DEGREE;

const heading_of = (rad) => `${String(((Math.round(rad / DEGREE) % 360) + 360) % 360).padStart(3, "0")}°`;

/** An attitude indicator; up on it is up on the screen at roll 0. */
export class Indicator {
    constructor(title) {
        this.canvas = element("canvas", { role: "img", width: 10, height: 10 });
        this.made = element("figure", { class: "indicator" }, element("figcaption", {}, title), this.canvas, (this.heading = element("output", {}, "---")));
        this.title = title;
        this.show(null);
    }

    /** attitude: [roll, pitch, heading], or null without one; a heading of null is not valid. */
    show(attitude) {
        const heading = attitude && attitude[2] !== null ? heading_of(attitude[2]) : "---";
        const [roll, pitch] = (attitude ?? []).map((angle) => (angle === null ? "-" : (angle / DEGREE).toFixed(1)));
        this.heading.value = heading;
        this.canvas.setAttribute("aria-label", attitude ? `${this.title}: ${parts("axes_rph").map((axis, k) => `${axis} ${[`${roll}°`, `${pitch}°`, heading][k]}`).join(", ")}` : `${this.title}: -`);
        const size = Math.round((this.canvas.clientWidth || 130) * devicePixelRatio), half = size / 2;
        [this.canvas.width, this.canvas.height] = [size, size];
        const paint = this.canvas.getContext("2d");
        paint.translate(half, half);
        paint.arc(0, 0, half - 1, 0, 7);
        paint.clip();
        if (attitude) this.ball(paint, half, attitude);
        else {
            fill(paint, "#0e0e0e", -half, -half, size, size);
            [paint.fillStyle, paint.font, paint.textAlign, paint.textBaseline] = ["#f04638", `bold ${half / 3}px sans-serif`, "center", "middle"];
            paint.fillText("ATT", 0, 0);
        }
    }

    ball(paint, half, [roll, pitch]) {
        const by = half / RIM;
        paint.save();
        paint.rotate(-roll);
        paint.translate(0, pitch * by);
        fill(paint, "#468cdc", -3 * half, -20 * half, 6 * half, 20 * half);
        fill(paint, "#8c5f32", -3 * half, 0, 6 * half, 20 * half);
        [paint.strokeStyle, paint.lineWidth] = ["#f0f0f0", Math.max(1, half / 50)];
        for (let step = -16; step <= 16; step++) {
            const wide = step === 0 ? 3 * half : half * (step % 2 === 0 ? 0.3 : 0.15);
            line(paint, [-wide, -step * 5 * DEGREE * by], [wide, -step * 5 * DEGREE * by]);
        }
        paint.restore();
        [paint.strokeStyle, paint.lineWidth] = ["#ffbe3c", half / 18];
        line(paint, [-0.6 * half, 0], [-0.22 * half, 0], [-0.22 * half, 0.1 * half]);
        line(paint, [0.6 * half, 0], [0.22 * half, 0], [0.22 * half, 0.1 * half]);
        line(paint, [-1, 0], [1, 0]);
        paint.beginPath();
        paint.moveTo(0, -half + 2);
        paint.lineTo(-0.08 * half, -0.84 * half);
        paint.lineTo(0.08 * half, -0.84 * half);
        paint.fillStyle = "#ffbe3c";
        paint.fill();
    }
}

function fill(paint, ink, ...box) {
    paint.fillStyle = ink;
    paint.fillRect(...box);
}

function line(paint, ...points) {
    paint.beginPath();
    for (const [x, y] of points) paint.lineTo(x, y);
    paint.stroke();
}

/** An angle in degrees and minutes: N 39°54.0. */
function place_of(rad, letters, width) {
    const tenths = Math.round((Math.abs(rad) / DEGREE) * 600), degrees = Math.floor(tenths / 600);
    return `${letters[rad < 0 ? 1 : 0]}${String(degrees).padStart(width, "0")}°${((tenths % 600) / 10).toFixed(1).padStart(4, "0")}`;
}

/** The panel of the INS. act(kind, values) is called for each action, in the words of [[panel]]; values() gives what was entered, or throws. */
export class Panel {
    constructor(sins, act) {
        this.sins = sins;
        const button = (name, kind, values) => element("button", { onclick: () => act(kind, values), "data-act": kind }, name);
        const entries = parts("entries").map((name) => element("input", { "aria-label": `${name} [°]`, placeholder: `${name} [°]`, inputmode: "decimal", autocomplete: "off" }));
        const number = (entry) => {
            const value = entry.value.trim();
            if (value === "" || !Number.isFinite(Number(value))) throw new Error(text("not_a_number", entry.placeholder, value));
            return value;
        };
        const position = () => ({ latitude_deg: number(entries[0]), longitude_deg: number(entries[1]) });
        const power = element("select", { "aria-label": text("Power") }, ...options(parts("powers").map((name, k) => [String(k), name])));
        power.onchange = () => act(["aircraft_power", "battery", "no_power"][power.selectedIndex]);
        this.lamps = ["ALIGN", "NAV RDY", "FAULT", "ON BATT"].map((name) => element("span", { class: "lamp" }, name));
        this.displays = [element("output", { class: "display" }, "--- ---"), element("output", { class: "display" }, "GS ---  TK ---")];
        this.state = element("output", { class: "unit_state" });
        this.modes = ["OFF", "ALIGN", "NAV", "ATT", "TEST"].map((name) => button(name, name.toLowerCase()));
        this.made = element(
            "fieldset",
            { class: "panel" },
            element("legend", {}, text("Panel of the INS")),
            element("div", { class: "bar" }, ...this.lamps),
            ...this.displays,
            element("div", { class: "bar" }, ...this.modes, power),
            element("div", { class: "bar" }, entries[0], entries[1], button(text("Enter 1").replace(/ ?1$/, ""), "position", position)),
            element("div", { class: "bar" }, button(text("Enter the true position"), "true_position")),
            element("div", { class: "bar" }, entries[2], button(text("Enter 2").replace(/ ?2$/, ""), "heading", () => ({ heading_deg: number(entries[2]) }))),
            this.state,
        );
    }

    /** unit: {status, shown} of the unit, or null. */
    show(unit) {
        const { sins } = this, lit = (flag) => unit !== null && (unit.status.annunciators & flag) !== 0;
        const on = [sins.UNIT_ALIGN_LIT, sins.UNIT_NAV_READY, sins.UNIT_FAULT, sins.UNIT_ON_BATTERY].map(lit);
        this.lamps.forEach((lamp, k) => lamp.classList.toggle("lit", on[k]));
        this.lamps[0].classList.toggle("flashing", lit(sins.UNIT_ALIGN_FLASHES));
        this.modes.forEach((mode, k) => mode.setAttribute("aria-pressed", String(unit?.status.mode === k)));
        if (!unit) return;
        const { status, shown } = unit, valid = (flag) => (shown.validity & flag) !== 0, [east, north] = shown.velocity_enu_m_s;
        const speed_kt = Math.hypot(east, north) / KNOT, track = speed_kt < 50 ? "---" : heading_of(Math.atan2(east, north));
        this.displays[0].value = valid(sins.UNIT_VALID_POSITION) ? `${place_of(shown.latitude_rad, "NS", 2)} ${place_of(shown.longitude_rad, "EW", 3)}` : "--- ---";
        this.displays[1].value = valid(sins.UNIT_VALID_VELOCITY) ? `GS ${speed_kt.toFixed()}  TK ${track}` : "GS ---  TK ---";
        const reasons = parts("unit_reasons").filter((_, k) => (status.reasons >> k) & 1);
        const to_go = status.minutes_to_go > 0 ? [`${status.minutes_to_go} min`] : [];
        const state = [[parts("unit_states")[status.state], ...to_go].join(", "), ...reasons].join("; ");
        if (this.state.value !== state) this.state.value = state;
    }

    /** Attitude of the INS for its indicator. */
    attitude({ shown }) {
        const { UNIT_VALID_ATTITUDE, UNIT_VALID_HEADING } = this.sins;
        if ((shown.validity & UNIT_VALID_ATTITUDE) === 0) return null;
        return [shown.roll_rad, shown.pitch_rad, (shown.validity & UNIT_VALID_HEADING) !== 0 ? shown.heading_rad : null];
    }
}
