//! Each effect of gyros and accelerometers against its closed form, by the motions of a laboratory.

mod laboratory;
mod output;
mod size_effect;
mod whole;

use nalgebra::Vector3;
use sins::sensors::{Sensor, StreamKey, Triad, TriadParameters};
use sins::signal::Increment;

const EPS: f64 = f64::EPSILON;

fn triad(sensor: Sensor, parameters: &TriadParameters) -> Triad {
    parameters.validate(sensor).unwrap();
    let mut triad = Triad::new(StreamKey { seed: 11, run: 0 }, sensor);
    triad.set(parameters);
    triad
}

/// Increment at constant rate and force.
fn steady(rate: Vector3<f64>, force: Vector3<f64>, dt: f64) -> Increment {
    Increment { angle: rate * dt, velocity: force * dt }
}

/// Lengths of increments that jitter about `dt`.
fn jittering(dt: f64) -> impl Iterator<Item = f64> {
    (0..).map(move |k| dt * [1.0, 0.6, 1.3, 1.1, 0.7][k % 5])
}
