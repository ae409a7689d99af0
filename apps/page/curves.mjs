// Curves over time by uPlot: three panels of a quantity, with one cursor and one zoom, and values at the cursor.

import { RUNS } from "./runs.mjs";
import { element, parts, shown, text } from "./texts.mjs";
import { line_of } from "./theory.mjs";

/** Units of a kind of quantity, each with its size, and the least span of an axis, so that rounding does not fill a panel. */
const KINDS = {
    length: { units: [["mm", 1e-3], ["m", 1], ["km", 1000]], least: 1e-3 },
    speed: { units: [["mm/s", 1e-3], ["m/s", 1]], least: 1e-5 },
    angle: { units: [["″", Math.PI / 648000], ["′", Math.PI / 10800], ["°", Math.PI / 180]], least: Math.PI / 648000 / 100 },
    degrees: { units: [["°", Math.PI / 180]], least: Math.PI / 18000 },
    rate: { units: [["°/h", Math.PI / 648000], ["°/s", Math.PI / 180]], least: Math.PI / 648000 / 1000 },
    force: { units: [["mm/s²", 1e-3], ["m/s²", 1]], least: 1e-5 },
    time: { units: [["s", 1], ["min", 60], ["h", 3600]], least: 1 },
};

/** Quantities: the place of their name in the text "quantities", axes, kind, and triples of the points. The first is drawn on top. */
export const QUANTITIES = [
    { name: () => parts("quantities")[0], axes: "axes_enu", kind: "length", triples: ["position2", "position1"] },
    { name: () => parts("quantities")[1], axes: "axes_enu", kind: "speed", triples: ["velocity2", "velocity1"] },
    { name: () => text("Misalignment"), axes: "axes_enu", kind: "angle", triples: ["misalignment2", "misalignment1"] },
    { name: () => parts("quantities")[2], axes: "axes_rph", kind: "angle", triples: ["attitude2", "attitude1"] },
    { name: () => parts("quantities")[5], axes: "axes_rph", kind: "degrees", triples: ["attitude", "true_attitude"], names: "values" },
    { name: () => parts("quantities")[6], axes: "axes_enu", kind: "speed", triples: ["velocity", "true_velocity"], names: "values" },
    { name: () => parts("quantities")[3], axes: "axes_xyz", kind: "rate", triples: ["rate"] },
    { name: () => parts("quantities")[4], axes: "axes_xyz", kind: "force", triples: ["force"] },
];

/** The largest unit in which a value is at least 2; the first one for small values. */
export function unit_of(kind, largest) {
    const { units } = KINDS[kind];
    return units.findLast(([, size]) => largest >= 2 * size) ?? units[0];
}

/** Most flights whose curves are kept. */
export const MOST_KEPT = 4;

/** A column over time at other times: between two points on the line through them, and nothing beyond the last one. */
export function at_times(times, column, wanted) {
    let k = 0;
    return Array.from(wanted, (time) => {
        while (k < times.length && times[k] < time) k++;
        if (k === times.length) return null;
        if (k === 0 || times[k] === time) return times[k] === time ? column[k] : null;
        return column[k - 1] + ((column[k] - column[k - 1]) * (time - times[k - 1])) / (times[k] - times[k - 1]);
    });
}

/** Numbers at an axis in one notation: as many decimals at each, or a power of ten at each. */
export function tick_texts(ticks) {
    const texts = ticks.map((tick) => shown(tick, 6)), decimals = (own) => own.split(".")[1]?.length ?? 0;
    if (!texts.some((own) => own.includes("e"))) {
        const most = Math.max(0, ...texts.map(decimals));
        return ticks.map((tick) => tick.toFixed(most).replace(/^-(0\.?0*)$/, "$1"));
    }
    const digits = texts.map((_, k) => decimals(String(Number(ticks[k].toPrecision(6)).toExponential()).split("e")[0]));
    return ticks.map((tick) => (tick === 0 ? "0" : tick.toExponential(Math.max(...digits))));
}

const largest_of = (columns) => columns.reduce((most, column) => column.reduce((own, value) => Math.max(own, Math.abs(value)), most), 0);

/** A colour of the style sheet. */
export const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

export class Curves {
    /** target: the element for the panels. */
    constructor(target) {
        [this.target, this.plots, this.key, this.points, this.marks, this.kept, this.theory] = [target, [], "", null, [], [], () => null];
        new ResizeObserver(() => this.resize()).observe(target);
    }

    /** From the next drawing on: marks, [{at_s, name}], a function that says what theory says, and the whole time instead of an enlarged part. */
    look_at(marks, theory) {
        [this.marks, this.theory, this.key] = [marks, theory, ""];
    }

    /** Keeps the curves of the flight that is shown, by a name; they stay until they are forgotten. */
    keep(name) {
        if (this.points && this.kept.length < MOST_KEPT) this.kept.push({ name, points: this.points });
    }

