// What theory says of the curves of a lesson, as a line beside them.
/** By the name in a lesson: of a scene the axis, the rate in SI and the times between which it holds, or null where it says nothing. */
export const THEORIES = {
    /** One reading of the gyros in each sample interval T, on a cone of half angle a: about the up axis it loses ½ a² ω (1 - sin(ωT)/(ωT)). */
    coning(scene) {
        const number = (key) => Number.parseFloat(scene.get(key)), of = (k, name) => number(`manoeuvre[0].sinusoid[${k}].${name}`);
        const radians = (k, name) => (of(k, name) * Math.PI) / 180, w = 2 * Math.PI * of(0, "frequency_hz"), x = w / number("flight.rate_hz"), ramp_s = number("manoeuvre[0].ramp_s");
        const cone = radians(0, "amplitude_deg") * radians(1, "amplitude_deg") * Math.sin(radians(1, "phase_deg") - radians(0, "phase_deg"));
        const rate = of(1, "frequency_hz") === of(0, "frequency_hz") ? ((cone * w) / 2) * (1 - Math.sin(x) / x) : NaN;
        return number("options.subsamples") === 1 && Number.isFinite(rate) ? { axis: 2, rate, from_s: ramp_s, to_s: number("manoeuvre[0].duration_s") - ramp_s } : null;
    },
};

/** The line over the times, from the curve on where it begins to hold; nothing elsewhere. */
export function line_of(theory, times, column) {
    const begin = times.findIndex((time) => time >= theory.from_s);
    return Array.from(times, (time, k) => (begin < 0 || k < begin || time > theory.to_s ? null : column[begin] + theory.rate * (time - times[begin])));
}
