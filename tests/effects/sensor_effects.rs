//! Each effect of gyros and accelerometers against its closed form, on the motions of the laboratory: rate table, tumbling,
//! centrifuge, vibration, steps.

use crate::support::{DEG_PER_HOUR, G};
use nalgebra::{Matrix3, Vector3};
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
        // K w, half the difference to each side, c w |w|.
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

/// g²-sensitivity k [deg/h/g²]: on a centrifuge each gyro drifts by k f² of the force f along its own axis, with the same sign at both
/// signs of the force; a vibration of amplitude A about 1 g makes a drift of k (g² + A²/2), of which increments at ten a period see
/// the vibration's part times (sin x / x)².
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
    // Of an increment of at most 0.6 m/s as a difference of integrals up to 100 m/s, squared.
    let bound = k.amax() * 2.0 * 0.6 / dt * EPS * 100.0 / dt;
    assert!((sum / (1000.0 * dt) - expected).amax() < bound, "{sum:?} {expected:?}");
}

/// Centrifuge: 30 g along each accelerometer, and what arms to the arm's axis add.
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

/// Vibration of amplitude A about 1 g: the g² term makes a bias of k (g² + A²/2), of which increments at ten a period see
/// the vibration's part times (sin x / x)².
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
    // Each error is a difference of increments of 0.5 m/s, each of those one of integrals up to 100 m/s.
    assert!((bias - expected).abs() < EPS * 100.0 / dt, "{bias} {expected}");
}

/// A vibration A sin Ωt in increments of dt, x = Ω dt/2: what acts on their means sees A sin x / x, so that of squares
/// 1 - (sin x / x)² is lost, and where the sign changes in the middle of an increment 1 - cos x of the size. At a tenth of the sample
/// rate with two increments an interval, and with one.
#[test]
fn what_acts_on_the_mean_of_an_increment_loses_of_a_vibration() {
    let (amplitude, turn) = (50.0, 20.0 * std::f64::consts::PI);
    for (per_period, of_square, of_size) in [(20, 0.0082, 0.0123), (10, 0.0325, 0.0489)] {
        let dt = 0.1 / f64::from(per_period);
        let x = 0.5 * turn * dt;
        // Over half a period, and so many increments later: what the accelerometers give too much.
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

/// Three accelerometers, each somewhere else.
const ARMS: Matrix3<f64> = Matrix3::new(0.03, -0.01, 0.02, 0.01, 0.04, -0.02, -0.02, 0.01, 0.05);

/// A constant rate has no transient: from the first increment on ω×(ω×r), whatever the length of the increments.
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

/// Largest differences between what accelerometers x and y at the arm (r, 0, 0) integrate and the closed form, while the
/// angle about z is A sin Ωt: -r ∫ω² dt and r (ω(t) - ω of the first increment).
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
        // The first two ends come from fewer points.
        let tangential = (sum.y - r * (a * turn * (turn * t).cos() - first)).abs();
        largest_y = f64::max(largest_y, if k < 2 { 0.0 } else { tangential });
        if t > seconds {
            break;
        }
    }
    (largest_x, largest_y)
}

/// Rocking about z. The derivative of a cubic through the angle at 0, -h, -2h, -3h is wrong by h³θ''''/4 at the most: that
/// bounds the tangential velocity, at any time. The centripetal one has, an increment, d (h³ω'''/4 + h³ω'''/4)/12 of
/// that, and less than half as much of the curvature of ω; and once, of the first three increments, less than 3 h³ω'²/12.
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
    // Jittering: the four points span at most 0.01 times 1, 1.3 + 1.1, 1.3 + 1.1 + 0.7.
    let (_, y) = size_effect_of_rocking(jittering(0.01), seconds);
    assert!(y < r * a * turn.powi(4) / 24.0 * 0.013 * 0.024 * 0.031, "{y:e}");
}

