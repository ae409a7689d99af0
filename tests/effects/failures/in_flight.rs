//! Failures in a flight: set, replaced and cleared, in both error data, through resets and divergence.

use nalgebra::Vector3;
use sins::earth::state::{BodyAxes, Navigation};
use sins::math::{Euler, attitude_from_euler};
use sins::sensors::{Axis, Failure, SensorOutput};
use sins::signal::Increment;
use sins::{ErrorKind, ErrorSource, ImuFlags, Options, Simulator, Step};

use super::{DT, EPS, INVALID_GYRO, in_flight, noisy_simulator, rest, simulator};
use crate::support::{G, bits, resting_sample, sensed};

/// One failure of each kind, small enough that the solution stays within its range.
const EVERY_KIND: [Failure; 7] = [
    Failure::Stuck,
    Failure::Dead,
    Failure::BiasStep { size: 1e-6 },
    Failure::Spikes { size: 1e-4, interval_s: 0.25, duration_s: 0.003 },
    Failure::Noise { density: 1e-6 },
    Failure::DropOuts { interval_s: 0.0, probability: 0.5 },
    Failure::DropOuts { interval_s: 0.05, probability: 0.0 },
];

/// For each kind of failure the other axes never change. After the failure is cleared, the signals are those of sound
/// sensors, to the bit: the noise has continued during the failure, and no draw has moved.
#[test]
fn a_cleared_failure_leaves_the_unfailed_draws() {
    let expected = sensed(&mut noisy_simulator(), in_flight(0..150));
    for failure in EVERY_KIND {
        let mut failing = noisy_simulator();
        let mut found = sensed(&mut failing, in_flight(0..50));
        failing.set_failure(SensorOutput::Gyro(Axis::Y), Some(failure)).unwrap();
        failing.set_failure(SensorOutput::Accelerometer(Axis::X), Some(failure)).unwrap();
        found.extend(sensed(&mut failing, in_flight(50..100)));
        failing.set_failure(SensorOutput::Accelerometer(Axis::X), None).unwrap();
        failing.set_failure(SensorOutput::Gyro(Axis::Y), None).unwrap();
        found.extend(sensed(&mut failing, in_flight(100..150)));
        let mut differing = [0; 2];
        for (k, (found, expected)) in found.iter().zip(&expected).enumerate() {
            if !(49..99).contains(&k) {
                assert_eq!(found, expected, "{failure:?} {k}");
                continue;
            }
            assert_eq!(found.ideal, expected.ideal);
            let (angle, velocity) = (found.measured.angle, found.measured.velocity);
            assert_eq!((angle.x, angle.z), (expected.measured.angle.x, expected.measured.angle.z));
            assert_eq!(
                (velocity.y, velocity.z),
                (expected.measured.velocity.y, expected.measured.velocity.z)
            );
            differing[0] += usize::from(angle.y != expected.measured.angle.y);
            differing[1] += usize::from(velocity.x != expected.measured.velocity.x);
        }
        // Spikes differ least often: two in half a second, each within one interval or across two.
        assert!(differing[0] >= 2 && differing[1] >= 2, "{failure:?}: {differing:?}");
    }
}

/// A new failure replaces the previous one of the same output; a dead output that then sticks is stuck at 0.
#[test]
fn the_last_failure_replaces_the_one_before() {
    let output = SensorOutput::Gyro(Axis::Y);
    let mut simulator = simulator();
    simulator.set_failure(output, Some(Failure::BiasStep { size: 1.0 })).unwrap();
    simulator.set_failure(output, Some(Failure::BiasStep { size: 0.25 })).unwrap();
    let imu = sensed(&mut simulator, rest(0..2))[0];
    assert!((imu.measured.angle.y - imu.ideal.angle.y - 0.25 * DT).abs() < 4.0 * EPS * DT);
    simulator.set_failure(output, Some(Failure::Dead)).unwrap();
    assert_eq!(sensed(&mut simulator, rest(2..3))[0].flags, INVALID_GYRO);
    simulator.set_failure(output, Some(Failure::Stuck)).unwrap();
    let imu = sensed(&mut simulator, rest(3..4))[0];
    assert_eq!((imu.measured.angle.y, imu.flags), (0.0, ImuFlags::default()));
}

