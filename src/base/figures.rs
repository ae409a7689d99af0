//! Numbers as text for people.

/// A unit: its name, and its size in the SI unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Its name behind a number.
    pub name: &'static str,
    /// Its size [SI unit].
    pub si: f64,
}

/// Millionth of g [m/s²].
pub const MICRO_G: Unit = Unit { name: "µg", si: super::units::MICRO_G };

/// Four significant digits; powers of ten where plain digits would be long.
pub fn significant(value: f64) -> String {
    digits(value, 3)
}

/// The first digit and `behind` more; powers of ten where plain digits would be long.
pub fn digits(value: f64, behind: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{value:.behind$e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    match exponent.parse::<i32>() {
        Ok(exponent @ -3..6) => format!("{value:.*}", usize::try_from(behind as i32 - exponent).unwrap_or(0)),
        Ok(exponent) => format!("{mantissa}×10{}", superscript(exponent)),
        Err(_) => scientific,
    }
}

/// Two significant digits, or all before the point.
pub fn two_digits(value: f64) -> String {
    let scale = |value: f64| format!("1e{}", 1 - exponent(value)).parse::<f64>().unwrap_or(1.0);
    if value == 0.0 || !value.is_finite() || !scale(value).is_normal() {
        return value.to_string();
    }
    let rounded = (value * scale(value)).round() / scale(value);
    // The exponent is taken again, because 9.96 rounds to a number with one more digit before the point.
    let decimals = (1 - exponent(rounded)).max(0) as usize;
    format!("{rounded:.decimals$}")
}

/// The power of ten of the first digit.
fn exponent(value: f64) -> i32 {
    format!("{value:e}").split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

/// A number as raised digits.
pub fn superscript(number: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize]);
    number.to_string().chars().map(raised).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_four_digits() {
        for (value, text) in [
            (0.0, "0"),
            (1234.56, "1235"),
            (-0.012_345_6, "-0.01235"),
            (1.0, "1.000"),
            (123_456.0, "123456"),
            (1.234_56e-9, "1.235×10⁻⁹"),
            (-2e12, "-2.000×10¹²"),
        ] {
            assert_eq!(significant(value), text);
        }
    }

    #[test]
    fn numbers_keep_two_digits() {
        for (value, text) in [
            (0.0, "0"),
            (9.96, "10"),
            (-0.125, "-0.13"),
            (1000.0, "1000"),
            (1249.0, "1200"),
            (0.000_999, "0.0010"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(two_digits(value), text);
        }
        for value in [f64::MIN_POSITIVE / 4.0, -1e-300, 1.7e308] {
            assert!(two_digits(value).parse::<f64>().is_ok_and(|read| (read / value - 1.0).abs() < 0.06));
        }
    }
}
