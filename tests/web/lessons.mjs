// Lessons of the page without a browser: what their texts say, in numbers of flights, and which lessons are not packed.
//
//     SINS=target/release/sins SINS_MODULE=target/wasm/sins.mjs node --test tests/web/lessons.mjs      see tests/web.sh

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";

import { lessons_of, read_by } from "../../apps/page/pack/lessons_of.mjs";
import { measure } from "../../apps/page/measure.mjs";
import { THEORIES } from "../../apps/page/theory.mjs";

const { SINS, SINS_MODULE } = process.env;
const FOLDER = "apps/page/lessons", LESSONS = lessons_of(FOLDER), out = resolve("target/web");

/** Of a lesson's scene with other values, flown by the program: position errors [m], misalignment [arcmin], true heading, the record at a time. */
function flown(name, values = {}) {
    const file = [name, ...Object.entries(values).flat()].join("_").replace(/[^\w]/g, "");
    const sets = Object.entries(values).flatMap(([key, value]) => ["--set", `${key}=${value}`]);
    execFileSync(SINS, ["fly", `${FOLDER}/${name}/scene.toml`, ...sets, "--name", file, "--out", `${out}/flown/expected`, "--quiet", "--force"]);
    const [head, ...lines] = readFileSync(`${out}/flown/expected/${file}.csv`, "utf8").trim().split("\n").map((line) => line.split(","));
    const column = (own, size = 1) => lines.map((line) => Number(line[head.indexOf(own)]) / size);
    const of = (own) => lines.map((line) => Number(line[head.indexOf(own)]));
    const [time_s, east, north] = [column("time_s"), ...["east", "north"].map((axis) => column(`navigation_error_position_${axis}_m`))];
    const [tilt, up] = ["east", "up"].map((axis) => column(`navigation_error_misalignment_${axis}_rad`, Math.PI / 10800)), heading = column("truth_heading_rad");
    const at = (wanted_s) => time_s.findIndex((own) => own >= wanted_s);
    return { at, of, time_s, east, north, tilt, up, heading, off_m: time_s.map((_, k) => Math.hypot(east[k], north[k])) };
}

