//! Enumerations of the interface that are enumerations of the crate, as Rust sources.

use std::fs;
use std::path::Path;

use syn::{Item, ItemEnum};

use super::read::doc;

/// The enumeration of the interface, what its constants begin with, the first of them, and the enumeration of the crate with its file.
const ENUMERATIONS: [(&str, &str, u32, &str, &str); 15] = [
    ("sins_frame", "SINS_FRAME", 0, "Frame", "mechanization/mod.rs"),
    ("sins_scheme", "SINS_SCHEME", 0, "Scheme", "mechanization/mod.rs"),
    ("sins_vertical", "SINS_VERTICAL", 0, "VerticalMode", "mechanization/vertical.rs"),
    ("sins_earth", "SINS_EARTH", 0, "Ellipsoid", "earth/mod.rs"),
    ("sins_gravity", "SINS_GRAVITY", 0, "GravityModel", "earth/gravity.rs"),
    ("sins_axes", "SINS_AXES", 0, "BodyAxes", "earth/state.rs"),
    ("sins_alignment", "SINS_ALIGNMENT", 0, "Alignment", "sensors/initial.rs"),
    ("sins_grade", "SINS_GRADE", 1, "Grade", "sensors/preset.rs"),
    ("sins_errors_source", "SINS_ERRORS", 0, "ErrorSource", "simulator/mod.rs"),
    ("sins_decision", "SINS_DECISION", 0, "Decision", "ensemble/statistics/meets.rs"),
    ("sins_bus_word_status", "SINS_BUS", 0, "WordStatus", "unit/bus/word.rs"),
    ("sins_channel", "SINS_CHANNEL", 0, "Channel", "truth/flight/manoeuvre.rs"),
    ("sins_unit_power", "SINS_UNIT_POWER", 0, "Power", "unit/panel.rs"),
    ("sins_unit_alignment", "SINS_UNIT_ALIGNMENT", 0, "AlignmentKind", "unit/panel.rs"),
    ("sins_unit_state", "SINS_UNIT_STATE", 0, "State", "unit/panel.rs"),
];

/// The enumerations of the interface: sources by their names. The crate is in the folder `src`.
pub fn interface(src: &Path) -> Vec<(String, String)> {
    let made = ENUMERATIONS.map(|(name, prefix, first, own, file)| {
        let path = src.join(file);
        println!("cargo:rerun-if-changed={}", path.display());
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let items = syn::parse_file(&text).expect("a source of the crate parses").items;
        let found = items.iter().find_map(|item| match item {
            Item::Enum(item) if item.ident == own => Some(item),
            _ => None,
        });
        let found = found.unwrap_or_else(|| panic!("{file} has no {own}"));
        (name.to_owned(), constants(found, name, prefix, first))
    });
    made.into()
}

fn constants(own: &ItemEnum, name: &str, prefix: &str, first: u32) -> String {
    let comment =
        |lines: Vec<String>| -> String { lines.iter().map(|line| format!("/// {line}\n")).collect() };
    let mut text = comment(doc(&own.attrs)) + &format!("pub type {name} = i32;\n\n");
    let mut choices = String::new();
    for (variant, number) in own.variants.iter().zip(first..) {
        let constant = format!("{prefix}{}", upper(&variant.ident.to_string()));
        text += &comment(doc(&variant.attrs));
        text += &format!("pub const {constant}: {name} = {number};\n");
        choices += &format!("    {} = {constant},\n", variant.ident);
    }
    text + &format!("\nchoices!({name}: {} {{\n{choices}}});\n", own.ident)
}

/// A name of several words as a constant has it, with a line before each: _FOLLOW_TRUTH.
fn upper(words: &str) -> String {
    let parted = |letter: char| if letter.is_uppercase() { vec!['_', letter] } else { vec![letter] };
    words.chars().flat_map(parted).collect::<String>().to_uppercase()
}
