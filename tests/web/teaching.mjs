// The page as somebody meets it who knows nothing of it: the first screen and the lessons.
//
//     SINS=target/release/sins node --test tests/web/teaching.mjs      see tests/web.sh

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import test, { after, before } from "node:test";
import { deflateRawSync } from "node:zlib";

import { lessons_of } from "../../apps/page/pack/lessons_of.mjs";
import { processor_times } from "./browser.mjs";
import { downloaded, fly, opened, out, press, same_as_program, set, start, state, stop, until } from "./user.mjs";

/** Samples of the opening flight in those of the hour that Node flies. */
const OPENING_HOURS = (48 * 3600) / 360000;
/** Most time of the workers, from their start on, in that of Node for as many samples. */
const MOST_TO_NODE = 4;
/** Most time of the worker and of a task of the page for a move of a slider, in that of a flown hour at 100 Hz in Node. */
const MOST_OF_SLIDER = 1 / 3;
const { SINS } = process.env;
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
    const plots = [...document.querySelectorAll(".uplot")].filter(is_shown), curve_inks = ["0,70,160", "142,197,255", "242,154,74", "184,106,28", "192,57,43", "255,138,128"];
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

const FOLDER = "apps/page/lessons", LESSONS = lessons_of(FOLDER);

test("a lesson says what a step takes here, and one with ideal sensors, of the scene that is shown", async (context) => {
    const page = await opened(context, { hash: "#lesson=effects" }), sentence = page.locator("[data-times]");
    const said = async () => {
        await page.waitForFunction(() => /ideal sensors/.test(document.querySelector("[data-times]").textContent));
        return /^A step takes ([0-9.]+) µs here, and ([0-9.]+) µs with ideal sensors\.$/.exec(await sentence.textContent()).slice(1).map(Number);
    };
    assert.ok((await said()).every((own) => own > 0));
    await page.evaluate(() => (document.querySelector("[data-times]").textContent = ""));
    for (const place of [3, 1, 2]) await page.locator('[data-slides="gyro.bias_deg_h"]').fill(String(place)); // measured once more, of the last one
    assert.ok((await said()).every((own) => own > 0));
    await page.selectOption("#language", "zh");
    await page.waitForFunction(() => /理想传感器/.test(document.querySelector("[data-times]").textContent));
    await page.goto(`${page.url().split("#")[0]}#lesson=gyros`);
    await page.waitForFunction(() => document.querySelector(".lesson h2") && !document.querySelector("[data-times]"));
});

test("each lesson opens by its link: title, question, picture, and the records of sins fly for its scene", async (context) => {
    assert.deepEqual(LESSONS.map(({ order }) => order), LESSONS.map((_, k) => k + 1));
    const page = await opened(context, { hash: "" });
    await until(page, /^Finished/);
    await page.evaluate(() => {
        const own = CanvasRenderingContext2D.prototype, { fillText } = own;
        own.fillText = function (text, x, y, ...others) {
            if (this.canvas.closest(".cost")) window.written.push([text, Math.round(x), Math.round(y)]);
            return fillText.call(this, text, x, y, ...others);
        };
    });
    for (const { name, shows, en, zh } of LESSONS) {
        await page.evaluate(() => (window.written = []));
        await page.getByRole("link", { name: en.title, exact: true }).click();
        await page.waitForFunction((title) => document.querySelector(".lesson h2")?.textContent === title, en.title);
        await until(page, /^Finished/);
        assert.equal(new URL(page.url()).hash, `#lesson=${name}`);
        assert.deepEqual(await page.locator("nav [aria-current]").allInnerTexts(), [en.title]);
        assert.deepEqual(await page.locator(".lesson p").allInnerTexts(), [en.question, ...en.paragraphs]);
        assert.equal(await page.locator(".lead").isVisible(), false);
        await page.waitForTimeout(500);
        if (shows === "cost") {
            await page.waitForFunction(() => document.getElementById("cost_said").value.includes("µs"));
            const numbers = (await page.evaluate(() => window.written)).filter(([own]) => /^10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+$/.test(own));
            const most = (axis) => Math.max(...numbers.map((own) => new Set(numbers.filter((other) => other[axis] === own[axis]).map(([text]) => text)).size));
            assert.ok(most(2) >= 2 && most(1) >= 2, JSON.stringify(numbers)); // of each axis: beside each other, above each other
        }
        const drawings = await empty(page);
        assert.deepEqual([drawings.bare, drawings.black], [0, 0]);
        writeFileSync(`${out}/flown/lesson_${name}.csv`, await downloaded(page, "records"));
        execFileSync(SINS, ["fly", `${FOLDER}/${name}/scene.toml`, "--name", name, "--out", `${out}/flown/expected`, "--quiet", "--force"]);
        assert.ok(readFileSync(`${out}/flown/lesson_${name}.csv`).equals(readFileSync(`${out}/flown/expected/${name}.csv`)), name);
        await page.selectOption("#language", "zh");
        assert.deepEqual(await page.locator(".lesson p").allInnerTexts(), [zh.question, ...zh.paragraphs]);
        assert.doesNotMatch([zh.question, ...zh.paragraphs].join(""), /[\u3000-\u9fff\uff00-\uffef] [\u4e00-\u9fff]/);
        await page.waitForTimeout(200);
        assert.deepEqual(await empty(page), drawings);
        await page.selectOption("#language", "en");
        await page.waitForTimeout(200);
        await page.screenshot({ path: `${out}/lesson_${name}.png` });
    }
    await page.goBack();
    await page.waitForFunction((title) => document.querySelector(".lesson h2")?.textContent === title, LESSONS.at(-2).en.title);
});

