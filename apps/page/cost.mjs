// What accuracy costs: sliders for the algorithm, and its error and time, measured here and now, as a point in a diagram.

import { colour } from "./curves.mjs";
import { FINE } from "./measure.mjs";
import { element, shown, text } from "./texts.mjs";

const RATES_HZ = [10, 20, 25, 50, 100, 200, 400];
const SUBSAMPLES = [1, 2, 3, 4, 5];
/** How near to a point a click must be [pixels]. */
const REACH = 12;
/** Least error in the diagram: below it is rounding [m]. */
const LEAST_M = 1e-9;
/** Least room between the points and the ends of an axis, which are powers of ten, so that each axis has two numbers or more. */
const MARGIN = 1.25;
const power_of_ten = (tick) => `10${Array.from(String(Math.round(Math.log10(tick))), (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit] ?? "⁻").join("")}`;
const same = (a, b) => a.scheme === b.scheme && a.subsamples === b.subsamples && a.rate_hz === b.rate_hz;

export class Cost {
    /** study(): the colleague that measures. fly() flies the scene. */
    constructor(scene, study, fly) {
        [this.scene, this.study, this.fly, this.points, this.sensors_m, this.turn] = [scene, study, fly, [], null, 0];
        this.schemes = scene.words(scene.key("options.scheme")).toSorted((a, b) => ["paper", "exact"].indexOf(b) - ["paper", "exact"].indexOf(a));
        const slider = (id, name, values, value) => {
            const input = element("input", { type: "range", id, min: 0, max: values.length - 1, step: 1, value: String(Math.max(0, values.indexOf(value))) });
            const output = element("output", { for: id });
            input.oninput = () => this.show_choice();
            input.onchange = () => this.measure_chosen();
            return { input, output, made: element("div", { class: "slider" }, element("label", { for: id }, name), input, output) };
        };
        this.sliders = [
            slider("cost_scheme", text("Scheme"), this.schemes, scene.get("options.scheme")),
            slider("cost_subsamples", text("Subsamples"), SUBSAMPLES, Number(scene.get("options.subsamples"))),
            slider("cost_rate", text("Sample rate [Hz]"), RATES_HZ, Number(scene.get("flight.rate_hz") || 100)),
        ];
        this.said = element("output", { class: "said", id: "cost_said" });
        this.plot_at = element("div", { class: "plot" });
        const button = (name, act, what) => element("button", { onclick: act, "data-do": what }, name);
        this.made = element(
            "section",
            { class: "cost", "aria-labelledby": "cost_title" },
            element("h2", { id: "cost_title" }, text("What accuracy costs")),
            element("p", {}, text("cost_what")),
            ...this.sliders.map(({ made }) => made),
            element("div", { class: "bar" }, button(text("Measure"), () => this.measure_chosen(), "measure"), button(text("Measure all"), () => this.measure_all(), "measure_all"), button(text("Put into the scene"), () => this.adopt(), "adopt")),
            this.said,
            this.plot_at,
        );
        new ResizeObserver(() => this.plot?.setSize(this.size())).observe(this.plot_at);
        this.show_choice();
    }

    /** Shows what another one has measured, after a change of the language, and takes over what it measures. */
    follow(other) {
        if (!other) return;
        [this.text, this.points, this.sensors_m] = [other.text, other.points, other.sensors_m];
        other.sliders.forEach(({ input }, k) => (this.sliders[k].input.value = input.value));
        other.turn++;
        this.show_choice();
        const point = this.points.find((own) => same(own, this.chosen));
        if (other.is_measuring) this.measure_chosen();
        else if (other.said.value && point) this.say_measured(point);
    }

    /** The choice of the sliders. */
    get chosen() {
        const [scheme, subsamples, rate] = this.sliders.map(({ input }) => Number(input.value));
        return { scheme: this.schemes[scheme], subsamples: SUBSAMPLES[subsamples], rate_hz: RATES_HZ[rate] };
    }

    name({ scheme, subsamples, rate_hz }) {
        return text("cost_choice", this.scene.word_label(this.scene.key("options.scheme"), scheme), subsamples, rate_hz);
    }

    show_choice() {
        const { scheme, subsamples, rate_hz } = this.chosen, values = [this.scene.word_label(this.scene.key("options.scheme"), scheme), subsamples, `${rate_hz} Hz`];
        this.sliders.forEach(({ input, output }, k) => {
            output.value = values[k];
            input.setAttribute("aria-valuetext", String(values[k]));
        });
        this.draw();
    }

