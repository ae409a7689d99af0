//! From the signal to the output: bandwidth, ramp, dead zone, range, quantization.

use nalgebra::Vector3;
use sins::sensors::{Sensor, TriadParameters};
use sins::signal::Increment;

use super::{EPS, jittering, steady, triad};
use crate::support::G;

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

/// -3 dB at the bandwidth with a delay of a quarter period, 1/√(1 + 2⁴) at twice the bandwidth. A constant signal passes from
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
        // Mean over an increment, hold over it, mean again: a factor sin x / x each. The filter passes images of the hold by 1e-7.
        let x = std::f64::consts::PI / f64::from(per_period);
        assert!((found / gain - (x.sin() / x).powi(3)).abs() < 1e-7, "{found}");
        if ratio == 1.0 {
            // The output is a quarter period late; a mean held over its own increment adds no delay.
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

/// Output in whole pulses, with noise and at any increments: never more than half a pulse of the integral is missing.
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