test("what the lesson on Schuler says is so at every latitude of its slider", () => {
    const PERIOD_S = 5064, TURN_S = 86164, ARC_M = 1852, HOUR_S = 3600;
    const latitudes = LESSONS.find(({ name }) => name === "schuler").slider.find(({ key }) => key === "flight.latitude_deg").values;
    assert.ok(latitudes.includes(0) && latitudes.length > 4);
    for (const latitude_deg of latitudes) {
        const { at, east, north, tilt, off_m } = flown("schuler", { "flight.latitude_deg": latitude_deg });
        const is_near = (value, wanted, by, what) => assert.ok(Math.abs(value - wanted) <= by, `${latitude_deg} deg: ${what}: ${value}, not ${wanted}`);
        const first = off_m.slice(0, at(PERIOD_S)), swing = north.slice(at(4000), at(6000)), back = at(4000) + swing.indexOf(Math.min(...swing));
        is_near(back, at(PERIOD_S), at(120), "the end of the first swing");
        is_near(Math.max(...first), 2 * ARC_M, 0.015 * 2 * ARC_M, "the first swing");
        is_near(off_m[back], 0, 0.04 * 2 * ARC_M, "where it returns");
        assert.ok(Math.max(...off_m) <= 1.01 * 2 * ARC_M, `${latitude_deg} deg: ${Math.max(...off_m)} m within the day`);
        is_near(tilt[0], 1, 1e-3, "the tilt at the start");
        is_near(tilt[at(PERIOD_S / 4)], 0, (2 * Math.PI * 60) / PERIOD_S, "the tilt after a quarter of the period"); // within a record
        is_near(tilt[at(PERIOD_S / 2)], -1, 0.05, "the tilt after half a period");
        // Foucault: the line between two ends of the swing.
        const turned = (from_s) => (([a, b]) => Math.atan2(east[b] - east[a], north[b] - north[a]))([at(from_s), at(from_s + PERIOD_S / 2)]);
        is_near(((turned(2 * PERIOD_S) - turned(0)) * 180) / Math.PI / ((2 * PERIOD_S) / HOUR_S), 15 * Math.sin((latitude_deg * Math.PI) / 180), 0.5, "Foucault");
        // The middle of the swing is the first tilt, as north and east turn away from it. Within a period the plane of the swing turns too.
        const middle = (from_s) => north.slice(at(from_s), at(from_s + PERIOD_S)).reduce((sum, own, _, all) => sum + own / all.length, 0);
        const turn = (time_s) => (2 * Math.PI * (time_s + PERIOD_S / 2)) / TURN_S;
        for (const from_s of [0, TURN_S / 4, TURN_S / 2]) is_near(middle(from_s), ARC_M * Math.cos(turn(from_s)), (PERIOD_S / TURN_S) * ARC_M, "the middle of the swing");

        const drift = flown("schuler", { "flight.latitude_deg": latitude_deg, "start.misalignment_arcmin[0]": 0, "gyro.bias_deg_h[0]": 0.01 });
        const grown = (from_s, to_s) => Math.abs(drift.north[drift.at(to_s)] - drift.north[drift.at(from_s)]) / (to_s - from_s);
        // The rate is as cos(2 pi t / turn) - cos(2 pi t / period): of its mean, -0.07 at the first step and -0.31 at the second.
        for (const k of [1, 2]) assert.ok(grown(k * PERIOD_S - 150, k * PERIOD_S + 150) < 0.35 * grown((k - 1) * PERIOD_S, k * PERIOD_S), `${latitude_deg} deg: step ${k}`);
        const most_m = Math.max(...drift.off_m);
        assert.ok(most_m > 2 * ARC_M && drift.off_m[drift.at(TURN_S)] < 0.03 * most_m, `${latitude_deg} deg: ${drift.off_m[drift.at(TURN_S)]} m of ${most_m} m`);
    }
});

test("what the lesson on cost says is so: algorithms on both sides of the error of its sensors", async () => {
    const { load } = await import(pathToFileURL(resolve(SINS_MODULE))), sins = await load();
    const scene = sins.scene_parse(LESSONS.find(({ name }) => name === "cost").scene), own = sins.scene_get_setup(scene);
    assert.ok(own.flown_s <= 600); // the whole of it is measured
    const sensors = measure(sins, scene, null), at = (scheme, subsamples, rate_hz) => measure(sins, scene, { scheme, subsamples, rate_hz });
    const [simple, enough, fine] = [at("exact", 1, 10), at("exact", 2, 10), at("polynomial", 4, 100)];
    console.log(`page: sensors ${sensors.error_m.toPrecision(2)} m; ${[simple, enough, fine].map((one) => `${one.error_m.toPrecision(2)} m`).join(", ")}`);
    assert.equal(sensors.flown_s, own.flown_s);
    assert.ok(simple.error_m > 2 * sensors.error_m && enough.error_m < sensors.error_m / 2 && fine.error_m < 1e-3 * enough.error_m);
    assert.ok(fine.us_per_s > enough.us_per_s); // ten times as many samples
    sins.scene_set_values(scene, 'options.scheme = "exact"\noptions.subsamples = 1\nflight.rate_hz = 10\n');
    const coarse = measure(sins, scene, null);
    assert.ok(Math.abs(coarse.error_m / sensors.error_m - 1) < 1e-3, `${coarse.error_m} m`); // the error of the sensors alone
});

