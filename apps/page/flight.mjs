// A flight in a worker: a scene in flight, sample by sample, with the records of `sins fly`, and points for the curves.

import { Points, numbers_of } from "./points.mjs";

/** Samples between two looks at the clock. */
const STEPS = 64;
/** Length of a piece of the records in memory [letters]. */
const PIECE = 1 << 20;

export const FLYING = 0, PAUSED = 1, FINISHED = 2, STOPPED = 3, FAILED = 4; // in the order of the text "states"

/** The samples of a scene: computed by the library, or those of a log. */
export class Samples {
    constructor(sins, scene, log) {
        [this.sins, this.scene, this.flight] = [sins, scene, null];
        const { flight, rate_hz } = sins.scene_get_setup(scene);
        this.rate_hz = rate_hz;
        this.log = flight === sins.SCENE_FLIGHT_LOG ? log : null;
        const all = sins.scene_get_samples(scene, this.log);
        [this.count, this.record_every] = [Number(all.count), Number(all.record_every)];
        [this.start_s, this.period_s, this.duration_s] = [all.start_s, all.period_s, all.duration_s];
    }
    read(index, sample) {
        if (this.log) return void this.sins.log_get_sample(this.log, index, sample);
        this.flight ??= this.sins.scene_create_flight(this.scene);
        this.sins.flight_sample_at(this.flight, index / this.rate_hz, sample);
    }
    /** Where a sample is: its line in the log, or its time. */
    place(index) {
        return this.log ? { line: Number(this.sins.log_get_sample(this.log, index, new this.sins.flight_sample())) } : { time_s: index * this.period_s };
    }
    close() {
        this.flight?.close();
    }
}

/** Records at the first sample from each multiple of a time on, as in `sins fly`. */
class Spacing {
    constructor(every_s) {
        [this.every_s, this.next_s] = [every_s, every_s];
    }
    take(time_s, interval_s) {
        const latest_s = time_s + 0.1 * interval_s; // stamps of a log are rounded
        if (latest_s < this.next_s) return false;
        this.next_s = this.every_s * (Math.floor(latest_s / this.every_s) + 1);
        return true;
    }
}

export class Flight {
    /** log: the log of the scene, or null. pace: speed as a multiple of real time; 0: as fast as possible. */
    constructor(sins, text, log, pace) {
        this.sins = sins;
        this.scene = sins.scene_parse(text);
        const samples = (this.samples = new Samples(sins, this.scene, log));
        this.play = sins.play_create(this.scene, samples.log);
        this.sim = sins.play_get_simulator(this.play);
        this.is_as_planned = true;
        this.has_unit = sins.scene_get_value(this.scene, "unit.start") !== '"none"';
        [this.records, this.imu] = [sins.array(sins.record, 1), sins.array(sins.imu, 1)];
        this.numbers = numbers_of(this.imu);
        this.covariance = sins.scene_get_options(this.scene).covariance ? new sins.covariance() : null;
        const { every_s } = sins.scene_get_setup(this.scene);
        this.spacing = new Spacing(every_s > 0 ? every_s : samples.record_every * samples.period_s);
        [this.angles, this.velocities, this.ends] = ["angle_rad", "velocity_m_s"]
            .map((name) => ["measured", "ideal"].map((kind) => this.imu.offset(`${kind}_${name}`)))
            .concat([[this.imu.offset("time_s"), this.imu.offset("interval_s")]]);
        [this.sums, this.summed_s] = [new Float64Array(6), 0];
        this.points = new Points(this.records, this.imu, samples.count);
        [this.pieces, this.piece, this.next, this.state, this.fault, this.is_new] = [[], "", 0, FLYING, null, true];
        this.add_line(sins.record_line(null, null, this.covariance));
        this.set_pace(pace);
    }

    /** The time of the last sample since the start of the flight. */
    get time_s() {
        return this.next > 1 ? this.records_time() - this.samples.start_s : 0;
    }
    records_time() {
        return this.numbers()[this.ends[0]];
    }

    set_pace(pace) {
        [this.pace, this.paced_from_s, this.paced_at_ms] = [pace, this.next * this.samples.period_s, performance.now()];
    }
    pause(is_paused) {
        if (this.state === (is_paused ? FLYING : PAUSED)) this.state = is_paused ? PAUSED : FLYING;
        this.set_pace(this.pace);
    }
    stop() {
        if (this.state === FLYING || this.state === PAUSED) this.state = STOPPED;
    }

    /** Flies until a time of the clock. Returns in how many milliseconds the next sample is due. */
    advance(until_ms) {
        while (this.state === FLYING) {
            const now_ms = performance.now(), flown_ms = this.pace > 0 ? this.pace * (now_ms - this.paced_at_ms) : Infinity;
            const due = Math.min((this.paced_from_s + flown_ms / 1000) / this.samples.period_s, this.samples.count - 1);
            if (now_ms > until_ms) return 0;
            for (let k = 0; k < STEPS && this.state === FLYING; k++) {
                if (this.next > due) return Math.max(1, ((this.next - due) * this.samples.period_s * 1000) / this.pace);
                this.step();
            }
        }
        return Infinity;
    }

