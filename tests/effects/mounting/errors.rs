//! Errors in the mounting that the INS assumes appear as in closed form, in both error data.

use nalgebra::Vector3;
use sins::math::{Euler, rotate, rotate_inverse};
use sins::mechanization::{Frame, VerticalMode};
use sins::sensors::{InitialErrorParameters, TriadParameters};
use sins::signal::mounting::MountingParameters;
use sins::truth::flight::Manoeuvre;
use sins::{ErrorSource, Options};

use super::{aerobatics, flight, mounted, samples, wrongly_believed};
use crate::support::{DEG_PER_HOUR, G, errors, options_at, step};

/// In straight flight, if the INS assumes the block turned right by b more than it is, the vehicle's heading comes out b to the
/// left. Nothing else errs: the block itself is navigated without error. The end of the arm swings by b times the arm's length.
#[test]
fn a_boresight_error_is_an_attitude_error() {
    let b = 1e-3;
    let mounting = MountingParameters {
        lever_arm_m: Vector3::new(0.0, 4.0, 0.0),
        boresight_error: Euler { heading: b, ..Euler::default() },
        ..MountingParameters::default()
    };
    let options = Options { error_model: true, ..options_at(50.0) };
    let mut simulator = mounted(&options, &mounting);
    for sample in samples(&flight(&[Manoeuvre::Straight { duration_s: 60.0 }]), 50.0) {
        step(&mut simulator, &sample);
    }
    let heading = simulator.truth().unwrap().unwrap().navigation.euler.heading;
    for source in [ErrorSource::Navigation, ErrorSource::Model] {
        let errors = errors(&simulator, source);
        // The vertical at the position that the INS finds leans by 4 m · b over the Earth's radius: 6e-10 rad.
        assert!((errors.heading_rad + b).abs() < 1e-9, "{source:?} {errors:?}");
        assert!(errors.roll_rad.abs() < 1e-9 && errors.pitch_rad.abs() < 1e-9, "{errors:?}");
        // C~ = (I - [φ×]) C: φ up turns the computed body to the right.
        assert!((errors.misalignment_n - Vector3::new(0.0, 0.0, errors.heading_rad)).norm() < 1e-9);
        // The INS assumes the reference point 4 m behind the block, along a heading b to the left of the true heading: it
        // finds the point 4 m · b to the right. The linear model drops 4 m · b²/2.
        let right = Vector3::new(heading.cos(), -heading.sin(), 0.0);
        assert!((errors.position_n - right * (4.0 * b)).norm() < 4.0 * b * b, "{source:?} {errors:?}");
        assert!(errors.velocity_n.norm() < 1e-6, "{errors:?}");
    }
}

/// In a coordinated turn an arm that the INS assumes longer by d changes the position by -C d and the velocity by -C (ω×d).
#[test]
fn a_lever_arm_error_goes_round_with_the_turn() {
    let error = Vector3::new(0.1, -0.3, 0.2);
    let mounting =
        MountingParameters { lever_arm_error_m: error, lever_arm_m: error * 9.0, ..Default::default() };
    let turn = flight(&[Manoeuvre::Turn { heading_change_rad: 6.0, bank_rad: 1.0, ramp_s: 3.0 }]);
    let options = Options { error_model: true, vertical: VerticalMode::Free, ..options_at(100.0) };
    let mut simulator = mounted(&options, &mounting);
    let turn_rate = G * 1.0f64.tan() / 180.0;
    for sample in samples(&turn, 100.0) {
        step(&mut simulator, &sample);
        // After the roll-in and before the roll-out.
        if !(4.0..turn.duration_s() - 4.0).contains(&sample.time_s) {
            continue;
        }
        let q_nb = simulator.truth().unwrap().unwrap().navigation.q_nb;
        // A right turn: its rate points down.
        let omega_b = rotate_inverse(&q_nb, &Vector3::new(0.0, 0.0, -turn_rate));
        let position_n = -rotate(&q_nb, &error);
        let velocity_n = -rotate(&q_nb, &omega_b.cross(&error));
        for source in [ErrorSource::Navigation, ErrorSource::Model] {
            let errors = errors(&simulator, source);
            // 180 m/s over 6.4e6 m turns the vertical by 3e-5 rad/s, the scheme leaves 1e-6 m.
            assert!((errors.position_n - position_n).norm() < 1e-5, "{source:?} {errors:?} {position_n:?}");
            assert!(
                (errors.velocity_n - velocity_n).norm() < 3e-5 * 0.4,
                "{source:?} {errors:?} {velocity_n:?}"
            );
            assert!(errors.misalignment_n.norm() < 1e-7, "{errors:?}");
        }
    }
}

