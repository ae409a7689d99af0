//! The list of keys, for those who write a scene.

use super::Scene;
use super::Updated;
use super::draft::{Draft, FAILURE_KINDS};
use super::key::{Key, Section, Target, Unit};
use super::limits::{Limits, limits};
use super::table::{ACTIONS, CHANNELS, KEYS, SENSORS, UPDATED, of_section, of_sensor};
use super::value::shown;
use crate::flight::{Channel, MANOEUVRE_KINDS};

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

/// The items that can have a key.
fn condition(key: &Key) -> String {
    let one_of = |key: &str, words: Vec<&str>| format!("{key}={}", words.join("|"));
    let uses = |table: &[(&'static str, &[&str])], uses: &dyn Fn(&str) -> bool| {
        let kinds = table.iter().filter(|(_, fields)| fields.iter().any(|field| uses(field)));
        kinds.map(|(kind, _)| *kind).collect::<Vec<_>>()
    };
    match (key.section, key.name) {
        (Section::Manoeuvre, "kind") | (Section::Failure, "sensor" | "kind" | "from_s" | "until_s") => {
            String::new()
        }
        (Section::Manoeuvre, _) => one_of("kind", uses(&MANOEUVRE_KINDS, &|field| field == key.field())),
        (Section::Sinusoid, "amplitude_deg" | "amplitude_m_s") => {
            let is_its = |channel: &Channel| (*channel == Channel::Speed) == (key.name == "amplitude_m_s");
            let channels = CHANNELS.iter().filter(|(_, channel)| is_its(channel));
            one_of("channel", channels.map(|(word, _)| *word).collect())
        }
        (Section::Failure, "axis") => one_of("sensor", SENSORS[..2].to_vec()),
        (Section::Failure, _) => {
            let quantity = key.field().trim_start_matches("failure.");
            let kinds = one_of("kind", uses(&FAILURE_KINDS[1..], &|field| quantity.starts_with(field)));
            let sensors: Vec<&str> = (0..3)
                .filter(|sensor| of_sensor(key, *sensor).is_none())
                .map(|sensor| SENSORS[sensor])
                .collect();
            if sensors.len() == SENSORS.len() {
                kinds
            } else {
                format!("{kinds} {}", one_of("sensor", sensors))
            }
        }
        (Section::Update, _) => key.is_of_velocity().map_or(String::new(), |is_of_velocity| {
            let kinds =
                UPDATED.iter().filter(|(_, updated)| (*updated == Updated::Velocity) == is_of_velocity);
            one_of("kind", kinds.map(|(word, _)| *word).collect())
        }),
        (Section::Panel, _) => {
            let users: Vec<&str> = ACTIONS
                .iter()
                .filter(|(_, action)| key.is_used_by_action(*action))
                .map(|(word, _)| *word)
                .collect();
            if users.len() == ACTIONS.len() { String::new() } else { one_of("kind", users) }
        }
        _ => String::new(),
    }
}

/// The meaning and the unit of a key, for a comment behind it.
pub fn meaning(key: &Key, in_si: bool) -> String {
    match key.target {
        Target::Numbers { unit, .. } if !in_si => key.doc.to_owned() + &unit.behind(),
        Target::Numbers { .. } if in_si => format!("{} [SI]", key.doc),
        _ => key.doc.to_owned(),
    }
}
