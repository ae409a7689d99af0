// Pages of `sins budget`, `sins curve`, `sins allan`, `sins identify` and `sins live` in Chromium: values at the cursor and saved data against the files
// beside the pages, enlarged parts, keys, the page without its script, and what stands above the curves and at the foot of every page.
//
//     SINS=target/release/sins node --test tests/web/studies.mjs      see tests/web.sh

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { createSocket } from "node:dgram";
import { once } from "node:events";
import { readFileSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import test, { after, before } from "node:test";

import { KEPT_WITH_WORKERS } from "./browser.mjs";
import { opened, out, point, policy_of, rows_of, saved, sins, start, stop, table, text_of } from "./drawings.mjs";

const FLIGHTS = resolve("c_examples/flights"), LIVE_S = 60;
/** What `sins identify` printed. */
let identified;
const PAGES = ["budget/budget", "curve/curve", "allan", "identify", "live/live", "warned", "warned_ensemble"];

before(async () => {
    const quiet = ["--quiet", "--force", "--out", out];
    const log = `${FLIGHTS}/airliner_cruise.csv`, [head, ...lines] = readFileSync(log, "utf8").trim().split("\n").filter((line) => !line.startsWith("#"));
    // Two seconds are missing.
    writeFileSync(`${out}/gap.csv`, [head, ...lines.slice(0, 5000), ...lines.slice(5100)].join("\n"));
    const failure = '[[failure]]\nsensor = "gyro"\naxis = "z"\nkind = "dead"\nfrom_s = 20\nuntil_s = 30\n', update = '[[update]]\nkind = "position"\nat_s = 40\nsigma_m = 3\n';
    writeFileSync(`${out}/warned.toml`, `[flight]\nfile = "gap.csv"\n[gyro]\npreset = "navigation"\n[accelerometer]\npreset = "navigation"\n${failure}${update}`);
    sins("fly", "warned.toml", ...quiet);
    sins("report", "warned.csv", "-o", "warned.html", "--force");
    sins("ensemble", "warned.toml", "--runs", "8", ...quiet);
    sins("budget", "simulation2", "warned.toml", "--hours", "0.1", "--position", "2", "--force", "--out", "budget");
    sins("curve", "--quick", "--flight", "cruise", "warned.toml", "--force", "--out", "curve");
    sins("fly", "simulation2", "--set", "flight.builtin=rest", "--set", "flight.hours=0.2", "--name", "rest", "--imu", "imu.csv", ...quiet);
    sins("allan", "imu.csv", "-o", "allan.html", "--csv", "points.csv", "--force");
    const truth = ["aerobatics", "--set", "flight.hours=0.11", "--set", "flight.rate_hz=25"];
    sins("fly", ...truth, "--preset", "tactical", "--set", "options.subsamples=1", "--name", "sensed", "--imu", "sensed_imu.csv", ...quiet);
    identified = JSON.parse(sins("identify", ...truth, "--imu", "sensed_imu.csv", "--prior", "tactical", "--check", "--twins", "40", "--page", "identify.html", "--json", "--force"));
    await live(lines);
    await start();
});
after(stop);

/** Flies lines of a log as packets, each after the answer to the one before. */
async function live(lines) {
    const socket = createSocket("udp4");
    socket.bind(0, "127.0.0.1");
    await once(socket, "listening");
    const to = `udp:127.0.0.1:${socket.address().port}`, order = ["live", "--from", "udp:0", "--to", to, "--format", "generic", "--seconds", String(LIVE_S)];
    const program = spawn(process.env.SINS, [...order, "--preset", "tactical", "--name", "live", "--force", "--out", "live"], { cwd: out });
    const ended = once(program, "exit"), [said] = await once(program.stdout, "data"), port = Number(/udp:127\.0\.0\.1:(\d+)/.exec(said)[1]);
    program.stderr.resume();
    program.stdout.resume();
    let has_ended = false;
    ended.then(() => (has_ended = true));
    // The first packets have no answer yet.
    const answered = () => new Promise((done) => {
        const timer = setTimeout(done, 100);
        socket.once("message", () => (clearTimeout(timer), done()));
    });
    for (const line of lines) {
        if (has_ended) break;
        // Angles of the packets are in degrees.
        const values = line.split(",").map((value, k) => ([1, 2, 7, 8, 9].includes(k) ? (value * 180) / Math.PI : value));
        socket.send(values.join(","), port, "127.0.0.1");
        await answered();
    }
    socket.close();
    assert.deepEqual(await ended, [0, null]);
}

const near = (value, wanted, share, words) => assert.ok(Math.abs(value - wanted) <= share * Math.abs(wanted), `${words ?? ""}: ${value}, not ${wanted}`);
const SI = { nm: 1e-9, "µm": 1e-6, mm: 1e-3, m: 1, km: 1e3, "µm/s": 1e-6, "mm/s": 1e-3, "m/s": 1, nrad: 1e-9, "µrad": 1e-6, arcsec: Math.PI / 648000, "°": Math.PI / 180 };
const number = (text) => Number(text.replace(/×10([⁻⁰¹²³⁴-⁹]+)/, (_, power) => `e${[...power].map((sign) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(sign)).map((k) => (k ? k - 1 : "-")).join("")}`));
/** A value with its unit, in SI units. */
const si = (words) => {
    const [, value, unit] = /([\d.]+(?:×10\S+)?) (\S+)$/.exec(words);
    assert.ok(SI[unit], words);
    return number(value) * SI[unit];
};

test("budget: the cursor goes from bar to bar, by pointer and keys, and shows the value of each effect", async (context) => {
    const page = await opened(context, "budget/budget"), rows = table("budget/budget.csv").filter((row) => row.scene === "simulation2");
    for (const [k, column] of ["position_m", "velocity_m_s", "attitude_rad"].entries()) {
        const own = page.locator('[data-run="simulation2"] .panel').nth(k), hit = own.locator(".hit");
        const check = async (row) => {
            const words = await text_of(own), [, shown] = / ▪ (.*)$/.exec(words);
            assert.ok(shown.startsWith(row.effect), `${row.effect}: ${words}`);
            near(si(shown), Number(row[column]), 0.051, words); // two digits
        };
        for (const [at, row] of rows.entries()) {
            await point(page, own, 0.9, (at + 0.5) / rows.length);
            await check(row);
        }
        await page.mouse.move(1, 1);
        assert.doesNotMatch(await text_of(own), /▪/);
        await hit.focus();
        await page.keyboard.press("Shift+ArrowRight");
        await check(rows.at(-1));
        for (const row of [rows.at(-2), rows.at(-3)]) {
            await page.keyboard.press("ArrowLeft");
            await check(row);
            assert.equal(await page.locator(".said").textContent(), await text_of(own));
        }
    }
});

test("budget: bars are as long as their errors, no effect exceeds the root sum of squares, and the saved data are those of the file", async (context) => {
    const page = await opened(context, "budget/budget"), rows = table("budget/budget.csv").filter((row) => row.scene === "simulation2");
    const own = page.locator('[data-run="simulation2"] figure').first();
    const lengths = await own.locator(".inner path:has(title)").evaluateAll((bars) => bars.map((bar) => bar.getBBox().width));
    const errors = rows.map((row) => Number(row.position_m)), most = Math.max(...lengths);
    lengths.forEach((length, k) => assert.ok(Math.abs(length / most - errors[k] / Math.max(...errors)) < 1e-3, `${rows[k].effect}: ${length}`));
    const sum = Number(rows.find((row) => row.effect === "root sum of squares").position_m), effects = rows.filter((row) => row.key);
    near(sum, Math.hypot(...effects.map((row) => Number(row.position_m))), 1e-6);
    assert.equal(rows.at(-1).effect, "all together");
    assert.equal(rows.at(-2).effect, "root sum of squares");
    const data = await rows_of(page, own);
    assert.equal(data.length, rows.length);
    const unit = SI[/\[(.*)\]/.exec(data[0][0])[1]];
    data.forEach(([, words, , value, name], k) => {
        assert.ok(words.startsWith(rows[k].effect) && name.replaceAll("\u00a0", " ") === rows[k].effect, words);
        near(Number(value) * unit, errors[k], 1e-5, words);
    });
    const [name, svg] = await saved(page, own, "svg");
    assert.ok(name.endsWith(".svg") && svg.includes("gyro bias") && svg.includes("deterministic"), name);
});

test("curve: the cursor goes from point to point, and each has its scheme, rate, error and cost", async (context) => {
    const page = await opened(context, "curve/curve"), rows = table("curve/curve.csv").filter((row) => row.scene === "cruise" && row.position_m);
    const own = page.locator(".panel").first(), figure = page.locator("figure").first();
    const name = (row) => [row.scheme, row.subsamples, row.updates_per_sample > 1 ? `× ${row.updates_per_sample}` : "", row.frame === "earth" ? "" : row.frame].filter(Boolean).join(" ");
    const check = (words, row) => {
        const [, who, error, cost] = /▪ (.*): (.*), (\S+) µs a second/.exec(words);
        assert.equal(who, `${name(row)} @ ${row.rate_hz} Hz`);
        near(si(error), Number(row.position_m), 0.051, words);
        near(Number(cost), Number(row.cost_ns_per_s) / 1000, 0.051, words);
    };
    // The pointer takes the nearest point: that of the paper's scheme in Earth-fixed axes stands alone.
    for (const rate of [10, 100]) {
        const row = rows.find((row) => row.scheme === "exact" && row.subsamples === "1" && row.frame === "earth" && Number(row.rate_hz) === rate);
        const dot = own.locator("circle", { has: page.locator(`title:text("exact 1 @ ${rate} Hz")`) }).first();
        await own.locator(".hit").scrollIntoViewIfNeeded();
        const box = await dot.boundingBox();
        await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
        check(await text_of(own), row);
    }
    await page.mouse.move(1, 1);
    const first = await opened(context, "curve/curve"), hit = first.locator(".hit").first();
    await hit.focus();
    for (const row of rows.slice(0, 8)) {
        await first.keyboard.press("ArrowRight");
        check(await text_of(first.locator(".panel").first()), row);
    }
    const data = (await rows_of(page, figure)).filter(([, words]) => words?.includes(" @ "));
    assert.equal(data.length, rows.length);
    data.forEach(([, words, , position_m, cost_us], k) => {
        assert.ok(words.startsWith(`${name(rows[k])} @ `), words);
        near(Number(position_m), Number(rows[k].position_m), 1e-4, words);
        near(Number(cost_us) * 1000, Number(rows[k].cost_ns_per_s), 0.5 / Number(rows[k].cost_ns_per_s) + 1e-5, words);
    });
});

test("allan: averaging time and deviation at the cursor, and in the saved data, are those of the points", async (context) => {
    const page = await opened(context, "allan"), all = table("points.csv"), column = all[0].column;
    const points = all.filter((row) => row.column === column).map((row) => [Number(row.averaging_time_s), Number(row.deviation)]);
    const own = page.locator(".panel").first(), figure = page.locator("figure").first();
    const unit = Math.PI / 648000; // deviations of angular rates in degrees an hour
    const check = async () => {
        const words = await text_of(own), [, tau, deviation] = /([\d.e-]+) s.* ▪ ([\d.e-]+)$/.exec(words).map(Number);
        const k = points.findIndex(([tau_s]) => tau_s >= tau), [[a, low], [b, high]] = [points[Math.max(0, k - 1)], points[k]];
        const share = a === b ? 0 : Math.log(tau / a) / Math.log(b / a);
        near(deviation * unit, low * (high / low) ** share, 0.005, words); // two pixels of the time are 2 % of it, which are cut to four digits
        return tau;
    };
    for (const share of [0.1, 0.5, 0.9]) {
        await point(page, own, share);
        const wanted = Math.exp(Math.log(points[0][0]) + share * Math.log(points.at(-1)[0] / points[0][0]));
        near(await check(), wanted, 0.03);
    }
    await own.locator(".hit").focus();
    await page.keyboard.press("Shift+ArrowLeft");
    await check();
    const line = (await rows_of(page, figure)).filter(([, name]) => name === "deviation");
    assert.equal(line.length, points.length);
    line.forEach(([, , , tau, deviation], k) => {
        near(tau, points[k][0], 1e-3);
        near(deviation * unit, points[k][1], 1e-3);
    });
});

test("identify: drifts and parameters at the cursor are those of the file", async (context) => {
    const page = await opened(context, "identify"), [drift, gyro] = [0, 1].map((k) => page.locator(".panel").nth(k));
    const { spans } = identified.check;
    assert.ok(spans.length >= 3);
    await drift.locator(".hit").focus();
    const dots = (await rows_of(page, page.locator("figure", { has: drift }))).filter(([, name]) => /^after /.test(name));
    assert.equal(dots.length, spans.length);
    spans.forEach((span, k) => near(Number(/: ([\d.]+) m, predicted/.exec(dots[k][1])[1]), span.real_m, 1e-3, dots[k][1]));
    // The first of 12 parameters.
    await point(page, gyro, 0.5, 0.5 / 12);
    const [, bias_deg_h] = /bias x: (-?[\d.]+) ± [\d.]+ °\/h/.exec(await text_of(gyro)) ?? assert.fail(await text_of(gyro));
    assert.ok(Math.abs(bias_deg_h - (identified.gyro["bias x"].value * 648000) / Math.PI) < 0.01, bias_deg_h);
});

test("live: the cursor shows the values of the records", async (context) => {
    const page = await opened(context, "live/live"), all = table("live/live.csv");
    const own = page.locator(".panel", { has: page.locator('.caption:text("position east")') }).first();
    const check = async (share) => {
        const words = await text_of(own), [, time_s] = /(-?[\d.]+) s /.exec(words), unit = SI[/\[(.*)\]/.exec(words)[1]];
        if (share) near(Number(time_s), share * LIVE_S, 0.02, words);
        const near_by = all.filter((row) => Math.abs(row.time_s - all[0].time_s - time_s) < 1.1).map((row) => Number(row.navigation_error_position_east_m));
        const most = Math.max(...all.map((row) => Math.abs(row.navigation_error_position_east_m)));
        for (const [, value] of words.matchAll(/▪ (-?[\d.]+)/g)) {
            assert.ok(value * unit >= Math.min(...near_by) - 0.004 * most && value * unit <= Math.max(...near_by) + 0.004 * most, words);
        }
        assert.match(words, /▪/);
    };
    for (const share of [0.2, 0.8]) {
        await point(page, own, share);
        await check(share);
    }
    await own.locator(".hit").focus();
    await page.keyboard.press("ArrowLeft");
    await check();
    const rows = await rows_of(page, page.locator("figure", { has: own }));
    assert.ok(rows.filter(([caption]) => caption.startsWith("position east")).length > 20);
});

test("drag enlarges a part, double-click and keys go back", async (context) => {
    for (const name of ["budget/budget", "curve/curve", "allan", "identify", "live/live"]) {
        const page = await opened(context, name), own = page.locator(".panel").first(), before = await own.locator("> .x-ticks").count();
        const is_part = () => own.evaluate((panel) => panel.classList.contains("part"));
        await point(page, own, 0.2, 0.3);
        await page.mouse.down();
        await point(page, own, 0.5, 0.6);
        await page.mouse.up();
        assert.ok(await is_part(), name);
        assert.ok((await own.locator(".now text").count()) > 1, `${name}: ticks of its own`);
        await own.locator(".hit").dblclick();
        assert.ok(!(await is_part()), name);
        for (const [key, wanted] of [["+", true], ["Escape", false], ["+", true], ["-", true], ["-", false]]) {
            await page.keyboard.press(key);
            if (key !== "-") assert.equal(await is_part(), wanted, `${name} ${key}`);
        }
        await page.keyboard.press("Escape");
        assert.ok(!(await is_part()) && (await own.locator("> .x-ticks").count()) === before, name);
    }
});

test("without script all figures are there; every page fits 400 pixels, dark, and prints", async (context) => {
    for (const name of PAGES) {
        const bare = await opened(context, name, { javaScriptEnabled: false }), with_script = await opened(context, name);
        const shown = (page) => page.locator(".inner path:visible, .inner circle:visible").count();
        assert.equal(await bare.locator(".plot:visible").count(), await with_script.locator(".plot:visible").count(), name);
        assert.equal(await shown(bare), await shown(with_script), name);
        for (const what of [".hit", ".save", ".said"]) assert.equal(await bare.locator(what).count(), 0);
        assert.equal(await bare.locator(".help").isVisible(), false);
        const page = await opened(context, name, { colorScheme: "dark", viewport: { width: 400, height: 800 } });
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0, name);
        for (const own of await page.locator(".panel:visible").all()) {
            await page.mouse.move(1, 1);
            const before = await text_of(own);
            await point(page, own, 0.4);
            assert.notEqual(await text_of(own), before, `${name}: ${before}`);
        }
        await page.screenshot({ path: `${out}/${name.replace("/", "_")}_dark.png`, fullPage: true });
        await page.emulateMedia({ media: "print" });
        for (const what of [".save", ".help"]) assert.equal(await page.locator(what).first().isVisible(), false);
    }
});

