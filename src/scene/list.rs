//! The list of keys, for those who write a scene.

use super::Scene;
use super::column::{IMU_TAKES as IMU_COLUMN_TAKES, TAKES as COLUMN_TAKES};
use super::draft::Draft;
use super::key::{Key, Section, Target, Unit};
use super::limits::{Limits, limits};
use super::table::{KEYS, of_section};
use super::written::shown;

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
    /// Name of the SI unit; empty: none.
    pub si_unit: &'static str,
    /// Which elements a single number sets: element k by bit k; 0: a single number is not enough.
    pub spread: u32,
    /// Limits of its numbers in its unit; `None`: they depend on other values, or there are none.
    pub limits: Option<Limits>,
    /// Its value where a scene does not set it, in TOML; empty: it has none then.
    pub default: String,
    /// Items that can have it: "kind=turn|s_turn", or such conditions with a space between; empty: all.
    pub condition: String,
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

/// Key `index` of [`keys`], and how many there are.
pub fn key_line(index: usize) -> (Option<KeyLine>, usize) {
    (KEYS.get(index).map(line), KEYS.len())
}

/// The key that sets a field of the interface: "gyro.bias_deg_h" for "gyro.bias_rad_s".
pub fn key_of_field(field: &str) -> Option<String> {
    KEYS.iter().find(|key| key.field() == field).map(Key::path)
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
    const NONE: Unit = Unit { text: "", si: 1.0, si_text: "" };
    let (kind, takes, unit) = match key.target {
        Target::Numbers { shape, unit, .. } => {
            (KeyKind::Numbers(shape.count()), shape.expected().to_owned(), unit)
        }
        Target::Choice { words, .. } => (KeyKind::Words(words), words.join("|"), NONE),
        Target::Count { .. } => (KeyKind::Whole, "a whole number".to_owned(), NONE),
        Target::Text { example, .. } => (KeyKind::Text, format!("a text, as \"{example}\""), NONE),
        Target::Flag { .. } => (KeyKind::Flag, "true or false".to_owned(), NONE),
        Target::Column(_) if key.section == Section::Imu => {
            (KeyKind::Text, IMU_COLUMN_TAKES.to_owned(), NONE)
        }
        Target::Column(_) => (KeyKind::Text, COLUMN_TAKES.to_owned(), NONE),
    };
    let spread = match key.target {
        Target::Numbers { shape, .. } => (0..shape.count())
            .filter(|&element| shape.single_sets(element) == Some(true))
            .fold(0, |bits, element| bits | 1 << element),
        _ => 0,
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
        si_unit: unit.si_text,
        spread,
        limits: limits(key),
        default: shown(&mut Draft::from(&Scene::default()), key, false, None),
        condition: condition(key),
        doc: key.doc,
    }
}

/// The items that can have a key: of each key of the section that chooses among them, the words with which it is used.
fn condition(key: &Key) -> String {
    let mut draft = Draft::from(&Scene::default());
    let mut conditions = Vec::new();
    for (_, by) in of_section(key.section).filter(|(_, by)| ["kind", "channel", "sensor"].contains(&by.name))
    {
        let Target::Choice { words, set, .. } = by.target else { continue };
        // No failure is none of the kinds.
        let first = usize::from(words[0] == "none");
        let used: Vec<usize> = (first..words.len())
            .filter(|word| {
                set(&mut draft, *word);
                key.is_used(&draft)
            })
            .collect();
        set(&mut draft, used.first().copied().unwrap_or_default());
        if used.len() < words.len() - first {
            let used: Vec<&str> = used.into_iter().map(|word| words[word]).collect();
            conditions.insert(0, format!("{}={}", by.name, used.join("|")));
        }
    }
    conditions.join(" ")
}

/// The meaning and the unit of a key, for a comment behind it.
pub fn meaning(key: &Key, in_si: bool) -> String {
    match key.target {
        Target::Numbers { unit, .. } if !in_si => key.doc.to_owned() + &unit.behind(),
        Target::Numbers { .. } if in_si => format!("{} [SI]", key.doc),
        _ => key.doc.to_owned(),
    }
}
