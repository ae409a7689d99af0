//! Positions and headings that are entered or stored hold where the aircraft stood: what a motion makes wrong is dropped.

use sins::earth::Earth;
use sins::unit::{AlignmentKind, Mode, State, StoredAlignment, UnitParameters};

use crate::aircraft::{Aircraft, Motion};
use crate::support::DEG;

const TAXI: Motion = Motion::Drive { acceleration: 1.0, to: 5.0 };
const BRAKE: Motion = Motion::Drive { acceleration: 1.0, to: 0.0 };

/// A unit at ALIGN into which a position was entered 40 s after the start.
fn entered(latitude_deg: f64, parameters: UnitParameters) -> Aircraft {
    let mut aircraft = Aircraft::ideal(latitude_deg);
    aircraft.unit.set_parameters(&parameters).unwrap();
    aircraft.unit.select(Mode::Align);
    aircraft.stand(40.0);
    aircraft.enter_true_position();
    aircraft
}

fn taxi(aircraft: &mut Aircraft) {
    aircraft.go(TAXI, 96.0);
    aircraft.go(BRAKE, 6.0);
}

/// What the aircraft does.
type Way = fn(&mut Aircraft);

/// Each way in which the aircraft leaves the place where a position was entered, seen by the test of motion or not.
fn ways() -> Vec<(&'static str, UnitParameters, Way)> {
    let usual = UnitParameters::default();
    vec![
        ("taxiing", usual, |aircraft| {
            aircraft.stand(60.0);
            taxi(aircraft);
        }),
        ("a flight", usual, |aircraft| {
            aircraft.go(Motion::Drive { acceleration: 3.0, to: 90.0 }, 200.0);
            aircraft.go(Motion::Drive { acceleration: 3.0, to: 0.0 }, 40.0);
        }),
        ("entered while it moves", usual, |aircraft| {
            aircraft.go(TAXI, 30.0);
            aircraft.enter_true_position();
            taxi(aircraft);
        }),
        ("a slow start", usual, |aircraft| {
            aircraft.go(Motion::Drive { acceleration: 0.003, to: 1.0 }, 600.0);
            aircraft.go(BRAKE, 6.0);
        }),
        ("motion that is not tested yet", UnitParameters { motion_inhibition_s: 1e5, ..usual }, taxi as Way),
        ("a tolerance of any distance", UnitParameters { motion_distance_m: 1e6, ..usual }, taxi),
        ("ready before", UnitParameters { alignment_s: 60.0, ..usual }, |aircraft| {
            aircraft.until(Motion::Rest, State::Ready, 100.0);
            taxi(aircraft);
        }),
        ("steps without an update", usual, |aircraft| {
            (0..1000).for_each(|_| aircraft.step_without_update(TAXI));
            (0..60).for_each(|_| aircraft.step_without_update(BRAKE));
        }),
        ("an alignment in flight", usual, |aircraft| {
            aircraft.unit.set_alignment(AlignmentKind::InFlight);
            taxi(aircraft);
            aircraft.unit.set_alignment(AlignmentKind::Gyrocompass);
        }),
        ("an alignment of a simulation", usual, |aircraft| {
            aircraft.unit.set_alignment(AlignmentKind::Fast);
            taxi(aircraft);
            aircraft.unit.set_alignment(AlignmentKind::Gyrocompass);
        }),
        ("ATT", usual, |aircraft| {
            aircraft.unit.select(Mode::Attitude);
            taxi(aircraft);
            aircraft.unit.select(Mode::Align);
        }),
    ]
}

#[test]
fn a_position_does_not_hold_where_it_was_not_entered() {
    for selector in [Mode::Align, Mode::Navigate] {
        for (name, parameters, leave) in ways() {
            let mut aircraft = entered(40.0, parameters);
            let from = aircraft.place();
            leave(&mut aircraft);
            aircraft.unit.select(selector);
            let metres = (Earth::default().to_earth_fixed(&from)
                - Earth::default().to_earth_fixed(&aircraft.place()))
            .norm();
            assert!(metres > 250.0, "{name}: {metres} m");
            let mut asked = false;
            for _ in 0..1200 {
                let status = aircraft.stand(1.0);
                assert!(!status.validity.position && status.state != State::Ready, "{name}: {status:?}");
                asked |= status.align_flashes;
            }
            let status = aircraft.unit.status();
            assert!(asked && status.align_flashes && status.reasons.no_position, "{name}: {status:?}");
            aircraft.enter_true_position();
            let aligned = if selector == Mode::Align { State::Ready } else { State::Navigation };
            aircraft.until(Motion::Rest, aligned, 60.0);
            let error = aircraft.errors().position_n.xy().norm();
            // The motion since the unit has looked last, at 5 m/s.
            assert!(error < 1.0, "{name}: {error} m");
        }
    }
}

/// A position that was refused must be entered twice where the aircraft stands now.
#[test]
fn a_refused_position_does_not_hold_elsewhere() {
    let mut aircraft = Aircraft::ideal(10.0);
    let stored = StoredAlignment { latitude_rad: 12.0 * DEG, longitude_rad: 0.3, heading_rad: 0.0 };
    aircraft.unit.set_stored(Some(stored)).unwrap();
    aircraft.unit.select(Mode::Align);
    aircraft.stand(10.0);
    let place = aircraft.place();
    let enter = |aircraft: &mut Aircraft| {
        aircraft.unit.enter_position(place.latitude_rad, place.longitude_rad).unwrap();
        aircraft.stand(1.0).reasons
    };
    assert!(enter(&mut aircraft).position_disagrees);
    taxi(&mut aircraft);
    let reasons = aircraft.stand(10.0).reasons;
    assert!(!reasons.position_disagrees && reasons.no_position);
    assert!(enter(&mut aircraft).position_disagrees);
    let reasons = enter(&mut aircraft);
    assert!(!reasons.position_disagrees && !reasons.no_position);
}

