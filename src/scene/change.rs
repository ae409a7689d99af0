//! Changes of a scene key by key, each checked as a text with these values would be.

use toml::de::DeTable;

use super::fault::Faults;
use super::key::Section;
use super::{FlightPath, FlightSource, Scene};
use crate::base::text::Fault;
use crate::base::text::too_deep;
use crate::sensors::{InitialErrorParameters, TriadParameters};
use crate::truth::flight::FlightStart;

/// The lists whose items can be set.
const LISTS: [Section; 4] = [Section::Manoeuvre, Section::Failure, Section::Update, Section::Panel];

/// Largest number of values that are set at once: each is compared with each.
const MAX_SETTINGS: usize = 4096;

impl Scene {
    /// Sets values, as [`Self::parse_with`] takes them, all at once. On faults the scene stays what it was. A preset replaces all errors
    /// of its sensors or of the start; a log or a built-in flight replaces the flight.
    pub fn set(&mut self, settings: &[(&str, &str)]) -> Result<(), Vec<Fault>> {
        if settings.len() > MAX_SETTINGS {
            let sentence = format!("{} values: at most {MAX_SETTINGS} are set at once", settings.len());
            return Err(vec![Fault { sentence, ..Fault::default() }]);
        }
        let mut base = self.clone();
        for (path, value) in settings {
            match *path {
                "flight.file" if !value.is_empty() => {
                    base.flight = FlightSource::Log(String::new());
                    base.rate_hz = Self::default().rate_hz;
                }
                "flight.builtin" if !value.is_empty() => base.flight = FlightSource::Builtin(String::new()),
                "gyro.preset" => base.errors.gyro = TriadParameters::default(),
                "accelerometer.preset" => base.errors.accel = TriadParameters::default(),
                "start.preset" => base.errors.initial = InitialErrorParameters::default(),
                _ => {}
            }
        }
        let of_text = |fault: &mut Fault| {
            if fault.line > 0 {
                (fault.line, fault.column) = (0, 0);
            }
        };
        *self = Self::parse_with(base.write().as_bytes(), settings).map_err(|mut faults| {
            faults.iter_mut().for_each(of_text);
            faults
        })?;
        Ok(())
    }

    /// Puts the items of `text` in the place of all items of a list, "manoeuvre", "failure", "update" or "panel". They are written as in
    /// the text of a scene; lines of faults are those of `text`. On faults the scene stays what it was. Manoeuvres replace a log or a
    /// built-in flight.
    pub fn set_items(&mut self, list: &str, text: &str) -> Result<(), Vec<Fault>> {
        let Some(section) = LISTS.into_iter().find(|section| section.name() == list) else {
            let sentence = "expected manoeuvre, failure, update or panel".to_owned();
            return Err(vec![Fault { sentence, ..Fault::default() }]);
        };
        let mut base = self.clone();
        match section {
            Section::Failure => base.failures.clear(),
            Section::Update => base.updates.clear(),
            Section::Panel => base.panel.clear(),
            _ => {
                let start = FlightStart { ellipsoid: base.options.ellipsoid, ..FlightStart::default() };
                let path = base.path().unwrap_or(FlightPath { start, manoeuvres: Vec::new(), repeat: 1 });
                base.flight = FlightSource::Path(FlightPath { manoeuvres: Vec::new(), ..path });
            }
        }
        let mut faults = Faults::new(text);
        if too_deep(text).is_none()
            && let (items, errors) = DeTable::parse_recoverable(text)
            && errors.is_empty()
        {
            for (name, _) in items.get_ref().iter().filter(|(name, _)| name.get_ref() != list) {
                faults.add(&name.span(), format!("expected only [[{list}]]"));
            }
        }
        if !faults.is_empty() {
            return Err(faults.into_list());
        }
        let own = base.write();
        let before = own.matches('\n').count();
        *self = Self::parse(format!("{own}{text}\n").as_bytes()).map_err(|mut faults| {
            for fault in &mut faults {
                match fault.line.checked_sub(before) {
                    Some(line) if line > 0 => fault.line = line,
                    _ => (fault.line, fault.column) = (0, 0),
                }
            }
            faults
        })?;
        Ok(())
    }
}
