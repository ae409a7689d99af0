//! A label: its numbers, and the range that they must be in.

use super::source::{Group, Source};
use super::table::LABELS;
use super::word::{self, Format, WordStatus};
use crate::base::error::{Error, Rule};

/// A label.
#[derive(Debug, Clone, Copy)]
pub struct Label {
    /// Its number, written in octal.
    pub number: u8,
    /// What it is.
    pub name: &'static str,
    /// Unit of the value; empty: a pure number, or bits.
    pub unit: &'static str,
    /// Value of the lowest bit or digit.
    pub resolution: f64,
    /// Range of the quantity, in the unit. A binary number ends one resolution below the end of its own range.
    pub range: (f64, f64),
    /// How the number stands in the word.
    pub format: Format,
    /// Time from one word to the next [ms]; 0: an input, which the unit does not send.
    pub interval_ms: u32,
    /// What makes it valid.
    pub(super) group: Group,
    /// The value, in the unit.
    pub(super) quantity: fn(&Source) -> f64,
}

impl PartialEq for Label {
    fn eq(&self, other: &Self) -> bool {
        self.number == other.number
    }
}

impl Label {
    /// The label of a word.
    pub(super) fn of(word: u32) -> Option<&'static Self> {
        LABELS.iter().find(|label| label.number == word as u8)
    }

    /// The word that a unit sends.
    pub(super) fn word(&self, source: &Source, identifier: u32) -> u32 {
        let status = source.status_of(self.group);
        let value = if status == WordStatus::Normal { (self.quantity)(source) } else { 0.0 };
        word::encode(self.number, &self.format, identifier, self.steps(value), status)
    }

    /// The word that says `value`, in the unit of the label, with a normal status. A value beyond the range of the label is the end of
    /// the range; angles of any direction wrap in binary words.
    pub fn encode(&self, value: f64, source: u32) -> u32 {
        word::encode(self.number, &self.format, source, self.steps(value), WordStatus::Normal)
    }

    /// The least and the greatest legal number, in units of the resolution.
    fn limits(&self) -> (i64, i64) {
        let (low, high) = word::limits(&self.format);
        let steps = |value: f64| (value / self.resolution).round() as i64;
        (low.max(steps(self.range.0)), high.min(steps(self.range.1)))
    }

    /// The least and the greatest legal value, in the unit.
    pub fn least_and_greatest(&self) -> (f64, f64) {
        let (low, high) = self.limits();
        (self.value(low), self.value(high))
    }

    /// The nearest legal number to a value, in units of the resolution; 0 for a value that is not finite.
    fn steps(&self, value: f64) -> i64 {
        let steps = value / self.resolution;
        if !steps.is_finite() {
            return 0;
        }
        let (low, high) = self.limits();
        match self.format {
            Format::Binary { wraps, .. } => {
                let count = (steps + 0.5).floor() as i64;
                let turn = high - low + 1;
                if wraps {
                    (count.rem_euclid(turn) - low).rem_euclid(turn) + low
                } else {
                    count.clamp(low, high)
                }
            }
            _ => ((steps.abs() + 0.5).floor().copysign(steps) as i64).clamp(low, high),
        }
    }

    /// A decimal number is divided, so that 45.5 is 45.5.
    fn value(&self, steps: i64) -> f64 {
        match self.format {
            Format::Decimal(_) => steps as f64 / (1.0 / self.resolution).round(),
            _ => steps as f64 * self.resolution,
        }
    }

    /// The value of a word with this label. The error says which digit, or that the value is out of range.
    pub(super) fn read(&self, word: u32) -> Result<f64, Error> {
        let steps = word::steps(&self.format, word)?;
        let ((low, high), value) = (self.limits(), self.value(steps));
        if (low..=high).contains(&steps) {
            return Ok(value);
        }
        Err(Error::invalid(self.name, value, Rule::Between(self.range.0, self.range.1)))
    }
}
