//! A gyrocompass ends when its heading is as accurate as the limit: sensors that are too poor to find north show no heading.

use nalgebra::Vector3;
use sins::sensors::{Alignment, Grade, InitialErrorParameters, TriadParameters};
use sins::unit::{AlignmentKind, Mode, State, Status, StoredAlignment, Unit, UnitParameters, Validity};

use crate::aircraft::{Aircraft, Motion, Receiver};
use crate::support::{DEG, DEG_PER_HOUR, EARTH_RATE, G};

type Sensors = (TriadParameters, TriadParameters);

/// A unit at NAV behind the time of a gyrocompass, with one window more.
fn aligned(latitude_deg: f64, run: u64, sensors: &Sensors, parameters: UnitParameters) -> Aircraft {
    let mut aircraft = Aircraft::new(latitude_deg, run, 2.0, sensors);
    aircraft.unit.set_parameters(&parameters).unwrap();
    aircraft.unit.select(Mode::Navigate);
    aircraft.stand(20.0);
    aircraft.enter_true_position();
    let alignment_s = 60.0 * (5.0 + 0.002 * latitude_deg * latitude_deg);
    aircraft.stand(if parameters.alignment_s > 0.0 { parameters.alignment_s } else { alignment_s } + 30.0);
    aircraft
}

fn shows_north(status: &Status) -> bool {
    let valid = status.validity;
    let waits = status.reasons.north_unknown;
    assert_eq!(status.align_flashes, waits, "{status:?}");
    assert_eq!(status.state, if waits { State::FineAlignment } else { State::Navigation }, "{status:?}");
    assert!(valid.attitude && valid.rates, "{status:?}");
    assert!([valid.heading, valid.position, valid.velocity] == [!waits; 3], "{status:?}");
    !waits
}

/// At every latitude at which the unit aligns: strategic and navigation grade find north, poorer grades do not.
#[test]
fn grades_that_do_not_find_north_show_no_heading() {
    for (grade, finds) in [
        (Grade::Strategic, true),
        (Grade::Navigation, true),
        (Grade::PaperSimulation2, true),
        (Grade::Tactical, false),
        (Grade::Industrial, false),
    ] {
        for latitude_deg in [0.0, -45.0, 70.0, 81.9] {
            for run in 0..3 {
                let aircraft = aligned(latitude_deg, run, &grade.parameters(), Default::default());
                let status = aircraft.unit.status();
                assert_eq!(shows_north(&status), finds, "{grade:?} at {latitude_deg}: {status:?}");
            }
        }
    }
}

/// No heading on the way either, from the half of the time on.
#[test]
fn a_heading_that_is_not_found_is_never_shown() {
    let mut aircraft = Aircraft::new(45.0, 1, 2.0, &Grade::Industrial.parameters());
    aircraft.unit.select(Mode::Align);
    aircraft.stand(20.0);
    aircraft.enter_true_position();
    for second in 0..1800 {
        let status = aircraft.stand(1.0);
        assert!(!status.validity.heading && !status.validity.position, "{second} s: {status:?}");
    }
    // With a limit that accepts each heading it is ready at the next window.
    let parameters = UnitParameters { heading_limit_rad: 4.0, ..Default::default() };
    aircraft.unit.set_parameters(&parameters).unwrap();
    aircraft.until(Motion::Rest, State::Ready, 31.0);
    // With a limit that it does not reach any more it is not.
    aircraft.unit.set_parameters(&UnitParameters::default()).unwrap();
    let status = aircraft.stand(31.0);
    assert!(status.reasons.north_unknown && !status.validity.heading, "{status:?}");
}