/// In a realignment the position of the navigation stays when the aircraft leaves the place where another one was entered.
#[test]
fn a_position_of_a_realignment_does_not_hold_elsewhere() {
    let mut aircraft = Aircraft::ideal(20.0);
    aircraft.align();
    aircraft.unit.select(Mode::Navigate);
    aircraft.stand(10.0);
    aircraft.unit.select(Mode::Align);
    aircraft.stand(10.0);
    aircraft.enter_true_position();
    aircraft.stand(5.0);
    taxi(&mut aircraft);
    assert_eq!(aircraft.unit.status().state, State::Realignment);
    aircraft.until(Motion::Rest, State::Ready, 100.0);
    let error = aircraft.errors().position_n.xy().norm();
    assert!(error < 1.0, "{error} m");
}

/// Without an entry the stored latitude gives a heading, as long as the aircraft stands where the unit was switched on.
#[test]
fn a_stored_position_does_not_hold_elsewhere() {
    for moves in [false, true] {
        let mut aircraft = Aircraft::ideal(20.0);
        let (latitude_rad, longitude_rad) = (aircraft.place().latitude_rad, aircraft.place().longitude_rad);
        let stored = StoredAlignment { latitude_rad, longitude_rad, heading_rad: 0.7 };
        aircraft.unit.set_stored(Some(stored)).unwrap();
        aircraft.unit.select(Mode::Align);
        aircraft.stand(40.0);
        if moves {
            taxi(&mut aircraft);
        }
        let status = aircraft.stand(1200.0);
        assert!(status.validity.heading != moves && status.reasons.no_position, "{status:?}");
    }
}

/// A unit that is ready, and creeps away without that the test of motion sees it, is not ready any more.
#[test]
fn a_ready_unit_that_creeps_away_asks_for_its_position() {
    let tolerant = UnitParameters {
        alignment_s: 60.0,
        motion_distance_m: 1e6,
        motion_threshold_m_s: 1e3,
        ..Default::default()
    };
    let mut aircraft = entered(20.0, tolerant);
    aircraft.until(Motion::Rest, State::Ready, 100.0);
    let status = aircraft.go(Motion::Drive { acceleration: 4e-4, to: 1.0 }, 400.0);
    assert!(!status.reasons.motion, "{status:?}");
    assert!(status.state == State::FineAlignment && status.reasons.no_position, "{status:?}");
}

/// A position that is entered as soon as a short time at OFF has begun a realignment holds there, far from the first alignment.
#[test]
fn a_position_holds_from_the_begin_of_a_realignment() {
    let mut aircraft = Aircraft::ideal(20.0);
    aircraft.align();
    aircraft.unit.select(Mode::Navigate);
    aircraft.stand(10.0);
    taxi(&mut aircraft);
    aircraft.unit.set_parameters(&UnitParameters { quick_off_s: 5.0, ..Default::default() }).unwrap();
    aircraft.unit.select(Mode::Off);
    aircraft.stand(3.0);
    aircraft.unit.select(Mode::Navigate);
    aircraft.until(Motion::Rest, State::Realignment, 3.0);
    let place = aircraft.place();
    aircraft.unit.enter_position(place.latitude_rad + 2e-5, place.longitude_rad).unwrap();
    aircraft.until(Motion::Rest, State::Navigation, 100.0);
    let error = aircraft.errors().position_n;
    assert!((error.y - 127.0).abs() < 1.0 && error.x.abs() < 1.0, "{error:?}");
}

/// Gusts that stop the alignment leave the aircraft in its place: the position stays.
#[test]
fn a_position_stays_where_the_aircraft_sways() {
    // In a window of less than a period the sway is an acceleration.
    let mut aircraft = entered(0.0, UnitParameters { coarse_alignment_s: 1.0, ..Default::default() });
    assert!((0..60).any(|_| aircraft.go(Motion::Sway, 1.0).reasons.motion));
    assert!(!aircraft.stand(20.0).reasons.no_position);
    aircraft.until(Motion::Rest, State::Ready, 400.0);
}

/// A unit that is ready aligns again with another kind, also behind a realignment; then it has the error of that alignment.
#[test]
fn ready_behind_a_realignment_another_kind_aligns_again() {
    for kind in [AlignmentKind::StoredHeading, AlignmentKind::Fast, AlignmentKind::InFlight] {
        let mut aircraft = Aircraft::ideal(0.0);
        aircraft.align();
        aircraft.unit.select(Mode::Navigate);
        aircraft.stand(10.0);
        aircraft.unit.select(Mode::Align);
        aircraft.stand(1.0);
        // A realignment is the same with each kind.
        aircraft.unit.set_alignment(kind);
        assert_eq!(aircraft.stand(1.0).state, State::Realignment, "{kind:?}");
        aircraft.unit.set_alignment(AlignmentKind::Gyrocompass);
        aircraft.until(Motion::Rest, State::Ready, 60.0);
        aircraft.enter_true_position();
        aircraft.unit.set_alignment(kind);
        let status = aircraft.stand(1.0);
        assert!(status.state == State::CoarseAlignment && !status.validity.position, "{kind:?}: {status:?}");
        if kind != AlignmentKind::InFlight {
            let whole_s = if kind == AlignmentKind::Fast { 30.0 } else { 300.0 };
            let seconds = 1.0 + aircraft.until(Motion::Rest, State::Ready, 400.0);
            assert!((seconds - whole_s).abs() < 1.0, "{kind:?}: {seconds} s");
        }
    }
}
