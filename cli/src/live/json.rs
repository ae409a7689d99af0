//! A sample, and what an INS shows, as an object in JSON.

use sins::records::number;
use sins::unit::UnitNavigation;
use sins::units::DEG;

use super::packet::{Refused, Why};
use super::text::{self, COLUMNS};
use sins::truth::FlightSample;

/// The sample in an object with the keys of [`COLUMNS`]. Other keys may have numbers, words or texts, and are ignored.
pub fn decode(datagram: &[u8]) -> Result<FlightSample, Refused> {
    let mut values = [None; COLUMNS.len()];
    let mut rest = expect(text::utf8(datagram)?, '{')?;
    loop {
        let (key, after) = quoted(rest)?;
        let after = expect(after, ':')?;
        let (value, after) = value(after)?;
        if let Some(place) = COLUMNS.iter().position(|column| *column == key) {
            if values[place].is_some() {
                return Err(Refused::new(Why::Syntax, format!("{key}: stands twice")));
            }
            values[place] = Some(text::number(key, value)?);
        }
        let after = after.trim_start();
        match after.strip_prefix(',') {
            Some(next) => rest = next,
            None => {
                rest = expect(after, '}')?.trim();
                break;
            }
        }
    }
    if !rest.is_empty() {
        return Err(Refused::new(Why::Syntax, "more than one object: a datagram has one sample"));
    }
    let missing: Vec<&str> =
        COLUMNS.into_iter().zip(&values).filter(|(_, value)| value.is_none()).map(|(name, _)| name).collect();
    if !missing.is_empty() {
        return Err(Refused::new(Why::Length, format!("missing keys: {}", missing.join(", "))));
    }
    Ok(text::sample(&values.map(Option::unwrap_or_default)))
}

fn expect(text: &str, letter: char) -> Result<&str, Refused> {
    let text = text.trim_start();
    text.strip_prefix(letter).ok_or_else(|| syntax(&letter.to_string(), text))
}

fn syntax(expected: &str, text: &str) -> Refused {
    let found: String = text.chars().take(20).collect();
    Refused::new(Why::Syntax, format!("expected {expected}, found \"{found}\""))
}

/// The text in quotation marks at the beginning, and what follows. No key or word needs an escape.
fn quoted(text: &str) -> Result<(&str, &str), Refused> {
    let inside = expect(text, '"')?;
    match inside.split_once('"') {
        Some((word, after)) if !word.contains('\\') => Ok((word, after)),
        _ => Err(syntax("a text without \\ in quotation marks", text.trim_start())),
    }
}

/// The value at the beginning, and what follows.
fn value(text: &str) -> Result<(&str, &str), Refused> {
    let text = text.trim_start();
    if text.starts_with('"') {
        return quoted(text);
    }
    let end = text.find([',', '}']).unwrap_or(text.len());
    let (value, after) = text.split_at(end);
    if value.starts_with(['{', '[']) || value.is_empty() {
        return Err(syntax("a number or a text", text));
    }
    Ok((value, after))
}

/// What an INS in `state` shows; null is not valid. The keys are those of a sample.
pub fn encode(shown: &UnitNavigation, state: &str) -> String {
    let UnitNavigation { time_s, validity, place, v_n, euler, .. } = shown;
    let values = [
        (true, *time_s),
        (validity.position, place.latitude_rad / DEG),
        (validity.position, place.longitude_rad / DEG),
        (validity.velocity, place.height_m),
        (validity.velocity, v_n.x),
        (validity.velocity, v_n.y),
        (validity.velocity, v_n.z),
        (validity.attitude, euler.roll / DEG),
        (validity.attitude, euler.pitch / DEG),
        (validity.heading, euler.heading / DEG),
    ];
    let members = COLUMNS.into_iter().zip(values).map(|(name, (is_valid, value))| {
        let value = if is_valid { number(value) } else { "null".to_owned() };
        format!("\"{name}\":{value}")
    });
    format!("{{{},\"state\":\"{state}\"}}\n", members.collect::<Vec<_>>().join(","))
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;
    use sins::earth::Geodetic;
    use sins::math::Euler;
    use sins::unit::Validity;

    use super::*;

    const SAMPLE: &str = "\"latitude_deg\":1,\"longitude_deg\":2,\"height_m\":3,\"velocity_east_m_s\":4,\
        \"velocity_north_m_s\":5,\"velocity_up_m_s\":6,\"roll_deg\":7,\"pitch_deg\":8,\"heading_deg\":9";

    #[test]
    fn an_object_is_a_sample() {
        let text = format!("{{ \"time_s\" : -1.5e1 , \"name\": \"x\", {SAMPLE}, \"paused\":false }}\n");
        let sample = decode(text.as_bytes()).unwrap();
        assert_eq!((sample.time_s, sample.v_n), (-15.0, Some(Vector3::new(4.0, 5.0, 6.0))));
        assert_eq!(sample.euler.heading, 9.0 * DEG);
    }

    #[test]
    fn wrong_objects_are_named() {
        for (begin, end, why) in [
            ("{", "}", Why::Length),
            ("{\"time_s\":1,\"time_s\":1,", "}", Why::Syntax),
            ("{\"time_s\":nan,", "}", Why::NotANumber),
            ("{\"time_s\":\"one\",", "}", Why::Syntax),
            ("{\"time_s\":[1],", "}", Why::Syntax),
            ("{\"time_s\":1,", "", Why::Syntax),
            ("{\"time_s\":1,", "}{}", Why::Syntax),
            ("[\"time_s\":1,", "}", Why::Syntax),
            ("{\"time_s\":,", "}", Why::Syntax),
        ] {
            let text = format!("{begin}{SAMPLE}{end}");
            let refused = decode(text.as_bytes()).unwrap_err();
            assert_eq!(refused.why, why, "{text}: {refused:?}");
        }
        for text in ["", "{", "{}", "{\"", "{\"a", "{\"a\"", "{\"a\":", "\u{fffd}"] {
            assert_eq!(decode(text.as_bytes()).unwrap_err().why, Why::Syntax, "{text}");
        }
    }

    /// A sample needs what an INS in navigation shows, so that one can be the input of another.
    #[test]
    fn what_is_shown_can_be_read() {
        let mut shown = UnitNavigation {
            time_s: 2.5,
            place: Geodetic { latitude_rad: 0.5, longitude_rad: -1.0, height_m: 1e-9 },
            v_n: Vector3::new(1.0, 2.0, 3.0),
            euler: Euler { roll: 0.1, pitch: 0.2, heading: 0.3 },
            validity: Validity { rates: true, attitude: true, heading: true, position: true, velocity: true },
            ..UnitNavigation::default()
        };
        let sample = decode(encode(&shown, "navigation").as_bytes()).unwrap();
        assert_eq!((sample.time_s, sample.v_n, sample.place.height_m), (2.5, Some(shown.v_n), 1e-9));
        assert!((sample.place.longitude_rad + 1.0).abs() < 4.0 * f64::EPSILON);
        shown.validity = Validity { rates: true, attitude: true, ..Validity::default() };
        let text = encode(&shown, "fine alignment");
        assert!(text.contains("\"latitude_deg\":null") && text.contains("\"state\":\"fine alignment\""));
        assert_eq!(decode(text.as_bytes()).unwrap_err().why, Why::Syntax);
    }
}
