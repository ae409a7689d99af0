//! Units chosen by size, and numbers as text.

pub use sins::figures::{MICRO_G, Unit, digits, significant, superscript, two_digits};
pub use sins::records::rounded;
use sins::units::{ARCSEC, DEG};

const fn unit(name: &'static str, si: f64) -> Unit {
    Unit { name, si }
}

/// Metre.
pub const METRE: Unit = unit("m", 1.0);
/// Kilometre.
pub const KILOMETRE: Unit = unit("km", 1e3);

/// Units of one quantity, from small to large. There is no nm, because beside positions it would be read as nautical miles.
#[derive(Debug, PartialEq)]
pub struct Family {
    /// SI unit: for zero, and in texts for values far below all other units.
    pub si: Unit,
    /// Units of axes for values that are only rounding.
    pub tiny: &'static [Unit],
    pub usual: &'static [Unit],
}

/// Units of length.
pub const LENGTH: &Family = &Family {
    si: METRE,
    tiny: &[unit("10⁻¹² m", 1e-12), unit("10⁻⁹ m", 1e-9)],
    usual: &[unit("µm", 1e-6), unit("mm", 1e-3), METRE, KILOMETRE],
};

/// Units of speed.
pub const SPEED: &Family = &Family {
    si: unit("m/s", 1.0),
    tiny: &[unit("10⁻¹⁵ m/s", 1e-15), unit("10⁻¹² m/s", 1e-12), unit("10⁻⁹ m/s", 1e-9)],
    usual: &[unit("µm/s", 1e-6), unit("mm/s", 1e-3), unit("m/s", 1.0)],
};

/// Units of angle, for attitude errors.
pub const ANGLE: &Family = &Family {
    si: unit("rad", 1.0),
    tiny: &[unit("10⁻¹⁵ rad", 1e-15), unit("10⁻¹² rad", 1e-12)],
    usual: &[unit("nrad", 1e-9), unit("arcsec", ARCSEC), unit("deg", DEG)],
};

/// Degree per hour [rad/s].
pub const DEG_PER_HOUR: Unit = unit("deg/h", sins::units::DEG_PER_HOUR);

/// Nautical mile per hour [m/s].
pub const NMI_PER_HOUR: Unit = unit("nmi/h", sins::units::NMI_PER_HOUR);

/// The family of an SI unit.
pub fn family(si_name: &str) -> Option<&'static Family> {
    [LENGTH, SPEED, ANGLE].into_iter().find(|family| family.si.name == si_name)
}

/// The largest unit of which `size` [SI] is at least one, otherwise the smallest unit; the SI unit for zero.
pub fn fitting(size: f64, family: &Family) -> Unit {
    let mut units = family.tiny.iter().chain(family.usual);
    let smallest = if size == 0.0 { None } else { units.clone().next() };
    units.rfind(|unit| size.abs() >= unit.si).or(smallest).copied().unwrap_or(family.si)
}

/// The unit of one of several axes: the unit of the `largest` axis, unless this axis is so small that its ticks would be fractions.
pub fn fitting_axis(size: f64, largest: f64, family: &Family) -> Unit {
    fitting(if size < 0.05 * largest { size } else { largest }, family)
}

/// `value` [SI] in the usual unit that fits it, "12.35 km"; in the SI unit with a power of ten if no usual unit fits.
pub fn with_unit(value: f64, family: &Family) -> String {
    in_unit(value, usual(value, family))
}

/// Four digits of `value` [SI] in `unit`.
pub fn in_unit(value: f64, unit: Unit) -> String {
    format!("{} {}", significant(value / unit.si), unit.name)
}

/// The largest usual unit of which `value` [SI] is at least one; otherwise the SI unit.
pub fn usual(value: f64, family: &Family) -> Unit {
    family.usual.iter().rfind(|unit| value.abs() >= unit.si).copied().unwrap_or(family.si)
}

/// Two significant digits, or all before the point; powers of ten where plain digits would be long.
pub fn short(value: f64) -> String {
    if (1e-3..1e6).contains(&value.abs()) { two_digits(value) } else { digits(value, 1) }
}

