//! Errors as data: field, value and limit. The sentence is made only when the error is displayed.

mod check;
mod rule;

use core::fmt;

pub(crate) use check::{check_integer, check_range, check_ranges, check_temperature, check_within};
pub use rule::{Rule, Value};

use rule::ShortNumber;

/// The kind of the error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorKind {
    /// A value out of its range.
    InvalidArgument,
    /// A call that is right, but at the wrong moment.
    BadState,
    /// A sample that is not later than the previous sample, or off the stated sample period.
    TimeOrder,
    /// A jump of the truth: a gap in time, a teleport, half a turn in one interval.
    Discontinuity,
    /// No room for another sample before the next step.
    QueueFull,
    /// The solution left its representable range.
    Diverged,
    /// The geographic mechanization came too close to a pole.
    Singular,
    /// Not enough memory for the request.
    OutOfMemory,
    /// A snapshot that is damaged, of another release or another kind, or bytes that are no snapshot.
    Snapshot,
    /// A buffer of the caller with too little room for the result.
    BufferTooSmall,
}

/// Error of a rejected call. The call changed nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Error {
    /// The kind of the error.
    pub kind: ErrorKind,
    /// The field with the error, as it is spelled in the interface; empty if the call itself is the error.
    pub field: &'static str,
    /// Index of the element, if the field is an array.
    pub index: Option<usize>,
    /// The rejected value, if a value is the error.
    pub value: Option<Value>,
    /// The limit that was violated.
    pub rule: Rule,
}

impl Error {
    /// An error about the value of a field.
    pub fn of(kind: ErrorKind, field: &'static str, value: impl Into<Value>, rule: Rule) -> Self {
        Self { kind, field, index: None, value: Some(value.into()), rule }
    }

    /// An error about a value out of its range.
    pub fn invalid(field: &'static str, value: impl Into<Value>, rule: Rule) -> Self {
        Self::of(ErrorKind::InvalidArgument, field, value, rule)
    }

    /// An error about a call at the wrong moment.
    pub fn bad_state(why: &'static str) -> Self {
        Self { kind: ErrorKind::BadState, field: "", index: None, value: None, rule: Rule::Sentence(why) }
    }

    /// The sentence with `name` in the place of the field and its index.
    pub fn sentence_about(&self, name: &str) -> String {
        let rule = Self { field: "", index: None, value: None, ..*self };
        let value = self.value.map_or(String::new(), |value| format!(" = {value}"));
        format!("{name}{value}: {rule}")
    }

    /// The same error in a unit of `size` in SI. Limits have six digits, without digits that come from rounding, and are not beyond
    /// the limits in SI.
    pub fn in_unit(self, size: f64) -> Self {
        if size == 1.0 {
            return self;
        }
        let low = |number: f64| six_digits(number / size, 1.0);
        let high = |number: f64| six_digits(number / size, -1.0);
        let rule = match self.rule {
            Rule::Between(from, to) => Rule::Between(low(from), high(to)),
            Rule::OffOr(from, to) => Rule::OffOr(low(from), high(to)),
            Rule::DefaultOr(from, to) => Rule::DefaultOr(low(from), high(to)),
            Rule::NeededBy(from, to, field) => Rule::NeededBy(low(from), high(to), field),
            Rule::Below(limit) => Rule::Below(high(limit)),
            Rule::AtLeast(words, limit) => Rule::AtLeast(words, low(limit.as_f64()).into()),
            Rule::AtMost(words, limit) => Rule::AtMost(words, high(limit.as_f64()).into()),
            Rule::Exactly(words, limit) => Rule::Exactly(words, high(limit.as_f64()).into()),
            Rule::SentenceWith(words, limit) => Rule::SentenceWith(words, high(limit.as_f64()).into()),
            other => other,
        };
        Self { value: self.value.map(|value| rounded(value.as_f64() / size, 15).into()), rule, ..self }
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
                Some(value) => write!(f, " = {value}: ")?,
                None => f.write_str(": ")?,
            }
        }
        match self.rule {
            Rule::Finite => f.write_str("must be a finite number"),
            Rule::Between(low, high) => {
                write!(f, "must be from {} to {}", ShortNumber(low), ShortNumber(high))?;
                // Not s/rad, the unit of a nonlinearity.
                let is_angle = self.field.ends_with("_rad") && !self.field.ends_with("_s_rad");
                let may_be_degrees = |value: f64| is_angle && (1.6..=360.0).contains(&value.abs());
                let is_stamp = self.field == "time_s" || self.field.ends_with(".time_s");
                let hint = match self.value {
                    Some(Value::Real(value)) if may_be_degrees(value) => "; is it in degrees?",
                    // The time since 1970 in another unit.
                    Some(Value::Real(1e10..1e14)) if is_stamp => "; is it in ms?",
                    Some(Value::Real(1e14..1e17)) if is_stamp => "; is it in microseconds?",
                    Some(Value::Real(1e17..1e20)) if is_stamp => "; is it in nanoseconds?",
                    _ => "",
                };
                f.write_str(hint)
            }
            Rule::BetweenIntegers(low, high) => write!(f, "must be from {low} to {high}"),
            Rule::OffOr(low, high) => {
                write!(f, "must be 0 for none, or from {} to {}", ShortNumber(low), ShortNumber(high))
            }
            Rule::DefaultOr(low, high) => {
                write!(f, "must be 0 for the default, or from {} to {}", ShortNumber(low), ShortNumber(high))
            }
            Rule::NeededBy(low, high, field) => {
                write!(f, "must be from {} to {} where {field} is not 0", ShortNumber(low), ShortNumber(high))
            }
            Rule::Below(high) => write!(f, "must be less than {}", ShortNumber(high)),
            Rule::OneOf(name, first, last) => write!(f, "must be of enum {name}, {first} to {last}"),
            Rule::Zero(why) => write!(f, "must be 0{why}"),
            Rule::Sentence(words) => f.write_str(words),
            Rule::AtLeast(words, number)
            | Rule::AtMost(words, number)
            | Rule::Exactly(words, number)
            | Rule::SentenceWith(words, number) => write!(f, "{words} {number}"),
            Rule::GapWithJump(limit_s, moved_m) => write!(
                f,
                "the gap after the last accepted sample must be at most options.max_gap_s = {}; in the gap the position jumped by {} m",
                ShortNumber(limit_s),
                ShortNumber(moved_m)
            ),
            Rule::Label(number, is_reversed, other) => {
                write!(f, "label {number:03o} is not in the table")?;
                let Some((other, name)) = other else { return Ok(()) };
                let not = if is_reversed { "not " } else { "" };
                write!(f, "; label bits {not}reversed? {other:03o} would be {name}")
            }
        }
    }
}

