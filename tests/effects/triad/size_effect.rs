//! Accelerometers that are not in one place: at constant rate and in a rocking block.

use nalgebra::{Matrix3, Vector3};
use sins::sensors::{Sensor, TriadParameters};
use sins::signal::Increment;

use super::{EPS, jittering, steady, triad};

/// Lever arms of three accelerometers, each at another place [m].
const ARMS: Matrix3<f64> = Matrix3::new(0.03, -0.01, 0.02, 0.01, 0.04, -0.02, -0.02, 0.01, 0.05);

/// A constant rate has no transient: the output is ω×(ω×r) from the first increment on, for any length of the increments.
#[test]
fn size_effect_at_constant_rate() {
    let mut accel =
        triad(Sensor::Accelerometer, &TriadParameters { lever_arm_m: ARMS, ..Default::default() });
    let rate = Vector3::new(1.0, -2.0, 3.0);
    let expected = Vector3::from_fn(|i, _| rate.cross(&rate.cross(&ARMS.row(i).transpose()))[i]);
    for dt in jittering(0.01).take(50) {
        let error = accel.sense(&steady(rate, Vector3::zeros(), dt), dt) / dt;
        // Differences of rates, rounded, over dt.
        assert!((error - expected).amax() < 20.0 * EPS * 3.0 * 0.05 / dt, "{error:?} {expected:?}");
    }
    assert!((accel.steady_error(&rate, &Vector3::zeros(), None) - expected).amax() < 4.0 * EPS * 14.0 * 0.05);
}

/// Largest differences between the closed form and what accelerometers x and y at the arm (r, 0, 0) integrate, while the
/// angle about z is A sin Ωt. The closed forms are -r ∫ω² dt and r (ω(t) - ω of the first increment).
fn size_effect_of_rocking(dts: impl Iterator<Item = f64>, seconds: f64) -> (f64, f64) {
    let (r, a, turn) = (0.1, 0.2, 6.0);
    let lever_arm_m = Matrix3::new(r, 0.0, 0.0, r, 0.0, 0.0, 0.0, 0.0, 0.0);
    let mut accel = triad(Sensor::Accelerometer, &TriadParameters { lever_arm_m, ..Default::default() });
    let (mut t, mut sum, mut first) = (0.0, Vector3::zeros(), None);
    let (mut largest_x, mut largest_y) = (0.0, 0.0);
    for (k, dt) in dts.enumerate() {
        let angle = a * ((turn * (t + dt)).sin() - (turn * t).sin());
        t += dt;
        let first = *first.get_or_insert(angle / dt);
        sum += accel.sense(&Increment { angle: Vector3::z() * angle, ..Increment::ZERO }, dt);
        let squares = 0.5 * (a * turn).powi(2) * (t + (2.0 * turn * t).sin() / (2.0 * turn));
        largest_x = f64::max(largest_x, (sum.x + r * squares).abs());
        // The rates at the first two ends are derived from fewer points.
        let tangential = (sum.y - r * (a * turn * (turn * t).cos() - first)).abs();
        largest_y = f64::max(largest_y, if k < 2 { 0.0 } else { tangential });
        if t > seconds {
            break;
        }
    }
    (largest_x, largest_y)
}

/// Rocking about z. The derivative of a cubic through the angle at 0, -h, -2h, -3h is wrong by h³θ''''/4 at the most: this bounds
/// the error of the tangential velocity at any time. The centripetal velocity errs in each increment by
/// d (h³ω'''/4 + h³ω'''/4)/12, and by less than half as much from the curvature of ω. The first three increments add less than
/// 3 h³ω'²/12, once.
#[test]
fn size_effect_of_rocking_is_of_third_order_and_does_not_accumulate() {
    let (r, a, turn) = (0.1, 0.2, 6.0_f64);
    let seconds = 20.0;
    for h in [0.02, 0.01, 0.005] {
        let (x, y) = size_effect_of_rocking(std::iter::repeat(h), seconds);
        let tangential = r * a * turn.powi(4) * h.powi(3) / 4.0;
        assert!(y < tangential, "{h}: {y:e} {tangential:e}");
        assert!(y > 0.5 * tangential, "the bound is met where the fourth derivative is largest: {y:e}");
        let rate_of_change = a * turn * turn;
        let centripetal = r * a * a * turn.powi(6) * h.powi(4) * (1.0 / 24.0 + 1.0 / 48.0) * seconds
            + r * h.powi(3) * rate_of_change * rate_of_change / 4.0;
        assert!(x < centripetal, "{h}: {x:e} {centripetal:e}");
    }
    // Jittering: the four points span at most 0.01 times 1.3, 1.3 + 1.1, 1.3 + 1.1 + 0.7.
    let (_, y) = size_effect_of_rocking(jittering(0.01), seconds);
    assert!(y < r * a * turn.powi(4) / 24.0 * 0.013 * 0.024 * 0.031, "{y:e}");
}
