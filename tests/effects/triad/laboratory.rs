//! The errors of a sensor that a rate table, tumbling, a centrifuge and a vibration table show.

use nalgebra::{Matrix3, Vector3};
use sins::sensors::{Sensor, TriadParameters};
use sins::signal::Increment;

use super::{EPS, steady, triad};
use crate::support::{DEG_PER_HOUR, G};

/// Rate table: scale factor asymmetry and nonlinearity show at both signs of the rate.
#[test]
fn rate_table() {
    let parameters = TriadParameters {
        scale_factor: Vector3::repeat(1e-4),
        scale_factor_asymmetry: Vector3::repeat(6e-5),
        scale_factor_nonlinearity: Vector3::repeat(2e-5),
        ..Default::default()
    };
    let mut gyro = triad(Sensor::Gyro, &parameters);
    for (rate, dt) in [(3.0, 0.01), (-3.0, 0.01), (0.5, 0.0025), (-0.5, 0.02), (0.0, 0.01)] {
        let sensed = gyro.sense(&steady(Vector3::repeat(rate), Vector3::zeros(), dt), dt).x;
        // Scale factor K w, half of the asymmetry on each side, nonlinearity c w |w|.
        let expected = rate + 1e-4 * rate + 3e-5 * f64::abs(rate) + 2e-5 * rate * f64::abs(rate);
        assert!((sensed - expected * dt).abs() <= 4.0 * EPS * f64::abs(rate) * dt, "{rate}: {sensed}");
    }
}

/// Tumbling: in six positions each column of the g-sensitivity shows with both signs, and the g² term with one.
#[test]
fn tumbling() {
    let g_sensitivity = Matrix3::new(1.0, -2.0, 3.0, -4.0, 5.0, -6.0, 7.0, -8.0, 9.0) * 1e-7;
    let mut gyro = triad(Sensor::Gyro, &TriadParameters { g_sensitivity, ..Default::default() });
    let rectification = Vector3::new(1.0, 2.0, -3.0) * 1e-6;
    let mut accel = triad(
        Sensor::Accelerometer,
        &TriadParameters { vibration_rectification_s2_m: rectification, ..Default::default() },
    );
    let (rate, dt) = (Vector3::new(1e-5, 2e-5, 3e-5), 0.01);
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let force = Vector3::ith(axis, sign * G);
            let ideal = steady(rate, force, dt);
            let drift = (gyro.sense(&ideal, dt) - ideal.angle) / dt;
            let expected = g_sensitivity.column(axis) * (sign * G);
            assert!((drift - expected).amax() < 4.0 * EPS * 1e-4, "{axis}: {drift:?}");
            assert!((gyro.steady_error(&rate, &force, None) - expected).amax() < 4.0 * EPS * 1e-4);
            let bias = (accel.sense(&ideal, dt) - ideal.velocity) / dt;
            let expected = Vector3::ith(axis, rectification[axis] * G * G);
            assert!((bias - expected).amax() < 8.0 * EPS * G, "{axis}: {bias:?}");
        }
    }
}

/// g²-sensitivity k [deg/h/g²]: on a centrifuge each gyro drifts by k f² of the force f along its own axis, with the same sign at
/// both signs of the force. A vibration of amplitude A about 1 g makes a drift of k (g² + A²/2); with ten increments in a period
/// the vibration's part is multiplied by (sin x / x)².
#[test]
fn g2_sensitivity_on_a_centrifuge_and_a_vibration_table() {
    let k = Vector3::new(0.5, -0.2, 2.0) * (DEG_PER_HOUR / (G * G));
    let parameters = TriadParameters { g2_sensitivity: k, ..Default::default() };
    let mut gyro = triad(Sensor::Gyro, &parameters);
    let (rate, dt) = (Vector3::new(1e-5, 2e-5, 3e-5), 0.004);
    for force in [Vector3::new(30.0, -20.0, 1.0) * G, Vector3::new(-30.0, 20.0, -1.0) * G] {
        let ideal = steady(rate, force, dt);
        let drift = (gyro.sense(&ideal, dt) - ideal.angle) / dt;
        let expected = Vector3::new(450.0, -80.0, 2.0) * DEG_PER_HOUR;
        // Roundings of the sum with the rate, and of squares.
        let bound = 4.0 * EPS * (rate.amax() + expected.amax());
        assert!((drift - expected).amax() < bound, "{drift:?} {expected:?}");
        assert!((gyro.steady_error(&rate, &force, None) - expected).amax() < bound);
    }

    let (amplitude, frequency, dt) = (50.0, 10.0, 0.01);
    let turn = 2.0 * std::f64::consts::PI * frequency;
    let integral = |t: f64| G * t - amplitude / turn * (turn * t).cos();
    let mut sum = Vector3::zeros();
    for i in 0..1000 {
        let increment = integral(f64::from(i + 1) * dt) - integral(f64::from(i) * dt);
        sum += gyro.sense(&Increment { velocity: Vector3::repeat(increment), ..Increment::ZERO }, dt);
    }
    let x = 0.5 * turn * dt;
    let expected = k * (G * G + 0.5 * amplitude * amplitude * (x.sin() / x).powi(2));
    // Rounding of the square of an increment of at most 0.6 m/s, which is a difference of integrals up to 100 m/s.
    let bound = k.amax() * 2.0 * 0.6 / dt * EPS * 100.0 / dt;
    assert!((sum / (1000.0 * dt) - expected).amax() < bound, "{sum:?} {expected:?}");
}

