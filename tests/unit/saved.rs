//! Snapshots of a unit.

use sins::ErrorKind;
use sins::snapshot::{self, SnapshotOf};
use sins::unit::{AlignmentKind, Mode, State, Unit, UnitParameters};

use crate::aircraft::{Aircraft, Motion, Receiver, papers_sensors};
use crate::support::bits;
use crate::support::forged::{forge, words};

fn saved(unit: &Unit) -> Vec<u8> {
    let mut buffer = vec![0; sins::abi::SINS_UNIT_SNAPSHOT_MAX_SIZE];
    let length = unit.save_snapshot(&mut buffer).unwrap();
    buffer.truncate(length);
    buffer
}

/// A day: alignment, taxi, flight, realignment, ATT, off. At each moment both snapshots go on to the same bits.
#[test]
fn a_day_goes_on_to_the_same_bits_from_any_moment() {
    let mut aircraft = Aircraft::new(10.0, 2, 5.0, &papers_sensors());
    let day: [(Mode, Motion, f64); 9] = [
        (Mode::Off, Motion::Rest, 10.0),
        (Mode::Align, Motion::Rest, 100.0),
        (Mode::Align, Motion::Sway, 230.0),
        (Mode::Navigate, Motion::Drive { acceleration: 1.0, to: 5.0 }, 60.0),
        (Mode::Navigate, Motion::Turn(0.03), 60.0),
        (Mode::Navigate, Motion::Rest, 20.0),
        (Mode::Align, Motion::Rest, 40.0),
        (Mode::Attitude, Motion::Rest, 60.0),
        (Mode::Off, Motion::Rest, 20.0),
    ];
    let mut longest = 0;
    for (mode, motion, seconds) in day {
        aircraft.unit.select(mode);
        aircraft.go(motion, 7.0);
        if mode == Mode::Align {
            aircraft.enter_true_position();
        }
        let unit = saved(&aircraft.unit);
        longest = longest.max(unit.len());
        let mut other = aircraft.clone();
        other.unit = Unit::new(&UnitParameters { fault_s: 3.0, ..Default::default() }, Mode::Off).unwrap();
        other.unit.load_snapshot(&unit).unwrap();
        assert_eq!(saved(&other.unit), unit);
        for each in [&mut aircraft, &mut other] {
            each.go(motion, seconds);
        }
        assert!(
            other.unit == aircraft.unit && bits(&other.simulator) == bits(&aircraft.simulator),
            "{mode:?}"
        );
    }
    println!("longest snapshot: {longest} bytes");
}

/// The same in an alignment in flight.
#[test]
fn an_alignment_in_flight_goes_on_to_the_same_bits_from_any_moment() {
    let mut aircraft = Aircraft::new(10.0, 2, 5.0, &papers_sensors());
    aircraft.receiver = Some(Receiver::new(9, 3.0, 0.02));
    aircraft.unit.set_alignment(AlignmentKind::InFlight);
    aircraft.unit.select(Mode::Navigate);
    let (straight, turn) = (Motion::Drive { acceleration: 1.0, to: 80.0 }, Motion::Turn(0.03));
    let mut longest = 0;
    for motion in [straight, turn, straight, straight, turn, straight, straight, straight] {
        aircraft.go(motion, 14.2);
        let unit = saved(&aircraft.unit);
        longest = longest.max(unit.len());
        let mut other = aircraft.clone();
        other.unit = Unit::new(&UnitParameters::default(), Mode::Off).unwrap();
        other.unit.load_snapshot(&unit).unwrap();
        for each in [&mut aircraft, &mut other] {
            each.go(motion, 14.6);
        }
        assert!(other.unit == aircraft.unit && bits(&other.simulator) == bits(&aircraft.simulator));
    }
    assert_eq!(aircraft.unit.status().state, State::Navigation);
    println!("longest snapshot: {longest} bytes");
}

