// The map: the true track and that of the INS, in kilometres east and north of the start, by uPlot.

import { colour, tick_texts } from "./curves.mjs";
import { parts, text } from "./texts.mjs";

const RADIUS_KM = 6371;

/** Kilometres east and north of a place: equidistant from it, so that poles and the date line are places like others. */
export function plane([latitudes, longitudes]) {
    const count = latitudes.length, east = new Float64Array(count), north = new Float64Array(count);
    const [sin0, cos0] = [Math.sin(latitudes[0]), Math.cos(latitudes[0])];
    for (let k = 0; k < count; k++) {
        const [sin, cos] = [Math.sin(latitudes[k]), Math.cos(latitudes[k])], by = longitudes[k] - longitudes[0];
        const [x, y, z] = [cos * Math.sin(by), cos0 * sin - sin0 * cos * Math.cos(by), sin0 * sin + cos0 * cos * Math.cos(by)];
        const off = Math.hypot(x, y), scale = off === 0 ? 0 : (RADIUS_KM * Math.atan2(off, z)) / off;
        [east[k], north[k]] = [scale * x, scale * y];
    }
    return [east, north];
}

export class Track {
    constructor(target) {
        [this.target, this.tracks, this.plot] = [target, [], null];
        new ResizeObserver(() => this.plot?.setSize(this.size())).observe(target);
    }

    /** Shows tracks: [latitudes, longitudes] of the truth, and of the INS from the same place on. */
    show(places) {
        this.tracks = places.filter((place) => place?.[0].length > 0).map((place) => {
            const from = places.find((own) => own?.[0].length > 0);
            return plane([[from[0][0], ...place[0]], [from[1][0], ...place[1]]]).map((column) => column.subarray(1));
        });
        if (this.tracks.length === 0) return this.clear();
        const bounds = [0, 1].map((axis) => this.tracks.flatMap((track) => [track[axis].reduce((a, b) => Math.min(a, b)), track[axis].reduce((a, b) => Math.max(a, b))]));
        this.bounds = bounds.map((own) => [Math.min(...own), Math.max(...own)]);
        const key = JSON.stringify([text("Map"), matchMedia("(prefers-color-scheme: dark)").matches]);
        if (key !== this.key) {
            this.plot?.destroy();
            [this.key, this.plot] = [key, this.make()];
        }
        this.plot.setData(this.data());
    }

    clear() {
        this.plot?.destroy();
        [this.plot, this.key] = [null, ""];
    }

    /** Of both tracks. */
    data() {
        return [null, ...[0, 1].map((k) => this.tracks[k] ?? [[], []])];
    }

    make() {
        const grid = { stroke: colour("grid"), width: 1 }, font = "12px system-ui, sans-serif", names = parts("values");
        const axis = (name) => ({ stroke: colour("ink"), grid, ticks: grid, font, labelFont: font, labelSize: 18, label: `${name} [km]`, space: 45, values: (_, ticks) => tick_texts(ticks) });
        const [east, north] = parts("axes_enu");
        const line = (label, ink, width) => ({ label, stroke: colour(ink), facets: [{ scale: "x", auto: true }, { scale: "y", auto: true }], paths: track_path(colour(ink), width) });
        const series = [line(names[1], "data1", 3), line(names[0], "data2", 1.25)];
        const plot = new uPlot(
            {
                ...this.size(),
                mode: 2,
                padding: [10, 14, 0, 0],
                scales: { x: { time: false, range: (own) => this.range(own, 0) }, y: { range: (own) => this.range(own, 1) } },
                series: [null, ...series],
                axes: [{ ...axis(east), size: 40 }, { ...axis(north), size: 52 }],
                cursor: { show: false },
                legend: { live: false },
            },
            this.data(),
            this.target,
        );
        plot.root.setAttribute("role", "img");
        plot.root.setAttribute("aria-label", text("Map"));
        return plot;
    }

    /** The range of an axis: a kilometre has the same length on both. */
    range(plot, axis) {
        const [wide, high] = [plot.bbox?.width || 300, plot.bbox?.height || 300], spans = this.bounds.map(([low, top]) => Math.max(top - low, 0.02) * 1.1);
        const per_pixel = Math.max(spans[0] / wide, spans[1] / high), half = (per_pixel * (axis ? high : wide)) / 2;
        const middle = (this.bounds[axis][0] + this.bounds[axis][1]) / 2;
        return [middle - half, middle + half];
    }

    size() {
        const width = Math.max(200, this.target.clientWidth);
        return { width, height: Math.min(width, 380) };
    }
}

/** Draws a track as a line, and its end as a dot. */
function track_path(ink, width) {
    return (plot, at) => {
        const [xs, ys] = plot.data[at], { ctx } = plot, scale = devicePixelRatio;
        const [to_x, to_y] = [(value) => plot.valToPos(value, "x", true), (value) => plot.valToPos(value, "y", true)];
        ctx.save();
        ctx.beginPath();
        ctx.rect(plot.bbox.left, plot.bbox.top, plot.bbox.width, plot.bbox.height);
        ctx.clip();
        [ctx.strokeStyle, ctx.fillStyle, ctx.lineWidth, ctx.lineJoin] = [ink, ink, width * scale, "round"];
        ctx.beginPath();
        for (let k = 0; k < xs.length; k++) ctx.lineTo(to_x(xs[k]), to_y(ys[k]));
        ctx.stroke();
        if (xs.length) {
            ctx.beginPath();
            ctx.arc(to_x(xs.at(-1)), to_y(ys.at(-1)), (2 + width) * scale, 0, 7);
            ctx.fill();
        }
        ctx.restore();
        return null;
    };
}
