// What a user does at the page, and the page in Chromium from its file, for the tests of the page.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

import { browser } from "./browser.mjs";

const { SINS, SINS_PAGE = "target/web/sins.html", SINS_MODULE } = process.env;
export const out = resolve("target/web"), address = pathToFileURL(resolve(SINS_PAGE)).href;
let chromium;

/** Starts the browser. Returns it, and the time that Node needs for a flown hour. */
export async function start() {
    mkdirSync(`${out}/flown`, { recursive: true });
    chromium = await browser();
    return { chromium, hour_ms: await hour_in_node_ms() };
}
export const stop = () => chromium.close();

/** Time of the processor that Node needs for an hour of simulation 2, flown sample by sample by the page's module [ms]. */
async function hour_in_node_ms() {
    const { load } = await import(pathToFileURL(resolve(SINS_MODULE)));
    const sins = await load(), scene = sins.scene_create_builtin("simulation2"), { rate_hz } = sins.scene_get_setup(scene);
    const sim = sins.scene_create_simulator(scene), flight = sins.scene_create_flight(scene), sample = new sins.flight_sample();
    const began = process.cpuUsage();
    for (let k = 0; k < 3600 * rate_hz; k++) {
        sins.flight_sample_at(flight, k / rate_hz, sample);
        sins.scene_prepare(scene, sim, 0, sample);
        sins.push_sample(sim, sample);
        sins.step(sim);
    }
    return process.cpuUsage(began).user / 1000;
}

/** The page, opened from its file; without a hash it flies at once. Errors within it fail the test; requests to others too. */
export async function opened(context, { hash = "#simulation2", ...options } = {}) {
    const own_context = await chromium.newContext({ viewport: { width: 1360, height: 900 }, ...options });
    const page = await own_context.newPage(), errors = [];
    page.on("pageerror", (error) => errors.push(error.stack));
    page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
    page.on("request", (request) => /^(file|data|blob):/.test(request.url()) || errors.push(request.url()));
    const { close } = own_context;
    context.after(async () => {
        await close.call(page.context());
        assert.deepEqual(errors, []);
    });
    await page.goto(address + hash);
    await page.waitForSelector("body[data-ready]");
    return page;
}

export const state = (page) => page.evaluate(() => document.getElementById("state").value);
export const until = (page, pattern) => page.waitForFunction((source) => new RegExp(source).test(document.getElementById("state").value), pattern.source, { timeout: 600000, polling: 50 });
export const press = (page, name) => page.click(`[data-do="${name}"]`);
export const field = (path) => `[data-path="${path}"]`;
export const tab = (page, place) => page.click(`#tab${place}`);
export const text = (page) => page.evaluate(() => document.getElementById("text")?.value);

export async function set(page, path, value) {
    const at = page.locator(field(path)).first();
    await ((await at.evaluate((own) => own.tagName)) === "SELECT" ? at.selectOption(value) : at.fill(value));
    await at.blur();
}

/** Opens all folded parts of the settings. */
export const unfold = (page) => page.evaluate(() => document.querySelectorAll("aside details").forEach((own) => (own.open = true)));

/** Writes the whole text of the scene. */
export async function write(page, scene) {
    await tab(page, 4);
    await page.fill("#text", scene);
    await page.waitForFunction(() => document.getElementById("text").getAttribute("aria-invalid") === "false");
    await page.waitForTimeout(700);
}

export async function downloaded(page, what) {
    const [download] = await Promise.all([page.waitForEvent("download"), press(page, what)]);
    return readFileSync(await download.path());
}

export async function fly(page) {
    await press(page, "start");
    await until(page, /^(Finished|已完成)/);
}

/** Saves scene and records, and compares the records with those of the program for this scene. */
export async function same_as_program(page, name) {
    const [scene, records] = [await downloaded(page, "save"), await downloaded(page, "records")];
    writeFileSync(`${out}/flown/${name}.toml`, scene);
    execFileSync(SINS, ["fly", `${out}/flown/${name}.toml`, "--out", `${out}/flown/expected`, "--quiet", "--force"]);
    const expected = readFileSync(`${out}/flown/expected/${name}.csv`);
    assert.ok(expected.length > 10000);
    assert.ok(records.equals(expected), `${name}: other records than those of sins fly`);
    return scene.toString();
}

/** Drops files on the page, all at once. */
export async function drop(page, ...paths) {
    await page.evaluate(() => document.body.append(Object.assign(document.createElement("input"), { type: "file", id: "dropped", hidden: true, multiple: true })));
    await page.setInputFiles("#dropped", paths);
    await page.evaluate(() => {
        const data = new DataTransfer(), input = document.getElementById("dropped");
        for (const file of input.files) data.items.add(file);
        input.remove();
        document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
    });
}
