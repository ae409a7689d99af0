//! Modes and states.

use sins::unit::{AlignmentKind, Mode, State};

use crate::aircraft::{Aircraft, Motion};
use crate::support::{DEG, EARTH_RATE};

#[test]
fn a_unit_that_is_off_shows_nothing() {
    let mut aircraft = Aircraft::ideal(45.0);
    let status = aircraft.stand(30.0);
    assert_eq!((status.state, status.validity), (State::Off, Default::default()));
    assert_eq!(
        aircraft.navigation(),
        sins::unit::UnitNavigation { time_s: aircraft.navigation().time_s, ..Default::default() }
    );
    assert!((aircraft.navigation().time_s - 29.9).abs() < 1e-9);
}

/// Test 5 s, coarse alignment 30 s, ready after 5 + 0.002·45² = 9.05 min more than the test.
#[test]
fn an_alignment_goes_through_its_states_in_the_time_of_the_latitude() {
    let mut aircraft = Aircraft::ideal(45.0);
    aircraft.stand(1.0);
    aircraft.unit.select(Mode::Align);
    let status = aircraft.stand(1.0);
    assert!(status.state == State::Test && status.in_test && !status.validity.rates);
    aircraft.until(Motion::Rest, State::CoarseAlignment, 5.1);
    aircraft.enter_true_position();
    let status = aircraft.stand(1.0);
    assert!(status.align && !status.align_flashes && status.validity.rates && !status.validity.attitude);
    let to_go = status.to_go_s;
    assert!((to_go - (9.05 * 60.0 - 1.0)).abs() < 0.2, "{to_go}");
    let coarse = aircraft.until(Motion::Rest, State::FineAlignment, 40.0);
    assert!((coarse - 29.0).abs() < 0.2, "{coarse}");
    let status = aircraft.stand(1.0);
    assert!(status.validity.attitude && !status.validity.heading);
    // Until two windows are complete, the level turns with the Earth: by at most 1.5 windows of 30 s.
    assert!(aircraft.navigation().euler.roll.abs() < 45.0 * EARTH_RATE);
    let status = aircraft.stand(0.5 * 9.05 * 60.0);
    assert!(status.validity.heading && !status.validity.position);
    assert!((aircraft.navigation().euler.heading - aircraft.heading()).abs() < 1e-3);
    let whole = aircraft.until(Motion::Rest, State::Ready, 600.0) + 0.5 * 9.05 * 60.0 + 1.0 + coarse + 1.0;
    assert!((whole - 9.05 * 60.0).abs() < 0.5, "{whole}");
    let status = aircraft.unit.status();
    assert!(
        status.navigation_ready && !status.align && status.validity.position && !status.validity.velocity
    );
    aircraft.unit.select(Mode::Navigate);
    let status = aircraft.stand(1.0);
    assert!(status.state == State::Navigation && status.validity.velocity);
    let errors = aircraft.errors();
    assert!(errors.misalignment_n.norm() < 1e-6 && errors.position_n.norm() < 1e-3, "{errors:?}");
}

#[test]
fn with_the_selector_at_nav_it_navigates_as_soon_as_it_is_aligned() {
    let mut aircraft = Aircraft::ideal(0.0);
    aircraft.unit.select(Mode::Navigate);
    aircraft.stand(10.0);
    aircraft.enter_true_position();
    let seconds = 10.0 + aircraft.until(Motion::Rest, State::Navigation, 310.0);
    assert!((seconds - 305.0).abs() < 0.5, "{seconds}");
}

#[test]
fn without_a_position_it_does_not_become_ready_and_flashes() {
    let mut aircraft = Aircraft::ideal(20.0);
    aircraft.unit.select(Mode::Align);
    let status = aircraft.stand(1500.0);
    assert!(status.state == State::FineAlignment && status.align_flashes && status.reasons.no_position);
    aircraft.enter_true_position();
    aircraft.until(Motion::Rest, State::Ready, 60.0);
}

