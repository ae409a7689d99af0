//! The alignment on measured increments.

use nalgebra::Vector3;
use sins::earth::Geodetic;
use sins::sensors::{Alignment, Grade, InitialErrorParameters, PARAMETERS, Sensor, TriadParameters};
use sins::unit::{Mode, State, StoredAlignment, UnitParameters, Validity};

use crate::aircraft::{Aircraft, Motion, papers_sensors};
use crate::support::{DEG, DEG_PER_HOUR, EARTH_RATE, G, one_unit_of};

/// An aircraft whose unit has aligned for `minutes` in `motion`.
fn aligned(
    latitude_deg: f64,
    minutes: f64,
    motion: Motion,
    run: u64,
    sensors: &(TriadParameters, TriadParameters),
) -> Aircraft {
    let rate_hz = if motion == Motion::Rest { 2.0 } else { 20.0 };
    let mut aircraft = Aircraft::new(latitude_deg, run, rate_hz, sensors);
    let parameters = UnitParameters { alignment_s: 60.0 * minutes, ..Default::default() };
    aircraft.unit.set_parameters(&parameters).unwrap();
    aircraft.unit.select(Mode::Navigate);
    aircraft.go(motion, 10.0);
    aircraft.enter_true_position();
    aircraft.until(motion, State::Navigation, 60.0 * minutes + 10.0);
    aircraft
}

/// Mean and standard deviation.
fn moments(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let variance = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / (count - 1.0);
    (mean, variance.sqrt())
}

/// With the paper's gyros: white noise gives 1.020 of N/(Ω cos L √T), a bias b/(Ω cos L). The standard deviation of 1200 runs scatters by
/// 2 %, their mean by 2.9 % of it; the bounds are 3.5 standard deviations.
#[test]
fn the_heading_error_is_that_of_theory() {
    const RUNS: u64 = 1200;
    let (gyro, _) = papers_sensors();
    for (latitude_deg, minutes) in [(0.0f64, 10.0f64), (40.0, 10.0), (75.0, 16.0)] {
        let horizontal = EARTH_RATE * (latitude_deg * DEG).cos();
        let sensors = (gyro, TriadParameters::default());
        let heading =
            |run| aligned(latitude_deg, minutes, Motion::Rest, run, &sensors).errors().misalignment_n.z;
        let (mean, sigma) = moments(&(0..RUNS).map(heading).collect::<Vec<f64>>());
        let least = gyro.random_walk.x / (horizontal * (60.0 * minutes).sqrt());
        // The bias to the east of an aircraft with a heading of 0.7 rad: both horizontal gyros.
        let east = gyro.bias.x * (0.7f64.cos() + 0.7f64.sin());
        let (of_sigma, of_mean) = (sigma / least, (mean.abs() - east / horizontal) / sigma);
        println!("{latitude_deg} deg, {minutes} min: {of_sigma:.3} of the least, mean {of_mean:+.3} sigma");
        assert!((of_sigma / 1.020 - 1.0).abs() < 0.07 && of_mean.abs() < 0.10);
    }
}

/// The start of a simulator with `alignment_s` has the mean errors of the same time. Biases that are drawn and white noise, 1000 runs
/// each: the ratio of two standard deviations scatters by 3.2 %; the bound is 4 of this and the 2 % of the windows.
#[test]
fn it_agrees_with_a_start_that_is_aligned_over_the_same_time() {
    const RUNS: u64 = 1000;
    let each = Vector3::repeat;
    let gyro = TriadParameters {
        bias_sigma: each(0.01 * DEG_PER_HOUR),
        random_walk: each(0.003 * DEG / 60.0),
        ..Default::default()
    };
    let accel =
        TriadParameters { bias_sigma: each(50e-6 * G), random_walk: each(10e-6 * G), ..Default::default() };
    let sensors = (gyro, accel);
    let unit: Vec<Vector3<f64>> = (0..RUNS)
        .map(|run| aligned(40.0, 10.0, Motion::Rest, run, &sensors).errors().misalignment_n)
        .collect();
    let start: Vec<Vector3<f64>> = (RUNS..2 * RUNS)
        .map(|run| {
            let mut aircraft = Aircraft::new(40.0, run, 2.0, &sensors);
            let initial = InitialErrorParameters {
                alignment: Alignment::LevelAndGyrocompass,
                alignment_s: 600.0,
                ..Default::default()
            };
            aircraft.simulator.set_initial_errors(&initial).unwrap();
            aircraft.stand(1.0);
            aircraft.errors().misalignment_n
        })
        .collect();
    for axis in 0..3 {
        let of = |all: &[Vector3<f64>]| moments(&all.iter().map(|one| one[axis]).collect::<Vec<f64>>()).1;
        let ratio = of(&unit) / of(&start);
        println!("axis {axis}: {ratio:.3} of {:.2e} rad", of(&start));
        assert!((ratio - 1.0).abs() < 0.15, "axis {axis}: {ratio}");
    }
}

