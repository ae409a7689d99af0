//! The end of a flight: realignment, or navigation that is lost.

use nalgebra::Vector3;
use sins::sensors::TriadParameters;
use sins::unit::{Mode, State, UnitParameters, Validity};

use crate::aircraft::{Aircraft, Motion};
use crate::support::{DEG, DEG_PER_HOUR, G};

const KNOT: f64 = 1852.0 / 3600.0;

/// Two hours: take-off, a racetrack, landing.
fn fly(aircraft: &mut Aircraft) {
    aircraft.go(Motion::Drive { acceleration: 2.0, to: 100.0 }, 60.0);
    for _ in 0..10 {
        aircraft.go(Motion::Drive { acceleration: 1.0, to: 100.0 }, 583.0);
        aircraft.go(Motion::Turn(1.5 * DEG), 120.0);
    }
    aircraft.go(Motion::Drive { acceleration: 2.0, to: 0.0 }, 60.0);
}

fn navigating(latitude_deg: f64) -> Aircraft {
    let each = Vector3::repeat;
    let gyro = TriadParameters {
        bias: each(0.01 * DEG_PER_HOUR),
        random_walk: each(0.002 * DEG / 60.0),
        ..Default::default()
    };
    let accel = TriadParameters { bias: each(50e-6 * G), ..Default::default() };
    let mut aircraft = Aircraft::new(latitude_deg, 5, 10.0, &(gyro, accel));
    aircraft.align();
    aircraft.unit.select(Mode::Navigate);
    aircraft
}

/// After two hours of flight the velocity error falls below 0.05 m/s and the tilt to that of the accelerometers' bias, 5e-5 rad; the
/// drift of the next hour is that of a newly aligned unit, a fraction of what it would be without.
#[test]
fn a_fast_realignment_removes_velocity_and_tilt() {
    let mut aircraft = navigating(40.0);
    fly(&mut aircraft);
    aircraft.stand(10.0);
    let before = aircraft.errors();
    let mut without = aircraft.clone();
    aircraft.unit.select(Mode::Align);
    assert_eq!(aircraft.stand(1.0).state, State::Realignment);
    aircraft.enter_true_position();
    let seconds = 1.0 + aircraft.until(Motion::Rest, State::Ready, 31.0);
    assert!((seconds - 30.0).abs() < 0.5, "{seconds}");
    aircraft.unit.select(Mode::Navigate);
    aircraft.stand(1.0);
    let after = aircraft.errors();
    let tilt = |errors: &sins::errors::NavigationErrors| errors.misalignment_n.xy().norm();
    println!(
        "velocity {:.3} to {:.4} m/s, tilt {:.2e} to {:.2e} rad, position {:.0} to {:.1} m",
        before.velocity_n.xy().norm(),
        after.velocity_n.xy().norm(),
        tilt(&before),
        tilt(&after),
        before.position_n.xy().norm(),
        after.position_n.xy().norm()
    );
    assert!(after.velocity_n.xy().norm() < 0.05 && before.velocity_n.xy().norm() > 0.3);
    assert!(tilt(&after) < 2f64.sqrt() * 50e-6 * 1.1 && after.position_n.xy().norm() < 1.0);
    let drift = |aircraft: &mut Aircraft, selector| {
        aircraft.unit.select(selector);
        let start = aircraft.errors().position_n;
        aircraft.go(Motion::Drive { acceleration: 2.0, to: 100.0 }, 3600.0);
        (aircraft.errors().position_n - start).xy().norm()
    };
    let (with, without) = (drift(&mut aircraft, Mode::Navigate), drift(&mut without, Mode::Navigate));
    println!("drift of the next hour: {with:.0} m, without {without:.0} m: {:.2}", with / without);
    assert!(with < 0.6 * without);
}

#[test]
fn align_in_motion_loses_the_navigation() {
    let mut aircraft = navigating(20.0);
    aircraft.go(Motion::Drive { acceleration: 1.0, to: 30.0 * KNOT }, 30.0);
    assert_eq!(aircraft.unit.status().state, State::Navigation);
    aircraft.unit.select(Mode::Align);
    let status = aircraft.go(Motion::Drive { acceleration: 1.0, to: 30.0 * KNOT }, 0.2);
    assert!(status.state == State::CoarseAlignment && status.reasons.motion && !status.validity.position);
}

/// With `quick_off_s` a selector without ALIGN realigns: OFF for 3 s, then NAV.
#[test]
fn a_short_time_at_off_realigns_if_the_unit_can() {
    for (quick_off_s, state) in [(5.0, State::Realignment), (0.0, State::Test)] {
        let mut aircraft = navigating(20.0);
        aircraft.unit.set_parameters(&UnitParameters { quick_off_s, ..Default::default() }).unwrap();
        aircraft.stand(10.0);
        aircraft.unit.select(Mode::Off);
        aircraft.stand(3.0);
        aircraft.unit.select(Mode::Navigate);
        aircraft.until(Motion::Rest, state, 3.0);
    }
}

/// A take-off with the selector at ALIGN, before and behind the realignment, and NAV in the air: nothing is shown that is not so. The
/// unit had made the velocity 0 in the air.
#[test]
fn a_take_off_with_the_selector_at_align_shows_no_velocity() {
    for parked_s in [1.0, 100.0] {
        let mut aircraft = navigating(20.0);
        aircraft.stand(30.0);
        aircraft.unit.select(Mode::Align);
        aircraft.stand(parked_s);
        let mut shown = aircraft.go(Motion::Drive { acceleration: 2.0, to: 60.0 }, 4.0);
        assert!(
            shown.state == State::Realignment && shown.reasons.motion && shown.align_flashes,
            "{shown:?}"
        );
        shown = aircraft.go(Motion::Drive { acceleration: 2.0, to: 60.0 }, 100.0);
        assert!(shown.state == State::CoarseAlignment && shown.reasons.motion, "{shown:?}");
        aircraft.unit.select(Mode::Navigate);
        for _ in 0..600 {
            let Validity { attitude, heading, position, velocity, .. } =
                aircraft.go(Motion::Drive { acceleration: 2.0, to: 60.0 }, 1.0).validity;
            assert!(!(attitude || heading || position || velocity));
        }
    }
}

/// ALIGN while taxiing steadily, below the speed of a realignment: flagged, and nothing is made 0 until the aircraft stands.
#[test]
fn align_while_taxiing_waits_for_rest() {
    for speed in [0.05, 1.0, 5.0, 9.0] {
        let mut aircraft = navigating(20.0);
        let taxi = Motion::Drive { acceleration: 1.0, to: speed };
        aircraft.go(taxi, 60.0);
        aircraft.unit.select(Mode::Align);
        aircraft.go(taxi, 10.0);
        let status = aircraft.go(taxi, 200.0);
        assert!(status.state == State::Realignment && status.reasons.motion && !status.validity.velocity);
        // Below 0.1 m/s of the gyros' biases, and a heading error of 5e-3 rad.
        assert!(
            aircraft.errors().velocity_n.norm() < 0.1 + 5e-3 * speed,
            "{speed}: {:?}",
            aircraft.errors().velocity_n
        );
        aircraft.unit.select(Mode::Navigate);
        aircraft.until(Motion::Rest, State::Navigation, 100.0);
        assert!(aircraft.errors().velocity_n.norm() < 0.05, "{speed}: {:?}", aircraft.errors().velocity_n);
    }
}
