//! Tests of the unit: sensors, power, entered positions.

use sins::sensors::{Axis, Failure, SensorOutput};
use sins::unit::{AlignmentKind, Mode, Power, State, StoredAlignment, UnitParameters};

use crate::aircraft::{Aircraft, Motion, Receiver};
use crate::support::DEG;

#[test]
fn a_dead_gyro_is_a_fault_until_the_unit_is_off() {
    let mut aircraft = Aircraft::ideal(40.0);
    aircraft.unit = sins::unit::Unit::new(&UnitParameters::default(), Mode::Navigate).unwrap();
    assert_eq!(aircraft.stand(10.0).state, State::Navigation);
    let output = SensorOutput::Gyro(Axis::Y);
    aircraft.simulator.set_failure(output, Some(Failure::Dead)).unwrap();
    assert!(!aircraft.stand(0.9).fault);
    let status = aircraft.stand(0.3);
    assert!(status.fault && status.reasons.no_signal && status.validity == Default::default());
    aircraft.simulator.set_failure(output, None).unwrap();
    assert!(aircraft.stand(10.0).fault);
    aircraft.unit.select(Mode::Off);
    assert_eq!(aircraft.stand(6.0).state, State::Off);
}

/// Every second interval of a gyro lost in a turn: the time without a signal is summed, and until it is reached, the heading is wrong
/// by at most the turn in it. An interval without a signal shows no rates.
#[test]
fn a_gyro_that_is_lost_again_and_again_is_a_fault() {
    let mut aircraft = Aircraft::ideal(40.0);
    aircraft.unit = sins::unit::Unit::new(&UnitParameters::default(), Mode::Navigate).unwrap();
    aircraft.go(Motion::Drive { acceleration: 2.0, to: 100.0 }, 60.0);
    let output = SensorOutput::Gyro(Axis::Z);
    let turn = Motion::Turn(3.0 * DEG);
    for _ in 0..300 {
        aircraft.simulator.set_failure(output, Some(Failure::Dead)).unwrap();
        assert!(!aircraft.go(turn, 0.1).validity.rates);
        aircraft.simulator.set_failure(output, None).unwrap();
        let status = aircraft.go(turn, 0.1);
        assert_eq!(status.validity.rates, !status.fault);
        let error = sins::math::wrap_angle(aircraft.navigation().euler.heading - aircraft.heading());
        assert!(!status.validity.heading || error.abs() < 3.1 * DEG, "{error}");
    }
    let status = aircraft.unit.status();
    assert!(status.fault && status.reasons.no_signal);
}

#[test]
fn the_battery_lasts_its_time() {
    let mut aircraft = Aircraft::ideal(40.0);
    aircraft.unit =
        sins::unit::Unit::new(&UnitParameters { battery_s: 20.0, ..Default::default() }, Mode::Navigate)
            .unwrap();
    aircraft.stand(5.0);
    aircraft.unit.set_power(Power::Battery);
    let status = aircraft.stand(19.0);
    assert!(status.on_battery && status.state == State::Navigation);
    let status = aircraft.stand(2.0);
    assert!(status.state == State::Off && status.reasons.battery_empty && status.stored.is_none());
}

#[test]
fn without_power_the_unit_is_off_and_stores_nothing() {
    let mut aircraft = Aircraft::ideal(40.0);
    aircraft.unit = sins::unit::Unit::new(&UnitParameters::default(), Mode::Navigate).unwrap();
    aircraft.stand(5.0);
    aircraft.unit.set_power(Power::None);
    let status = aircraft.stand(0.1);
    assert!(status.state == State::Off && status.stored.is_none());
    aircraft.unit.set_power(Power::Aircraft);
    assert_eq!(aircraft.stand(0.1).state, State::Test);
}