test("the line of theory follows the phase and the amplitudes of the cone, and says nothing of other motions", () => {
    const rate = (changes) => {
        const values = { "flight.rate_hz": "10", "options.subsamples": "1", "manoeuvre[0].ramp_s": "10", "manoeuvre[0].duration_s": "300" };
        for (const [k, phase] of [[0, "0"], [1, "90"]]) for (const [key, value] of Object.entries({ amplitude_deg: "5", frequency_hz: "0.5", phase_deg: phase })) values[`manoeuvre[0].sinusoid[${k}].${key}`] = value;
        return THEORIES.coning({ get: (key) => ({ ...values, ...changes })[key] ?? "" })?.rate ?? null;
    };
    const sinusoid = (k, key, value) => ({ [`manoeuvre[0].sinusoid[${k}].${key}`]: value }), whole = rate({});
    assert.ok(Math.abs(whole * (180 / Math.PI) * 3600 - 40.39) < 0.01, `${whole}`);
    assert.ok(Math.abs(rate(sinusoid(1, "phase_deg", "0"))) < 1e-18 && Math.abs(rate(sinusoid(1, "phase_deg", "-90")) + whole) < 1e-12);
    assert.ok(Math.abs(rate(sinusoid(0, "amplitude_deg", "2.5")) / whole - 0.5) < 1e-12);
    assert.deepEqual([rate(sinusoid(1, "frequency_hz", "1")), rate({ "options.subsamples": "2" }), rate(sinusoid(1, "amplitude_deg", ""))], [null, null, null]);
});

test("what the lesson on coning says is so: the drift of theory, and what makes it smaller", () => {
    const drift_deg_h = (values = {}) => {
        const { at, up, heading } = flown("coning", values), [from, to] = [at(30), at(270)]; // 10 s of ramps at both ends
        assert.ok(Math.max(...heading.map((own) => Math.abs(Math.sin(own)))) < 1e-12); // it stays
        return ((up[to] - up[from]) / 60 / 240) * 3600;
    };
    const [a, w, T] = [(5 * Math.PI) / 180, 2 * Math.PI * 0.5, 0.1], theory_deg_h = ((a * a * w) / 2) * (1 - Math.sin(w * T) / (w * T)) * (180 / Math.PI) * 3600;
    const one = drift_deg_h(), is_near = (value, wanted, part, what) => assert.ok(Math.abs(value - wanted) <= part * wanted, `${what}: ${value}, not ${wanted}`);
    is_near(one, theory_deg_h, 0.01, "the drift");
    is_near(theory_deg_h, 40, 0.02, "theory");
    is_near(flown("coning", {}).up.at(-1), 3.2 * 60, 0.02, "the end");
    is_near(one / drift_deg_h({ "options.subsamples": 2 }), 1000, 0.2, "two subsamples");
    is_near(one / drift_deg_h({ "flight.rate_hz": 100 }), 100, 0.02, "ten times the rate");
    is_near(one / drift_deg_h({ "manoeuvre[0].sinusoid[0].amplitude_deg": 2.5 }), 2, 0.01, "half of the roll");
    assert.ok(Math.abs(drift_deg_h({ "manoeuvre[0].sinusoid[0].amplitude_deg": 0 })) < 1e-4 * one);
});

const is_near = (value, wanted, part, what) => assert.ok(Math.abs(value - wanted) <= part * wanted, `${what}: ${value}, not ${wanted}`);