test("a lesson whose scene is changed stays in the address; another scene leaves it", async (context) => {
    const page = await opened(context, { hash: "#lesson=schuler" });
    await until(page, /^Finished: 24 h/);
    await set(page, "flight.hours", "12");
    await page.waitForFunction(() => location.hash.startsWith("#lesson=schuler&scene="));
    await page.reload();
    await page.waitForSelector("body[data-ready]");
    await until(page, /^Finished: 12 h/);
    assert.equal(await page.locator(".lesson h2").innerText(), "Why 84 minutes?");
    assert.equal(await page.locator("[data-do=open_builtin]").isDisabled(), true); // the list shows the lesson's scene
    await page.selectOption('[data-path="scene"]', "rest");
    await page.click("[data-do=open_builtin]");
    assert.equal(await page.locator(".lesson").count(), 0);
    await page.waitForFunction(() => location.hash.startsWith("#scene="));
    const none = await opened(context, { hash: "#lesson=nothing" });
    assert.match(await state(none), /no scene that can be read/);
    const narrow = await opened(context, { hash: "#lesson=schuler", viewport: { width: 400, height: 800 }, colorScheme: "dark" });
    await until(narrow, /^Finished/);
    assert.equal(await narrow.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0);
    const tops = await narrow.evaluate(() => [".question", ".display", ".words", "aside", "footer"].map((own) => document.querySelector(own).getBoundingClientRect().top));
    assert.deepEqual(tops, tops.toSorted((a, b) => a - b));
    // A slider and its curves are on the screen together.
    const [slider, curves] = await narrow.evaluate(() => [".slider", ".plots .uplot"].map((own) => document.querySelector(own).getBoundingClientRect()));
    assert.ok(curves.bottom - slider.top < 800, `${curves.bottom - slider.top} pixels`);
});

