// The page in Chromium, as its users have it: a file. Records of flights are compared with `sins fly`, byte by byte.
//
//     SINS=target/release/sins HOURS=48 node --test tests/web/page.mjs      see tests/web.sh

import assert from "node:assert/strict";
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import test, { after, before } from "node:test";
import { deflateRawSync } from "node:zlib";
import { pathToFileURL } from "node:url";

import { KEPT, kept_from, page_with, processor_times } from "./browser.mjs";
import { address, downloaded, drop, field, fly, opened, out, press, same_as_program, set, start, state, stop, tab, text, unfold, until, write } from "./user.mjs";

const { HOURS = "1", SINS_PAGE = "target/web/sins.html", SINS_MODULE } = process.env;
const MOST_LINES = 3150, MOST_BYTES = 1.6e6;
/** Most time of the page's workers in the time that Node needs for the same flight, and of a task of the page in that of a flown hour. */
const MOST_TO_NODE = 3, MOST_OF_HOUR = 1 / 6;
const [TRAJECTORY, SENSORS, , UNIT, TEXT] = [0, 1, 2, 3, 4];
let chromium, hour_ms;

before(async () => ({ chromium, hour_ms } = await start()));
after(stop);

test("one file of at most 1.6 MB, made of at most 3150 lines", () => {
    const lines = readdirSync("apps/page").filter((name) => /\.(mjs|css|html)$/.test(name)).map((name) => readFileSync(`apps/page/${name}`, "utf8").split("\n").length - 1);
    const all = lines.reduce((sum, own) => sum + own, 0), bytes = statSync(SINS_PAGE).size;
    console.log(`page: ${(bytes / 1e6).toFixed(2)} MB, ${all} lines`);
    assert.ok(bytes <= MOST_BYTES && all <= MOST_LINES);
});

test("the paper's figures 3 to 5: open simulation 2, press Start", async (context) => {
    const page = await opened(context);
    await page.waitForTimeout(700);
    if (HOURS !== "48") await set(page, "flight.hours", HOURS);
    const began_ms = Date.now();
    const { tasks, longest_ms, workers_ms } = await processor_times(chromium, () => fly(page));
    const to_node = workers_ms / (hour_ms * Number(HOURS));
    console.log(`page: ${HOURS} h of simulation 2 in ${((Date.now() - began_ms) / 1000).toFixed(1)} s, ${(workers_ms / 1000).toFixed(1)} s of the processor: ${to_node.toFixed(2)} of Node's time`);
    console.log(`page: the longest of ${tasks} tasks of the page took ${longest_ms.toFixed(1)} ms of the processor, ${(longest_ms / hour_ms).toFixed(3)} of a flown hour`);
    assert.ok(to_node <= MOST_TO_NODE && longest_ms <= MOST_OF_HOUR * hour_ms);
    assert.match(await same_as_program(page, "simulation2"), /error_model = "rk4"/);
    for (const [quantity, axes] of [["2", "misalignment"], ["1", "velocity"], ["0", "position"]]) {
        await page.selectOption("#quantity", quantity);
        const labels = await page.locator(".plots .uplot").evaluateAll((all) => all.map((own) => own.getAttribute("aria-label")));
        assert.equal(labels.length, 3, axes);
        for (const [k, name] of ["East", "North", "Up"].entries()) assert.match(labels[k], new RegExp(`, ${name}: -?[0-9.e-]+ `));
    }
    await page.screenshot({ path: `${out}/light.png`, fullPage: true });
    const picture = await downloaded(page, "picture");
    assert.equal(picture.subarray(1, 4).toString(), "PNG");
    writeFileSync(`${out}/picture.png`, picture);
    assert.ok(picture.length > 10000);
});

