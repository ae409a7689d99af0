//! Errors that follow the temperature: closed forms, alignment, both error data, and samples without a temperature.

use nalgebra::Vector3;
use sins::earth::Geodetic;
use sins::earth::state::{BodyAxes, Navigation};
use sins::math::Euler;
use sins::sensors::{Alignment, InitialErrorParameters, Sensor, StreamKey, Triad, TriadParameters};
use sins::signal::Increment;
use sins::truth::FlightSample;
use sins::{ErrorKind, Options, Simulator};

use crate::support::{DEG, bits, options_at, resting_sample, sensed};

const EPS: f64 = f64::EPSILON;

/// All four coefficients on each axis, of the size of bad sensors.
fn thermal(scale: f64) -> TriadParameters {
    TriadParameters {
        reference_temperature_c: 25.0,
        bias_temperature: Vector3::new(1.0, -2.0, 0.5) * scale,
        bias_temperature2: Vector3::new(-0.02, 0.01, 0.03) * scale,
        scale_factor_temperature: Vector3::new(3e-5, -1e-5, 2e-5),
        scale_factor_temperature2: Vector3::new(1e-7, 2e-7, -3e-7),
        ..Default::default()
    }
}

/// A sample at rest at the temperature `temperature_c`.
fn warm(time_s: f64, temperature_c: f64) -> FlightSample {
    FlightSample { temperature_c: Some(temperature_c), ..resting_sample(time_s) }
}

/// Warm-up by 0.5 K/s from 20 °C at rest, at samples of any distance: the error increments are the integrals of b1 θ + b2 θ², and
/// of s1 θ + s2 θ² times the constant signal.
#[test]
fn a_warm_up_integrates_to_its_closed_form() {
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    simulator.set_gyro(&thermal(1e-6)).unwrap();
    simulator.set_accel(&thermal(1e-3)).unwrap();
    let theta = |time_s: f64| -5.0 + 0.5 * time_s;
    let times: Vec<f64> = (0..200).map(|k| 0.3 * f64::from(k) + 0.1 * f64::from(k % 3)).collect();
    let intervals = sensed(&mut simulator, times.iter().map(|&time_s| warm(time_s, 25.0 + theta(time_s))));
    assert_eq!(intervals.len(), 199);
    for (imu, ends) in intervals.iter().zip(times.windows(2)) {
        // ∫θ dt and ∫θ² dt of θ' = 1/2.
        let first = theta(ends[1]).powi(2) - theta(ends[0]).powi(2);
        let second = (theta(ends[1]).powi(3) - theta(ends[0]).powi(3)) / 1.5;
        for (ideal, measured, scale) in
            [(imu.ideal.angle, imu.measured.angle, 1e-6), (imu.ideal.velocity, imu.measured.velocity, 1e-3)]
        {
            let p = thermal(scale);
            let bias = p.bias_temperature * first + p.bias_temperature2 * second;
            let scale_factor = (p.scale_factor_temperature * first + p.scale_factor_temperature2 * second)
                .component_mul(&ideal)
                / imu.interval_s;
            let error = measured - ideal;
            // The measured sum is rounded, and second is a difference of cubes of up to 9e3 K³.
            let tolerance = 8.0 * EPS * (measured.amax() + 0.03 * scale * 9e3 + 2.0 * scale * 625.0);
            assert!((error - bias - scale_factor).amax() < tolerance, "{error:?} {bias:?} {scale_factor:?}");
        }
    }
}

