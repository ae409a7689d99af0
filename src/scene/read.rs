//! The reader of scenes: every section, item and key of a text, and every fault at its place.

use core::ops::Range;

use toml::de::{DeTable, DeValue};
use toml_parser::Source;
use toml_parser::lexer::TokenKind;

use super::draft::{Draft, FAILURE_KINDS, FailureDraft, SinusoidDraft};
use super::fault::{Fault, Faults, excerpt, nearest};
use super::key::{Key, Section, Target};
use super::setting::Setting;
use super::table::{self, KEYS};
use super::value::{Value, put};
use super::{MAX_TEXT, Scene};
use crate::flight::{Channel, MANOEUVRE_KINDS, MAX_MANOEUVRES, MAX_SINUSOIDS, Manoeuvre, ManoeuvreFields};

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

/// Brackets that may be open at once: the parser takes a kilobyte of stack for each. A scene needs two.
const MAX_NESTING: usize = 8;

/// Where a text nests deeper than that [bytes].
pub(super) fn too_deep(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    for token in Source::new(text).lex() {
        match token.kind() {
            TokenKind::LeftSquareBracket | TokenKind::LeftCurlyBracket => depth += 1,
            TokenKind::RightSquareBracket | TokenKind::RightCurlyBracket => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth > MAX_NESTING {
            return Some(token.span().start());
        }
    }
    None
}

impl Scene {
    /// The scene of a text in TOML (UTF-8), or all faults of the text.
    pub fn parse(text: &[u8]) -> Result<Self, Vec<Fault>> {
        Self::parse_with(text, &[])
    }

    /// The scene of a text, with these values in the place of those that the text gives the same keys: `("gyro.bias_deg_h",
    /// "0.01")`. A value is written as in the text, but a string needs no quotes. If a key is set twice, the last value counts. Keys
    /// of sections in double brackets cannot be set in this way.
    pub fn parse_with(text: &[u8], settings: &[(&str, &str)]) -> Result<Self, Vec<Fault>> {
        let whole = |sentence: String| vec![Fault { line: 1, column: 1, sentence }];
        if text.len() > MAX_TEXT {
            return Err(whole(format!("{} bytes: a scene has at most {MAX_TEXT}", text.len())));
        }
        let text = core::str::from_utf8(text).map_err(|error| {
            let before = &text[..error.valid_up_to()];
            let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
            vec![Fault { line, column: 1, sentence: "not UTF-8".to_owned() }]
        })?;
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        if let Some(at) = too_deep(text) {
            let mut faults = Faults::new(text);
            faults.add(
                &(at..at),
                format!("more than {MAX_NESTING} brackets within each other: no scene needs that"),
            );
            return Err(faults.into_list());
        }
        let (root, errors) = DeTable::parse_recoverable(text);
        let mut reader = Reader {
            faults: Faults::new(text),
            draft: Draft::from(&Self::default()),
            sections: Section::ALL.map(|_| Item::default()),
            manoeuvres: Vec::new(),
            items: Vec::new(),
            settings: Vec::new(),
        };
        reader.take_settings(settings);
        for error in &errors {
            reader.faults.add(&error.span().unwrap_or(0..0), error.message());
        }
        if errors.is_empty() {
            reader.read_root(root.get_ref());
            reader.check_together();
            reader.check_values();
        }
        reader.into_scene()
    }
}

pub(super) struct Reader<'t> {
    pub faults: Faults<'t>,
    pub draft: Draft,
    sections: [Item; Section::ALL.len()],
    pub manoeuvres: Vec<Manoeuvre>,
    /// Where each manoeuvre stands.
    pub items: Vec<Item>,
    pub settings: Vec<Setting>,
}

