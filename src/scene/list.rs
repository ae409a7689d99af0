//! The list of keys, for those who write a scene.

use super::key::{Key, Place, Section, Target, Unit};
use super::table::{KEYS, of_section};
use crate::sensors::{PARAMETERS, ParameterRange};

/// A key as a reader sees it.
#[derive(Debug, Clone, PartialEq)]
pub struct KeyLine {
    /// Section, with the sections above it: "manoeuvre.sinusoid".
    pub section: &'static str,
    /// Whether the section stands in double brackets, any number of times.
    pub is_list: bool,
    /// Name of the key.
    pub name: &'static str,
    /// Name of the key that takes this quantity in SI, if this key has another unit.
    pub si_name: Option<&'static str>,
    /// What kind of value it takes.
    pub kind: KeyKind,
    /// What kind of value it takes, in words: "one number for all axes, or three", or the words it takes.
    pub takes: String,
    /// Its unit; empty: none.
    pub unit: &'static str,
    /// Size of its unit in SI units.
    pub unit_si: f64,
    /// Least and largest number, in its unit, if a table has them. If 0 means off, 0 is within.
    pub limits: Option<(f64, f64)>,
    /// What it means.
    pub doc: &'static str,
}

/// What kind of value a key takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum KeyKind {
    /// This many numbers, matrices row by row.
    Numbers(usize),
    /// One of these words.
    Words(&'static [&'static str]),
    /// A whole number.
    Whole,
    /// A text.
    Text,
    /// True or false.
    Flag,
}

/// Every key of a scene, in the order in which a scene is written.
pub fn keys() -> Vec<KeyLine> {
    KEYS.iter().map(line).collect()
}

/// Every section and key as a page of text.
pub fn keys_text() -> String {
    let mut text = String::new();
    for section in Section::ALL {
        let brackets = if section.is_list() { ("[[", "]]") } else { ("[", "]") };
        let newline = if text.is_empty() { "" } else { "\n" };
        text.push_str(&format!(
            "{newline}{}{}{}  {}\n",
            brackets.0,
            section.name(),
            brackets.1,
            section.doc()
        ));
        for (_, key) in of_section(section) {
            let KeyLine { name, si_name, takes, unit, doc, .. } = line(key);
            let unit = if unit.is_empty() { String::new() } else { format!(" [{unit}]") };
            let si = si_name.map_or(String::new(), |si_name| format!("; in SI {si_name}"));
            text.push_str(&format!("  {name}: {doc}; {takes}{unit}{si}\n"));
        }
    }
    text
}

fn line(key: &Key) -> KeyLine {
    const NONE: Unit = Unit { text: "", si: 1.0 };
    let (kind, takes, unit) = match key.target {
        Target::Numbers { shape, unit, .. } => {
            (KeyKind::Numbers(shape.count()), shape.expected().to_owned(), unit)
        }
        Target::Choice { words, .. } => (KeyKind::Words(words), words.join("|"), NONE),
        Target::Count { .. } => (KeyKind::Whole, "a whole number".to_owned(), NONE),
        Target::Text { example, .. } => (KeyKind::Text, format!("a text, as \"{example}\""), NONE),
        Target::Flag { .. } => (KeyKind::Flag, "true or false".to_owned(), NONE),
    };
    KeyLine {
        section: key.section.name(),
        is_list: key.section.is_list(),
        name: key.name,
        si_name: key.si_name(),
        kind,
        takes,
        unit: unit.text,
        unit_si: unit.si,
        limits: limits(key),
        doc: key.doc,
    }
}

/// The limits of a key's numbers, in its unit.
fn limits(key: &Key) -> Option<(f64, f64)> {
    let Target::Numbers { unit, limits, place, .. } = key.target else { return None };
    let Place::Parameter(sensor, row) = place else { return limits };
    let (low, high) = match PARAMETERS[row].of(sensor)?.range {
        ParameterRange::Within(low, high) => (low, high),
        off_or => (0.0, off_or.ends().1),
    };
    // Rounded towards 0, so that the limit itself is accepted.
    let in_unit = |limit: f64| {
        let number = limit / unit.si;
        if (number * unit.si).abs() <= limit.abs() {
            number
        } else if number > 0.0 {
            number.next_down()
        } else {
            number.next_up()
        }
    };
    Some((in_unit(low), in_unit(high)))
}

/// The meaning and the unit of a key, for a comment behind it.
pub fn meaning(key: &Key, in_si: bool) -> String {
    match key.target {
        Target::Numbers { unit, .. } if !in_si && !unit.text.is_empty() => {
            format!("{} [{}]", key.doc, unit.text)
        }
        Target::Numbers { .. } if in_si => format!("{} [SI]", key.doc),
        _ => key.doc.to_owned(),
    }
}
