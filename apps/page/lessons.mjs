// Lessons: a row of links to them, and the lesson that is open: its title, its question, its sliders and its paragraphs.

import { unit_name } from "./scene.mjs";
import { element, label, language, shown, text } from "./texts.mjs";

/** A lesson by its name in the address, or undefined. */
export const lesson_of = (lessons, name) => lessons.find((own) => own.name === name);

/** The links to the first flight and to the lessons, with the open one marked. */
export function row_of(lessons, open) {
    const link = (href, name, is_open) => element("a", { href, "aria-current": is_open ? "page" : undefined }, name);
    const links = lessons.map((own) => link(`#lesson=${own.name}`, own[language].title, own === open.lesson));
    return element("nav", { "aria-label": text("Lessons") }, link("#", text("first_flight"), open.is_first), ...links);
}

/** The first number of a value: that of all axes, or of the first one. */
const number_of = (value) => Number.parseFloat(value.replace(/^\[/, ""));

/** A slider of a key of the scene: fly() is called when it has set a value. It stands at the value of the scene, or at the nearest number. */
function slider_made(scene, own, k, fly) {
    const { key, values } = own, id = `lesson_slider${k}`, known = scene.key(key), unit = unit_name(known), is_word = typeof values[0] === "string";
    const input = element("input", { type: "range", id, min: 0, max: values.length - 1, step: 1, "data-slides": key }), output = element("output", { for: id });
    input.oninput = () => scene.set({ [key]: String(values[input.value]) }).length || fly();
    const made = element("div", { class: "slider" }, element("label", { for: id }, own[language]), input, output);
    made.refresh = () => {
        const written = scene.get(key), value = number_of(written), off = values.map((one) => (is_word ? Number(one !== written) : Math.abs(one - value)));
        const words = known.name === "builtin" ? label(`builtin.${written}`, written) : scene.word_label(known, written);
        [input.value, output.value] = [off.indexOf(Math.min(...off)), is_word ? words : `${shown(value, 6)} ${unit}`.trimEnd()];
        input.setAttribute("aria-valuetext", output.value);
    };
    return made;
}

/** What the sliders do, with the sample interval of the scene. */
function rate_made(scene) {
    const made = element("div", { class: "hint" });
    made.refresh = () => (made.textContent = text("lesson_rate", shown(1 / scene.sins.scene_get_setup(scene.handle).rate_hz, 4)));
    return made;
}

/** What a step takes here: times(text), a promise, measures it for each scene, one at a time. */
function times_made(scene, times) {
    const made = element("div", { class: "hint", "data-times": "" });
    let [measured, is_busy] = [null, false];
    made.refresh = async () => {
        if (is_busy || scene.text === measured || scene.faults.length > 0) return;
        [measured, is_busy] = [scene.text, true];
        const [own_us, ideal_us] = await times(measured).catch(() => []);
        is_busy = false;
        if (scene.text !== measured) return made.refresh();
        made.textContent = own_us > 0 ? text("lesson_times", shown(own_us, 2), shown(ideal_us, 2)) : "";
    };
    return made;
}

/** What stands beside the picture; on a narrow screen the paragraphs are below it, so that a slider is near its curves. */
export function lesson_made(lesson, scene, fly, times) {
    const { title, question, paragraphs } = lesson[language];
    return element(
        "article",
        { class: "lesson", "aria-labelledby": "lesson_title" },
        element(
            "div",
            {},
            element("h2", { id: "lesson_title" }, title),
            element("p", { class: "question" }, question),
            ...lesson.slider.map((own, k) => slider_made(scene, own, k, fly)),
            ...(lesson.slider.length > 0 ? [rate_made(scene)] : []),
            ...(lesson.times ? [times_made(scene, times)] : []),
        ),
        element("div", { class: "words" }, ...paragraphs.map((own) => element("p", {}, own))),
    );
}
