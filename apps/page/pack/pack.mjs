// Packs the page into one file: node pack.mjs FOLDER UPLOT OUT.html, with sins.mjs, sins.wasm and licences in FOLDER, and the files of uPlot
// in UPLOT. The modules become one script, in which each name exists once; the page and its workers run it.

import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

import { lessons_of, read_by } from "./lessons_of.mjs";

const [folder, uplot, out] = process.argv.slice(2), own = join(dirname(new URL(import.meta.url).pathname), "..");
const read = (...path) => readFileSync(join(...path), "utf8");

/** Modules in the order in which each stands behind those that it imports. */
function modules(name, found = new Map()) {
    if (found.has(name)) return found;
    const source = name === "sins" ? read(folder, "sins.mjs") : read(own, name);
    found.set(name, null); // being read
    for (const [, imported] of source.matchAll(/^import [^;]*? from "(?:\.\/)?(.+?)";$/gm)) modules(imported, found);
    found.delete(name);
    return found.set(name, source);
}

/** A module within the common script, which is no module: browsers start no module as worker of a page that is a file. Without its comments. */
const within = (source) => source.replace(/^ *(\/\/.*|\/\*\*[^]*?\*\/)\n/gm, "").replace(/^import [^;]*? from ".+?";$\n/gm, "").replace(/^export /gm, "").replaceAll("import.meta.url", "location.href");

/** A text within an element of script. */
function data(id, text, type = "text/plain") {
    if (/<\/script|<!--/i.test(text)) throw new Error(`${id}: has an end of an element`);
    return `<script type="${type}" id="${id}">${text}</script>`;
}

/** The library is 4 % smaller by libdeflate than by zlib. */
const gzip = (input) => execFileSync("libdeflate-gzip", ["-12", "-c"], { input, maxBuffer: 2 ** 26 }).toString("base64");
const texts = (language) => read(own, "../emulator", `${language}.txt`);
const licences = [
    `uPlot\n\n${read(uplot, "../LICENSE")}`,
    ...readdirSync(join(folder, "licences")).map((name) => `${name}\n\n${read(folder, "licences", name).replace(/<style[^]*?<\/style>|<[^>]+>/g, "")}`),
];
const { load } = await import(pathToFileURL(resolve(folder, "sins.mjs")));
const lessons = read_by(await load(), lessons_of(join(own, "lessons")));
const program = [read(uplot, "uPlot.iife.min.js"), ...[...modules("page.mjs").values()].map(within)].join("\n");
const style = `\n${read(uplot, "uPlot.min.css")}\n${read(own, "page.css")}`, script = `\n"use strict";\n{\n${program}\n}\n`;
const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
/** Nothing but these two texts, the library and the worker, which is the same script: no network. */
const policy = `default-src 'none'; script-src ${hash(script)} 'wasm-unsafe-eval'; worker-src blob:; style-src ${hash(style)}; base-uri 'none'; form-action 'none'`;
const page = read(own, "page.html")
    .replace("<!-- policy -->", () => `<meta http-equiv="Content-Security-Policy" content="${policy}" />`)
    .replace("<!-- style -->", () => `<style>${style}</style>`)
    .replace("<!-- data -->", () => [data("en", texts("en")), data("zh", texts("zh")), data("lessons", JSON.stringify(lessons), "application/json"), data("licences", gzip(licences.join("\n\n"))), data("library", gzip(readFileSync(join(folder, "sins.wasm"))))].join("\n"))
    .replace("<!-- program -->", () => data("program", script, "text/javascript"));
writeFileSync(out, page);
console.log(`${out}: ${(page.length / 1e6).toFixed(2)} MB`);
