//! Words of ARINC 429, as the rest of an avionics bench reads them.
//!
//! The encoder is a function of the status and the navigation of a [`Unit`](crate::unit::Unit): it has no state. A real unit shows the values of
//! some 80 ms ago: a host that wants this delay keeps status and navigation for that time.

mod source;
mod table;
mod word;

pub use source::Inputs;
pub use table::{LABELS, Label};
pub use word::{Format, WordStatus, reversed};

use crate::error::{Error, check_range};
use crate::unit::{State, Status, UnitNavigation};
use source::Source;

/// A word and its time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Word {
    /// Time of the word [s].
    pub time_s: f64,
    /// The word: bit 1 is its lowest bit.
    pub word: u32,
    /// Number of the label.
    pub label: u8,
}

/// A decoded word.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decoded {
    /// Its label.
    pub label: &'static Label,
    /// The value, in the unit of the label.
    pub value: f64,
    /// Its status.
    pub status: WordStatus,
}

impl PartialEq for Label {
    fn eq(&self, other: &Self) -> bool {
        self.number == other.number
    }
}

impl Inputs {
    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        if let Some((speed, direction)) = self.wind {
            check_range("inputs.wind_speed_m_s", speed, 0.0, 500.0)?;
            check_range("inputs.wind_direction_rad", direction, -10.0, 10.0)?;
        }
        check_range("inputs.magnetic_variation_rad", self.variation_rad.unwrap_or(0.0), -3.2, 3.2)?;
        check_range("inputs.source", self.source.into(), 0.0, 3.0)
    }
}

/// Gives each word that is due after `from_s` and not after `to_s` [s] to `take`, in the order of time. A unit that is off sends none.
pub fn words(
    status: &Status,
    shown: &UnitNavigation,
    inputs: &Inputs,
    (from_s, to_s): (f64, f64),
    mut take: impl FnMut(Word),
) -> Result<(), Error> {
    inputs.validate()?;
    check_range("from_s", from_s, -1e10, 1e10)?;
    check_range("to_s", to_s, from_s, from_s + 10.0)?;
    if matches!(status.state, State::Off | State::PowerDown) {
        return Ok(());
    }
    let source = Source::new(shown, status, inputs);
    // A thousandth of a millisecond for the rounding of times.
    let milliseconds = |time_s: f64| (time_s * 1e3 + 1e-3).floor() as i64;
    for time_ms in milliseconds(from_s) + 1..=milliseconds(to_s) {
        for label in LABELS
            .iter()
            .filter(|label| label.interval_ms != 0 && time_ms % i64::from(label.interval_ms) == 0)
        {
            take(Word {
                time_s: time_ms as f64 / 1e3,
                word: label.word(&source, inputs.source),
                label: label.number,
            });
        }
    }
    Ok(())
}

/// Label, value and status of a word. `None`: its parity is even, or the table does not have its label.
pub fn decode(word: u32) -> Option<Decoded> {
    let label = LABELS.iter().find(|label| u32::from(label.number) == word & 0xff)?;
    let (steps, status) = word::decode(&label.format, word)?;
    Some(Decoded { label, value: steps * label.resolution, status })
}

impl Label {
    fn word(&self, source: &Source, identifier: u32) -> u32 {
        let status = source.status_of(self.group);
        let steps = if status == WordStatus::Normal { (self.of)(source) / self.resolution } else { 0.0 };
        word::encode(self.number, &self.format, identifier, steps, status)
    }

    /// The word that says `value`, in the unit of the label, with a normal status.
    pub fn encode(&self, value: f64, source: u32) -> u32 {
        word::encode(self.number, &self.format, source, value / self.resolution, WordStatus::Normal)
    }
}
