//! The keys of a section, into a draft.

use core::ops::Range;

use toml::de::{DeTable, DeValue};

use super::draft::Draft;
use super::fault::{Faults, nearest, unknown};
use super::key::{Key, Section, Target};
use super::setting::{Setting, check_settings};
use super::table::{self, KEYS, names_of};
use super::value::{Value, put};
use crate::flight::Manoeuvre;

type Span = Range<usize>;

/// A section, or an item of a list: where its head stands, and where those of its keys that the text sets, by their
/// place in the table.
#[derive(Debug, Clone, Default)]
pub(super) struct Item {
    pub head: Span,
    pub keys: Vec<(usize, Span)>,
}

impl Item {
    /// Where the key of `name` stands.
    pub fn key(&self, name: &str) -> Option<&Span> {
        self.keys.iter().find(|(index, _)| KEYS[*index].name == name).map(|(_, span)| span)
    }

    /// The key that the text sets for the field of an error, and where.
    pub fn of_field(&self, field: &str) -> Option<(&'static Key, &Span)> {
        let sets = |key: &Key| !field.is_empty() && (key.field().starts_with(field) || key.path() == field);
        self.keys.iter().find(|(index, _)| sets(&KEYS[*index])).map(|(index, span)| (&KEYS[*index], span))
    }
}

/// What has been read of a text, and what is wrong with it.
pub(super) struct Reader<'t> {
    pub faults: Faults<'t>,
    pub draft: Draft,
    pub sections: [Item; Section::ALL.len()],
    pub manoeuvres: Vec<Manoeuvre>,
    /// Where each manoeuvre stands.
    pub items: Vec<Item>,
    pub settings: Vec<Setting>,
}

impl Reader<'_> {
    pub fn section(&self, section: Section) -> &Item {
        &self.sections[section as usize]
    }

    /// Reads the keys of a section in the order of the table, so that a preset comes before what differs from it.
    pub fn read_keys(&mut self, section: Section, head: Span, section_table: &DeTable<'_>) -> Item {
        let mut item = Item { head, keys: Vec::new() };
        check_settings(&self.settings, section, &mut self.faults);
        for (index, key) in table::of_section(section) {
            let is_of_key = |setting: &&Setting| {
                setting.section == section
                    && (setting.name == key.name || Some(setting.name.as_str()) == key.si_name())
            };
            // The last of them: the same quantity may be set in its unit and in SI.
            if let Some(setting) = self.settings.iter().rfind(is_of_key) {
                let value = match key.target {
                    Target::Text { .. } if !matches!(setting.value, Value::Text(_)) => {
                        &Value::Text(setting.text.clone())
                    }
                    _ => &setting.value,
                };
                item.keys.push((index, setting.span.clone()));
                if let Err(sentence) = put(&mut self.draft, key, setting.name != key.name, value) {
                    self.faults.add(&setting.span, sentence);
                }
                continue;
            }
            let mut first: Option<&str> = None;
            for (name, in_si) in [(Some(key.name), false), (key.si_name(), true)] {
                let found =
                    name.and_then(|name| section_table.get_key_value(name).map(|found| (name, found)));
                let Some((name, (at, value))) = found else { continue };
                if let Some(first) = first {
                    self.faults.add(&at.span(), format!("{name}: the same quantity as {first}; give one"));
                    continue;
                }
                first = Some(name);
                item.keys.push((index, at.span()));
                if let Err(sentence) = put(&mut self.draft, key, in_si, &Value::of(value.get_ref())) {
                    self.faults.add(&value.span(), sentence);
                }
            }
        }
        for (name, value) in section_table {
            if self.faults.are_many() {
                break;
            }
            let (name, span) = (name.get_ref().as_ref(), name.span());
            let is_sinusoids = section == Section::Manoeuvre && name == "sinusoid";
            if is_sinusoids && !matches!(value.get_ref(), DeValue::Array(_)) {
                self.faults.add(&span, "sinusoid: expected [[manoeuvre.sinusoid]], in double brackets");
            } else if !is_sinusoids && !names_of(section).any(|known| known == name) {
                self.faults.add(&span, unknown("key", name, nearest(name, names_of(section))));
            }
        }
        item
    }
}