/// Centrifuge: 30 g along each accelerometer, in both directions.
#[test]
fn centrifuge() {
    let parameters = TriadParameters {
        scale_factor_nonlinearity: Vector3::repeat(1e-7),
        vibration_rectification_s2_m: Vector3::repeat(2e-7),
        ..Default::default()
    };
    let mut accel = triad(Sensor::Accelerometer, &parameters);
    for force in [30.0 * G, -30.0 * G] {
        let sensed = accel.sense(&steady(Vector3::zeros(), Vector3::repeat(force), 0.01), 0.01) / 0.01;
        let expected = force + 1e-7 * force * force.abs() + 2e-7 * force * force;
        assert!((sensed.z - expected).abs() < 4.0 * EPS * force.abs(), "{sensed:?}");
    }
}

/// Vibration of amplitude A about 1 g: the g² term makes a bias of k (g² + A²/2); with ten increments in a period the
/// vibration's part is multiplied by (sin x / x)².
#[test]
fn vibration_table() {
    let (amplitude, frequency, dt) = (50.0, 10.0, 0.01);
    let k = 1e-6;
    let parameters =
        TriadParameters { vibration_rectification_s2_m: Vector3::repeat(k), ..Default::default() };
    let mut accel = triad(Sensor::Accelerometer, &parameters);
    let turn = 2.0 * std::f64::consts::PI * frequency;
    let integral = |t: f64| G * t - amplitude / turn * (turn * t).cos();
    let n = 1000;
    let mut sum = 0.0;
    for i in 0..n {
        let increment = integral(f64::from(i + 1) * dt) - integral(f64::from(i) * dt);
        let ideal = Increment { velocity: Vector3::repeat(increment), ..Increment::ZERO };
        sum += accel.sense(&ideal, dt).z - increment;
    }
    let x = 0.5 * turn * dt;
    let seen = (x.sin() / x).powi(2);
    assert!((0.96..0.97).contains(&seen), "3 % less at ten increments a period");
    let bias = sum / (f64::from(n) * dt);
    let expected = k * (G * G + 0.5 * amplitude * amplitude * seen);
    // Each error is a difference of increments of 0.5 m/s, each increment is a difference of integrals up to 100 m/s.
    assert!((bias - expected).abs() < EPS * 100.0 / dt, "{bias} {expected}");
}

/// A vibration A sin Ωt in increments of dt, x = Ω dt/2: an effect that acts on the means of increments gets A sin x / x. Squares
/// lose 1 - (sin x / x)²; where the sign changes in the middle of an increment, the absolute value loses 1 - cos x. The vibration
/// is at a tenth of the sample rate, with two increments an interval and with one.
#[test]
fn what_acts_on_the_mean_of_an_increment_loses_of_a_vibration() {
    let (amplitude, turn) = (50.0, 20.0 * std::f64::consts::PI);
    for (per_period, of_square, of_size) in [(20, 0.0082, 0.0123), (10, 0.0325, 0.0489)] {
        let dt = 0.1 / f64::from(per_period);
        let x = 0.5 * turn * dt;
        // Excess of the accelerometers' output over half a period that begins at `start` [s].
        let error = |parameters: &TriadParameters, start: f64| -> f64 {
            let mut accel = triad(Sensor::Accelerometer, parameters);
            let integral = |t: f64| -amplitude / turn * (turn * t).cos();
            let increment = |i: i32| {
                let velocity = integral(start + f64::from(i + 1) * dt) - integral(start + f64::from(i) * dt);
                accel.sense(&Increment { velocity: Vector3::repeat(velocity), ..Increment::ZERO }, dt).x
                    - velocity
            };
            (0..per_period / 2).map(increment).sum()
        };
        let one = Vector3::repeat(1e-3);
        let nonlinear = TriadParameters { scale_factor_nonlinearity: one, ..Default::default() };
        let rectifying = TriadParameters { vibration_rectification_s2_m: one, ..Default::default() };
        let asymmetric = TriadParameters { scale_factor_asymmetry: one, ..Default::default() };
        // ∫ of s² and of |s|/2 over half a period.
        let square = 1e-3 * amplitude * amplitude * std::f64::consts::PI / (2.0 * turn);
        let size = 1e-3 * amplitude / turn;
        let seen = (x.sin() / x).powi(2);
        for parameters in [nonlinear, rectifying] {
            let found = error(&parameters, 0.0);
            assert!((found - square * seen).abs() < 100.0 * EPS * amplitude, "{found} {square}");
        }
        assert!(
            (error(&asymmetric, 0.0) - size).abs() < 100.0 * EPS * amplitude,
            "no sign changes within one"
        );
        let found = error(&asymmetric, 0.5 * dt);
        assert!((found - size * x.cos()).abs() < 100.0 * EPS * amplitude, "{found} {size}");
        assert!(
            (1.0 - seen - of_square).abs() < 1e-4 && (1.0 - x.cos() - of_size).abs() < 1e-4,
            "as the header has it"
        );
    }
}
