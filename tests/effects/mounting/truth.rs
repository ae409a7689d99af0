//! With perfect sensors an INS off the reference point navigates to the truth.

use nalgebra::{Quaternion, Vector3};
use sins::earth::state::BodyAxes;
use sins::math::{Euler, attitude_from_euler, rotate};
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::signal::Increment;
use sins::signal::mounting::MountingParameters;
use sins::truth::flight::Manoeuvre;
use sins::truth::{FlightSample, IntakeLimits};
use sins::{ErrorSource, Options, Simulator, Step};

use super::{aerobatics, flight, mounted, off_centre, samples, wrongly_believed};
use crate::support::{DEG, EARTH_RATE, Worst, errors, fly, options_at, resting_sample, step};

fn worst(options: &Options, rate_hz: f64, mounting: &MountingParameters) -> Worst {
    fly(&mut mounted(options, mounting), samples(&aerobatics(), rate_hz).into_iter(), 1)
}

/// Ratio of the fourth-order error with a mounting to the error without: the arm's ω² l = 2.8² · 5.4 m/s² = 4 g adds to the
/// flight's 5 g, at up to twice its frequency.
const SHARE_OF_THE_ARM: f64 = 1.0 + 4.0 / 5.0 * 16.0;

/// The mechanization integrates the arm's acceleration like any other: the error is of the same order, the fourth, and of the
/// size of the error in the flight itself. The block's signals and the way back to the reference point add no error.
#[test]
fn perfect_sensors_navigate_to_the_truth_as_without_a_mounting() {
    for (frame, vertical) in
        [(Frame::EarthFixed, VerticalMode::FollowTruth), (Frame::Geographic, VerticalMode::Free)]
    {
        let at = |rate_hz: f64, mounting: &MountingParameters| {
            worst(&Options { frame, vertical, ..options_at(rate_hz) }, rate_hz, mounting)
        };
        let (coarse, fine) = (at(50.0, &off_centre()), at(100.0, &off_centre()));
        let alone = at(100.0, &MountingParameters::default());
        println!("{frame:?}, {vertical:?}, 100 Hz: {fine:?}, without a mounting {alone:?}");
        for (coarse, fine) in [(coarse.position_m, fine.position_m), (coarse.velocity_m_s, fine.velocity_m_s)]
        {
            let order = (coarse / fine).log2();
            assert!((order - 4.0).abs() < 0.3, "order {order}");
        }
        let bound = SHARE_OF_THE_ARM;
        assert!(fine.position_m < bound * alone.position_m, "{fine:?} {alone:?}");
        assert!(fine.velocity_m_s < bound * alone.velocity_m_s, "{fine:?} {alone:?}");
        assert!(fine.misalignment_rad < 1.1 * alone.misalignment_rad, "attitude has no arm");
    }
}

/// An algorithm of higher order shows what the block's signals and the way back add: gravitation along the arm, 5.4 m · 3e-6 /s²,
/// is taken in the middle of each increment, with an error of θ²/24 at θ = 2.8/800 rad: 9e-12 m/s² for 97 s.
#[test]
fn the_blocks_signals_are_those_of_a_rigid_arm() {
    let options = Options { scheme: Scheme::Polynomial, subsamples: 4, ..options_at(200.0) };
    let worst = worst(&options, 200.0, &off_centre());
    println!("polynomial, 4 subsamples, 200 Hz: {worst:?}");
    assert!(worst.position_m < 4e-8 && worst.velocity_m_s < 9e-10, "{worst:?}");
}

/// A boresight alone turns the increments and nothing else: the navigation is the same to rounding.
#[test]
fn a_boresight_alone_turns_the_increments() {
    for axes in [BodyAxes::RightForwardUp, BodyAxes::ForwardRightDown] {
        let options = Options { axes, ..options_at(50.0) };
        let boresight = MountingParameters { lever_arm_m: Vector3::zeros(), ..off_centre() };
        let mut alone = Simulator::new(&options).unwrap();
        let mut turned = mounted(&options, &boresight);
        // Attitude of the block's axes in the vehicle's axes; both conventions derive it from the attitude right-forward-up.
        let q_rfu = attitude_from_euler(&boresight.boresight);
        let exchange = axes.exchange(&Quaternion::identity());
        let q_bs = exchange.conjugate() * q_rfu * exchange;
        for sample in samples(&aerobatics(), 50.0) {
            step(&mut alone, &sample);
            step(&mut turned, &sample);
            let (Some(alone), Some(turned)) = (alone.imu(), turned.imu()) else { continue };
            let Increment { angle, velocity } = turned.ideal;
            assert!((rotate(&q_bs, &angle) - alone.ideal.angle).norm() < 16.0 * f64::EPSILON * 0.1);
            assert!((rotate(&q_bs, &velocity) - alone.ideal.velocity).norm() < 16.0 * f64::EPSILON);
        }
        let difference = errors(&turned, ErrorSource::Navigation).position_n
            - errors(&alone, ErrorSource::Navigation).position_n;
        assert!(difference.norm() < 2e-8, "4000 roundings of 1e-9 m: {difference:?}");
    }
}

