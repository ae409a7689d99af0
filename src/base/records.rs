//! Lines of files of numbers.

use core::fmt;

/// A line of a file, without the line end.
pub fn line(values: impl IntoIterator<Item = f64>) -> String {
    values.into_iter().map(number).collect::<Vec<_>>().join(",")
}

/// A number as the shortest text that gives the same bits when it is read.
pub struct Number(pub f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = *self;
        let size = value.abs();
        if size == 0.0 || (1e-5..1e15).contains(&size) {
            write!(f, "{value}")
        } else {
            write!(f, "{value:e}")
        }
    }
}

/// The text of a [`Number`].
pub fn number(value: f64) -> String {
    Number(value).to_string()
}

/// `value` rounded to `digits` significant digits.
pub fn rounded(value: f64, digits: usize) -> f64 {
    format!("{value:.0$e}", digits.saturating_sub(1)).parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_read_back() {
        for (value, text) in
            [(0.0, "0"), (-0.1, "-0.1"), (3.0, "3"), (1.25e-300, "1.25e-300"), (1e22, "1e22")]
        {
            assert_eq!(number(value), text);
            assert_eq!(text.parse::<f64>().unwrap().to_bits(), value.to_bits());
        }
    }
}
