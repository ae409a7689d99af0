//! Keys that are set beside the text of a scene.

use core::ops::Range;

use super::fault::{Faults, excerpt, nearest, unknown};
use super::key::Section;
use super::table::names_of;
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

/// The settings of keys and values, as `section.key` and the text of a value; notes what is wrong with a key.
pub(super) fn take_settings(settings: &[(&str, &str)], faults: &mut Faults<'_>) -> Vec<Setting> {
    let mut taken: Vec<Setting> = Vec::new();
    for (index, (path, text)) in settings.iter().enumerate() {
        let span = faults.setting_span(index);
        let Some((section, name)) = path.rsplit_once('.') else {
            faults.add(&span, format!("{}: expected section.key", excerpt(path)));
            continue;
        };
        match Section::ALL.into_iter().find(|known| known.name() == section) {
            Some(section) if section.is_list() => {
                faults.add(&span, format!("[[{}]]: only in the text of a scene", section.name()));
            }
            Some(section) => {
                taken.retain(|earlier| (earlier.section, earlier.name.as_str()) != (section, name));
                let (name, text) = (name.to_owned(), (*text).to_owned());
                let value = Value::of_setting(&text);
                taken.push(Setting { section, name, text, value, span });
            }
            None => {
                let names = Section::ALL.into_iter().map(Section::name);
                faults.add(&span, unknown("section", section, nearest(section, names)));
            }
        }
    }
    taken
}

/// Notes the settings of a section that name no key of it.
pub(super) fn check_settings(settings: &[Setting], section: Section, faults: &mut Faults<'_>) {
    for setting in settings.iter().filter(|setting| setting.section == section) {
        let name = setting.name.as_str();
        if !names_of(section).any(|known| known == name) {
            faults.add(&setting.span, unknown("key", name, nearest(name, names_of(section))));
        }
    }
}