/// On a carousel of ω = 1 rad/s about the vertical, an arm of 2 m senses the centripetal ω² l = 2 m/s² inwards.
#[test]
fn a_steady_turn_feels_centripetal_force() {
    let rate = 1.0;
    let mounting =
        MountingParameters { lever_arm_m: Vector3::new(2.0, 0.0, 0.0), ..MountingParameters::default() };
    let mut simulator = mounted(&options_at(100.0), &mounting);
    let mut alone = Simulator::new(&options_at(100.0)).unwrap();
    for k in 0..200 {
        let time_s = f64::from(k) / 100.0;
        let euler = Euler { heading: -rate * time_s, ..Euler::default() };
        let sample = FlightSample { euler, ..resting_sample(time_s) };
        step(&mut simulator, &sample);
        step(&mut alone, &sample);
        let (Some(imu), Some(alone)) = (simulator.imu(), alone.imu()) else { continue };
        let felt = (imu.ideal.velocity - alone.ideal.velocity) / imu.interval_s;
        let total = rate + EARTH_RATE * (39.9 * DEG).sin();
        // The gradient of gravitation adds 1.5e-6 /s² · 2 m along the arm; the Earth's north rate couples with 1e-4 of the rate.
        assert!((felt.x + total * total * 2.0).abs() < 1e-5, "{felt:?}");
        assert!(felt.yz().norm() < 3e-4, "{felt:?}");
    }
    let errors = errors(&simulator, ErrorSource::Navigation);
    assert!(errors.position_n.norm() < 1e-8 && errors.velocity_n.norm() < 1e-8, "{errors:?}");
}

/// The host gives angular rate and specific force of the reference point along the body axes: with these signals, perfect
/// sensors navigate to the truth as well.
#[test]
fn the_hosts_own_signals_are_moved_to_the_block() {
    let flight = aerobatics();
    let mut host = Simulator::new(&options_at(400.0)).unwrap();
    let mut given = Vec::new();
    let fine = samples(&flight, 400.0);
    for (k, sample) in fine.iter().enumerate() {
        step(&mut host, sample);
        if let (Some(imu), true) = (host.imu(), k % 8 == 4) {
            // Means over 2.5 ms, centred 1.25 ms before the sample. No sample has the rate and the force of half an interval
            // before it, so the host's flight is sampled at the centre.
            let time_s = sample.time_s - 0.5 * imu.interval_s;
            given.push(FlightSample {
                omega_ib_b: Some(imu.ideal.angle / imu.interval_s),
                f_b: Some(imu.ideal.velocity / imu.interval_s),
                ..flight.sample_at(time_s).unwrap()
            });
        }
    }
    let options = Options { vertical: VerticalMode::FollowTruth, ..Options::default() };
    let alone = fly(&mut Simulator::new(&options).unwrap(), given.iter().copied(), 1);
    let moved = fly(&mut mounted(&options, &off_centre()), given.iter().copied(), 1);
    println!("host's signals at 50 Hz: {moved:?}, without a mounting {alone:?}");
    assert!(moved.position_m < SHARE_OF_THE_ARM * alone.position_m, "{moved:?} {alone:?}");
    assert!(moved.velocity_m_s < SHARE_OF_THE_ARM * alone.velocity_m_s, "{moved:?} {alone:?}");
}

/// The closed loop holds the block to the truth, so that its reference point stays there.
#[test]
fn the_closed_loop_holds_a_mounted_block() {
    // The trim counts after ten time constants: for half of the flight.
    let intake = IntakeLimits { max_gap_s: 1.0, ..options_at(50.0).intake };
    let options = Options { closed_loop_time_s: Some(5.0), intake, ..options_at(50.0) };
    let trimmed = |mounting: &MountingParameters| {
        let mut simulator = mounted(&options, mounting);
        let worst = fly(&mut simulator, samples(&aerobatics(), 50.0).into_iter(), 1);
        (worst, simulator.trim().unwrap().unwrap())
    };
    let open = worst(&options_at(50.0), 50.0, &off_centre());
    let (closed, trim) = trimmed(&off_centre());
    assert!(closed.position_m < 0.5 * open.position_m, "{closed:?} {open:?}");
    // With a mounting that the INS assumes wrongly the INS errs and the shadow does not: the trim is the same, to the bit.
    let (erring, same) = trimmed(&wrongly_believed());
    assert!(erring.position_m > 10.0 * closed.position_m, "{erring:?}");
    assert!(trim.force_m_s2 > 0.0 && trim.rate_rad_s > 0.0, "{trim:?}");
    assert_eq!(same, trim);
}

/// Before the first step the solution is that of the coming step: a vehicle that starts in a roll has the rate of its first two
/// samples. Later samples correct the rate; the block's velocity follows, in the truth and in the solution, without an error.
#[test]
fn a_start_in_a_roll_has_the_blocks_velocity() {
    let flight = flight(&[Manoeuvre::Roll { duration_s: 5.0, turns: 1.0 }]);
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        let scheme = Scheme::Polynomial;
        let options = Options { frame, scheme, subsamples: 4, error_model: true, ..options_at(100.0) };
        let mut simulator = mounted(&options, &off_centre());
        for k in 0..100 {
            simulator.push_sample(&flight.sample_at(1.5 + f64::from(k) / 100.0).unwrap()).unwrap();
            if k > 0 {
                assert_eq!(simulator.step().unwrap(), Step::Done);
            }
            for source in [ErrorSource::Navigation, ErrorSource::Model] {
                let errors = errors(&simulator, source);
                // Eight roundings of a position in Earth-fixed axes.
                assert!(errors.position_n.norm() < 8e-9, "{frame:?} {source:?} {k}: {errors:?}");
                assert!(errors.velocity_n.norm() < 1e-9, "{frame:?} {source:?} {k}: {errors:?}");
            }
        }
    }
}