impl core::error::Error for Error {}

/// `number` with `digits` digits.
fn rounded(number: f64, digits: usize) -> f64 {
    format!("{number:.0$e}", digits - 1).parse().unwrap_or(number)
}

/// A limit with six digits: the nearest, or if that is not the limit within rounding, the next one in a `direction`, 1 or -1.
fn six_digits(limit: f64, direction: f64) -> f64 {
    let near = rounded(limit, 6);
    let text = format!("{near:.5e}");
    let exponent: i32 = text.split_once('e').and_then(|(_, digits)| digits.parse().ok()).unwrap_or_default();
    let step: f64 = format!("1e{}", exponent - 5).parse().unwrap_or_default();
    let is_within = (near - limit) * direction >= -1e-12 * limit.abs();
    if is_within { near } else { rounded(near + direction * step, 6) }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::FRAC_PI_2;

    use super::*;

    #[test]
    fn the_sentence_names_field_value_and_limit() {
        assert_eq!(
            check_range("sample.latitude_rad", 47.5, -1.5, 1.5).unwrap_err().to_string(),
            "sample.latitude_rad = 47.5: must be from -1.5 to 1.5; is it in degrees?"
        );
        for (value, hint) in [
            (1.76e12, "; is it in ms?"),
            (1.76e15, "; is it in microseconds?"),
            (1.76e18, "; is it in nanoseconds?"),
            (-1.76e12, ""),
            (1e300, ""),
        ] {
            let error = check_range("sample.time_s", value, -1e10, 1e10).unwrap_err().to_string();
            assert_eq!(error, format!("sample.time_s = {value:e}: must be from -1e10 to 1e10{hint}"));
        }
        let error = check_ranges("gyro.markov_time_s", &[1.0, -3.0], 0.0, 1e12).unwrap_err();
        assert_eq!(error.to_string(), "gyro.markov_time_s[1] = -3: must be from 0 to 1e12");
        assert_eq!(
            check_range("height_m", f64::NAN, 0.0, 1.0).unwrap_err().to_string(),
            "height_m = NaN: must be a finite number"
        );
        assert_eq!(Error::bad_state("too late").to_string(), "too late");
        assert_eq!(
            check_integer("count", u64::MAX, 2, 1_000_000_000).unwrap_err().to_string(),
            "count = 18446744073709551615: must be from 2 to 1000000000"
        );
        let run = Error::invalid("run", u64::MAX, Rule::BetweenIntegers(0, u64::MAX - 1));
        assert_eq!(run.to_string(), "run = 18446744073709551615: must be from 0 to 18446744073709551614");
        let size =
            Error::invalid("gyro.struct_size", 3_435_973_836_u32, Rule::Exactly("must be", 712_u32.into()));
        assert_eq!(size.to_string(), "gyro.struct_size = 3435973836: must be 712");
        // In another unit, a stated limit is accepted, and the value is none of the stated range.
        let latitude = |value| check_range("", value, -FRAC_PI_2 - 1e-9, FRAC_PI_2 + 1e-9);
        let error = latitude(90.0000001_f64.to_radians()).unwrap_err().in_unit(1.0_f64.to_radians());
        assert_eq!(error.sentence_about("latitude_deg"), "latitude_deg = 90.0000001: must be from -90 to 90");
        let rate = |value| check_range("", value, 1e-9, 1e6);
        let error = rate(1.1e6).unwrap_err().in_unit(1.0_f64.to_radians());
        assert_eq!(
            error.sentence_about("rate"),
            "rate = 6.30253574643906e7: must be from 5.72958e-8 to 5.72957e7"
        );
        assert_eq!(rate(5.72957e7_f64.to_radians()), Ok(()));
    }
}
