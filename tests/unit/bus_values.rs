//! Words of ARINC 429 that say what no unit can mean, and the reasons why a word is rejected.

use sins::unit::bus::{Format, LABELS, Label, WordStatus, decode, decode_reversed, reversed};
use sins::unit::{Mode, State};

use crate::aircraft::{Aircraft, Motion};
use crate::support::DEG;
use crate::support::draws::Draws;

fn label(number: u8) -> &'static Label {
    LABELS.iter().find(|label| label.number == number).unwrap()
}

/// The word with these bits above its label, with the right parity.
fn word(number: u8, bits: u32) -> u32 {
    let word = u32::from(number) | bits & 0x7fff_ff00;
    word | u32::from(word.count_ones().is_multiple_of(2)) << 31
}

/// The decimal digits of a field, if its hexadecimal digits are some.
fn digits(word: u32, lowest: u32, bits: u32) -> Option<f64> {
    let text = format!("{:x}", word >> lowest & ((1 << bits) - 1));
    text.parse::<u32>().ok().map(f64::from)
}

/// The value of a word with a normal status, if it is one: the fields as hexadecimal text, or as a share of the full scale; and the range
/// of each quantity. Nothing is from the library.
fn meant(word: u32) -> Option<f64> {
    let sign = if word >> 29 & 3 == 3 { -1.0 } else { 1.0 };
    let place = |limit: f64| {
        let (degrees, minutes) = (digits(word, 20, 9)?, digits(word, 8, 12)? / 10.0);
        let degrees = (minutes < 60.0).then_some(degrees + minutes / 60.0)?;
        (degrees <= limit).then_some(sign * degrees)
    };
    let positive = |value: Option<f64>, limit: f64| {
        value.map(|value| sign * value).filter(|v| (0.0..=limit).contains(v))
    };
    // The data as a fraction of the full scale: 29 bits at the top of the integer, without those below the lowest.
    let binary = |lowest: u32, scale: f64| {
        let data = (word << 3) as i32 >> (lowest + 3) << (lowest + 3);
        scale * f64::from(data) / 2_f64.powi(31)
    };
    let within = |value: f64, low: f64, high: f64| (low..=high).contains(&value).then_some(value);
    match word as u8 {
        0o010 | 0o041 => place(90.0),
        0o011 | 0o042 => place(180.0),
        0o012 => positive(digits(word, 14, 15), 7999.0),
        0o013 | 0o014 | 0o044 => positive(digits(word, 14, 14).map(|tenths| tenths / 10.0), 360.0),
        0o015 => positive(digits(word, 18, 10), 399.0),
        0o016 | 0o043 => positive(digits(word, 18, 10), 360.0),
        0o007 => positive(digits(word, 18, 8).map(|tenths| tenths / 10.0), 9.9),
        0o351 => positive(digits(word, 14, 8).map(|tenths| tenths / 10.0), 9.9),
        0o310 => within(binary(8, 180.0), -90.0, 90.0),
        0o311 => Some(binary(8, 180.0)),
        0o361 => Some(binary(8, 131_072.0)),
        0o312 => within(binary(10, 4096.0), 0.0, 4096.0),
        0o315 => within(binary(10, 256.0), 0.0, 256.0),
        0o322 | 0o324 => within(binary(10, 180.0), -90.0, 90.0),
        0o313 | 0o314 | 0o316 | 0o317 | 0o320 | 0o321 | 0o325 => Some(binary(10, 180.0)),
        0o326 | 0o327 | 0o330 | 0o336 | 0o337 => Some(binary(10, 128.0)),
        0o323 | 0o331 | 0o332 | 0o333 | 0o362 | 0o363 | 0o364 | 0o375 | 0o376 => Some(binary(10, 4.0)),
        0o335 => Some(binary(10, 32.0)),
        0o360 | 0o365 => Some(binary(10, 32_768.0)),
        0o366 | 0o367 => Some(binary(10, 4096.0)),
        0o370 => Some(binary(10, 8.0)),
        0o126 => within(binary(13, 32_768.0), 0.0, 32_768.0),
        0o270 => Some(f64::from(word >> 10 & 0x7_ffff)),
        other => panic!("label {other:o}"),
    }
}