impl Reader<'_> {
    pub fn section(&self, section: Section) -> &Item {
        &self.sections[section as usize]
    }

    fn read_root(&mut self, root: &DeTable<'_>) {
        for section in Section::ALL {
            let is_set = self.settings.iter().any(|setting| setting.section == section);
            if is_set && !root.contains_key(section.name()) {
                self.sections[section as usize] = self.read_keys(section, 0..0, &DeTable::new());
            }
        }
        for (name, value) in root {
            if self.faults.are_many() {
                return;
            }
            let (name, span) = (name.get_ref().as_ref(), name.span());
            let section = Section::ALL.into_iter().find(|section| section.name() == name);
            match (section, value.get_ref()) {
                (Some(section), DeValue::Table(section_table)) if !section.is_list() => {
                    let item = self.read_keys(section, span, section_table);
                    self.sections[section as usize] = item;
                }
                (Some(section), DeValue::Array(array)) if section.is_list() => {
                    for element in array.iter() {
                        if self.faults.are_many() {
                            return;
                        }
                        let head = element.span();
                        match element.get_ref() {
                            DeValue::Table(item) if section == Section::Manoeuvre => {
                                self.read_manoeuvre(head, item);
                            }
                            DeValue::Table(item) => self.read_failure(head, item),
                            _ => self.faults.add(&head, format!("expected [[{name}]]")),
                        }
                    }
                }
                (Some(section), _) if section.is_list() => {
                    self.faults.add(&span, format!("{name}: expected [[{name}]], in double brackets"));
                }
                (Some(_), _) => self.faults.add(&span, format!("{name}: expected [{name}], in brackets")),
                (None, DeValue::Table(_) | DeValue::Array(_)) => {
                    let names = Section::ALL.into_iter().map(Section::name);
                    self.faults.add(&span, unknown("section", name, nearest(name, names)));
                }
                (None, _) => {
                    let sentence = format!("{}: expected a [section] before it", excerpt(name));
                    self.faults.add(&span, sentence);
                }
            }
        }
    }

    /// Reads the keys of a section in the order of the table, so that a preset comes before the keys that change it.
    fn read_keys(&mut self, section: Section, head: Span, section_table: &DeTable<'_>) -> Item {
        let mut item = Item { head, keys: Vec::new() };
        self.check_settings(section);
        for (index, key) in table::of_section(section) {
            let is_of_key = |setting: &&Setting| {
                setting.section == section
                    && (setting.name == key.name || Some(setting.name.as_str()) == key.si_name())
            };
            // The last of them, because the same quantity may be set in its unit and in SI.
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
            let names =
                || table::of_section(section).flat_map(|(_, key)| [Some(key.name), key.si_name()]).flatten();
            if is_sinusoids && !matches!(value.get_ref(), DeValue::Array(_)) {
                self.faults.add(&span, "sinusoid: expected [[manoeuvre.sinusoid]], in double brackets");
            } else if !is_sinusoids && !names().any(|known| known == name) {
                self.faults.add(&span, unknown("key", name, nearest(name, names())));
            }
        }
        item
    }

    fn read_manoeuvre(&mut self, head: Span, section_table: &DeTable<'_>) {
        self.draft.manoeuvre = ManoeuvreFields::default();
        let item = self.read_keys(Section::Manoeuvre, head.clone(), section_table);
        if let Some(DeValue::Array(sinusoids)) = section_table.get("sinusoid").map(|value| value.get_ref()) {
            for sinusoid in sinusoids.iter() {
                match sinusoid.get_ref() {
                    DeValue::Table(item) => self.read_sinusoid(sinusoid.span(), item),
                    _ => self.faults.add(&sinusoid.span(), "expected [[manoeuvre.sinusoid]]"),
                }
            }
        }
        let (kind, uses) = MANOEUVRE_KINDS[self.draft.manoeuvre.kind];
        if item.key("kind").is_none() {
            self.faults.add(&head, "[[manoeuvre]]: expected its kind");
        } else {
            for (index, span) in &item.keys {
                let Key { name, .. } = KEYS[*index];
                if name != "kind" && !uses.contains(&KEYS[*index].field()) {
                    self.faults.add(span, format!("manoeuvre.{name}: {kind} does not use it"));
                }
            }
            if kind != "sinusoids" && self.draft.manoeuvre.sinusoid_count > 0 {
                self.faults.add(&head, format!("[[manoeuvre.sinusoid]]: {kind} has none"));
            }
        }
        if self.items.len() == MAX_MANOEUVRES {
            self.faults.add(&head, format!("[[manoeuvre]]: more than {MAX_MANOEUVRES}"));
            return;
        }
        self.manoeuvres.push(self.draft.manoeuvre.to_manoeuvre());
        self.items.push(item);
    }

    fn read_sinusoid(&mut self, head: Span, section_table: &DeTable<'_>) {
        self.draft.sinusoid = SinusoidDraft::default();
        let item = self.read_keys(Section::Sinusoid, head.clone(), section_table);
        let is_speed = self.draft.sinusoid.channel == Channel::Speed;
        let (own, other) =
            if is_speed { ("amplitude_m_s", "amplitude_deg") } else { ("amplitude_deg", "amplitude_m_s") };
        if item.key("channel").is_none() {
            self.faults.add(&head, "[[manoeuvre.sinusoid]]: expected its channel");
        } else if let Some(span) = item.key(other) {
            self.faults.add(span, format!("sinusoid.{other}: not for this channel; expected {own}"));
        }
        let manoeuvre = &mut self.draft.manoeuvre;
        let Some(place) = manoeuvre.sinusoids.get_mut(manoeuvre.sinusoid_count) else {
            self.faults
                .add(&head, format!("[[manoeuvre.sinusoid]]: more than {MAX_SINUSOIDS} in a manoeuvre"));
            return;
        };
        *place = self.draft.sinusoid.to_sinusoid();
        manoeuvre.sinusoid_count += 1;
    }

    fn read_failure(&mut self, head: Span, section_table: &DeTable<'_>) {
        self.draft.failure = FailureDraft::default();
        let item = self.read_keys(Section::Failure, head.clone(), section_table);
        for name in ["sensor", "kind"] {
            if item.key(name).is_none() {
                self.faults.add(&head, format!("[[failure]]: expected its {name}"));
                return;
            }
        }
        let failure = self.draft.failure.clone();
        match (failure.sensor == 2, item.key("axis")) {
            (true, Some(span)) => self.faults.add(span, "failure.axis: the altimeter has only one output"),
            (false, None) => self.faults.add(&head, "[[failure]]: expected its axis"),
            _ => {}
        }
        let (kind, uses) = FAILURE_KINDS[failure.kind];
        for (index, span) in &item.keys {
            let (name, field) = (KEYS[*index].name, KEYS[*index].field());
            let is_quantity =
                |quantity: &&str| field.strip_prefix("failure.").is_some_and(|f| f.starts_with(*quantity));
            let is_general = ["sensor", "axis", "kind", "from_s", "until_s"].contains(&name);
            if !is_general && !uses.iter().any(is_quantity) {
                self.faults.add(span, format!("failure.{name}: {kind} does not use it"));
            } else if let Some(own) = table::of_sensor(&KEYS[*index], failure.sensor) {
                self.faults.add(span, format!("failure.{name}: not for this sensor; expected {own}"));
            }
        }
        if let (Some(_), Some(span)) = (item.key("interval_s"), item.key("probability")) {
            self.faults.add(span, "failure.probability: only for drop-outs without interval_s");
        }
        match failure.to_planned() {
            Ok(Some(planned)) => {
                if let Err(error) = self.draft.scene.add_failure(planned) {
                    self.faults.add(&head, error.to_string());
                }
            }
            Ok(None) => {}
            Err(error) => self.add_error(&error, &item),
        }
    }
}

pub(super) fn unknown(what: &str, name: &str, near: Option<&str>) -> String {
    let near = near.map_or(String::new(), |near| format!("; {near}?"));
    format!("no such {what}: {}{near}", excerpt(name))
}
