//! Sensor errors with a source.

use nalgebra::Vector3;

use super::parameters::TriadParameters;

/// The errors of the paper's simulation 2, gyros and accelerometers: constant drift 0.01 °/h and bias 1e-5 g, angle
/// random walk 0.005 °/√h, accelerometer white noise of 5e-6 g.
///
/// Departure: the paper gives the accelerometer noise without a bandwidth. It is read here as the standard deviation in a
/// band of 1 Hz, 5 µg/√Hz.
pub fn paper_simulation2() -> (TriadParameters, TriadParameters) {
    const DEG: f64 = core::f64::consts::PI / 180.0;
    const G: f64 = 9.80665;
    let gyro = TriadParameters {
        bias: Vector3::repeat(0.01 * DEG / 3600.0),
        random_walk: Vector3::repeat(0.005 * DEG / 60.0),
        ..Default::default()
    };
    let accel = TriadParameters {
        bias: Vector3::repeat(1e-5 * G),
        random_walk: Vector3::repeat(5e-6 * G),
        ..Default::default()
    };
    (gyro, accel)
}
