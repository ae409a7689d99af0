// Fields of the scene: a row for each key, with its name, unit and fault, and its meaning and limits as a hint. An item of a list has a draft, which becomes part of
// the scene as soon as the library accepts it.

import { quoted, unit_name, unquoted } from "./scene.mjs";
import { element, label, options, parts, text } from "./texts.mjs";

let rows_made = 0;

/** A row: label, field, unit, fault. changed(value) is called with a new value. */
export function row(scene, key, path, changed) {
    const id = `field_${rows_made++}`, words = scene.words(key), hint = scene.hint(key);
    const described = { id, "aria-describedby": `${id}_hint ${id}_fault`, "data-path": path };
    const field = words
        ? element("select", described, ...options(words.map((word) => [word, scene.word_label(key, word)])))
        : element("input", { ...described, type: "text", autocomplete: "off", spellcheck: "false", placeholder: unquoted(key.default_value) });
    field.onchange = () => changed(field.value);
    const fault = element("output", { class: "fault", id: `${id}_fault`, for: id });
    const made = element(
        "div",
        { class: key.kind === scene.sins.SCENE_KEY_TEXT ? "row wide" : "row", title: hint },
        element("label", { for: id }, scene.name(path)),
        field,
        element("span", { class: "unit" }, unit_name(key)),
        element("span", { class: "hint", id: `${id}_hint` }, hint),
        fault,
    );
    return {
        made,
        field,
        path,
        key,
        /** Shows a value, unless the field has one that was rejected. */
        show(value, faults) {
            const own = faults.find((one) => path === one.path || path.startsWith(`${one.path}[`) || one.path.startsWith(`${path}[`));
            fault.value = own ? scene.told(own) : "";
            field.setAttribute("aria-invalid", String(own !== undefined));
            if (own === undefined || own.in_text) {
                field.value = !words && scene.is_default(key, value) ? "" : value.replace(/^\[|\]$/g, "");
            }
            made.classList.toggle("off", scene.is_default(key, value));
        },
    };
}

/** The fields of keys, in an element that follows the scene. */
export function fields(scene, keys) {
    const rows = keys.map((key) => row(scene, key, key.path, (value) => scene.set({ [key.path]: value })));
    const made = element("div", { class: "rows" }, ...rows.map((own) => own.made));
    made.refresh = () => rows.forEach((own) => own.show(scene.get(own.path), [...scene.faults, ...scene.refused]));
    return made;
}

/** A list of presets and the button that takes one. */
export function presets(scene, section) {
    const key = scene.key(`${section}.preset`), choices = scene.words(key).map((word) => [word, scene.word_label(key, word)]);
    const list = element("select", { "aria-label": text("preset"), "data-path": key.path }, ...options(choices));
    return element("div", { class: "bar" }, list, element("button", { onclick: () => scene.set({ [key.path]: list.value }) }, text("Apply")));
}

