// sins.mjs compared with the header, and its behaviour: node --test. Needs SINS_MODULE: see tests/hosts.sh.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";

const { load, SinsError } = await import(process.env.SINS_MODULE);
const sins = await load();
const header = readFileSync("include/sins_functions.h", "utf8");
const DRIFT = 0.01 * sins.DEG_PER_HOUR;

function sample(fields = {}) {
    return new sins.flight_sample({ latitude_rad: 39.9 * sins.DEG, ...fields });
}

/** What a call throws. */
function thrown(call) {
    try {
        call();
    } catch (error) {
        return error;
    }
    throw new Error("nothing was thrown");
}

const refuses = (call, sentence) => assert.equal(thrown(call).message, sentence);

test("the module has every function of the header but those of identify, with its arguments but those that it returns", () => {
    const all = [...header.matchAll(/X\([^,]+, sins_(\w+), \((.*)\)\)/g)], has = (row) => !row[1].startsWith("identify_");
    const rows = all.filter(has);
    assert.ok(all.filter((row) => !has(row)).every(([, name]) => !(name in sins)));
    assert.ok(rows.length > 120);
    for (const [, name, list] of rows) {
        assert.equal(typeof sins[name], "function", name);
        const declared = list === "void" ? [] : list.split(", ");
        const name_of = (one) => one.match(/\w+$/)[0];
        const told = /^\w*\(?([^)]*)\)/.exec(sins[name].toString())[1].split(", ").filter(Boolean);
        assert.deepEqual(told, declared.map(name_of).filter((one) => told.includes(one)), name);
        // What the call writes: a handle, a number, a text with its size. The size of an array follows its pointer.
        const left = declared.filter((one) => !told.includes(name_of(one)));
        const written = /^(\w+ \*|(char|double|size_t|u?int\d\d_t) )\*\w+$/;
        const is_size = (one) => /^size_t \w+$/.test(one) && declared[declared.indexOf(one) - 1].includes("*");
        assert.ok(left.every((one) => written.test(one) || is_size(one)), `${name}: ${left}`);
    }
});

test("an hour of drift, in a few calls", () => {
    const sim = sins.create(null), at = sample();
    assert.equal(sins.get_errors(sim, sins.ERRORS_NAVIGATION), null);
    assert.equal(sins.last_status, sins.NEED_SAMPLE);
    sins.set_gyro(sim, { bias_rad_s: [DRIFT, 0, 0] });
    for (at.time_s = 0; at.time_s <= 3600; at.time_s++) {
        sins.push_sample(sim, at);
        sins.step(sim);
    }
    const errors = sins.get_errors(sim, sins.ERRORS_NAVIGATION);
    assert.equal(errors.position_enu_m[0].toFixed(), "-145");
    const place = new sins.errors();
    assert.equal(sins.get_errors(sim, sins.ERRORS_NAVIGATION, place), sins.OK);
    assert.deepEqual(place.copy(), errors.copy());
    sim.close();
    refuses(() => sins.step(sim), "SINS_ERROR_BAD_HANDLE");
});

test("an error names field, value and limit, in a sentence and in its parts", () => {
    const sim = sins.create(null);
    const error = thrown(() => sins.set_gyro(sim, { bias_rad_s: [0, 1e9, 0] }));
    assert.ok(error instanceof SinsError);
    assert.equal(error.message, "gyro.bias_rad_s[1] = 1e9: must be from -100 to 100");
    assert.equal(error.status, sins.ERROR_INVALID_ARGUMENT);
    assert.deepEqual([error.info.field, error.info.index, error.info.maximum], ["gyro.bias_rad_s", 1n, 100]);
});

test("wrong arguments and fields are named before the call", () => {
    const sim = sins.create(null), gyro = new sins.gyro_params();
    const INT32 = "must be a whole number from -2147483648 to 2147483647";
    refuses(() => sins.step({}), "sim = {...}: must be a sim of this instance of the library");
    refuses(() => sins.flight_duration(sim), "flight = [object Object]: must be a flight of this instance of the library");
    refuses(() => sins.get_errors(sim, 1.5), `source = 1.5: ${INT32}`);
    refuses(() => sins.get_errors(sim), `source = undefined: ${INT32}`);
    refuses(() => sins.move_time(sim, "1"), 'time_s = "1": must be a number');
    refuses(() => sins.scene_create_builtin("a\0b"), 'name = "a\\u0000b": must be a text without a zero');
    refuses(() => sins.set_gyro(sim, 3), "params = 3: must be a gyro_params");
    refuses(() => sins.run(sim, [{ time: 0 }], 1, null), "flight_sample has no field time");
    refuses(() => sins.run(sim, [], 1, [{}]), "records = [object Object]: must be an array as sins.array(sins.record, count) makes it");
    refuses(() => sins.snapshot_save(sim, new Uint8Array(8)), "buffer = 0,0,0,0,0,0,0,0: must be bytes as sins.bytes(count) makes them");
    refuses(() => { gyro.bias_rad_s = [1, 2]; }, "gyro_params.bias_rad_s = 1,2: must be 3 numbers");
    refuses(() => { gyro.markov_time_s = [1, "2", 3]; }, 'gyro_params.markov_time_s[1] = "2": must be a number');
    refuses(() => { new sins.options().seed = -1; }, "options.seed = -1: must be a whole number from 0 to 18446744073709551615");
    refuses(() => { gyro.bias = 1; }, "Cannot add property bias, object is not extensible");
    refuses(() => new sins.options({ schema: 1 }), "options has no field schema");
    refuses(() => sins.array(sins.record, 1).at(1), "index = 1: must be from 0 to 0");
    refuses(() => sins.array(sins.record, 1).offset("truth.lat"), 'path = "truth.lat": record_solution has no lat');
});