/// A sway of 0.1° and 1 cm at 0.3 Hz does not stop the alignment. A window of 29.5 s leaves 4.6e-4 of its acceleration of 0.05 m/s²,
/// 2.4e-6 rad of the vertical, in each of two windows, which are 0.032 rad of the Earth apart.
#[test]
fn sway_in_gusts_does_no_harm() {
    let ideal = aligned(40.0, 10.0, Motion::Sway, 0, &Default::default());
    let heading = ideal.errors().misalignment_n.z.abs();
    println!("heading error in gusts: {heading:.1e} rad");
    assert!(heading < 2.0 * 2.4e-6 / 0.032);
    let sensors = papers_sensors();
    let swaying = aligned(40.0, 10.0, Motion::Sway, 3, &sensors).errors().misalignment_n;
    assert!(swaying.norm() < 5e-3);
}

/// Taxiing at 1 kt stops an alignment within 2 s; it starts anew when the aircraft has stood for 5 s, and takes its whole time. The
/// position is asked for again.
#[test]
fn taxiing_stops_it_and_rest_starts_it_anew() {
    const KNOT: f64 = 1852.0 / 3600.0;
    for after_s in [20.0, 200.0] {
        let mut aircraft = Aircraft::new(0.0, 0, 20.0, &papers_sensors());
        aircraft.unit.select(Mode::Align);
        aircraft.stand(10.0);
        aircraft.enter_true_position();
        assert!(!aircraft.stand(after_s).reasons.motion);
        let taxi = Motion::Drive { acceleration: 0.5, to: KNOT };
        let status = aircraft.go(taxi, 2.0);
        assert!(status.reasons.motion && status.align_flashes && status.state == State::CoarseAlignment);
        aircraft.go(taxi, 5.0);
        aircraft.go(Motion::Drive { acceleration: 0.5, to: 0.0 }, 2.0);
        let again = aircraft.until(Motion::Rest, State::FineAlignment, 80.0);
        assert!(aircraft.unit.status().reasons.no_position);
        aircraft.enter_true_position();
        assert!((30.0..70.0).contains(&again), "{again}");
        let ready = again + aircraft.until(Motion::Rest, State::Ready, 310.0);
        assert!(ready > 300.0, "{ready}");
        assert!(aircraft.errors().misalignment_n.z.abs() < 8e-3);
    }
}

/// With perfect sensors nothing is left, at any latitude and after any time: of a gyrocompass, of an alignment with the stored heading,
/// and of a realignment. A rounding of ε a sample in the attitude is divided by the motion of the vertical where this shows north. The
/// mean of a window of the length a is exact up to terms of (Ω a)⁴/1000.
#[test]
fn perfect_sensors_leave_no_tilt() {
    for latitude_deg in [-75.0, 0.0, 40.0, 80.0] {
        let mut compass = Aircraft::ideal(latitude_deg);
        compass.align();
        let left = compass.errors().misalignment_n.norm();
        let motion = EARTH_RATE * 300.0 * (latitude_deg * DEG).cos();
        assert!(left < f64::EPSILON * 10.0 * 1100.0 / motion, "{latitude_deg}: {left:e} rad");
        for length_s in [20.0, 90.0, 180.0, 600.0] {
            let mut aircraft = Aircraft::ideal(latitude_deg);
            let parameters = UnitParameters {
                stored_heading_alignment_s: length_s,
                realignment_s: length_s,
                ..Default::default()
            };
            aircraft.unit.set_parameters(&parameters).unwrap();
            aircraft.unit.set_alignment(sins::unit::AlignmentKind::StoredHeading);
            let Geodetic { latitude_rad, longitude_rad, .. } = aircraft.place();
            let heading_rad = aircraft.heading();
            aircraft
                .unit
                .set_stored(Some(StoredAlignment { latitude_rad, longitude_rad, heading_rad }))
                .unwrap();
            aircraft.unit.select(Mode::Navigate);
            aircraft.stand(10.0);
            aircraft.enter_true_position();
            for what in ["stored heading", "realignment"] {
                aircraft.until(Motion::Rest, State::Navigation, length_s + 60.0);
                let left = aircraft.errors().misalignment_n.norm();
                let limit = f64::EPSILON * 10.0 * length_s + (EARTH_RATE * length_s).powi(4) / 1000.0;
                assert!(left < limit.max(1e-13), "{latitude_deg}, {length_s} s, {what}: {left:e} rad");
                aircraft.unit.select(Mode::Align);
                aircraft.stand(1.0);
                aircraft.unit.select(Mode::Navigate);
            }
        }
    }
}

