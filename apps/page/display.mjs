// The display: controls of the flight, curves, map, instruments and the table of values, all of the flight in the worker.

import { Axis } from "./axis.mjs";
import { Curves, MOST_KEPT, QUANTITIES } from "./curves.mjs";
import { RUNS } from "./runs.mjs";
import { save } from "./files.mjs";
import { FLYING, PAUSED } from "./flight.mjs";
import { Indicator, Panel } from "./instruments.mjs";
import { Track } from "./map.mjs";
import { element, options, parts, shown, text } from "./texts.mjs";
import { THEORIES } from "./theory.mjs";
import { log_of } from "./trajectory.mjs";
import { answer, duration, rows } from "./values.mjs";

const PACES = [1, 10, 100, 1000, 0]; // in the order of the text "paces"
/** Time for which a sentence stands in the place of the state of a flight [ms]. */
const READ_MS = 5000;

export class Display {
    /** pilot: the colleague that flies. */
    constructor(scene, pilot) {
        [this.scene, this.pilot, this.now, this.points, this.path, this.band, this.quantity] = [scene, pilot, null, null, null, null, QUANTITIES[0]];
        const button = (name, act, what) => element("button", { onclick: act, "data-do": what }, text(name));
        this.start = button("Start", () => this.press_start(), "start");
        this.pause = button("Pause", () => pilot.ask("pause", { is_paused: this.now?.state === FLYING }), "pause");
        this.stop = button("Stop", () => pilot.ask("stop"), "stop");
        this.start.classList.add("first");
        this.pace = element("select", { id: "pace" }, ...options(parts("paces").map((name, k) => [String(PACES[k]), name]), "0"));
        this.pace.onchange = () => pilot.ask("pace", { pace: Number(this.pace.value) });
        this.progress = element("progress", { max: 1, value: 0, "aria-label": text("Flight") });
        this.state = element("output", { class: "state", id: "state" });
        this.answer = element("output", { class: "answer", id: "answer" });
        this.findings = element("ul", { class: "findings", "aria-label": text("Flight data") });
        /** Number of logs that were read, and that of the one that flew: the worker keeps the last one alone. */
        [this.logs, this.flown_log] = [0, 0];
        /** What the curves of this flight are called when they are kept, or "". */
        this.call = () => "";
        this.keep = button("Keep this curve", () => this.keep_curves(), "keep");
        this.many = button("Many runs", () => this.fly_many(), "many");
        this.forget = button("Remove kept curves", () => this.forget_curves(), "forget");
        const quantity = (this.quantities = element("select", { id: "quantity" }, ...options(QUANTITIES.map((own, k) => [String(k), own.name()]))));
        quantity.onchange = () => {
            this.quantity = QUANTITIES[quantity.selectedIndex];
            this.draw();
        };
        const [curves, map] = [element("div", { class: "plots" }), element("div", { class: "plot" })];
        [this.curves, this.track] = [new Curves(curves), new Track(map)];
        this.indicators = parts("indicators").map((title) => new Indicator(title));
        this.axis = new Axis();
        this.panel = new Panel(scene.sins, (kind, values) => this.act(kind, values));
        this.values = element("tbody");
        const [of_navigation, of_truth] = parts("values");
        this.attitudes = element("div", { class: "indicators" }, ...this.indicators.map(({ made }) => made));
        this.table = element("table", {}, element("thead", {}, element("tr", {}, element("th", {}), ...[of_navigation, of_truth].map((name) => element("th", { scope: "col" }, name)))), this.values);
        this.made = element(
            "div",
            { class: "display" },
            element("div", { class: "bar controls" }, this.start, this.pause, this.stop, element("label", { for: "pace" }, text("Pace")), this.pace),
            this.progress,
            this.state,
            this.answer,
            this.findings,
            element("div", { class: "views" },
                element("section", { class: "curves" }, element("div", { class: "bar" }, element("label", { for: "quantity" }, text("Quantity")), quantity, this.keep, this.many, this.forget), curves),
                element("section", { class: "beside" }, this.axis.made, this.attitudes, this.panel.made, element("h3", {}, text("Map")), map, this.table),
            ),
        );
        pilot.on_flight = (now, points) => this.take(now, points);
        this.refresh();
    }

    /** Shows another flight after a change of the language. */
    follow(other) {
        if (!other) return;
        for (const name of ["now", "points", "path", "flown_text", "has_model", "log_name", "planned", "band", "logs", "flown_log"]) this[name] = other[name];
        this.pace.value = other.pace.value;
        this.curves.kept = other.curves.kept;
        this.choose(QUANTITIES.indexOf(other.quantity));
        this.show_findings(other.found);
        this.refresh();
    }

    choose(place) {
        [this.quantity, this.quantities.selectedIndex] = [QUANTITIES[place], place];
    }

    keep_curves() {
        const { kept } = this.curves;
        this.curves.keep(this.call() || text("kept", kept.length + 1));
        this.refresh();
    }

