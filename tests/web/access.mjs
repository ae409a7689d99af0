// Accessibility by axe-core: nothing serious or critical in the page, its lessons, and the pages of the program.
//
//     SINS=target/release/sins node --test tests/web/access.mjs      see tests/web.sh

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import test, { after, before } from "node:test";
import { pathToFileURL } from "node:url";

import { lessons_of } from "../../apps/page/pack/lessons_of.mjs";
import { opened, out, start, stop, unfold, until } from "./user.mjs";

const { SINS } = process.env;
const axe = readFileSync("target/node/node_modules/axe-core/axe.min.js", "utf8");

before(start);
after(stop);

/** What axe-core finds on a page: rule, impact and elements. */
async function found(page) {
    await page.evaluate(axe);
    const { violations, passes } = await page.evaluate(() => window.axe.run(document));
    assert.ok(passes.length > 10);
    return violations.map(({ id, impact, nodes }) => [id, impact, nodes.slice(0, 3).map(({ html }) => html.slice(0, 120))]).filter(([, impact]) => ["serious", "critical"].includes(impact));
}

test("axe-core finds a fault, if there is one", async (context) => {
    const page = await opened(context, { hash: "#rest" });
    await page.evaluate(() => document.body.append(Object.assign(document.createElement("button"), { id: "nameless" })));
    assert.deepEqual((await found(page)).map(([id]) => id), ["button-name"]);
});

test("the page: every tab of the settings, light and dark, wide and narrow, in both languages", async (context) => {
    for (const options of [{}, { colorScheme: "dark", viewport: { width: 400, height: 800 } }]) {
        const page = await opened(context, { hash: "", ...options });
        await until(page, /^Finished/);
        for (const place of [0, 1, 2, 3, 4]) {
            await page.click(`#tab${place}`);
            await unfold(page);
            assert.deepEqual(await found(page), [], `tab ${place}`);
        }
        await page.selectOption("#language", "zh");
        assert.deepEqual(await found(page), []);
    }
});

test("each lesson", async (context) => {
    for (const { name } of lessons_of("apps/page/lessons")) {
        const page = await opened(context, { hash: `#lesson=${name}`, colorScheme: name === "unit" ? "dark" : "light" });
        await until(page, /^Finished/);
        assert.deepEqual(await found(page), [], name);
        await page.context().close();
    }
});

test("pages of the program", async (context) => {
    const sins = (...values) => execFileSync(SINS, values, { cwd: `${out}/flown`, stdio: "pipe" });
    sins("fly", "simulation2", "--set", "flight.hours=0.1", "--quiet", "--force");
    sins("fly", "rest", "--preset", "tactical", "--set", "flight.hours=0.1", "--quiet", "--force");
    sins("report", "sins_out/simulation2.csv", "sins_out/rest.csv", "-o", "report.html", "--force");
    sins("ensemble", "simulation2", "--runs", "8", "--set", "flight.hours=0.1", "--quiet", "--force");
    for (const file of ["report.html", "sins_out/simulation2_ensemble.html"]) {
        for (const colorScheme of ["light", "dark"]) {
            const page = await opened(context, { hash: "#rest", colorScheme });
            await page.goto(pathToFileURL(`${out}/flown/${file}`).href);
            assert.deepEqual(await found(page), [], `${file}, ${colorScheme}`);
            await page.context().close();
        }
    }
});
