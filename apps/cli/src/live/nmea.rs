//! Sentences of NMEA 0183 of an INS: talker IN (integrated navigation), fixes as estimated (dead reckoning).

use sins::unit::UnitNavigation;
use sins::units::DEG;

/// Time between sentences of one kind [s].
pub const INTERVAL_S: f64 = 0.2;

/// Knot [m/s].
const KNOT_M_S: f64 = 1852.0 / 3600.0;

/// GGA, RMC and HDT of what an INS shows. Fields that are not valid are empty. The time of day is that of the time stamps.
pub fn sentences(shown: &UnitNavigation) -> String {
    let UnitNavigation { validity, place, v_n, euler, .. } = shown;
    let only = |is_valid: bool, text: String| if is_valid { text } else { String::new() };
    let time = time_of_day(shown.time_s);
    let latitude = only(validity.position, angle(place.latitude_rad, 2, ["N", "S"]));
    let longitude = only(validity.position, angle(wrapped(place.longitude_rad), 3, ["E", "W"]));
    let [latitude, longitude] =
        [latitude, longitude].map(|text| if text.is_empty() { ",".to_owned() } else { text });
    let height = only(validity.velocity, format!("{:.1},M", place.height_m));
    let height = if height.is_empty() { ",".to_owned() } else { height };
    let quality = if validity.position { 6 } else { 0 };
    let speed = only(validity.velocity, format!("{:.2}", v_n.x.hypot(v_n.y) / KNOT_M_S));
    let track = only(validity.velocity, heading(v_n.x.atan2(v_n.y)));
    let [status, mode] = if validity.position { ["A", "E"] } else { ["V", "N"] };
    let north = only(validity.heading, heading(euler.heading));
    [
        format!("INGGA,{time},{latitude},{longitude},{quality},,,{height},,M,,"),
        format!("INRMC,{time},{status},{latitude},{longitude},{speed},{track},,,,{mode}"),
        format!("INHDT,{north},T"),
    ]
    .map(|sentence| checked(&sentence))
    .concat()
}

/// The sentence with its sum and its end.
fn checked(sentence: &str) -> String {
    let sum = sentence.bytes().fold(0, |sum, byte| sum ^ byte);
    format!("${sentence}*{sum:02X}\r\n")
}

/// hhmmss.ss
fn time_of_day(time_s: f64) -> String {
    let hundredths = (time_s * 100.0).round().rem_euclid(8_640_000.0) as u64;
    let seconds = hundredths / 100;
    format!("{:02}{:02}{:02}.{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60, hundredths % 100)
}

/// Degrees and minutes, and the letter of the sign.
fn angle(angle_rad: f64, digits: usize, letters: [&str; 2]) -> String {
    const PER_MINUTE: u64 = 100_000;
    let units = (angle_rad.abs() / DEG * 60.0 * PER_MINUTE as f64).round() as u64;
    let (minutes, rest) = (units / PER_MINUTE, units % PER_MINUTE);
    let letter = letters[usize::from(angle_rad < 0.0)];
    format!("{:0digits$}{:02}.{rest:05},{letter}", minutes / 60, minutes % 60)
}

/// The angle from -π to π.
fn wrapped(angle_rad: f64) -> f64 {
    let turn = 2.0 * std::f64::consts::PI;
    angle_rad - turn * (angle_rad / turn).round()
}

/// Degrees from 0 to 359.99.
fn heading(angle_rad: f64) -> String {
    // Adding 0 turns -0 into 0.
    let hundredths = (angle_rad / DEG * 100.0).round().rem_euclid(36_000.0) + 0.0;
    format!("{:.2}", hundredths / 100.0)
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;
    use sins::earth::Geodetic;
    use sins::math::Euler;
    use sins::unit::Validity;

    use super::*;

    const ALL: Validity =
        Validity { rates: true, attitude: true, heading: true, position: true, velocity: true };

    /// The sums are those of an exclusive or by hand; 48°07.038' N, 11°31' E is the usual example of the sentences.
    #[test]
    fn sentences_are_those_written_by_hand() {
        let shown = UnitNavigation {
            time_s: 86_400.0 + 12.0 * 3600.0 + 35.0 * 60.0 + 19.0,
            validity: ALL,
            place: Geodetic {
                latitude_rad: (48.0 + 7.038 / 60.0) * DEG,
                longitude_rad: (11.0 + 31.0 / 60.0) * DEG,
                height_m: 545.4,
            },
            v_n: Vector3::new(-KNOT_M_S * 22.4, 0.0, 1.0),
            euler: Euler { heading: 2.0 * std::f64::consts::PI - 1e-9, ..Euler::default() },
            ..UnitNavigation::default()
        };
        let lines = sentences(&shown);
        let bodies: Vec<&str> = lines.lines().map(|line| line.split('*').next().unwrap()).collect();
        assert_eq!(
            bodies,
            [
                "$INGGA,123519.00,4807.03800,N,01131.00000,E,6,,,545.4,M,,M,,",
                "$INRMC,123519.00,A,4807.03800,N,01131.00000,E,22.40,270.00,,,,E",
                "$INHDT,0.00,T"
            ]
        );
        for line in lines.split_terminator("\r\n") {
            let (body, sum) = line[1..].split_once('*').unwrap();
            assert_eq!(u8::from_str_radix(sum, 16).unwrap(), body.bytes().fold(0, |sum, byte| sum ^ byte));
            assert!(line.len() <= 80, "{line}");
        }
        assert!(checked("GPHDT,0.00,T").starts_with("$GPHDT,0.00,T*"));
    }

    #[test]
    fn minutes_are_below_sixty_and_the_south_west_has_its_letters() {
        assert_eq!(angle(-(33.0 + 59.999_999_9 / 60.0) * DEG, 2, ["N", "S"]), "3400.00000,S");
        assert_eq!(angle(wrapped(200.0 * DEG), 3, ["E", "W"]), "16000.00000,W");
        assert_eq!(time_of_day(-0.001), "000000.00");
        assert_eq!(time_of_day(59.999), "000100.00");
        assert_eq!(heading(-1e-9), "0.00");
    }

    #[test]
    fn what_is_not_valid_is_empty() {
        let shown = UnitNavigation { time_s: 1.0, ..UnitNavigation::default() };
        let lines = sentences(&shown);
        let bodies: Vec<&str> = lines.lines().map(|line| line.split('*').next().unwrap()).collect();
        assert_eq!(bodies, ["$INGGA,000001.00,,,,,0,,,,,,M,,", "$INRMC,000001.00,V,,,,,,,,,,N", "$INHDT,,T"]);
    }
}