/// Error data 1 with all errors at once: sensors that err in the axes of the block, an INS with initial errors, and a
/// mounting that the INS assumes wrongly.
#[test]
fn both_error_data_hear_of_the_mounting() {
    for (frame, vertical) in [
        (Frame::EarthFixed, VerticalMode::Damped),
        (Frame::Geographic, VerticalMode::FollowTruth),
        (Frame::EarthFixed, VerticalMode::FollowTruth),
        (Frame::Geographic, VerticalMode::Free),
    ] {
        let options = Options { frame, vertical, error_model: true, ..options_at(50.0) };
        let mut simulator = mounted(&options, &wrongly_believed());
        simulator
            .set_gyro(&TriadParameters {
                bias: Vector3::new(1.0, -2.0, 3.0) * DEG_PER_HOUR,
                random_walk: Vector3::repeat(1e-6),
                ..Default::default()
            })
            .unwrap();
        simulator
            .set_accel(&TriadParameters { bias: Vector3::new(1e-4, 2e-4, -1e-4) * G, ..Default::default() })
            .unwrap();
        simulator
            .set_initial_errors(&InitialErrorParameters {
                misalignment_n: Vector3::new(2e-5, -3e-5, 1e-4),
                position_n: Vector3::new(20.0, -30.0, 10.0),
                velocity_n: Vector3::new(0.1, 0.2, 0.05),
                ..Default::default()
            })
            .unwrap();
        for (k, sample) in samples(&aerobatics(), 50.0).iter().enumerate() {
            step(&mut simulator, sample);
            if k % 500 != 499 {
                continue;
            }
            let (found, expected) =
                (errors(&simulator, ErrorSource::Model), errors(&simulator, ErrorSource::Navigation));
            // Products of two errors: 1e-3 rad of misalignment with 5.5 m of arm at 3 rad/s, with 50 m/s² for a minute, and
            // with itself; and a thousandth of what noise does within an interval.
            let position = (found.position_n - expected.position_n).norm();
            let velocity = (found.velocity_n - expected.velocity_n).norm();
            let misalignment = (found.misalignment_n - expected.misalignment_n).norm();
            assert!(position < 1e-3 * expected.position_n.norm(), "{found:?} {expected:?}");
            assert!(velocity < 2e-3 * expected.velocity_n.norm(), "{found:?} {expected:?}");
            assert!(misalignment < 2e-3 * expected.misalignment_n.norm(), "{found:?} {expected:?}");
        }
    }
}

/// The vertical channel's aid acts on the reference point and holds there, whatever arm the INS assumes.
#[test]
fn the_aided_height_is_that_of_the_reference_point() {
    let mut simulator = mounted(&options_at(50.0), &wrongly_believed());
    for (k, sample) in samples(&aerobatics(), 50.0).iter().enumerate() {
        step(&mut simulator, sample);
        let errors = errors(&simulator, ErrorSource::Navigation);
        // Rounding of a position in Earth-fixed axes. The vertical at the other end of the arm leans by 9e-7 rad, and with it
        // the horizontal velocity of the correction: 1e-5 m/s at the most.
        assert!(k == 0 || errors.position_n.z.abs() < 8e-9, "{errors:?}");
        assert!(k == 0 || errors.velocity_n.z.abs() < 1e-11, "{errors:?}");
    }
}