    /** Flies to the next sample. */
    step() {
        const { sins, play, sim, samples } = this, index = this.next;
        const is_last = index + 1 === samples.count;
        try {
            sins.play_next(play);
            this.next++;
            const is_due = index === 0 || this.add_interval();
            if (is_due || is_last) this.keep_record();
            if (index > 0 && this.points.is_due(index, is_last)) {
                sins.get_record(sim, this.records.at(0));
                this.points.add(samples.start_s, is_last);
            }
            if (is_last) this.state = FINISHED;
        } catch (error) {
            [this.state, this.fault] = [FAILED, fault_of(error, this.samples.place(index))];
        }
    }

    /** Adds the sensor errors of the last interval to their sums. Whether it has a record. */
    add_interval() {
        this.sins.get_imu(this.sim, this.imu.at(0));
        const numbers = this.numbers(), [angle, ideal_angle] = this.angles, [velocity, ideal_velocity] = this.velocities;
        for (let k = 0; k < 3; k++) {
            this.sums[k] += numbers[angle + k] - numbers[ideal_angle + k];
            this.sums[3 + k] += numbers[velocity + k] - numbers[ideal_velocity + k];
        }
        const interval_s = numbers[this.ends[1]];
        this.summed_s += interval_s;
        return this.spacing.take(numbers[this.ends[0]] - this.samples.start_s, interval_s);
    }

    keep_record() {
        const { sins, sim, summed_s } = this, record = this.records.at(0);
        sins.get_record(sim, record);
        const covariance = this.covariance && sins.get_covariance(sim, this.covariance) === sins.OK ? this.covariance : null;
        this.add_line(sins.record_line(record, summed_s > 0 ? this.sums.map((sum) => sum / summed_s) : null, covariance));
        this.sums.fill(0);
        this.summed_s = 0;
    }

    add_line(line) {
        this.piece += `${line}\n`;
        if (this.piece.length > PIECE) {
            this.pieces.push(new Blob([this.piece])); // the browser may keep it on its disk
            this.piece = "";
        }
    }

    /** The file of records so far. */
    file() {
        return new Blob([...this.pieces, this.piece], { type: "text/csv" });
    }

    /**
     * Takes over the planned failures or actions at the panel, which act from the next interval on: a new failure begins now at the
     * earliest. Returns the items, and whether a scene with them flies what was flown: a failure that has begun is not changed.
     */
    plan(list, items) {
        const { sins, scene, time_s } = this, past = items_of(sins, scene, list);
        sins.scene_set_items(scene, list, items);
        if (list === "failure") {
            const has_begun = (item) => time_s > 0 && Number(/^from_s = (\S+)/m.exec(item)?.[1] ?? 0) < time_s;
            const wanted = items_of(sins, scene, list);
            this.is_as_planned &&= past.every((item) => !has_begun(item) || wanted.includes(item));
            wanted.forEach((item, k) => has_begun(item) && !past.includes(item) && sins.scene_set_values(scene, `failure[${k}].from_s = ${time_s}`));
        }
        sins.play_set_plan(this.play, scene);
        return { items: items_of(sins, scene, list).join("\n"), is_as_planned: this.is_as_planned };
    }

    /** The instant now: for the instruments and the table of values. */
    status() {
        const { sins, play, sim, samples, state, fault, next, has_unit } = this;
        const now = { state, fault, time_s: this.time_s, duration_s: samples.duration_s, has_unit };
        if (next === 0 || state === FAILED) return now;
        const record = sins.get_record(sim);
        const accuracy = next > 1 ? sins.get_accuracy(sim)?.copy() : null;
        const [status, shown] = has_unit && next > 1 ? sins.play_get_shown(play) : [];
        return { ...now, record: record.copy(), accuracy, unit: status ? { status: status.copy(), shown: shown.copy() } : null };
    }

    close() {
        this.samples.close();
        for (const handle of [this.play, this.scene]) handle.close();
    }
}

/** The items of a list of a scene, as texts. */
export const items_of = (sins, scene, list) => all_of((k) => sins.scene_get_value(scene, `${list}[${k}]`));

/** What the library has at the places from 0 on: it fails behind the last one. */
export function all_of(read) {
    const all = [];
    try {
        for (;;) all.push(read(all.length));
    } catch {
        return all;
    }
}

/** An error in parts that another thread can tell in any language. */
export function fault_of(error, place = {}) {
    const info = error.info?.copy?.() ?? {};
    const sentence = error.message.replace(/^at \S+ s(, line \d+ of the log)?: /, ""); // where it was: place
    return { ...place, sentence, path: info.field, flags: info.flags, value: info.value, minimum: info.minimum, maximum: info.maximum };
}