test("what the lesson on gyros says is so: errors grow with the bias, and so many runs are within two miles", () => {
    const own = (gyro, accelerometer, run = 0) => flown("gyros", { "gyro.bias_sigma_deg_h": gyro, "accelerometer.bias_sigma_micro_g": accelerometer, "options.run": run }).off_m.at(-1);
    is_near(own(0.01, 0) / own(0.001, 0), 10, 1e-3, "ten times the bias");
    is_near(own(0.1, 0) / own(0.01, 0), 10, 1e-2, "ten times the bias");
    const runs = (...sets) => {
        execFileSync(SINS, ["ensemble", `${FOLDER}/gyros/scene.toml`, "--runs", "200", ...sets.flatMap((set) => ["--set", set]), "--name", "gyros", "--out", `${out}/flown/expected`, "--quiet", "--force"]);
        const [head, ...lines] = readFileSync(`${out}/flown/expected/gyros_ensemble.csv`, "utf8").trim().split("\n").map((line) => line.split(","));
        return Object.fromEntries(["cep50_m", "r95_m"].map((name) => [name, Number(lines.at(-1)[head.indexOf(name)])]));
    };
    const gyros = runs("accelerometer.bias_sigma_micro_g=0"), accelerometers = runs("gyro.bias_sigma_deg_h=0", "accelerometer.bias_sigma_micro_g=200");
    is_near(gyros.cep50_m, 2300, 0.03, "CEP50 of gyros of 0.01 deg/h");
    is_near(gyros.cep50_m / 1852, 1.2, 0.05, "in nautical miles");
    is_near(gyros.r95_m, 4500, 0.03, "R95");
    is_near(accelerometers.cep50_m / gyros.cep50_m, 1, 0.2, "accelerometers of 200 micro-g");
});

test("what the lesson on the pole says is so: curves jump and distances do not, and geographic axes end", () => {
    const { east, north, off_m, of, time_s } = flown("pole"), step = (values) => values.map((value, k) => Math.abs(value - (values[k - 1] ?? value)));
    const at_pole = step(east.map((_, k) => k)).findIndex((_, k) => off_m[k] > 1 && Math.abs(east[k] - east[k - 1]) > 0.5 * off_m[k]);
    assert.ok(Math.abs(time_s[at_pole] - 268) < 2, `${time_s[at_pole]} s`);
    is_near(-east[at_pole] / east[at_pole - 1], 1, 0.2, "east changes its sign");
    is_near(-north[at_pole] / north[at_pole - 1], 1, 0.2, "north changes its sign");
    assert.ok(Math.max(...step(off_m)) < 0.05 * Math.max(...off_m), `${Math.max(...step(off_m))} m`);
    const heading = of("truth_heading_rad"), in_loop = heading.slice(time_s.findIndex((own) => own > 500), time_s.findIndex((own) => own > 560));
    assert.ok(Math.max(...step(in_loop).map((own) => Math.abs(Math.sin(own / 2)))) > 0.9); // it jumps by half a turn
    const aside = ["earth", "geographic"].map((frame) => flown("pole", { "flight.heading_deg": 20, "options.frame": frame }));
    const nearest_deg = 90 - Math.max(...aside[0].of("truth_latitude_rad").map((own) => (own * 180) / Math.PI));
    is_near(nearest_deg * 111.69, 23, 0.02, "the distance from the pole");
    for (const axis of ["east", "north"]) assert.ok(Math.abs(aside[0][axis].at(-1) - aside[1][axis].at(-1)) < 1e-3);
    assert.throws(() => flown("pole", { "options.frame": "geographic" }), ({ stderr }) => {
        const [, ended_s] = /at ([\d.]+) s: .*the geographic frame needs/.exec(stderr.toString());
        is_near((268 - ended_s) * 0.25, 6, 0.1, "the end before the pole");
        return true;
    });
    const ideal = { "gyro.preset": "ideal", "accelerometer.preset": "ideal" }, days = flown("pole", { "flight.repeat": 152, "output.every_s": 4, ...ideal });
    is_near(days.time_s.at(-1) / 3600, 48, 1e-3, "the hours");
    is_near(((days.time_s.at(-1) / 152) * 10) / 3600, 3.2, 0.02, "the hours of 10 rounds");
    assert.ok(days.off_m.every((own) => own < 0.3), `${Math.max(...days.off_m)} m`);
    const far_km = new Array(152).fill(Infinity), latitudes = days.of("truth_latitude_rad");
    days.time_s.forEach((own, k) => {
        const round = Math.min(Math.floor((152 * own) / days.time_s.at(-1)), 151);
        far_km[round] = Math.min(far_km[round], (90 - (latitudes[k] * 180) / Math.PI) * 111.69);
    });
    assert.ok(far_km.every((own, k) => k % 2 === 1 || own < 1), far_km.join()); // 1 km: a record has 4 s
});

