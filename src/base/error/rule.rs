//! Limits and rejected values, and how they are displayed.

use core::fmt;

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
    /// The gap after the last accepted sample is longer than the limit [s], and the position jumped in it [m].
    GapWithJump(f64, f64),
    /// The label of a word is not in the table: its number, whether its bits are reversed, and, if there is one, the label with the bits in
    /// the other order, by number and name.
    Label(u8, bool, Option<(u8, &'static str)>),
}

impl Rule {
    /// The smallest and the largest value, if the rule has them. The limit of [`Rule::Below`] itself is not allowed.
    pub fn limits(&self) -> (Option<f64>, Option<f64>) {
        match *self {
            Self::Finite
            | Self::Sentence(_)
            | Self::SentenceWith(..)
            | Self::Label(..)
            | Self::GapWithJump(..) => (None, None),
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
    /// A word of 32 bits, displayed as eight hexadecimal digits.
    Word(u32),
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
            Self::Word(value) => value.into(),
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

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Real(number) => ShortNumber(number).fmt(f),
            Self::Signed(integer) => integer.fmt(f),
            Self::Unsigned(integer) => integer.fmt(f),
            Self::Word(bits) => write!(f, "{bits:08x}"),
        }
    }
}

/// Number to display, a very large or very small one with an exponent.
pub(super) struct ShortNumber(pub f64);

impl fmt::Display for ShortNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if size != 0.0 && self.0.is_finite() && !(1e-4..1e7).contains(&size) {
            write!(f, "{:e}", self.0)
        } else {
            write!(f, "{}", self.0)
        }
    }
}
