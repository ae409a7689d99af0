// What a user chooses at the page and what it then shows: kept curves, the quantity, the list of scenes, logs with what is wrong in them.
//
//     SINS=target/release/sins node --test tests/web/choices.mjs      see tests/web.sh

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import test, { after, before } from "node:test";
import { pathToFileURL } from "node:url";

import { at_times, tick_texts } from "../../apps/page/curves.mjs";
import { lessons_of } from "../../apps/page/pack/lessons_of.mjs";
import { drop, fly, opened, out, press, same_as_program, set, start, stop, tab, unfold, until, write } from "./user.mjs";

const { SINS } = process.env;
const LESSONS = lessons_of("apps/page/lessons");

before(start);
after(stop);

test("curves are kept: drawn below the next flight in colours of their own, in any language, until they are removed", async (context) => {
    const page = await opened(context, { hash: "#lesson=gyros" });
    await until(page, /^Finished/);
    const names = () => page.locator(".plots .uplot:first-child .u-series:not(:first-child) th .u-label").allInnerTexts();
    const data = () => page.evaluate(() => document.querySelectorAll(".plots .uplot").length), slide = async (place) => {
        await page.locator('[data-slides="gyro.bias_sigma_deg_h"]').fill(String(place));
        await until(page, /^Finished/);
        await page.waitForTimeout(300);
    };
    const before = await names();
    assert.equal(await page.locator("[data-do=forget]").isVisible(), false);
    for (let k = 1; k <= 4; k++) {
        await slide(k);
        await press(page, "keep");
    }
    assert.equal(await page.locator("[data-do=keep]").isDisabled(), true); // four are kept at most
    assert.deepEqual(await names(), ["0.001 °/h", "0.01 °/h", "0.1 °/h", "1 °/h"].map((own) => `${own}, 10 µg, 0`).concat(before));
    await slide(5);
    assert.deepEqual([(await names()).length, await data()], [5, 3]);
    assert.ok(await page.evaluate(() => {
        const canvas = document.querySelector(".plots canvas"), { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height), inks = new Set();
        for (let k = 0; k < data.length; k += 4) if (data[k + 3] === 255) inks.add(`${data[k]},${data[k + 1]},${data[k + 2]}`);
        return inks.has("106,79,179"); // that of a tenth of the error
    }));
    await page.selectOption("#language", "zh");
    assert.equal((await names()).length, 5);
    await page.selectOption("#language", "en");
    await press(page, "forget");
    assert.deepEqual(await names(), before);
    await press(page, "keep");
    await page.getByRole("link", { name: LESSONS[0].en.title, exact: true }).click(); // another lesson begins anew
    await until(page, /^Finished: 24 h/);
    assert.deepEqual(await names(), before);
});

