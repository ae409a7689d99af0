// Pages of `sins report` and `sins ensemble` in Chromium: values at the cursor against the records, enlarged parts, keys, files, and the
// page without its script.
//
//     SINS=target/release/sins node --test tests/web/pages.mjs      see tests/web.sh

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test, { after, before } from "node:test";

import { KEPT_WITH_WORKERS } from "./browser.mjs";
import { caption_of, opened, out, point, policy_of, rows_of, saved, sins, start, stop, text_of } from "./drawings.mjs";

const MOST_BYTES = 8192;

before(async () => {
    const quiet = ["--quiet", "--force", "--out", out];
    sins("fly", "simulation2", "--set", "flight.hours=2", ...quiet);
    sins("fly", "aerobatics", "--set", "flight.hours=0.05", "--preset", "tactical", ...quiet);
    sins("report", "simulation2.csv", "aerobatics.csv", "-o", "report.html", "--force");
    sins("ensemble", "simulation2", "--runs", "16", "--set", "flight.hours=0.2", ...quiet);
    for (const [scene, ...more] of [["simulation1"], ["coning"], ["rest", "--preset", "ideal", "--name", "ideal"]]) sins("fly", scene, "--set", "flight.hours=0.1", ...more, ...quiet);
    sins("report", "simulation2.csv", "-o", "one.html", "--force");
    sins("report", "simulation2.csv", "simulation1.csv", "ideal.csv", "aerobatics.csv", "coning.csv", "-o", "five.html", "--force");
    await start();
});
after(stop);

/** The panel with a caption, in the figures of a run. */
const panel = (page, run, caption) => page.locator(`[data-run="${run}"] .panel`, { has: page.locator(`.caption:text("${caption}")`) }).first();
const parts_shown = (page, run) => page.locator(`[data-run="${run}"] .panel.part`).count();

/** Columns of a file of records. */
function records(name) {
    const [head, ...lines] = readFileSync(`${out}/${name}.csv`, "utf8").trim().split("\n").map((line) => line.split(","));
    return Object.fromEntries(head.map((column, k) => [column, lines.map((line) => Number(line[k]))]));
}

/** A column at a time, and how much it changes within two pixels of the drawing. */
function expected(all, column, time_s, width_s) {
    const near = all[column].filter((_, k) => Math.abs(all.time_s[k] - time_s) <= width_s);
    return [Math.min(...near), Math.max(...near)];
}

test("a cursor shows the values of all panels of the run at that time: those of its records", async (context) => {
    const page = await opened(context, "report"), all = records("simulation2");
    for (const share of [0.05, 0.55, 0.95]) {
        await point(page, panel(page, 1, "position east"), share);
        const shown = await text_of(panel(page, 1, "position east")), [, time_min] = /(-?[\d.]+) min/.exec(shown), time_s = Number(time_min) * 60;
        assert.ok(Math.abs(time_s - share * 7200) < 30, shown);
        for (const [caption, column, size] of [
            ["position east [km]", "position_east_m", 1000],
            ["position north [km]", "position_north_m", 1000],
            ["velocity east", "velocity_east_m_s", 1],
        ]) {
            const own = panel(page, 1, caption), text = await text_of(own), values = text.match(/▪ (-?[\d.]+)/g)?.map((value) => Number(value.slice(2)));
            assert.ok(values?.length >= 2, text);
            const [low, high] = expected(all, `navigation_error_${column}`, time_s, 30), margin = 0.004 * Math.max(...all[`navigation_error_${column}`].map(Math.abs));
            for (const value of values) assert.ok(value * size > low - margin && value * size < high + margin, `${text}: ${low} to ${high}`);
        }
        // Of the track the first and the last 15 minutes are drawn: it has a dot then. The other run has no cursor.
        assert.equal((await panel(page, 1, "north of the start").locator(".cursor circle").count()) > 0, share !== 0.55);
        assert.equal(await page.locator('[data-run="2"] .cursor').count(), 0);
    }
    await page.mouse.move(2, 2);
    assert.equal(await page.locator(".cursor").count(), 0);
});