/// Number of words of a label that are decoded: with `--features long-tests` all, those of other parities apart.
const WORDS: u32 = if cfg!(feature = "long-tests") { 1 << 23 } else { 100_000 };

/// All bits under every label, or random ones: what the word means, or "illegal value", and never a number then.
#[test]
fn no_word_decodes_as_a_value_that_it_does_not_have() {
    let (mut draws, mut illegal) = (Draws::new(429), 0);
    for label in &LABELS {
        let mut illegal_here = 0;
        for index in 0..WORDS {
            let is_whole = cfg!(feature = "long-tests");
            let word = word(label.number, if is_whole { index << 8 } else { (draws.next() >> 32) as u32 });
            let found = decode(word).unwrap();
            let is_normal = match label.format {
                Format::Binary { .. } => word >> 29 & 3 == 3,
                Format::Decimal(_) => matches!(word >> 29 & 3, 0 | 3),
                Format::Bits => word >> 29 & 3 == 0,
            };
            match meant(word) {
                _ if !is_normal => {
                    assert!(
                        !matches!(found.status, WordStatus::Normal | WordStatus::IllegalValue),
                        "{word:08x}"
                    );
                }
                Some(value) => {
                    assert_eq!(found.status, WordStatus::Normal, "{word:08x} {value}");
                    assert!(
                        (found.value - value).abs() <= 4.0 * f64::EPSILON * value.abs(),
                        "{word:08x} {found:?} {value}"
                    );
                }
                None => {
                    assert!(
                        found.status == WordStatus::IllegalValue && found.value.is_nan(),
                        "{word:08x} {found:?}"
                    );
                    assert!(found.illegal.is_some(), "{word:08x}");
                    illegal_here += 1;
                }
            }
        }
        let is_decimal = matches!(label.format, Format::Decimal(_));
        assert!(illegal_here > 1000 || !is_decimal, "{}: the test has drawn no illegal word", label.name);
        illegal += illegal_here;
    }
    println!("figure: {illegal} of {} words illegal", u64::from(WORDS) * LABELS.len() as u64);
}

/// Every number of every label, from the end of its range to the other; and with each other status.
#[test]
fn every_legal_word_decodes_to_its_value() {
    let mut count = 0;
    for label in &LABELS {
        let (low, high) = label.least_and_greatest();
        let steps = |value: f64| (value / label.resolution).round() as i64;
        for step in steps(low)..=steps(high) {
            let value = step as f64 * label.resolution;
            let word = label.encode(value, 0);
            let found = decode(word).unwrap();
            assert!(
                found.status == WordStatus::Normal && (found.value - value).abs() < 1e-6 * label.resolution,
                "{}: {value} {word:08x} {found:?}",
                label.name
            );
            count += 1;
        }
        // Beyond the range, the end of the range is sent, or the angle wraps: nothing that is illegal.
        for value in [1.001 * high, 1.001 * low - 0.3, 10.0 * high, 10.0 * low - 5.0, 1e300, -1e300, f64::NAN]
        {
            assert_eq!(
                decode(label.encode(value, 0)).unwrap().status,
                WordStatus::Normal,
                "{}: {value}",
                label.name
            );
        }
    }
    println!("figure: {count} legal ones");
}

/// By hand: what is wrong, and the sentence that says it.
#[test]
fn an_illegal_value_says_which_digit_or_which_range() {
    for (given, sentence) in [
        // 041: the tens of degrees are F.
        (0x04f3_0021, "digit[2] = 15: must be from 0 to 9"),
        // 012: the tens are F.
        (0x00bc_000a, "digit[2] = 15: must be from 0 to 9"),
        // 041: N 45 75.0.
        (word(0o041, 0x0457_5000), "digit[3] = 7: must be from 0 to 5"),
        // 010: 99 degrees.
        (word(0o010, 0x0990_0000), "latitude = 99: must be from -90 to 90"),
        // 042: W 180 30.0.
        (word(0o042, 0x7803_0000), "set longitude = -180.5: must be from -180 to 180"),
        // 043: 361, and minus 10 degrees.
        (word(0o043, 0x0d84_0000), "set heading = 361: must be from 0 to 360"),
        (word(0o043, 0x6040_0000), "set heading = -10: must be from 0 to 360"),
        // 310: 90 degrees are 0x08000000.
        (word(0o310, 0x6810_0000), "latitude = 90.703125: must be from -90 to 90"),
        (word(0o310, 0x7000_0000), "latitude = -180: must be from -90 to 90"),
        // 312: the sign is set.
        (word(0o312, 0x7fff_fc00), "ground speed = -0.015625: must be from 0 to 4096"),
    ] {
        let found = decode(given).unwrap();
        assert!(found.status == WordStatus::IllegalValue && found.value.is_nan(), "{given:08x} {found:?}");
        assert_eq!(found.illegal.unwrap().to_string(), sentence, "{given:08x}");
        assert_eq!(decode_reversed(reversed(given)).unwrap().status, WordStatus::IllegalValue);
    }
}

