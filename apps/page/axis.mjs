// The vertical axis of the body in three dimensions: where its tip was, and where it and the forward axis of the truth and of the INS are.

import { colour } from "./curves.mjs";
import { DEGREE } from "./instruments.mjs";
import { element, parts, shown, text } from "./texts.mjs";

/** The direction from which one looks: about the vertical, and above the horizon. */
const [ROUND, ABOVE] = [-25 * DEGREE, 32 * DEGREE];

/** East, north and up of the forward and the vertical axis of a body with this roll, pitch and heading. */
export function axes_of([roll, pitch, heading]) {
    const [[sr, cr], [sp, cp], [sh, ch]] = [roll, pitch, heading].map((angle) => [Math.sin(angle), Math.cos(angle)]);
    return { forward: [sh * cp, ch * cp, sp], up: [ch * sr - sh * sp * cr, -sh * sr - ch * sp * cr, cp * cr] };
}

/** Right and up on the screen of east, north and up. */
function on_screen([east, north, up]) {
    const [x, away] = [Math.cos(ROUND) * east - Math.sin(ROUND) * north, Math.sin(ROUND) * east + Math.cos(ROUND) * north];
    return [x, Math.cos(ABOVE) * up + Math.sin(ABOVE) * away];
}

export class Axis {
    constructor() {
        this.canvas = element("canvas", { role: "img", width: 10, height: 10 });
        this.made = element("figure", { class: "axis", hidden: true }, element("figcaption", {}, text("body_axes")), this.canvas, element("p", { class: "hint" }, text("body_axes_what")));
    }

    /** Draws the points of a flight, or nothing. */
    show(points) {
        const { canvas } = this, [wide, high] = [canvas.clientWidth, canvas.clientHeight].map((size) => Math.round((size || 10) * devicePixelRatio)), paint = canvas.getContext("2d");
        [canvas.width, canvas.height] = [wide, high];
        const count = points?.time.length ?? 0, at = (triple, k) => axes_of(triple.map((column) => column[k])), size = Math.min(0.72 * high, 0.44 * wide);
        if (count === 0) return canvas.setAttribute("aria-label", `${text("body_axes")}: -`);
        const place = (axis) => on_screen(axis).map((own, k) => (k === 0 ? wide / 2 + size * own : 0.7 * high - size * own));
        const line = (ink, width, ...axes) => {
            paint.beginPath();
            axes.forEach((axis) => paint.lineTo(...place(axis)));
            [paint.strokeStyle, paint.lineWidth] = [colour(ink), width * devicePixelRatio];
            paint.stroke();
        };
        const circle = Array.from({ length: 73 }, (_, k) => [Math.sin(5 * k * DEGREE), Math.cos(5 * k * DEGREE), 0]);
        line("edge", 1, ...circle);
        for (const end of [[0, 1, 0], [1, 0, 0], [0, 0, 1]]) line("edge", 1, [0, 0, 0], end);
        [paint.fillStyle, paint.font, paint.textAlign] = [colour("ink"), `${12 * devicePixelRatio}px system-ui, sans-serif`, "center"];
        parts("axes_enu").forEach((name, k) => paint.fillText(name, ...place([0, 1, 2].map((own) => (own === k ? 1.12 : 0)))));
        paint.fillStyle = colour("data1");
        let far = 1;
        for (let k = 0; k < count; k++) {
            const { up } = at(points.true_attitude, k), [x, y] = place(up);
            far = Math.min(far, up[2]);
            paint.fillRect(x - devicePixelRatio, y - devicePixelRatio, 2 * devicePixelRatio, 2 * devicePixelRatio);
        }
        for (const [triple, ink, width] of [[points.true_attitude, "data1", 3.5], [points.attitude, "data2", 1.5]]) {
            const { forward, up } = at(triple, count - 1);
            line(ink, width, forward, [0, 0, 0], up);
        }
        const turned = at(points.attitude, count - 1).forward, own = at(points.true_attitude, count - 1).forward;
        const between = Math.atan2(turned[0] * own[1] - turned[1] * own[0], turned[0] * own[0] + turned[1] * own[1]) / DEGREE;
        canvas.setAttribute("aria-label", `${text("body_axes")}: ${text("body_axes_told", shown(Math.acos(far) / DEGREE, 2), shown(between, 2))}`);
    }
}