test("many runs: the area is between the outermost but one of those that `sins ensemble` flies, until the scene is flown anew", async (context) => {
    const page = await opened(context, { hash: "#lesson=gyros" });
    await until(page, /^Finished/);
    const labels = () => page.locator(".plots .uplot").evaluateAll((all) => all.map((own) => own.getAttribute("aria-label")));
    const shown = async (quantity) => {
        await page.selectOption("#quantity", quantity);
        const label = /48 of 50 runs: (\S+) … (\S+) (\S+)$/, sizes = { mm: 1e-3, m: 1, km: 1000, "mm/s": 1e-3, "m/s": 1, "″": Math.PI / 648000, "′": Math.PI / 10800, "°": Math.PI / 180 };
        return (await labels()).map((own) => label.exec(own).slice(1)).map(([low, high, unit]) => [low, high].map((own) => Number(own) * sizes[unit]));
    };
    await press(page, "many");
    await page.waitForFunction(() => /48 of 50/.test(document.querySelector(".plots .uplot")?.getAttribute("aria-label")));
    writeFileSync(`${out}/many.toml`, LESSONS.find(({ name }) => name === "gyros").scene);
    assert.equal(spawnSync(SINS, ["ensemble", `${out}/many.toml`, "--runs", "50", "--name", "many", "--out", `${out}/many`, "--quiet", "--force"]).status, 0);
    const [head, ...rows] = readFileSync(`${out}/many/many_ensemble_runs.csv`, "utf8").trim().split("\n").map((line) => line.split(","));
    const column = (name) => rows.map((row) => Number(row[head.indexOf(name)])).sort((a, b) => a - b);
    for (const [quantity, name, unit] of [["0", "position", "m"], ["1", "velocity", "m_s"], ["2", "misalignment", "rad"]]) {
        for (const [k, edges] of (await shown(quantity)).entries()) {
            const all = column(`${name}_${["east", "north", "up"][k]}_${unit}`), near = (found, wanted) => assert.ok(Math.abs(found - wanted) <= 1e-3 * Math.abs(wanted) + 1e-12, `${name} ${k}: ${edges}, not ${all[1]}, ${all.at(-2)}`);
            near(edges[0], all[1]);
            near(edges[1], all.at(-2));
        }
    }
    await page.selectOption("#quantity", "0");
    await page.locator(".plots").screenshot({ path: `${out}/many.png` });
    await page.locator('[data-slides="gyro.bias_sigma_deg_h"]').fill("4");
    await until(page, /^Finished/);
    await page.waitForFunction(() => !/48 of 50/.test(document.querySelector(".plots .uplot").getAttribute("aria-label")));

    const state = (pattern) => until(page, pattern);
    for (const [scene, answer] of [['[flight]\nbuiltin = "rest"\nhours = 0.01\n', /^Nothing in this scene is random/], ['[flight]\nbuiltin = "rest"\nhours = 2\nrate_hz = 100\n[gyro]\nbias_sigma_deg_h = 1\n', /take too long here/]]) {
        await write(page, scene);
        await fly(page);
        await press(page, "many");
        await state(answer);
    }
    await write(page, '[flight]\nbuiltin = "rest"\nhours = 0.3\nrate_hz = 1\n[unit]\nstart = "nav"\n');
    await fly(page);
    assert.equal(await page.locator("[data-do=many]").isDisabled(), true);

    // Not of a log that is no more: its errors would be those along another one.
    const logged = (name, north) => {
        const rows = Array.from({ length: 200 }, (_, k) => `${k},${45 + north * k * 1e-5},10,1000,0,${north},0,0,0,0`);
        writeFileSync(`${out}/${name}`, `time_s,latitude_deg,longitude_deg,height_m,velocity_east_m_s,velocity_north_m_s,velocity_up_m_s,roll_deg,pitch_deg,heading_deg\n${rows.join("\n")}\n`);
    };
    logged("one.csv", 1);
    logged("two.csv", 2);
    await write(page, '[flight]\nbuiltin = "rest"\n[gyro]\nbias_sigma_deg_h = 1\n');
    await drop(page, `${out}/one.csv`);
    await fly(page);
    assert.equal(await page.locator("[data-do=many]").isDisabled(), false);
    await drop(page, `${out}/two.csv`);
    await page.waitForFunction(() => document.querySelector("[data-do=many]").disabled);
});

test("a setting is found by words of its name, meaning and unit, in both languages, and set where it was found", async (context) => {
    const page = await opened(context, { hash: "" });
    await until(page, /^Finished/);
    for (const place of [4, 0]) await tab(page, place);
    const paths = () => page.locator("aside [data-path]:visible").evaluateAll((all) => all.map((own) => own.dataset.path));
    const tabs = await paths();
    assert.ok(tabs.includes("flight.hours"));
    await page.fill("#find", "Gyros bias °/h");
    const found = await paths();
    assert.ok(found.includes("gyro.bias_deg_h") && found.every((path) => /^gyro\..*deg_h/.test(path)), found);
    await page.locator('[data-path="gyro.bias_deg_h"]:visible').fill("0.25");
    await page.keyboard.press("Enter");
    await until(page, /^Finished/);
    assert.match(await page.inputValue("#text"), /^bias_deg_h = 0\.25 /m);
    await page.locator('[data-path="gyro.bias_deg_h"]:visible').fill("1e9"); // a fault stands where it was made
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => [...document.querySelectorAll(".fault")].some((own) => own.checkVisibility() && /bias_deg_h/.test(own.value ?? "")));
    for (const [words, path] of [["sample rate", "flight.rate_hz"], ["output.every", "output.every_s"], ["alignment_s", "unit.alignment_s"]]) {
        await page.fill("#find", words);
        assert.ok((await paths()).includes(path), `${words}: ${await paths()}`);
    }
    // What a page cannot use is not found: names of files and folders.
    for (const words of ["output.folder", "flight.file", "nothing of this name"]) {
        await page.fill("#find", words);
        assert.deepEqual([await paths(), await page.getByText("No such setting").isVisible()], [[], true], words);
    }
    await page.selectOption("#language", "zh");
    await page.fill("#find", "陀螺 零偏");
    assert.ok((await paths()).includes("gyro.bias_deg_h"), await paths());
    await page.selectOption("#language", "en");
    assert.deepEqual(await paths(), tabs);
});

