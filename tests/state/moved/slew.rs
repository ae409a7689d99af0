//! The truth jumps: a slew keeps the errors, by way of the pole too, and from there they go their way.

use nalgebra::Vector3;
use sins::errors::NavigationErrors;
use sins::math::Euler;
use sins::mechanization::{Frame, VerticalMode};
use sins::mounting::MountingParameters;
use sins::sensors::InitialErrorParameters;
use sins::truth::FlightSample;
use sins::{ErrorSource, Options, Simulator};

use super::{elsewhere, troubled};
use crate::support::moments::initial;
use crate::support::{errors, fly_through, options_at, patrol, resting_sample};

/// How the errors of both sources have changed: positions [m], velocities [m/s], misalignments [rad].
fn change(a: &NavigationErrors, b: &NavigationErrors) -> [f64; 3] {
    [
        (a.position_n - b.position_n).norm(),
        (a.velocity_n - b.velocity_n).norm(),
        (a.misalignment_n - b.misalignment_n).norm(),
    ]
}

/// Positions are rounded where they are read: eight units in the last place of 8e6 m. Velocities and attitudes have errors of 3e2
/// m/s and 1, and what positions are wrong by over the distance to the Earth's axis.
fn is_rounding(change: [f64; 3]) -> bool {
    change[0] < 8.0 * 8e6 * f64::EPSILON && change[1] < 1e-11 && change[2] < 1e-14
}

/// From anywhere to anywhere: both frames, both hemispheres, high and low, other speeds and attitudes, errors of metres and of a
/// hundred kilometres; near a pole, there and back. Both error data are what they were.
#[test]
fn a_slew_keeps_the_errors() {
    let mut largest = [0.0_f64; 3];
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        for vertical in [VerticalMode::Damped, VerticalMode::FollowTruth, VerticalMode::Free] {
            for far_m in [0.0, 100e3] {
                let options = Options { frame, vertical, error_model: true, ..Options::default() };
                let mut simulator = troubled(&options);
                let mut start = initial();
                start.alignment = Default::default();
                start.position_n += Vector3::new(far_m, -0.5 * far_m, 0.0);
                simulator.set_initial_errors(&start).unwrap();
                let samples: Vec<_> = (0..200).map(|k| resting_sample(f64::from(k) * 0.02)).collect();
                fly_through(&mut simulator, &samples);
                let places = [
                    (-40.0, 0.0, 250.0),
                    (75.0, 12e3, 0.0),
                    (0.0, -300.0, 30.0),
                    (if frame == Frame::EarthFixed { 89.0 } else { 85.0 }, 1e3, 100.0),
                    (40.0, 2000e3, 7000.0),
                ];
                for (latitude_deg, height_m, speed_m_s) in places {
                    let before = [ErrorSource::Navigation, ErrorSource::Model]
                        .map(|source| errors(&simulator, source));
                    let imu = simulator.imu().unwrap();
                    simulator.move_truth(&elsewhere(1e3, latitude_deg, height_m, speed_m_s)).unwrap();
                    let after = [ErrorSource::Navigation, ErrorSource::Model]
                        .map(|source| errors(&simulator, source));
                    for (before, after) in before.iter().zip(&after) {
                        let change = change(after, before);
                        largest = std::array::from_fn(|i| largest[i].max(change[i]));
                        assert!(is_rounding(change), "{frame:?} {vertical:?} to {latitude_deg}: {change:?}");
                    }
                    let now = simulator.imu().unwrap();
                    assert_eq!((now.measured, now.time_s), (imu.measured, 1e3));
                }
            }
        }
    }
    println!("largest changes of errors by a slew: {largest:?} m, m/s, rad");
}

/// By way of the pole, where components of the solution's own axes have no meaning: there and back they are what they were, and an
/// INS that is slewed to where it is stays what it is.
#[test]
fn a_slew_by_way_of_the_pole_keeps_the_errors() {
    let options = Options { error_model: true, ..Options::default() };
    let mut simulator = troubled(&options);
    fly_through(&mut simulator, (0..200).map(|k| resting_sample(f64::from(k) * 0.02)));
    let before = [ErrorSource::Navigation, ErrorSource::Model].map(|source| errors(&simulator, source));
    for latitude_deg in [90.0, -90.0, 89.9999, -89.99, 89.9] {
        let sample = elsewhere(1e3, latitude_deg, 1e3, 200.0);
        simulator.move_truth(&sample).unwrap();
        let there = simulator.navigation().unwrap().unwrap().navigation.earth_fixed(&options.earth());
        simulator.move_truth(&sample).unwrap();
        let again = simulator.navigation().unwrap().unwrap().navigation.earth_fixed(&options.earth());
        assert!((there.r_e - again.r_e).norm() < 1e-7 && (there.v_e - again.v_e).norm() < 1e-10);
        assert!((there.q_eb - again.q_eb).norm() < 1e-13);
        // Velocity and misalignment have their lengths in any axes.
        let position = errors(&simulator, ErrorSource::Navigation).position_n;
        assert!((position - before[0].position_n).norm() < 1e-7, "{latitude_deg}: {position:?}");
    }
    simulator.move_truth(&elsewhere(1e3, -30.0, 1e3, 200.0)).unwrap();
    for (before, source) in before.iter().zip([ErrorSource::Navigation, ErrorSource::Model]) {
        let change = change(&errors(&simulator, source), before);
        assert!(is_rounding(change.map(|change| change / 10.0)), "{change:?}");
    }
}