test("the map of 48 hours turns where the path turns", async (context) => {
    const page = await opened(context);
    // The lines that are drawn on canvases of the map.
    await page.evaluate(() => {
        const own = CanvasRenderingContext2D.prototype, { beginPath, lineTo } = own;
        own.beginPath = function () {
            if (this.canvas.closest(".plot")) (window.lines = (window.lines ?? []).slice(-100)).push([]);
            return beginPath.call(this);
        };
        own.lineTo = function (x, y) {
            if (this.canvas.closest(".plot")) window.lines.at(-1).push([x, y]);
            return lineTo.call(this, x, y);
        };
    });
    await set(page, "flight.rate_hz", "2");
    await set(page, "flight.hours", "48");
    await fly(page);
    const tracks = (await page.evaluate(() => window.lines)).filter((line) => line.length > 1000).slice(-2);
    assert.equal(tracks.length, 2);
    for (const track of tracks) {
        // Points that are nearer than two pixels do not show a direction.
        const far = [track[0]];
        for (const at of track) if (Math.hypot(at[0] - far.at(-1)[0], at[1] - far.at(-1)[1]) >= 2) far.push(at);
        const directions = far.slice(1).map(([x, y], k) => Math.atan2(y - far[k][1], x - far[k][0]));
        const turns = directions.slice(1).map((angle, k) => Math.abs(Math.atan2(Math.sin(angle - directions[k]), Math.cos(angle - directions[k]))));
        console.log(`map: ${track.length} points, largest turn ${((Math.max(...turns) * 180) / Math.PI).toFixed(0)} deg`);
        assert.ok(Math.max(...turns) < Math.PI / 3, `${Math.max(...turns)}`);
    }
});

test("a bias that is set in the form flies as in sins fly", async (context) => {
    const page = await opened(context, { hash: "#commuter" });
    await set(page, "flight.hours", "0.05");
    await tab(page, SENSORS);
    await unfold(page);
    await page.selectOption(field("gyro.preset"), "tactical");
    await page.locator("details", { has: page.locator(field("gyro.preset")) }).getByRole("button").click();
    await set(page, "gyro.bias_deg_h", "1, -2, 3.5");
    await set(page, "options.covariance", "on");
    await fly(page);
    const scene = await same_as_program(page, "bias");
    assert.match(scene, /^bias_deg_h = \[1, -2, 3.5\]/m);
    assert.match(scene, /^bias_sigma_deg_h = /m);
});

test("every key has a field with a name of at most three words, its meaning, unit and limits", async (context) => {
    const page = await opened(context), { load } = await import(pathToFileURL(resolve(SINS_MODULE)));
    const sins = await load(), key = new sins.scene_key(), found = new Map();
    await write(page, MANOEUVRES);
    for (const place of [0, 1, 2, 3, 4]) {
        await tab(page, place);
        await unfold(page);
        const rows = await page.locator(`#panel${place} .row`).evaluateAll((all) => all.map((row) => [row.querySelector("[data-path]")?.dataset.path, row.innerText, row.title, row.querySelector("label")?.textContent]));
        for (const [path, ...own] of rows) if (path) found.set(path.replace(/\[\d+\]/g, ""), own);
    }
    let missing = [];
    for (let k = 0; k === 0 || k < Number(key.count); k++) {
        sins.scene_get_key(k, key);
        const path = `${key.section}.${key.name}`, is_of_list = (key.flags & sins.SCENE_KEY_IN_LIST) !== 0;
        // A page has neither folders nor a terminal, and does not identify sensors.
        const is_of_program = key.section === "imu" || ["output.folder", "output.name", "output.imu", "output.quiet"].includes(path);
        if (is_of_list || key.name === "preset" || path === "flight.file" || path === "flight.builtin" || is_of_program) {
            assert.ok(!is_of_program || !found.has(path), path);
            continue;
        }
        const [own, title, name] = found.get(path) ?? ["", "", ""];
        const has_limits = (key.flags & sins.SCENE_KEY_LIMITS) === 0 || title.includes(String(Number(key.maximum.toPrecision(6))));
        const is_named = name !== "" && name.split(" ").length <= 3 && `${name}; ${title}`.includes(key.meaning);
        if (!is_named || !has_limits || (key.unit !== "" && !/[a-zµ°√]/.test(own.split("\n").at(-2) ?? own))) missing.push(path);
    }
    assert.deepEqual(missing, []);
    assert.ok(found.size > 150);
    // No two fields of a section have one name.
    const names = [...found].map(([path, [, , name]]) => `${path.split(".").slice(0, -1)}: ${name}`);
    assert.equal(new Set(names).size, names.length);
});