/// The gyros find a latitude that is a degree, or a hemisphere, off; a tenth of a degree is below what they find.
#[test]
fn a_wrong_latitude_is_found_and_the_second_one_is_a_fault() {
    for (wrong_deg, is_found) in [(41.0, true), (-40.0, true), (40.1, false)] {
        let mut aircraft = Aircraft::ideal(40.0);
        aircraft.unit.select(Mode::Align);
        aircraft.stand(10.0);
        let longitude_rad = aircraft.place().longitude_rad;
        aircraft.unit.enter_position(wrong_deg * DEG, longitude_rad).unwrap();
        let status = aircraft.go(Motion::Rest, 530.0);
        assert_eq!(status.reasons.latitude_disagrees, is_found, "{wrong_deg}");
        assert_eq!(status.state == State::Ready, !is_found, "{wrong_deg}");
        if is_found {
            assert!((status.found_latitude_rad.unwrap() / DEG - 40.0).abs() < 0.01);
            let mut right = aircraft.clone();
            right.enter_true_position();
            right.until(Motion::Rest, State::Ready, 60.0);
            aircraft.unit.enter_position(wrong_deg * DEG, longitude_rad).unwrap();
            aircraft.until(Motion::Rest, State::Fault, 60.0);
        }
    }
}

#[test]
fn a_position_far_from_the_stored_one_must_be_entered_twice() {
    let mut aircraft = Aircraft::ideal(10.0);
    let stored = StoredAlignment { latitude_rad: 12.0 * DEG, longitude_rad: 0.3, heading_rad: 0.0 };
    aircraft.unit.set_stored(Some(stored)).unwrap();
    aircraft.unit.select(Mode::Align);
    aircraft.stand(10.0);
    aircraft.enter_true_position();
    let status = aircraft.stand(1.0);
    assert!(status.reasons.position_disagrees && status.reasons.no_position && status.align_flashes);
    aircraft.enter_true_position();
    let status = aircraft.stand(1.0);
    assert!(!status.reasons.position_disagrees && !status.reasons.no_position);
    aircraft.until(Motion::Rest, State::Ready, 330.0);
}

#[test]
fn entries_at_the_wrong_moment_and_out_of_range_are_rejected() {
    let mut aircraft = Aircraft::ideal(10.0);
    let refused = |aircraft: &mut Aircraft, state: State, why: &str| {
        assert_eq!(aircraft.unit.status().state, state);
        let error = aircraft.unit.enter_position(0.1, 0.3).unwrap_err();
        assert_eq!(error.to_string(), format!("a position can be entered during an alignment; {why}"));
        if state != State::Attitude {
            let error = aircraft.unit.enter_heading(0.1).unwrap_err().to_string();
            let why = match state {
                State::Test => "; the power-up test is not over",
                State::Erection => "; the erection is not over",
                _ => "",
            };
            assert_eq!(error, format!("a heading can be entered when the attitude of ATT is valid{why}"));
        }
    };
    refused(&mut aircraft, State::Off, "the unit is off");
    aircraft.unit.select(Mode::Attitude);
    aircraft.stand(1.0);
    refused(&mut aircraft, State::Test, "the power-up test is not over");
    aircraft.until(Motion::Rest, State::Erection, 60.0);
    refused(&mut aircraft, State::Erection, "the unit is in ATT");
    aircraft.until(Motion::Rest, State::Attitude, 300.0);
    refused(&mut aircraft, State::Attitude, "the unit is in ATT");
    aircraft.unit.select(Mode::Off);
    aircraft.stand(1.0);
    refused(&mut aircraft, State::PowerDown, "the unit is off");
    let mut aircraft = Aircraft::ideal(10.0);
    aircraft.unit.select(Mode::Align);
    aircraft.stand(10.0);
    let error = aircraft.unit.enter_position(47.5, 0.3).unwrap_err();
    assert!(error.to_string().ends_with("is it in degrees?"), "{error}");
    let error =
        aircraft.unit.set_parameters(&UnitParameters { erection_s: -1.0, ..Default::default() }).unwrap_err();
    assert_eq!(
        error.to_string(),
        "unit.erection_s = -1: must be 0 for the default, or from 0.001 to 1000000"
    );
    let before = aircraft.unit;
    let error = aircraft.unit.update(&mut aircraft.simulator).unwrap_err();
    assert_eq!(error.to_string(), "the unit has taken this step already");
    assert!(aircraft.unit == before);
}