    /** The scene but for its algorithm and rate: what is measured is of it. */
    what() {
        const { scene } = this, { sins } = scene, other = sins.scene_parse(scene.text);
        if (!scene.is_log) sins.scene_set_values(other, FINE);
        const key = sins.scene_write(other);
        other.close();
        return key;
    }

    /** Drops what was measured in another flight. */
    of_scene() {
        const own = this.what();
        if (this.text !== own) [this.text, this.points, this.sensors_m] = [own, [], null];
        return own;
    }

    async measure(options) {
        const written = this.of_scene(), measured = await this.study().ask("measure", { text: this.scene.text, options });
        if (written !== this.text) return null;
        if (options === null) this.sensors_m = measured.error_m;
        else this.points = [...this.points.filter((point) => !same(point, options)), { ...options, ...measured }];
        return measured;
    }

    /** Measures by act(due), unless the flight is a log. due(): nothing newer was asked for, and the scene is the same; without it nothing is said. */
    async measuring(act) {
        const turn = ++this.turn, written = this.of_scene(), newest = () => turn === this.turn, due = () => newest() && written === this.what();
        if (this.scene.is_log) return void (this.said.value = text("cost_log"));
        [this.said.value, this.is_measuring] = [text("computing"), true];
        try {
            await act(due);
        } catch (fault) {
            if (due()) this.said.value = this.scene.told(fault);
        }
        if (newest()) this.is_measuring = false;
        if (newest() && !due() && this.said.value.startsWith(text("computing"))) this.said.value = "";
        this.draw();
    }

    measure_chosen() {
        return this.measuring(async (due) => {
            const { chosen } = this, measured = await this.measure(chosen);
            if (due() && this.sensors_m === null) await this.measure(null);
            if (!due()) return;
            this.draw();
            this.say_measured({ ...chosen, ...measured });
            for (const rate_hz of RATES_HZ.filter((rate) => rate !== chosen.rate_hz)) {
                await this.measure({ ...chosen, rate_hz }); // the curve on which the choice is a point
                if (!due()) return;
                this.draw();
            }
        });
    }

    /** Measures every choice, and draws each at once. */
    measure_all() {
        const all = RATES_HZ.flatMap((rate_hz) => this.schemes.flatMap((scheme) => SUBSAMPLES.map((subsamples) => ({ scheme, subsamples, rate_hz }))));
        return this.measuring(async (due) => {
            if (this.sensors_m === null) await this.measure(null);
            for (const [k, options] of all.entries()) {
                this.said.value = `${text("computing")} ${k + 1}/${all.length}`;
                await this.measure(options);
                if (!due()) return;
                this.draw();
            }
            this.measure_chosen();
        });
    }

    say_measured(point) {
        const { error_m, flown_s, us_per_s } = point;
        this.said.value = text("cost_measured", this.name(point), shown(error_m, 2), shown(flown_s, 4), shown(us_per_s, 2), shown(this.sensors_m, 2));
    }

    /** Flies the scene with the algorithm of the point at a place of the diagram, if there is one. */
    fly_at(plot, x, y) {
        const far = ({ us_per_s, error_m }) => Math.hypot(plot.valToPos(us_per_s, "x") - x, plot.valToPos(Math.max(error_m, LEAST_M), "y") - y);
        const point = this.points.reduce((nearest, own) => (nearest && far(nearest) <= far(own) ? nearest : own), null);
        if (point === null || far(point) > REACH) return;
        const places = [this.schemes.indexOf(point.scheme), SUBSAMPLES.indexOf(point.subsamples), RATES_HZ.indexOf(point.rate_hz)];
        this.sliders.forEach(({ input }, k) => (input.value = places[k]));
        [this.turn, this.is_measuring] = [this.turn + 1, false];
        this.show_choice();
        this.adopt();
        this.say_measured(point);
        this.fly();
    }

    /** The chosen algorithm becomes that of the scene. */
    adopt() {
        const { scheme, subsamples, rate_hz } = this.chosen;
        this.scene.set({ "options.scheme": scheme, "options.subsamples": String(subsamples), "flight.rate_hz": String(rate_hz) });
    }

    size() {
        return { width: Math.max(200, this.plot_at.clientWidth), height: 300 };
    }