    /** Shows a quantity of the points. has_model: whether there is error data 1. band: that of many runs, or null. */
    show(quantity, points, has_model, band) {
        [this.quantity, this.points, this.has_model] = [quantity, points, has_model];
        if (!points?.time.length) return this.clear();
        const triples = quantity.triples.filter((name, k) => k === 0 || quantity.names || has_model);
        const columns = triples.map((name) => points[name]), { time } = points, [time_unit, time_size] = unit_of("time", time.at(-1));
        const banded = band?.[triples[0]];
        const names = parts(quantity.names ?? "data"), axes = parts(quantity.axes), theory = triples[0] === "misalignment2" ? this.theory() : null;
        const panels = axes.map((axis, k) => {
            const kept = this.kept.map(({ points: { time: times, [triples[0]]: triple } }) => at_times(times, triple[k], time));
            const edges = (banded?.[k] ?? []).map((edge) => at_times(band.time, edge, time));
            if (theory?.axis === k) kept.push(line_of(theory, time, points[triples[0]][k]));
            const own = columns.map((triple) => triple[k]), [unit, size] = unit_of(quantity.kind, largest_of([...edges, ...kept, ...own]));
            const scaled = (column, by) => column.map((value) => (value === null ? null : value / by));
            return { axis, unit, size, data: [scaled(time, time_size), ...[...edges, ...kept, ...own.toReversed()].map((column) => scaled(column, size))] };
        });
        this.time_size = time_size;
        const key = JSON.stringify([quantity.axes, quantity.kind, quantity.name(), triples, this.kept.map(({ name }) => name), theory?.axis, Boolean(banded), time_unit, panels.map(({ unit }) => unit), matchMedia("(prefers-color-scheme: dark)").matches]);
        if (key !== this.key) {
            this.key = key;
            this.plots.forEach((plot) => plot.destroy());
            this.target.replaceChildren();
            const labels = triples.map((_, at) => names[at]).toReversed();
            this.plots = panels.map((panel, k) => this.make(panel, labels, time_unit, k === panels.length - 1, Boolean(banded), theory?.axis === k));
        }
        panels.forEach(({ data, axis, unit }, k) => {
            const plot = this.plots[k], is_whole = !plot.is_zoomed;
            plot.setData(data, is_whole);
            if (!is_whole) plot.redraw();
            const last = data.at(-1).at(-1);
            const edges = banded ? `; ${text("band", RUNS - 2, RUNS)}: ${data.slice(1, 3).map((edge) => shown(edge.at(-1) ?? NaN, 4)).join(" … ")} ${unit}` : "";
            plot.root.setAttribute("aria-label", `${quantity.name()}, ${axis}: ${last === undefined ? "-" : shown(last, 4)} ${unit}${edges}`);
        });
    }

    /** Without a flight there is a sentence, and no axes. */
    clear() {
        this.plots.forEach((plot) => plot.destroy());
        [this.plots, this.key] = [[], ""];
        this.target.replaceChildren(element("p", { class: "nothing" }, text("no_curves")));
    }

    make({ axis, unit, size, data }, labels, time_unit, is_last, has_band, has_theory) {
        const { least } = KINDS[this.quantity.kind], ink = colour("ink"), grid = { stroke: colour("grid"), width: 1 };
        const own_axis = { stroke: ink, grid, ticks: grid, font: "12px system-ui, sans-serif", labelFont: "12px system-ui, sans-serif" };
        const is_two = labels.length === 2;
        const line = (label, stroke, width) => ({ label, stroke: colour(stroke), width, value: (_, value) => (value === null ? "" : `${shown(value, 5)} ${unit}`), points: { show: false } });
        const kept = this.kept.map(({ name }, k) => line(name, `kept${k}`, 1.25));
        if (has_theory) kept.push({ ...line(text("theory"), "sensors", 5), dash: [12, 12] });
        const edges = has_band ? [text("band", RUNS - 2, RUNS), "…"].map((name) => line(name, "data2", 0.5)) : [];
        const series = [...edges, ...kept, ...labels.map((label, k) => line(label, is_two && k === 0 ? "data1" : "data2", is_two && k === 0 ? 3 : 1.25))];
        const plot = new uPlot(
            {
                ...this.sizes(is_last),
                padding: [10, 14, 0, 0],
                scales: {
                    x: { time: false, range: (_, low, high) => (low === high ? [low, low + 1] : [low, high]) },
                    y: { range: (_, low, high) => spread(low, high, least / size) },
                },
                series: [{ label: text("time"), value: (_, value) => (value === null ? "" : `${shown(value, 6)} ${time_unit}`) }, ...series],
                bands: has_band ? [{ series: [2, 1], fill: colour("band") }] : [],
                axes: [
                    { ...own_axis, size: is_last ? 46 : 16, ...(is_last ? { label: `${text("time")} [${time_unit}]`, labelSize: 18, values: (_, ticks) => tick_texts(ticks) } : { values: () => [] }) },
                    { ...own_axis, size: 62, label: `${axis} [${unit}]`, labelSize: 18, values: (_, ticks) => tick_texts(ticks) },
                ],
                cursor: { sync: { key: "time" }, drag: { x: true, y: false } },
                hooks: { setScale: [(own, name) => name === "x" && note_zoom(own)], draw: [(own) => this.draw_marks(own)] },
            },
            data,
            this.target,
        );
        plot.root.setAttribute("role", "img");
        plot.root.tabIndex = 0;
        plot.root.title = text("plot_tip");
        plot.root.onkeydown = (event) => this.on_key(event, plot);
        return plot;
    }

