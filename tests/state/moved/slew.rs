//! The truth jumps. A slew keeps the errors, also by way of the pole, and after it they evolve as usual.

use nalgebra::Vector3;
use sins::errors::NavigationErrors;
use sins::math::Euler;
use sins::mechanization::{Frame, VerticalMode};
use sins::sensors::InitialErrorParameters;
use sins::signal::mounting::MountingParameters;
use sins::truth::FlightSample;
use sins::{ErrorKind, ErrorSource, Options, Simulator};

use super::{elsewhere, troubled};
use crate::support::moments::{initial, reads, snapshot};
use crate::support::{errors, fly_through, options_at, patrol, resting_sample};

/// Size of the difference of two sets of errors: position [m], velocity [m/s], misalignment [rad].
fn change(a: &NavigationErrors, b: &NavigationErrors) -> [f64; 3] {
    [
        (a.position_n - b.position_n).norm(),
        (a.velocity_n - b.velocity_n).norm(),
        (a.misalignment_n - b.misalignment_n).norm(),
    ]
}

/// Limits of the rounding. Positions are rounded when they are read: eight units in the last place of 8e6 m. Velocities of
/// 3e2 m/s and attitudes of 1 are rounded too, and they have the position's rounding divided by the distance to the Earth's axis.
const ROUNDING: [f64; 3] = [8.0 * 8e6 * f64::EPSILON, 1e-11, 1e-14];

/// Whether a change is rounding.
fn is_rounding(change: [f64; 3]) -> bool {
    (0..3).all(|i| change[i] < ROUNDING[i])
}

/// Slews between any places: both frames, both hemispheres, high and low, other speeds and attitudes, errors of metres and of a
/// hundred kilometres, to near a pole and back. The errors of both sources stay the same.
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
    let ([m, m_s, rad], [limit_m, limit_m_s, limit_rad]) = (largest, ROUNDING);
    let limits = format!("limits {limit_m:.1e} m, {limit_m_s:e} m/s, {limit_rad:e} rad");
    println!("figure: {m:.1e} m, {m_s:.1e} m/s, {rad:.1e} rad ({limits})");
}

/// By way of the pole, where components along the local axes have no meaning: after a slew there and back the errors are the same.
/// A slew to the current truth changes nothing.
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
        // The lengths of velocity and misalignment errors do not depend on the axes.
        let position = errors(&simulator, ErrorSource::Navigation).position_n;
        assert!((position - before[0].position_n).norm() < 1e-7, "{latitude_deg}: {position:?}");
    }
    simulator.move_truth(&elsewhere(1e3, -30.0, 1e3, 200.0)).unwrap();
    for (before, source) in before.iter().zip([ErrorSource::Navigation, ErrorSource::Model]) {
        let change = change(&errors(&simulator, source), before);
        assert!(is_rounding(change.map(|change| change / 10.0)), "{change:?}");
    }
}

/// After the slew the flight continues like one that has been there with the same errors. An error-free INS stays free of errors.
/// An INS with errors follows data 1 (the error equations), which also keep their values through the slew.
#[test]
fn after_a_slew_the_errors_go_their_way() {
    let flight = patrol(1200.0);
    let (limit, mut worst) = (1e-3, 0.0_f64);
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
        // The rest is of second order in misalignments of 3e-4 rad. Without velocities the start has an error of about 1 mm, like
        // any start.
        let own = if with_velocity { 1e-6 } else { 1e-2 };
        assert!(apart < own + limit * size, "{apart} of {size}");
        assert_eq!(size > 50.0, errs);
        assert_eq!(simulator.intervals(), 2999 + 5999);
        if errs {
            worst = worst.max(apart / size);
        }
    }
    println!("figure: a minute later {worst:.1e} of the error apart (limit {limit:e})");
}

/// An IMU with a mounting keeps its errors in a slew, and the closed loop's own navigator keeps its small error. No draw moves:
/// the noise after the slew is that of a flight without one.
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
    // The attitude is the same, so the lever arm has the same direction in local axes.
    let change = change(&errors(&slewed, ErrorSource::Navigation), &before);
    assert!(is_rounding(change.map(|change| change / 4.0)), "{change:?}");
    for k in 301..2000 {
        fly_through(&mut slewed, [turned(f64::from(k) * 0.01)]);
        fly_through(&mut stayed, [resting_sample(f64::from(k - 1) * 0.01)]);
        let noise = |simulator: &Simulator| {
            let imu = simulator.imu().unwrap();
            imu.measured.angle - imu.ideal.angle
        };
        // Filters settle after the jump, and positions are rounded. A filter of 40 Hz has settled after a tenth of a second.
        if k > 330 {
            let apart = (noise(&slewed) - noise(&stayed)).norm();
            assert!(apart < 1e-9, "{k}: {apart}");
        }
    }
    assert!(slewed.trim().unwrap().unwrap().force_m_s2 < 1e-6, "{:?}", slewed.trim());
}

/// Slews of a vehicle that turns fast about a block far from its reference point: such a point is faster than the vehicle. What the limit
/// of the speed accepts is a simulator whose snapshot loads; what it rejects has changed nothing.
#[test]
fn a_slew_that_is_accepted_has_a_snapshot_that_loads() {
    let (mut accepted, mut rejected) = (0, 0);
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        for with_velocity in [true, false] {
            for rate in [0.0, 500.0, 700.0, 990.0, 1000.0] {
                for speed in [0.0, 3e3, 15e3] {
                    let mut simulator = troubled(&Options { frame, ..Options::default() });
                    let far = Vector3::new(0.0, 100.0, 0.0);
                    simulator
                        .set_mounting(&MountingParameters {
                            lever_arm_m: far,
                            lever_arm_error_m: far,
                            ..Default::default()
                        })
                        .unwrap();
                    fly_through(&mut simulator, [resting_sample(0.0), resting_sample(0.02)]);
                    let turning = |time_s: f64, north_m: f64| {
                        let mut sample = elsewhere(time_s, 40.0, 1e4, speed);
                        sample.place.latitude_rad += north_m / 6.4e6;
                        sample.omega_ib_b = Some(Vector3::new(0.0, 0.0, rate));
                        sample.v_n = sample.v_n.filter(|_| with_velocity);
                        sample
                    };
                    let before = (reads(&simulator), snapshot(&simulator));
                    match simulator.move_truth(&turning(10.0, 0.0)) {
                        Ok(()) => accepted += 1,
                        Err(error) => {
                            assert_eq!(error.kind, ErrorKind::Diverged, "{error}");
                            assert!(before == (reads(&simulator), snapshot(&simulator)), "{error}");
                            rejected += 1;
                        }
                    }
                    // The first velocity of a slew without one comes with the next sample.
                    for north_m in [None, Some(0.01 * speed)] {
                        north_m
                            .into_iter()
                            .for_each(|north_m| _ = simulator.push_sample(&turning(10.01, north_m)));
                        let mut loaded = Simulator::new(&Options::default()).unwrap();
                        loaded.load_snapshot(&snapshot(&simulator)).unwrap();
                        assert!(reads(&loaded) == reads(&simulator), "{rate} rad/s, {speed} m/s");
                    }
                }
            }
        }
    }
    println!("figure: {accepted} slews accepted, {rejected} rejected");
    assert!(accepted > 10 && rejected > 10, "{accepted} {rejected}");
}
