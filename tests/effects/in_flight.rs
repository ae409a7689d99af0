//! The effects of gyros and accelerometers in a simulator: both error data, alignment, saturation, reset, reposition, and
//! sensors that make the solution diverge.

use nalgebra::{Matrix3, Vector3};
use sins::math::Euler;
use sins::sensors::{Alignment, InitialErrorParameters, TriadParameters};
use sins::signal::Increment;
use sins::truth::FlightSample;
use sins::{ErrorKind, ErrorSource, ImuInterval, Options, Simulator};

use crate::support::{DEG, DEG_PER_HOUR, G, options_at, patrol, resting_sample, sensed};

/// Effects of the size of good instruments; the ranges are beyond the signals of the flight.
fn every_effect() -> (TriadParameters, TriadParameters) {
    let one = Vector3::repeat(1.0);
    let gyro = TriadParameters {
        bias_sigma: one * 0.01 * DEG_PER_HOUR,
        random_walk: one * 1e-6,
        rate_random_walk: one * 1e-10,
        ramp: Vector3::new(1.0, -1.0, 0.5) * 1e-11,
        flicker: one * 3e-8,
        quantization: one * 1e-6,
        scale_factor: one * 1e-5,
        scale_factor_asymmetry: one * 1e-5,
        scale_factor_nonlinearity: one * 1e-5,
        g_sensitivity: Matrix3::new(1.0, -2.0, 3.0, 2.0, 1.0, -1.0, 0.5, 0.3, 1.0) * 1e-9,
        bandwidth_hz: one * 200.0,
        range: one * 10.0,
        ..Default::default()
    };
    let accel = TriadParameters {
        bias_sigma: one * 1e-5 * G,
        random_walk: one * 1e-5,
        rate_random_walk: one * 1e-7,
        ramp: Vector3::new(1.0, -1.0, 0.5) * 1e-8,
        flicker: one * 1e-5,
        quantization: one * 1e-5,
        scale_factor_asymmetry: one * 1e-5,
        scale_factor_nonlinearity: one * 1e-6,
        vibration_rectification_s2_m: one * 1e-6,
        lever_arm_m: Matrix3::new(0.05, 0.0, 0.0, 0.0, 0.05, 0.0, 0.0, 0.0, 0.05),
        bandwidth_hz: one * 200.0,
        range: one * 30.0 * G,
        ..Default::default()
    };
    (gyro, accel)
}

fn with_every_effect(options: &Options) -> Simulator {
    let mut simulator = Simulator::new(options).unwrap();
    let (gyro, accel) = every_effect();
    simulator.set_gyro(&gyro).unwrap();
    simulator.set_accel(&accel).unwrap();
    simulator
}

fn at_rest(count: usize) -> impl Iterator<Item = FlightSample> {
    (0..count).map(|k| resting_sample(k as f64 / 100.0))
}

fn patrol_samples(seconds: f64) -> Vec<FlightSample> {
    let flight = patrol(2400.0);
    (0..(seconds * 100.0) as usize).map(|k| flight.sample_at(1000.0 + k as f64 / 100.0).unwrap()).collect()
}

/// Differences of error data 1 and 2 in position [m], velocity [m/s] and misalignment [rad] after the patrol, and error data 2.
fn gap_and_size(gyro: &TriadParameters, accel: &TriadParameters) -> ([f64; 3], [f64; 3]) {
    let mut simulator = Simulator::new(&Options { error_model: true, ..options_at(100.0) }).unwrap();
    simulator.set_gyro(gyro).unwrap();
    simulator.set_accel(accel).unwrap();
    sensed(&mut simulator, patrol_samples(900.0));
    let [navigation, model] = [ErrorSource::Navigation, ErrorSource::Model].map(|source| {
        let (_, errors) = simulator.errors(source).unwrap().unwrap();
        [errors.position_n, errors.velocity_n, errors.misalignment_n]
    });
    let gap = std::array::from_fn(|i| (model[i] - navigation[i]).norm());
    (gap, navigation.map(|error| error.norm()))
}

/// Every effect whose errors are steady within an interval and proportional to its parameters, `size` times as large.
fn every_steady_effect(size: f64) -> (TriadParameters, TriadParameters) {
    let scaled = |triad: TriadParameters| TriadParameters {
        bias_sigma: triad.bias_sigma * size,
        rate_random_walk: triad.rate_random_walk * size,
        ramp: triad.ramp * size,
        flicker: triad.flicker * size,
        scale_factor: triad.scale_factor * size,
        scale_factor_asymmetry: triad.scale_factor_asymmetry * size,
        scale_factor_nonlinearity: triad.scale_factor_nonlinearity * size,
        misalignment: Matrix3::new(0.0, 1.0, -2.0, 2.0, 0.0, 1.0, -1.0, 1.0, 0.0) * (1e-5 * size),
        g_sensitivity: triad.g_sensitivity * size,
        lever_arm_m: triad.lever_arm_m * size,
        vibration_rectification_s2_m: triad.vibration_rectification_s2_m * size,
        ..Default::default()
    };
    let (gyro, accel) = every_effect();
    (scaled(gyro), scaled(accel))
}