/** An item as a draft: [section, {name: value}] of itself and of those within it. */
function draft_of(item) {
    const draft = [];
    for (const line of item.split("\n")) {
        const head = /^\[\[(.+)\]\]/.exec(line), value = /^(\w+) = (.*)$/.exec(line);
        if (head) draft.push([head[1], {}]);
        else if (value) draft.at(-1)[1][value[1]] = unquoted(value[2].replace(/\s+# .*$/, ""));
    }
    return draft;
}

/** A draft as the text of an item. */
function item_of(scene, draft) {
    const lines = draft.map(([section, values]) => {
        const own = Object.entries(values).filter(([, value]) => value !== "");
        const value_of = ([name, value]) => {
            const key = scene.key(`${section}.${name}`), is_number = /^[-+.\d[]/.test(value);
            return `${name} = ${scene.words(key) || !is_number ? quoted(value) : scene.written(key.path, value)}\n`;
        };
        return `[[${section}]]\n${own.map(value_of).join("")}`;
    });
    return lines.join("");
}

/** Whether an item with these words can have a key: "kind=turn|s_turn sensor=gyro". */
function applies(key, values) {
    return key.condition.split(" ").filter(Boolean).every((term) => {
        const [name, words] = term.split("=");
        return words.split("|").includes(values[name]);
    });
}

/** The words and values of an item in a line. */
function summary(scene, draft) {
    const [section, values] = draft[0], words = [], numbers = [];
    for (const [name, value] of Object.entries(values)) {
        const key = scene.key(`${section}.${name}`);
        if (scene.words(key)) words.push(scene.word_label(key, value));
        else numbers.push(`${label(`${key.path}.short`, scene.name(key.path))} ${value} ${unit_name(key)}`);
    }
    return `${words.join(" ")}: ${numbers.join(", ")}`;
}

/** The items of a list: choose, add, move, remove, and edit one. fresh: the text of a new item. */
export function items(scene, list, fresh) {
    let chosen = 0, draft = null;
    const choices = element("select", { size: 5, "aria-label": text(LISTS[list]), "data-list": list });
    const editor = element("div", { class: "rows" });
    const button = (name, act) => element("button", { onclick: act }, text(name));
    const put = (all, next) => {
        const faults = scene.set_items(list, all);
        chosen = faults.length ? chosen : next;
        draft = null;
        made.refresh();
    };
    const bar = element(
        "div",
        { class: "bar" },
        button("Add", () => put(scene.items(list).toSpliced(chosen + 1, 0, fresh()), chosen + 1)),
        button("Remove", () => put(scene.items(list).toSpliced(chosen, 1), Math.max(chosen - 1, 0))),
        button("Move up", () => move(-1)),
        button("Move down", () => move(1)),
    );
    function move(by) {
        const all = scene.items(list), to = chosen + by;
        if (to >= 0 && to < all.length) put(all.with(to, all[chosen]).with(chosen, all[to]), to);
    }
    choices.onchange = () => {
        [chosen, draft] = [choices.selectedIndex, null];
        made.refresh();
    };

    /** Takes a value of the draft, and the draft if it is valid. */
    function take(part, name, value) {
        if (part === draft.length) draft.push([`${list}.sinusoid`, {}]);
        draft[part][1][name] = value;
        draft = draft.filter(([, values], k) => k === 0 || values.channel);
        if (draft[0][1].kind !== "sinusoids") draft.length = 1;
        const kept = draft.map(([section, values]) => {
            const used = Object.entries(values).filter(([own]) => applies(scene.key(`${section}.${own}`), values));
            return [section, Object.fromEntries(used)];
        });
        scene.set_items(list, scene.items(list).with(chosen, item_of(scene, kept)));
    }

    function edit() {
        const focus = document.activeElement?.dataset.path;
        editor.replaceChildren();
        const all = draft[0][1].kind === "sinusoids" && draft.length <= 6 ? [...draft, [`${list}.sinusoid`, {}]] : draft;
        all.forEach(([section, values], part) => {
            const at = `${list}[${chosen}]${part > 0 ? `.sinusoid[${part - 1}]` : ""}`;
            for (const key of scene.keys.filter((own) => own.section === section && applies(own, values))) {
                if (part > 0 && !values.channel && key.name !== "channel") continue;
                const own = row(scene, key, `${at}.${key.name}`, (value) => take(part, key.name, value));
                if (part > 0 && key.name === "channel") own.field.prepend(...options([["", "-"]]));
                editor.append(own.made);
                own.show(values[key.name] ?? (part === 0 && scene.words(key) ? unquoted(key.default_value) : ""), scene.faults);
                if (own.path === focus) own.field.focus();
            }
        });
    }

    const message = element("output", { class: "fault" });
    const made = element("div", { class: "items" }, choices, bar, message, editor);
    made.refresh = () => {
        const all = scene.items(list), own = scene.faults.filter((fault) => fault.path.startsWith(list));
        chosen = Math.max(0, Math.min(chosen, all.length - 1));
        if (own.length === 0 || draft === null) draft = all.length ? draft_of(all[chosen]) : null;
        choices.replaceChildren(...options(all.map((item, k) => [String(k), `${k + 1} ${summary(scene, draft_of(item))}`]), String(chosen)));
        message.value = own.length ? told_with_item(scene, own[0]) : "";
        if (draft) edit();
        else editor.replaceChildren();
        bar.children[1].disabled = all.length === 0;
    };
    return made;
}

/** What is wrong with an item, and with which one: the sentence of the library names the section alone. */
function told_with_item(scene, fault) {
    const told = scene.told(fault), [item] = /^\w+\[\d+\]/.exec(fault.path) ?? [""];
    return told.includes(item) ? told : `${item}: ${told}`;
}

const LISTS = { manoeuvre: "Manoeuvres", failure: "Failures of sensors", update: "Updates", panel: "Panel of the INS" };

/** A heading that folds what stands below it, unless something of it is set: is_set() tells it. */
export function folded(title, is_set, ...content) {
    const part = element("details", {}, element("summary", {}, title), ...content), made = element("div", {}, part);
    let was_set = false;
    made.refresh = () => {
        const is_now = is_set();
        // What a user sets back does not fold below the pointer.
        if (is_now !== was_set && (is_now || !part.contains(document.activeElement))) part.open = is_now;
        was_set = is_now;
    };
    return made;
}

/** A heading and what stands below it. */
export const group = (title, ...content) => element("section", {}, element("h3", {}, title), ...content);

/** The name of a section of the scene. */
export const section_name = (section) => {
    const index = ["gyro", "accelerometer", "altimeter", "gravity", "mounting", "start", "options", "flight", "output"].indexOf(section);
    return parts("sections")[index];
};

/** Selects a line of a text, and scrolls to it. */
export function select_place(area, line, column) {
    const lines = area.value.split("\n"), start = lines.slice(0, line - 1).reduce((sum, own) => sum + own.length + 1, 0);
    area.focus();
    area.setSelectionRange(start + Math.max(0, column - 1), start + (lines[line - 1]?.length ?? 0));
    area.scrollTop = (area.scrollHeight / lines.length) * Math.max(0, line - 4);
}