    /** The points of each scheme, the chosen one, and the error of the sensors. */
    draw() {
        const of = (points) => [Float64Array.from(points, ({ us_per_s }) => us_per_s), Float64Array.from(points, ({ error_m }) => Math.max(error_m, LEAST_M))];
        const chosen = this.points.filter((point) => same(point, this.chosen));
        const own = this.points.filter((point) => same(point, { ...this.chosen, rate_hz: point.rate_hz })).sort((a, b) => a.rate_hz - b.rate_hz);
        const costs = this.points.map(({ us_per_s }) => us_per_s), span = costs.length ? [Math.min(...costs), Math.max(...costs)] : [];
        const line = this.sensors_m === null || span.length === 0 ? [[], []] : [Float64Array.from(span), Float64Array.from(span, () => this.sensors_m)];
        const data = [null, ...this.schemes.map((scheme) => of(this.points.filter((point) => point.scheme === scheme))), line, of(own), of(chosen)];
        this.plot_at.hidden = costs.length === 0;
        const key = JSON.stringify([text("time"), matchMedia("(prefers-color-scheme: dark)").matches]);
        if (key !== this.key) {
            this.plot?.destroy();
            [this.key, this.plot] = [key, this.make(data)];
        }
        this.plot.setData(data);
    }

    make(data) {
        const filter = (_, ticks) => ticks.map((tick) => (Number.isInteger(Math.log10(tick)) ? tick : null)), grid = { stroke: colour("grid"), width: 1, filter };
        const font = "12px system-ui, sans-serif", facets = [{ scale: "x", auto: true }, { scale: "y", auto: true }];
        const axis = (label) => ({ stroke: colour("ink"), grid, ticks: grid, font, labelFont: font, labelSize: 18, label, filter, values: (_, ticks) => ticks.map((tick) => (tick === null ? "" : power_of_ten(tick))) });
        const scheme = (word, k) => ({ label: this.scene.word_label(this.scene.key("options.scheme"), word), stroke: colour(`scheme${k}`), facets, paths: dots(colour(`scheme${k}`), 3) });
        const limits = (_, low, high) => (low === null || low === undefined ? [1, 1000] : [10 ** Math.floor(Math.log10(low / MARGIN)), 10 ** Math.ceil(Math.log10(high * MARGIN))]);
        const plot = new uPlot(
            {
                ...this.size(),
                mode: 2,
                padding: [10, 14, 0, 0],
                scales: { x: { time: false, distr: 3, range: limits }, y: { distr: 3, range: limits } },
                series: [
                    null,
                    ...this.schemes.map(scheme),
                    { label: text("error of the sensors"), stroke: colour("sensors"), facets, paths: dashes(colour("sensors")) },
                    { label: text("chosen algorithm"), stroke: colour("ink"), facets, paths: lines(colour("ink")) },
                    { label: text("chosen"), stroke: colour("ink"), facets, paths: dots(colour("ink"), 7, true) },
                ],
                axes: [{ ...axis(text("time of a simulated second [µs]")), size: 44 }, { ...axis(text("largest error [m]")), size: 66 }],
                cursor: { show: false },
                legend: { live: false },
            },
            data,
            this.plot_at,
        );
        plot.over.addEventListener("click", ({ offsetX, offsetY }) => this.fly_at(plot, offsetX, offsetY));
        plot.root.setAttribute("role", "img");
        plot.root.setAttribute("aria-label", text("What accuracy costs"));
        return plot;
    }
}

/** Draws points as dots, or as rings. */
function dots(ink, radius, is_ring = false) {
    return drawn((plot, paint, points) => {
        [paint.strokeStyle, paint.fillStyle, paint.lineWidth] = [ink, ink, 2 * devicePixelRatio];
        for (const [x, y] of points) {
            paint.beginPath();
            paint.arc(x, y, radius * devicePixelRatio, 0, 7);
            if (is_ring) paint.stroke();
            else paint.fill();
        }
    });
}

/** Draws a line through the points. */
function lines(ink) {
    return drawn((plot, paint, points) => {
        [paint.strokeStyle, paint.lineWidth] = [ink, devicePixelRatio];
        paint.beginPath();
        for (const [x, y] of points) paint.lineTo(x, y);
        paint.stroke();
    });
}

/** Draws a line from edge to edge at the height of the first point. */
function dashes(ink) {
    return drawn((plot, paint, points) => {
        if (points.length === 0) return;
        [paint.strokeStyle, paint.lineWidth] = [ink, 1.5 * devicePixelRatio];
        paint.setLineDash([6 * devicePixelRatio, 4 * devicePixelRatio]);
        paint.beginPath();
        paint.moveTo(plot.bbox.left, points[0][1]);
        paint.lineTo(plot.bbox.left + plot.bbox.width, points[0][1]);
        paint.stroke();
    });
}

function drawn(draw) {
    return (plot, at) => {
        const [xs, ys] = plot.data[at];
        plot.ctx.save();
        draw(plot, plot.ctx, Array.from(xs, (x, k) => [plot.valToPos(x, "x", true), plot.valToPos(ys[k], "y", true)]));
        plot.ctx.restore();
        return null;
    };
}
