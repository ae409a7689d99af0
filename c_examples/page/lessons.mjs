// Lessons: a row of links to them, and the lesson that is open: its title, its question and its paragraphs.

import { element, language, text } from "./texts.mjs";

/** A lesson by its name in the address, or undefined. */
export const lesson_of = (lessons, name) => lessons.find((own) => own.name === name);

/** The links to the first flight and to the lessons, with the open one marked. */
export function row_of(lessons, open) {
    const link = (href, name, is_open) => element("a", { href, "aria-current": is_open ? "page" : undefined }, name);
    const links = lessons.map((own) => link(`#lesson=${own.name}`, own[language].title, own === open.lesson));
    return element("nav", { "aria-label": text("Lessons") }, link("#", text("first_flight"), open.is_first), ...links);
}

/** What stands beside the picture. */
export function lesson_made(lesson) {
    const { title, question, paragraphs } = lesson[language];
    return element(
        "article",
        { class: "lesson", "aria-labelledby": "lesson_title" },
        element("h2", { id: "lesson_title" }, title),
        element("p", { class: "question" }, question),
        ...paragraphs.map((own) => element("p", {}, own)),
    );
}