test("the first screen has the sentence, the map and the position errors of the run that was named first", async (context) => {
    for (const [name, count] of [["one", 1], ["five", 5]]) {
        for (const viewport of [{ width: 800, height: 800 }, { width: 1280, height: 800 }, { width: 1920, height: 800 }]) {
            const page = await opened(context, name, { viewport }), figures = page.locator("main > .figures");
            const bottom = async (own) => ((box) => box.y + box.height)(await own.boundingBox());
            const lead = page.locator(".lead");
            const map = figures.locator(".panel", { hasText: "north of the start" }).locator(".inner").first();
            const position = figures.locator(".panel", { hasText: "position east" }).locator(".inner").first();
            for (const own of [lead, map, position]) assert.ok((await bottom(own)) <= viewport.height, `${name} ${viewport.width}: ${await bottom(own)}`);
            assert.match(await lead.innerText(), /After .* the INS is .* off/);
            const sections = await page.locator("section.run").all();
            assert.equal(sections.length, count);
            for (const section of sections) {
                const is_rounding = /no error beyond rounding/.test(await section.innerText());
                assert.equal((await section.locator(".panel").count()) === 0, is_rounding, `${name}: ${await section.getAttribute("id")}`);
            }
            // That of ideal sensors is among the five.
            assert.equal((await page.locator("section.run", { hasText: "no error beyond rounding" }).count()) > 0, name === "five");
        }
    }
});