test("what the lesson on effects says is so: the flight decides which error counts", () => {
    const none = { "gyro.scale_factor_ppm": 0 };
    const off = (builtin, values = {}) => flown("effects", { "flight.builtin": builtin, ...values }).off_m.at(-1), [rest, aerobatics] = ["rest", "aerobatics"].map((own) => off(own));
    is_near(rest, 0.2, 0.1, "the scale factor at rest");
    assert.ok(aerobatics > 300 && aerobatics > 1000 * rest, `${aerobatics} m`);
    is_near(off("rest", { ...none, "gyro.bias_deg_h": 1 }), 516, 0.01, "the bias at rest");
    is_near(off("aerobatics", { ...none, "gyro.bias_deg_h": 1 }), 115, 0.01, "the bias in aerobatics");
    const roll = flown("effects", { "flight.builtin": "aerobatics" }), angle = roll.of("truth_roll_rad");
    const rates = angle.map((own, k) => Math.abs(Math.asin(Math.sin(own - (angle[k - 1] ?? own)))) / (roll.time_s[1] - roll.time_s[0]));
    assert.ok(Math.max(...rates) > (100 * Math.PI) / 180);
});

test("what the lesson on the second order says is so: the lines part with the square of the errors", () => {
    const apart = (heading, bias) => {
        const own = flown("second_order", { "start.misalignment_arcmin[2]": heading, "gyro.bias_deg_h": bias });
        const model = ["east", "north"].map((axis) => own.of(`model_error_position_${axis}_m`));
        return { off_m: own.off_m.at(-1), most_m: Math.max(...own.east.map((east, k) => Math.hypot(east - model[0][k], own.north[k] - model[1][k]))) };
    };
    const one = apart(60, 0.1), two = apart(120, 0.2), small = apart(0, 0.01);
    is_near(one.off_m, 81e3, 0.01, "the error");
    is_near(one.most_m, 800, 0.02, "how far the lines are apart");
    is_near(two.most_m / one.most_m, 4, 0.02, "both errors twice as large");
    assert.ok(small.most_m < 0.002 * small.off_m, `${small.most_m} m of ${small.off_m} m`);
});

test("what the lesson on the box says is so: nothing lights up, a fix corrects the position alone", () => {
    const { at, off_m, of } = flown("unit"), end = (values) => flown("unit", values).off_m.at(-1);
    is_near(off_m.at(-1), 3400, 0.01, "the end");
    assert.ok(off_m[at(1199)] < 50 && off_m[at(1899)] > 2000 && off_m[at(1902)] < 50 && off_m[at(1960)] > 5 * off_m[at(1902)]);
    const sizes = [0, 0.1, 1, 5].map((size) => end({ "failure[0].size_deg_h": size })), fixes = [1600, 1750, 1900, 2100].map((at_s) => end({ "update[0].at_s": at_s }));
    assert.deepEqual(sizes, sizes.toSorted((a, b) => a - b));
    assert.deepEqual(fixes, fixes.toSorted((a, b) => b - a));
    flown("unit"); // the file of the scene as it is
    const [head, ...rows] = readFileSync(`${out}/flown/expected/unit_unit.csv`, "utf8").trim().split("\n").map((line) => line.split(","));
    const states = new Set(rows.map((row) => row[head.indexOf("state")]));
    assert.ok(states.has("navigation") && ![...states].some((own) => /fault|attitude/.test(own)), [...states].join());
    assert.ok(of("time_s").at(-1) > 2200);
});