test("the chosen quantity stays when the language changes, the list says what flies, and Start is the first stop of Tab", async (context) => {
    const page = await opened(context, { hash: "" });
    await until(page, /^Finished/);
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.dataset.do), "start");
    await page.selectOption("#quantity", "2");
    await page.selectOption("#language", "zh");
    assert.equal(await page.locator("#quantity").inputValue(), "2");
    await page.selectOption("#language", "en");
    const listed = () => page.evaluate(() => document.querySelector('[data-path="scene"]').selectedOptions[0].textContent);
    assert.match(await listed(), /^The paper's simulation 2: a patrol of 48 hours/); // at another rate, so not the built-in one
    for (const own of ["rest", "aerobatics"]) {
        await page.selectOption('[data-path="scene"]', own);
        await page.click("[data-do=open_builtin]");
        assert.equal(await page.locator('[data-path="scene"]').inputValue(), own);
    }
    // A title is that of what was opened: also with more errors and other options, but not of another flight.
    await tab(page, 1);
    await unfold(page);
    await set(page, "options.subsamples", "3");
    await set(page, "gyro.bias_deg_h", "0.25");
    await tab(page, 0);
    assert.match(await listed(), /^Loops, rolls/);
    await set(page, "flight.speed_m_s", "190");
    assert.equal(await listed(), "This scene");
    await set(page, "flight.title", "My own");
    assert.equal(await listed(), "My own");
});

test("what the judge finds in a log stands above its curves, and goes with the log", async (context) => {
    // A flight to the east at 75 m/s whose velocity is in knots, and the same without the fault.
    const head = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg,velocity_east_m_s,velocity_north_m_s,velocity_up_m_s\n";
    const log = (speed) => head + Array.from({ length: 601 }, (_, k) => `${k / 2},0,${(11 + ((k / 2) * 75 * 180) / Math.PI / 6378137).toFixed(12)},500,0,0,90,${speed},0,0\n`).join("");
    const [knots, good] = [[75 * 3600 / 1852, "knots"], [75, "good"]].map(([speed, name]) => (writeFileSync(`${out}/${name}.csv`, log(speed)), `${out}/${name}.csv`));
    const page = await opened(context, { hash: "#rest" }), found = () => page.locator(".findings li").allInnerTexts();
    await drop(page, knots);
    await until(page, /601 samples/);
    // Exit code 2: it is unusable.
    const said = JSON.parse(spawnSync(SINS, ["log", knots, "--json"], { encoding: "utf8" }).stdout.split("\n")[0]).findings.filter(({ kind }) => kind), shown = await found();
    assert.equal(shown.length, said.length);
    for (const [k, { level, sentence }] of said.entries()) assert.ok(shown[k].startsWith(`${level[0].toUpperCase()}${level.slice(1)}: ${sentence}`), `${shown[k]}, not ${sentence}`);
    assert.match((await found())[0], /^Unusable: velocity is 1\.94 times the displacement \(knots\?\)/);
    await fly(page);
    const [list, curves] = await page.evaluate(() => [".findings", ".plots"].map((own) => document.querySelector(own).getBoundingClientRect()));
    assert.ok(list.height > 0 && list.bottom <= curves.top);
    await page.selectOption("#language", "zh");
    assert.match((await found())[0], /^不可用: /);
    await page.selectOption("#language", "en");
    await drop(page, good);
    await until(page, /good\.csv: 601 samples/);
    assert.deepEqual((await found()).filter((own) => /^Unusable/.test(own)), []);
    await drop(page, knots);
    await until(page, /knots\.csv: 601 samples/);
    await page.selectOption('[data-path="scene"]', "rest");
    await press(page, "open_builtin");
    assert.equal(await page.locator(".findings").isVisible(), false);
});

test("a heading that is north to two decimals is 0.00", async (context) => {
    const page = await opened(context, { hash: "#rest" });
    await write(page, '[flight]\nrate_hz = 10\nheading_deg = 359.9999\n[[manoeuvre]]\nkind = "rest"\nduration_s = 60\n');
    await fly(page);
    const cells = await page.locator("tbody tr", { hasText: "Attitude" }).locator("td").allInnerTexts();
    assert.deepEqual(cells.map((own) => own.split(" ")[2]), ["0.00", "0.00"]);
});

