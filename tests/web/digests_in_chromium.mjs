// The digests of digests.mjs in Chromium: `node tests/web/digests_in_chromium.mjs FOLDER`.

import { readFileSync } from "node:fs";

import { browser, page_with } from "./browser.mjs";
import { are_expected } from "./digests.mjs";

const chromium = await browser();
const page = await page_with(chromium, process.argv[2]);
const flights = readFileSync(new URL("flights.mjs", import.meta.url), "utf8").replace("export class", "class");
const found = await page.evaluate(`(async () => {
    ${flights}
    const { load } = await import("./sins.mjs");
    return [...new Flights(await load()).digests()];
})()`);
process.exitCode = are_expected(found) ? 0 : 1;
console.log(`in Chromium ${chromium.version()}`);
await chromium.close();