test("a lesson flies at once and is drawn whole, whatever was flown before", async (context) => {
    const page = await opened(context, { hash: "" }), range = () => page.evaluate(() => document.querySelector(".plots .u-over").getBoundingClientRect());
    await until(page, /^Finished: 48 h/);
    // A part of the first flight is enlarged, and the same flight is paused at its first seconds.
    const { x, y, width, height } = await range();
    await page.mouse.move(x + 0.1 * width, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + 0.2 * width, y + height / 2, { steps: 5 });
    await page.mouse.up();
    await page.selectOption("#pace", "1");
    await press(page, "start");
    await until(page, /^Flying/);
    await press(page, "pause");
    await until(page, /^Paused/);
    for (const { en } of LESSONS) {
        await page.getByRole("link", { name: en.title, exact: true }).click();
        await page.waitForFunction((title) => document.querySelector(".lesson h2")?.textContent === title, en.title);
        await until(page, /^Finished/);
        assert.equal(await page.locator("#pace").inputValue(), "0");
        await page.waitForTimeout(500);
        // The first of three panels shows the time at its cursor: that at the right edge is the end of the flight.
        await page.locator(".plots").scrollIntoViewIfNeeded();
        const last = await range();
        await page.mouse.move(last.x + last.width - 1, last.y + last.height / 2);
        const [shown_s, flown_s] = await page.evaluate(() => [".plots .uplot:last-child .u-series:first-child .u-value", "#state"].map((own) => {
            const [, value, unit] = /([\d.]+) (s|min|h)\b(?:\.|$)/.exec((document.querySelector(own).value ?? document.querySelector(own).textContent).trim());
            return value * { s: 1, min: 60, h: 3600 }[unit];
        }));
        assert.ok(Math.abs(shown_s - flown_s) <= 0.01 * flown_s, `${shown_s} s of ${flown_s} s`);
    }
});

test("of two addresses that are opened one after the other, the last remains", async (context) => {
    const long = `#scene=${deflateRawSync(`[flight]\nbuiltin = "rest"\n${"# a comment\n".repeat(80000)}`).toString("base64url")}`;
    const page = await opened(context, { hash: "#commuter" });
    for (let k = 0; k < 5; k++) {
        await page.evaluate(([first, last]) => new Promise((done) => {
            addEventListener("hashchange", () => {
                location.hash = last;
                setTimeout(done, 1000);
            }, { once: true });
            location.hash = first;
        }), [long, `#lesson=${LESSONS[0].name}`]);
        assert.equal(await page.locator(".lesson h2").innerText(), LESSONS[0].en.title);
        await page.evaluate(() => (location.hash = "#commuter"));
        await page.waitForFunction(() => document.querySelector(".lesson") === null);
    }
});

test("a click on a point of the diagram flies the scene with its algorithm, and the points stay", async (context) => {
    const page = await opened(context, { hash: "#lesson=cost" });
    await page.evaluate(() => {
        const own = CanvasRenderingContext2D.prototype, { arc, clearRect } = own;
        own.clearRect = function (...values) {
            if (this.canvas.closest(".cost")) window.points = [];
            return clearRect.apply(this, values);
        };
        own.arc = function (x, y, radius, ...others) {
            if (this.canvas.closest(".cost") && radius === 3 * devicePixelRatio) window.points.push([x / devicePixelRatio, y / devicePixelRatio]);
            return arc.call(this, x, y, radius, ...others);
        };
    });
    await page.waitForFunction(() => window.points?.length === 7);
    await until(page, /^Finished/);
    const canvas = page.locator(".cost canvas"), [x, y] = (await page.evaluate(() => window.points)).sort((a, b) => a[1] - b[1])[0]; // the largest error: 10 Hz
    const click = (right, down) => canvas.evaluate((own, [left, top]) => {
        const { x, y } = own.getBoundingClientRect();
        document.elementFromPoint(x + left, y + top).dispatchEvent(new MouseEvent("click", { clientX: x + left, clientY: y + top, bubbles: true }));
    }, [x + right, y + down]);
    await canvas.scrollIntoViewIfNeeded();
    const rate = () => page.locator('[data-path="flight.rate_hz"]').inputValue();
    await click(40, -40); // beside the points
    assert.equal(await rate(), "");
    await click(5, -5);
    assert.equal(await rate(), "10");
    await until(page, /^Finished/);
    assert.match(await same_as_program(page, "clicked"), /^rate_hz = 10 /m);
    assert.match(await page.locator("#cost_said").innerText(), /^exact, 2 subsamples, 10 Hz: 0\.\d+ m within 360 s/);
    await page.locator("#cost_subsamples").fill("3");
    await page.locator("#cost_subsamples").dispatchEvent("change");
    await page.waitForFunction(() => window.points.length === 14);
});