test("numbers at an axis have one notation, and kept curves are drawn at the times of the flight", () => {
    for (const [ticks, texts] of [
        [[0, 0.5, 1, 1.5], ["0.0", "0.5", "1.0", "1.5"]],
        [[-200, 0, 200], ["-200", "0", "200"]],
        [[0, 5e-7, 1e-6], ["0", "5e-7", "1e-6"]],
        [[0, 0.5e-6, 1e-6, 1.5e-6], ["0", "5.0e-7", "1.0e-6", "1.5e-6"]],
        [[-0.00001, 0, 0.00001], ["-0.00001", "0.00000", "0.00001"]],
        [[5e20, 1e21], ["5e+20", "1e+21"]],
    ]) assert.deepEqual(tick_texts(ticks), texts);
    for (let k = 0; k < 2000; k++) {
        const step = 10 ** Math.round(60 * Math.sin(k) / 3) * [1, 2, 2.5, 5][k % 4], all = tick_texts([-2, -1, 0, 1, 2, 3].map((own) => own * step)).filter((own) => Number(own) !== 0);
        assert.ok(new Set(all.map((own) => own.includes("e"))).size === 1 && new Set(all.map((own) => own.split("e")[0].split(".")[1]?.length)).size === 1, all.join(" "));
        assert.equal(new Set(all).size, 5, all.join(" "));
    }
    assert.deepEqual(at_times([0, 1, 3], [10, 20, 40], [0, 0.5, 1, 2, 3, 4]), [10, 15, 20, 30, 40, null]);
    assert.deepEqual(at_times([1, 2], [5, 6], [0, 1]), [null, 5]);
});

test("flight records in GPX, IGC and FDR, and a table with semicolons, fly when they are dropped: as in sins fly", async (context) => {
    // A circle of 2 km at 60 m/s, a row each second: time [s], latitude and longitude [deg], height [m], roll and heading [deg].
    const rows = Array.from({ length: 240 }, (_, t) => {
        const turned = (60 / 2000) * t, deg = 180 / Math.PI / 6378137;
        return [t, 48 + 2000 * Math.sin(turned) * deg, 11 + (2000 * (1 - Math.cos(turned)) * deg) / Math.cos((48 * Math.PI) / 180), 900 + t, 10.4, ((turned * 180) / Math.PI) % 360];
    });
    const two = (value) => String(value).padStart(2, "0"), clock = (t, by) => [10, Math.floor(t / 60), t % 60].map(two).join(by);
    const igc_angle = (own, digits, [plus, minus]) => `${String(Math.floor(own)).padStart(digits, "0")}${String(Math.round((own % 1) * 60000)).padStart(5, "0")}${own < 0 ? minus : plus}`;
    const logs = {
        "circle.gpx": `<?xml version="1.0"?>\n<gpx version="1.1"><trk><trkseg>\n${rows.map(([t, lat, lon, height]) => `<trkpt lat="${lat.toFixed(8)}" lon="${lon.toFixed(8)}"><ele>${height}</ele><time>2026-07-25T${clock(t, ":")}Z</time></trkpt>\n`).join("")}</trkseg></trk></gpx>\n`,
        "circle.igc": `AXXX001\r\nHFDTE250726\r\n${rows.map(([t, lat, lon, height]) => `B${clock(t, "")}${igc_angle(lat, 2, "NS")}${igc_angle(lon, 3, "EW")}A${String(height).padStart(5, "0").repeat(2)}\r\n`).join("")}`,
        "circle.fdr": `A\n4\n\nCOMM, made up\nACFT, Aircraft/x.acf\nTAIL, N1\nDATE, 05/01/2026\nPRES,29.92\nDISA,0\nWIND,230,16\nDREF, sim/cockpit2/gauges/actuators/barometer_setting_in_hg_pilot 1.0\n\nCOMM, degrees\n${rows.map(([t, lat, lon, height, roll, heading]) => `${clock(t, ":")}, ${lon.toFixed(9)}, ${lat.toFixed(9)}, ${(height / 0.3048).toFixed(3)}, ${heading.toFixed(4)}, 0, ${roll}, 29.92\n`).join("")}`,
        "circle.csv": `t;lat;lon;h;roll;hdg\n${rows.map((row) => row.map((own) => own.toFixed(9).replace(".", ",")).join(";")).join("\n")}\n`,
    };
    const columns = '[log]\nseparator = "semicolon"\ntime = "t"\nlatitude = "lat"\nlongitude = "lon"\nheight = "h"\nroll = "roll"\npitch = 0\nheading = "hdg"\nsmooth = "auto"\n';
    for (const [name, log] of Object.entries(logs)) {
        writeFileSync(`${out}/flown/${name}`, log);
        const page = await opened(context, { hash: "#rest" });
        await write(page, `[flight]\nfile = "none.csv"\n[gyro]\npreset = "tactical"\n${name.endsWith("csv") ? columns : ""}[output]\nevery_s = 0.5\n`);
        await drop(page, `${out}/flown/${name}`);
        await until(page, new RegExp(`^${name}: \\d+ samples, 2\\d\\d`));
        await fly(page);
        await same_as_program(page, `circle_${name.slice(-3)}`);
        await page.context().close();
    }
});