/// The flight goes on from the slew like one that has been there with such errors: an error-free INS stays free of errors, and one
/// with errors goes the way of data 1, which are kept alike and know of no jump.
#[test]
fn after_a_slew_the_errors_go_their_way() {
    let flight = patrol(1200.0);
    for (frame, with_velocity, errs) in [
        (Frame::EarthFixed, true, false),
        (Frame::EarthFixed, false, false),
        (Frame::EarthFixed, true, true),
        (Frame::Geographic, true, true),
        (Frame::EarthFixed, false, true),
    ] {
        let options = Options { frame, error_model: true, ..options_at(100.0) };
        let mut simulator = Simulator::new(&options).unwrap();
        if errs {
            let initial = InitialErrorParameters {
                position_n: Vector3::new(100.0, -200.0, 5.0),
                velocity_n: Vector3::new(0.1, 0.2, 0.0),
                misalignment_n: Vector3::new(1e-4, -1e-4, 3e-4),
                ..Default::default()
            };
            simulator.set_initial_errors(&initial).unwrap();
        }
        fly_through(&mut simulator, (0..3000).map(|k| resting_sample(f64::from(k) * 0.01)));
        let flown: Vec<_> = (0..6000)
            .map(|k| flight.sample_at(300.0 + f64::from(k) / 100.0).unwrap())
            .map(|sample| FlightSample { v_n: sample.v_n.filter(|_| with_velocity), ..sample })
            .collect();
        simulator.move_truth(&flown[0]).unwrap();
        fly_through(&mut simulator, &flown[1..]);
        let (navigated, model) =
            (errors(&simulator, ErrorSource::Navigation), errors(&simulator, ErrorSource::Model));
        let (apart, size) = ((navigated.position_n - model.position_n).norm(), navigated.position_n.norm());
        println!("{frame:?}, velocity {with_velocity}: error {size} m, data 1 and 2 {apart} m apart");
        // Second order in misalignments of 3e-4 rad; without velocities the start is not known better than 1 mm, as at any start.
        let own = if with_velocity { 1e-6 } else { 1e-2 };
        assert!(apart < own + 1e-3 * size, "{apart} of {size}");
        assert_eq!(size > 50.0, errs);
        assert_eq!(simulator.intervals(), 2999 + 5999);
    }
}

/// The block of a mounting keeps its errors; that of the closed loop's own navigator stays as small, and no draw moves: the noise
/// behind the slew is that of a flight without one.
#[test]
fn a_slew_of_a_block_in_a_closed_loop_moves_no_draw() {
    let options = Options { closed_loop_time_s: Some(10.0), error_model: true, ..options_at(100.0) };
    let start = || {
        let mut simulator = troubled(&options);
        simulator
            .set_mounting(&MountingParameters {
                lever_arm_m: Vector3::new(1.0, 4.0, -0.5),
                boresight: Euler { roll: 0.1, pitch: 0.0, heading: 1.0 },
                ..Default::default()
            })
            .unwrap();
        fly_through(&mut simulator, (0..300).map(|k| resting_sample(f64::from(k) * 0.01)));
        simulator
    };
    let (mut slewed, mut stayed) = (start(), start());
    let before = errors(&slewed, ErrorSource::Navigation);
    let turned = |time_s: f64| {
        let mut sample = resting_sample(time_s);
        sample.place.longitude_rad += 1.0;
        sample
    };
    slewed.move_truth(&turned(3.0)).unwrap();
    // The same attitude, to which the arm lies as before.
    let change = change(&errors(&slewed, ErrorSource::Navigation), &before);
    assert!(is_rounding(change.map(|change| change / 4.0)), "{change:?}");
    for k in 301..2000 {
        fly_through(&mut slewed, [turned(f64::from(k) * 0.01)]);
        fly_through(&mut stayed, [resting_sample(f64::from(k - 1) * 0.01)]);
        let noise = |simulator: &Simulator| {
            let imu = simulator.imu().unwrap();
            imu.measured.angle - imu.ideal.angle
        };
        // Filters settle at the jump, and positions round: 40 Hz have forgotten after a tenth of a second.
        if k > 330 {
            let apart = (noise(&slewed) - noise(&stayed)).norm();
            assert!(apart < 1e-9, "{k}: {apart}");
        }
    }
    assert!(slewed.trim().unwrap().unwrap().force_m_s2 < 1e-6, "{:?}", slewed.trim());
}