#[test]
fn an_instant_alignment_navigates_at_once() {
    let mut aircraft = Aircraft::ideal(45.0);
    aircraft.stand(5.0);
    aircraft.unit.set_alignment(AlignmentKind::Instant);
    aircraft.unit.select(Mode::Navigate);
    let status = aircraft.stand(0.1);
    assert_eq!(status.state, State::Navigation);
    assert!(aircraft.errors().misalignment_n.norm() < 1e-12);
}

#[test]
fn a_fast_alignment_takes_its_time() {
    let mut aircraft = Aircraft::ideal(45.0);
    aircraft.unit.set_alignment(AlignmentKind::Fast);
    aircraft.unit.select(Mode::Navigate);
    let seconds = aircraft.until(Motion::Rest, State::Navigation, 40.0);
    assert!((seconds - 35.0).abs() < 0.5, "{seconds}");
    assert!(aircraft.errors().misalignment_n.norm() < 1e-12);
}

/// A simulation aligns in motion, where the sensors find no attitude, and away from where the position was entered.
#[test]
fn a_made_up_alignment_in_motion_shows_nothing_before_it_is_true() {
    for kind in [AlignmentKind::Fast, AlignmentKind::Instant] {
        for speed in [5.0, 20.0, 50.0, 200.0] {
            let drive = Motion::Drive { acceleration: 5.0, to: speed };
            let mut aircraft = Aircraft::ideal(45.0);
            aircraft.unit.select(Mode::Align);
            aircraft.stand(10.0);
            aircraft.enter_true_position();
            aircraft.go(drive, 60.0);
            aircraft.set_alignment(kind);
            aircraft.unit.select(Mode::Navigate);
            for _ in 0..100 {
                let status = aircraft.go(drive, 1.0);
                if status.state == State::Navigation {
                    break;
                }
                let valid = aircraft.navigation().validity;
                assert!(
                    !valid.attitude && !valid.heading && !valid.position,
                    "{kind:?}, {speed} m/s: {valid:?}"
                );
            }
            let (errors, shown) = (aircraft.errors(), aircraft.navigation());
            assert!(shown.validity.position && shown.validity.heading, "{kind:?}, {speed} m/s");
            assert!(
                errors.position_n.norm() < 1e-3 && errors.misalignment_n.norm() < 1e-9,
                "{kind:?}, {speed} m/s: {errors:?}"
            );
        }
    }
}

/// 78.25° takes 17.2 min; beyond 82° the unit refuses.
#[test]
fn high_latitudes_take_longer_and_are_refused_in_the_end() {
    let mut aircraft = Aircraft::ideal(78.25);
    aircraft.unit.select(Mode::Align);
    aircraft.stand(10.0);
    aircraft.enter_true_position();
    let minutes = (10.0 - 5.0 + aircraft.until(Motion::Rest, State::Ready, 1100.0)) / 60.0;
    assert!((minutes - 17.246).abs() < 0.02, "{minutes}");

    let mut aircraft = Aircraft::ideal(83.0);
    aircraft.unit.select(Mode::Align);
    aircraft.stand(10.0);
    aircraft.enter_true_position();
    let status = aircraft.stand(1500.0);
    assert!(status.reasons.latitude_too_high && status.align_flashes && status.state == State::FineAlignment);
}

#[test]
fn switched_off_it_stores_position_and_heading() {
    let mut aircraft = Aircraft::ideal(10.0);
    aircraft.align();
    aircraft.unit.select(Mode::Navigate);
    aircraft.stand(10.0);
    aircraft.unit.select(Mode::Off);
    assert_eq!(aircraft.stand(1.0).state, State::PowerDown);
    let status = aircraft.stand(5.0);
    assert_eq!(status.state, State::Off);
    let stored = status.stored.unwrap();
    assert!((stored.latitude_rad - 10.0 * DEG).abs() < 1e-9 && (stored.heading_rad - 0.7).abs() < 1e-6);
}
