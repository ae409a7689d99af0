//! The reader of scenes: every section and item of a text, and every fault at its place.

use core::ops::Range;

use toml::de::{DeTable, DeValue};

use super::draft::{Draft, FailureDraft, NO_UPDATE, planned_update};
use super::fault::Faults;
use super::key::Section;
use super::reader::{Item, Reader};
use super::setting::take_settings;
use super::table::{self, KEYS};
use super::{MAX_TEXT, PlannedAction, Scene, Updated};
use crate::base::error::Error;
use crate::base::text::{About, Fault};
use crate::base::text::{MAX_NESTING, too_deep};
use crate::base::text::{excerpt, nearest, unknown};
use crate::log::foreign;
use crate::sensors::FailureFields;
use crate::truth::flight::{Channel, MAX_MANOEUVRES, MAX_SINUSOIDS, ManoeuvreFields, Sinusoid};

type Span = Range<usize>;

/// A text in UTF-8 of at most [`MAX_TEXT`] bytes, or its fault.
pub fn utf8(text: &[u8]) -> Result<&str, Vec<Fault>> {
    let at = |line, sentence| vec![Fault { line, column: 1, sentence, about: About::default() }];
    if text.len() > MAX_TEXT {
        return Err(at(1, format!("{} bytes: a text has at most {MAX_TEXT}", text.len())));
    }
    core::str::from_utf8(text).map_err(|error| {
        let before = &text[..error.valid_up_to()];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        at(line, "not UTF-8".to_owned())
    })
}

impl Scene {
    /// The scene of a text in TOML (UTF-8), or all faults of the text.
    pub fn parse(text: &[u8]) -> Result<Self, Vec<Fault>> {
        Self::parse_with(text, &[])
    }

    /// The scene of a text, with these values in the place of those that the text gives the same keys: `("gyro.bias_deg_h",
    /// "0.01")`, `("gyro.bias_deg_h[1]", "0.01")`, `("manoeuvre[3].bank_deg", "30")`. A value is written as in the text, but a string
    /// needs no quotes; an empty value is the default. If a key is set twice, the last value counts.
    pub fn parse_with(text: &[u8], settings: &[(&str, &str)]) -> Result<Self, Vec<Fault>> {
        let file = text;
        let is_foreign = || {
            let sentence = format!("is {}: expected a scene, a text in TOML", foreign(file)?);
            Some(vec![Fault { line: 1, column: 1, sentence, about: About::default() }])
        };
        let text = utf8(text).map_err(|faults| is_foreign().unwrap_or(faults))?;
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
        if let Some(faults) = (!errors.is_empty()).then(is_foreign).flatten() {
            return Err(faults);
        }
        let mut faults = Faults::new(text);
        let settings = take_settings(settings, &mut faults);
        let mut reader = Reader {
            faults,
            draft: Draft::of_nothing(),
            sections: Section::ALL.iter().map(|section| Item::empty((*section).into(), 0..0)).collect(),
            manoeuvres: Vec::new(),
            items: Vec::new(),
            place: [0; 2],
            settings,
        };
        for error in &errors {
            reader.faults.add(&error.span().unwrap_or(0..0), error.message());
        }
        if errors.is_empty() {
            reader.read_root(root.get_ref());
            reader.check_settings();
            reader.check_together();
            reader.check_values();
        }
        reader.into_scene()
    }
}