test("what has its default is folded, and what is set is not", async (context) => {
    const page = await opened(context, { hash: "#rest" });
    const open = () => page.locator("aside [role=tabpanel]:visible details").evaluateAll((all) => all.map((own) => own.open));
    await tab(page, SENSORS);
    assert.deepEqual(await open(), [false, false, false, false, false]);
    await write(page, '[flight]\nbuiltin = "rest"\nhours = 0.1\n[accelerometer]\nbias_micro_g = [0, 0, 5]\n[[failure]]\nsensor = "gyro"\naxis = "x"\nkind = "dead"\nfrom_s = 5\n');
    await tab(page, SENSORS);
    assert.deepEqual(await open(), [false, true, false, false, true]);
    // A field that is emptied does not fold below the pointer.
    await page.fill(field("accelerometer.bias_micro_g"), "");
    await page.keyboard.press("Enter");
    await page.waitForTimeout(600);
    assert.doesNotMatch(await page.inputValue("#text"), /bias_micro_g = \[0, 0, 5/);
    assert.deepEqual(await open(), [false, true, false, false, true]);
});

const MANOEUVRES = `[flight]
latitude_deg = 45
speed_m_s = 100
rate_hz = 50
[[manoeuvre]]
kind = "straight"
duration_s = 20
[[manoeuvre]]
kind = "sinusoids"
duration_s = 30
[[manoeuvre.sinusoid]]
channel = "roll"
amplitude_deg = 10
frequency_hz = 0.1
[[failure]]
sensor = "gyro"
axis = "y"
kind = "bias_step"
from_s = 10
size_deg_h = 100
[[update]]
kind = "velocity"
at_s = 15
sigma_m_s = 0.1
`;

test("manoeuvres are added, edited, moved and removed in the form", async (context) => {
    const page = await opened(context);
    await write(page, MANOEUVRES);
    await tab(page, TRAJECTORY);
    const list = page.locator("[data-list=manoeuvre]"), names = () => list.locator("option").allInnerTexts(), button = (name) => page.locator("#panel0").getByRole("button", { name });
    assert.equal((await names()).length, 2);
    await button("Add").click();
    await set(page, "manoeuvre[1].kind", "turn");
    assert.match(await page.locator("#panel0 .items > .fault").innerText(), /manoeuvre\[1\]/); // a turn has no duration, but a bank
    await set(page, "manoeuvre[1].heading_change_deg", "90");
    await set(page, "manoeuvre[1].bank_deg", "30");
    assert.match((await names())[1], /^2 turn: /);
    await set(page, "manoeuvre[1].bank_deg", "89");
    assert.match(await page.locator(".row", { has: page.locator(field("manoeuvre[1].bank_deg")) }).locator(".fault").innerText(), /bank_deg = 89: must be from/);
    await set(page, "manoeuvre[1].bank_deg", "45");
    await button("Move down").click();
    assert.match((await names())[2], /^3 turn: .*45/);
    await list.selectOption("0");
    await button("Remove").click();
    assert.equal((await names()).length, 2);
    await fly(page);
    const scene = await same_as_program(page, "manoeuvres");
    assert.match(scene.replaceAll("\n", " "), /"sinusoids".*"roll".*"turn"/);
    // A built-in flight as manoeuvres that can be edited.
    await page.selectOption("#source", "0");
    await page.selectOption("#builtin", "commuter");
    await page.selectOption("#source", "1");
    assert.ok((await names()).length > 3);
});

test("wrong input is marked at its field, told, and not flown", async (context) => {
    const page = await opened(context), invalid = (path) => page.locator(field(path)).getAttribute("aria-invalid");
    await tab(page, SENSORS);
    await unfold(page);
    await set(page, "gyro.bias_deg_h", "1, 3e8, 2");
    assert.equal(await invalid("gyro.bias_deg_h"), "true");
    const fault = page.locator(".row", { has: page.locator(field("gyro.bias_deg_h")) }).locator(".fault");
    assert.match(await fault.innerText(), /gyro.bias_deg_h\[1\] = 3e8: must be from -2.06264e7 to 2.06264e7/);
    await set(page, "altimeter.bias_m", "3"); // another field is taken, and the fault stays
    assert.equal(await page.inputValue(field("gyro.bias_deg_h")), "1, 3e8, 2");
    await press(page, "start");
    assert.match(await state(page), /not valid/);
    await page.selectOption("#language", "zh");
    await unfold(page);
    assert.match(await fault.first().innerText(), /必须在 -20626500 至 20626500 之间|必须在/);
    await page.selectOption("#language", "en");
    await unfold(page);
    await set(page, "gyro.bias_deg_h", "0.5");
    assert.equal(await invalid("gyro.bias_deg_h"), "false");
    // In the text: the place, the key that was meant, and the field.
    await tab(page, TEXT);
    const before = await text(page);
    await page.fill("#text", '[flight]\nbuiltin = "rest"\n[gyro]\nbais_deg_h = 1\nbias_sigma_deg_h = -1\n');
    await page.waitForSelector("#text_faults li");
    assert.deepEqual(await page.locator("#text_faults li").allInnerTexts(), ["4:1: no such key: bais_deg_h; did you mean bias_deg_h?", "5:1: gyro.bias_sigma_deg_h[0] = -1: must be from 0 to 2.06264e7 °/h"]);
    await page.locator("#text_faults button").nth(1).click();
    assert.equal(await page.evaluate(() => { const own = document.activeElement; return own.value.slice(own.selectionStart, own.selectionEnd); }), "bias_sigma_deg_h = -1");
    await press(page, "start");
    assert.match(await state(page), /not valid/);
    await tab(page, SENSORS);
    await unfold(page);
    assert.equal(await invalid("gyro.bias_sigma_deg_h"), "true");
    await tab(page, TEXT);
    await page.fill("#text", before);
    await page.waitForFunction(() => document.getElementById("text_faults").children.length === 0);
    // Files that are none.
    writeFileSync(`${out}/binary.csv`, Buffer.from([0, 255, 1, 2, 3, 10, 255]));
    await drop(page, `${out}/binary.csv`);
    await until(page, /^binary.csv: /);
    writeFileSync(`${out}/short.csv`, "time_s,latitude_deg\n0,1\n");
    await drop(page, `${out}/short.csv`);
    await until(page, /^short.csv: .*missing columns: /);
});

test("form and text follow each other, and a link is the experiment", async (context) => {
    const page = await opened(context, { hash: "#rest" });
    await tab(page, TEXT);
    assert.match(await text(page), /rest/);
    await tab(page, SENSORS);
    await unfold(page);
    await set(page, "accelerometer.bias_micro_g", "50");
    assert.match(await text(page), /bias_micro_g = 50/);
    await tab(page, TEXT);
    const written = (await text(page)).replace("bias_micro_g = 50", "bias_micro_g = 70") + "# a comment\n";
    await write(page, written);
    assert.equal(await text(page), written); // as it was written
    await tab(page, SENSORS);
    assert.equal(await page.inputValue(field("accelerometer.bias_micro_g")), "70");
    const link = new URL(await page.evaluate(() => location.href)).hash;
    assert.ok(link.startsWith("#scene=") && link.length < 2000, link);
    const other = await opened(context, { hash: link });
    await tab(other, SENSORS);
    assert.equal(await other.inputValue(field("accelerometer.bias_micro_g")), "70");
    await other.reload();
    await other.waitForSelector("body[data-ready]");
    await tab(other, SENSORS);
    assert.equal(await other.inputValue(field("accelerometer.bias_micro_g")), "70");
    const broken = await opened(context, { hash: "#scene=AAAA" });
    assert.match(await state(broken), /no scene/);
});

test("after any address the page works, and says what the address lacks", async (context) => {
    const link = (bytes) => `#scene=${deflateRawSync(bytes).toString("base64url")}`;
    const none = ["#%", "#%E0%A4%A", "#%00", "#rest%", "#nothing", "#__proto__", "#scene=", "#scene=%", "#scene=AAAA", "#=", "##", `#${"x".repeat(100000)}`];
    // Letters that are none, and a text that is longer than the library reads: 30 KB that unpack to 30 MB.
    none.push(link(Buffer.from([255, 254, 253])), link(Buffer.alloc(30e6, "#")));
    const works = async (page, hash) => {
        await press(page, "start");
        await until(page, /^(Flying|Finished)/);
        await page.evaluate(() => document.querySelector('[data-do="stop"]').click()); // nothing happens if the flight has ended
        await until(page, /^(Stopped|Finished)/).catch(() => assert.fail(hash.slice(0, 30)));
    };
    for (const hash of none) {
        const page = await opened(context, { hash });
        assert.match(await state(page), /no scene that can be read/, hash.slice(0, 30));
        await works(page, hash);
        await page.context().close();
    }
    // The same in a page that is open.
    const page = await opened(context, { hash: "#rest" });
    for (const hash of none) {
        await page.evaluate((wanted) => (location.hash = wanted), hash);
        await until(page, /no scene that can be read/);
        await works(page, hash);
    }
    const faulty = await opened(context, { hash: link('[flight]\nbuiltin = "rest"\n[gyro]\nbais_deg_h = 1\n') });
    assert.match(await state(faulty), /no such key: bais_deg_h; did you mean bias_deg_h/);
    await faulty.evaluate(() => (location.hash = "#commuter"));
    await tab(faulty, TEXT);
    await faulty.waitForFunction(() => !document.getElementById("text").value.includes("bais"));
    await works(faulty, "#commuter");
});

test("a log that is dropped on any scene is flown as long as it is", async (context) => {
    const { load } = await import(pathToFileURL(resolve(SINS_MODULE))), sins = await load(), names = [];
    for (let has_more = true; has_more; ) {
        try {
            names.push(sins.scene_builtin_name(names.length));
        } catch {
            has_more = false;
        }
    }
    assert.ok(names.length > 5);
    for (const name of names) {
        const page = await opened(context, { hash: `#${name}` });
        await drop(page, "c_examples/flights/fighter_aerobatics.csv");
        await until(page, /samples, 300 s/);
        await fly(page);
        assert.equal(await page.inputValue(field("flight.hours")), "", name);
        assert.doesNotMatch((await downloaded(page, "save")).toString(), /^(hours|duration_s)/m);
        await page.context().close();
    }
});

test("a fault that only the log shows marks its field, in its unit, until it is mended", async (context) => {
    const page = await opened(context), hours = page.locator(".row", { has: page.locator(field("flight.hours")) });
    await drop(page, "c_examples/flights/fighter_aerobatics.csv");
    await until(page, /samples, 300 s/);
    const sentence = /flight\.hours = 48: must be at most the duration of the log: 0\.0833333 h$/;
    await set(page, "flight.hours", "48");
    await until(page, sentence);
    const is_marked = () => page.locator(field("flight.hours")).getAttribute("aria-invalid");
    assert.match(await hours.locator(".fault").innerText(), sentence);
    assert.deepEqual([await is_marked(), await page.inputValue(field("flight.hours"))], ["true", "48"]);
    await press(page, "start");
    await until(page, sentence);
    await page.selectOption("#language", "zh");
    await page.waitForFunction(() => /0\.0833333 h/.test(document.querySelector('[data-path="flight.hours"]').closest(".row").querySelector(".fault").value));
    assert.match(await hours.locator(".fault").innerText(), /[\u4e00-\u9fff].*0\.0833333 h$/);
    await page.selectOption("#language", "en");
    // A log that is dropped again, as it was changed, keeps the time that the user wants of it.
    await set(page, "flight.hours", "0.05");
    assert.equal(await is_marked(), "false");
    await drop(page, "c_examples/flights/fighter_aerobatics.csv");
    await until(page, /samples, 300 s/);
    assert.equal(await page.inputValue(field("flight.hours")), "0.05");
    await fly(page);
    assert.equal(await is_marked(), "false");
    // A spacing below the time between two samples.
    await set(page, "flight.hours", "");
    await tab(page, TEXT);
    await page.locator(field("output.every_s")).fill("0.001");
    await page.locator(field("output.every_s")).blur();
    await until(page, /output\.every_s = 0\.001: must be at least the sample interval, 0\.01\d* s$/);
    assert.equal(await page.locator(field("output.every_s")).getAttribute("aria-invalid"), "true");
});

test("limits are told in the unit that stands at the field, of every field", async (context) => {
    for (const locale of ["en", "zh"]) {
        const page = await opened(context, { locale });
        await write(page, MANOEUVRES);
        let told = 0;
        for (const place of [0, 1, 2, 3, 4]) {
            await tab(page, place);
            await unfold(page);
            const wrong = await page.evaluate((own) => {
                const found = [];
                for (const path of [...document.querySelectorAll(`#panel${own} .row input[data-path]`)].map((input) => input.dataset.path)) {
                    // An editor of an item is made anew by each change.
                    const row = () => document.querySelector(`#panel${own} [data-path="${path}"]`).closest(".row"), unit = row().querySelector(".unit").textContent;
                    const put = (value) => (row().querySelector("input").value = value, row().querySelector("input").onchange());
                    const before = row().querySelector("input").value;
                    put("1e300");
                    const fault = row().querySelector(".fault").value, is_marked = row().querySelector("input").getAttribute("aria-invalid") === "true";
                    if (unit && fault) found.push([path, unit, fault, is_marked]);
                    put(before);
                }
                return found;
            }, place);
            for (const [path, unit, fault, is_marked] of wrong) {
                if (!/must be (from|at |more|less)|必须/.test(fault)) continue;
                assert.ok(is_marked && new RegExp(`\\d ${unit.replace(/[()]/g, "\\$&")}( |$)`).test(fault), `${path} [${unit}]: ${fault}`);
                told++;
            }
        }
        console.log(`page: ${told} fields tell their limits in their unit (${locale})`);
        assert.ok(told > 80, `${told}`);
    }
});

test("the page runs its own script and its worker, and loads nothing", async () => {
    assert.deepEqual(await kept_from(chromium, address), KEPT);
});

test("Chinese: every text of the page, every key and word", async (context) => {
    const zh = readFileSync("apps/emulator/zh.txt", "utf8"), plain = (own) => own.replaceAll("&", "").replace(/\.\.\.$/, "");
    const names = new Set(zh.split("\n").map((line) => plain(line.split(" = ")[0])));
    const sources = readdirSync("apps/page").filter((name) => name.endsWith(".mjs")).map((name) => readFileSync(`apps/page/${name}`, "utf8")).join("\n");
    const used = [...sources.matchAll(/\b(?:text|parts|button)\("([^"]+)"/g)].map(([, name]) => name);
    assert.ok(used.length > 60);
    assert.deepEqual([...new Set(used.filter((name) => !names.has(plain(name))))], []);
    const page = await opened(context, { locale: "zh-CN" });
    assert.equal(await page.evaluate(() => document.documentElement.lang), "zh-Hans");
    await write(page, MANOEUVRES);
    for (const place of [0, 1, 2, 3]) {
        await tab(page, place);
        await unfold(page);
        const labels = await page.locator(`#panel${place} label, #panel${place} button, #panel${place} summary, #panel${place} h3, #panel${place} option`).allTextContents();
        const symbols = /^[\d\s:.,;/°µ√²a-zA-Z()"-]{0,3}$|^(English|x|y|z|CGCS2000|WGS-84|GRS 80|SINS)$/;
        assert.deepEqual(labels.filter((own) => !/[\u4e00-\u9fff]/.test(own) && !symbols.test(own)), [], `tab ${place}`);
    }
    await fly(page);
    assert.match(await state(page), /^已完成/);
    await page.screenshot({ path: `${out}/chinese.png`, fullPage: true });
});

test("a log of 30 MB is dropped and flown", async (context) => {
    const { load } = await import(pathToFileURL(resolve(SINS_MODULE))), log = `${out}/flown/long.csv`;
    if (!existsSync(log)) writeFileSync(log, long_log(await load()));
    assert.ok(statSync(log).size > 30e6);
    const page = await opened(context), scene = '[flight]\nfile = "long.csv"\nhours = 0.1\n[gyro]\nbias_deg_h = 1\n';
    await write(page, scene);
    await until(page, /long.csv is not here yet/);
    const { longest_ms } = await processor_times(chromium, async () => {
        await drop(page, log);
        await until(page, /^long.csv: \d+ samples/);
        await fly(page);
    });
    console.log(`page: a log of ${(statSync(log).size / 1e6).toFixed(0)} MB: the longest task of the page took ${longest_ms.toFixed(1)} ms of the processor`);
    assert.ok(longest_ms <= MOST_OF_HOUR * hour_ms);
    await same_as_program(page, "long_log");
});

/** A log of the library's own patrol. */
function long_log(sins) {
    const scene = sins.scene_create_builtin("patrol"), flight = sins.scene_create_flight(scene), sample = new sins.flight_sample();
    const columns = ["time_s", "latitude_rad", "longitude_rad", "height_m", "roll_rad", "pitch_rad", "heading_rad"];
    const lines = [[...columns, "velocity_east_m_s", "velocity_north_m_s", "velocity_up_m_s"].join(",")];
    for (let k = 0, size = 0; size < 30.1e6; k++) {
        sins.flight_sample_at(flight, k / 100, sample);
        lines.push([...columns.map((name) => sample[name]), ...sample.velocity_enu_m_s].join(","));
        size += lines.at(-1).length + 1;
    }
    return `${lines.join("\n")}\n`;
}

test("a scene is dropped; its log is asked for by its name", async (context) => {
    const page = await opened(context);
    await drop(page, "c_examples/scenes/fighter.toml");
    await until(page, /fighter_aerobatics.csv is not here yet/);
    await press(page, "start");
    assert.match(await state(page), /is not here yet/);
    await drop(page, "c_examples/flights/fighter_aerobatics.csv");
    await until(page, /samples, 300 s/);
    await fly(page);
});

test("the panel of the unit: what is done in flight is in the scene, which flies the same again", async (context) => {
    const page = await opened(context), panel = (act) => page.click(`.panel [data-act="${act}"]`), shows = (pattern) => page.waitForFunction((source) => new RegExp(source).test(document.querySelector(".unit_state").value), pattern.source, { timeout: 60000 });
    await write(page, '[flight]\nlatitude_deg = 40\nlongitude_deg = 116\nrate_hz = 20\n[[manoeuvre]]\nkind = "rest"\nduration_s = 7200\n[gyro]\npreset = "navigation"\n[accelerometer]\npreset = "navigation"\n[unit]\nstart = "off"\n');
    await page.selectOption("#pace", "100");
    await press(page, "start");
    await until(page, /^Flying/);
    await shows(/^Off/);
    await panel("align");
    await shows(/^(Coarse|Fine) alignment/);
    await page.fill('.panel input >> nth=0', "40x");
    await panel("position");
    await until(page, /40x: expected a number/);
    await page.fill('.panel input >> nth=0', "40");
    await page.fill('.panel input >> nth=1', "116");
    await panel("position");
    await page.selectOption("#pace", "1000");
    await shows(/^Ready/);
    await panel("nav");
    await shows(/^Navigation/);
    await page.selectOption("#pace", "0");
    await until(page, /^Finished: /);
    const scene = await same_as_program(page, "panel");
    assert.deepEqual([...scene.matchAll(/^kind = "(align|position|nav)"/gm)].map(([, kind]) => kind), ["align", "position", "nav"]);
    await tab(page, UNIT);
    assert.equal(await page.locator("[data-list=panel] option").count(), 3);
});

test("a failure that is planned in flight is in the scene", async (context) => {
    const page = await opened(context, { hash: "#racetrack" });
    await set(page, "flight.hours", "0.2");
    await page.selectOption("#pace", "100");
    await tab(page, SENSORS);
    await unfold(page);
    await press(page, "start");
    await page.waitForFunction(() => document.querySelector("progress").value > 0.05);
    await page.locator("#panel1 details", { has: page.locator("[data-list=failure]") }).getByRole("button", { name: "Add" }).click();
    await page.selectOption("#pace", "0");
    await until(page, /^Finished: /);
    assert.match(await same_as_program(page, "failure"), /\[\[failure\]\]/);
    assert.doesNotMatch(await state(page), /changed/);
});

test("start, pause, pace, stop; closing in flight", async (context) => {
    const page = await opened(context), progress = () => page.evaluate(() => document.querySelector("progress").value);
    await page.selectOption("#pace", "1");
    await press(page, "start");
    await until(page, /^Flying/);
    await page.waitForTimeout(1500);
    const real = (await progress()) * 48 * 3600;
    assert.ok(real > 0.3 && real < 60, `${real} s`);
    await page.selectOption("#pace", "0");
    await page.waitForFunction(() => document.querySelector("progress").value > 1e-3);
    await press(page, "pause");
    await until(page, /^Paused/);
    const paused = await progress();
    await page.waitForTimeout(500);
    assert.equal(await progress(), paused);
    await press(page, "start");
    await page.waitForFunction((before) => document.querySelector("progress").value > before, paused);
    await press(page, "stop");
    await until(page, /^Stopped/);
    assert.ok((await downloaded(page, "records")).length > 1000);
    await press(page, "start");
    await until(page, /^Flying/);
    const { longest_ms } = await processor_times(chromium, () => page.close());
    assert.ok(longest_ms <= MOST_OF_HOUR * hour_ms);
    const next = await opened(context); // the browser is as before
    assert.equal(await state(next), "Ready");
});

test("an error in flight is told with its time", async (context) => {
    const page = await opened(context);
    await write(page, '[flight]\nbuiltin = "rest"\nhours = 2\n[accelerometer]\nbias_micro_g = [0, 0, 1e6]\n[options]\nvertical = "free"\n');
    await press(page, "start");
    await until(page, /^Ended by an error: .* 1727.1 s: navigated height_m = .*: must be from -500000 to 2e7$/);
});

test("what accuracy costs: a choice is measured, drawn and put into the scene", async (context) => {
    const page = await opened(context, { hash: "#aerobatics" }), said = () => page.evaluate(() => document.getElementById("cost_said").value);
    const move = async (id, value) => {
        await page.locator(id).fill(value);
        await page.locator(id).dispatchEvent("change");
    };
    const figure = async () => {
        await page.waitForFunction(() => / m within /.test(document.getElementById("cost_said").value), null, { timeout: 60000 });
        const [, error_m, time_us] = /Hz: (\S+) m within .*, (\S+) µs/.exec(await said());
        return [Number(error_m), Number(time_us)];
    };
    await move("#cost_rate", "0");
    const [coarse_m, cheap_us] = await figure();
    await move("#cost_rate", "4");
    await page.waitForFunction(() => /100 Hz: /.test(document.getElementById("cost_said").value), null, { timeout: 60000 });
    const [fine_m, costly_us] = await figure();
    console.log(`page: aerobatics at 10 and 100 Hz: ${coarse_m} and ${fine_m} m, ${cheap_us} and ${costly_us} µs for a simulated second`);
    // Coning terms of the fourth order; ten times as many steps take at least thrice the time.
    assert.ok(fine_m < coarse_m / 1000 && costly_us > 3 * cheap_us);
    await move("#cost_scheme", "2");
    await move("#cost_subsamples", "3");
    await press(page, "adopt");
    await tab(page, SENSORS);
    assert.deepEqual([await page.inputValue(field("options.scheme")), await page.inputValue(field("options.subsamples"))], ["polynomial", "4"]);
    await drop(page, "c_examples/flights/fighter_aerobatics.csv");
    await until(page, /samples/);
    await press(page, "measure");
    assert.match(await said(), /A log has/);
});

test("a keyboard is enough, everything has a name, and 400 pixels are wide enough", async (context) => {
    for (const options of [{}, { colorScheme: "dark", viewport: { width: 400, height: 800 } }]) {
        const page = await opened(context, options);
        await set(page, "flight.hours", "0.1");
        await page.focus("[data-do=start]");
        await page.keyboard.press("Enter");
        await until(page, /^Finished/);
        await page.focus("#tab0");
        for (const place of [0, 1, 2, 3, 4]) {
            assert.equal(await page.evaluate(() => document.activeElement.id), `tab${place}`);
            await unfold(page);
            const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
            assert.ok(wide <= 0, `tab ${place}: ${wide} pixels beyond the edge`);
            await page.keyboard.press("ArrowRight");
        }
        const session = await page.context().newCDPSession(page), { nodes } = await session.send("Accessibility.getFullAXTree");
        const nameless = nodes.filter(({ ignored, role, name }) => !ignored && /^(button|textbox|combobox|listbox|slider|img|image|tab|progressbar|link)$/.test(role?.value) && !name?.value);
        assert.deepEqual(nameless.map(({ role, properties }) => [role.value, properties]), []);
        const plot = page.locator(".plots .uplot").first(), legend = () => plot.locator(".u-value").last().innerText();
        await plot.focus();
        await page.keyboard.press("Home");
        const first = await legend();
        await page.keyboard.press("End");
        assert.notEqual(await legend(), first);
        assert.match(await page.locator(".plots .uplot").nth(2).locator(".u-value").first().innerText(), /360 s|6 min/); // one cursor for all panels
        await page.keyboard.press("+");
        await page.keyboard.press("Escape");
        if (options.colorScheme) await page.screenshot({ path: `${out}/dark_400.png`, fullPage: true });
    }
    const dark = await opened(context, { colorScheme: "dark" });
    await set(dark, "flight.hours", "0.5");
    await fly(dark);
    await dark.screenshot({ path: `${out}/dark.png`, fullPage: true });
});

test("the example of 30 lines in a page", async (context) => {
    mkdirSync(`${out}/minimal`, { recursive: true });
    const folder = resolve(SINS_MODULE, "..");
    for (const name of ["sins.mjs", "sins.wasm"]) writeFileSync(`${out}/minimal/${name}`, readFileSync(`${folder}/${name}`));
    writeFileSync(`${out}/minimal/minimal.html`, readFileSync("c_examples/web/minimal.html"));
    const page = await page_with(chromium, `${out}/minimal`), errors = () => page.evaluate(() => document.getElementById("errors").value);
    context.after(() => page.close());
    await page.goto("https://sins.test/minimal.html");
    await page.waitForFunction(() => document.getElementById("errors").value.startsWith("After"));
    assert.equal(await errors(), "After an hour: -145 m east, -1336 m north");
    await page.fill("#bias", "1e9");
    assert.match(await errors(), /^gyro.bias_rad_s\[0\] = .*: must be from -100 to 100$/);
});
