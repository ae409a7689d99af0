//! The keys of a section, into a draft.

use core::ops::Range;

use toml::de::{DeTable, DeValue};

use super::draft::Draft;
use super::fault::Faults;
use super::key::{Key, Section};
use super::setting::Setting;
use super::site::Site;
use super::table::{self, KEYS, names_of};
use super::value::{Value, put, put_back, put_element};
use crate::base::text::About;
use crate::base::text::{nearest, unknown};
use crate::truth::flight::Manoeuvre;

type Span = Range<usize>;

/// A section, or an item of a list: where its head stands, and where those of its keys that the text sets, by their
/// place in the table.
#[derive(Debug, Clone)]
pub(super) struct Item {
    pub site: Site,
    pub head: Span,
    pub keys: Vec<(usize, Span)>,
    /// The keys whose values were not taken, so that the draft has a default in their place.
    pub rejected: Vec<usize>,
    /// Whether its kind is missing or unknown.
    pub is_of_no_kind: bool,
}

impl Item {
    /// One without keys.
    pub fn empty(site: Site, head: Span) -> Self {
        Self { site, head, keys: Vec::new(), rejected: Vec::new(), is_of_no_kind: false }
    }

    /// Where it begins: its head, or its first key if settings alone make it.
    pub fn begin(&self) -> &Span {
        self.keys.first().map(|(_, span)| span).filter(|_| self.head.is_empty()).unwrap_or(&self.head)
    }

    /// Where the key of `name` stands.
    pub fn key(&self, name: &str) -> Option<&Span> {
        self.keys.iter().find(|(index, _)| KEYS[*index].name == name).map(|(_, span)| span)
    }

    /// Whether the value of the key of `name` was not taken.
    pub fn lacks(&self, name: &str) -> bool {
        self.rejected.iter().any(|index| KEYS[*index].name == name)
    }

    /// The key of a field that an error names, and where the text sets it; else the head of the item.
    pub fn of_field(&self, field: &str) -> Option<(usize, &Span)> {
        let sets = |key: &Key| field.contains('.') && (key.field().starts_with(field) || key.path() == field);
        let set = self.keys.iter().find(|(index, _)| sets(&KEYS[*index])).map(|(index, span)| (*index, span));
        set.or_else(|| {
            let (index, _) = table::of_section(self.site.section).find(|(_, key)| sets(key))?;
            Some((index, self.begin()))
        })
    }
}

/// What has been read of a text, and what is wrong with it.
pub(super) struct Reader<'t> {
    pub faults: Faults<'t>,
    /// On the heap: a scene can have the flight of another one, which is read within its own reading.
    pub draft: Box<Draft>,
    /// Those in single brackets and the heads of lists, on the heap for the same reason.
    pub sections: Vec<Item>,
    pub manoeuvres: Vec<Manoeuvre>,
    /// Where each manoeuvre stands.
    pub items: Vec<Item>,
    /// The item of a list that is being read: its place in the list, of a sinusoid that of its manoeuvre first.
    pub place: [usize; 2],
    pub settings: Vec<Setting>,
}

impl Reader<'_> {
    pub fn section(&self, section: Section) -> &Item {
        &self.sections[section as usize]
    }

    /// Reads the keys of a section in the order of the table, so that a preset comes before the keys that change it.
    pub fn read_keys(&mut self, section: Section, head: Span, section_table: &DeTable<'_>) -> Item {
        let site = Site { section, item: self.place };
        self.faults.name(&head, site, None);
        let mut item = Item::empty(site, head);
        for (index, key) in table::of_section(section) {
            let settings = self.settings.iter_mut().filter(|setting| setting.is_of(site, index));
            let mut settings: Vec<&mut Setting> = settings.collect();
            settings.iter_mut().for_each(|setting| setting.is_used = true);
            // The last that sets the whole key, because the same quantity may be set in its unit and in SI.
            let whole = settings.iter().rposition(|setting| setting.path.element.is_none());
            let mut first: Option<&str> = None;
            for (name, in_si) in [(Some(key.name), false), (key.si_name(), true)] {
                let found =
                    name.and_then(|name| section_table.get_key_value(name).map(|found| (name, found)));
                let Some((name, (at, value))) = found.filter(|_| whole.is_none()) else { continue };
                if let Some(first) = first {
                    self.faults.add(&at.span(), format!("{name}: the same quantity as {first}; give one"));
                    continue;
                }
                first = Some(name);
                item.keys.push((index, at.span()));
                self.faults.name(&at.span(), site, Some(index));
                self.faults.name(&value.span(), site, Some(index));
                if let Err(sentence) = put(&mut self.draft, key, in_si, &Value::of(value.get_ref())) {
                    item.rejected.push(index);
                    self.faults.add(&value.span(), sentence);
                }
            }
            for setting in &settings[whole.unwrap_or(0)..] {
                let (value, in_si) = (setting.value_for(key), setting.path.in_si);
                let put = match setting.path.element {
                    Some(element) => put_element(&mut self.draft, key, in_si, element, &value),
                    None if setting.is_default() => {
                        // The draft has the default, or what a preset has set.
                        if !section.is_list() {
                            put_back(&mut self.draft, key);
                        }
                        continue;
                    }
                    None => put(&mut self.draft, key, in_si, &value),
                };
                // A fault is one of the setting, not of the text that it changes.
                item.keys.retain(|(other, _)| *other != index);
                item.keys.push((index, setting.span.clone()));
                item.rejected.retain(|other| *other != index);
                if let Err(sentence) = put {
                    item.rejected.push(index);
                    let about = About { path: setting.path.to_string(), ..About::default() };
                    self.faults.add_about(&setting.span, sentence, about);
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

    /// Notes the settings of items that the text does not have.
    pub fn check_settings(&mut self) {
        for setting in self.settings.iter().filter(|setting| setting.path.site.section.is_list()) {
            if !setting.is_used {
                self.faults.add(&setting.span, format!("{}: the scene has no such item", setting.path.site));
            }
        }
    }
}
