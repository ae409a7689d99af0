//! Settings: keys that are set in addition to the text of a scene.

use core::ops::Range;

use super::fault::{excerpt, nearest};
use super::key::Section;
use super::read::{Reader, unknown};
use super::table;
use super::value::Value;

/// A value that takes the place of the text's.
#[derive(Debug)]
pub(super) struct Setting {
    pub section: Section,
    pub name: String,
    pub text: String,
    pub value: Value,
    pub span: Range<usize>,
}

impl Reader<'_> {
    /// Takes keys and values, as `section.key` and the text of a value; notes what is wrong with a key.
    pub fn take_settings(&mut self, settings: &[(&str, &str)]) {
        for (index, (path, text)) in settings.iter().enumerate() {
            let span = self.faults.setting_span(index);
            let Some((section, name)) = path.rsplit_once('.') else {
                self.faults.add(&span, format!("{}: expected section.key", excerpt(path)));
                continue;
            };
            match Section::ALL.into_iter().find(|known| known.name() == section) {
                Some(section) if section.is_list() => {
                    let sentence = format!("[[{}]]: only in the text of a scene", section.name());
                    self.faults.add(&span, sentence);
                }
                Some(section) => {
                    self.settings
                        .retain(|earlier| (earlier.section, earlier.name.as_str()) != (section, name));
                    let (name, text) = (name.to_owned(), (*text).to_owned());
                    let value = Value::of_setting(&text);
                    self.settings.push(Setting { section, name, text, value, span });
                }
                None => {
                    let names = Section::ALL.into_iter().map(Section::name);
                    self.faults.add(&span, unknown("section", section, nearest(section, names)));
                }
            }
        }
    }

    /// Whether there are keys of the names that are set.
    pub fn check_settings(&mut self, section: Section) {
        let names =
            || table::of_section(section).flat_map(|(_, key)| [Some(key.name), key.si_name()]).flatten();
        for setting in self.settings.iter().filter(|setting| setting.section == section) {
            let name = setting.name.as_str();
            if !names().any(|known| known == name) {
                self.faults.add(&setting.span, unknown("key", name, nearest(name, names())));
            }
        }
    }
}