test("a slider of a lesson flies each of its values at once, and the last one of a drag remains", async (context) => {
    for (const { name, slider } of LESSONS.filter((own) => own.slider.length > 0)) {
        const page = await opened(context, { hash: `#lesson=${name}` });
        await until(page, /^Finished/);
        const move = (key, place) => page.evaluate(([own, wanted]) => {
            const input = document.querySelector(`[data-slides="${own}"]`);
            input.value = wanted;
            input.dispatchEvent(new Event("input"));
            return input.parentElement.querySelector("output").value;
        }, [key, place]);
        assert.match(await page.locator(".lesson .hint").first().innerText(), /with a sample each [\d.]+ s\.$/);
        const curves = () => page.locator(".plots .uplot").evaluateAll((all) => all.map((own) => own.getAttribute("aria-label")).join());
        let moves = 0;
        const fly_all = async () => {
            for (const { key, values } of slider) {
                const found = new Set();
                for (const [place, value] of values.entries()) {
                    const said = await move(key, place);
                    assert.ok(typeof value === "string" ? said !== "" : Math.abs(Number.parseFloat(said) - value) <= 1e-6 * Math.abs(value), `${key} = ${value}: ${said}`);
                    await until(page, /^(Finished|Ended by an error)/); // geographic axes end at the pole
                    found.add(await curves());
                    moves++;
                }
                assert.equal(found.size, values.length, `${name}: ${key}: ${[...found].join("\n")}`); // each value has curves of its own
            }
        };
        await fly_all(); // browsers optimise what has run for some time
        moves = 0;
        const { longest_ms, workers_ms } = await processor_times(chromium, fly_all), each_ms = workers_ms / moves;
        console.log(`page: a slider of ${name}: ${each_ms.toFixed(0)} ms of the worker and at most ${longest_ms.toFixed(0)} ms of a task of the page, where Node flies an hour at 100 Hz in ${hour_ms.toFixed(0)} ms`);
        assert.ok(each_ms + longest_ms <= hour_ms * MOST_OF_SLIDER);
        const [{ key, values }] = slider;
        await page.evaluate(([own, count]) => {
            const input = document.querySelector(`[data-slides="${own}"]`);
            for (let k = 0; k < 50; k++) {
                input.value = k % count;
                input.dispatchEvent(new Event("input"));
            }
            input.value = 1;
            input.dispatchEvent(new Event("input"));
        }, [key, values.length]);
        await until(page, /^Finished/);
        assert.equal(await page.locator(`[data-slides="${key}"]`).inputValue(), "1");
        await same_as_program(page, `slider_${name}`);
        await page.waitForTimeout(700);
        assert.match(await state(page), /^Finished: [^,]*$/); // what is drawn is what is set
        assert.ok(new URL(page.url()).hash.startsWith(`#lesson=${name}&scene=`));
    }
});

test("sliders by the keyboard, and a slider follows the form", async (context) => {
    const page = await opened(context, { hash: "#lesson=schuler" });
    await until(page, /^Finished/);
    const tilt = page.getByRole("slider", { name: "Tilt" });
    await tilt.focus();
    await page.keyboard.press("ArrowRight");
    assert.equal(await tilt.getAttribute("aria-valuetext"), "1.5 arcmin");
    await until(page, /^Finished/);
    await page.click("#tab2");
    await set(page, "start.misalignment_arcmin", "0.6, 0, 0");
    assert.deepEqual([await tilt.inputValue(), await tilt.getAttribute("aria-valuetext")], ["1", "0.6 arcmin"]);
});

test("the lesson on coning keeps the curve of two subsamples beside its own, and so does a link to it alone", async (context) => {
    const page = await opened(context, { hash: "#lesson=coning" }), plot = page.locator(".plots .uplot").last();
    const values = async () => (await plot.locator(".u-value").allInnerTexts()).map((own) => Number.parseFloat(own));
    await until(page, /^Finished/);
    assert.deepEqual(await plot.locator(".u-label").allInnerTexts(), ["time", "2, 10 Hz, 5 °", "Drift in theory", "Error data 2"]);
    assert.equal(await page.locator('[data-slides="options.subsamples"]').inputValue(), "0");
    await plot.focus();
    await page.keyboard.press("End");
    const [, two, , one] = await values();
    assert.ok(two > 0 && Math.abs(one / two / 1000 - 1) < 0.2, `${one} ${two}`);
    assert.equal(await page.evaluate(() => location.hash), "#lesson=coning");
    await page.locator('[data-slides="flight.rate_hz"]').fill("3");
    await page.waitForFunction(() => /&scene=/.test(location.hash));
    const own = await opened(context, { hash: await page.evaluate(() => location.hash) });
    await until(own, /^Finished/);
    assert.equal(await own.locator('[data-do="forget"]').isVisible(), false); // as the reader left it
});