    /** Draws between which errors the runs of the scene are. */
    async fly_many() {
        const written = this.flown_text;
        this.say(text("flying_runs", RUNS));
        try {
            const band = await this.pilot.ask("band", { text: written });
            if (band === null || written !== this.flown_text) return;
            this.band = band;
            this.say("");
            this.draw();
        } catch (fault) {
            const own = text(fault.sentence, RUNS);
            this.say(own === fault.sentence ? this.scene.told(fault) : own, true);
        }
    }

    forget_curves() {
        this.curves.kept = [];
        this.refresh();
    }

    /** What the judge found in the log: [{level, sentence}]. */
    show_findings(found = []) {
        this.found = found;
        this.findings.replaceChildren(...found.map(({ level, sentence }) => element("li", {}, `${parts("levels")[level]}: ${sentence}`)));
    }

    /**
     * Shows the navigation's error of a name, such as "position", or the chosen one, with marks: [{at_s, name}], over the whole time, and
     * what theory of a name says; and the axis of the body in three dimensions, or not.
     */
    look_at(name, marks, theory, with_axis) {
        this.curves.look_at(marks, () => THEORIES[theory]?.(this.scene) ?? null);
        this.axis.made.hidden = !with_axis;
        const chosen = QUANTITIES.findIndex(({ triples }) => triples[0] === `${name}2`);
        if (chosen >= 0) this.choose(chosen);
        this.draw();
    }

    /** What keeps the flight from its start, or "". */
    obstacle() {
        const { scene } = this, log = log_of(scene);
        if (scene.faults.length) return text("not_in_flight");
        return log === null || log === this.log_name ? "" : text("log_missing", scene.get("flight.file"));
    }

    /** Continues a flight that is paused, or flies the scene. */
    press_start() {
        if (this.now?.state === PAUSED && !this.obstacle()) return this.pilot.ask("pause", { is_paused: false });
        return this.fly();
    }

    /** Flies the scene as fast as possible, whatever pace and state the flight before had. */
    fly_at_once() {
        this.pace.value = "0";
        return this.fly();
    }

    /** Flies the scene with another value of a key, keeps these curves, and flies it as it is. */
    fly_beside(key, value) {
        const own = this.scene.get(key);
        this.scene.set({ [key]: String(value) });
        this.fly_at_once();
        this.has_flown = () => {
            this.keep_curves();
            this.scene.set({ [key]: own });
            this.fly_at_once();
        };
    }

    /** Flies the scene from its start. */
    async fly() {
        const obstacle = this.obstacle();
        if (obstacle) return this.say(obstacle, true);
        [this.flown_text, this.points, this.now, this.has_model, this.band] = [this.scene.text, null, null, this.scene.get("options.error_model") === "rk4", null];
        [this.flown_log, this.has_flown] = [this.logs, null];
        this.say("");
        try {
            await this.pilot.ask("start", { text: this.flown_text, pace: Number(this.pace.value) });
        } catch (fault) {
            this.scene.refuse(fault);
            this.say(this.scene.told(fault), true);
        }
    }

    /** An action at the panel now, which becomes part of the scene. */
    async act(kind, values = () => ({})) {
        try {
            if (!this.now || this.now.state > PAUSED) throw new Error(text("nothing_flown"));
            const lines = Object.entries({ kind: `"${kind}"`, ...values() }).map(([name, value]) => `${name} = ${value}\n`);
            const items = this.scene.items("panel"), item = await this.pilot.ask("act", { lines: lines.join(""), items: items.join("\n") });
            this.keep_plan("panel", [...items, item]);
        } catch (error) {
            this.say(this.scene.told({ ...error, sentence: error.sentence ?? error.message }), true);
        }
    }

    /** Plans in flight are also those of the flown scene. */
    keep_plan(list, items) {
        const was_same = this.flown_text === this.scene.text;
        this.scene.set_items(list, items);
        if (was_same) this.flown_text = this.scene.text;
        this.refresh();
    }

    /** Failures that were planned or ended in the form act in the flight too. */
    async follow_plans() {
        const failures = this.scene.items("failure").join("\n");
        if (this.planned === failures) return;
        this.planned = failures;
        if (!this.now || this.now.state > PAUSED || this.scene.faults.length) return;
        const { items, is_as_planned } = await this.pilot.ask("plan", { list: "failure", items: failures });
        if (is_as_planned) this.flown_text = with_failures(this.scene.sins, this.flown_text, items);
        if (items !== failures && this.planned === failures) {
            this.planned = items;
            this.scene.set_items("failure", [items]);
        }
        this.refresh();
    }

    /** The state of the flight, and sometimes its curves. */
    take(now, points) {
        if (now.state !== this.now?.state) this.said = null;
        this.now = now;
        if (points) this.points = points;
        cancelAnimationFrame(this.frame);
        this.frame = requestAnimationFrame(() => {
            this.refresh(points !== null);
            if (now.state > PAUSED) this.has_flown?.();
        });
    }

