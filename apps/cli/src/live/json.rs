//! A sample, and what an INS shows, as an object in JSON.

use sins::records::number;
use sins::scene::listed;
use sins::unit::UnitNavigation;
use sins::units::DEG;

use super::packet::{Refused, Why};
use super::text::{self, COLUMNS};
use sins::truth::FlightSample;

/// The sample in an object with the keys of [`COLUMNS`]. Other keys may have any value, and are ignored.
pub fn decode(datagram: &[u8]) -> Result<FlightSample, Refused> {
    let mut values = [None; COLUMNS.len()];
    let mut others = Vec::new();
    let mut rest = expect(text::utf8(datagram)?, '{')?;
    loop {
        let (key, after) = quoted(rest).ok_or_else(|| syntax("expected a key in quotation marks", rest))?;
        let after = expect(after, ':')?;
        let (value, after) =
            value(after).map_err(|what| syntax(&format!("{key}: expected {what}"), after))?;
        match COLUMNS.iter().position(|column| *column == key) {
            Some(place) if values[place].is_some() => {
                return Err(Refused::new(Why::Syntax, format!("{key}: stands twice")));
            }
            Some(place) => values[place] = Some(text::number(key, value)?),
            None => others.push(key),
        }
        let after = after.trim_start();
        match after.strip_prefix(',') {
            Some(next) => rest = next,
            None => {
                let end = after.strip_prefix('}');
                rest =
                    end.ok_or_else(|| syntax(&format!("{key}: expected , or }} behind it"), after))?.trim();
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
        let found =
            if others.is_empty() { String::new() } else { format!("; found {}", listed(others.into_iter())) };
        return Err(Refused::new(Why::Length, format!("missing keys: {}{found}", missing.join(", "))));
    }
    Ok(text::sample(&values.map(Option::unwrap_or_default)))
}

fn expect(text: &str, letter: char) -> Result<&str, Refused> {
    let text = text.trim_start();
    text.strip_prefix(letter).ok_or_else(|| syntax(&format!("expected {letter}"), text))
}

fn syntax(expected: &str, text: &str) -> Refused {
    let found: String = text.trim_start().chars().take(20).collect();
    Refused::new(Why::Syntax, format!("{expected}, found \"{found}\""))
}

/// The text in quotation marks at the beginning, with its escapes, and what follows.
fn quoted(text: &str) -> Option<(&str, &str)> {
    let inside = text.trim_start().strip_prefix('"')?;
    let mut is_escaped = false;
    let end = inside.find(|letter: char| {
        let is_end = letter == '"' && !is_escaped;
        is_escaped = letter == '\\' && !is_escaped;
        is_end
    })?;
    Some((&inside[..end], &inside[end + 1..]))
}

/// The value at the beginning, and what follows; or what was expected.
fn value(text: &str) -> Result<(&str, &str), &'static str> {
    let text = text.trim_start();
    match text.chars().next() {
        Some('"') => quoted(text).ok_or("a text that ends with a quotation mark"),
        Some('{' | '[') => nested(text).ok_or("a value whose brackets are closed"),
        _ => {
            let end = text.find([',', '}']).unwrap_or(text.len());
            if text[..end].trim().is_empty() { Err("a value") } else { Ok(text.split_at(end)) }
        }
    }
}

/// The object or the array at the beginning, and what follows.
fn nested(text: &str) -> Option<(&str, &str)> {
    let mut open = Vec::new();
    let mut rest = text;
    loop {
        rest = &rest[rest.find(['{', '[', '}', ']', '"'])?..];
        if rest.starts_with('"') {
            rest = quoted(rest)?.1;
            continue;
        }
        match rest.as_bytes()[0] {
            b'{' => open.push(b'}'),
            b'[' => open.push(b']'),
            bracket if open.pop() == Some(bracket) => {}
            _ => return None,
        }
        rest = &rest[1..];
        if open.is_empty() {
            return Some(text.split_at(text.len() - rest.len()));
        }
    }
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

    /// Whatever stands under a key that is not ours, before, between and behind ours.
    #[test]
    fn keys_of_others_have_any_value() {
        let plain = decode(format!("{{\"time_s\":1,{SAMPLE}}}").as_bytes()).unwrap();
        for value in [
            "0",
            "-1.5e-3",
            "NaN",
            "-Infinity",
            "true",
            "null",
            "\"\"",
            "\"a, b}\"",
            r#""with \" and \\""#,
            r#""\u00e9\n""#,
            "[]",
            "{}",
            "[ 1 , [2,{}], \"]\" ]",
            r#"{"gyro":[0.1,-0.2],"name":"}\"{","deep":{"a":{"b":[[[]]]}}}"#,
            "{ \"time_s\" : 7 }",
        ] {
            for (begin, end) in [
                (format!("{{\"imu\":{value},\"time_s\":1,"), "}".to_owned()),
                ("{\"time_s\":1,".to_owned(), format!(",\"a \\\" b\" : {value} \n}}")),
            ] {
                let text = format!("{begin}{SAMPLE}{end}");
                assert_eq!(decode(text.as_bytes()), Ok(plain), "{text}");
            }
        }
        let deep = format!("{{\"a\":{}{},\"time_s\":1,{SAMPLE}}}", "[".repeat(30_000), "]".repeat(30_000));
        assert_eq!(decode(deep.as_bytes()), Ok(plain));
    }

    #[test]
    fn messages_name_the_key() {
        for (begin, words) in [
            ("{\"imu\":{\"gyro\":0,", "imu: expected , or } behind it, found \"\""),
            (
                "{\"imu\":{\"gyro\":[0,",
                "imu: expected a value whose brackets are closed, found \"{\"gyro\":[0",
            ),
            ("{\"imu\":[},", "imu: expected a value whose brackets are closed"),
            ("{\"note\":\"a,", "note: expected , or } behind it, found"),
            ("{\"note\":,", "note: expected a value, found"),
            ("{\"time_s\":{\"s\":1},", "time_s: expected a number, found \"{\"s\":1}\""),
            ("{\"time_s\":[1,2],", "time_s: expected a number, found \"[1,2]\""),
            ("{\"time_s\":null,", "time_s: expected a number, found \"null\""),
            ("{\"time\":1,\"attitude\":{},", "missing keys: time_s; found time, attitude"),
        ] {
            let refused = decode(format!("{begin}{SAMPLE}}}").as_bytes()).unwrap_err();
            assert!(refused.sentence.starts_with(words), "{begin}: {refused:?}");
        }
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