/// A step at the bandwidth f: y = 1 - e^-st (cos st + sin st), s = √2 π f, and its integral, exactly at any increments.
#[test]
fn bandwidth_against_the_step_response() {
    let frequency = 5.0;
    let s = std::f64::consts::SQRT_2 * std::f64::consts::PI * frequency;
    for dt in [0.0025, 0.01, 0.02, 0.5] {
        let parameters = TriadParameters { bandwidth_hz: Vector3::repeat(frequency), ..Default::default() };
        let mut gyro = triad(Sensor::Gyro, &parameters);
        assert_eq!(gyro.sense(&Increment::ZERO, dt), Vector3::zeros());
        let (mut t, mut integral) = (0.0, 0.0);
        for dt in jittering(dt).take(100) {
            t += dt;
            integral += gyro.sense(&steady(Vector3::repeat(1.0), Vector3::zeros(), dt), dt).x;
            let expected = t - (1.0 - (-s * t).exp() * (s * t).cos()) / s;
            assert!((integral - expected).abs() < 100.0 * EPS * (t + 1.0), "{dt} {t}: {integral} {expected}");
        }
    }
}

/// -3 dB at the bandwidth with a quarter period of delay, 1/√(1 + 2⁴) at twice that; and a constant signal goes through from
/// the first increment on.
#[test]
fn bandwidth_against_the_frequency_response() {
    let (frequency, per_period) = (5.0, 1000);
    for (ratio, gain) in [(1.0, 0.5_f64.sqrt()), (2.0, 1.0 / 17.0_f64.sqrt()), (0.1, 1.0 / 1.0001_f64.sqrt())]
    {
        let turn = 2.0 * std::f64::consts::PI * frequency * ratio;
        let dt = 1.0 / (frequency * ratio * f64::from(per_period));
        let parameters = TriadParameters { bandwidth_hz: Vector3::repeat(frequency), ..Default::default() };
        let mut gyro = triad(Sensor::Gyro, &parameters);
        let (mut sine, mut cosine) = (0.0, 0.0);
        // Ten periods at twice the bandwidth and more leave e^-22 of the start.
        for k in 0..40 * per_period {
            let t = f64::from(k) * dt;
            let angle = ((turn * t).cos() - (turn * (t + dt)).cos()) / turn;
            let out = gyro.sense(&Increment { angle: Vector3::repeat(angle), ..Increment::ZERO }, dt).y;
            if k >= 39 * per_period {
                sine += out * (turn * (t + 0.5 * dt)).sin();
                cosine += out * (turn * (t + 0.5 * dt)).cos();
            }
        }
        let period = f64::from(per_period) * dt;
        let found = 2.0 * sine.hypot(cosine) / period;
        // Mean over an increment, held over it, mean again: sin x / x each; images of that go through the filter by 1e-7.
        let x = std::f64::consts::PI / f64::from(per_period);
        assert!((found / gain - (x.sin() / x).powi(3)).abs() < 1e-7, "{found}");
        if ratio == 1.0 {
            // A quarter period late; means held over their own increment are not late themselves.
            assert!(cosine < 0.0 && (sine / cosine).abs() < 1e-7, "{sine:e} {cosine:e}");
        }
    }
    let parameters = TriadParameters { bandwidth_hz: Vector3::repeat(frequency), ..Default::default() };
    let mut accel = triad(Sensor::Accelerometer, &parameters);
    for dt in jittering(0.01).take(20) {
        let ideal = steady(Vector3::zeros(), Vector3::new(0.0, 0.0, G), dt);
        assert!((accel.sense(&ideal, dt) - ideal.velocity).amax() < 4.0 * EPS * G / 20.0);
    }
}

/// The integral of a ramp is R t²/2 at any increments.
#[test]
fn a_ramp_does_not_depend_on_the_increments() {
    let slope = Vector3::new(1e-6, -2e-6, 0.0);
    for dt in [0.0025, 0.01, 0.02] {
        let mut gyro = triad(Sensor::Gyro, &TriadParameters { ramp: slope, ..Default::default() });
        let (mut t, mut sum) = (0.0, Vector3::zeros());
        for dt in jittering(dt).take(1000) {
            t += dt;
            sum += gyro.sense(&Increment::ZERO, dt);
        }
        assert!((sum - slope * (0.5 * t * t)).amax() < 1000.0 * EPS * 1e-6 * t * t, "{sum:?}");
        assert!(
            (gyro.steady_error(&Vector3::zeros(), &Vector3::zeros(), None) - slope * t).amax()
                < 1e-6 * t * 1000.0 * EPS
        );
    }
}