test("what a reader must know stands in words above the curves, and at the foot when, how, by what and where a page was written", async (context) => {
    const wanted = {
        warned: ["1 gap in the truth", "Failures: gyro z dead", "Updates by fixes: position 40 s"],
        warned_ensemble: ["Failures: gyro z dead", "Updates by fixes: position 40 s"],
        "budget/budget": ["Gaps in the flight data: 1, of 2.02 s", "Flown without its failures", "Flown without its updates"],
        "curve/curve": ["warned: Gaps in the flight data: 1, of 2.02 s", "Flown without its updates"],
        "live/live": [],
        allan: [],
        identify: [],
    };
    for (const name of PAGES) {
        const page = await opened(context, name);
        for (const words of wanted[name]) {
            const remark = page.locator(".remark", { hasText: words }).first();
            assert.ok(await remark.isVisible(), `${name}: ${words}`);
            const below = await remark.evaluate((own) => [...document.querySelectorAll("figure")].some((figure) => own.compareDocumentPosition(figure) & Node.DOCUMENT_POSITION_FOLLOWING));
            assert.ok(below, `${name}: ${words}`);
        }
        if (name === "warned_ensemble") {
            // The picture is in the first screen, so the notes on the log stand below, and a link to them above.
            assert.ok(await page.locator(".intro a", { hasText: "Notes on the flight data" }).isVisible(), name);
            assert.ok(await page.locator("#notes ~ .remark", { hasText: "Gaps in the flight data: 1, of 2.02 s" }).isVisible(), name);
        }
        const foot = await page.locator("footer").innerText();
        const order = name.split("/")[0].replace("warned_", "").replace("warned", "report");
        assert.match(foot, new RegExp(`Written on \\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d UTC by sins \\d+\\.\\d+\\.\\d+: sins ${order} [^]*thread`), name);
    }
});

test("these pages too run their own script and nothing else, and load nothing", async () => {
    for (const name of PAGES) assert.deepEqual(await policy_of(name), KEPT_WITH_WORKERS, name);
});