test("the lesson on coning draws the drift of theory beside the flown one, where the gyros are read once in a sample interval", async (context) => {
    const page = await opened(context, { hash: "#lesson=coning" }), plot = page.locator(".plots .uplot").last();
    const [labels, values] = [".u-label", ".u-value"].map((own) => () => plot.locator(own).allInnerTexts());
    await until(page, /^Finished/);
    await plot.focus();
    await page.keyboard.press("End"); // of the ramp, in which theory says nothing
    for (let pages = 0; pages < 4; pages++) await page.keyboard.press("PageUp");
    const [, , theory, flown] = await values();
    assert.equal((await labels())[2], "Drift in theory");
    const [of_theory, of_flown] = [theory, flown].map((own) => Number.parseFloat(own));
    assert.ok(of_flown > 2 && Math.abs(of_theory / of_flown - 1) < 0.01 && of_theory !== of_flown, `${theory} ${flown}`);
    await page.screenshot({ path: `${out}/theory.png` });
    await page.locator('[data-slides="options.subsamples"]').fill("1");
    await page.waitForFunction(() => !document.querySelector(".plots").innerText.includes("Drift in theory"));
});

test("the lesson on coning draws the axes of the body: a cone, with half of the roll half as wide, and a plane without roll", async (context) => {
    const page = await opened(context, { hash: "#lesson=coning" }), canvas = page.locator(".axis canvas");
    const told = async () => /up to (\S+)° from the vertical; .* (\S+)° to the right/.exec(await canvas.getAttribute("aria-label")).slice(1).map(Number);
    /** Width and height of the dots: of the pixels of the colour of the true axis that are no part of a line. */
    const dots = () => canvas.evaluate((own) => {
        const { width, height } = own, { data } = own.getContext("2d").getImageData(0, 0, width, height), ink = getComputedStyle(document.documentElement).getPropertyValue("--data1").trim();
        const wanted = [1, 3, 5].map((at) => Number.parseInt(ink.slice(at, at + 2), 16)), found = [];
        for (let y = 0; y < height / 3; y++) for (let x = 0; x < width; x++) if (wanted.every((part, k) => data[4 * (y * width + x) + k] === part)) found.push([x, y]);
        const span = (all) => Math.max(...all) - Math.min(...all);
        return { wide: span(found.map(([x]) => x)), count: found.length };
    });
    await until(page, /^Finished/);
    const whole = await dots(), [angle, turned] = await told();
    assert.ok(Math.abs(angle - 5) < 0.06 && Math.abs(Math.abs(turned) - 3.2) < 0.1, `${angle}, ${turned}`);
    const roll = page.locator('[data-slides="manoeuvre[0].sinusoid[0].amplitude_deg"]');
    await roll.fill("2");
    const shows = (from, to) => page.waitForFunction(([low, high]) => {
        const off = Math.abs(Number(/(\S+)° to the right/.exec(document.querySelector(".axis canvas").getAttribute("aria-label"))[1]));
        return off >= low && off <= high;
    }, [from, to]);
    await shows(1.5, 1.7);
    await page.screenshot({ path: `${out}/axis.png` });
    await roll.fill("0");
    await shows(0, 1e-3);
    const plane = await dots(), [in_plane] = await told();
    assert.ok(Math.abs(in_plane - 5) < 0.06, `${in_plane}`);
    assert.ok(plane.wide < 0.7 * whole.wide && plane.count < whole.count, JSON.stringify([whole, plane]));
    await page.goto(`${page.url().split("#")[0]}#lesson=schuler`);
    await until(page, /^Finished/);
    assert.equal(await canvas.isVisible(), false);
});
