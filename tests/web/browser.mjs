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
