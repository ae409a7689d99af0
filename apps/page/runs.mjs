// Many runs of a scene, as `sins ensemble` flies them: between which errors all but the outermost runs are.

import { Samples } from "./flight.mjs";

/** Number of runs, most points of their band, and most samples of all runs. */
export const RUNS = 50;
const MOST_POINTS = 400, MOST_SAMPLES = 2e7;
/** Time between two looks for messages [ms]. */
const TURN_MS = 12;

/** The errors that have a band, by the names of their points. */
const ERRORS = { position2: "position_enu_m", velocity2: "velocity_enu_m_s", misalignment2: "misalignment_enu_rad" };

/**
 * The band of a scene: the times, and by the names of the errors [low, high] of each axis, without the lowest and the highest run. It ends
 * where a run diverges. rest(): called between pieces of the work, a promise of whether it is still wanted; if not, the band is null.
 */
export async function band_of(sins, scene, log, rest) {
    const samples = new Samples(sins, scene, log), sim = sins.scene_create_simulator(scene), ensemble = sins.ensemble_create(sim, 0, RUNS);
    try {
        if (samples.count * RUNS > MOST_SAMPLES) throw new Error("too_many_samples");
        const sample = new sins.flight_sample(), errors = sins.array(sins.errors, RUNS), every = Math.ceil(samples.count / MOST_POINTS);
        const names = Object.keys(ERRORS), band = { time: [], ...Object.fromEntries(names.map((name) => [name, [0, 1, 2].map(() => [[], []])])) };
        let until_ms = performance.now() + TURN_MS;
        for (let k = 0; k < samples.count; k++) {
            samples.read(k, sample);
            sins.scene_prepare_ensemble(scene, ensemble, samples.start_s, sample);
            sins.ensemble_push_sample(ensemble, sample);
            sins.ensemble_step(ensemble);
            if (k % every === 0 || k === samples.count - 1) {
                sins.ensemble_get_all_errors(ensemble, sins.ERRORS_NAVIGATION, errors);
                if (!add_point(sins, band, sample.time_s - samples.start_s, errors)) break;
            }
            if (performance.now() < until_ms) continue;
            if (!(await rest())) return null;
            until_ms = performance.now() + TURN_MS;
        }
        if (names.every((name) => band[name].every(([low, high]) => low.every((own, k) => own === high[k])))) throw new Error("nothing_random");
        return band;
    } finally {
        for (const handle of [ensemble, sim, samples]) handle.close();
    }
}

/** Adds the errors of all runs at a time. Whether each run has some. */
function add_point(sins, band, time_s, errors) {
    const runs = [...errors].map((own) => own.copy());
    if (runs.some(({ flags }) => flags & sins.ERRORS_NOT_COMPUTED)) return false;
    band.time.push(time_s);
    for (const [name, field] of Object.entries(ERRORS)) {
        band[name].forEach(([low, high], axis) => {
            const sorted = runs.map((own) => own[field][axis]).sort((a, b) => a - b);
            low.push(sorted[1]);
            high.push(sorted.at(-2));
        });
    }
    return true;
}