/// A stored heading, fixes, and what only a simulation can do need no north.
#[test]
fn other_kinds_do_as_before() {
    for kind in [AlignmentKind::StoredHeading, AlignmentKind::InFlight, AlignmentKind::Fast] {
        let mut aircraft = Aircraft::new(45.0, 1, 10.0, &Grade::Tactical.parameters());
        let (latitude_rad, longitude_rad) = (aircraft.place().latitude_rad, aircraft.place().longitude_rad);
        let stored = StoredAlignment { latitude_rad, longitude_rad, heading_rad: aircraft.heading() };
        aircraft.unit.set_stored(Some(stored)).unwrap();
        aircraft.set_alignment(kind);
        aircraft.receiver = Some(Receiver::new(1, 3.0, 0.05));
        aircraft.unit.select(Mode::Navigate);
        let moves = kind == AlignmentKind::InFlight;
        let motion = if moves { Motion::Drive { acceleration: 2.0, to: 200.0 } } else { Motion::Rest };
        aircraft.go(motion, 20.0);
        if !moves {
            aircraft.enter_true_position();
        }
        for turn in 0..20 {
            let turns = moves && turn % 3 == 1;
            aircraft.go(if turns { Motion::Turn(3.0 * DEG) } else { motion }, 20.0);
        }
        let status = aircraft.unit.status();
        assert!(status.state == State::Navigation && status.validity.heading, "{kind:?}: {status:?}");
    }
}

/// A unit at NAV, whose simulator has looked for north with this bias of a horizontal gyro.
fn started(bias_deg_h: f64, latitude_deg: f64) -> Aircraft {
    let gyro = TriadParameters { bias: Vector3::x() * (bias_deg_h * DEG_PER_HOUR), ..Default::default() };
    let mut aircraft = Aircraft::new(latitude_deg, 1, 10.0, &(gyro, TriadParameters::default()));
    let initial = InitialErrorParameters {
        alignment: Alignment::LevelAndGyrocompass,
        ..InitialErrorParameters::default()
    };
    aircraft.simulator.set_initial_errors(&initial).unwrap();
    aircraft.unit = Unit::new(&UnitParameters::default(), Mode::Navigate).unwrap();
    aircraft.stand(1.0);
    aircraft
}

fn is_without_north(aircraft: &Aircraft) -> bool {
    let status = aircraft.unit.status();
    let is_known = !status.reasons.north_unknown;
    assert_eq!(aircraft.simulator.navigation().unwrap().unwrap().north_unknown, !is_known, "{status:?}");
    let (heading, position, velocity) = (is_known, is_known, is_known);
    assert_eq!(status.validity, Validity { rates: true, attitude: true, heading, position, velocity });
    assert_eq!(aircraft.navigation().validity, status.validity);
    assert_eq!(status.state, State::Navigation);
    !is_known
}

/// A simulator that starts without north gives a unit at NAV neither heading nor position, until it starts anew with better gyros.
#[test]
fn a_start_without_north_is_attitude_alone() {
    let mut hidden = 0;
    for bias_deg_h in [0.01, 3.0, 12.0, 17.0, 60.0] {
        for latitude_deg in [0.0, 60.0, -75.0] {
            let mut aircraft = started(bias_deg_h, latitude_deg);
            let is_hidden = bias_deg_h * DEG_PER_HOUR > EARTH_RATE * (latitude_deg * DEG).cos();
            hidden += u32::from(is_hidden);
            assert_eq!(is_without_north(&aircraft), is_hidden, "{bias_deg_h} at {latitude_deg}");
            aircraft.go(Motion::Drive { acceleration: 2.0, to: 50.0 }, 60.0);
            assert_eq!(is_without_north(&aircraft), is_hidden, "{bias_deg_h} at {latitude_deg}");
            aircraft.simulator.reset();
            aircraft.stand(1.0);
            assert_eq!(is_without_north(&aircraft), is_hidden, "{bias_deg_h} at {latitude_deg}");
            aircraft.simulator.set_gyro(&TriadParameters::default()).unwrap();
            aircraft.simulator.reset();
            aircraft.stand(1.0);
            assert!(!is_without_north(&aircraft), "{bias_deg_h} at {latitude_deg}");
        }
    }
    assert_eq!(hidden, 8);
}

