//! The keys of a scene, in the order in which they are read and written.

mod errors;
mod failure;
mod flight;
mod imu;
mod log;
mod options;
mod panel;
mod sensors;
mod update;

use super::draft::Draft;
use super::key::{Key, Section, Target, Unit};
use crate::base::joined::{joined, total};
use crate::base::parameter::Range;

/// Every key.
pub const KEYS: &[Key] = &joined::<Key, { total(PARTS) }>(PARTS);

const PARTS: &[&[Key]] = &[
    flight::FLIGHT,
    flight::START,
    flight::REPEAT,
    log::FORMAT,
    log::COLUMNS,
    log::REPAIR,
    imu::FORMAT,
    imu::COLUMNS,
    flight::MANOEUVRE,
    flight::SINUSOID,
    options::OPTIONS,
    sensors::GYRO,
    sensors::ACCELEROMETER,
    errors::ALTIMETER,
    &[sensors::START],
    errors::START,
    errors::ALIGNMENT,
    errors::MOUNTING,
    errors::GRAVITY,
    failure::FAILURE,
    update::UPDATE,
    panel::START,
    panel::UNIT_KEYS,
    panel::PANEL,
    options::OUTPUT,
];

/// The keys of a section with their places in [`KEYS`].
pub fn of_section(section: Section) -> impl Iterator<Item = (usize, &'static Key)> {
    KEYS.iter().enumerate().filter(move |(_, key)| key.section == section)
}

/// The names of the keys of a section, in their own units and in SI.
pub fn names_of(section: Section) -> impl Iterator<Item = &'static str> {
    of_section(section).flat_map(|(_, key)| [Some(key.name), key.si_name()]).flatten()
}

/// The key that sets, for `sensor`, the quantity that this key of [[failure]] sets for another sensor.
pub fn of_sensor(key: &Key, sensor: usize) -> Option<&'static str> {
    let names = failure::BY_SENSOR.iter().find(|names| names.contains(&key.name))?;
    (names[sensor] != key.name).then_some(names[sensor])
}

/// A unit, its size in SI units, and the SI unit.
const fn unit(text: &'static str, si: f64, si_text: &'static str) -> Unit {
    Unit { text, si, si_text }
}

/// A unit that the library has too.
const fn si(text: &'static str) -> Unit {
    unit(text, 1.0, text)
}

const PURE: Unit = si("");

/// A text that is not empty.
const fn text(
    section: Section,
    name: &'static str,
    example: &'static str,
    doc: &'static str,
    place: fn(&mut Draft) -> &mut String,
) -> Key {
    Key::new(section, name, doc, Target::Text { example, place })
}

/// The range of a number, from the first to the second [SI].
const fn within((low, high): (f64, f64)) -> Range {
    Range::Within(low, high)
}

/// A key of numbers: section, shape, name, unit, meaning; the library's field, its range behind `in`, and the place in the draft.
macro_rules! number {
    ($section:expr, $shape:expr, $name:literal, $unit:expr, $doc:literal,
        $field:literal $(in $limits:expr)? => $places:ident($($place:ident).+)) => {
        Key::new($section, $name, $doc, Target::Numbers {
            field: $field,
            unit: $unit,
            shape: $shape,
            range: [$(Some(super::within($limits)),)? None][0],
            place: Place::At(|draft| $places(&mut draft.$($place).+)),
        })
    };
}
use number;

/// A key of words, whose number is in the draft.
macro_rules! word {
    ($section:expr, $name:literal, $doc:literal, $field:literal, $words:expr, $($place:ident).+) => {
        Key::new($section, $name, $doc, Target::Choice {
            field: $field,
            words: $words,
            get: |draft| draft.$($place).+,
            set: |draft, index| draft.$($place).+ = index,
        })
    };
}
use word;

/// A key of words, each for one value of a place in the draft.
macro_rules! choice {
    ($section:expr, $name:literal, $doc:literal, $field:literal => $($place:ident).+, $words:expr) => {
        Key::new($section, $name, $doc, Target::Choice {
            field: $field,
            words: &crate::base::joined::first_words($words),
            get: |draft| $words.iter().position(|(_, value)| *value == draft.$($place).+).unwrap_or(0),
            set: |draft, index| draft.$($place).+ = $words[index].1,
        })
    };
}
use choice;

/// A key of a whole number, with its range behind `in`.
macro_rules! count {
    ($section:expr, $name:literal, $doc:literal, $field:literal $(in $limits:expr)? => $($place:ident).+) => {
        Key::new($section, $name, $doc, Target::Count {
            field: $field,
            range: [$(Some(super::within($limits)),)? None][0],
            get: |draft| draft.$($place).+ as u64,
            set: |draft, number| draft.$($place).+ = number.try_into().unwrap_or(!0),
        })
    };
}
use count;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_keys_of_a_section_share_a_name() {
        for section in Section::ALL {
            let names: Vec<&str> = names_of(section).collect();
            for (index, name) in names.iter().enumerate() {
                assert!(!names[..index].contains(name), "{}.{name}", section.name());
            }
        }
    }

    #[test]
    fn keys_stand_in_the_order_of_their_sections() {
        assert!(KEYS.is_sorted_by_key(|key| key.section));
    }

    /// The fields of a struct in the header, without struct_size and reserved fields.
    fn fields(header: &str, name: &str) -> Vec<String> {
        let (_, rest) = header.split_once(&format!("typedef struct {name} {{")).unwrap();
        let (body, _) = rest.split_once('}').unwrap();
        let kinds = ["int32_t ", "uint32_t ", "uint64_t ", "double "];
        let members =
            body.lines().map(str::trim).filter(|line| kinds.iter().any(|kind| line.starts_with(kind)));
        let names = members.map(|line| {
            let name = line.trim_end_matches(';').split_whitespace().last().unwrap();
            name.split('[').next().unwrap().to_owned()
        });
        names.filter(|name| !["struct_size", "reserved", "reserved2"].contains(&name.as_str())).collect()
    }

    #[test]
    fn every_field_of_the_structs_has_a_key() {
        let include = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../include");
        let headers =
            ["sins.h", "sins_flight.h"].map(|name| std::fs::read_to_string(include.join(name)).unwrap());
        let header = headers.concat();
        let mut count = 0;
        for (name, prefix) in [
            ("sins_options", "options"),
            ("sins_gyro_params", "gyro"),
            ("sins_accel_params", "accel"),
            ("sins_altimeter_params", "altimeter"),
            ("sins_initial_errors", "initial"),
            ("sins_mounting", "mounting"),
            ("sins_gravity_params", "gravity"),
            ("sins_failure", "failure"),
            ("sins_flight_start", "start"),
            ("sins_manoeuvre", "manoeuvre"),
        ] {
            for field in fields(&header, name) {
                // The flight is on the simulator's Earth; sinusoids have a section of their own, and so are counted.
                let by_another =
                    ["earth", "sinusoid_count", "channel", "amplitude", "frequency_hz", "phase_rad"];
                let is_by_another =
                    ["start", "manoeuvre"].contains(&prefix) && by_another.contains(&field.as_str());
                // Of a failure the unit belongs to the sensor.
                let path = format!("{prefix}.{field}");
                let has_key = KEYS.iter().any(|key| {
                    key.field() == path || (prefix == "failure" && key.field().starts_with(&path))
                });
                assert!(has_key || is_by_another, "{path} has no key");
                count += 1;
            }
        }
        assert!(count > 80, "{count}");
    }
}