/// An accelerometer that lost every second interval before the alignment has filled the loop of the vertical channel with an error that no
/// sensor has. An alignment of any kind begins without it.
#[test]
fn what_failures_left_in_the_vertical_channel_does_not_outlive_an_alignment() {
    const CRUISE: Motion = Motion::Drive { acceleration: 2.0, to: 200.0 };
    for (kind, rate_hz) in [
        (AlignmentKind::InFlight, 2.0),
        (AlignmentKind::InFlight, 10.0),
        (AlignmentKind::Gyrocompass, 10.0),
        (AlignmentKind::Fast, 1.0),
        (AlignmentKind::Instant, 10.0),
    ] {
        let is_in_flight = kind == AlignmentKind::InFlight;
        let mut aircraft = Aircraft::new(40.0, 0, rate_hz, &Default::default());
        aircraft.roll_rate = 20.0 * DEG;
        let motion = if is_in_flight { CRUISE } else { Motion::Rest };
        aircraft.go(motion, 120.0);
        let output = SensorOutput::Accelerometer(Axis::Z);
        for step in 0..(60.0 * rate_hz) as usize {
            aircraft.simulator.set_failure(output, (step % 2 == 0).then_some(Failure::Dead)).unwrap();
            aircraft.go(motion, 1.0 / rate_hz);
        }
        aircraft.simulator.set_failure(output, None).unwrap();
        aircraft.receiver = is_in_flight.then(|| Receiver::new(1, 0.0, 0.0));
        aircraft.set_alignment(kind);
        aircraft.unit.select(Mode::Navigate);
        aircraft.go(motion, 20.0);
        if kind == AlignmentKind::Gyrocompass {
            aircraft.enter_true_position();
        }
        for turn in 0..60 {
            let turns = is_in_flight && turn % 3 == 1;
            let sign = if turn % 2 == 0 { 3.0 } else { -3.0 };
            aircraft.go(if turns { Motion::Turn(sign * DEG) } else { motion }, 20.0);
            let shown = aircraft.navigation();
            if !shown.validity.velocity {
                continue;
            }
            let truth = aircraft.simulator.truth().unwrap().unwrap().navigation;
            let (up_m_s, height_m) = (shown.v_n.z - truth.v_n.z, shown.place.height_m - truth.place.height_m);
            assert!(
                up_m_s.abs() < 0.05 && height_m.abs() < 3.0,
                "{kind:?}, {rate_hz} Hz: {up_m_s} m/s, {height_m} m"
            );
        }
        assert_eq!(aircraft.unit.status().state, State::Navigation, "{kind:?}: {:?}", aircraft.unit.status());
    }
}

/// The vertical accelerometer loses intervals in ATT, less than makes a fault: they show no vertical, and the attitude goes on by the
/// gyros.
#[test]
fn a_lost_accelerometer_does_not_tilt_the_attitude() {
    let mut aircraft = Aircraft::new(40.0, 0, 10.0, &crate::aircraft::papers_sensors());
    aircraft.unit.select(Mode::Attitude);
    aircraft.until(Motion::Rest, State::Attitude, 60.0);
    aircraft.stand(600.0);
    let before = aircraft.navigation().euler;
    let output = SensorOutput::Accelerometer(Axis::Z);
    for lost in [true, false].repeat(8) {
        aircraft.simulator.set_failure(output, lost.then_some(Failure::Dead)).unwrap();
        aircraft.stand(0.1);
    }
    let (shown, status) = (aircraft.navigation(), aircraft.unit.status());
    assert!(shown.validity.attitude && status.state == State::Attitude, "{status:?}");
    let tilted = (shown.euler.roll - before.roll).hypot(shown.euler.pitch - before.pitch);
    // The Earth turns the vertical by 1.2e-4 rad.
    assert!(tilted < 2e-4, "{tilted} rad");
}