/// Twice the errors make four times the difference between the two error data. The bound covers terms of third order, smaller by an
/// error angle of 1e-4, and 3e-8 m of the navigator itself. An effect missing in error data 1 would make twice the difference.
#[test]
fn both_error_data_agree_to_second_order_in_every_steady_effect() {
    let [(once, _), (twice, size)] =
        [1.0, 2.0].map(every_steady_effect).map(|(gyro, accel)| gap_and_size(&gyro, &accel));
    for (label, i) in [("position", 0), ("velocity", 1), ("misalignment", 2)] {
        let ratio = twice[i] / once[i];
        println!(
            "{label}: {:.2e} of {:.2e} differ, {ratio:.4} times those of half the errors",
            twice[i], size[i]
        );
        assert!((ratio - 4.0).abs() < 0.004, "{label}: {ratio}");
    }
}

/// White noise and steps of quantization jump within an interval: the differential equations include only their mean and first
/// moment. The error of a filter does not scale. The missing parts are a thousandth of the whole; an effect left out would be
/// missing as a whole.
#[test]
fn both_error_data_hear_of_every_effect() {
    let (gyro, accel) = every_effect();
    let (gap, size) = gap_and_size(&gyro, &accel);
    for (label, i) in [("position", 0), ("velocity", 1), ("misalignment", 2)] {
        assert!(gap[i] < 0.01 * size[i], "{label}: {} of {}", gap[i], size[i]);
    }
    assert!(size[0] > 10.0, "there is something to hear: {} m", size[0]);
}

/// Level and heading north, sensor axes are east-north-up. A gyro along east with g-sensitivity and a ramp, and
/// accelerometers with lever arms, tilt the alignment as their steady errors do.
#[test]
fn an_alignment_sees_the_steady_parts() {
    let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
    let mut unbalance = Matrix3::zeros();
    unbalance[(0, 2)] = 1e-9;
    let ramp = Vector3::new(1e-12, 0.0, 0.0);
    let gyro = TriadParameters { g_sensitivity: unbalance, ramp, ..Default::default() };
    simulator.set_gyro(&gyro).unwrap();
    let lever_arm_m = Matrix3::new(0.0, 0.0, 0.0, 0.0, 100.0, 0.0, 0.0, 0.0, 0.0);
    simulator.set_accel(&TriadParameters { lever_arm_m, ..Default::default() }).unwrap();
    let alignment = Alignment::LevelAndGyrocompass;
    simulator.set_initial_errors(&InitialErrorParameters { alignment, ..Default::default() }).unwrap();
    sensed(&mut simulator, at_rest(100));
    // The ramp has come to 1e-12 in a second; an alignment at this time includes it.
    simulator.reposition(&resting_sample(1.0)).unwrap();
    let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
    let sample = resting_sample(0.0);
    let earth = sins::earth::Earth::default();
    let g = earth.gravity(&earth.to_earth_fixed(&sample.place)).norm();
    let (sin, cos) = sample.place.latitude_rad.sin_cos();
    let (north, up) = (earth.rate_rad_s * cos, earth.rate_rad_s * sin);
    // An arm of 100 m along north: ω×(ω×r) has -ω_up² r along the arm. East gyro: G g + R t.
    let expected = Vector3::new(up * up * 100.0 / g, 0.0, -(1e-9 * g + 1e-12 * 0.99) / north);
    let misalignment = errors.misalignment_n;
    assert!((misalignment - expected).norm() < 1e-6 * expected.norm(), "{misalignment:?} {expected:?}");
    assert!((misalignment.x / expected.x - 1.0).abs() < 1e-3, "{misalignment:?} {expected:?}");
}

#[test]
fn saturation_is_flagged_for_the_interval_and_the_sensor() {
    let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
    let range = Vector3::new(1e3, 1e3, 5.0);
    simulator.set_accel(&TriadParameters { range, ..Default::default() }).unwrap();
    let intervals = sensed(&mut simulator, at_rest(3));
    for imu in &intervals {
        assert!(imu.flags.accel_saturated && !imu.flags.gyro_saturated);
        assert!((imu.measured.velocity.z / imu.interval_s - 5.0).abs() < 4.0 * f64::EPSILON * 5.0);
    }
    simulator.set_accel(&TriadParameters::default()).unwrap();
    let next = sensed(&mut simulator, [resting_sample(0.03)]);
    assert!(!next[0].flags.accel_saturated, "the flag is of the interval");
    assert_eq!(next[0].measured, next[0].ideal, "and ideal sensors are transparent again");
}

