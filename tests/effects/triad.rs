//! A triad as a whole: ideal to the bit, draws that do not move each other, errors in the units of the parameters.

use nalgebra::Vector3;
use sins::sensors::{Sensor, StreamKey, Triad, TriadParameters};
use sins::signal::Increment;

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
            // In flight: the other process goes on as if nothing had happened.
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
