//! Errors as data: field, value and limit. The sentence is made only when the error is displayed.

use core::fmt;

use crate::units::TEMPERATURE_RANGE_C;

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

/// The limit that a value must satisfy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rule {
    /// The value is finite: not NaN, not infinite.
    Finite,
    /// `low` ≤ value ≤ `high`.
    Between(f64, f64),
    /// `low` ≤ value ≤ `high`, integers of 64 bits.
    BetweenIntegers(u64, u64),
    /// value = 0, which means none, or `low` ≤ value ≤ `high`.
    OffOr(f64, f64),
    /// value = 0, which means a default, or `low` ≤ value ≤ `high`.
    DefaultOr(f64, f64),
    /// `low` ≤ value ≤ `high`, because the named field is not 0.
    NeededBy(f64, f64, &'static str),
    /// value < limit.
    Below(f64),
    /// value ≥ limit: words before the limit, and the limit.
    AtLeast(&'static str, Value),
    /// value ≤ limit: words before the limit, and the limit.
    AtMost(&'static str, Value),
    /// value = limit: words before the limit, and the limit.
    Exactly(&'static str, Value),
    /// value = 0: words that follow "must be 0".
    Zero(&'static str),
    /// A value of this enumeration of the C interface: all integers from the first to the last.
    OneOf(&'static str, i32, i32),
    /// A sentence that describes the limit.
    Sentence(&'static str),
    /// A sentence that ends with a number. The number is not itself the limit of the value.
    SentenceWith(&'static str, Value),
}

impl Rule {
    /// The smallest and the largest value, if the rule has them. The limit of [`Rule::Below`] itself is not allowed.
    pub fn limits(&self) -> (Option<f64>, Option<f64>) {
        match *self {
            Self::Finite | Self::Sentence(_) | Self::SentenceWith(..) => (None, None),
            Self::Between(low, high)
            | Self::OffOr(low, high)
            | Self::DefaultOr(low, high)
            | Self::NeededBy(low, high, _) => (Some(low), Some(high)),
            Self::BetweenIntegers(low, high) => (Some(low as f64), Some(high as f64)),
            Self::OneOf(_, low, high) => (Some(low.into()), Some(high.into())),
            Self::AtLeast(_, low) => (Some(low.as_f64()), None),
            Self::Below(high) => (None, Some(high)),
            Self::AtMost(_, high) => (None, Some(high.as_f64())),
            Self::Exactly(_, only) => (Some(only.as_f64()), Some(only.as_f64())),
            Self::Zero(_) => (Some(0.0), Some(0.0)),
        }
    }
}

/// A rejected value. Integers keep every digit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// Value of a floating-point field.
    Real(f64),
    /// Value of a signed integer field.
    Signed(i64),
    /// Value of an unsigned integer field.
    Unsigned(u64),
}

impl Value {
    /// Whether the field is an integer.
    pub fn is_integer(self) -> bool {
        !matches!(self, Self::Real(_))
    }

    /// The nearest floating-point number to the value.
    pub fn as_f64(self) -> f64 {
        match self {
            Self::Real(value) => value,
            Self::Signed(value) => value as f64,
            Self::Unsigned(value) => value as f64,
        }
    }
}

macro_rules! value_from {
    ($($number:ty as $kind:ident),*) => {
        $(impl From<$number> for Value {
            fn from(number: $number) -> Self {
                Self::$kind(number as _)
            }
        })*
    };
}
value_from!(
    f64 as Real,
    i32 as Signed,
    u8 as Unsigned,
    u16 as Unsigned,
    u32 as Unsigned,
    u64 as Unsigned,
    usize as Unsigned
);

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

    /// The same error in a unit of `size` in SI, with six digits: enough for a limit, without digits that come from rounding.
    pub fn in_unit(self, size: f64) -> Self {
        if size == 1.0 {
            return self;
        }
        let digits = |number: f64| format!("{number:.5e}").parse().unwrap_or(number);
        let number = |number: f64| digits(number / size);
        let value = |value: Value| Value::Real(number(value.as_f64()));
        let rule = match self.rule {
            Rule::Between(low, high) => Rule::Between(number(low), number(high)),
            Rule::OffOr(low, high) => Rule::OffOr(number(low), number(high)),
            Rule::DefaultOr(low, high) => Rule::DefaultOr(number(low), number(high)),
            Rule::NeededBy(low, high, field) => Rule::NeededBy(number(low), number(high), field),
            Rule::Below(limit) => Rule::Below(number(limit)),
            Rule::AtLeast(words, limit) => Rule::AtLeast(words, value(limit)),
            Rule::AtMost(words, limit) => Rule::AtMost(words, value(limit)),
            Rule::Exactly(words, limit) => Rule::Exactly(words, value(limit)),
            Rule::SentenceWith(words, limit) => Rule::SentenceWith(words, value(limit)),
            other => other,
        };
        Self { value: self.value.map(value), rule, ..self }
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
        let is_integer = self.value.is_some_and(Value::is_integer);
        let limit = |number| Number { number, is_integer };
        match self.rule {
            Rule::Finite => f.write_str("must be a finite number"),
            Rule::Between(low, high) => {
                write!(f, "must be from {} to {}", limit(low), limit(high))?;
                // Not s/rad, the unit of a nonlinearity.
                let is_angle = self.field.ends_with("_rad") && !self.field.ends_with("_s_rad");
                let may_be_degrees = |value: f64| is_angle && (1.6..=360.0).contains(&value.abs());
                match self.value {
                    Some(Value::Real(value)) if may_be_degrees(value) => f.write_str("; is it in degrees?"),
                    _ => Ok(()),
                }
            }
            Rule::BetweenIntegers(low, high) => write!(f, "must be from {low} to {high}"),
            Rule::OffOr(low, high) => {
                write!(f, "must be 0 for none, or from {} to {}", limit(low), limit(high))
            }
            Rule::DefaultOr(low, high) => {
                write!(f, "must be 0 for the default, or from {} to {}", limit(low), limit(high))
            }
            Rule::NeededBy(low, high, field) => {
                write!(f, "must be from {} to {} where {field} is not 0", limit(low), limit(high))
            }
            Rule::Below(high) => write!(f, "must be less than {}", limit(high)),
            Rule::OneOf(name, first, last) => write!(f, "must be of enum {name}, {first} to {last}"),
            Rule::Zero(why) => write!(f, "must be 0{why}"),
            Rule::Sentence(words) => f.write_str(words),
            Rule::AtLeast(words, number)
            | Rule::AtMost(words, number)
            | Rule::Exactly(words, number)
            | Rule::SentenceWith(words, number) => write!(f, "{words} {number}"),
        }
    }
}

impl core::error::Error for Error {}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Real(number) => Number { number, is_integer: false }.fmt(f),
            Self::Signed(integer) => integer.fmt(f),
            Self::Unsigned(integer) => integer.fmt(f),
        }
    }
}

/// Number to display: an integer with every digit, a very large or very small number with an exponent.
struct Number {
    number: f64,
    is_integer: bool,
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { number, is_integer } = *self;
        let size = number.abs();
        if !is_integer && size != 0.0 && number.is_finite() && !(1e-4..1e7).contains(&size) {
            write!(f, "{number:e}")
        } else {
            write!(f, "{number}")
        }
    }
}

/// Checks that an integer is from `low` to `high`.
pub(crate) fn check_integer(
    field: &'static str,
    value: impl Into<Value>,
    low: i64,
    high: i64,
) -> Result<(), Error> {
    let (value, low, high) = (value.into(), low as f64, high as f64);
    let is_within = (low..=high).contains(&value.as_f64());
    if is_within { Ok(()) } else { Err(Error::invalid(field, value, Rule::Between(low, high))) }
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
        assert_eq!(
            check_range("sample.latitude_rad", 47.5, -1.5, 1.5).unwrap_err().to_string(),
            "sample.latitude_rad = 47.5: must be from -1.5 to 1.5; is it in degrees?"
        );
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
    }
}