/// Each kind, on a gyro and on an accelerometer: error data 1 follows error data 2, except for terms of second order and for
/// what an error does within an interval beyond its mean and first moment.
#[test]
fn both_error_data_hear_of_failures() {
    for failure in EVERY_KIND {
        let mut simulator = simulator();
        sensed(&mut simulator, in_flight(0..100));
        simulator.set_failure(SensorOutput::Gyro(Axis::X), Some(failure)).unwrap();
        simulator.set_failure(SensorOutput::Accelerometer(Axis::X), Some(failure)).unwrap();
        sensed(&mut simulator, in_flight(100..3000));
        let (_, navigation) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
        let (_, model) = simulator.errors(ErrorSource::Model).unwrap().unwrap();
        let misalignment = navigation.misalignment_n.norm();
        for (label, found, expected) in [
            ("velocity", model.velocity_n, navigation.velocity_n),
            ("misalignment", model.misalignment_n, navigation.misalignment_n),
        ] {
            let difference = (found - expected).norm();
            let bound = (0.01 + misalignment) * expected.norm();
            assert!(difference < bound, "{failure:?} {label}: {found:?} {expected:?}");
        }
    }
}

/// A reset starts a new exercise with sound sensors; the same failures at the same intervals give the same bits. A reposition
/// clears no failure.
#[test]
fn a_reset_clears_failures_and_a_reposition_keeps_them() {
    let exercise = |simulator: &mut Simulator| {
        sensed(simulator, in_flight(0..50));
        let noise = Some(Failure::Noise { density: 1e-4 });
        simulator.set_failure(SensorOutput::Gyro(Axis::X), noise).unwrap();
        let drop_outs = Some(Failure::DropOuts { interval_s: 0.0, probability: 0.3 });
        simulator.set_failure(SensorOutput::Accelerometer(Axis::Z), drop_outs).unwrap();
        sensed(simulator, in_flight(50..100));
        bits(simulator)
    };
    let mut simulator = noisy_simulator();
    let first = exercise(&mut simulator);
    simulator.reset();
    assert_eq!(exercise(&mut simulator), first);
    simulator.reset();
    assert_eq!(sensed(&mut simulator, in_flight(0..50)), sensed(&mut noisy_simulator(), in_flight(0..50)));

    simulator.set_failure(SensorOutput::Gyro(Axis::Z), Some(Failure::Dead)).unwrap();
    simulator.reposition(&in_flight(500..501)[0]).unwrap();
    assert!(sensed(&mut simulator, in_flight(501..510)).iter().all(|imu| imu.flags == INVALID_GYRO));
}

/// A failure that makes the solution diverge is reported, and the last good solution stays. After the failure is cleared, the
/// same interval can be flown.
#[test]
fn a_failure_can_diverge_and_be_cleared() {
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    let wild = Some(Failure::BiasStep { size: 9e3 });
    simulator.set_failure(SensorOutput::Accelerometer(Axis::X), wild).unwrap();
    simulator.push_sample(&resting_sample(0.0)).unwrap();
    let mut steps = 0;
    let error = loop {
        simulator.push_sample(&resting_sample(f64::from(steps + 1))).unwrap();
        match simulator.step() {
            Ok(_) => steps += 1,
            Err(error) => break error,
        }
    };
    // 9 km/s a step: the eleventh step leads to 99 km/s, the twelfth would exceed 100 km/s.
    assert_eq!((error.kind, steps), (ErrorKind::Diverged, 11));
    let good = bits(&simulator);
    assert!(simulator.step().is_err() && bits(&simulator) == good);
    simulator.set_failure(SensorOutput::Accelerometer(Axis::X), None).unwrap();
    assert_eq!(simulator.step().unwrap(), Step::Done);
}

/// Failures act on the host's increments as on samples: a dead gyro is flagged, a stuck gyro repeats the previous interval.
#[test]
fn a_navigator_alone_fails_too() {
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    let start = Navigation::new(
        resting_sample(0.0).place,
        Vector3::zeros(),
        attitude_from_euler(&Euler::default()),
        BodyAxes::default(),
    );
    simulator.start_navigation(0.0, &start).unwrap();
    let push = |simulator: &mut Simulator, rate: f64| {
        let increment = Increment { angle: Vector3::repeat(rate * DT), velocity: Vector3::z() * (G * DT) };
        simulator.push_imu(&[increment], DT).unwrap();
        simulator.imu().unwrap()
    };
    push(&mut simulator, 0.25);
    simulator.set_failure(SensorOutput::Gyro(Axis::Z), Some(Failure::Stuck)).unwrap();
    simulator.set_failure(SensorOutput::Gyro(Axis::X), Some(Failure::Dead)).unwrap();
    let imu = push(&mut simulator, 0.5);
    assert_eq!(imu.flags, INVALID_GYRO);
    assert_eq!(imu.measured.angle, Vector3::new(0.0, 0.5 * DT, 0.25 * DT));
}