    say(sentence, is_fault = false) {
        this.said = sentence ? { sentence, is_fault, until_ms: performance.now() + READ_MS } : null;
        this.show_state();
    }

    /** Says why the path cannot be shown, until it can. */
    say_of_path(sentence) {
        this.say(sentence, true);
        this.said_of_path = this.said;
    }

    show_state() {
        const { now, scene, said } = this, is_old = now && this.flown_text !== scene.text;
        const place = now?.fault && (now.fault.line ? `${scene.get("flight.file")}:${now.fault.line}: ` : `${shown(now.fault.time_s, 10)} s: `);
        const sentence = now?.fault ? place + scene.told(now.fault) : "";
        const state = now ? `${parts("states")[now.state]}${is_old ? text("old") : ""}: ${duration(now.time_s)} / ${duration(now.duration_s)}. ${sentence}` : text("ready");
        const told = said ? said.sentence : state;
        if (this.state.value !== told) this.state.value = told;
        this.state.classList.toggle("fault", Boolean(said?.is_fault || now?.fault));
        if (now) this.progress.value = now.duration_s ? now.time_s / now.duration_s : 0;
    }

    refresh(with_curves = true) {
        const { now } = this, is_flying = now?.state === FLYING, is_paused = now?.state === PAUSED;
        if (is_flying && performance.now() > this.said?.until_ms) this.said = null;
        [this.start.disabled, this.pause.disabled, this.stop.disabled] = [is_flying, !is_flying && !is_paused, !is_flying && !is_paused];
        const { kept } = this.curves;
        this.many.disabled = !this.points || now?.state <= PAUSED || now.has_unit || this.flown_log !== this.logs;
        [this.keep.disabled, this.forget.hidden, this.findings.hidden] = [!this.points || kept.length === MOST_KEPT, kept.length === 0, log_of(this.scene) === null];
        this.pause.setAttribute("aria-pressed", String(is_paused));
        this.show_state();
        this.panel.made.hidden = now ? !now.has_unit : this.scene.get("unit.start") === "none";
        this.panel.show(now?.unit ?? null);
        this.answer.value = answer(now);
        const { record, unit } = now ?? {}, attitude = (own) => own && [own.roll_rad, own.pitch_rad, own.heading_rad];
        [this.attitudes.hidden, this.table.hidden] = [!record, !record];
        this.indicators[0].show(attitude(record?.truth) ?? null);
        this.indicators[1].show(unit ? this.panel.attitude(unit) : now?.has_unit ? null : (attitude(record?.navigation) ?? null));
        this.values.replaceChildren(...rows(now).map(([name, ...cells]) => element("tr", {}, element("th", { scope: "row" }, name), ...cells.map((cell) => element("td", cells.length === 1 ? { colspan: 2 } : {}, cell)))));
        if (with_curves) this.draw();
    }

    draw() {
        const { points } = this;
        this.curves.show(this.quantity, points, this.has_model, this.band);
        if (!this.axis.made.hidden) this.axis.show(points);
        if (points) this.track.show([points.true_path, points.path]);
        else this.track.show([this.path?.place]);
        this.made.classList.toggle("old", Boolean(this.now && this.flown_text !== this.scene.text));
    }

    /** The path of the flight before it is flown. */
    async preview() {
        const obstacle = this.obstacle();
        if (this.scene.faults.length || this.previewed === this.scene.text) return;
        if (obstacle) return this.say_of_path(obstacle);
        const written = (this.previewed = this.scene.text);
        try {
            const path = await this.pilot.ask("path", { text: written });
            if (written !== this.previewed) return;
            this.path = path;
            this.scene.refuse(null);
            if (this.said === this.said_of_path || performance.now() > this.said?.until_ms) this.said = null;
        } catch (fault) {
            if (written !== this.previewed) return;
            this.path = null;
            this.scene.refuse(fault);
            if (!this.now || this.now.state > PAUSED) this.say_of_path(this.scene.told(fault));
        }
        if (!this.points) this.draw();
        this.show_state();
    }

    async save_records() {
        const file = await this.pilot.ask("records");
        if (file === null) return this.say(text("nothing_flown"), true);
        save(file, `${this.name()}.csv`);
    }

    async save_picture() {
        if (!this.points) return this.say(text("nothing_flown"), true);
        save(await this.curves.picture(`${this.quantity.name()}: ${this.scene.title || this.name()}`), `${this.name()}.png`);
    }

    /** The base name of files. */
    name() {
        return this.scene.get("output.name") || "sins";
    }
}

/** The text of a scene with other failures. */
function with_failures(sins, written, items) {
    const scene = sins.scene_parse(written);
    sins.scene_set_items(scene, "failure", items);
    const changed = sins.scene_write(scene);
    scene.close();
    return changed;
}
