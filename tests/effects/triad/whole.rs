//! A triad as a whole: an ideal one is transparent to the bit, effects act in the stated order, effects do not move each other's
//! draws, errors have the units of the parameters.

use nalgebra::{Matrix3, Vector3};
use sins::sensors::{Sensor, StreamKey, Triad, TriadParameters};
use sins::signal::Increment;

use super::{EPS, jittering, steady, triad};

const KEY: StreamKey = StreamKey { seed: 7, run: 3 };
const IDEAL: Increment =
    Increment { angle: Vector3::new(0.1, -0.2, -0.0), velocity: Vector3::new(0.3, -0.0, 9.8) };

fn noisy() -> TriadParameters {
    let ones = Vector3::repeat(1.0);
    TriadParameters { markov_sigma: ones, markov_time_s: ones, random_walk: ones, ..Default::default() }
}

#[test]
fn an_ideal_triad_is_transparent_to_the_bit() {
    let mut triad = Triad::new(KEY, Sensor::Gyro);
    triad.set(&TriadParameters::default());
    let measured = triad.sense(&IDEAL, 0.01);
    assert!(triad.is_ideal());
    assert_eq!(measured.map(f64::to_bits), IDEAL.angle.map(f64::to_bits));
}

#[test]
fn switching_an_effect_leaves_the_draws_of_the_others() {
    let dt = 0.01;
    let mut both = Triad::new(KEY, Sensor::Gyro);
    both.set(&noisy());
    let mut walk = Triad::new(KEY, Sensor::Gyro);
    walk.set(&TriadParameters { markov_sigma: Vector3::zeros(), ..noisy() });
    let mut markov = Triad::new(KEY, Sensor::Gyro);
    markov.set(&TriadParameters { random_walk: Vector3::zeros(), ..noisy() });
    let zero = Increment::ZERO;
    for step in 0..100 {
        if step == 50 {
            // In flight: the other process continues unchanged.
            both.set(&TriadParameters { random_walk: Vector3::zeros(), ..noisy() });
        }
        let sum = both.sense(&zero, dt);
        let mut parts = markov.sense(&zero, dt);
        if step < 50 {
            // The sum is formed in the order of the effects: Markov first.
            let noise = walk.sense(&zero, dt);
            parts += noise;
        }
        assert_eq!(sum, parts, "step {step}");
    }
}

#[test]
fn errors_are_in_the_units_of_the_parameters() {
    let mut triad = Triad::new(KEY, Sensor::Accelerometer);
    let mut parameters = TriadParameters { bias: Vector3::new(0.0, 0.5, 0.0), ..Default::default() };
    parameters.scale_factor.x = 1e-3;
    parameters.misalignment[(2, 0)] = 1e-4;
    triad.set(&parameters);
    let velocity = Vector3::new(2.0, 0.0, 0.0);
    let measured = triad.sense(&Increment { velocity, ..Increment::ZERO }, 0.01);
    assert_eq!(measured, Vector3::new(2.002, 0.005, 2e-4));
    let error = triad.steady_error(&Vector3::zeros(), &Vector3::new(200.0, 0.0, 0.0), None);
    assert_eq!(error, Vector3::new(0.2, 0.5, 0.02));
}

/// The order of the effects along the path of the signal: for each pair of neighbours only this order gives the exact numbers.
#[test]
fn effects_act_in_the_order_stated() {
    let one = Vector3::repeat(1.0);
    let sense =
        |sensor, parameters: &TriadParameters, ideal: Increment| triad(sensor, parameters).sense(&ideal, 1.0);
    let force = |f: f64| steady(Vector3::new(0.0, 0.0, 2.0), one * f, 1.0);
    // Size effect before scale factor: (1 - 4 × 0.5) × 1.5.
    let arms = Matrix3::new(0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    let parameters = TriadParameters { lever_arm_m: arms, scale_factor: one * 0.5, ..Default::default() };
    assert_eq!(sense(Sensor::Accelerometer, &parameters, force(1.0)).x, -1.5);
    // Scale-type errors multiply the same sensed signal, not each other: 2 (1 + 0.5) + 0.25 × 4 + 0.125 × 4 + 0.1 × 2/2.
    let parameters = TriadParameters {
        scale_factor: one * 0.5,
        scale_factor_nonlinearity: one * 0.25,
        vibration_rectification_s2_m: one * 0.125,
        scale_factor_asymmetry: one * 0.5,
        ..Default::default()
    };
    assert_eq!(sense(Sensor::Accelerometer, &parameters, force(2.0)).y, 3.0 + 1.0 + 0.5 + 0.5);
    // Bias after the scale-type errors and before the dead zone: 0.5 + 0.5 is within 1; 1.5 is not.
    let parameters =
        TriadParameters { bias: one * 0.5, dead_zone: one, scale_factor: one, ..Default::default() };
    assert_eq!(sense(Sensor::Accelerometer, &parameters, force(0.25)).z, 0.0);
    assert_eq!(sense(Sensor::Accelerometer, &parameters, force(0.5)).z, 1.5);
    // Range after the bias, quantization after the range: 3 + 0.5 is cut to 3.1, which is 10 pulses of 0.3.
    let parameters =
        TriadParameters { bias: one * 0.5, range: one * 3.1, quantization: one * 0.3, ..Default::default() };
    assert_eq!(sense(Sensor::Accelerometer, &parameters, force(3.0)).z, 10.0 * 0.3);
}

/// Four random effects together give the sum of each alone; one that is switched off in flight leaves the others' draws.
#[test]
fn random_effects_do_not_move_each_others_draws() {
    let ones = Vector3::repeat(1.0);
    let alone = [
        TriadParameters { markov_sigma: ones, markov_time_s: ones, ..Default::default() },
        TriadParameters { flicker: ones, ..Default::default() },
        TriadParameters { rate_random_walk: ones, ..Default::default() },
        TriadParameters { random_walk: ones, ..Default::default() },
    ];
    let all = TriadParameters {
        markov_sigma: ones,
        markov_time_s: ones,
        flicker: ones,
        rate_random_walk: ones,
        random_walk: ones,
        ..Default::default()
    };
    let without = [
        TriadParameters { markov_sigma: Vector3::zeros(), ..all },
        TriadParameters { flicker: Vector3::zeros(), ..all },
        TriadParameters { rate_random_walk: Vector3::zeros(), ..all },
        TriadParameters { random_walk: Vector3::zeros(), ..all },
    ];
    for (switched, without) in without.iter().enumerate() {
        let mut singles = alone.each_ref().map(|parameters| triad(Sensor::Gyro, parameters));
        let mut together = triad(Sensor::Gyro, &all);
        for (step, dt) in jittering(0.01).take(200).enumerate() {
            if step == 100 {
                together.set(without);
            }
            let sum: Vector3<f64> = singles
                .iter_mut()
                .enumerate()
                .map(|(k, single)| (k, single.sense(&Increment::ZERO, dt)))
                .filter(|&(k, _)| step < 100 || k != switched)
                .map(|(_, sensed)| sensed)
                .sum();
            let found = together.sense(&Increment::ZERO, dt);
            assert!((found - sum).amax() < 16.0 * EPS, "{switched} {step}: {found:?} {sum:?}");
        }
    }
}