/// `value` [SI] with two digits in the usual unit that fits it, or in the SI unit.
pub fn brief(value: f64, family: &Family) -> String {
    let unit = usual(value, family);
    format!("{} {}", short(value / unit.si), unit.name)
}

/// Position [m], velocity [m/s] and attitude [rad], each by [`brief`].
pub fn brief_parts(parts: [f64; 3]) -> String {
    let [position, velocity, attitude] = parts;
    [brief(position, LENGTH), brief(velocity, SPEED), brief(attitude, ANGLE)].join(", ")
}

/// `value` with six significant digits.
pub fn six_digits(value: f64) -> f64 {
    rounded(value, 6)
}

/// A power of ten as plain digits or as 10 with an exponent.
pub fn power_of_ten(exponent: i32) -> String {
    match exponent {
        -3..=-1 => format!("{:.*}", exponent.unsigned_abs() as usize, 10f64.powi(exponent)),
        0..=4 => format!("{:.0}", 10f64.powi(exponent)),
        _ => format!("10{}", superscript(exponent)),
    }
}

/// A time to the microsecond, "329.98 s", as an option takes it.
pub fn stamp_text(seconds: f64) -> String {
    format!("{} s", (seconds * 1e6).round() / 1e6)
}

/// A duration as text, "84.4 min".
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
            (1.2e-8, LENGTH, "10⁻⁹ m"),
            (1e-14, LENGTH, "10⁻¹² m"),
            (0.4, LENGTH, "mm"),
            (-850.0, LENGTH, "m"),
            (1852.0, LENGTH, "km"),
            (0.0, LENGTH, "m"),
            (2e-6, SPEED, "µm/s"),
            (0.5, SPEED, "mm/s"),
            (2e-15, ANGLE, "10⁻¹⁵ rad"),
            (3e-6, ANGLE, "nrad"),
            (5e-4, ANGLE, "arcsec"),
            (0.02, ANGLE, "deg"),
            (0.0, ANGLE, "rad"),
        ] {
            assert_eq!(fitting(size, family).name, name, "{size}");
        }
    }

    #[test]
    fn what_rounding_leaves_is_a_power_of_ten_of_the_si_unit() {
        assert_eq!(with_unit(0.002_16, ANGLE), "445.5 arcsec");
        assert_eq!(with_unit(2.5e-12, ANGLE), "2.500×10⁻¹² rad");
        assert_eq!(with_unit(2.931e-8, LENGTH), "2.931×10⁻⁸ m");
        assert_eq!(with_unit(2.5e-15, ANGLE), "2.500×10⁻¹⁵ rad");
        assert_eq!(with_unit(2.22e-27, SPEED), "2.220×10⁻²⁷ m/s");
        assert_eq!(with_unit(0.0, SPEED), "0 m/s");
    }

    /// Readers from navigation read nm as a nautical mile.
    #[test]
    fn no_unit_looks_like_a_nautical_mile() {
        for family in [LENGTH, SPEED, ANGLE] {
            for unit in family.tiny.iter().chain(family.usual) {
                assert!(!unit.name.starts_with("nm"), "{}", unit.name);
            }
        }
    }

    #[test]
    fn powers_of_ten_are_plain_or_raised() {
        assert_eq!(
            (power_of_ten(-2), power_of_ten(3), power_of_ten(-5)),
            ("0.01".into(), "1000".into(), "10⁻⁵".into())
        );
    }

    #[test]
    fn brief_has_two_digits() {
        for (value, family, text) in [
            (1234.0, LENGTH, "1.2 km"),
            (0.84, LENGTH, "840 mm"),
            (-9.96e-6, SPEED, "-10 µm/s"),
            (9.1e-12, SPEED, "9.1×10⁻¹² m/s"),
            (2.93e-8, LENGTH, "2.9×10⁻⁸ m"),
            (2.65e-15, ANGLE, "2.7×10⁻¹⁵ rad"),
            (0.0, ANGLE, "0 rad"),
        ] {
            assert_eq!(brief(value, family), text);
        }
    }

    #[test]
    fn times_in_words() {
        assert_eq!(time_text(5064.0), "84.4 min");
        assert_eq!(time_text(86_400.0), "24 h");
        assert_eq!(time_text(12.5), "12.5 s");
    }
}