/// Scale factor errors multiply the sensed signal, and all temperature errors act before the dead zone and the range:
/// 3 (1 + 0.5 × 2) + 0.25 × 2² = 7 is cut to 6.5, and 0.25 (1 + 1) - 0.5 gives 0.
#[test]
fn temperature_acts_in_its_place_in_the_order() {
    let one = Vector3::repeat(1.0);
    let sense = |parameters: &TriadParameters, sensed: f64| {
        let mut triad = Triad::new(StreamKey::default(), Sensor::Accelerometer);
        triad.set(parameters);
        triad.begin_interval(1.0, Some([12.0; 2]), None);
        triad.sense(&Increment { velocity: one * sensed, ..Increment::ZERO }, 1.0)
    };
    let thermal = TriadParameters {
        reference_temperature_c: 10.0,
        scale_factor_temperature: one * 0.5,
        bias_temperature2: one * 0.25,
        ..Default::default()
    };
    assert_eq!(sense(&thermal, 3.0), one * 7.0);
    assert_eq!(sense(&TriadParameters { range: one * 6.5, ..thermal }, 3.0), one * 6.5);
    // A second scale factor error also multiplies the sensed signal, not the result of the first.
    assert_eq!(sense(&TriadParameters { scale_factor: one, ..thermal }, 3.0), one * 10.0);
    let cold = TriadParameters { bias_temperature2: one * -0.125, dead_zone: one * 0.1, ..thermal };
    assert_eq!(sense(&cold, 0.25), Vector3::zeros());
}

/// Final bits of a run that is levelled and gyrocompassed with these errors, then a minute at rest at `temperature_c`.
fn a_minute(gyro: &TriadParameters, accel: &TriadParameters, temperature_c: Option<f64>) -> Vec<u64> {
    let options = Options { error_model: true, ..options_at(100.0) };
    let mut simulator = Simulator::new(&options).unwrap();
    simulator.set_gyro(gyro).unwrap();
    simulator.set_accel(accel).unwrap();
    let initial = InitialErrorParameters { alignment: Alignment::LevelAndGyrocompass, ..Default::default() };
    simulator.set_initial_errors(&initial).unwrap();
    let samples = (0..6000).map(|k| FlightSample { temperature_c, ..resting_sample(f64::from(k) / 100.0) });
    let first = sensed(&mut simulator, samples);
    assert_eq!(first.len(), 5999);
    bits(&simulator)
}

/// At a constant temperature, θ = 8 K, the errors equal a bias, or a scale factor error, in powers of two: alignment,
/// navigation and both error data are the same, to the bit.
#[test]
fn a_constant_temperature_is_a_bias_or_a_scale_factor_error() {
    let one = Vector3::repeat(1.0);
    let at = TriadParameters { reference_temperature_c: -10.0, ..Default::default() };
    for (first, second) in [(1.0, 0.0), (0.0, 0.125), (-3.0, 0.5)] {
        let warm_bias = |unit: f64| TriadParameters {
            bias_temperature: one * (first * unit),
            bias_temperature2: one * (second * unit),
            ..at
        };
        let bias = |unit: f64| TriadParameters {
            bias: one * (first * 8.0 + second * 64.0) * unit,
            ..Default::default()
        };
        let (of_gyros, of_accels) = (2.0_f64.powi(-28), 2.0_f64.powi(-16));
        assert_eq!(
            a_minute(&warm_bias(of_gyros), &warm_bias(of_accels), Some(-2.0)),
            a_minute(&bias(of_gyros), &bias(of_accels), None),
        );
        let unit = 2.0_f64.powi(-20);
        let warm_scale = TriadParameters {
            scale_factor_temperature: one * (first * unit),
            scale_factor_temperature2: one * (second * unit),
            ..at
        };
        let scale = TriadParameters {
            scale_factor: one * (first * 8.0 + second * 64.0) * unit,
            ..Default::default()
        };
        assert_eq!(a_minute(&warm_scale, &warm_scale, Some(-2.0)), a_minute(&scale, &scale, None));
    }
}

/// Without a coefficient a temperature has no effect; at the reference temperature the coefficients have none.
#[test]
fn no_coefficient_or_no_difference_changes_no_bit() {
    let ideal = TriadParameters::default();
    let plain = a_minute(&ideal, &ideal, None);
    assert_eq!(a_minute(&ideal, &ideal, Some(70.0)), plain);
    let reference = TriadParameters { reference_temperature_c: 25.0, ..ideal };
    assert_eq!(a_minute(&reference, &reference, None), plain);
    assert_eq!(a_minute(&thermal(1e-6), &thermal(1e-3), Some(25.0)), plain);
}

