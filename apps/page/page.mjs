// SINS in a page: the form and the text of the scene, the display of the flight, and what accuracy costs.

import { load } from "sins";
import { Cost } from "./cost.mjs";
import { Display } from "./display.mjs";
import { of_link, on_drop, choose, save, text_of, to_link, unpacked } from "./files.mjs";
import { fields, folded, group, items, presets, section_name, select_place } from "./form.mjs";
import { lesson_made, lesson_of, row_of } from "./lessons.mjs";
import { Scene, unit_name } from "./scene.mjs";
import { element, language, options, parts, read_texts, remember_language, speak, stored_language, text } from "./texts.mjs";
import { fly_log, GENERAL, log_of, refresh_within, trajectory } from "./trajectory.mjs";
import { Colleague, serve } from "./worker.mjs";

/** Time after the last letter in the text, or the last change of the scene, after which others follow [ms]. */
const PAUSE_MS = 300;
/** Sample rate of the flight that the page opens with, which it flies at once [Hz]. */
const OPENING_HZ = 1;
/** The only key of the output that has a meaning in a page. */
const OUTPUT = "output.every_s";

class Page {
    constructor(sins, module) {
        const program = new Blob([document.getElementById("program").textContent], { type: "text/javascript" });
        [this.address, this.module, this.tab] = [URL.createObjectURL(program), module, 0];
        /** The address whose scene the page has, and how many addresses were opened. */
        [this.linked, this.turn] = [null, 0];
        this.lessons = JSON.parse(document.getElementById("lessons").textContent);
        /** What the page has opened, which stands in the address: its part of the address, its scene, and the lesson if it is one. */
        this.open = { hash: null, text: null, lesson: null, is_first: false };
        this.scene = new Scene(sins);
        /** The last log, and the files beside it by their names. */
        [this.log, this.beside] = [null, new Map()];
        this.pilot = new Colleague(this.address, module);
        this.scene.addEventListener("change", ({ source }) => this.on_change(source));
        this.scene.addEventListener("refused", () => this.refresh_fields());
        on_drop((file) => this.take_file(file));
        addEventListener("hashchange", () => this.open_link());
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.display.draw() ?? this.cost.draw());
    }

    /** The worker that measures, which begins with its first question. */
    study() {
        return (this.measuring ??= new Colleague(this.address, this.module));
    }

    /** Builds the page in the language of the user. */
    build() {
        const { scene } = this, { display, cost } = this;
        document.documentElement.lang = language === "zh" ? "zh-Hans" : "en";
        document.title = text("page_title");
        this.display = new Display(scene, this.pilot);
        this.display.follow(display);
        this.cost = new Cost(scene, () => this.study(), () => this.display.fly_at_once());
        this.cost.follow(cost);
        const languages = element("select", { id: "language", "aria-label": "Language 语言" }, ...options([["en", "English"], ["zh", "中文"]], language));
        languages.onchange = () => this.set_language(languages.value);
        const button = (name, act, what) => element("button", { onclick: act, "data-do": what }, text(name));
        const header = element(
            "header",
            {},
            element("h1", {}, text("page_title")),
            element(
                "div",
                { class: "bar" },
                button("Open", () => choose(".toml,.csv,.igc,.gpx,.fdr", (file) => this.take_file(file)), "open"),
                button("Save the scene", () => save(new Blob([this.text.value], { type: "application/toml" }), `${this.display.name()}.toml`), "save"),
                button("Save the records", () => this.display.save_records(), "records"),
                button("Picture", () => this.display.save_picture(), "picture"),
                button("Copy the link", () => this.copy_link(), "link"),
                languages,
            ),
        );
        const aside = element("aside", { "aria-label": text("Settings") }, ...this.tabs());
        this.lead = element("p", { class: "lead" }, text("opening"));
        [this.row, this.lesson] = [element("div", { class: "lessons" }), element("div", { class: "beside_picture" })];
        // The first in the order of keys is the flight.
        this.main = element("main", {}, this.lead, this.display.made, this.cost.made);
        document.getElementById("page").replaceChildren(this.main, header, this.row, element("div", { class: "left" }, this.lesson, aside), this.footer());
        this.refresh();
        this.show_lesson(null);
    }

    footer() {
        const about = parts("about").map((line) => line.replace("%1", this.scene.sins.version_string()).replace("%2", this.scene.sins.version_string()));
        const licences = element("details", {}, element("summary", {}, text("Licences")), element("pre", {}));
        licences.ontoggle = async () => {
            licences.lastChild.textContent ||= new TextDecoder().decode(await unpacked("licences"));
        };
        return element("footer", {}, element("p", {}, [text("page_title"), ...about.slice(1)].join(". ")), licences);
    }

    /** The tabs of the settings, each with its panel. */
    tabs() {
        const { scene } = this, names = parts("tabs");
        const keys_of = (own) => scene.keys.filter((key) => key.section === own && key.name !== "preset"), section = (own) => fields(scene, keys_of(own));
        const part = (own, ...content) => folded(section_name(own), () => keys_of(own).some((key) => !scene.is_default(key)), ...content, section(own));
        const failure = () => `[[failure]]\nsensor = "gyro"\naxis = "x"\nkind = "dead"\nfrom_s = ${this.display.now?.time_s ?? 0}\n`;
        this.text = element("textarea", { id: "text", spellcheck: "false", wrap: "off", "aria-label": text("Text of the scene"), "aria-describedby": "text_faults" });
        this.text.oninput = () => this.later("typed", () => scene.parse(this.text.value));
        this.faults = element("ul", { id: "text_faults", class: "faults", role: "status" });
        const settings = {
            [names[0]]: () => [trajectory(scene, (file) => this.take_file(file))],
            [names[1]]: () => [
                group(section_name("options"), section("options")),
                ...["gyro", "accelerometer"].map((own) => part(own, presets(scene, own))),
                ...["altimeter", "gravity"].map((own) => part(own)),
                folded(text("Failures of sensors"), () => scene.items("failure").length > 0, items(scene, "failure", failure)),
            ],
            [names[2]]: () => [presets(scene, "start"), section("start"), part("mounting")],
            [text("Unit")]: () => [group(text("Panel of the INS"), items(scene, "panel", () => '[[panel]]\nkind = "align"\nat_s = 0\n')), section("unit")],
            [text("Text")]: () => [this.text, this.faults, group(section_name("output"), fields(scene, [scene.key(OUTPUT)])), group(text("Updates"), items(scene, "update", () => '[[update]]\nkind = "position"\nat_s = 60\nsigma_m = 10\n'))],
        };
        const list = element("div", { role: "tablist" });
        this.panels = Object.entries(settings).map(([name, make], k) => {
            const tab = element("button", { role: "tab", id: `tab${k}`, "aria-controls": `panel${k}`, onclick: () => this.choose_tab(k) }, name);
            tab.onkeydown = ({ key }) => {
                const step = { ArrowRight: 1, ArrowLeft: -1 }[key];
                if (step) this.choose_tab((k + step + this.panels.length) % this.panels.length).focus();
            };
            list.append(tab);
            return { tab, make, panel: element("div", { role: "tabpanel", id: `panel${k}`, "aria-labelledby": `tab${k}` }) };
        });
        this.choose_tab(this.tab);
        const tabs = element("div", {}, list, ...this.panels.map(({ panel }) => panel));
        return [...this.finder(tabs), tabs];
    }

    /** A field that finds keys by words of their name, meaning and unit, and the fields found, shown instead of the tabs. */
    finder(tabs) {
        const { scene } = this, given = (key) => `${key.path} ${this.name_of(key)} ${scene.name(key.path)} ${scene.meaning(key.path)} ${unit_name(key)}`.toLowerCase();
        const can_stand = scene.keys.filter((key) => this.name_of(key) && key.name !== "preset" && (key.section !== "flight" || GENERAL.includes(key.name)));
        const field = element("input", { type: "search", id: "find", "aria-label": text("Find a setting"), placeholder: text("Find a setting") });
        field.oninput = () => {
            const words = field.value.toLowerCase().split(/\s+/).filter(Boolean), is_asked = words.length > 0;
            const keys = can_stand.filter((key) => is_asked && words.every((word) => given(key).includes(word)));
            const sections = [...new Set(keys.map(({ section }) => section))].map((own) => keys.filter((key) => key.section === own));
            const groups = sections.map((own) => group(this.name_of(own[0]), fields(scene, own)));
            this.found.replaceChildren(...(groups.length ? groups : [text("No such setting")]));
            [tabs.hidden, this.found.hidden] = [is_asked, !is_asked];
            refresh_within(this.found);
        };
        return [element("div", { class: "bar" }, field), (this.found = element("div", { hidden: "" }))];
    }

    /** The name of the section of a key that has a field on the page. */
    name_of = ({ section, path }) => (section === "output" ? path === OUTPUT && section_name(section) : section === "unit" ? text("Unit") : section_name(section));

    /** Shows a panel of the settings, which is made when it is first shown. Returns its tab. */
    choose_tab(chosen) {
        this.tab = chosen;
        this.panels.forEach(({ tab, panel, make }, k) => {
            tab.setAttribute("aria-selected", String(k === chosen));
            tab.tabIndex = k === chosen ? 0 : -1;
            panel.hidden = k !== chosen;
            if (k === chosen && panel.childElementCount === 0) panel.append(...make());
        });
        refresh_within(this.panels[chosen].panel);
        return this.panels[chosen].tab;
    }

    refresh_fields() {
        for (const made of [this.panels[this.tab].panel, this.found]) refresh_within(made);
    }

    /** Calls something after a pause, once. */
    later(name, act) {
        clearTimeout(this[name]);
        this[name] = setTimeout(act, PAUSE_MS);
    }

    on_change(source) {
        if (source === "opened") this.opened();
        this.refresh(source);
        this.display.follow_plans();
        this.later("changed", () => {
            this.display.preview();
            this.write_link();
        });
    }

    refresh(source = null) {
        const { scene } = this;
        if (source !== "text") this.text.value = scene.text;
        this.refresh_fields();
        const in_text = scene.faults.filter((fault) => fault.in_text);
        this.faults.replaceChildren(...in_text.map((fault) => {
            const go = () => select_place(this.text, Number(fault.line), Number(fault.column));
            return element("li", {}, element("button", { class: "fault", onclick: go }, `${fault.line}:${fault.column}: ${scene.told(fault)}`));
        }));
        this.text.setAttribute("aria-invalid", String(in_text.length > 0));
        refresh_within(this.lesson);
        this.lead.hidden = !this.open.is_first || scene.text !== this.open.text;
        this.display.refresh(false);
    }

    set_language(wanted) {
        speak(wanted);
        remember_language();
        this.build();
    }

    /** Opens a scene, flies a log, or keeps a file that the [log] of the scene names beside its log. */
    async take_file(file) {
        const { scene, display } = this, names = scene.beside(), is_log = /\.(csv|txt|log|igc|gpx|fdr)$/i.test(file.name);
        try {
            if (names.includes(file.name) || is_log) {
                if (names.includes(file.name)) this.beside.set(file.name, file);
                else this.log = file;
                const [missing] = names.filter((name) => !this.beside.has(name)).concat(this.log ? [] : log_of(scene) ?? []), { log } = this;
                if (missing || !log) return display.say(missing ? text("log_missing", missing) : "", true);
                display.say(text("computing"));
                const { samples, duration_s, findings } = await this.pilot.ask("log", { file: log, beside: [...this.beside.values()], text: scene.faults.length ? null : scene.text });
                [display.previewed, display.log_name, display.logs] = [null, log.name, display.logs + 1];
                const [fault] = fly_log(scene, log.name);
                display.show_findings(findings);
                display.say(fault ? scene.told(fault) : text("log_read", log.name, samples, shown_s(duration_s)), Boolean(fault));
            } else {
                const written = await text_of(file);
                this.text.value = written;
                display.say("");
                this.opened();
                if (!scene.parse(written)) display.say(`${file.name}: ${scene.told(scene.faults[0])}`, true);
            }
        } catch (fault) {
            display.say(`${file.name}: ${scene.told({ ...fault, sentence: fault.sentence ?? fault.message })}`, true);
        }
    }

    /** Writes the scene into the address, unless the address has changed and is to be opened. */
    async write_link() {
        const { scene, turn } = this;
        if (scene.faults.some((fault) => fault.in_text)) return;
        const { hash, text: opened, lesson } = this.open, own = lesson ? `${hash}&` : "#";
        const linked = scene.text === opened ? hash : `${own}scene=${await to_link(scene.text)}`;
        if (turn !== this.turn || location.hash !== this.linked) return;
        if (location.hash !== linked) history.replaceState(null, "", linked || location.pathname + location.search);
        this.linked = linked;
    }

    /** Notes what was opened: without values, a scene that is nothing but itself. */
    opened({ hash = null, lesson = null, is_first = false } = {}) {
        const was_own = this.open.hash !== null;
        this.open = { hash, lesson, is_first, text: hash === null ? null : this.scene.text };
        this.display.forget_curves();
        if (was_own || hash !== null) this.show_lesson();
        this.refresh("text");
    }

    /** Opens and flies simulation 2, at a rate at which its two days take a second or two. */
    open_first() {
        this.scene.open(this.scene.sins.scene_create_builtin("simulation2"));
        this.scene.set({ "flight.rate_hz": String(OPENING_HZ) });
        this.opened({ hash: "", is_first: true });
        this.display.fly_at_once();
    }

    /** Opens and flies a lesson, with its own scene or with another one. */
    open_lesson(lesson, other) {
        if (!this.read(lesson.scene)) return;
        this.opened({ hash: `#lesson=${lesson.name}`, lesson });
        if (other !== undefined && !this.read(other)) return;
        if (lesson.beside && other === undefined) this.display.fly_beside(...lesson.beside);
        else this.display.fly_at_once();
        if (lesson.shows === "cost") this.cost.measure_chosen();
    }

    /** Shows the row of the lessons, and the open one with what it looks at; `shows` is null: with the chosen quantity. */
    show_lesson(shows = this.open.lesson?.shows ?? "position") {
        const { lesson } = this.open;
        this.row.replaceChildren(row_of(this.lessons, this.open));
        this.lesson.replaceChildren(...(lesson ? [lesson_made(lesson, this.scene, () => this.display.fly(), (written) => this.study().ask("step_times", { text: written }))] : []));
        refresh_within(this.lesson);
        this.display.call = () => Array.from(this.lesson.querySelectorAll(".slider output"), (own) => own.value).join(", ");
        this.display.look_at(shows, (lesson?.mark ?? []).map((own) => ({ at_s: own.at_s, name: own[language] })), lesson?.theory, lesson?.axis);
        if (lesson?.shows === "cost") this.lead.after(this.cost.made, this.display.made);
        else this.lead.after(this.display.made, this.cost.made);
    }

    /** Takes the text of a scene, and says what is wrong with it. */
    read(written) {
        this.text.value = written;
        if (this.scene.parse(written)) return true;
        this.display.say(this.scene.told(this.scene.faults[0]), true);
        return false;
    }

    async copy_link() {
        await this.write_link();
        await navigator.clipboard?.writeText(location.href).then(() => this.display.say(text("link_copied")), () => this.display.say(location.href));
    }

    /** Opens what the address has: #scene=..., #lesson=NAME, with its scene if it was changed, or #NAME of a built-in scene; or the first flight. */
    async open_link() {
        const { scene } = this, { hash } = location, [name, packed] = ["lesson", "scene"].map((own) => new URLSearchParams(hash.slice(1)).get(own));
        const lesson = lesson_of(this.lessons, name), turn = ++this.turn;
        if (hash === this.linked) return;
        this.linked = hash;
        if (hash === "") return this.open_first();
        try {
            if (name === null && packed === null) return scene.open(scene.sins.scene_create_builtin(decodeURIComponent(hash.slice(1))));
            const written = packed === null ? undefined : await of_link(packed);
            if (turn !== this.turn) return; // another address was opened meanwhile
            if (lesson) return this.open_lesson(lesson, written);
            if (written === undefined) throw new Error("no such lesson");
            this.opened();
            if (this.read(written)) this.refresh();
        } catch {
            if (turn === this.turn) this.display.say(text("no_link"), true);
        }
    }
}

const shown_s = (time_s) => Number(time_s.toPrecision(6));

async function start() {
    const read = (id) => document.getElementById(id).textContent;
    read_texts({ en: read("en"), zh: read("zh") });
    speak(stored_language() ?? (navigator.language.startsWith("zh") ? "zh" : "en"));
    const module = await WebAssembly.compile(await unpacked("library"));
    const page = new Page(await load(module), module);
    page.build();
    await page.open_link();
    page.on_change();
    document.body.dataset.ready = "";
}

if (typeof document === "undefined") serve();
else start().catch((error) => document.getElementById("page").replaceChildren(`${error.message}`));
