// What accuracy costs: the scene's flight with ideal sensors and other options, its error and its time on this machine.

import { axes_of } from "./axis.mjs";

/** Longest piece of the flight [s]; most samples in memory. */
const LONGEST_S = 600, BATCH = 4096;
/** The flight is repeated until the steps took this time, and the least time counts: browsers optimise what runs for some time [ms]. */
const LEAST_MS = 200;
/** Most rounds of a flight of a few steps. */
const MOST_ROUNDS = 200;
/** Records in the piece, among which the largest error is looked for. */
const RECORDS = 200;
/** Pairs of samples at which a longer flight is searched for its hardest piece, and the time between the two [s]. */
const PAIRS = 20000, PAIR_S = 0.1;
/** Algorithm and rate for the error of the sensors, whatever those of the scene are. */
export const FINE = 'options.scheme = "polynomial"\noptions.subsamples = 4\nflight.rate_hz = 100\n';

/**
 * options: {scheme, subsamples, rate_hz}, or null for the sensors of the scene with an algorithm that adds no error of its own. Returns the
 * largest distance from the true flight [m], the time that a simulated second takes [us], and for how long was flown [s].
 */
export function measure(sins, own_scene, options) {
    const scene = sins.scene_parse(sins.scene_write(own_scene));
    if (options === null) sins.scene_set_values(scene, FINE);
    const rate_hz = options?.rate_hz ?? sins.scene_get_setup(scene).rate_hz, flight = sins.scene_create_flight(scene);
    const whole_s = sins.scene_get_setup(scene).flown_s, start_s = hardest_s(sins, flight, whole_s), flown_s = Math.min(whole_s, LONGEST_S), count = Math.floor(flown_s * rate_hz + 1e-6) + 1;
    const simulator = () => (options === null ? sins.scene_create_simulator(scene) : sins.create(options_of(sins, scene, options)));
    const every = Math.max(1, Math.floor((count - 1) / RECORDS)), records = sins.array(sins.record, Math.ceil(BATCH / every) + 1);
    let [error_m, least_ms, sum_ms] = [0, Infinity, 0];
    do {
        const sim = simulator(), round = fly(sins, sim, flight, { start_s, rate_hz, count, every, records });
        sim.close();
        error_m = round.error_m;
        least_ms = Math.min(least_ms, round.spent_ms);
        sum_ms += round.spent_ms;
    } while (options !== null && sum_ms < LEAST_MS);
    flight.close();
    scene.close();
    return { error_m, us_per_s: (1000 * least_ms) / ((count - 1) / rate_hz), flown_s: (count - 1) / rate_hz };
}

/** Where the piece of the flight begins that turns most, by the mean square of its rates [s]. */
function hardest_s(sins, flight, flown_s) {
    if (flown_s <= LONGEST_S) return 0;
    const every_s = (flown_s - PAIR_S) / (PAIRS - 1), sample = new sins.flight_sample(), sums = new Float64Array(PAIRS + 1);
    const axes_at = (time_s) => {
        sins.flight_sample_at(flight, time_s, sample);
        const { forward, up } = axes_of([sample.roll_rad, sample.pitch_rad, sample.heading_rad]);
        return [...forward, ...up];
    };
    for (let k = 0; k < PAIRS; k++) {
        const [before, behind] = [k * every_s, k * every_s + PAIR_S].map(axes_at);
        sums[k + 1] = sums[k] + before.reduce((sum, own, j) => sum + (behind[j] - own) ** 2, 0);
    }
    const wide = Math.max(1, Math.floor(LONGEST_S / every_s)), of = (k) => sums[k + wide] - sums[k];
    let best = 0;
    for (let k = 1; k + wide <= PAIRS; k++) if (of(k) > of(best)) best = k;
    // Errors grow after a motion: it stands as early in the piece as it can.
    const [most, latest] = [of(best), Math.min(best + wide, PAIRS - wide)];
    while (most > 0 && best < latest && of(best + 1) >= 0.99 * most) best++;
    return Math.min(best * every_s, flown_s - LONGEST_S);
}

/** What a step of a scene takes on this machine, and one of the same flight with ideal sensors [us]. */
export function step_times(sins, scene) {
    const { rate_hz, flown_s } = sins.scene_get_setup(scene), flight = sins.scene_create_flight(scene), count = Math.floor(Math.min(flown_s, LONGEST_S) * rate_hz + 1e-6) + 1;
    if (count < 2) return [];
    const made = [() => sins.scene_create_simulator(scene), () => sins.create(sins.scene_get_options(scene))], least_ms = [Infinity, Infinity], records = sins.array(sins.record, BATCH);
    for (let sum_ms = 0, round = 0; sum_ms < 2 * LEAST_MS && round < MOST_ROUNDS; round++) {
        for (const [k, make] of made.entries()) {
            const sim = make(), { spent_ms } = fly(sins, sim, flight, { start_s: 0, rate_hz, count, every: count, records });
            sim.close();
            [least_ms[k], sum_ms] = [Math.min(least_ms[k], spent_ms), sum_ms + spent_ms];
        }
    }
    flight.close();
    return least_ms.map((own) => (1000 * own) / (count - 1));
}

/** The options of a scene with another algorithm. Without the sensors, an error of the start and the error equations. */
function options_of(sins, scene, { scheme, subsamples, rate_hz }) {
    const own = sins.scene_get_options(scene);
    own.scheme = sins[`SCHEME_${scheme.toUpperCase()}`];
    own.subsamples = subsamples;
    own.sample_period_s = 1 / rate_hz;
    own.error_model = sins.ERROR_MODEL_OFF;
    own.covariance = sins.COVARIANCE_OFF;
    own.truth_summary = sins.SUMMARY_OFF;
    return own;
}

/** Flies once: samples are computed outside of the measured time, because a host has its own flight. */
function fly(sins, sim, flight, { start_s, rate_hz, count, every, records }) {
    const samples = sins.array(sins.flight_sample, Math.min(BATCH, count)), position = records.offset("navigation_errors.position_enu_m");
    let [error_m, spent_ms] = [0, 0];
    for (let first = 0; first < count; first += samples.length) {
        const some = Math.min(samples.length, count - first), part = some === samples.length ? samples : sins.array(sins.flight_sample, some);
        for (let k = 0; k < some; k++) sins.flight_sample_at(flight, start_s + (first + k) / rate_hz, part.at(k));
        const began_ms = performance.now(), written = sins.run(sim, part, every, records);
        spent_ms += performance.now() - began_ms;
        const { numbers, stride } = records;
        for (let k = 0; k < written; k++) error_m = Math.max(error_m, Math.hypot(...numbers.subarray(k * stride + position, k * stride + position + 3)));
    }
    return { error_m, spent_ms };
}