/// What was not valid is not stored, and not kept in a realignment. When the unit has aligned, north is known, also to the simulator.
#[test]
fn a_start_without_north_ends_with_an_alignment() {
    let mut aircraft = started(60.0, 45.0);
    assert!(is_without_north(&aircraft));
    let mut off = aircraft.clone();
    off.unit.select(Mode::Off);
    let status = off.stand(20.0);
    assert!(status.state == State::Off && status.stored.is_none(), "{status:?}");

    let (latitude_rad, longitude_rad) = (aircraft.place().latitude_rad, aircraft.place().longitude_rad);
    aircraft.set_alignment(AlignmentKind::Fast);
    aircraft.unit.select(Mode::Align);
    let status = aircraft.stand(1.0);
    assert_eq!((status.state, status.reasons.north_unknown), (State::CoarseAlignment, false), "{status:?}");
    aircraft.until(Motion::Rest, State::Ready, 200.0);
    aircraft.unit.select(Mode::Navigate);
    aircraft.stand(1.0);
    assert!(!is_without_north(&aircraft));
    let shown = aircraft.navigation();
    // 60 °/h turn by 3e-4 rad in each of the last seconds.
    assert!((shown.euler.heading - aircraft.heading()).abs() < 1e-3, "{shown:?}");
    let off = [shown.place.latitude_rad - latitude_rad, shown.place.longitude_rad - longitude_rad];
    assert!(off.iter().all(|angle| angle.abs() < 1e-5), "{shown:?}");

    // Parked with a heading: a realignment. A start anew in it loses the heading again.
    aircraft.unit.select(Mode::Align);
    assert_eq!(aircraft.stand(1.0).state, State::Realignment);
    aircraft.simulator.reset();
    let status = aircraft.stand(1.0);
    assert_eq!((status.state, status.reasons.north_unknown), (State::CoarseAlignment, false), "{status:?}");
    assert!(!status.validity.heading);
}

/// The standard deviation is that of the closed form of each effect, to 15 %: with a limit above it the unit navigates, below it not.
#[test]
fn the_limit_is_that_of_the_closed_form() {
    const T: f64 = 900.0;
    let none = TriadParameters::default;
    let each = Vector3::repeat;
    let horizontal = |latitude_deg: f64| EARTH_RATE * (latitude_deg * DEG).cos();
    let bias = 0.05 * DEG_PER_HOUR;
    let noise = 0.01 * DEG / 60.0;
    let (of_force, of_force_noise) = (2e-3 * G, 1e-3 * G);
    let mut cases: Vec<(&str, f64, Sensors, f64)> = Vec::new();
    for latitude_deg in [0.0, 60.0, -78.0] {
        let rate = horizontal(latitude_deg);
        let drawn = TriadParameters { bias_sigma: each(bias), ..none() };
        cases.push(("bias_sigma", latitude_deg, (drawn, none()), bias * (1.0 / rate).hypot(0.5 * T)));
        let set = TriadParameters { bias: Vector3::new(bias, 0.0, 0.0), ..none() };
        cases.push(("bias", latitude_deg, (set, none()), bias * (1.0 / rate + 0.5 * T)));
        let white = TriadParameters { random_walk: each(noise), ..none() };
        cases.push(("random_walk", latitude_deg, (white, none()), noise / (rate * T.sqrt())));
        let white = TriadParameters { random_walk: each(of_force_noise), ..none() };
        let of_vertical = (3.0f64 / 30.0).sqrt() * of_force_noise / (G * rate * T);
        cases.push(("accelerometer noise", latitude_deg, (none(), white), of_vertical));
    }
    let tilted = TriadParameters { bias_sigma: each(of_force), ..none() };
    cases.push(("accelerometer bias", 80.0, (none(), tilted), of_force / G * (80.0 * DEG).tan()));
    for (name, latitude_deg, sensors, sigma) in cases {
        for (factor, finds) in [(1.15, true), (1.0 / 1.15, false)] {
            let parameters =
                UnitParameters { alignment_s: T, heading_limit_rad: sigma * factor, ..Default::default() };
            let aircraft = aligned(latitude_deg, 3, &sensors, parameters);
            let status = aircraft.unit.status();
            assert_eq!(shows_north(&status), finds, "{name} at {latitude_deg}, {factor}: {status:?}");
        }
    }
}
