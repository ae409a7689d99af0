//! Words of ARINC 429.

use sins::unit::bus::{Format, Inputs, LABELS, Word, WordStatus, decode, reversed, words};
use sins::unit::{Mode, State, Status, UnitNavigation, Validity};

use crate::aircraft::{Aircraft, Motion, papers_sensors};
use crate::support::DEG;
use crate::support::draws::Draws;

fn label(number: u8) -> &'static sins::unit::bus::Label {
    LABELS.iter().find(|label| label.number == number).unwrap()
}

/// Computed by hand: label, data shifted to their bits, status, and the parity bit where the count of ones is even.
#[test]
fn words_are_those_computed_by_hand() {
    for (number, value, word) in [
        // 45 / (180 / 2^20) = 2^18 at bit 8; status 3 at bit 29; 6 ones.
        (0o310, 45.0, 0xe400_00c8),
        // -2^19 in 21 bits is 0x180000; 8 ones.
        (0o311, -90.0, 0xf800_00c9),
        // 480 * 64 = 0x7800 at bit 10; 10 ones.
        (0o312, 480.0, 0xe1e0_00ca),
        // 270 is -90: -2^17 in 19 bits is 0x60000; 8 ones.
        (0o314, 270.0, 0xf800_00cc),
        // 30 / (180 / 2^18) = 43690.7: 0xaaab; 16 ones.
        (0o325, 30.0, 0xe2aa_acd5),
        // -8000 in 19 bits is 0x7e0c0; 16 ones.
        (0o365, -1000.0, 0xff83_00f5),
        // 48 07.3: digits 4 at 24, 8 at 20, 0 at 16, 7 at 12, 3 at 8; status 0; 8 ones.
        (0o010, 48.0 + 7.3 / 60.0, 0x8480_7308),
        // 122 22.5 west: 1 at 28, 2 at 24, 20, 16, 12, 5 at 8; status 3; 11 ones.
        (0o011, -122.375, 0x7222_2509),
        // 123.4: 1 at 26, 2 at 22, 3 at 18, 4 at 14; 7 ones.
        (0o044, 123.4, 0x048d_0024),
        // 2^16 at bit 10; 9 ones.
        (0o333, 1.0, 0x6400_00db),
        // 65 at bit 13; 8 ones.
        (0o126, 65.0, 0xe008_2056),
    ] {
        let label = label(number);
        let found = label.encode(value, 0);
        assert_eq!(found, word, "{number:o}: {found:08x}");
        let decoded = decode(word).unwrap();
        let turned = if number == 0o314 { value - 360.0 } else { value };
        assert!((decoded.value - turned).abs() <= 0.5 * label.resolution, "{number:o}: {}", decoded.value);
        assert_eq!(decoded.status, WordStatus::Normal);
    }
}

/// A flight in the four quarters of the globe, over the date line and near a pole: each word of a valid value is the value to half its
/// resolution, or the end of its range.
#[test]
fn every_label_is_decoded_to_half_its_resolution() {
    let mut draws = Draws::new(1);
    for _ in 0..100_000 {
        for label in &LABELS {
            let Format::Binary { lowest, wraps } = label.format else { continue };
            let span = label.resolution * (1_u64 << (29 - lowest)) as f64;
            let value = draws.within(-0.75 * span, 0.75 * span);
            let (low, high) = (label.range.0, label.range.1.min(0.5 * span - label.resolution));
            let expected = if wraps { value - span * (value / span).round() } else { value.clamp(low, high) };
            let found = decode(label.encode(value, 3)).unwrap();
            let miss = (found.value - expected).abs();
            let miss = if wraps { miss.min(span - miss) } else { miss };
            assert!(
                found.label == label && miss <= 0.500_001 * label.resolution,
                "{}: {value} {}",
                label.name,
                found.value
            );
        }
    }
    for (label, value) in LABELS.iter().zip([0.0, f64::NAN, f64::INFINITY, -1e300, 1e300].into_iter().cycle())
    {
        assert!(
            decode(label.encode(value, 0)).is_ok_and(|decoded| decoded.value.is_finite()),
            "{}",
            label.name
        );
    }
}

fn due(aircraft: &Aircraft, from_s: f64, to_s: f64) -> Vec<Word> {
    let mut found = Vec::new();
    let (status, shown) = (aircraft.unit.status(), aircraft.navigation());
    words(&status, &shown, &Inputs::default(), (from_s, to_s), |word| found.push(word)).unwrap();
    found
}

