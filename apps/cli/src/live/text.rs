//! A sample as a line of comma-separated values, which carries its time.

use nalgebra::Vector3;
use sins::earth::Geodetic;
use sins::math::Euler;
use sins::truth::FlightSample;
use sins::units::DEG;

use super::packet::{Refused, Why};

/// The values of a sample, in order: columns of a flight log.
pub const COLUMNS: [&str; 10] = [
    "time_s",
    "latitude_deg",
    "longitude_deg",
    "height_m",
    "velocity_east_m_s",
    "velocity_north_m_s",
    "velocity_up_m_s",
    "roll_deg",
    "pitch_deg",
    "heading_deg",
];

/// The sample in a datagram of one line; its end may be left out.
pub fn decode(datagram: &[u8]) -> Result<FlightSample, Refused> {
    let line = utf8(datagram)?.trim();
    if line.contains('\n') {
        return Err(Refused::new(Why::Syntax, "several lines: a datagram has one sample"));
    }
    let count = line.split(',').count();
    if count != COLUMNS.len() {
        let sentence = format!("{count} values: must be {}, as {}", COLUMNS.len(), COLUMNS.join(","));
        return Err(Refused::new(Why::Length, sentence));
    }
    let mut values = [0.0; COLUMNS.len()];
    for ((value, name), text) in values.iter_mut().zip(COLUMNS).zip(line.split(',')) {
        *value = number(name, text)?;
    }
    Ok(sample(&values))
}

pub fn utf8(datagram: &[u8]) -> Result<&str, Refused> {
    std::str::from_utf8(datagram).map_err(|_| Refused::new(Why::Syntax, "not a text in UTF-8"))
}

/// The number `text` of `name`.
pub fn number(name: &str, text: &str) -> Result<f64, Refused> {
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(value) => Err(Refused::not_a_number(name, value)),
        Err(_) => {
            let found: String = text.trim().chars().take(20).collect();
            Err(Refused::new(Why::Syntax, format!("{name}: expected a number, found \"{found}\"")))
        }
    }
}

/// The sample of values in the order of [`COLUMNS`].
pub fn sample(values: &[f64; COLUMNS.len()]) -> FlightSample {
    let [time_s, latitude, longitude, height_m, east, north, up, roll, pitch, heading] = *values;
    FlightSample {
        time_s,
        place: Geodetic { latitude_rad: latitude * DEG, longitude_rad: longitude * DEG, height_m },
        v_n: Some(Vector3::new(east, north, up)),
        euler: Euler { roll: roll * DEG, pitch: pitch * DEG, heading: heading * DEG },
        omega_ib_b: None,
        f_b: None,
        temperature_c: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_a_sample() {
        let sample = decode(b"12.5, 45,-90,1000,1,2,3,10,-5,270\r\n").unwrap();
        assert_eq!((sample.time_s, sample.place.height_m), (12.5, 1000.0));
        assert_eq!(sample.place.longitude_rad, -90.0 * DEG);
        assert_eq!(sample.v_n, Some(Vector3::new(1.0, 2.0, 3.0)));
        assert_eq!(sample.euler, Euler { roll: 10.0 * DEG, pitch: -5.0 * DEG, heading: 270.0 * DEG });
    }

    #[test]
    fn wrong_lines_are_named() {
        for (line, why, words) in [
            (&b"1,2,3"[..], Why::Length, "3 values: must be 10, as time_s,latitude_deg"),
            (b"", Why::Length, "1 values"),
            (b"1,2,3,4,5,6,7,8,9,10,11", Why::Length, "11 values"),
            (b"1,2,3,nan,5,6,7,8,9,10", Why::NotANumber, "height_m = NaN"),
            (b"1,2,3,4,5,6,7,8,9,inf", Why::NotANumber, "heading_deg = inf"),
            (b"1,2,3,4,5,six,7,8,9,10", Why::Syntax, "velocity_north_m_s: expected a number, found \"six\""),
            (b"1,2,3,4,5,6,7,8,9,10\n1,2,3,4,5,6,7,8,9,10", Why::Syntax, "several lines"),
            (b"\xff\xfe", Why::Syntax, "not a text"),
        ] {
            let refused = decode(line).unwrap_err();
            assert_eq!(refused.why, why, "{refused:?}");
            assert!(refused.sentence.starts_with(words), "{refused:?}");
        }
    }
}