/// A coefficient is never without a temperature: a call that would set one without is refused and changes nothing.
#[test]
fn samples_without_a_temperature_are_refused_while_coefficients_are_set() {
    let missing = "sample.temperature_c: is needed while temperature coefficients are set";
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    simulator.set_accel(&thermal(1e-3)).unwrap();
    let refused = simulator.push_sample(&resting_sample(0.0)).unwrap_err();
    assert_eq!((refused.kind, refused.to_string().as_str()), (ErrorKind::InvalidArgument, missing));
    assert_eq!(simulator.waiting_samples(), 0);
    assert_eq!(simulator.reposition(&resting_sample(0.0)).unwrap_err().to_string(), missing);
    assert_eq!(sensed(&mut simulator, (0..3).map(|k| warm(f64::from(k), 20.0))).len(), 2);
    assert!(simulator.push_sample(&resting_sample(3.0)).is_err());
    simulator.set_accel(&TriadParameters::default()).unwrap();
    simulator.push_sample(&resting_sample(3.0)).unwrap();

    // The waiting sample has no temperature.
    assert_eq!(simulator.set_gyro(&thermal(1e-6)).unwrap_err().kind, ErrorKind::BadState);
    simulator.step().unwrap();
    // Now the first interval has a temperature only at its end: this temperature holds throughout.
    simulator
        .set_gyro(&TriadParameters { scale_factor_temperature: Vector3::zeros(), ..thermal(1e-6) })
        .unwrap();
    let imu = sensed(&mut simulator, [warm(4.0, 35.0)])[0];
    let drift = (imu.measured.angle.x - imu.ideal.angle.x) / imu.interval_s;
    assert!((drift - (10.0 - 2.0) * 1e-6).abs() < 4.0 * EPS * 1e-5, "{drift:e}");

    let mut navigator = Simulator::new(&Options::default()).unwrap();
    let place = Geodetic { latitude_rad: 39.9 * DEG, longitude_rad: 0.0, height_m: 0.0 };
    let q_nb = sins::math::attitude_from_euler(&Euler::default());
    let start = Navigation::new(place, Vector3::zeros(), q_nb, BodyAxes::default());
    navigator.set_gyro(&thermal(1e-6)).unwrap();
    assert_eq!(navigator.start_navigation(0.0, &start).unwrap_err().kind, ErrorKind::BadState);
    navigator.set_gyro(&TriadParameters::default()).unwrap();
    navigator.start_navigation(0.0, &start).unwrap();
    assert_eq!(navigator.set_gyro(&thermal(1e-6)).unwrap_err().kind, ErrorKind::BadState);
}

#[test]
fn temperatures_have_a_range() {
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    for (temperature_c, sentence) in [
        (-274.0, "sample.temperature_c = -274: must be from -273.15 to 1000"),
        (1001.0, "sample.temperature_c = 1001: must be from -273.15 to 1000"),
        (f64::NAN, "sample.temperature_c = NaN: must be a finite number"),
    ] {
        assert_eq!(simulator.push_sample(&warm(0.0, temperature_c)).unwrap_err().to_string(), sentence);
    }
    let with = |change: fn(&mut TriadParameters)| {
        let mut parameters = TriadParameters::default();
        change(&mut parameters);
        parameters
    };
    for (parameters, sentence) in [
        (
            with(|p| p.reference_temperature_c = -300.0),
            "gyro.reference_temperature_c = -300: must be from -273.15 to 1000",
        ),
        (
            with(|p| p.bias_temperature.y = 101.0),
            "gyro.bias_temperature_rad_s_per_k[1] = 101: must be from -100 to 100",
        ),
        (
            with(|p| p.bias_temperature2.z = -101.0),
            "gyro.bias_temperature2_rad_s_per_k2[2] = -101: must be from -100 to 100",
        ),
        (
            with(|p| p.scale_factor_temperature.x = 2.0),
            "gyro.scale_factor_temperature_per_k[0] = 2: must be from -1 to 1",
        ),
        (
            with(|p| p.scale_factor_temperature2.x = f64::INFINITY),
            "gyro.scale_factor_temperature2_per_k2[0] = inf: must be a finite number",
        ),
    ] {
        assert_eq!(simulator.set_gyro(&parameters).unwrap_err().to_string(), sentence);
    }
}
