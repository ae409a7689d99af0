// Chromium for the tests, without a network.

import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";

const require = createRequire(resolve("target/node/package.json"));

export async function browser() {
    const flags = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"];
    return require("playwright-core").chromium.launch({ executablePath: "/usr/bin/chromium", args: flags });
}

/** A page at an address at which the files of a folder are. */
export async function page_with(browser, folder) {
    const page = await browser.newPage();
    const types = { html: "text/html", mjs: "text/javascript", wasm: "application/wasm" };
    await page.route("https://sins.test/**", (route) => {
        const { pathname } = new URL(route.request().url());
        const body = pathname === "/" ? "<!doctype html>" : readFileSync(resolve(folder, pathname.slice(1)));
        return route.fulfill({ body, contentType: types[pathname.split(".")[1]] ?? "text/html" });
    });
    await page.goto("https://sins.test/");
    return page;
}

/**
 * Does something, and returns the longest task of the pages and the sum of the tasks of their workers, in milliseconds of the processor:
 * a busy machine does not lengthen them.
 */
export async function processor_times(browser, act) {
    const session = await browser.newBrowserCDPSession(), events = [];
    session.on("Tracing.dataCollected", ({ value }) => events.push(...value.filter((event) => event.name === "thread_name" || (event.ph === "X" && /RunTask/.test(event.name)))));
    await session.send("Tracing.start", { transferMode: "ReportEvents", traceConfig: { includedCategories: ["toplevel", "__metadata"] } });
    await act();
    const ended = new Promise((done) => session.once("Tracing.tracingComplete", done));
    await session.send("Tracing.end");
    await ended;
    await session.detach();
    const named = (name) => new Set(events.filter((event) => event.args?.name === name).map(({ pid, tid }) => `${pid} ${tid}`));
    const times_ms = (threads) => events.filter(({ pid, tid, tdur }) => tdur !== undefined && threads.has(`${pid} ${tid}`)).map(({ tdur }) => tdur / 1000);
    const [pages, workers] = [times_ms(named("CrRendererMain")), times_ms(named("DedicatedWorker thread"))];
    return { tasks: pages.length, longest_ms: Math.max(...pages), workers_ms: workers.reduce((sum, own) => sum + own, 0) };
}

/** What the content security policy of a page at an address keeps a foreign text within it from doing: the directives, and what it did. */
export async function kept_from(browser, address) {
    const page = await browser.newPage(), requests = [];
    const keep = (request, error = "") => error === "csp" || /^(file|data|blob):/.test(request.url()) || requests.push(`${request.url()} ${error}`);
    page.on("requestfinished", (request) => keep(request));
    page.on("requestfailed", (request) => keep(request, request.failure().errorText));
    await page.goto(address);
    const found = await page.evaluate(async () => {
        const directives = new Set(), add = (tag, values) => document.body.append(Object.assign(document.createElement(tag), values));
        document.addEventListener("securitypolicyviolation", ({ effectiveDirective }) => directives.add(effectiveDirective));
        const fetched = await fetch("https://sins.test/").then(() => true, () => false);
        const worker = await new Promise((done) => {
            try {
                const own = new Worker(URL.createObjectURL(new Blob(['fetch("https://sins.test/").then(() => postMessage(true), () => postMessage(false))'])));
                [own.onmessage, own.onerror] = [({ data }) => done(data), () => done(false)];
            } catch {
                done(false);
            }
        });
        add("img", { src: "https://sins.test/image.png" });
        add("iframe", { src: "https://sins.test/" });
        add("script", { textContent: "window.ran = true" });
        add("script", { src: "https://sins.test/script.js" });
        add("style", { textContent: "body { color: red }" });
        add("p", { innerHTML: '<b style="color: red" onclick="window.ran = true">x</b>' });
        document.querySelector("p b[onclick]").click();
        document.head.append(Object.assign(document.createElement("base"), { href: "https://sins.test/" }));
        await new Promise((done) => setTimeout(done, 500));
        return { directives: [...directives].sort(), did: [fetched, worker, Boolean(window.ran), getComputedStyle(document.querySelector("p b[onclick]")).color === "rgb(255, 0, 0)"] };
    });
    await page.close();
    return { ...found, requests };
}

/** From everything; a page may have workers of its own. */
export const KEPT = {
    directives: ["base-uri", "connect-src", "frame-src", "img-src", "script-src-attr", "script-src-elem", "style-src-attr", "style-src-elem"],
    did: [false, false, false, false],
    requests: [],
};

/** From everything, workers too. */
export const KEPT_WITH_WORKERS = { ...KEPT, directives: [...KEPT.directives, "worker-src"].sort() };
