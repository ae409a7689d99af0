//! Errors as data: which field, which value, which limit. The sentence is made when somebody reads it.

use core::fmt;

use crate::units::TEMPERATURE_RANGE_C;

/// What kind of refusal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorKind {
    /// A value out of its range.
    InvalidArgument,
    /// Right call, wrong moment.
    BadState,
    /// A sample that is not later than the one before, or off its stated period.
    TimeOrder,
    /// Truth jumped: a gap in time, a teleport, half a turn in one interval.
    Discontinuity,
    /// No room for another sample before the next step.
    QueueFull,
    /// The solution left its representable range.
    Diverged,
    /// The geographic mechanization came within reach of a pole.
    Singular,
    /// No memory for what was asked.
    OutOfMemory,
    /// A snapshot that is damaged, foreign or newer.
    Snapshot,
    /// No room for what was asked.
    BufferTooSmall,
}

/// The limit that a value has to keep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rule {
    /// Not a number, or infinite.
    Finite,
    /// `low` ≤ value ≤ `high`.
    Between(f64, f64),
    /// 0, which is none, or `low` ≤ value ≤ `high`.
    OffOr(f64, f64),
    /// `low` ≤ value ≤ `high`, because the named field is not 0.
    NeededBy(f64, f64, &'static str),
    /// value < limit.
    Below(f64),
    /// A sentence, for limits that need words.
    Words(&'static str),
    /// A sentence and the number that ends it.
    WordsAnd(&'static str, f64),
}

/// A refused call. Nothing was changed by it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Error {
    /// What kind of refusal.
    pub kind: ErrorKind,
    /// The field at fault, as it is spelled in the interface; empty if it is the call itself.
    pub field: &'static str,
    /// Place in the field, if that is an array.
    pub index: Option<usize>,
    /// The value at fault, if it is one.
    pub value: Option<f64>,
    /// The limit.
    pub rule: Rule,
}

impl Error {
    /// An error about the value of a field.
    pub fn of(kind: ErrorKind, field: &'static str, value: f64, rule: Rule) -> Self {
        Self { kind, field, index: None, value: Some(value), rule }
    }

    /// A value out of its range.
    pub fn invalid(field: &'static str, value: f64, rule: Rule) -> Self {
        Self::of(ErrorKind::InvalidArgument, field, value, rule)
    }

    /// A call at the wrong moment.
    pub fn bad_state(why: &'static str) -> Self {
        Self { kind: ErrorKind::BadState, field: "", index: None, value: None, rule: Rule::Words(why) }
    }

    /// The same error, about element `index` of the field.
    pub fn at(self, index: usize) -> Self {
        Self { index: Some(index), ..self }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.field.is_empty() {
            f.write_str(self.field)?;
            if let Some(index) = self.index {
                write!(f, "[{index}]")?;
            }
            match self.value {
                Some(value) => write!(f, " = {}: ", Number(value))?,
                None => f.write_str(": ")?,
            }
        }
        match self.rule {
            Rule::Finite => f.write_str("must be a finite number"),
            Rule::Between(low, high) => write!(f, "must be from {} to {}", Number(low), Number(high)),
            Rule::OffOr(low, high) => {
                write!(f, "must be 0 for none, or from {} to {}", Number(low), Number(high))
            }
            Rule::NeededBy(low, high, field) => {
                write!(f, "must be from {} to {} where {field} is not 0", Number(low), Number(high))
            }
            Rule::Below(limit) => write!(f, "must be less than {}", Number(limit)),
            Rule::Words(words) => f.write_str(words),
            Rule::WordsAnd(words, number) => write!(f, "{words} {}", Number(number)),
        }
    }
}

impl core::error::Error for Error {}

/// Integers as integers, very large and very small numbers with an exponent.
struct Number(f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = *self;
        let size = value.abs();
        if size != 0.0 && value.is_finite() && !(1e-4..1e7).contains(&size) {
            write!(f, "{value:e}")
        } else {
            write!(f, "{value}")
        }
    }
}

/// Checks that `value` is a finite number from `low` to `high`.
#[inline]
pub(crate) fn check_range(field: &'static str, value: f64, low: f64, high: f64) -> Result<(), Error> {
    if (low..=high).contains(&value) { Ok(()) } else { Err(out_of_range(field, value, low, high)) }
}

#[cold]
fn out_of_range(field: &'static str, value: f64, low: f64, high: f64) -> Error {
    let rule = if value.is_finite() { Rule::Between(low, high) } else { Rule::Finite };
    Error::invalid(field, value, rule)
}

/// Checks each element of `values` as [`check_range`] does.
pub(crate) fn check_ranges(field: &'static str, values: &[f64], low: f64, high: f64) -> Result<(), Error> {
    for (index, &value) in values.iter().enumerate() {
        check_range(field, value, low, high).map_err(|error| error.at(index))?;
    }
    Ok(())
}

/// Checks a temperature [°C].
pub(crate) fn check_temperature(field: &'static str, temperature_c: f64) -> Result<(), Error> {
    check_range(field, temperature_c, TEMPERATURE_RANGE_C.0, TEMPERATURE_RANGE_C.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sentence_names_field_value_and_limit() {
        let error = check_ranges("gyro.markov_time_s", &[1.0, -3.0], 0.0, 1e12).unwrap_err();
        assert_eq!(error.to_string(), "gyro.markov_time_s[1] = -3: must be from 0 to 1e12");
        assert_eq!(
            check_range("height_m", f64::NAN, 0.0, 1.0).unwrap_err().to_string(),
            "height_m = NaN: must be a finite number"
        );
        assert_eq!(Error::bad_state("too late").to_string(), "too late");
    }
}