/// Sensors with one effect of a usual size at a time, and those of each grade: a right position is not refused. Flicker of the gyros and
/// of the accelerometers was.
#[test]
fn a_right_position_is_not_refused() {
    const RUNS: u64 = 40;
    let none = TriadParameters::default();
    let grades = [
        Grade::Strategic,
        Grade::Navigation,
        Grade::Tactical,
        Grade::Industrial,
        Grade::Consumer,
        Grade::PaperSimulation2,
    ];
    let mut cases: Vec<(String, (TriadParameters, TriadParameters))> =
        grades.map(|grade| (format!("{grade:?}"), grade.parameters())).into();
    for parameter in PARAMETERS {
        for (sensor, size) in [(Sensor::Gyro, 0.1), (Sensor::Gyro, 3.0), (Sensor::Accelerometer, 300.0)] {
            let mut one = one_unit_of(sensor, size, |other| other.name == parameter.name);
            one.markov_time_s = Vector3::repeat(300.0);
            let sensors = if sensor == Sensor::Gyro { (one, none) } else { (none, one) };
            if parameter.of(sensor).is_some() {
                cases.push((format!("{} of {sensor:?}, {size} units", parameter.name), sensors));
            }
        }
    }
    for (name, sensors) in cases {
        for run in 0..RUNS {
            let mut aircraft = Aircraft::new(45.0, run, 2.0, &sensors);
            aircraft.warming = Some(0.01);
            aircraft.unit.select(Mode::Align);
            aircraft.stand(20.0);
            aircraft.enter_true_position();
            let status = aircraft.stand(700.0);
            assert!(!status.reasons.latitude_disagrees && !status.fault, "{name}, run {run}: {status:?}");
        }
    }
}

/// A start that is too slow to be felt: the tilt of its acceleration is at most that over the time until the aircraft has left its place.
#[test]
fn a_slow_start_stops_it() {
    for acceleration in [0.003, 0.01, 0.04] {
        for at_s in [100.0, 120.0, 400.0] {
            let mut aircraft = Aircraft::ideal(40.0);
            aircraft.unit.select(Mode::Align);
            aircraft.stand(10.0);
            aircraft.enter_true_position();
            aircraft.stand(at_s);
            let mut seconds = 0.0;
            while !aircraft.unit.status().reasons.motion {
                aircraft.go(Motion::Drive { acceleration, to: 2.0 }, 0.1);
                seconds += 0.1;
            }
            // 0.2 m at this acceleration.
            assert!(seconds < f64::sqrt(0.4 / acceleration) + 0.3, "{seconds}");
            let status = aircraft.go(Motion::Drive { acceleration, to: 2.0 }, 60.0);
            assert!(status.reasons.motion && status.state == State::CoarseAlignment, "{status:?}");
        }
    }
}

/// Another kind begins the alignment anew, with nothing of the old one, and such a unit can be saved.
#[test]
fn another_kind_begins_it_anew() {
    use sins::unit::AlignmentKind::{Fast, Gyrocompass, InFlight, StoredHeading};
    for (before, after) in
        [(InFlight, Gyrocompass), (Gyrocompass, InFlight), (StoredHeading, Gyrocompass), (Gyrocompass, Fast)]
    {
        for seconds in [20.0, 50.0, 600.0] {
            let mut aircraft = Aircraft::ideal(40.0);
            aircraft.receiver = Some(crate::aircraft::Receiver::new(1, 3.0, 0.1));
            aircraft.unit.set_alignment(before);
            aircraft.unit.select(Mode::Align);
            aircraft.stand(10.0);
            aircraft.enter_true_position();
            aircraft.stand(seconds);
            aircraft.unit.set_alignment(after);
            for _ in 0..700 {
                let status = aircraft.stand(1.0);
                let shown = aircraft.navigation();
                let mut buffer = vec![0; sins::abi::SINS_UNIT_SNAPSHOT_MAX_SIZE];
                let length = aircraft.unit.save_snapshot(&mut buffer).unwrap();
                let mut loaded = aircraft.unit;
                loaded.load_snapshot(&buffer[..length]).unwrap();
                assert!(loaded == aircraft.unit);
                let Validity { attitude, heading, .. } = status.validity;
                // The first window of a gyrocompass is up to 46 s old, in which the Earth turns the vertical; the first two of an
                // alignment in flight are up to 75 s old, and show 294 m/s with fixes of 0.1 m/s.
                let of_fixes =
                    if after == InFlight { 29.0 * EARTH_RATE + 5.0 * 0.1 * 2f64.sqrt() / 294.0 } else { 0.0 };
                let tilt = 46.0 * EARTH_RATE + of_fixes;
                assert!(!attitude || shown.euler.roll.abs().max(shown.euler.pitch.abs()) < tilt, "{shown:?}");
                let error = sins::math::wrap_angle(shown.euler.heading - aircraft.heading());
                assert!(
                    !heading || error.abs() < 5.0 * 0.1 * DEG,
                    "{before:?} {after:?} {seconds}: {status:?} {error}"
                );
            }
        }
    }
}

/// With the stored heading it takes 90 s, and has the heading that was stored.
#[test]
fn a_stored_heading_shortens_it() {
    let mut aircraft = Aircraft::ideal(60.0);
    aircraft.align();
    aircraft.unit.select(Mode::Off);
    aircraft.stand(10.0);
    aircraft.unit.set_alignment(sins::unit::AlignmentKind::StoredHeading);
    aircraft.unit.select(Mode::Navigate);
    aircraft.stand(10.0);
    aircraft.enter_true_position();
    let seconds = 10.0 + aircraft.until(Motion::Rest, State::Navigation, 100.0);
    assert!((seconds - 95.0).abs() < 0.5, "{seconds}");
    assert!(aircraft.errors().misalignment_n.norm() < 1e-9, "{:?}", aircraft.errors());
}
