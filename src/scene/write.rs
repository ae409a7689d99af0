//! The writer of scenes.

use super::draft::{Draft, update_draft};
use super::key::{Key, Section, Target};
use super::list::meaning;
use super::site::{Site, ValuePath};
use super::table::of_section;
use super::written::{divided, shown, written};
use super::{FlightSource, Scene};
use crate::sensors::FailureFields;
use crate::truth::flight::ManoeuvreFields;

impl Scene {
    /// The scene in TOML with comments: all values that are not the default. [`Scene::parse`] reads the same scene from it, to the bit.
    pub fn write(&self) -> String {
        let mut writer = Writer::new(self);
        for section in Section::ALL {
            match section {
                Section::Sinusoid => {}
                _ if section.is_list() => {
                    (0..).take_while(|index| writer.item(self, section, *index).is_some()).count();
                }
                _ => writer.section(section),
            }
        }
        writer.text
    }
}

/// A key that is not at its default, as a reader sees it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ChangedKey {
    /// Section: "gyro".
    pub section: &'static str,
    /// Name of the key: "bias_deg_h".
    pub name: &'static str,
    /// Its value in TOML; a number that has no equal in the unit is the nearest.
    pub value: String,
    /// Its unit; empty: none.
    pub unit: &'static str,
    /// What it means.
    pub doc: &'static str,
}

impl Scene {
    /// The keys of all sections in single brackets that are not at their default, in the order of [`keys`](super::keys).
    pub fn changed_keys(&self) -> Vec<ChangedKey> {
        let mut writer = Writer::new(self);
        let mut set = Vec::new();
        for section in Section::ALL.into_iter().filter(|section| !section.is_list()) {
            for (_, key) in of_section(section) {
                if writer.is_default(key) {
                    continue;
                }
                let value = shown(&mut writer.draft, key, false, None);
                let unit = if let Target::Numbers { unit, .. } = key.target { unit.text } else { "" };
                set.push(ChangedKey { section: section.name(), name: key.name, value, unit, doc: key.doc });
            }
        }
        set
    }

    /// The value at a path: `"options.scheme"`, `"gyro.bias_deg_h[1]"`, `"manoeuvre[3].bank_deg"`, `"failure[0].sensor"`, default or
    /// not. It is written as in the text of a scene; a value that the scene does not have is empty. `"manoeuvre[3]"`,
    /// `"failure[0]"`, `"update[0]"` and `"panel[0]"` are all lines of an item. `None`: there is no such value.
    pub fn value(&self, path: &str) -> Option<String> {
        match Site::read(path) {
            Ok(Site { section, item: [index, _] }) if section.lists() == 1 => {
                let mut writer = Writer::new(self);
                writer.item(self, section, index)?;
                Some(writer.text)
            }
            _ => {
                let path = ValuePath::read(path).ok()?;
                let mut draft = self.draft_of(path.site)?;
                let is_there = self.has(&draft, path.key());
                Some(if is_there {
                    shown(&mut draft, path.key(), path.in_si, path.element)
                } else {
                    String::new()
                })
            }
        }
    }

    /// Whether the scene, or its item in `draft`, has the value of a key: a text may set it.
    fn has(&self, draft: &Draft, key: &Key) -> bool {
        match key.section {
            Section::Flight if key.is_of_manoeuvres() => matches!(self.flight, FlightSource::Path(_)),
            Section::Flight if key.name == "temperature_change_c_h" => !draft.temperature_c.is_nan(),
            Section::Flight if key.name == "rate_hz" => !self.is_log(),
            Section::Options if key.name == "closed_loop_time_s" => draft.closed_loop,
            Section::Failure if FailureFields::KINDS[draft.failure.fields.kind].0 == "drop_outs" => {
                let is_random = draft.failure.fields.interval_s == 0.0;
                key.is_used(draft) && key.name != if is_random { "interval_s" } else { "probability" }
            }
            _ => key.is_used(draft),
        }
    }

