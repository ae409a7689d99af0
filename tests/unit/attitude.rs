//! The mode ATT.

use sins::unit::{Mode, State};

use crate::aircraft::{Aircraft, Motion};
use crate::support::{DEG, EARTH_RATE};

fn in_flight(latitude_deg: f64, speed: f64) -> Aircraft {
    let mut aircraft = Aircraft::ideal(latitude_deg);
    aircraft.unit = sins::unit::Unit::new(&Default::default(), Mode::Navigate).unwrap();
    aircraft.go(Motion::Drive { acceleration: 5.0, to: speed }, 60.0);
    aircraft
}

#[test]
fn erection_then_attitude_then_an_entered_heading() {
    let mut aircraft = in_flight(30.0, 30.0);
    let straight = Motion::Drive { acceleration: 1.0, to: 30.0 };
    aircraft.unit.select(Mode::Attitude);
    let status = aircraft.go(straight, 1.0);
    assert!(status.state == State::Erection && status.validity.rates && !status.validity.attitude);
    let seconds = 1.0 + aircraft.until(straight, State::Attitude, 31.0);
    assert!((seconds - 30.0).abs() < 0.3, "{seconds}");
    let status = aircraft.unit.status();
    assert!(status.validity.attitude && !status.validity.heading && !status.validity.position);
    aircraft.unit.enter_heading(1.0).unwrap();
    let shown = aircraft.navigation();
    // The Earth turns the level by 15 s · Ω from the middle of the erection.
    assert!(shown.validity.heading && (shown.euler.heading - 1.0).abs() < 1e-12);
    assert!(shown.euler.roll.abs() < 15.0 * EARTH_RATE && shown.euler.pitch.abs() < 15.0 * EARTH_RATE);
    assert_eq!((shown.place.latitude_rad, shown.v_n.x), (0.0, 0.0));
    // A second ATT has no navigation to go back to.
    aircraft.unit.select(Mode::Navigate);
    assert_eq!(aircraft.go(straight, 0.2).state, State::CoarseAlignment);
}

/// Level gyros measure Ω sin L about the vertical: 7.5°/h at 30°. The heading of the aircraft does not change.
#[test]
fn the_heading_drifts_with_the_earth() {
    let mut aircraft = Aircraft::ideal(30.0);
    aircraft.unit.select(Mode::Attitude);
    aircraft.until(Motion::Rest, State::Attitude, 40.0);
    aircraft.unit.enter_heading(1.0).unwrap();
    aircraft.stand(1800.0);
    let drift = aircraft.navigation().euler.heading - 1.0;
    let expected = -EARTH_RATE * 0.5 * 1800.0;
    println!("drift in half an hour: {:.3} deg, {:.3} expected", drift / DEG, expected / DEG);
    // To first order in the lag of the level behind the Earth, Ω cos L τ = 0.0076 rad.
    assert!((drift / expected - 1.0).abs() < 0.02);
}

/// In a turn at the rate ω the apparent vertical turns with the aircraft: the level e follows β e^(iωt) with the time constant τ, so
/// e = β (e^(iωt) - e^(-t/τ))/(1 + iωτ) beside the lag behind the Earth, Ω τ = 0.009 rad · cos L.
#[test]
fn a_long_turn_leaves_a_false_vertical() {
    let mut aircraft = in_flight(60.0, 60.0);
    aircraft.unit.select(Mode::Attitude);
    aircraft.until(Motion::Drive { acceleration: 1.0, to: 60.0 }, State::Attitude, 31.0);
    let (rate, tau, t) = (1.0 * DEG, 120.0f64, 120.0);
    aircraft.go(Motion::Turn(rate), t);
    let bank = (rate * 60.0 / 9.81f64).atan();
    let shown = aircraft.navigation();
    // Real and imaginary part: towards the wing now, and across.
    let (sin, cos) = (rate * t).sin_cos();
    let decay = (-t / tau).exp();
    let (re, im) = (cos - decay, sin);
    let (a, b) = (1.0, rate * tau);
    let e = (bank * (re * a + im * b) / (a * a + b * b), bank * (im * a - re * b) / (a * a + b * b));
    let size = e.0.hypot(e.1);
    let error = (shown.euler.roll - bank).hypot(shown.euler.pitch);
    println!(
        "after {t} s of turn: attitude error {:.3} deg, {:.3} expected, bank {:.2} deg",
        error / DEG,
        size / DEG,
        bank / DEG
    );
    assert!((error - size).abs() < 0.01, "{error} {size}");
}