/// A navigator alone on the host's increments: a wheel of 5 rad/s with its accelerometers off the centre.
#[test]
fn foreign_increments_have_the_same_effects() {
    let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
    let lever_arm_m = Matrix3::new(0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    simulator.set_accel(&TriadParameters { lever_arm_m, ..Default::default() }).unwrap();
    let range = Vector3::repeat(4.0);
    simulator.set_gyro(&TriadParameters { range, ..Default::default() }).unwrap();
    let mut truth = Simulator::new(&options_at(100.0)).unwrap();
    truth.push_sample(&resting_sample(0.0)).unwrap();
    let start = truth.truth().unwrap().unwrap().navigation;
    simulator.start_navigation(0.0, &start).unwrap();
    let part =
        Increment { angle: Vector3::new(0.0, 0.0, 5.0 * 0.005), velocity: Vector3::new(0.0, 0.0, G * 0.005) };
    for _ in 0..10 {
        simulator.push_imu(&[part, part], 0.01).unwrap();
        let imu = simulator.imu().unwrap();
        let force = (imu.measured.velocity - imu.ideal.velocity) / imu.interval_s;
        assert!((force - Vector3::new(-2.5, 0.0, 0.0)).norm() < 1e-12, "{force:?}");
        assert!(imu.flags.gyro_saturated && !imu.flags.accel_saturated);
        assert!((imu.measured.angle.z - 0.04).abs() < 1e-16);
    }
}

#[test]
fn a_reset_brings_every_effect_back_to_the_bit() {
    let samples = patrol_samples(20.0);
    let mut simulator = with_every_effect(&options_at(100.0));
    let first = sensed(&mut simulator, samples.iter().cloned());
    simulator.reset();
    assert_eq!(sensed(&mut simulator, samples), first);
}

/// At a jump of the truth, walks, flicker, ramps and noise continue as without the jump; filters do not ring.
#[test]
fn at_a_reposition_noise_goes_on_and_filters_settle() {
    let (mut gyro, mut accel) = every_effect();
    for parameters in [&mut gyro, &mut accel] {
        // Additive effects alone: the others depend on the signals, which differ in another attitude.
        *parameters = TriadParameters {
            bias_sigma: parameters.bias_sigma,
            random_walk: parameters.random_walk,
            rate_random_walk: parameters.rate_random_walk,
            ramp: parameters.ramp,
            flicker: parameters.flicker,
            bandwidth_hz: Vector3::repeat(0.5),
            ..Default::default()
        };
    }
    let banked = |k: usize| FlightSample {
        euler: Euler { roll: 1.0, ..resting_sample(0.0).euler },
        ..resting_sample(k as f64 / 100.0)
    };
    let start = || {
        let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
        simulator.set_gyro(&gyro).unwrap();
        simulator.set_accel(&accel).unwrap();
        simulator
    };
    let through = sensed(&mut start(), at_rest(200));
    let mut jumping = start();
    sensed(&mut jumping, at_rest(100));
    jumping.reposition(&banked(100)).unwrap();
    let after = sensed(&mut jumping, (101..200).map(banked));
    let error = |imu: &ImuInterval| {
        (imu.measured.angle - imu.ideal.angle, imu.measured.velocity - imu.ideal.velocity)
    };
    for (after, through) in after.iter().zip(&through[99..]) {
        let ((angle, velocity), (expected_angle, expected_velocity)) = (error(after), error(through));
        // Differences of increments of 0.1 m/s and of the filter's state, 10 m/s² over 2 1/s.
        assert!((angle - expected_angle).norm() < 1e-15, "{angle:?} {expected_angle:?}");
        assert!((velocity - expected_velocity).norm() < 1e-14, "{velocity:?} {expected_velocity:?}");
    }
}

/// Sensor errors that drive the solution out of its range: the step is refused, and the last good solution stays.
#[test]
fn a_solution_thrown_away_stays_readable() {
    let one = Vector3::repeat(1.0);
    let wild = [
        TriadParameters { scale_factor_nonlinearity: one, bias: one * 1e4, ..Default::default() },
        TriadParameters { vibration_rectification_s2_m: one, bias: one * -1e4, ..Default::default() },
        TriadParameters { rate_random_walk: one * 1e4, ..Default::default() },
        TriadParameters { ramp: one * 1e4, ..Default::default() },
        TriadParameters { flicker: one * 1e4, ..Default::default() },
    ];
    for accel in &wild {
        let mut simulator = Simulator::new(&options_at(1.0)).unwrap();
        simulator.set_accel(accel).unwrap();
        let mut before = None;
        let mut refused = false;
        for k in 0..1000 {
            simulator.push_sample(&resting_sample(f64::from(k))).unwrap();
            match simulator.step() {
                Ok(_) => before = simulator.navigation().unwrap(),
                Err(error) => {
                    assert_eq!(error.kind, ErrorKind::Diverged, "{error}");
                    refused = true;
                    break;
                }
            }
        }
        assert!(refused, "{accel:?}");
        let after = simulator.navigation().unwrap().unwrap();
        if let Some(before) = before {
            assert_eq!(after.navigation, before.navigation);
        }
        assert!(
            after.navigation.v_n.norm() < 100e3 && after.navigation.place.latitude_rad.abs() <= 90.0 * DEG
        );
    }
}
