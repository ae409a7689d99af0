//! The host's time or its truth jumps and the INS keeps its errors: a pause, a slew. Those read right after are those before, and
//! from there the flight goes on.

use crate::support::moments::{altimeter, every_effect, initial, reads, snapshot};
use crate::support::{options_at, patrol, resting_sample};
use nalgebra::Vector3;
use sins::earth::Geodetic;
use sins::errors::NavigationErrors;
use sins::math::Euler;
use sins::mechanization::{Frame, VerticalMode};
use sins::mounting::MountingParameters;
use sins::sensors::InitialErrorParameters;
use sins::state::Navigation;
use sins::truth::{FlightSample, IntakeLimits, Pushed};
use sins::{ErrorKind, ErrorSource, Options, Simulator, Step};

fn fly(simulator: &mut Simulator, samples: &[FlightSample]) {
    for sample in samples {
        simulator.push_sample(sample).unwrap();
        simulator.step().unwrap();
    }
}

/// With every error that there is, but initial ones that need no alignment.
fn troubled(options: &Options) -> Simulator {
    let mut simulator = Simulator::new(options).unwrap();
    let (gyro, accel) = every_effect();
    simulator.set_gyro(&gyro).unwrap();
    simulator.set_accel(&accel).unwrap();
    simulator.set_altimeter(&altimeter()).unwrap();
    simulator
        .set_initial_errors(&InitialErrorParameters { alignment: Default::default(), ..initial() })
        .unwrap();
    simulator
}

fn errors(simulator: &Simulator, source: ErrorSource) -> NavigationErrors {
    simulator.errors(source).unwrap().unwrap().1
}

/// What is read but times.
fn without_times(simulator: &Simulator) -> String {
    let solution =
        |solution: sins::Solution| (solution.navigation, solution.near_pole, solution.vertical_unaided);
    let imu = simulator.imu().map(|imu| (imu.interval_s, imu.ideal, imu.measured, imu.flags));
    let model = simulator.errors(ErrorSource::Model).map(|errors| errors.map(|(_, errors)| errors));
    format!(
        "{:?}",
        (
            simulator.truth().unwrap().map(solution),
            simulator.navigation().unwrap().map(solution),
            (imu, errors(simulator, ErrorSource::Navigation), model, simulator.intervals()),
        )
    )
}

/// The clock ran on by hours, or was set to 1970 and back, with samples waiting: each further read is that of the flight whose
/// stamps never jumped, to the bit. Stamps at 128 Hz are exact up to 2^46 s; with a stated period no difference is needed.
#[test]
fn a_pause_that_is_moved_leaves_no_bit_behind() {
    let flight = patrol(1200.0);
    let stated = IntakeLimits { period_s: Some(0.01), ..Default::default() };
    let model = Options { error_model: true, ..Options::default() };
    let closed = Options { closed_loop_time_s: Some(20.0), frame: Frame::Geographic, ..model };
    let cases = [
        (model, 1.0 / 128.0, 0.0, true),
        (closed, 1.0 / 128.0, 0.0, true),
        (Options { vertical: VerticalMode::Free, ..model }, 1.0 / 128.0, 0.0, false),
        // With a period, stamps that are off it by up to 0.15 of it.
        (Options { intake: stated, ..model }, 0.01, 0.15, true),
    ];
    for (options, period_s, jitter, with_velocity) in cases {
        let sample = |k: usize| {
            let mut sample = flight.sample_at(300.0 + k as f64 * period_s).unwrap();
            sample.time_s += jitter * period_s * ((k * 37 % 7) as f64 / 3.5 - 1.0);
            sample.v_n = sample.v_n.filter(|_| with_velocity);
            sample
        };
        let (mut straight, mut paused) = (troubled(&options), troubled(&options));
        let mut shift_s = 0.0;
        for k in 0..600 {
            let sample = sample(k);
            straight.push_sample(&sample).unwrap();
            paused.push_sample(&FlightSample { time_s: sample.time_s + shift_s, ..sample }).unwrap();
            if [100, 200, 201, 300].contains(&k) {
                shift_s = [3600.0, 1_700_000_000.0, -5000.0, 0.0][k % 4];
                paused.move_time(sample.time_s + shift_s).unwrap();
                // A snapshot of that moment is the same simulator.
                let mut loaded = Simulator::new(&Options::default()).unwrap();
                loaded.load_snapshot(&snapshot(&paused)).unwrap();
                assert_eq!((reads(&loaded), snapshot(&loaded)), (reads(&paused), snapshot(&paused)));
                paused = loaded;
            }
            // Three samples wait.
            if k > 3 {
                assert_eq!((straight.step(), paused.step()), (Ok(Step::Done), Ok(Step::Done)));
                assert_eq!(without_times(&paused), without_times(&straight), "sample {k}");
            }
        }
        let accuracy = |simulator: &Simulator| simulator.accuracy().unwrap().unwrap().1;
        let (a, b) = (accuracy(&paused), accuracy(&straight));
        // Moved to 1.7e9 s, where a stamp is rounded to 2.4e-7 s, and back.
        assert!((a.duration_s - b.duration_s).abs() < 1e-6 && a.velocity_rms_n == b.velocity_rms_n);
        assert!(paused.truth().unwrap().unwrap().time_s.abs() < 1e4);
    }
}

