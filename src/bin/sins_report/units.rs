//! Units chosen by size, and numbers as text.

use std::f64::consts::PI;

/// A unit and how much of the SI unit it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    pub name: &'static str,
    pub si: f64,
}

const fn unit(name: &'static str, si: f64) -> Unit {
    Unit { name, si }
}

/// The units of height.
pub const METRE: Unit = unit("m", 1.0);
/// See [`METRE`].
pub const KILOMETRE: Unit = unit("km", 1e3);

/// Units of length [m], each family from small to large.
pub const LENGTH: &[Unit] =
    &[unit("pm", 1e-12), unit("nm", 1e-9), unit("µm", 1e-6), unit("mm", 1e-3), METRE, KILOMETRE];

/// Units of speed [m/s].
pub const SPEED: &[Unit] = &[
    unit("pm/s", 1e-12),
    unit("nm/s", 1e-9),
    unit("µm/s", 1e-6),
    unit("mm/s", 1e-3),
    unit("m/s", 1.0),
    unit("km/s", 1e3),
];

/// Units of angle [rad].
pub const ANGLE: &[Unit] = &[
    unit("prad", 1e-12),
    unit("nrad", 1e-9),
    unit("µrad", 1e-6),
    unit("arcsec", PI / 648_000.0),
    unit("arcmin", PI / 10_800.0),
    unit("deg", PI / 180.0),
];

/// Degree an hour [rad/s].
pub const DEG_PER_HOUR: Unit = unit("deg/h", PI / 648_000.0);

/// Millionth of g [m/s²].
pub const MICRO_G: Unit = unit("µg", 9.80665e-6);

/// Nautical mile an hour [m/s].
pub const NMI_PER_HOUR: Unit = unit("nmi/h", 1852.0 / 3600.0);

/// The family that an SI unit heads.
pub fn family(si_name: &str) -> Option<&'static [Unit]> {
    match si_name {
        "m" => Some(LENGTH),
        "m/s" => Some(SPEED),
        "rad" => Some(ANGLE),
        _ => None,
    }
}

/// The largest unit of which `size` [SI] is at least one; the SI unit itself for zero (a degree for angles).
pub fn fitting(size: f64, family: &[Unit]) -> Unit {
    let zero = if family == ANGLE { 5 } else { 4 };
    let fits = |unit: &&Unit| if size == 0.0 { **unit == family[zero] } else { size.abs() >= unit.si };
    family.iter().rev().find(fits).copied().unwrap_or(family[0])
}

/// `value` [SI] in the unit that fits it, "12.35 km"; in the large one with a power of ten where none does.
pub fn with_unit(value: f64, family: &[Unit]) -> String {
    let mut unit = fitting(value, family);
    if value.abs() < 1e-3 * unit.si {
        unit = fitting(0.0, family);
    }
    format!("{} {}", significant(value / unit.si), unit.name)
}

/// Four significant digits; powers of ten where plain digits would be long.
pub fn significant(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{value:.3e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    match exponent.parse::<i32>() {
        Ok(exponent @ -3..6) => format!("{value:.*}", usize::try_from(3 - exponent).unwrap_or(0)),
        Ok(exponent) => format!("{mantissa}×10{}", superscript(exponent)),
        Err(_) => scientific,
    }
}

/// A power of ten as plain digits or as 10 with an exponent.
pub fn power_of_ten(exponent: i32) -> String {
    match exponent {
        -3..=-1 => format!("{:.*}", exponent.unsigned_abs() as usize, 10f64.powi(exponent)),
        0..=4 => format!("{:.0}", 10f64.powi(exponent)),
        _ => format!("10{}", superscript(exponent)),
    }
}

fn superscript(number: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize]);
    number.to_string().chars().map(raised).collect()
}

/// A length of time in words, "84.4 min".
pub fn time_text(seconds: f64) -> String {
    let (value, name) = match seconds {
        s if s < 120.0 => (s, "s"),
        s if s < 7200.0 => (s / 60.0, "min"),
        s => (s / 3600.0, "h"),
    };
    let rounded = (value * 10.0).round() / 10.0;
    format!("{rounded} {name}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_follow_the_size() {
        for (size, family, name) in [
            (1.2e-8, LENGTH, "nm"),
            (1e-14, LENGTH, "pm"),
            (0.4, LENGTH, "mm"),
            (-850.0, LENGTH, "m"),
            (1852.0, LENGTH, "km"),
            (0.0, LENGTH, "m"),
            (2e-6, SPEED, "µm/s"),
            (0.5, SPEED, "mm/s"),
            (1e-15, ANGLE, "prad"),
            (3e-6, ANGLE, "µrad"),
            (5e-5, ANGLE, "arcsec"),
            (5e-4, ANGLE, "arcmin"),
            (0.02, ANGLE, "deg"),
            (0.0, ANGLE, "deg"),
        ] {
            assert_eq!(fitting(size, family).name, name, "{size}");
        }
    }

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
        assert_eq!(
            (power_of_ten(-2), power_of_ten(3), power_of_ten(-5)),
            ("0.01".into(), "1000".into(), "10⁻⁵".into())
        );
    }

    #[test]
    fn times_in_words() {
        assert_eq!(time_text(5064.0), "84.4 min");
        assert_eq!(time_text(86_400.0), "24 h");
        assert_eq!(time_text(12.5), "12.5 s");
    }
}
