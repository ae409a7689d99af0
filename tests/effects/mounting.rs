//! A sensor block off the reference point: perfect sensors still navigate to the truth, and what the INS believes wrongly of
//! the mounting comes out as in closed form, in both error data.

use crate::support::{DEG, DEG_PER_HOUR, G, Worst, fly, options_at, resting_sample};
use nalgebra::{Quaternion, Vector3};
use sins::errors::NavigationErrors;
use sins::flight::{Flight, FlightStart, Manoeuvre};
use sins::math::{Euler, attitude_from_euler, rotate, rotate_inverse};
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::mounting::MountingParameters;
use sins::sensors::{InitialErrorParameters, TriadParameters};
use sins::signal::Increment;
use sins::state::BodyAxes;
use sins::truth::{FlightSample, IntakeLimits};
use sins::{ErrorKind, ErrorSource, Options, Simulator, Step};

const EARTH_RATE: f64 = 7.292_115e-5;

fn flight(manoeuvres: &[Manoeuvre]) -> Flight {
    let start = FlightStart {
        latitude_rad: 45.0 * DEG,
        longitude_rad: 0.3,
        height_m: 4000.0,
        speed_m_s: 180.0,
        heading_rad: 1.0,
        ..Default::default()
    };
    Flight::new(&start, manoeuvres).unwrap()
}

/// Rolls of up to 160 °/s, a loop and a turn of 4 to 5 g.
fn aerobatics() -> Flight {
    flight(&[
        Manoeuvre::STurn { duration_s: 30.0, heading_amplitude_rad: 0.6, cycles: 2.0, ramp_s: 6.0 },
        Manoeuvre::Roll { duration_s: 5.0, turns: 1.0 },
        Manoeuvre::Loop { duration_s: 35.0, turns: 1.0, ramp_s: 5.0 },
        Manoeuvre::Turn { heading_change_rad: 3.6, bank_rad: 1.35, ramp_s: 3.0 },
        Manoeuvre::Roll { duration_s: 10.0, turns: -2.0 },
    ])
}

fn samples(flight: &Flight, rate_hz: f64) -> Vec<FlightSample> {
    let count = (flight.duration_s() * rate_hz).floor() as usize;
    (0..=count).map(|k| flight.sample_at(k as f64 / rate_hz).unwrap()).collect()
}

/// 5.5 m off, and turned about every axis.
fn off_centre() -> MountingParameters {
    MountingParameters {
        lever_arm_m: Vector3::new(1.0, 5.0, -2.0),
        boresight: Euler { roll: 0.7, pitch: -0.3, heading: 2.0 },
        ..Default::default()
    }
}

/// What a careless installation leaves: 7 cm and some arc minutes.
fn wrongly_believed() -> MountingParameters {
    MountingParameters {
        lever_arm_error_m: Vector3::new(0.03, -0.05, 0.04),
        boresight_error: Euler { roll: 2e-4, pitch: -4e-4, heading: 6e-4 },
        ..off_centre()
    }
}

fn mounted(options: &Options, mounting: &MountingParameters) -> Simulator {
    let mut simulator = Simulator::new(options).unwrap();
    simulator.set_mounting(mounting).unwrap();
    simulator
}

fn step(simulator: &mut Simulator, sample: &FlightSample) {
    simulator.push_sample(sample).unwrap();
    simulator.step().unwrap();
}

fn errors(simulator: &Simulator, source: ErrorSource) -> NavigationErrors {
    simulator.errors(source).unwrap().unwrap().1
}

fn worst(options: &Options, rate_hz: f64, mounting: &MountingParameters) -> Worst {
    fly(&mut mounted(options, mounting), samples(&aerobatics(), rate_hz).into_iter(), 1)
}

/// An error of fourth order with a mounting, over that without: the arm's ω² l = 2.8² · 5.4 m/s² = 4 g stand beside the flight's
/// 5 g, at up to twice its frequency.
const SHARE_OF_THE_ARM: f64 = 1.0 + 4.0 / 5.0 * 16.0;

/// The arm's acceleration is integrated by the mechanization like any other: what that leaves is of its own order, the fourth,
/// and of the size of what it leaves of the flight itself. The block's signals and the way back add nothing.
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