#[test]
fn a_rejected_word_says_why() {
    let sentence = |found: Result<sins::unit::bus::Decoded, sins::Error>| found.unwrap_err().to_string();
    let parity = "has an even parity; words of ARINC 429 have an odd one";
    assert_eq!(sentence(decode(0xe400_00c9)), format!("word = e40000c9: {parity}"));
    assert_eq!(sentence(decode_reversed(0x1)), "word = 00000001: label 200 is not in the table");
    assert_eq!(sentence(decode(0x6400_00c8)), format!("word = 640000c8: {parity}"));
    // Label 023 is 310 with its bits in the other order.
    assert_eq!(
        sentence(decode(0xe400_0013)),
        "word = e4000013: label 023 is not in the table; label bits reversed? 310 would be latitude"
    );
    assert_eq!(
        sentence(decode_reversed(0xe400_00c8)),
        "word = e40000c8: label 023 is not in the table; label bits not reversed? 310 would be latitude"
    );
    assert_eq!(sentence(decode(0x0000_0001)), "word = 00000001: label 001 is not in the table");
    for label in &LABELS {
        let given = label.encode(0.0, 0);
        assert_eq!(decode_reversed(reversed(given)), decode(given));
    }
}

/// What a control panel sends goes into the unit if it is legal, up to the ends of the ranges; what is not is a number that the unit does
/// not take.
#[test]
fn set_words_are_entered_or_refused() {
    let mut aircraft = Aircraft::ideal(45.0);
    aircraft.unit.select(Mode::Align);
    aircraft.stand(10.0);
    assert_eq!(aircraft.unit.status().state, State::CoarseAlignment);
    let sent = |number: u8, value: f64| decode(label(number).encode(value, 0)).unwrap().value * DEG;
    for latitude in [90.0, -90.0, 45.5, 0.0] {
        for longitude in [180.0, -180.0, -0.1] {
            let entered = aircraft.unit.enter_position(sent(0o041, latitude), sent(0o042, longitude));
            assert_eq!(entered, Ok(()), "{latitude} {longitude}");
        }
    }
    let before = aircraft.unit;
    let value = |given: u32| decode(given).unwrap().value * DEG;
    for bad in [0x04f3_0021, word(0o041, 0x0457_5000), word(0o041, 0x0900_0100)] {
        let error = aircraft.unit.enter_position(value(bad), 0.0).unwrap_err();
        assert_eq!(error.to_string(), "latitude_rad = NaN: must be a finite number", "{bad:08x}");
    }
    for bad in [word(0o042, 0x1800_0100), word(0o042, 0x1785_9a00), word(0o042, 0x7990_0000)] {
        let error = aircraft.unit.enter_position(0.5, value(bad)).unwrap_err();
        assert_eq!(error.to_string(), "longitude_rad = NaN: must be a finite number", "{bad:08x}");
    }
    assert!(aircraft.unit == before);
    let mut aircraft = Aircraft::ideal(45.0);
    aircraft.unit.select(Mode::Attitude);
    aircraft.until(Motion::Rest, State::Attitude, 300.0);
    for heading in [0.0, 359.0, 360.0] {
        assert_eq!(aircraft.unit.enter_heading(sent(0o043, heading)), Ok(()), "{heading}");
    }
    for bad in [0x0d84_0000, 0x6040_0000, 0x03c0_0000] {
        let error = aircraft.unit.enter_heading(value(word(0o043, bad))).unwrap_err();
        assert_eq!(error.to_string(), "heading_rad = NaN: must be a finite number", "{bad:08x}");
    }
}