test("the first screen of an ensemble has the sentence with CEP50 and R95, and their picture", async (context) => {
    for (const viewport of [{ width: 1280, height: 800 }, { width: 1920, height: 800 }]) {
        const page = await opened(context, "simulation2_ensemble", { viewport });
        assert.match(await page.locator(".lead").innerText(), /^After 12 min half of the 16 runs are within .* \(CEP50; .* to .*\), and 95 % within .* \(R95; /);
        const picture = page.locator(".panel", { hasText: "horizontal error" }).locator(".inner").first(), { y, height } = await picture.boundingBox();
        assert.ok(y + height <= viewport.height, `${viewport.width}: ${y + height}`);
    }
});

test("drag enlarges all panels of the run, double-click goes back", async (context) => {
    const page = await opened(context, "report"), own = panel(page, 1, "position east");
    const grid = await own.locator(".x-ticks").count();
    await point(page, own, 0.25);
    await page.mouse.down();
    await point(page, own, 0.5);
    await page.mouse.up();
    const enlarged = await parts_shown(page, 1);
    assert.ok(enlarged >= 10, `${enlarged} panels`); // position, velocity, misalignment, attitude, track
    assert.equal(await parts_shown(page, 2), 0);
    const last = panel(page, 1, "difference of the two"), ticks = (await last.locator(".now .x-ticks text").allTextContents()).map(Number);
    assert.ok(ticks.length >= 4 && ticks[0] >= 30 && ticks.at(-1) <= 60, `${ticks}`);
    assert.equal(await last.locator("> .x-ticks").isVisible(), false);
    await point(page, own, 0.5); // the middle of the part
    const [, time_min] = /(-?[\d.]+) min/.exec(await text_of(own));
    assert.ok(Math.abs(Number(time_min) - 45) < 0.5, time_min);
    await own.locator(".hit").dblclick();
    assert.equal(await parts_shown(page, 1), 0);
    assert.equal(await own.locator(".x-ticks").count(), grid);
});

test("keys do the same, and what they show is said", async (context) => {
    const page = await opened(context, "report"), own = panel(page, 1, "position east");
    await own.locator(".hit").focus();
    await page.keyboard.press("ArrowRight");
    const first = await text_of(own);
    await page.keyboard.press("Shift+ArrowRight");
    const second = await text_of(own), time_min = (text) => Number(/(-?[\d.]+) min/.exec(text)[1]);
    assert.ok(Math.abs(time_min(second) - time_min(first) - 12) < 0.1, `${first}; ${second}`);
    assert.equal(await page.locator(".said").textContent(), second);
    await page.keyboard.press("+");
    assert.ok((await parts_shown(page, 1)) >= 10);
    await page.keyboard.press("-");
    await page.keyboard.press("-");
    assert.equal(await parts_shown(page, 1), 0);
    await page.keyboard.press("+");
    await page.keyboard.press("Escape");
    assert.equal(await parts_shown(page, 1), 0);
    // One stop of the tab key for each drawing.
    const stops = await page.locator('.hit[tabindex="0"]').count();
    assert.equal(stops, await page.locator(".plot:has(.panel)").count());
});

test("a drawing is saved as SVG, and its data as CSV", async (context) => {
    const page = await opened(context, "report"), figure = page.locator("figure", { has: page.locator('.caption:text("position east")') }).first();
    const [svg_name, svg] = await saved(page, figure, "svg");
    assert.match(svg_name, /\.svg$/);
    const alone = await page.context().newPage(); // the policy of the page permits no image
    const size = await alone.evaluate((text) => new Promise((done) => {
        const faults = new DOMParser().parseFromString(text, "image/svg+xml").querySelectorAll("parsererror").length, image = new Image();
        image.onload = () => done([faults, image.naturalWidth, image.naturalHeight]);
        image.onerror = () => done(null);
        image.src = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
    }), svg);
    assert.ok(size?.[0] === 0 && size[1] > 400 && size[2] > 400, `${size}`);
    assert.match(svg, /data 2: navigation minus truth/); // with its legend
    const rows = await rows_of(page, figure), all = records("simulation2");
    const east = rows.filter(([caption, line]) => caption?.startsWith("position east") && line?.startsWith("data 2"));
    assert.ok(east.length > 100);
    const most_m = Math.max(...all.navigation_error_position_east_m.map(Math.abs));
    for (const [, , , time_min, value_km] of east) {
        const [low, high] = expected(all, "navigation_error_position_east_m", Number(time_min) * 60, 15), margin = 0.001 * most_m;
        assert.ok(value_km * 1000 > low - margin && value_km * 1000 < high + margin, `${time_min} min: ${value_km} km, ${low} to ${high} m`);
    }
});

test("without script a page is complete: nothing of the script is on it", async (context) => {
    for (const name of ["report", "simulation2_ensemble"]) {
        const page = await opened(context, name, { javaScriptEnabled: false });
        for (const what of [".hit", ".save", ".cursor", ".said"]) assert.equal(await page.locator(what).count(), 0);
        assert.equal(await page.locator(".help").isVisible(), false);
        assert.ok((await page.locator(".plot").count()) > 3);
        const [, script] = /<script>(.*?)<\/script>/s.exec(readFileSync(`${out}/${name}.html`, "utf8"));
        assert.ok(script.length <= MOST_BYTES, `${script.length} bytes`);
    }
});

test("every panel of every page answers; dark, 400 pixels and print stay", async (context) => {
    for (const name of ["report", "simulation2_ensemble"]) {
        for (const options of [{}, { colorScheme: "dark", viewport: { width: 400, height: 800 } }]) {
            const page = await opened(context, name, options);
            assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0);
            const panels = await page.locator(".panel:visible").all();
            assert.ok(panels.length > 5);
            for (const own of panels) {
                await page.mouse.move(1, 1);
                const before = await caption_of(own);
                await point(page, own, 0.4);
                assert.notEqual(await caption_of(own), before, before);
            }
            await page.screenshot({ path: `${out}/${name}_${options.colorScheme ?? "light"}.png` });
            await page.emulateMedia({ media: "print" });
            for (const what of [".save", ".help"]) assert.equal(await page.locator(what).first().isVisible(), false);
        }
    }
});

test("a page runs its own script and nothing else, and loads nothing", async () => {
    for (const name of ["report", "one", "five", "simulation2_ensemble"]) assert.deepEqual(await policy_of(name), KEPT_WITH_WORKERS, name);
});
