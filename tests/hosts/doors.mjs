// Every scene ends alike in Node and in the flight of the page: node doors.mjs FOLDER, a folder that apps/cli/tests/program/doors.rs has written.
// SINS_MODULE names sins.mjs. ends.txt: see doors.py.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { FINISHED, Flight } from "../../apps/page/flight.mjs";

const { load, SinsError } = await import(process.env.SINS_MODULE);
const sins = await load();
const folder = process.argv[2];

function words(numbers) {
    const bytes = new DataView(new ArrayBuffer(8));
    return [...numbers].map((number) => (bytes.setFloat64(0, number), bytes.getBigUint64(0).toString(16).padStart(16, "0")));
}
const errors = ({ position_enu_m, velocity_enu_m_s, misalignment_enu_rad }) =>
    words([...position_enu_m, ...velocity_enu_m_s, ...misalignment_enu_rad]);

function by_play(text, log) {
    const scene = sins.scene_parse(text), play = sins.play_create(scene, log);
    scene.close();
    try {
        while (sins.play_next(play) !== sins.PLAY_END);
        const [status, shown] = [new sins.unit_status(), new sins.unit_navigation()];
        sins.play_get_shown(play, status, shown);
        const { latitude_rad, longitude_rad, height_m, velocity_enu_m_s, roll_rad, pitch_rad, heading_rad } = shown;
        const place = [latitude_rad, longitude_rad, height_m];
        return errors(sins.get_errors(sins.play_get_simulator(play), sins.ERRORS_NAVIGATION))
            .concat(words([...place, ...velocity_enu_m_s, roll_rad, pitch_rad, heading_rad]), `${status.validity}`, `${status.state}`);
    } catch (error) {
        assert(error instanceof SinsError && error.message.includes("panel"), error.message);
        return ["stopped"];
    } finally {
        play.close();
    }
}

function by_page(text, log) {
    const flight = new Flight(sins, text, log, 0);
    try {
        flight.advance(Infinity);
        if (flight.state === FINISHED) return errors(flight.status().record.navigation_errors);
        assert.match(flight.fault.sentence, /panel/);
        return ["stopped"];
    } finally {
        flight.close();
    }
}

const doors = { play: by_play, "the page": by_page };
const lines = readFileSync(`${folder}/ends.txt`, "utf8").trim().split("\n");
for (const line of lines) {
    const [name, ...end] = line.split(" "), text = readFileSync(`${folder}/${name}.toml`, "utf8");
    for (const [door, fly] of Object.entries(doors)) {
        const scene = sins.scene_parse(text), path = `${folder}/${name}.csv`;
        const log = existsSync(path) ? sins.log_parse(readFileSync(path), scene)[0] : null;
        const found = fly(text, log);
        assert.deepEqual(found, end.slice(0, found.length), `${door}, ${name}`);
        log?.close();
        scene.close();
    }
}
assert(lines.length > 40);
console.log(`javascript: ${lines.length} scenes end alike through ${Object.keys(doors).join(", ")}`);
