//! Checks of a whole scene: every part is within its limits, and the parts go together.

use super::draft::Draft;
use super::key::{Place, Section, Target};
use super::table::of_section;
use super::{Output, Scene};
use crate::base::error::{Error, Rule, check_range};
use crate::mechanization::VerticalMode;
use crate::sensors::{AltimeterParameters, Sensor, SensorOutput};

/// The error of a field that does not go together with another.
fn at_odds(field: &'static str, words: &'static str) -> Error {
    Error { value: None, ..Error::invalid(field, 0.0, Rule::Sentence(words)) }
}

impl Output {
    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        if self.name.contains(['/', '\\']) {
            return Err(at_odds("output.name", "must be a name without a folder; output.folder has that"));
        }
        Ok(())
    }
}

impl Draft {
    /// Checks each value of a section alone; an item of a list is checked as a whole.
    pub(super) fn validate(&self, section: Section) -> Result<(), Error> {
        let errors = &self.scene.errors;
        match section {
            Section::Options => self.options().validate(),
            Section::Gyro => errors.gyro.validate(Sensor::Gyro),
            Section::Accelerometer => errors.accel.validate(Sensor::Accelerometer),
            Section::Altimeter => errors.altimeter.validate(),
            Section::Start => errors.initial.validate(),
            Section::Mounting => errors.mounting.validate(),
            Section::Gravity => errors.gravity.validate(),
            Section::Flight => {
                self.check_limits(section)?;
                self.start.validate()
            }
            Section::Log | Section::Imu => self.check_limits(section),
            Section::Output => {
                self.check_limits(section)?;
                self.scene.output.validate()
            }
            Section::Unit => self.scene.unit.parameters.validate(),
            Section::Manoeuvre | Section::Sinusoid | Section::Failure | Section::Update | Section::Panel => {
                Ok(())
            }
        }
    }

    /// Checks the limits of values that only the scene has.
    fn check_limits(&self, section: Section) -> Result<(), Error> {
        let mut draft = self.clone();
        for (_, key) in of_section(section) {
            let Target::Numbers { field, place: Place::At(places), range: Some(range), .. } = key.target
            else {
                continue;
            };
            let (low, high) = range.ends();
            for number in places(&mut draft).filter(|number| !number.is_nan()) {
                check_range(field, *number, low, high)?;
            }
        }
        Ok(())
    }
}

impl Scene {
    /// Checks every part, and whether they go together: such a scene can be written, read back and flown. The parts can be
    /// set in any order, so that a scene in the making may not be one.
    pub fn check(&self) -> Result<(), Error> {
        self.check_limits()?;
        self.options.validate()?;
        self.errors.validate()?;
        self.output.validate()?;
        self.unit.parameters.validate()?;
        if let Some(error) = self.conflicts().into_iter().next() {
            return Err(error);
        }
        self.simulator_options().validate()?;
        if self.is_log() { Ok(()) } else { self.flown_s().map(|_| ()) }
    }

    /// Checks the limits of values that only the scene has.
    pub(crate) fn check_limits(&self) -> Result<(), Error> {
        let change_c_s = self.temperature.map(|temperature| temperature.change_c_s);
        let any = [
            ("flight.rate_hz", Some(self.rate_hz)),
            ("flight.duration_s", self.duration_s),
            ("flight.temperature_c", self.temperature.map(|temperature| temperature.at_start_c)),
            ("flight.temperature_change_c_s", change_c_s),
            ("output.every_s", self.output.every_s),
            ("log.rate_hz", self.log.rate_hz),
            ("log.missing", self.log.missing),
            ("log.smooth_rate_hz", Some(self.log.smooth_rate_hz)),
            ("log.position_sigma_m", self.log.position_sigma_m),
            ("log.attitude_sigma_rad", self.log.attitude_sigma_rad),
            ("log.attack_rad", Some(self.log.attack_rad)),
            ("imu.rate_hz", self.imu.rate_hz),
            ("imu.missing", self.imu.missing),
        ];
        // NaN stands for a missing value in a draft.
        if let Some(&(field, _)) = any.iter().find(|(_, number)| number.is_some_and(f64::is_nan)) {
            return Err(Error::invalid(field, f64::NAN, Rule::Finite));
        }
        let draft = Draft::from(self);
        draft.check_limits(Section::Flight)?;
        draft.check_limits(Section::Log)?;
        draft.check_limits(Section::Imu)?;
        draft.check_limits(Section::Output)
    }

    /// Settings that do not go together, each with the field that would have to change.
    pub(super) fn conflicts(&self) -> Vec<Error> {
        let mut conflicts = Vec::new();
        if !self.is_log() && self.options.intake.period_s.is_some() {
            let words = "only for a log; this flight is sampled at flight.rate_hz";
            conflicts.push(at_odds("options.sample_period_s", words));
        }
        if self.is_log() && self.rate_hz != Self::default().rate_hz {
            conflicts.push(at_odds("flight.rate_hz", "not for a flight log, which has its own time stamps"));
        }
        if !self.is_log() && self.rate_hz * self.options.intake.max_gap_s < 1.0 {
            let words = "samples would be farther apart than options.max_gap_s =";
            let rule = Rule::SentenceWith(words, self.options.intake.max_gap_s.into());
            conflicts.push(Error::invalid("flight.rate_hz", self.rate_hz, rule));
        }
        for (field, comment) in [("log.comment", &self.log.comment), ("imu.comment", &self.imu.comment)] {
            if !matches!(comment.as_bytes(), [letter] if letter.is_ascii_punctuation()) {
                conflicts.push(at_odds(field, "must be a single mark, as #"));
            }
        }
        if self.log.only.is_empty() != self.log.only_column.is_empty() {
            conflicts.push(at_odds(
                "log.only",
                "comes with log.only_column: a column, and its cell in the rows that are read",
            ));
        }
        if self.unit.start.is_none() && !self.panel.is_empty() {
            conflicts.push(at_odds("panel", "needs a unit: unit.start must be off or nav"));
        }
        if self.options.vertical != VerticalMode::Damped {
            if self.errors.altimeter != AltimeterParameters::default() {
                let words = "acts only in the damped vertical channel; options.vertical is another";
                conflicts.push(at_odds("altimeter", words));
            }
            if self.failures.iter().any(|planned| planned.output == SensorOutput::Altimeter) {
                let words = "must be the damped channel: a failure of the altimeter acts only there";
                conflicts.push(at_odds("options.vertical", words));
            }
        }
        conflicts
    }
}