/// Windows of an alignment, and of the erection of ATT, that are shorter than an interval of samples.
#[test]
fn an_alignment_in_windows_of_less_than_an_interval_is_saved_at_every_sample() {
    for mode in [Mode::Align, Mode::Attitude] {
        let mut aircraft = Aircraft::ideal(10.0);
        let short_s = 1e-3;
        let parameters = UnitParameters {
            power_up_test_s: short_s,
            coarse_alignment_s: short_s,
            alignment_s: short_s,
            erection_s: short_s,
            ..Default::default()
        };
        aircraft.unit = Unit::new(&parameters, Mode::Off).unwrap();
        aircraft.unit.select(mode);
        for _ in 0..30 {
            aircraft.stand(0.1);
            let unit = saved(&aircraft.unit);
            let mut other = Unit::new(&UnitParameters::default(), Mode::Off).unwrap();
            other.load_snapshot(&unit).unwrap();
            assert!(other == aircraft.unit && saved(&other) == unit);
        }
        assert!(aircraft.unit.status().validity.attitude, "{mode:?}");
    }
}

#[test]
fn damaged_bytes_are_refused_and_change_nothing() {
    let mut aircraft = Aircraft::ideal(10.0);
    aircraft.unit.select(Mode::Align);
    aircraft.receiver = Some(Receiver::new(1, 1.0, 0.1));
    aircraft.unit.set_alignment(AlignmentKind::InFlight);
    aircraft.go(Motion::Drive { acceleration: 1.0, to: 80.0 }, 100.0);
    assert!(aircraft.unit.status().validity.attitude);
    aircraft.unit.set_alignment(AlignmentKind::Gyrocompass);
    aircraft.stand(100.0);
    let good = saved(&aircraft.unit);
    let before = aircraft.unit;
    for (at, bit) in (0..good.len()).flat_map(|at| [(at, 0x10), (at, 0x80)]) {
        let mut bytes = good.clone();
        bytes[at] ^= bit;
        assert_eq!(aircraft.unit.load_snapshot(&bytes).unwrap_err().kind, ErrorKind::Snapshot, "{at}");
        // With a correct checksum: refused, or a unit that works.
        snapshot::seal(&mut bytes, SnapshotOf::Unit);
        let mut forged = before;
        if forged.load_snapshot(&bytes).is_ok() {
            let mut other = aircraft.clone();
            other.unit = forged;
            other.stand(1.0);
            let (shown, to_go_s) = (other.navigation(), other.unit.status().to_go_s);
            // The alignment takes 1107 s at the largest latitude: a time before its start would make it longer.
            let is_longest = forged.parameters() != before.parameters() || to_go_s <= 1107.0;
            assert!(is_longest && (0.0..=2e6).contains(&to_go_s), "{at}: {to_go_s}");
            assert!(shown.euler.roll.is_finite() && shown.rate_b.iter().all(|rate| rate.is_finite()), "{at}");
        }
        assert!(aircraft.unit == before);
    }
    let mut simulators = vec![0; 20480];
    let length = aircraft.simulator.save_snapshot(&mut simulators).unwrap();
    let error = aircraft.unit.load_snapshot(&simulators[..length]).unwrap_err();
    assert!(error.to_string().ends_with("it is one of a simulator"), "{error}");
}

/// Every number that a unit shows.
fn shown(aircraft: &Aircraft) -> Vec<f64> {
    let shown = aircraft.navigation();
    let (place, euler) = (shown.place, shown.euler);
    let mut all = vec![shown.time_s, place.latitude_rad, place.longitude_rad, place.height_m];
    all.extend([euler.roll, euler.pitch, euler.heading]);
    all.extend(shown.v_n.iter().chain(&shown.rate_b).chain(&shown.force_b));
    let status = aircraft.unit.status();
    all.extend([status.to_go_s, status.in_navigation_s, status.found_latitude_rad.unwrap_or_default()]);
    all
}