/// A trainer that is paused for an hour: reposition loses the drift, a moved time keeps it to the bit.
#[test]
fn a_paused_trainer_keeps_its_drift() {
    let mut trainer = troubled(&Options::default());
    let samples: Vec<_> = (0..3000).map(|k| resting_sample(f64::from(k) * 0.02)).collect();
    fly(&mut trainer, &samples);
    let drift = errors(&trainer, ErrorSource::Navigation).position_n;
    let later = samples[2999].time_s + 3600.0;
    trainer.move_time(later).unwrap();
    assert_eq!(errors(&trainer, ErrorSource::Navigation).position_n, drift);
    assert_eq!(trainer.truth().unwrap().unwrap().time_s, later);
    assert_eq!(trainer.push_sample(&resting_sample(later + 0.02)), Ok(Pushed::Regular));
    trainer.reposition(&resting_sample(later + 0.02)).unwrap();
    assert_ne!(errors(&trainer, ErrorSource::Navigation).position_n, drift);
}

/// A sample elsewhere.
fn elsewhere(time_s: f64, latitude_deg: f64, height_m: f64, speed_m_s: f64) -> FlightSample {
    let place = Geodetic { latitude_rad: latitude_deg.to_radians(), longitude_rad: -2.5, height_m };
    let euler = Euler { roll: -0.4, pitch: 0.2, heading: 5.0 };
    let v_n = Some(Vector3::new(-0.6, 0.8, 0.02) * speed_m_s);
    FlightSample { v_n, ..FlightSample::at_rest(time_s, place, euler) }
}

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
                fly(&mut simulator, &samples);
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
    fly(&mut simulator, &(0..200).map(|k| resting_sample(f64::from(k) * 0.02)).collect::<Vec<_>>());
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
        fly(&mut simulator, &(0..3000).map(|k| resting_sample(f64::from(k) * 0.01)).collect::<Vec<_>>());
        let flown: Vec<_> = (0..6000)
            .map(|k| flight.sample_at(300.0 + f64::from(k) / 100.0).unwrap())
            .map(|sample| FlightSample { v_n: sample.v_n.filter(|_| with_velocity), ..sample })
            .collect();
        simulator.move_truth(&flown[0]).unwrap();
        fly(&mut simulator, &flown[1..]);
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
        fly(&mut simulator, &(0..300).map(|k| resting_sample(f64::from(k) * 0.01)).collect::<Vec<_>>());
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
        fly(&mut slewed, &[turned(f64::from(k) * 0.01)]);
        fly(&mut stayed, &[resting_sample(f64::from(k - 1) * 0.01)]);
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

