//! Faults of the values of a text: values beyond limits, and settings that do not go together, each at its place.

use super::draft::Draft;
use super::key::{Section, Target};
use super::reader::{Item, Reader};
use super::site::ValuePath;
use super::table::KEYS;
use super::value::put_back;
use super::{BUILTIN_SCENES, FlightPath, FlightSource, Scene};
use crate::base::error::{Error, ErrorKind, Value};
use crate::base::text::{About, Fault};
use crate::base::text::{excerpt, nearest};

/// The sentence of the fault of a text that has no flight.
pub const NO_FLIGHT: &str = "[flight]: expected a flight: file, builtin or [[manoeuvre]]s";

impl Reader<'_> {
    /// Checks whether the keys go together.
    pub(super) fn check_together(&mut self) {
        let flight = self.section(Section::Flight).clone();
        let sources = [flight.key("file").is_some(), flight.key("builtin").is_some(), !self.items.is_empty()];
        let head = if flight.keys.is_empty() { &(0..0) } else { &flight.head };
        match sources.iter().filter(|is_there| **is_there).count() {
            0 => self.faults.add(head, NO_FLIGHT),
            1 => {}
            _ => self.faults.add(head, "[flight]: expected only one of file, builtin and [[manoeuvre]]s"),
        }
        if let Some(span) = flight.key("builtin")
            && !BUILTIN_SCENES.iter().any(|(name, _)| *name == self.draft.builtin)
        {
            let names = || BUILTIN_SCENES.iter().map(|(name, _)| *name);
            let near = nearest(&self.draft.builtin, names());
            let listed =
                near.map_or(names().collect::<Vec<_>>().join(", "), |near| format!("did you mean {near}?"));
            let sentence =
                format!("flight.builtin = \"{}\": no such flight; {listed}", excerpt(&self.draft.builtin));
            self.faults.add(span, sentence);
        }
        if !sources[2] {
            for (index, span) in &flight.keys {
                let key = &KEYS[*index];
                if key.is_of_manoeuvres() {
                    self.faults.add(
                        span,
                        format!("{}: only with [[manoeuvre]]s; this flight has its own start", key.path()),
                    );
                }
            }
        }
        if flight.key("temperature_c").is_none()
            && let Some(span) = flight.key("temperature_change_c_h")
        {
            self.faults.add(span, "flight.temperature_change_c_h: only together with temperature_c");
        }
        if let Some(span) = self.section(Section::Options).key("closed_loop_time_s").cloned()
            && !self.draft.closed_loop
        {
            self.faults.add(&span, "options.closed_loop_time_s: only with signal = \"closed-loop\"");
        }
    }

    /// Checks the limits of the library, one fault after the other: a rejected value is set back to its default, and the rest is
    /// checked again.
    pub(super) fn check_values(&mut self) {
        for section in Section::ALL {
            let item = self.section(section).clone();
            while let Err(error) = self.draft.validate(section) {
                self.add_error(&error, &item);
                let Some((index, _)) = item.of_field(error.field) else { break };
                self.sections[section as usize].rejected.push(index);
                if self.faults.are_many() || !put_back(&mut self.draft, &KEYS[index]) {
                    break;
                }
            }
        }
    }

    /// The section that the field of an error belongs to.
    fn item_of(&self, error: &Error) -> Item {
        let name = error.field.split('.').next();
        let section = Section::ALL.into_iter().find(|section| Some(section.name()) == name);
        self.section(section.unwrap_or(Section::Flight)).clone()
    }

    /// Settings that do not go together, each reported at the key that would have to change, or else at its section.
    fn check_conflicts(&mut self, scene: &Scene) {
        for error in scene.conflicts() {
            let item = self.item_of(&error);
            self.add_error(&error, &item);
        }
    }

    /// Notes an error of the library at the key that set the field.
    pub(super) fn add_error(&mut self, error: &Error, item: &Item) {
        self.add_error_with(error, item, "");
    }

    /// The same with the reason for the limit.
    fn add_error_with(&mut self, error: &Error, item: &Item, why: &str) {
        let Some((index, span)) = item.of_field(error.field) else {
            let lacks_memory = error.kind == ErrorKind::OutOfMemory;
            let about = About { path: item.site.to_string(), lacks_memory, ..About::default() };
            return self.faults.add_about(item.begin(), format!("{error}{why}"), about);
        };
        let (key, element) = (&KEYS[index], error.index);
        let count = if let Target::Numbers { shape, .. } = key.target { shape.count() } else { 1 };
        let path =
            ValuePath { site: item.site, key: index, in_si: false, element: element.filter(|_| count > 1) };
        let error =
            if let Target::Numbers { unit, .. } = key.target { error.in_unit(unit.si) } else { *error };
        let (minimum, maximum) = error.rule.limits();
        // A value in SI may be beyond all numbers in a small unit.
        let value = error.value.map(Value::as_f64).filter(|value| value.is_finite());
        let about = About { path: path.to_string(), value, minimum, maximum, lacks_memory: false };
        self.faults.add_about(span, key.sentence_of(&error) + why, about);
    }

    /// Checks each manoeuvre of the text at the speed with which it begins. Behind a manoeuvre with a fault the speed is not known, so the
    /// limits are the widest.
    fn check_manoeuvres(&mut self, scene: &Scene) {
        let FlightSource::Path(path) = &scene.flight else { return };
        let is_known = !self.section(Section::Flight).lacks("speed_m_s");
        let mut known_m_s = is_known.then_some(path.start.speed_m_s);
        for (item, manoeuvre) in self.items.clone().iter().zip(&path.manoeuvres) {
            if item.is_of_no_kind || !item.rejected.is_empty() {
                known_m_s = None;
                continue;
            }
            let speed_m_s = known_m_s.unwrap_or_else(|| manoeuvre.widest_speed_m_s());
            match manoeuvre.validate(speed_m_s) {
                Ok(()) => known_m_s = known_m_s.map(|speed_m_s| manoeuvre.speed_after(speed_m_s)),
                Err(error) => {
                    known_m_s = known_m_s.filter(|_| !manoeuvre.changes_speed());
                    let why =
                        manoeuvre.reason(&error, speed_m_s).map_or(String::new(), |why| format!(": {why}"));
                    self.add_error_with(&error, item, &why);
                }
            }
        }
        if self.faults.is_empty() {
            self.check_repeats(path, known_m_s);
        }
    }

    /// Checks the manoeuvres at the speeds of the times that they are flown again; the first time ends at `speed_m_s`.
    fn check_repeats(&mut self, path: &FlightPath, speed_m_s: Option<f64>) {
        let Some(mut speed_m_s) = speed_m_s else { return };
        for time in 2..=path.repeat {
            let begins_m_s = speed_m_s;
            for (place, manoeuvre) in path.manoeuvres.iter().enumerate() {
                if let (Err(error), Some(item)) =
                    (manoeuvre.validate(speed_m_s), self.items.get(place).cloned())
                {
                    let why =
                        manoeuvre.reason(&error, speed_m_s).map_or(String::new(), |why| format!(": {why}"));
                    return self.add_error_with(
                        &error,
                        &item,
                        &format!("{why} (time {time} of {})", path.repeat),
                    );
                }
                speed_m_s = manoeuvre.speed_after(speed_m_s);
            }
            if speed_m_s == begins_m_s {
                return;
            }
        }
    }

    /// Checks the flight, without integrating it.
    fn check_flight(&mut self, scene: &Scene) {
        if scene.is_log() {
            return;
        }
        if let Err(error) = scene.flown_s() {
            let item = match error.index.and_then(|index| self.items.get(index)) {
                Some(item) => item.clone(),
                None => self.section(Section::Flight).clone(),
            };
            self.add_error(&Error { index: None, ..error }, &item);
        }
    }

    /// What was read. Not inlined, as [`Draft::of_nothing`](super::draft::Draft::of_nothing).
    #[inline(never)]
    fn scene(&mut self) -> Box<Scene> {
        let manoeuvres = core::mem::take(&mut self.manoeuvres);
        Box::new(Draft::clone(&self.draft).into_scene(manoeuvres))
    }

    pub(super) fn into_scene(mut self) -> Result<Scene, Vec<Fault>> {
        let scene = self.scene();
        self.check_conflicts(&scene);
        self.check_manoeuvres(&scene);
        if self.faults.is_empty() {
            self.check_flight(&scene);
        }
        // This finds nothing if the checks above are complete: every scene that is read can be written.
        if self.faults.is_empty()
            && let Err(error) = scene.check()
        {
            let item = self.item_of(&error);
            self.add_error(&error, &item);
        }
        if self.faults.is_empty() { Ok(*scene) } else { Err(self.faults.into_list()) }
    }
}