test("a handle of another instance is refused, although its key may be the same", async () => {
    const other = await load();
    refuses(() => other.step(sins.create(null)), "sim = [object Object]: must be a sim of this instance of the library");
});

test("arrays are the memory that the library reads and writes", () => {
    const samples = sins.array(sins.flight_sample, 101), records = sins.array(sins.record, 10), sim = sins.create(null);
    sins.set_gyro(sim, { bias_rad_s: [DRIFT, 0, 0] });
    const { numbers, stride } = samples, time = samples.offset("time_s");
    for (let k = 0; k < samples.length; k++) {
        numbers[k * stride + time] = k;
    }
    const errors = records.numbers, north = records.offset("navigation_errors.position_enu_m") + 1;
    assert.equal(sins.run(sim, samples, 10, records), 10);
    assert.equal(errors[9 * records.stride + north], records.at(-1).navigation_errors.position_enu_m[1]);
    assert.notEqual(errors[9 * records.stride + north], 0);
    assert.deepEqual(Array.from(records, (one) => one.time_s), [10, 20, 30, 40, 50, 60, 70, 80, 90, 100]);
});

test("a view is empty after the memory has moved, and its struct is as before", () => {
    const gyro = new sins.gyro_params({ bias_rad_s: [1, 2, 3] }), view = gyro.bias_rad_s;
    const large = sins.bytes(64 << 20);
    assert.equal(large.length, 64 << 20);
    assert.equal(view.length, 0);
    assert.deepEqual([...gyro.bias_rad_s], [1, 2, 3]);
});

test("structs and handles that are dropped are given back", async () => {
    const before = process.memoryUsage().external;
    for (let round = 0; round < 400; round++) {
        for (let k = 0; k < 100; k++) {
            new sins.statistics();
            sins.create(null); // 4096 at a time
        }
        globalThis.gc();
        await new Promise((done) => setTimeout(done)); // finalizers are tasks
    }
    assert.ok(process.memoryUsage().external - before < 100e6);
});

test("a play owns the simulator and the unit that it lends", async () => {
    const scene = sins.scene_create_builtin("patrol"), play = sins.play_create(scene, null);
    sins.play_get_simulator(play).close();
    for (let round = 0; round < 3; round++) {
        for (let k = 0; k < 100; k++) assert.ok(sins.get_options(sins.play_get_simulator(play)).subsamples > 0);
        globalThis.gc();
        await new Promise((done) => setTimeout(done));
        assert.equal(sins.play_next(play), sins.OK);
    }
    const sim = sins.play_get_simulator(play);
    play.close();
    refuses(() => sins.step(sim), "SINS_ERROR_BAD_HANDLE");
});

test("texts of any length, and bytes", () => {
    const scene = sins.scene_parse(`[flight]\ntitle = "${"飞".repeat(1000)}"\nbuiltin = "patrol"\n`);
    assert.equal(sins.last_status, sins.OK);
    assert.equal(sins.scene_get_text(scene, sins.SCENE_TEXT_TITLE), "飞".repeat(1000));
    assert.equal(sins.scene_write(sins.scene_parse(sins.scene_write(scene))), sins.scene_write(scene));
    const faulty = sins.scene_parse("[flight]\nbuiltin = \"rest\"\n[gyro]\nbais_deg_h = 1\n");
    assert.equal(sins.last_status, sins.SCENE_HAS_FAULTS);
    const fault = sins.scene_get_fault(faulty, 0);
    assert.deepEqual([fault.line, fault.column, fault.sentence], [4n, 1n, "no such key: bais_deg_h; did you mean bias_deg_h?"]);
    const long = `${`# ${"x".repeat(1000)}\n`.repeat(5000)}time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n0,1,1,1,1,1,1\n1,1,1,1,1,1,1\n`;
    const [log] = sins.log_parse(new TextEncoder().encode(long), null);
    const [at, line] = sins.log_get_sample(log, 1);
    assert.deepEqual([at.time_s, line], [1, 5003n]);
    assert.match(thrown(() => sins.log_parse("a,b\n", null)).message, /^line = 1, column 1: missing columns: time_s/);
});

test("a record is a line of the program's files", () => {
    const names = sins.record_line(null, null, null).split(",");
    const record = new sins.record({ time_s: 0.1, navigation: { height_m: -3 } });
    const line = sins.record_line(record, [1, 2, 3, 4, 5, 6], null).split(",");
    assert.equal(line.length, names.length);
    const of = (name) => line[names.indexOf(name)];
    const errors = ["x", "y", "z"].map((axis) => [of(`gyro_error_${axis}_rad_s`), of(`accel_error_${axis}_m_s2`)]);
    assert.deepEqual([of("time_s"), of("navigation_height_m"), errors], ["0.1", "-3", [["1", "4"], ["2", "5"], ["3", "6"]]]);
});

test("a defect ends the instance, and another one is not touched", async () => {
    // An address outside of the memory: the module traps, as it does in a panic.
    const own = await load();
    const sim = own.create(null), gyro = new own.gyro_params();
    const [address] = Object.getOwnPropertySymbols(gyro).filter((one) => one.description === "address");
    gyro[address] = 0xffff0000;
    const error = thrown(() => own.set_gyro(sim, gyro));
    assert.equal(error.status, own.ERROR_INTERNAL);
    assert.match(error.message, /^a defect of the library \(.*\): load it again$/);
    assert.equal(thrown(() => own.step(sim)), error);
    assert.equal(sins.step(sins.create(null)), sins.NEED_SAMPLE);
});

test("what cannot be loaded is named", async () => {
    await assert.rejects(load(new Uint8Array([1, 2, 3])), WebAssembly.CompileError);
    await assert.rejects(load("/no/such.wasm"), { code: "ENOENT" });
});