    /** Times with a name, as dashed lines; the first panel has the names. */
    draw_marks(plot) {
        const { ctx: paint, bbox } = plot, { min, max } = plot.scales.x;
        paint.save();
        [paint.strokeStyle, paint.fillStyle, paint.lineWidth, paint.font] = [colour("sensors"), colour("sensors"), devicePixelRatio, `${12 * devicePixelRatio}px system-ui, sans-serif`];
        [paint.textAlign, paint.textBaseline] = ["left", "alphabetic"];
        paint.setLineDash([5 * devicePixelRatio, 4 * devicePixelRatio]);
        for (const { at_s, name } of this.marks) {
            const time = at_s / this.time_size, x = plot.valToPos(time, "x", true), wide = paint.measureText(name).width;
            if (time < min || time > max) continue;
            paint.beginPath();
            paint.moveTo(x, bbox.top);
            paint.lineTo(x, bbox.top + bbox.height);
            paint.stroke();
            const margin = 4 * devicePixelRatio, is_right = x + margin + wide < bbox.left + bbox.width;
            if (plot === this.plots[0]) paint.fillText(name, is_right ? x + margin : x - margin - wide, bbox.top + 12 * devicePixelRatio);
        }
        paint.restore();
    }

    /** Arrow keys move the cursor, plus and minus zoom around it, escape shows all. */
    on_key(event, plot) {
        const { min, max } = plot.scales.x, times = plot.data[0], at = plot.cursor.idx ?? times.length - 1;
        const step = { ArrowLeft: -1, ArrowRight: 1, PageUp: -50, PageDown: 50, Home: -Infinity, End: Infinity }[event.key];
        const zoom = { "+": 0.5, "-": 2, Escape: Infinity }[event.key];
        if (times.length === 0 || (step === undefined && zoom === undefined)) return;
        event.preventDefault();
        if (step !== undefined) {
            const to = Math.max(0, Math.min(times.length - 1, at + step));
            for (const own of this.plots) own.setCursor({ left: own.valToPos(times[to], "x"), top: own.over.clientHeight / 2 });
        } else {
            const half = (zoom * (max - min)) / 2, [first, last] = [times[0], times.at(-1)];
            const [low, high] = [Math.max(first, times[at] - half), Math.min(last, times[at] + half)];
            for (const other of this.plots) other.setScale("x", { min: low, max: high });
        }
    }

    sizes(is_last) {
        return { width: Math.max(200, this.target.clientWidth), height: (innerWidth < 600 ? 130 : 205) + (is_last ? 34 : 0) };
    }

    resize() {
        this.plots.forEach((plot, k) => plot.setSize(this.sizes(k === this.plots.length - 1)));
    }

    /** The panels as a picture. */
    picture(title) {
        const canvases = this.plots.map((plot) => plot.ctx.canvas), scale = devicePixelRatio, head = Math.round(30 * scale);
        const picture = element("canvas"), paint = picture.getContext("2d");
        picture.width = canvases[0].width;
        picture.height = canvases.reduce((sum, own) => sum + own.height, head);
        paint.fillStyle = colour("paper");
        paint.fillRect(0, 0, picture.width, picture.height);
        paint.fillStyle = colour("ink");
        paint.font = `${14 * scale}px system-ui, sans-serif`;
        paint.fillText(title, 10 * scale, 20 * scale, picture.width - 20 * scale);
        canvases.reduce((top, own) => (paint.drawImage(own, 0, top), top + own.height), head);
        return new Promise((done) => picture.toBlob(done, "image/png"));
    }
}

function note_zoom(plot) {
    const times = plot.data[0], { min, max } = plot.scales.x;
    plot.is_zoomed = times.length > 1 && (min > times[0] || max < times.at(-1));
}

/** A range of an axis with its least span. */
function spread(low, high, least) {
    if (low === null || low === undefined) return [-1, 1];
    const middle = (low + high) / 2, half = Math.max((high - low) * 0.55, least / 2);
    return [middle - half, middle + half];
}
