//! The writer of scenes.

use super::FlightSource;
use super::Scene;
use super::draft::{Draft, FailureDraft, SinusoidDraft};
use super::key::{Key, Section, Target};
use super::list::meaning;
use super::table::of_section;
use super::value::written;
use crate::flight::ManoeuvreFields;
use crate::sensors::SensorOutput;

impl Scene {
    /// The scene in TOML with comments: what is not default. [`Scene::parse`] reads the same scene from it, to the bit.
    pub fn write(&self) -> String {
        let mut writer =
            Writer { text: String::new(), draft: Draft::from(self), default: Draft::from(&Self::default()) };
        for section in Section::ALL {
            match section {
                Section::Manoeuvre => writer.manoeuvres(&self.flight),
                Section::Failure => {
                    for planned in &self.failures {
                        writer.draft.failure = FailureDraft::from(planned);
                        let own = [planned.output];
                        writer.section(section, |key| own_failure_key(key, &own));
                    }
                }
                Section::Sinusoid => {}
                _ => writer.section(section, |_| true),
            }
        }
        writer.text
    }
}

/// A failure states its sensor, its axis and its kind, and of the keys of a quantity the one of its sensor.
fn own_failure_key(key: &Key, [output]: &[SensorOutput; 1]) -> bool {
    let sensor = match output {
        SensorOutput::Gyro(_) => 0,
        SensorOutput::Accelerometer(_) => 1,
        SensorOutput::Altimeter => 2,
    };
    super::table::of_sensor(key, sensor).is_none() && !(key.name == "axis" && sensor == 2)
}

struct Writer {
    text: String,
    draft: Draft,
    default: Draft,
}

impl Writer {
    fn manoeuvres(&mut self, flight: &FlightSource) {
        let FlightSource::Path(path) = flight else { return };
        for manoeuvre in &path.manoeuvres {
            self.draft.manoeuvre = ManoeuvreFields::from(manoeuvre);
            self.section(Section::Manoeuvre, |_| true);
            let ManoeuvreFields { sinusoids, sinusoid_count, .. } = self.draft.manoeuvre;
            for sinusoid in &sinusoids[..sinusoid_count] {
                self.draft.sinusoid = SinusoidDraft::from(sinusoid);
                self.section(Section::Sinusoid, |_| true);
            }
        }
    }

    /// A section with those of its keys that are not default, if there is one; items of a list always, with what they are.
    fn section(&mut self, section: Section, wants: impl Fn(&Key) -> bool) {
        let mut lines = String::new();
        for (_, key) in of_section(section) {
            let is_always = section.is_list() && ["kind", "channel", "sensor", "axis"].contains(&key.name);
            if !wants(key) || (!is_always && self.is_default(key)) {
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
                let bits =
                    |draft| place.of(draft).into_iter().map(|number| number.to_bits()).collect::<Vec<_>>();
                bits(&mut self.draft) == bits(&mut self.default)
            }
            Target::Choice { get, .. } => get(&self.draft) == get(&self.default),
            Target::Count { get, .. } => get(&self.draft) == get(&self.default),
            Target::Text { place, .. } => place(&mut self.draft) == place(&mut self.default),
            Target::Flag { get, .. } => get(&self.draft) == get(&self.default),
        }
    }
}