    /// The numbers of such a key in its unit, matrices row by row; `None`: no such key, or one of another kind.
    pub fn numbers(&self, path: &str) -> Option<Vec<f64>> {
        let path = ValuePath::read(path).ok()?;
        let Target::Numbers { place, unit, .. } = path.key().target else { return None };
        let in_unit = |number: &mut f64| divided(*number, unit.si).unwrap_or(*number / unit.si);
        Some(place.of(&mut self.draft_of(path.site)?).map(in_unit).collect())
    }

    /// A draft with the item at `site`, if that is one of a list.
    fn draft_of(&self, site: Site) -> Option<Draft> {
        let mut draft = Draft::from(self);
        self.load(&mut draft, site)?;
        Some(draft)
    }

    /// Puts the item at a site of a list into `draft`; `None`: there is no such item.
    fn load(&self, draft: &mut Draft, Site { section, item: [index, inner] }: Site) -> Option<()> {
        match section {
            Section::Manoeuvre => draft.manoeuvre = self.manoeuvres().get(index)?.into(),
            Section::Sinusoid => {
                let manoeuvre = ManoeuvreFields::from(self.manoeuvres().get(index)?);
                draft.sinusoid = *manoeuvre.sinusoids.terms().get(inner)?;
            }
            Section::Failure => draft.failure = self.failures.get(index)?.into(),
            Section::Update => draft.update = update_draft(self.updates.get(index)?),
            Section::Panel => draft.action = *self.panel.get(index)?,
            _ => {}
        }
        Some(())
    }
}

struct Writer {
    text: String,
    draft: Draft,
    default: Draft,
}

impl Writer {
    fn new(scene: &Scene) -> Self {
        let default = Draft::from(&Scene::default());
        Self { text: String::new(), draft: Draft::from(scene), default }
    }

    /// Writes an item of a list, a manoeuvre with its sinusoids; `None`: there is no such item.
    fn item(&mut self, scene: &Scene, section: Section, index: usize) -> Option<()> {
        scene.load(&mut self.draft, Site { section, item: [index, 0] })?;
        self.section(section);
        let sinusoids = self.draft.manoeuvre.sinusoids;
        for sinusoid in sinusoids.terms().iter().filter(|_| section == Section::Manoeuvre) {
            self.draft.sinusoid = *sinusoid;
            self.section(Section::Sinusoid);
        }
        Some(())
    }

    /// Writes a section with its keys that are not at their default, if there are any. Items of a list are always written, with what
    /// they require.
    fn section(&mut self, section: Section) {
        let mut lines = String::new();
        for (_, key) in of_section(section) {
            let is_always = key.is_required(&self.draft);
            if !key.is_used(&self.draft) || (!is_always && self.is_default(key)) {
                continue;
            }
            let (value, in_si) = written(&mut self.draft, key);
            let name = key.si_name().filter(|_| in_si).unwrap_or(key.name);
            lines.push_str(&format!("{name} = {value}  # {}\n", meaning(key, in_si)));
        }
        if lines.is_empty() && !section.is_list() {
            return;
        }
        if !self.text.is_empty() {
            self.text.push('\n');
        }
        let name = section.name();
        let head = if section.is_list() {
            format!("[[{name}]]\n")
        } else {
            format!("# {}\n[{name}]\n", section.doc())
        };
        self.text.push_str(&head);
        self.text.push_str(&lines);
    }

    fn is_default(&mut self, key: &Key) -> bool {
        match key.target {
            Target::Numbers { place, .. } => {
                let bits = |number: &mut f64| number.to_bits();
                place.of(&mut self.draft).map(bits).eq(place.of(&mut self.default).map(bits))
            }
            Target::Choice { get, .. } => get(&self.draft) == get(&self.default),
            Target::Count { get, .. } => get(&self.draft) == get(&self.default),
            Target::Text { place, .. } => place(&mut self.draft) == place(&mut self.default),
            Target::Flag { get, .. } => get(&self.draft) == get(&self.default),
            Target::Column(quantity) => {
                let [own, default] =
                    [&self.draft, &self.default].map(|draft| &draft.columns(key.section)[quantity]);
                own == default
            }
        }
    }
}