/// Whatever the split of the time, each label is sent at the multiples of its interval, in order.
#[test]
fn each_label_has_its_interval() {
    let mut aircraft = Aircraft::ideal(45.0);
    aircraft.unit = sins::unit::Unit::new(&Default::default(), Mode::Navigate).unwrap();
    aircraft.stand(1.0);
    let whole = due(&aircraft, 3.0, 5.0);
    let mut split = Vec::new();
    for step in 0..200 {
        split.extend(due(&aircraft, 3.0 + 0.01 * f64::from(step), 3.0 + 0.01 * f64::from(step + 1)));
    }
    assert_eq!(whole, split);
    assert!(whole.is_sorted_by_key(|word| (word.time_s * 1e3).round() as i64));
    for label in &LABELS {
        let count = whole.iter().filter(|word| word.label == label.number).count();
        assert_eq!(count as u32, 2000_u32.checked_div(label.interval_ms).unwrap_or(0), "{}", label.name);
    }
}

/// A word is due at its time, and not before: a nanosecond earlier it is not sent, a time that is its rounding counts as it. Wherever the
/// time is split, each word is sent once.
#[test]
fn no_word_is_sent_before_its_time() {
    let status = Status { state: State::Navigation, ..Status::default() };
    let sent = |from_s: f64, to_s: f64| {
        let mut found = Vec::new();
        let shown = UnitNavigation::default();
        words(&status, &shown, &Inputs::default(), (from_s, to_s), |word| found.push(word)).map(|()| found)
    };
    for due_s in [-86_400.04, -0.04, 0.04, 0.28, 0.56, 1.2, 172_800.2] {
        for early_s in [1e-9, 5e-7, 9e-7, 1e-5, 9e-4] {
            let found = sent(due_s - 1e-3, due_s - early_s).unwrap();
            assert!(found.is_empty(), "{due_s} - {early_s}: {found:?}");
        }
        let early_s = due_s - 2.0 * f64::EPSILON * due_s.abs();
        assert!(sent(due_s - 1e-3, early_s).unwrap().iter().all(|word| word.time_s == due_s));
        assert!(!sent(due_s - 1e-3, early_s).unwrap().is_empty() && sent(early_s, due_s).unwrap().is_empty());
        assert!(sent(due_s, due_s + 9.99e-4).unwrap().is_empty());
    }
    // No word is later than four roundings of the time after which it is sent, to the bit.
    for due_ms in (0..10_000_000_000_000_i64).step_by(40 * 10_000_019) {
        let due_s = due_ms as f64 / 1e3;
        let mut to_s = due_s;
        for _ in 0..12 {
            to_s = to_s.next_down();
            let count = sent(due_s - 1e-3, to_s).unwrap().len();
            assert_eq!(count > 0, due_s - to_s <= 4.0 * f64::EPSILON * to_s.abs(), "{due_s} until {to_s}");
        }
    }
    let whole = sent(-0.5, 1.5).unwrap();
    for parts in 1..200 {
        let time = |part| -0.5 + 2.0 * f64::from(part) / f64::from(parts);
        let split: Vec<Word> =
            (0..parts).flat_map(|part| sent(time(part), time(part + 1)).unwrap()).collect();
        assert_eq!(whole, split, "{parts} parts");
    }
    let rejected = |from_s, to_s| sent(from_s, to_s).map(|found| found.len()).unwrap_err().to_string();
    assert!(sent(-1e10, -1e10 + 1.0).is_ok() && sent(1e10, 1e10 + 10.0).is_ok());
    assert_eq!(rejected(-1.1e10, 0.0), "from_s = -1.1e10: must be from -1e10 to 1e10");
    assert_eq!(rejected(0.0, -1.0), "to_s = -1: must be from 0 to 10");
}