/// An algorithm of higher order leaves what the block's signals and the way back add: gravitation along the arm, 5.4 m · 3e-6 /s²,
/// is taken in the middle of each increment, with an error of θ²/24 at θ = 2.8/800 rad: 9e-12 m/s² for 97 s.
#[test]
fn the_blocks_signals_are_those_of_a_rigid_arm() {
    let options = Options { scheme: Scheme::Polynomial, subsamples: 4, ..options_at(200.0) };
    let worst = worst(&options, 200.0, &off_centre());
    println!("polynomial, 4 subsamples, 200 Hz: {worst:?}");
    assert!(worst.position_m < 4e-8 && worst.velocity_m_s < 9e-10, "{worst:?}");
}

/// A boresight alone turns the increments and nothing else, exactly: to rounding the same navigation.
#[test]
fn a_boresight_alone_turns_the_increments() {
    for axes in [BodyAxes::RightForwardUp, BodyAxes::ForwardRightDown] {
        let options = Options { axes, ..options_at(50.0) };
        let boresight = MountingParameters { lever_arm_m: Vector3::zeros(), ..off_centre() };
        let mut alone = Simulator::new(&options).unwrap();
        let mut turned = mounted(&options, &boresight);
        // The block's axes in those of the vehicle, which both conventions take from the attitude right-forward-up.
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

/// On a carousel of ω = 1 rad/s about the vertical, an arm of 2 m feels the centripetal ω² l = 2 m/s² inwards.
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
        // Along the arm also gravitation's gradient, 1.5e-6 /s² · 2 m; the Earth's north rate couples with 1e-4 of the rate.
        assert!((felt.x + total * total * 2.0).abs() < 1e-5, "{felt:?}");
        assert!(felt.yz().norm() < 3e-4, "{felt:?}");
    }
    let errors = errors(&simulator, ErrorSource::Navigation);
    assert!(errors.position_n.norm() < 1e-8 && errors.velocity_n.norm() < 1e-8, "{errors:?}");
}

/// In straight flight a block that is believed to be turned right by b more than it is makes the vehicle's heading
/// come out b to the left, and nothing else: the block itself is navigated without error. The arm swings by b times its length.
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
        // The vertical where the INS believes to be leans by 4 m · b over the Earth's radius: 6e-10 rad.
        assert!((errors.heading_rad + b).abs() < 1e-9, "{source:?} {errors:?}");
        assert!(errors.roll_rad.abs() < 1e-9 && errors.pitch_rad.abs() < 1e-9, "{errors:?}");
        // C~ = (I - [φ×]) C: φ up turns the computed body to the right.
        assert!((errors.misalignment_n - Vector3::new(0.0, 0.0, errors.heading_rad)).norm() < 1e-9);
        // The INS looks for the reference point 4 m behind the block, along b to the left of the true heading: it
        // finds it 4 m · b to the right. The linear model drops 4 m · b²/2.
        let right = Vector3::new(heading.cos(), -heading.sin(), 0.0);
        assert!((errors.position_n - right * (4.0 * b)).norm() < 4.0 * b * b, "{source:?} {errors:?}");
        assert!(errors.velocity_n.norm() < 1e-6, "{errors:?}");
    }
}

/// In a coordinated turn an arm that is believed longer by d leaves the position by -C d and the velocity by -C (ω×d).
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
        // Once rolled in, and before rolling out.
        if !(4.0..turn.duration_s() - 4.0).contains(&sample.time_s) {
            continue;
        }
        let q_nb = simulator.truth().unwrap().unwrap().navigation.q_nb;
        // To the right: against the vertical.
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

/// Error data 1 of everything at once: sensors that err in the axes of the block, an INS with initial errors, a
/// mounting that it believes wrongly.
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

/// The vertical channel's aid is about the reference point: there it holds, whatever the INS believes of the arm.
#[test]
fn the_aided_height_is_that_of_the_reference_point() {
    let mut simulator = mounted(&options_at(50.0), &wrongly_believed());
    for (k, sample) in samples(&aerobatics(), 50.0).iter().enumerate() {
        step(&mut simulator, sample);
        let errors = errors(&simulator, ErrorSource::Navigation);
        // Roundings of a position in Earth-fixed axes; the vertical at the arm's other end leans by 9e-7 rad, and with it the
        // horizontal velocity that the correction has: 1e-5 m/s at the most.
        assert!(k == 0 || errors.position_n.z.abs() < 8e-9, "{errors:?}");
        assert!(k == 0 || errors.velocity_n.z.abs() < 1e-11, "{errors:?}");
    }
}

