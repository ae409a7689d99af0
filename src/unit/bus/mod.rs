//! Words of ARINC 429, as the rest of an avionics bench reads them.
//!
//! The encoder is a function of the status and the navigation of a [`Unit`](crate::unit::Unit): it has no state. A real unit shows the
//! values of some 80 ms ago: a host that wants this delay keeps status and navigation for that time.

mod label;
mod source;
mod table;
mod word;

pub use label::Label;
pub use source::Inputs;
pub use table::LABELS;
pub use word::{Digit, Format, WordStatus, reversed};

use crate::base::error::{Error, Rule, Value, check_range};
use crate::unit::{State, Status, UnitNavigation};
use source::Source;

/// A word and its time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Word {
    /// Time of the word [s].
    pub time_s: f64,
    /// The word: its lowest byte is the number of the label.
    pub word: u32,
    /// Number of the label.
    pub label: u8,
}

/// A decoded word.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decoded {
    /// Its label.
    pub label: &'static Label,
    /// The value, in the unit of the label; NaN if the data are no value of the label.
    pub value: f64,
    /// Its status.
    pub status: WordStatus,
    /// Why the value is not legal, if the status says so. A digit is counted from 0, the highest.
    pub illegal: Option<Error>,
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

/// Share of a time that its rounding may have: a product of two rounded numbers. A power of two: its product is exact.
const ROUNDINGS: f64 = 4.0 * f64::EPSILON;

/// Gives each word that is due after `from_s` and not after `to_s` [s] to `take`, in the order of time. `from_s` is from -1e10 to 1e10,
/// `to_s` from `from_s` to 10 s later. A time that is before a multiple of a millisecond by no more than four roundings counts as the
/// multiple. A unit that is off sends no word.
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
    let at = |time_ms: i64| time_ms as f64 / 1e3;
    let milliseconds = |time_s: f64| {
        let next = (time_s * 1e3).floor() as i64 + 1;
        if at(next) - time_s <= ROUNDINGS * time_s.abs() { next } else { next - 1 }
    };
    for time_ms in milliseconds(from_s) + 1..=milliseconds(to_s) {
        for label in LABELS
            .iter()
            .filter(|label| label.interval_ms != 0 && time_ms % i64::from(label.interval_ms) == 0)
        {
            take(Word { time_s: at(time_ms), word: label.word(&source, inputs.source), label: label.number });
        }
    }
    Ok(())
}

/// Label, value and status of a word. The error says why the word cannot be decoded: its parity is even, or the table does not have its
/// label.
pub fn decode(word: u32) -> Result<Decoded, Error> {
    decode_either(word, false)
}

/// The same of a word whose label bits are reversed.
pub fn decode_reversed(word: u32) -> Result<Decoded, Error> {
    decode_either(word, true)
}

fn decode_either(given: u32, is_reversed: bool) -> Result<Decoded, Error> {
    let word = if is_reversed { reversed(given) } else { given };
    let reject = |rule| Error::invalid("word", Value::Word(given), rule);
    if word::has_even_parity(word) {
        return Err(reject(Rule::Sentence("has an even parity; words of ARINC 429 have an odd one")));
    }
    let Some(label) = Label::of(word) else {
        let other = Label::of(reversed(word)).map(|label| (label.number, label.name));
        return Err(reject(Rule::Label(word as u8, is_reversed, other)));
    };
    let status = word::status(&label.format, word);
    Ok(match label.read(word) {
        Ok(value) => Decoded { label, value, status, illegal: None },
        Err(why) if status == WordStatus::Normal => {
            Decoded { label, value: f64::NAN, status: WordStatus::IllegalValue, illegal: Some(why) }
        }
        Err(_) => Decoded { label, value: f64::NAN, status, illegal: None },
    })
}