/// Each word of snapshots in every state, in turn another number: rejected, or a unit that shows numbers, at once and on the ground, in the
/// air and in another mode.
#[test]
fn forged_snapshots_show_numbers() {
    let mut moments = Vec::new();
    let mut aircraft = Aircraft::new(10.0, 2, 5.0, &papers_sensors());
    aircraft.unit.select(Mode::Align);
    for (mode, motion, seconds) in [
        (Mode::Align, Motion::Rest, 40.0),
        (Mode::Align, Motion::Rest, 90.0),
        (Mode::Align, Motion::Sway, 300.0),
        (Mode::Navigate, Motion::Drive { acceleration: 1.0, to: 20.0 }, 30.0),
        (Mode::Align, Motion::Rest, 40.0),
        (Mode::Attitude, Motion::Rest, 60.0),
    ] {
        aircraft.unit.select(mode);
        aircraft.go(motion, seconds);
        moments.push(aircraft.clone());
        if mode == Mode::Align {
            aircraft.enter_true_position();
        }
    }
    let mut aircraft = Aircraft::new(10.0, 2, 5.0, &papers_sensors());
    aircraft.receiver = Some(Receiver::new(9, 3.0, 0.02));
    aircraft.unit.set_alignment(AlignmentKind::InFlight);
    aircraft.unit.select(Mode::Navigate);
    for motion in [Motion::Drive { acceleration: 1.0, to: 80.0 }, Motion::Turn(0.03)] {
        aircraft.go(motion, 50.0);
        moments.push(aircraft.clone());
    }
    let numbers = [5e-324, 1e-6, 1.0, 1e12, 1e120, -1e9].map(f64::to_bits);
    let (mut all, mut loaded) = (0, 0);
    for aircraft in &moments {
        let good = words(&saved(&aircraft.unit));
        assert!(
            forge(&good, SnapshotOf::Unit) == saved(&aircraft.unit),
            "the forger's words are the saved ones"
        );
        for (at, number) in (0..good.len()).flat_map(|at| numbers.map(|number| (at, number))) {
            let mut words = good.clone();
            words[at] = number;
            let bytes = forge(&words, SnapshotOf::Unit);
            let mut other = aircraft.clone();
            all += 1;
            if other.unit.load_snapshot(&bytes).is_err() {
                continue;
            }
            loaded += 1;
            let state = other.unit.status().state;
            let check = |other: &Aircraft, when: &str| {
                let shown = shown(other);
                assert!(
                    shown.iter().all(|number| number.is_finite()),
                    "{state:?} {at} {:e} {when}: {shown:?}",
                    f64::from_bits(number)
                );
            };
            check(&other, "at once");
            other.stand(1.0);
            check(&other, "at rest");
            other.receiver = Some(Receiver::new(9, 3.0, 0.02));
            other.go(Motion::Drive { acceleration: 1.0, to: 80.0 }, 2.2);
            check(&other, "in motion");
            other.unit.select(if state == State::Navigation { Mode::Align } else { Mode::Attitude });
            other.stand(1.0);
            check(&other, "in another mode");
        }
    }
    println!("{loaded} of {all} forged snapshots are units");
}

/// A pair that is saved between the step and the update of the unit: the parts of the interval are in the snapshot of the simulator.
#[test]
fn a_pair_saved_before_the_update_goes_on_to_the_same_bits() {
    let mut aircraft = Aircraft::new(10.0, 2, 5.0, &papers_sensors());
    aircraft.unit.select(Mode::Align);
    for _ in 0..200 {
        aircraft.go(Motion::Sway, 0.2);
        let mut behind = aircraft.clone();
        behind.step_without_update(Motion::Sway);
        let mut loaded = behind.clone();
        let mut buffer = vec![0; sins::abi::SINS_SNAPSHOT_MAX_SIZE];
        let length = behind.simulator.save_snapshot(&mut buffer).unwrap();
        loaded.simulator = sins::Simulator::new(&Default::default()).unwrap();
        loaded.simulator.load_snapshot(&buffer[..length]).unwrap();
        loaded.unit.load_snapshot(&saved(&behind.unit)).unwrap();
        for each in [&mut behind, &mut loaded] {
            each.unit.update(&mut each.simulator).unwrap();
        }
        assert!(loaded.unit == behind.unit && bits(&loaded.simulator) == bits(&behind.simulator));
    }
}
