//! The table of sensor parameters against its own texts: the factor of each data-sheet unit agrees with the unit's text, and the
//! unit has the dimension of the SI unit.

use nalgebra::Matrix3;
use sins::sensors::{PARAMETERS, ParameterRange, Sensor, TriadParameters};

/// Size in SI units, and twice the exponents of rad, m, s, K: square roots have half exponents.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Unit {
    si: f64,
    twice: [i32; 4],
}

const ONE: Unit = Unit { si: 1.0, twice: [0; 4] };

impl Unit {
    fn named(name: &str) -> Self {
        let degree = std::f64::consts::PI / 180.0;
        let (si, twice) = match name {
            "" => (1.0, [0; 4]),
            "ppm" => (1e-6, [0; 4]),
            "rad" => (1.0, [2, 0, 0, 0]),
            "deg" => (degree, [2, 0, 0, 0]),
            "arcsec" => (degree / 3600.0, [2, 0, 0, 0]),
            "m" => (1.0, [0, 2, 0, 0]),
            "mm" => (1e-3, [0, 2, 0, 0]),
            "g" => (9.80665, [0, 2, -4, 0]),
            "micro-g" => (9.80665e-6, [0, 2, -4, 0]),
            "s" => (1.0, [0, 0, 2, 0]),
            "h" => (3600.0, [0, 0, 2, 0]),
            "Hz" => (1.0, [0, 0, -2, 0]),
            "K" | "deg C" => (1.0, [0, 0, 0, 2]),
            "1" => (1.0, [0; 4]),
            _ => panic!("{name}: no unit"),
        };
        Self { si, twice }
    }

    fn power(self, twice_exponent: i32) -> Self {
        let si = self.si.powf(f64::from(twice_exponent) / 2.0);
        Self { si, twice: self.twice.map(|twice| twice * twice_exponent / 2) }
    }

    fn over(self, other: Self) -> Self {
        Self { si: self.si / other.si, twice: std::array::from_fn(|i| self.twice[i] - other.twice[i]) }
    }

    /// Parses terms with "/" between them, from the left: "deg/h/sqrt(h)", "(rad/s)/(m/s2)^2".
    fn of(text: &str) -> Self {
        let (mut depth, mut start, mut terms) = (0, 0, Vec::new());
        for (at, letter) in text.char_indices() {
            depth += i32::from(letter == '(') - i32::from(letter == ')');
            if letter == '/' && depth == 0 {
                terms.push(&text[start..at]);
                start = at + 1;
            }
        }
        terms.push(&text[start..]);
        terms.into_iter().map(Self::term).reduce(Self::over).unwrap()
    }

    /// Parses a name or a text in parentheses, with a digit as exponent after it or a root before it.
    fn term(text: &str) -> Self {
        let exponent = text.chars().last().and_then(|letter| letter.to_digit(10)).filter(|_| text != "1");
        match (exponent, text.strip_prefix("sqrt(")) {
            (Some(digit), _) => {
                Self::term(text[..text.len() - 1].trim_end_matches('^')).power(2 * digit as i32)
            }
            (_, Some(rest)) => Self::of(rest.strip_suffix(')').unwrap()).power(1),
            _ => match text.strip_prefix('(') {
                Some(rest) => Self::of(rest.strip_suffix(')').unwrap()),
                None => Self::named(text),
            },
        }
    }
}

#[test]
fn data_sheet_units_are_what_their_texts_say() {
    let (mut count, limit, mut roundings) = (0, 8.0, 0.0_f64);
    for (parameter, sensor) in
        PARAMETERS.iter().flat_map(|row| [Sensor::Gyro, Sensor::Accelerometer].map(|sensor| (row, sensor)))
    {
        let Some(field) = parameter.of(sensor) else { continue };
        let (unit, key) = (Unit::of(field.unit), Unit::of(field.key_unit));
        assert_eq!(unit.si, ONE.si, "{}: [{}] is not SI", field.path, field.unit);
        assert_eq!(unit.twice, key.twice, "{}: [{}], [{}]", field.path, field.unit, field.key_unit);
        let off = (field.key_si / key.si - 1.0).abs();
        assert!(off < limit * f64::EPSILON, "{}: {:e}", field.path, field.key_si);
        roundings = roundings.max(off / f64::EPSILON);
        count += 1;
    }
    println!("figure: {count} units within {roundings} roundings (limit {limit})");
    assert!(count > 40, "{count}");
}

/// A definition reads as part of a sentence, an effect begins with its sensor's name, and a time has its standard deviation.
#[test]
fn names_are_whole() {
    for parameter in PARAMETERS {
        let fields = [parameter.gyro, parameter.accel];
        for doc in fields.iter().flatten().map(|field| parameter.doc_of(field)).chain([parameter.doc]) {
            assert!(doc.starts_with(|letter: char| letter.is_ascii_lowercase()), "{doc}");
            assert!(!doc.ends_with('.') && doc.is_ascii() && parameter.note.is_ascii(), "{doc}");
        }
        assert!(parameter.note.is_empty() || parameter.note.ends_with('.'), "{}", parameter.name);
        for (field, sensor) in [(parameter.gyro, "gyro"), (parameter.accel, "accel")] {
            let Some(field) = field else { continue };
            assert!(field.path.starts_with(&format!("{sensor}.")), "{}", field.path);
            assert!(field.effect.is_empty() || field.effect.starts_with(sensor), "{}", field.effect);
            let (low, high) = field.range.ends();
            assert!(low < high, "{}", field.path);
            if let ParameterRange::TimeOf(sigma, ..) = field.range {
                assert!(PARAMETERS.iter().any(|row| row.name == sigma), "{sigma}");
            }
        }
    }
}

fn sentence(set: impl FnOnce(&mut TriadParameters), sensor: Sensor) -> String {
    let mut parameters = TriadParameters::default();
    set(&mut parameters);
    parameters.validate(sensor).unwrap_err().to_string()
}

#[test]
fn a_term_of_the_other_kind_of_sensor_is_refused() {
    let mut arm = TriadParameters::default();
    arm.lever_arm_m[(1, 2)] = -0.5;
    assert!(arm.validate(Sensor::Accelerometer).is_ok());
    assert_eq!(
        arm.validate(Sensor::Gyro).unwrap_err().to_string(),
        "lever_arm_m[5] = -0.5: must be 0: it is a parameter of the other kind of sensor"
    );
    let unbalance = TriadParameters { g_sensitivity: Matrix3::identity(), ..Default::default() };
    assert!(unbalance.validate(Sensor::Gyro).is_ok() && unbalance.validate(Sensor::Accelerometer).is_err());
}

#[test]
fn the_sentence_says_that_0_is_none_and_which_sigma_needs_a_time() {
    assert_eq!(
        sentence(|p| p.range.y = -1.0, Sensor::Accelerometer),
        "accel.range_m_s2[1] = -1: must be 0 for none, or from 1e-9 to 1000000"
    );
    assert_eq!(
        sentence(|p| p.markov_sigma.z = 1e-3, Sensor::Gyro),
        "gyro.markov_time_s[2] = 0: must be from 1e-9 to 1e15 where gyro.markov_sigma_rad_s is not 0"
    );
    assert_eq!(
        sentence(|p| p.markov_time_s.x = -3.0, Sensor::Gyro),
        "gyro.markov_time_s[0] = -3: must be from 0 to 1e15"
    );
    assert_eq!(
        sentence(|p| p.misalignment_sigma[(1, 1)] = 1e-3, Sensor::Accelerometer),
        "accel.misalignment_sigma_rad[4] = 0.001: must be 0 on the diagonal; use scale_factor_sigma"
    );
}
