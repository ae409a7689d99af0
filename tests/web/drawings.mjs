// What the tests of pages with drawings share.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

import { browser, kept_from } from "./browser.mjs";

const { SINS } = process.env;
export const out = resolve("target/web/pages");
let chromium;

mkdirSync(out, { recursive: true });
export const sins = (...order) => execFileSync(SINS, order, { cwd: out, stdio: ["ignore", "pipe", "pipe"] });
export const start = async () => (chromium = await browser());
export const stop = () => chromium.close();

/** A page, opened from its file. Errors within it fail the test; requests to others too. */
export async function opened(context, name, options = {}) {
    const browsing = await chromium.newContext({ viewport: { width: 1360, height: 900 }, ...options }), page = await browsing.newPage(), errors = [];
    page.on("pageerror", (error) => errors.push(error.stack));
    page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
    page.on("request", (request) => /^(file|data|blob):/.test(request.url()) || errors.push(request.url()));
    context.after(async () => {
        await browsing.close();
        assert.deepEqual(errors, []);
    });
    await page.goto(pathToFileURL(`${out}/${name}.html`).href);
    return page;
}

/** What the policy of a page keeps a foreign text within it from doing. */
export const policy_of = (name) => kept_from(chromium, pathToFileURL(`${out}/${name}.html`).href);

export const caption_of = (own) => own.locator(".caption").innerHTML();
export const text_of = (own) => own.locator(".caption").evaluate((caption) => caption.textContent);

/** Points at a share of a panel, from left to right, and from above. */
export async function point(page, own, right, down = 0.5) {
    const hit = own.locator(".hit");
    await hit.scrollIntoViewIfNeeded();
    const box = await hit.boundingBox();
    await page.mouse.move(box.x + right * box.width, box.y + down * box.height);
}

/** Name and text of a file that a figure saves. */
export async function saved(page, figure, kind) {
    const [download] = await Promise.all([page.waitForEvent("download"), figure.locator(".save button", { hasText: kind }).first().click()]);
    return [download.suggestedFilename(), readFileSync(await download.path(), "utf8")];
}

/** The rows of the data that a figure saves: panel, line, time, right and up. */
export async function rows_of(page, figure) {
    const [head, ...lines] = (await saved(page, figure, "csv"))[1].trim().split("\n");
    assert.equal(head, "panel,line,time,x,y");
    return lines.map((line) => JSON.parse(`[${line}]`));
}

/** The rows of a file without quotation marks, by their heads. */
export function table(path) {
    const [head, ...lines] = readFileSync(`${out}/${path}`, "utf8").trim().split("\n").map((line) => line.split(","));
    return lines.map((line) => Object.fromEntries(head.map((name, k) => [name, line[k]])));
}