impl Reader<'_> {
    fn read_root(&mut self, root: &DeTable<'_>) {
        for section in Section::ALL {
            let is_set = self.settings.iter().any(|setting| setting.path.site == section.into());
            if is_set && !section.is_list() && !root.contains_key(section.name()) {
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
                    for (place, element) in array.iter().enumerate() {
                        if self.faults.are_many() {
                            return;
                        }
                        let head = element.span();
                        self.place = [place, 0];
                        if place == 0 {
                            self.sections[section as usize] = Item::empty(section.into(), head.clone());
                        }
                        match element.get_ref() {
                            DeValue::Table(item) if section == Section::Manoeuvre => {
                                self.read_manoeuvre(head, item);
                            }
                            DeValue::Table(item) if section == Section::Failure => {
                                self.read_failure(head, item);
                            }
                            DeValue::Table(item) if section == Section::Panel => {
                                self.read_action(head, item);
                            }
                            DeValue::Table(item) => self.read_update(head, item),
                            _ => self.faults.add(&head, format!("expected [[{name}]]")),
                        }
                    }
                    self.place = [0; 2];
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

    fn read_manoeuvre(&mut self, head: Span, section_table: &DeTable<'_>) {
        self.draft.manoeuvre = ManoeuvreFields::default();
        let mut item = self.read_keys(Section::Manoeuvre, head.clone(), section_table);
        if let Some(DeValue::Array(sinusoids)) = section_table.get("sinusoid").map(|value| value.get_ref()) {
            for (place, sinusoid) in sinusoids.iter().enumerate() {
                self.place[1] = place;
                match sinusoid.get_ref() {
                    DeValue::Table(item) => self.read_sinusoid(sinusoid.span(), item),
                    _ => self.faults.add(&sinusoid.span(), "expected [[manoeuvre.sinusoid]]"),
                }
            }
        }
        let (kind, _) = ManoeuvreFields::KINDS[self.draft.manoeuvre.kind];
        if self.has_all(&item) {
            for (index, span) in &item.keys {
                if !KEYS[*index].is_used(&self.draft) {
                    self.faults.add(span, format!("{}: {kind} does not use it", KEYS[*index].path()));
                }
            }
            if kind != "sinusoids" && !self.draft.manoeuvre.sinusoids.terms().is_empty() {
                self.faults.add(&head, format!("[[manoeuvre.sinusoid]]: {kind} has none"));
            }
        } else {
            item.is_of_no_kind = true;
        }
        if self.items.len() == MAX_MANOEUVRES {
            self.faults.add(&head, format!("[[manoeuvre]]: more than {MAX_MANOEUVRES}"));
            return;
        }
        self.manoeuvres.extend(self.draft.manoeuvre.kind());
        self.items.push(item);
    }

    fn read_sinusoid(&mut self, head: Span, section_table: &DeTable<'_>) {
        self.draft.sinusoid = Sinusoid::NONE;
        let item = self.read_keys(Section::Sinusoid, head.clone(), section_table);
        let is_speed = self.draft.sinusoid.channel == Channel::Speed;
        let (own, other) =
            if is_speed { ("amplitude_m_s", "amplitude_deg") } else { ("amplitude_deg", "amplitude_m_s") };
        if let (true, Some(span)) = (self.has_all(&item), item.key(other)) {
            self.faults.add(span, format!("sinusoid.{other}: not for this channel; expected {own}"));
            self.draft.sinusoid.amplitude = 0.0;
        }
        let sinusoid = self.draft.sinusoid;
        // That of the speed is checked with the flight.
        if let Err(error) = sinusoid.validate(f64::INFINITY) {
            let own = ["sinusoid.amplitude", "sinusoid.frequency_hz", "sinusoid.phase_rad"];
            let field = own.into_iter().find(|own| own.split('.').nth(1) == error.field.split('.').nth(1));
            self.add_error(&Error { field: field.unwrap_or(error.field), ..error }, &item);
        }
        if !self.draft.manoeuvre.sinusoids.push(sinusoid) {
            self.faults
                .add(&head, format!("[[manoeuvre.sinusoid]]: more than {MAX_SINUSOIDS} in a manoeuvre"));
        }
    }

    fn read_failure(&mut self, head: Span, section_table: &DeTable<'_>) {
        self.draft.failure = FailureDraft::default();
        let item = self.read_keys(Section::Failure, head.clone(), section_table);
        if !self.has_all(&item) {
            return;
        }
        let failure = self.draft.failure.clone();
        if let (2, Some(span)) = (failure.sensor, item.key("axis")) {
            self.faults.add(span, "failure.axis: the altimeter has only one output");
        }
        let (kind, _) = FailureFields::KINDS[failure.fields.kind];
        for (index, span) in &item.keys {
            let name = KEYS[*index].name;
            if !KEYS[*index].is_of_kind(&failure) {
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

    /// Whether the text sets all keys that the item in the draft requires; notes the first that it does not set. What an item of an unknown
    /// kind requires and uses is not known: it has one fault.
    fn has_all(&mut self, item: &Item) -> bool {
        if ["kind", "sensor", "channel"].iter().any(|name| item.lacks(name)) {
            return false;
        }
        let section = item.site.section;
        let missing = table::of_section(section)
            .map(|(_, key)| key)
            .find(|key| key.is_required(&self.draft) && item.key(key.name).is_none());
        if let Some(key) = missing {
            self.faults.add(&item.head, format!("[[{}]]: expected its {}", section.name(), key.name));
        }
        missing.is_none()
    }

    fn read_update(&mut self, head: Span, section_table: &DeTable<'_>) {
        self.draft.update = NO_UPDATE;
        let item = self.read_keys(Section::Update, head.clone(), section_table);
        if !self.has_all(&item) {
            return;
        }
        let is_of_velocity = self.draft.update.updated == Updated::Velocity;
        let (own, other) = if is_of_velocity { ("sigma_m_s", "sigma_m") } else { ("sigma_m", "sigma_m_s") };
        if let Some(span) = item.key(other) {
            self.faults.add(span, format!("update.{other}: not for this kind; expected {own}"));
            self.draft.update.sigma_n = NO_UPDATE.sigma_n;
        }
        match planned_update(&self.draft.update) {
            Ok(planned) => {
                if let Err(error) = self.draft.scene.add_update(planned) {
                    self.faults.add(&head, error.to_string());
                }
            }
            Err(error) => self.add_error(&error, &item),
        }
    }

    fn read_action(&mut self, head: Span, section_table: &DeTable<'_>) {
        self.draft.action = PlannedAction::default();
        let item = self.read_keys(Section::Panel, head.clone(), section_table);
        let planned = self.draft.action;
        if !self.has_all(&item) {
            return;
        }
        for (index, span) in item.keys.iter().filter(|(index, _)| !KEYS[*index].is_used(&self.draft)) {
            self.faults.add(span, format!("{}: not for this kind", KEYS[*index].path()));
        }
        match planned.validate().and_then(|()| self.draft.scene.add_action(planned)) {
            Ok(()) => {}
            Err(error) => self.add_error(&error, &item),
        }
    }
}