test("files beside a log are dropped with it, in any order and number: as in sins fly", async (context) => {
    // North at 60 m/s with a slow roll: positions each 0.2 s, attitudes each 0.25 s.
    const rows = (count, line) => Array.from({ length: count }, (_, k) => line(k)).join("\n");
    const texts = {
        "joined.toml": `[flight]\nfile = "POS.csv"\n[log]\ntime = "t"\nlatitude = "lat"\nlongitude = "lon"\nheight = "h"\n${[["roll", "Roll"], ["pitch", "Pitch"], ["heading", "Yaw"]].map(([key, col]) => `${key} = { col = "${col}", file = "ATT.csv" }\n`).join("")}[gyro]\npreset = "tactical"\n[output]\nevery_s = 0.5\n`,
        "POS.csv": `t,lat,lon,h\n${rows(300, (k) => `${(k / 5).toFixed(2)},${(48 + (60 * k) / 5 / 111195).toFixed(11)},11,900`)}\n`,
        "ATT.csv": `t,Roll,Pitch,Yaw\n${rows(241, (k) => `${(k / 4).toFixed(2)},${(3 * Math.sin(k / 40)).toFixed(6)},2,0`)}\n`,
    };
    for (const [name, own] of Object.entries(texts)) writeFileSync(`${out}/flown/${name}`, own);
    const path = (name) => `${out}/flown/${name}`, read = /^POS\.csv: \d+ samples, 59/;
    const whole = await opened(context, { hash: "#rest" });
    await drop(whole, path("ATT.csv"), path("POS.csv"), path("joined.toml"));
    await until(whole, read);
    await fly(whole);
    assert.match(await same_as_program(whole, "joined"), /ATT\.csv/);
    // One by one, what is still missing is said.
    const page = await opened(context, { hash: "#rest" });
    await drop(page, path("joined.toml"));
    await until(page, /ATT\.csv is not here yet|POS\.csv is not here yet/);
    await drop(page, path("POS.csv"));
    await until(page, /ATT\.csv is not here yet/);
    await drop(page, path("ATT.csv"));
    await until(page, read);
    // A file beside the log that was changed is read again.
    writeFileSync(path("ATT.csv"), texts["ATT.csv"].replace("\n1.00,", "\n1.00,x"));
    await drop(page, path("ATT.csv"));
    await until(page, /ATT\.csv:6: .*x0/);
    writeFileSync(path("ATT.csv"), texts["ATT.csv"]);
    await drop(page, path("ATT.csv"));
    await until(page, read);
});

test("of a longer flight the ten minutes that turn most are measured, from where they turn on", async () => {
    const [{ load }, { measure }] = await Promise.all([resolve(process.env.SINS_MODULE), "apps/page/measure.mjs"].map((path) => import(pathToFileURL(resolve(path)))));
    const sins = await load(), straight = (duration_s) => `[[manoeuvre]]\nkind = "straight"\nduration_s = ${duration_s}\n`;
    const cone = ["roll", "pitch"].map((channel, k) => `[[manoeuvre.sinusoid]]\nchannel = "${channel}"\namplitude_deg = 5\nfrequency_hz = 0.5\nphase_deg = ${90 * k}\n`).join("");
    const measured = (before_s, behind_s) => {
        const scene = sins.scene_parse(`[flight]\nspeed_m_s = 100\nlatitude_deg = 45\n${straight(before_s)}[[manoeuvre]]\nkind = "sinusoids"\nduration_s = 60\nramp_s = 5\n${cone}${straight(behind_s)}`);
        const found = measure(sins, scene, { scheme: "exact", subsamples: 1, rate_hz: 10 });
        scene.close();
        return found;
    };
    const short = measured(10, 530);
    assert.equal(short.flown_s, 600);
    for (const [before_s, behind_s] of [[1, 5000], [3000, 2000], [100000, 3000]]) {
        const { error_m, flown_s } = measured(before_s, behind_s);
        assert.ok(flown_s === 600 && error_m > 0.8 * short.error_m && error_m < 1.3 * short.error_m, `${before_s}: ${error_m}, not ${short.error_m}`);
    }
});