#[test]
fn dead_zone_and_range_of_a_swept_rate() {
    let parameters = TriadParameters {
        dead_zone: Vector3::new(0.1, 0.0, 0.3),
        range: Vector3::new(2.0, 1.0, 0.0),
        ..Default::default()
    };
    let mut gyro = triad(Sensor::Gyro, &parameters);
    let dt = 0.01;
    for step in -300..=300 {
        let rate = f64::from(step) / 100.0 + 0.005;
        let ideal = steady(Vector3::repeat(rate), Vector3::zeros(), dt);
        let sensed = gyro.sense(&ideal, dt);
        let expected = |dead: f64, range: f64| match rate.abs() {
            size if size <= dead => 0.0,
            size if size > range => range.copysign(rate) * dt,
            _ => ideal.angle.x,
        };
        assert_eq!(sensed, Vector3::new(expected(0.1, 2.0), expected(0.0, 1.0), expected(0.3, f64::MAX)));
        assert_eq!(gyro.take_saturated(), rate.abs() > 1.0, "{rate}");
        assert!(!gyro.take_saturated());
        let error = gyro.steady_error(&Vector3::repeat(rate), &Vector3::zeros(), None);
        assert!((error * dt - (sensed - ideal.angle)).amax() < 4.0 * EPS * rate.abs() * dt);
    }
}

/// Whole pulses, and never more than half a pulse lost of the integral: behind noise, at any increments.
#[test]
fn quantization_carries_what_is_left() {
    let pulse = 2.5e-6;
    let mut parameters = TriadParameters {
        random_walk: Vector3::repeat(1e-5),
        bias: Vector3::new(1e-5, -3e-4, 0.0),
        ..Default::default()
    };
    let mut plain = triad(Sensor::Gyro, &parameters);
    parameters.quantization = Vector3::repeat(pulse);
    let mut quantized = triad(Sensor::Gyro, &parameters);
    let mut lost = Vector3::zeros();
    let mut differing = 0;
    for dt in jittering(0.01).take(10_000) {
        let all = plain.sense(&Increment::ZERO, dt);
        let whole = quantized.sense(&Increment::ZERO, dt);
        for pulses in whole.iter().map(|angle| angle / pulse) {
            assert!((pulses - pulses.round()).abs() < 1e-9, "{pulses}");
        }
        lost += all - whole;
        assert!(lost.amax() < pulse * 0.500_001, "{lost:?}");
        differing += usize::from(lost.amax() > 0.25 * pulse);
    }
    assert!(differing > 1000, "it does something");
}

/// The order along the path of the signal, each pair of neighbours where it matters: exact numbers with one order only.
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
    // Scale-type errors of the same felt signal, not of each other: 2 (1 + 0.5) + 0.25 × 4 + 0.125 × 4 + 0.1 × 2/2.
    let parameters = TriadParameters {
        scale_factor: one * 0.5,
        scale_factor_nonlinearity: one * 0.25,
        vibration_rectification_s2_m: one * 0.125,
        scale_factor_asymmetry: one * 0.5,
        ..Default::default()
    };
    assert_eq!(sense(Sensor::Accelerometer, &parameters, force(2.0)).y, 3.0 + 1.0 + 0.5 + 0.5);
    // Bias behind them, and before the dead zone: 0.5 + 0.5 is within 1; 1.5 is not.
    let parameters =
        TriadParameters { bias: one * 0.5, dead_zone: one, scale_factor: one, ..Default::default() };
    assert_eq!(sense(Sensor::Accelerometer, &parameters, force(0.25)).z, 0.0);
    assert_eq!(sense(Sensor::Accelerometer, &parameters, force(0.5)).z, 1.5);
    // Range behind the bias, quantization behind the range: 3 + 0.5 is cut to 3.1, which is 10 pulses of 0.3.
    let parameters =
        TriadParameters { bias: one * 0.5, range: one * 3.1, quantization: one * 0.3, ..Default::default() };
    assert_eq!(sense(Sensor::Accelerometer, &parameters, force(3.0)).z, 10.0 * 0.3);
}

/// Four random effects at once are the sum of each alone; one that is switched off in flight leaves the draws of the others.
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
