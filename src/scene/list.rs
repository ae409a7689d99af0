//! The list of keys, for those who write a scene.

use super::key::{Key, Section, Target};
use super::table::{KEYS, of_section};

/// A key as a reader sees it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyLine {
    /// Section, with the sections above it: "manoeuvre.sinusoid".
    pub section: &'static str,
    /// Whether the section stands in double brackets, any number of times.
    pub is_list: bool,
    /// Name of the key.
    pub name: &'static str,
    /// The same quantity in SI, if the key has another unit.
    pub si_name: Option<&'static str>,
    /// What it takes: "one number for all axes, or three", or the words.
    pub takes: String,
    /// Its unit; empty: none.
    pub unit: &'static str,
    /// What it means.
    pub doc: &'static str,
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
    let (takes, unit) = match key.target {
        Target::Numbers { shape, unit, .. } => (shape.expected().to_owned(), unit.text),
        Target::Choice { words, .. } => (words.join("|"), ""),
        Target::Count { .. } => ("a whole number".to_owned(), ""),
        Target::Text { example, .. } => (format!("a text, as \"{example}\""), ""),
        Target::Flag { .. } => ("true or false".to_owned(), ""),
    };
    KeyLine {
        section: key.section.name(),
        is_list: key.section.is_list(),
        name: key.name,
        si_name: key.si_name(),
        takes,
        unit,
        doc: key.doc,
    }
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
