// The flights of tests/c/digests.c and tests/c/scene.h, by sins.mjs: the same calls, so the same bits.

const EVERY = 8;
const three = (value) => [value, value, value];

/** Fowler, Noll and Vo's 64-bit hash, in two halves of 32 bits, because bigint would be slow. */
function digest([high, low], bytes) {
    for (const byte of bytes) {
        low ^= byte;
        // times 2^40 + 0x1b3
        const product = (low >>> 0) * 0x1b3;
        high = (Math.imul(high, 0x1b3) + Math.floor(product / 2 ** 32) + (low << 8)) | 0;
        low = product | 0;
    }
    return [high, low];
}

export class Flights {
    constructor(sins) {
        this.sins = sins;
    }

    bytes(object) {
        const { numbers } = object; // of an array
        return new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength);
    }

    samples(flight, count, time_s) {
        const samples = this.sins.array(this.sins.flight_sample, count);
        for (let k = 0; k < count; k++) {
            this.sins.flight_sample_at(flight, time_s(k), samples.at(k));
        }
        flight.close();
        return samples;
    }

    /** Flies samples from number `first` on and digests the records. */
    run(hash, sim, samples, first, count) {
        const { sins } = this;
        const records = sins.array(sins.record, Math.floor((count - (first === 0)) / EVERY));
        const part = sins.array(sins.flight_sample, count);
        part.numbers.set(samples.numbers.subarray(first * samples.stride, (first + count) * samples.stride));
        if (sins.run(sim, part, EVERY, records) !== records.length) {
            throw new Error("another number of records");
        }
        return digest(hash, this.bytes(records));
    }

    /** Also digests the figures at the end; destroys the simulator. */
    fly_on(hash, sim, samples, first, count) {
        const { sins } = this;
        hash = this.run(hash, sim, samples, first, count);
        for (const [kind, read] of [[sins.accuracy, sins.get_accuracy], [sins.imu, sins.get_imu]]) {
            const figures = sins.array(kind, 1);
            read(sim, figures.at(0));
            hash = digest(hash, this.bytes(figures));
        }
        sim.close();
        return hash;
    }

    /** A roll, a loop, a steep turn. */
    scene_flight() {
        const { sins } = this;
        return sins.flight_create({ latitude_rad: 0.7, longitude_rad: 2, height_m: 3000, speed_m_s: 150 }, [
            { kind: sins.MANOEUVRE_ROLL, duration_s: 2, turns: 1 },
            { kind: sins.MANOEUVRE_TURN, heading_change_rad: 0.8, bank_rad: 1.2, ramp_s: 0.5 },
            { kind: sins.MANOEUVRE_LOOP, duration_s: 20, turns: 1, ramp_s: 1 },
        ]);
    }

    /** Every effect on. */
    scene_simulator(options) {
        const { sins } = this;
        const sim = sins.create(options);
        const misalignment_rad = [0, 1e-4, 0, 0, 0, 1e-4, 1e-4, 0, 0];
        const diagonal = (value) => [value, 0, 0, 0, value, 0, 0, 0, value];
        sins.set_gyro(sim, {
            bias_rad_s: three(1e-6),
            bias_sigma_rad_s: three(1e-6),
            markov_sigma_rad_s: three(1e-6),
            markov_time_s: three(10),
            random_walk_rad_sqrt_s: three(1e-5),
            rate_random_walk_rad_s_sqrt_s: three(1e-7),
            rate_ramp_rad_s2: three(1e-8),
            flicker_rad_s: three(1e-6),
            quantization_rad: three(1e-6),
            scale_factor: three(1e-4),
            scale_factor_asymmetry: three(1e-5),
            scale_factor_nonlinearity_s_rad: three(1e-5),
            misalignment_rad,
            g_sensitivity_rad_s_per_m_s2: diagonal(1e-7),
            range_rad_s: three(3),
            bandwidth_hz: three(40),
            dead_zone_rad_s: three(1e-6),
        });
        sins.set_accel(sim, {
            bias_m_s2: three(1e-3),
            bias_sigma_m_s2: three(1e-3),
            markov_sigma_m_s2: three(1e-3),
            markov_time_s: three(10),
            velocity_random_walk_m_s_sqrt_s: three(1e-3),
            acceleration_random_walk_m_s2_sqrt_s: three(1e-4),
            ramp_m_s3: three(1e-5),
            flicker_m_s2: three(1e-3),
            quantization_m_s: three(1e-4),
            scale_factor: three(1e-4),
            scale_factor_asymmetry: three(1e-5),
            scale_factor_nonlinearity_s2_m: three(1e-6),
            misalignment_rad,
            range_m_s2: three(25),
            bandwidth_hz: three(40),
            dead_zone_m_s2: three(1e-4),
            lever_arm_m: diagonal(0.1),
            vibration_rectification_s2_m: three(1e-6),
        });
        sins.set_altimeter(sim, { bias_m: 3, markov_sigma_m: 2, markov_time_s: 30, noise_m: 1, scale_factor: 1e-3, lag_s: 0.5 });
        sins.set_initial_errors(sim, {
            position_enu_m: three(10),
            position_sigma_enu_m: three(5),
            velocity_sigma_enu_m_s: three(0.1),
            misalignment_sigma_enu_rad: three(1e-3),
        });
        return sim;
    }

    own_options(seed) {
        const { sins } = this;
        return { error_model: sins.ERROR_MODEL_RK4, truth_summary: sins.SUMMARY_ON, covariance: sins.COVARIANCE_ON, seed };
    }

    simulation2() {
        const { sins } = this;
        const flight = sins.flight_create({ latitude_rad: 0.7, longitude_rad: 2, height_m: 8000, speed_m_s: 200 }, [
            {
                kind: sins.MANOEUVRE_SINUSOIDS,
                duration_s: 60,
                sinusoid_count: 6,
                channel: [0, 1, 2, 3, 4, 5],
                amplitude: [2.404825557695773, 0.02, 5, 0.004, 0.002, 0.002],
                frequency_hz: [0.0018, 0.0046, 0.007, 0.32, 0.43, 0.21],
            },
        ]);
        const sim = sins.create({ error_model: sins.ERROR_MODEL_RK4, seed: 20140601 });
        sins.set_gyro(sim, sins.gyro_preset(sins.GRADE_PAPER_SIMULATION2));
        sins.set_accel(sim, sins.accel_preset(sins.GRADE_PAPER_SIMULATION2));
        return [sim, this.samples(flight, 128 * 60 + 1, (k) => k / 128)];
    }

    /** Of each flight, its name and its digest. */
    *digests() {
        const { sins } = this;
        const begin = [0xcbf29ce4 | 0, 0x84222325 | 0];
        const named = (name, halves) => [name, halves.map((half) => (half >>> 0).toString(16).padStart(8, "0")).join("")];

        const [sim, patrol] = this.simulation2();
        yield named("simulation 2", this.fly_on(begin, sim, patrol, 0, patrol.length));

        const half = (patrol.length - 1) / 2, [saved] = this.simulation2(), thawed = sins.create(null);
        const hash = this.run(begin, saved, patrol, 0, half + 1);
        sins.snapshot_load(thawed, sins.snapshot(saved));
        yield named("snapshot replay", this.fly_on(hash, thawed, patrol, half + 1, half));

        const scene = this.samples(this.scene_flight(), 1025, (k) => k / 128);
        let all = begin;
        for (let i = 0; i < 30; i++) {
            const own = this.scene_simulator({
                frame: i % 2,
                scheme: Math.floor(i / 2) % 3,
                subsamples: 1 + (i % 5),
                updates_per_sample: 1 + (i % 2),
                vertical: Math.floor(i / 3) % 3,
                signal: Math.floor(i / 15),
                axes: Math.floor(i / 7) % 2,
                earth: i % 4,
                gravity: Math.floor(i / 4) % 2,
                error_model: sins.ERROR_MODEL_RK4,
                run: i,
            });
            all = this.fly_on(all, own, scene, 0, scene.length);
        }
        yield named("aerobatics, every effect", all);

        const over = sins.flight_create({ latitude_rad: 1.5706, longitude_rad: 0.5, height_m: 10000, speed_m_s: 250 }, [
            { kind: sins.MANOEUVRE_STRAIGHT, duration_s: 16 },
        ]);
        const pole = this.samples(over, 2049, (k) => k / 128);
        yield named("pole", this.fly_on(begin, this.scene_simulator(this.own_options(3)), pole, 0, pole.length));

        let state = 1;
        const jitter = this.samples(this.scene_flight(), 800, (k) => {
            state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
            return (10 * k + (k === 0 ? 0 : (state >>> 24) % 7)) / 1024;
        });
        for (let k = 200; k < 800; k++) {
            const sample = jitter.at(k);
            sample.flags = Math.floor(k / 200) % 2 ? sins.SAMPLE_NO_VELOCITY : 0;
            if (sample.flags) {
                sample.velocity_enu_m_s = three(0);
            }
        }
        yield named("jitter", this.fly_on(begin, this.scene_simulator(this.own_options(4)), jitter, 0, jitter.length));
    }
}