/// Off: no words. Test: functional test. Alignment: no computed data but for what is valid. Fault: failure warning.
#[test]
fn the_status_follows_the_unit() {
    let statuses = |aircraft: &Aircraft| {
        let all = due(aircraft, 9.0, 10.0);
        [0o310, 0o314, 0o324, 0o326, 0o320, 0o044].map(|number| {
            let word = all.iter().find(|word| word.label == number);
            word.map(|word| decode(word.word).unwrap().status)
        })
    };
    use WordStatus::{FailureWarning, FunctionalTest, NoComputedData, Normal};
    let mut aircraft = Aircraft::ideal(45.0);
    aircraft.stand(1.0);
    assert_eq!(statuses(&aircraft), [None; 6]);
    aircraft.unit.select(Mode::Align);
    aircraft.stand(1.0);
    assert_eq!(statuses(&aircraft), [Some(FunctionalTest); 6]);
    aircraft.stand(10.0);
    let of = |all: [WordStatus; 6]| all.map(Some);
    let no = NoComputedData;
    assert_eq!(statuses(&aircraft), of([no, no, no, Normal, no, no]));
    aircraft.enter_true_position();
    aircraft.stand(30.0);
    assert_eq!(statuses(&aircraft), of([no, no, Normal, Normal, no, no]));
    aircraft.until(Motion::Rest, State::Ready, 600.0);
    aircraft.unit.select(Mode::Navigate);
    aircraft.stand(1.0);
    assert_eq!(statuses(&aircraft), of([Normal, Normal, Normal, Normal, no, Normal]));
    aircraft
        .simulator
        .set_failure(
            sins::sensors::SensorOutput::Gyro(sins::sensors::Axis::X),
            Some(sins::sensors::Failure::Dead),
        )
        .unwrap();
    aircraft.stand(3.0);
    // A decimal word has no failure warning.
    assert_eq!(
        statuses(&aircraft),
        of([FailureWarning, FailureWarning, FailureWarning, FailureWarning, FailureWarning, no])
    );
}

/// In a turn with its bank: roll, rates, accelerations and the track agree with the flight.
#[test]
fn the_values_are_those_of_the_flight() {
    let mut aircraft = Aircraft::new(45.0, 1, 50.0, &papers_sensors());
    aircraft.unit = sins::unit::Unit::new(&Default::default(), Mode::Navigate).unwrap();
    aircraft.go(Motion::Drive { acceleration: 5.0, to: 150.0 }, 40.0);
    let (rate, t) = (1.5 * DEG, 30.0);
    aircraft.go(Motion::Turn(rate), t);
    let all = due(&aircraft, 9.0, 10.0);
    let value =
        |number: u8| decode(all.iter().find(|word| word.label == number).unwrap().word).unwrap().value;
    let bank = (rate * 150.0 / sins::units::STANDARD_GRAVITY).atan();
    let force = sins::units::STANDARD_GRAVITY.hypot(rate * 150.0) / sins::units::STANDARD_GRAVITY;
    for (number, expected, tolerance) in [
        (0o312, 150.0 * 3600.0 / 1852.0, 0.1),
        (0o325, bank / DEG, 0.05),
        (0o335, 1.5, 0.02),
        (0o330, 1.5 * bank.cos(), 0.01),
        (0o326, 1.5 * bank.sin(), 0.01),
        (0o333, force, 0.005),
        (0o332, 0.0, 0.005),
        (0o363, rate * 150.0 / sins::units::STANDARD_GRAVITY, 0.005),
        (0o321, 0.0, 0.1),
        (0o336, 0.0, 0.01),
        (0o364, 0.0, 0.005),
    ] {
        let found = value(number);
        assert!((found - expected).abs() < tolerance, "{number:o}: {found} {expected}");
    }
    let heading = aircraft.heading() / DEG;
    assert!(((value(0o314) - heading + 540.0).rem_euclid(360.0) - 180.0).abs() < 0.1);
    assert!((value(0o044) - heading.rem_euclid(360.0)).abs() < 0.2, "{} {heading}", value(0o044));
}

#[test]
fn magnetic_words_and_wind_come_from_the_inputs() {
    let status = Status { state: State::Navigation, ..Status::default() };
    let validity = Validity { rates: true, attitude: true, heading: true, position: true, velocity: true };
    let mut shown = UnitNavigation { validity, ..Default::default() };
    shown.euler.heading = 10.0 * DEG;
    let inputs =
        Inputs { wind: Some((20.0, 200.0 * DEG)), variation_rad: Some(12.0 * DEG), ..Default::default() };
    let mut all = Vec::new();
    words(&status, &shown, &inputs, (0.0, 1.0), |word| all.push(word)).unwrap();
    let value =
        |number: u8| decode(all.iter().find(|word| word.label == number).unwrap().word).unwrap().value;
    assert!((value(0o320) + 2.0).abs() < 1e-3 && (value(0o014) - 358.0).abs() < 0.06);
    assert!(
        (value(0o315) - 38.877).abs() < 1e-3 && (value(0o316) + 160.0).abs() < 1e-3 && value(0o016) == 200.0
    );
    let word = all.iter().find(|word| word.label == 0o310).unwrap().word;
    assert!(reversed(reversed(word)) == word && reversed(word) & 0xff == 0o310_u32.reverse_bits() >> 24);
    let error = words(&status, &shown, &inputs, (0.0, 11.0), |_| ()).unwrap_err();
    assert_eq!(error.to_string(), "to_s = 11: must be from 0 to 10");
}
