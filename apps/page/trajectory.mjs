// The trajectory of the scene: a built-in flight, manoeuvres, or a log.

import { fields, group, items } from "./form.mjs";
import { choose } from "./files.mjs";
import { element, label, options, parts, text } from "./texts.mjs";
import { quoted } from "./scene.mjs";

const BUILTIN = 0, MANOEUVRES = 1, LOG = 2; // in the order of the text "sources"
/** Keys of every flight. */
export const GENERAL = ["title", "hours", "rate_hz", "temperature_c", "temperature_change_c_h"];
const NEW_MANOEUVRE = '[[manoeuvre]]\nkind = "straight"\nduration_s = 60\n';

/** The flight of a built-in scene is that of another one, or its own. */
function flight_of(sins, name) {
    const scene = sins.scene_create_builtin(name), other = sins.scene_get_text(scene, sins.SCENE_TEXT_BUILTIN);
    scene.close();
    return other || name;
}

/** The text of a built-in scene. */
function text_of_builtin(sins, name) {
    const scene = sins.scene_create_builtin(name), written = sins.scene_write(scene);
    scene.close();
    return written;
}

/** take_file(file) takes a log or a scene. */
export function trajectory(scene, take_file) {
    const { sins } = scene, names = scene.builtins();
    const flown_names = [...new Set(names.map((name) => flight_of(sins, name)))];
    const named = (all) => options(all.map((name) => [name, label(`builtin.${name}`, name)]));
    const whole = element("select", { "aria-label": text("Whole scene"), "data-path": "scene" }, ...named(names));
    /** The scene that flies, where it is none of the list. */
    const own = element("option", { value: "", hidden: true });
    whole.prepend(own);
    const texts = new Map(names.map((name) => [name, text_of_builtin(sins, name)]));
    const take = element("button", { onclick: () => scene.open(sins.scene_create_builtin(whole.value)), "data-do": "open_builtin" }, text("Open"));
    whole.onchange = () => (take.disabled = whole.value === "");
    const source = element("select", { id: "source" }, ...options(parts("sources").slice(0, 3).map((name, k) => [String(k), name])));
    const builtin = element("select", { id: "builtin", "data-path": "flight.builtin" }, ...named(flown_names));
    const choose_log = () => choose(".csv,text/csv,.igc,.gpx,.fdr", take_file);
    const browse = element("button", { onclick: choose_log }, text("Choose"));
    const log_name = element("output", { class: "log" });
    const row = (id, name, ...content) => element("div", { class: "row wide" }, element("label", { for: id }, name), ...content);
    const rows = [
        row("builtin", text("Built-in"), builtin),
        element("div", { class: "row wide" }, element("span", {}, text("Log")), element("span", { class: "bar" }, browse, log_name)),
    ];

    function set_source(wanted) {
        if (wanted === BUILTIN) scene.set({ "flight.builtin": flight_of(sins, builtin.value || "patrol") });
        else if (wanted === MANOEUVRES) make_manoeuvres(scene);
        else choose_log();
        made.refresh();
    }
    source.onchange = () => set_source(source.selectedIndex);
    builtin.onchange = () => set_source(BUILTIN);

    const of_flight = (wanted) => scene.keys.filter((key) => key.section === "flight" && wanted(key.name));
    const start = group(text("Start of the flight"), fields(scene, of_flight((name) => !GENERAL.includes(name) && name !== "file" && name !== "builtin")));
    const table = group(text("Columns of the log"), fields(scene, scene.keys.filter((key) => key.section === "log")));
    const path = group(text("Manoeuvres"), items(scene, "manoeuvre", () => NEW_MANOEUVRE));
    let shown_text = null;
    const made = element(
        "div",
        {},
        element("div", { class: "bar scene" }, whole, take),
        element("section", {}, element("h3", {}, text("Flight")), row("source", text("Kind"), source), ...rows),
        fields(scene, of_flight((name) => GENERAL.includes(name))),
        start,
        path,
        table,
    );
    made.refresh = () => {
        const { flight } = sins.scene_get_setup(scene.handle), kind = [MANOEUVRES, BUILTIN, LOG][flight]; // enum sins_scene_flight
        source.selectedIndex = kind;
        const written = scene.text;
        if (written !== shown_text) {
            shown_text = written;
            own.textContent = scene.title || log_of(scene) || text("own_scene");
            whole.value = names.find((name) => texts.get(name) === written) ?? "";
            whole.onchange();
        }
        rows.forEach((own, k) => (own.hidden = kind !== [BUILTIN, LOG][k]));
        for (const part of [start, path]) part.hidden = kind !== MANOEUVRES;
        table.hidden = kind !== LOG;
        if (kind === BUILTIN) builtin.value = flight_of(sins, scene.get("flight.builtin"));
        log_name.value = kind === LOG ? scene.get("flight.file") : "";
        refresh_within(made);
    };
    return made;
}

/** Refreshes what follows the scene within an element. */
export function refresh_within(made) {
    for (const own of made.querySelectorAll("div")) if (own !== made) own.refresh?.();
}

/** Makes manoeuvres of a built-in flight, and of a log the default flight. */
function make_manoeuvres(scene) {
    const { sins } = scene, { flight } = sins.scene_get_setup(scene.handle);
    const from = flight === sins.SCENE_FLIGHT_LOG ? sins.scene_create() : scene.handle;
    const [count] = sins.scene_get_manoeuvres(from, null, null), start = new sins.flight_start();
    const manoeuvres = sins.array(sins.manoeuvre, count), [, repeat] = sins.scene_get_manoeuvres(from, start, manoeuvres);
    scene.change(() => sins.scene_set_manoeuvres(scene.handle, start, manoeuvres, repeat), ["flight"]);
    if (from !== scene.handle) from.close();
}

/** The name of the log that the scene flies, or null. */
export const log_of = (scene) => (scene.is_log ? scene.get("flight.file").split(/[\\/]/).at(-1) : null);

/** A log becomes the flight of the scene, which flies all of it if it flew something else before. */
export const fly_log = (scene, name) => scene.set({ "flight.file": quoted(name), ...(log_of(scene) === name ? {} : { "flight.hours": "" }) });