/// The host's angular rate and specific force are those of the reference point along the body axes: with them perfect sensors
/// navigate to the truth too.
#[test]
fn the_hosts_own_signals_are_moved_to_the_block() {
    let flight = aerobatics();
    let mut host = Simulator::new(&options_at(400.0)).unwrap();
    let mut given = Vec::new();
    let fine = samples(&flight, 400.0);
    for (k, sample) in fine.iter().enumerate() {
        step(&mut host, sample);
        if let (Some(imu), true) = (host.imu(), k % 8 == 4) {
            // Means over 2.5 ms, centred 1.25 ms before: the rate and force of the sample half an interval back are not at hand,
            // so the host's flight is sampled where these belong.
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
    // Its trim counts from ten time constants on: for half of the flight.
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
    // With a mounting that it believes wrongly the INS errs, and the shadow does not: the same trim, to the bit.
    let (erring, same) = trimmed(&wrongly_believed());
    assert!(erring.position_m > 10.0 * closed.position_m, "{erring:?}");
    assert!(trim.force_m_s2 > 0.0 && trim.rate_rad_s > 0.0, "{trim:?}");
    assert_eq!(same, trim);
}

/// No mounting is no mounting: to the bit. A reset and a reposition keep it.
#[test]
fn zero_is_off_and_the_mounting_stays() {
    let samples = samples(&flight(&[Manoeuvre::Roll { duration_s: 5.0, turns: 1.0 }]), 50.0);
    let flown = |simulator: &mut Simulator| {
        for sample in &samples {
            step(simulator, sample);
        }
        (simulator.navigation().unwrap().unwrap(), simulator.imu().unwrap())
    };
    let plain = flown(&mut Simulator::new(&Options::default()).unwrap());
    let mut simulator = mounted(&Options::default(), &MountingParameters::default());
    assert_eq!(flown(&mut simulator), plain);

    let mut simulator = mounted(&Options::default(), &wrongly_believed());
    let first = flown(&mut simulator);
    assert_ne!(first.0, plain.0);
    simulator.reset();
    assert_eq!(flown(&mut simulator), first);
    simulator.reposition(&samples[0]).unwrap();
    for sample in &samples[1..] {
        step(&mut simulator, sample);
    }
    assert_eq!((simulator.navigation().unwrap().unwrap(), simulator.imu().unwrap()), first);
    simulator.reset();
    simulator.set_mounting(&MountingParameters::default()).unwrap();
    assert_eq!(flown(&mut simulator), plain);
}

/// Before the first step the solution is that of the step to come: the rate of a vehicle that starts in a roll is that of its
/// first two samples. What more samples tell of it the block's velocity follows, in truth and in the solution: nothing is left.
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

#[test]
fn what_cannot_be_is_refused() {
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    let far = MountingParameters { lever_arm_m: Vector3::new(0.0, 101.0, 0.0), ..Default::default() };
    assert_eq!(
        simulator.set_mounting(&far).unwrap_err().to_string(),
        "mounting.lever_arm_m[1] = 101: must be from -100 to 100"
    );
    step(&mut simulator, &resting_sample(0.0));
    simulator.set_mounting(&off_centre()).unwrap();
    step(&mut simulator, &resting_sample(1.0));
    let before = simulator.navigation().unwrap();
    assert_eq!(simulator.set_mounting(&wrongly_believed()).unwrap_err().kind, ErrorKind::BadState);
    assert_eq!(simulator.navigation().unwrap(), before);
}

/// A block on a long arm in a wild spin is thrown out of its range: the step is refused and nothing has changed.
#[test]
fn an_arm_that_throws_the_block_away_is_an_error() {
    let mounting = MountingParameters { lever_arm_m: Vector3::new(0.0, 100.0, 0.0), ..Default::default() };
    let mut simulator = mounted(&Options::default(), &mounting);
    let spin = |time_s: f64, rate: f64| FlightSample {
        omega_ib_b: Some(Vector3::new(rate, 0.0, 0.0)),
        ..resting_sample(time_s)
    };
    step(&mut simulator, &spin(0.0, 0.0));
    step(&mut simulator, &spin(0.01, 0.0));
    let before = simulator.navigation().unwrap();
    simulator.push_sample(&spin(2.5, 1000.0)).unwrap();
    assert_eq!(simulator.step().unwrap_err().kind, ErrorKind::Diverged);
    assert_eq!(simulator.navigation().unwrap(), before);
}