test("a lesson that is not complete is not packed, and the fault names its file", async () => {
    const own = `${out}/lessons`, files = Object.fromEntries(["scene.toml", "lesson.toml", "en.md", "zh.md"].map((name) => [name, readFileSync(`${FOLDER}/schuler/${name}`, "utf8")]));
    const packed = (changes, name = "own") => {
        rmSync(own, { recursive: true, force: true });
        mkdirSync(`${own}/${name}`, { recursive: true });
        for (const [file, text] of Object.entries({ ...files, ...changes })) if (text !== null) writeFileSync(`${own}/${name}/${file}`, text);
        return lessons_of(own);
    };
    assert.equal(packed({})[0].mark.length, 2);
    const settings = files["lesson.toml"], words = files["en.md"];
    for (const [file, text, says] of [
        ["zh.md", null, /zh\.md: .*no such file/],
        ["scene.toml", null, /scene\.toml: .*no such file/],
        ["lesson.toml", null, /lesson\.toml: .*no such file/],
        ["lesson.toml", `${settings}colour = 1\n`, /lesson\.toml: line \d+: no such key: colour = 1/],
        ["lesson.toml", `toString = 1\n${settings}`, /no such key/],
        ["lesson.toml", `times = false\n${settings}`, /not a value of this key: times = false/],
        ["lesson.toml", `${settings}[[slide]]\n`, /no such list/],
        ["lesson.toml", `order = 2\n${settings}`, /a second time: order = 1/],
        ["lesson.toml", settings.replace('"position"', '"height"'), /not a value of this key: shows = "height"/],
        ["lesson.toml", settings.replace('"position"', "position"), /expected a text in quotes/],
        ["lesson.toml", settings.replace("values = [0, 0.5, 1, 1.5, 2]", 'values = ["a", ""]'), /not a value of this key/],
        ["lesson.toml", settings.replace("order = 1\n", ""), /expected order, shows/],
        ["lesson.toml", `beside = ["options.subsamples"]\n${settings}`, /not a value of this key: beside/],
        ["lesson.toml", settings.replace("at_s = 5064\n", ""), /\[\[mark\]\]: expected at_s, en, zh/],
        ["lesson.toml", settings.replace("values = [0, 0.5, 1, 1.5, 2]", "values = [0]"), /not a value of this key: values = \[0\]/],
        ["lesson.toml", settings.replace("values = [0, 0.5, 1, 1.5, 2]", 'values = [0, "x"]'), /not a value of this key/],
        ["en.md", words.slice(2), /en\.md: expected a heading/],
        ["en.md", "# Title\n\nQuestion?\n", /expected a question and at least one paragraph/],
        ["en.md", `${words}\n\n- a list\n`, /plain text: - a list/],
        ["en.md", `${words}\n\nSee [this](https://example.org).\n`, /plain text/],
        ["en.md", `${words}\n\n<b>bold</b>\n`, /plain text/],
    ]) assert.throws(() => packed({ [file]: text }), says);
    assert.throws(() => packed({}, "Own"), /expected a name of small letters/);
    const { load } = await import(pathToFileURL(resolve(SINS_MODULE))), sins = await load();
    assert.equal(read_by(sins, packed({})).length, 1);
    const beyond = packed({ "lesson.toml": settings.replace("0.02, 0.05]", "0.02, 1e9]") }), unknown = packed({ "lesson.toml": settings.replace("gyro.bias", "gyro.bais") });
    assert.throws(() => read_by(sins, beyond), /own\/lesson\.toml: gyro\.bias_deg_h\[0\] = 1e9: must be from/);
    assert.throws(() => read_by(sins, unknown), /own\/lesson\.toml: .*bais_deg_h/);
    const none = packed({ "lesson.toml": `beside = ["options.subsamples", 9]\n${settings}` });
    assert.throws(() => read_by(sins, none), /own\/lesson\.toml: options\.subsamples = 9/);
    const faulty = packed({ "scene.toml": files["scene.toml"].replace("latitude_deg", "latitud_deg") });
    assert.throws(() => read_by(sins, faulty), /^Error: own\/scene\.toml:7:1: no such key: latitud_deg; did you mean latitude_deg\?$/);
});