/// What cannot be moved is refused, and nothing has changed.
#[test]
fn a_move_that_makes_no_sense_is_refused() {
    let refused = |simulator: &mut Simulator,
                   kind: ErrorKind,
                   call: &dyn Fn(&mut Simulator) -> Result<(), sins::Error>| {
        let before = (reads(simulator), snapshot(simulator));
        let error = call(simulator).unwrap_err();
        assert_eq!(error.kind, kind, "{error}");
        assert!((reads(simulator), snapshot(simulator)) == before, "{error}");
    };
    let mut simulator = troubled(&Options { frame: Frame::Geographic, ..Options::default() });
    refused(&mut simulator, ErrorKind::BadState, &|simulator| simulator.move_time(5.0));
    fly(&mut simulator, &[resting_sample(0.0), resting_sample(0.02)]);
    for time_s in [f64::NAN, f64::INFINITY, 9.99999e9, 1e10, -1e10] {
        refused(&mut simulator, ErrorKind::InvalidArgument, &|simulator| simulator.move_time(time_s));
    }
    let pole = elsewhere(0.0, 89.999, 0.0, 0.0);
    refused(&mut simulator, ErrorKind::Singular, &|simulator| simulator.move_truth(&pole));
    let nowhere = FlightSample { time_s: f64::NAN, ..resting_sample(1.0) };
    refused(&mut simulator, ErrorKind::InvalidArgument, &|simulator| simulator.move_truth(&nowhere));

    let mut navigator = Simulator::new(&Options::default()).unwrap();
    let sample = resting_sample(0.0);
    let q_nb = sins::math::attitude_from_euler(&sample.euler);
    navigator
        .start_navigation(0.0, &Navigation::new(sample.place, Vector3::zeros(), q_nb, Default::default()))
        .unwrap();
    refused(&mut navigator, ErrorKind::BadState, &|navigator| navigator.move_time(5.0));
    refused(&mut navigator, ErrorKind::BadState, &|navigator| navigator.move_truth(&sample));

    // Before the first step a slew is a reposition.
    let (mut slewed, mut repositioned) = (troubled(&Options::default()), troubled(&Options::default()));
    slewed.push_sample(&resting_sample(0.0)).unwrap();
    slewed.move_truth(&sample).unwrap();
    repositioned.reposition(&sample).unwrap();
    assert_eq!(reads(&slewed), reads(&repositioned));
}

/// The interval of a gap is told when its sample is pushed: by the library's own rule, of the two intervals before.
/// At either end of the time that there is: stamps before and behind their place in the stated period are still read back.
#[test]
fn a_flight_at_the_ends_of_time_is_saved_and_loaded() {
    let options = Options {
        intake: IntakeLimits { period_s: Some(0.01), ..IntakeLimits::default() },
        ..Options::default()
    };
    for end_s in [-9.99998e9, 9.99998e9] {
        for off_s in [-0.003, 0.003] {
            let mut simulator = Simulator::new(&options).unwrap();
            for time_s in [0.0, 0.01, 0.02 + off_s] {
                simulator.push_sample(&resting_sample(time_s)).unwrap();
            }
            simulator.move_time(end_s).unwrap();
            let saved = snapshot(&simulator);
            let mut loaded = Simulator::new(&options).unwrap();
            loaded.load_snapshot(&saved).unwrap();
            assert!(snapshot(&loaded) == saved, "{end_s} {off_s}");
        }
    }
}

#[test]
fn a_gap_is_told_by_its_push() {
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    // Intervals of 1, 0.02, 0.02, 0.04, 0.09, 0.11, 0.29, 0.71, 0.02, 1.75 and 0.02 s, then of 4.4 times 0.02 s, less than 1.75 s.
    let stamps = [0.0, 1.0, 1.02, 1.04, 1.08, 1.17, 1.28, 1.57, 2.28, 2.30, 4.05, 4.07, 4.158];
    let (mut before, mut last, mut gaps): ([f64; 2], f64, Vec<f64>) = ([0.0; 2], 0.0, Vec::new());
    for time_s in stamps {
        let interval: f64 = time_s - last;
        let usual = before[0].max(before[1]);
        let is_gap = usual > 0.0 && interval > 2.5 * usual;
        if simulator.push_sample(&resting_sample(time_s)).unwrap() == Pushed::BehindGap {
            gaps.push(time_s);
        }
        assert_eq!(gaps.last() == Some(&time_s), is_gap, "{time_s}");
        (before, last) = ([interval, before[0]], time_s);
    }
    assert_eq!(gaps, [1.57]);
    // A second that the clock ran on, at 100 Hz.
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    fly(&mut simulator, &(0..10).map(|k| resting_sample(f64::from(k) * 0.01)).collect::<Vec<_>>());
    assert_eq!(simulator.push_sample(&resting_sample(1.1)), Ok(Pushed::BehindGap));
}

/// A first stamp of -0 with a stated period is the same in a snapshot that was loaded.
#[test]
fn a_first_stamp_of_minus_zero_is_zero() {
    let options =
        Options { intake: IntakeLimits { period_s: Some(0.02), ..Default::default() }, ..Default::default() };
    let mut simulator = Simulator::new(&options).unwrap();
    simulator.push_sample(&resting_sample(-0.0)).unwrap();
    let mut loaded = Simulator::new(&Options::default()).unwrap();
    loaded.load_snapshot(&snapshot(&simulator)).unwrap();
    assert_eq!((reads(&loaded), snapshot(&loaded)), (reads(&simulator), snapshot(&simulator)));
    assert!(simulator.truth().unwrap().unwrap().time_s.is_sign_positive());
}
