// Reads the lessons that the build packs into the page: a folder of folders, each with scene.toml, lesson.toml, en.md and zh.md.
// docs/lessons.md describes them. Whatever else stands in a file is a fault that names the file.

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

import { THEORIES } from "../theory.mjs";

const LANGUAGES = ["en", "zh"];
/** What a lesson shows first. */
const SHOWS = ["position", "velocity", "misalignment", "cost"];
/** Keys of lesson.toml, and of each of its lists, with what their value must be. */
const is_text = (value) => typeof value === "string" && value !== "", is_number = Number.isFinite;
const KEYS = { order: is_number, shows: (value) => SHOWS.includes(value) };
const MORE_KEYS = { times: (value) => value === true, axis: (value) => value === true, theory: (value) => Object.hasOwn(THEORIES, value), beside: (value) => Array.isArray(value) && value.length === 2 && is_text(value[0]) };
const LISTS = {
    mark: { at_s: (value) => is_number(value) && value > 0, en: is_text, zh: is_text },
    slider: { key: is_text, en: is_text, zh: is_text, values: (value) => Array.isArray(value) && value.length > 1 && (value.every(is_number) || value.every(is_text)) },
};

/** The lessons of a folder in their order. Throws if one is not complete. */
export function lessons_of(folder) {
    const lessons = readdirSync(folder, { withFileTypes: true }).filter((own) => own.isDirectory()).map(({ name }) => lesson_of(join(folder, name), name));
    return lessons.sort((a, b) => a.order - b.order);
}

/** The lessons, if the library reads the scene of each and takes each value of its sliders. Throws with the first fault. */
export function read_by(sins, lessons) {
    for (const { name, scene, slider, beside } of lessons) {
        const read = sins.scene_parse(scene), fault = new sins.fault(), first = () => (sins.scene_get_fault(read, 0, fault), fault.copy());
        if (sins.last_status === sins.SCENE_HAS_FAULTS) throw new Error(`${name}/scene.toml:${first().line}:${first().column}: ${first().sentence}`);
        for (const [key, value] of [...slider.flatMap(({ key, values }) => values.map((own) => [key, own])), ...(beside ? [beside] : [])]) {
            try {
                sins.scene_set_values(read, `${key} = ${value}`);
            } catch {
                throw new Error(`${name}/lesson.toml: ${first().sentence}`);
            }
        }
        read.close();
    }
    return lessons;
}

function lesson_of(folder, name) {
    const read = (file, use) => {
        try {
            return use(readFileSync(join(folder, file), "utf8"));
        } catch (error) {
            throw new Error(`${join(folder, file)}: ${error.message}`);
        }
    };
    if (!/^[a-z][a-z0-9_]*$/.test(name)) throw new Error(`${folder}: expected a name of small letters, digits and _`);
    const texts = LANGUAGES.map((language) => [language, read(`${language}.md`, words_of)]);
    return { name, scene: read("scene.toml", String), ...read("lesson.toml", settings_of), ...Object.fromEntries(texts) };
}

/** Joins the lines of a paragraph: by a blank, but none stands behind a Chinese character. */
const joined = (part) => part.replace(/\s*\n\s*/g, (_, at, all) => (/[\u3000-\u9fff\uff00-\uffef]/.test(all[at - 1]) ? "" : " "));

/** Title, question and paragraphs of a Markdown text: a heading, then paragraphs without any marks. */
function words_of(text) {
    const [title, question, ...paragraphs] = text.trim().split(/\n\s*\n/).map(joined);
    if (!/^# \S/.test(title)) throw new Error("expected a heading, # TITLE, in the first line");
    if (question === undefined || paragraphs.length === 0) throw new Error("expected a question and at least one paragraph, with an empty line before each");
    const marked = [question, ...paragraphs].find((part) => /^[#>*+|-]|\]\(|```|<\w/.test(part));
    if (marked) throw new Error(`expected a paragraph of plain text: ${marked.slice(0, 40)}`);
    return { title: title.slice(2), question, paragraphs };
}

/** The settings in lesson.toml: of TOML, [[lists]] of items and keys whose values are also JSON. */
function settings_of(text) {
    const settings = Object.fromEntries(Object.keys(LISTS).map((list) => [list, []]));
    let [at, keys] = [settings, { ...KEYS, ...MORE_KEYS }];
    text.split("\n").forEach((line, k) => {
        const fault = (what) => new Error(`line ${k + 1}: ${what}: ${line}`), [, list] = /^\[\[(\w+)\]\]$/.exec(line) ?? [];
        if (/^\s*(#.*)?$/.test(line)) return;
        if (list !== undefined) {
            if (!Object.hasOwn(LISTS, list)) throw fault("no such list");
            [at, keys] = [{}, LISTS[list]];
            return void settings[list].push(at);
        }
        const [, key, written] = /^(\w+) = (.+)$/.exec(line) ?? [];
        if (!Object.hasOwn(keys, key ?? "")) throw fault("no such key");
        if (Object.hasOwn(at, key)) throw fault("a second time");
        try {
            at[key] = JSON.parse(written);
        } catch {
            throw fault("expected a text in quotes, a number, or a list of them");
        }
        if (!keys[key](at[key])) throw fault("not a value of this key");
    });
    const is_whole = (own, wanted) => Object.keys(wanted).every((key) => Object.hasOwn(own, key));
    if (!is_whole(settings, KEYS)) throw new Error(`expected ${Object.keys(KEYS).join(", ")}`);
    for (const [list, wanted] of Object.entries(LISTS)) {
        if (!settings[list].every((own) => is_whole(own, wanted))) throw new Error(`[[${list}]]: expected ${Object.keys(wanted).join(", ")}`);
    }
    return settings;
}
