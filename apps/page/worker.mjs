// The worker: the flight, the log, the path of a flight before it is flown, and measurements of accuracy and cost. A request has a
// number, and its answer has the same; the state of the flight comes without one.

import { load } from "sins";
import { measure, step_times } from "./measure.mjs";
import { band_of } from "./runs.mjs";
import { FAILED, Flight, FLYING, Samples, all_of, fault_of } from "./flight.mjs";

/** Length of a piece of work, between which messages are read [ms]. */
const PIECE_MS = 12;
/** Time between two reports: of the instant, and of the curves [ms]. */
const STATUS_MS = 66, CURVES_MS = 250;
/** Most points of a path before the flight. */
const PATH_POINTS = 10000;

export function serve() {
    let sins, log = null, flight = null, told_ms = 0, drawn_ms = 0, is_going = false, asked = 0;
    const turns = new MessageChannel();

    /** Reports the flight; whole: with the curves. */
    function tell(whole) {
        const curves = whole ? flight.points.copy() : null;
        const buffers = curves ? Object.values(curves).flat().map((column) => column.buffer) : [];
        told_ms = performance.now();
        if (whole) drawn_ms = told_ms;
        postMessage({ flight: status(), curves }, buffers);
    }

    /** The status, also of a flight whose solution cannot be read any more. */
    function status() {
        try {
            return flight.status();
        } catch (error) {
            [flight.state, flight.fault] = [FAILED, flight.fault ?? fault_of(error)];
            return flight.status();
        }
    }

    /** Flies a piece, and asks for the next turn, so that messages come through. */
    function go_on() {
        is_going = flight?.state === FLYING;
        if (!is_going) return;
        const wait_ms = flight.advance(performance.now() + PIECE_MS), now_ms = performance.now();
        const has_ended = flight.state !== FLYING;
        if (has_ended || now_ms - drawn_ms > CURVES_MS) tell(true);
        else if (now_ms - told_ms > STATUS_MS) tell(false);
        if (wait_ms === 0) turns.port2.postMessage(null);
        else if (has_ended) is_going = false;
        else setTimeout(go_on, Math.min(wait_ms, STATUS_MS));
    }
    turns.port1.onmessage = go_on;
    const begin = () => is_going || turns.port2.postMessage(null);

    function end() {
        flight?.close();
        flight = null;
    }

    const with_scene = (text, use) => {
        const scene = sins.scene_parse(text);
        try {
            return use(scene);
        } finally {
            scene.close();
        }
    };

    const answers = {
        async library({ module }) {
            sins = await load(module);
        },
        /** Reads a flight log from its file and those beside it, by the [log] of a scene; text: null for columns of the library's own names. */
        async log({ file, beside, text }) {
            const [bytes, ...others] = await Promise.all([file, ...beside].map((own) => own.arrayBuffer()));
            asked++;
            const joined = (scene) => {
                const names = all_of((k) => sins.scene_log_file_name(scene, k));
                beside.forEach(({ name }, k) => names.includes(name) && sins.scene_give_log_file(scene, name, others[k]));
                return sins.log_parse(bytes, scene);
            };
            const [parsed] = text ? with_scene(text, joined) : sins.log_parse(bytes, null);
            if (flight?.samples.log) end();
            log?.close();
            log = parsed;
            const { samples, duration_s } = sins.log_get_info(log);
            const options = text ? with_scene(text, (scene) => sins.scene_get_options(scene)) : null;
            return { samples: Number(samples), duration_s, findings: findings_of(sins, log, options) };
        },
        /** The path of a flight that is not flown yet. */
        path({ text }) {
            return with_scene(text, (scene) => {
                const samples = new Samples(sins, scene, log), sample = new sins.flight_sample(), points = [];
                const every = Math.floor(samples.count / PATH_POINTS) + 1;
                for (let k = 0; k < samples.count; k += every) {
                    samples.read(k, sample);
                    points.push([sample.latitude_rad, sample.longitude_rad, sample.height_m]);
                }
                samples.close();
                const place = [0, 1, 2].map((k) => Float64Array.from(points, (point) => point[k]));
                return { place, duration_s: samples.duration_s, period_s: samples.period_s };
            });
        },
        start({ text, pace }) {
            asked++;
            end();
            flight = new Flight(sins, text, log, pace);
            begin();
        },
        /** The band of many runs; null if another one or a flight was asked for before it was flown. */
        async band({ text }) {
            const own = ++asked, scene = sins.scene_parse(text);
            const rest = () => new Promise((done) => setTimeout(() => done(asked === own)));
            try {
                return await band_of(sins, scene, log, rest);
            } finally {
                scene.close();
            }
        },
        pace({ pace }) {
            flight?.set_pace(pace);
        },
        pause({ is_paused }) {
            flight?.pause(is_paused);
            if (flight) tell(true);
            begin();
        },
        stop() {
            flight?.stop();
            if (flight) tell(true);
        },
        /** Takes over a list of the scene in flight. */
        plan: ({ list, items }) => flight?.plan(list, items),
        /** An action at the panel, now: the item that it is in the scene. */
        act({ lines, items }) {
            const item = `[[panel]]\n${lines}at_s = ${flight.time_s}\n`;
            flight.plan("panel", items + item);
            return item;
        },
        /** The file of records. */
        records: () => flight?.file() ?? null,
        /** The error of the mechanization of a scene with other options, and its time. */
        measure: ({ text, options }) => with_scene(text, (scene) => measure(sins, scene, options)),
        step_times: ({ text }) => with_scene(text, (scene) => step_times(sins, scene)),
    };

    onmessage = async ({ data }) => {
        try {
            postMessage({ number: data.number, answer: await answers[data.do](data) });
        } catch (error) {
            postMessage({ number: data.number, fault: fault_of(error) });
        }
    };
}

/** What the judge finds in a log, with the Earth of these options: [{level, sentence}], the worst first. */
function findings_of(sins, log, options) {
    const judge = sins.judge_create(options);
    try {
        sins.judge_push_log(judge, log);
        const found = sins.array(sins.finding, sins.judge_get_findings(judge, null));
        if (found.length > 0) sins.judge_get_findings(judge, found);
        return Array.from({ length: found.length }, (_, k) => found.at(k).copy()).map(({ level, sentence }) => ({ level, sentence }));
    } finally {
        judge.close();
    }
}

/** The other side: a worker of the page. */
export class Colleague {
    constructor(address, module) {
        this.worker = new Worker(address);
        [this.requests, this.last] = [new Map(), 0];
        [this.on_flight, this.on_failure] = [() => {}, console.error];
        this.worker.onmessage = ({ data }) => {
            if (data.flight) return this.on_flight(data.flight, data.curves);
            const { done, failed } = this.requests.get(data.number);
            this.requests.delete(data.number);
            if (data.fault) failed(data.fault);
            else done(data.answer);
        };
        this.worker.onerror = (event) => this.on_failure(event.message ?? "the worker cannot be started");
        this.ask("library", { module }).catch((fault) => this.on_failure(fault.sentence));
    }
    /** Asks for something; the promise is rejected with a fault. */
    ask(what, values = {}) {
        const number = ++this.last;
        this.worker.postMessage({ do: what, number, ...values });
        return new Promise((done, failed) => this.requests.set(number, { done, failed }));
    }
}
