// The page as somebody meets it who knows nothing of it: the first screen.
//
//     SINS=target/release/sins node --test tests/web/teaching.mjs      see tests/web.sh

import assert from "node:assert/strict";
import test, { after, before } from "node:test";

import { processor_times } from "./browser.mjs";
import { field, fly, opened, out, same_as_program, set, start, state, stop, until } from "./user.mjs";

/** Samples of the opening flight in those of the hour that Node flies. */
const OPENING_HOURS = (48 * 3600) / 360000;
/** Most time of the workers, from their start on, in that of Node for as many samples. */
const MOST_TO_NODE = 4;
let chromium, hour_ms;

before(async () => ({ chromium, hour_ms } = await start()));
after(stop);

const answer = (page) => page.evaluate(() => document.getElementById("answer").value);
/** Drawings without a curve, and black instruments, that the page shows: none is the aim. */
const empty = (page) => page.evaluate(() => {
    const is_shown = (own) => own.checkVisibility() && own.clientWidth > 0;
    const ink = (canvas) => {
        const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height), inks = new Set();
        for (let k = 0; k < data.length; k += 4) if (data[k + 3] === 255) inks.add(`${data[k]},${data[k + 1]},${data[k + 2]}`);
        return inks;
    };
    const plots = [...document.querySelectorAll(".uplot")].filter(is_shown), curve_inks = ["0,70,160", "142,197,255", "242,154,74", "184,106,28"];
    const bare = plots.filter((plot) => !curve_inks.some((own) => ink(plot.querySelector("canvas")).has(own)));
    const black = [...document.querySelectorAll(".indicator canvas")].filter((own) => is_shown(own) && !ink(own).has("70,140,220"));
    return { plots: plots.length, bare: bare.length, black: black.length };
});

test("the first screen: a flight is drawn, a sentence says what it is, and nothing is empty", async (context) => {
    for (const options of [{}, { viewport: { width: 1400, height: 900 }, colorScheme: "dark" }, { viewport: { width: 800, height: 900 } }, { viewport: { width: 400, height: 800 } }]) {
        let page;
        const { workers_ms } = await processor_times(chromium, async () => {
            page = await opened(context, { hash: "", ...options });
            await until(page, /^Finished: 48 h/);
        });
        console.log(`page: the opening flight took ${(workers_ms / (hour_ms * OPENING_HOURS)).toFixed(2)} of Node's time`);
        assert.ok(workers_ms <= MOST_TO_NODE * hour_ms * OPENING_HOURS);
        await page.waitForTimeout(500);
        assert.match(await answer(page), /^After 48 h the INS is \d+\.?\d* km from the true position\.$/);
        assert.match(await page.locator(".lead").innerText(), /position error .* patrol of 48 hours/);
        assert.deepEqual(await empty(page), { plots: 4, bare: 0, black: 0 });
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0);
        await page.screenshot({ path: `${out}/first_${options.viewport?.width ?? 1360}.png` });
        await page.context().close();
    }
});

test("the first flight is that of sins fly, it is not in the address, and its sentence goes with it", async (context) => {
    const page = await opened(context, { hash: "" });
    await until(page, /^Finished/);
    assert.match(await same_as_program(page, "opening"), /^rate_hz = 1 /m);
    await page.waitForTimeout(700);
    assert.equal(new URL(page.url()).hash, "");
    await page.reload();
    await page.waitForSelector("body[data-ready]");
    await until(page, /^Finished: 48 h/);
    await page.selectOption("#language", "zh");
    assert.match(await page.locator(".lead").innerText(), /48 小时/);
    assert.match(await answer(page), /^48 h 后/);
    await page.selectOption("#language", "en");
    await set(page, "flight.hours", "0.5");
    assert.equal(await page.locator(".lead").isVisible(), false);
    await page.waitForFunction(() => location.hash.startsWith("#scene="));
});

test("a scene that is not flown has no empty drawing, but says what to do", async (context) => {
    for (const hash of ["#rest", "#simulation2"]) {
        const page = await opened(context, { hash });
        await page.waitForFunction(() => document.querySelector(".beside .uplot")); // the path of the flight
        assert.equal(await state(page), "Ready");
        assert.equal(await answer(page), "");
        assert.equal(await page.locator(".plots").innerText(), "The curves of the flight appear here: press Start.");
        assert.deepEqual(await empty(page), { plots: 1, bare: 0, black: 0 });
        await page.click("[data-do=picture]");
        assert.match(await state(page), /Nothing was flown/);
        await set(page, "flight.hours", "0.1");
        await fly(page);
        assert.deepEqual(await empty(page), { plots: 4, bare: 0, black: 0 });
    }
});
