//! Attitudes whose unit or whose sense nothing states.

use super::super::words::words;
use super::motion::{Motion, READINGS, Reading};
use super::{ATTITUDE, Draft, QUATERNION, Question, largest};
use crate::base::text::excerpt;
use crate::base::units::DEG;

/// Largest angle between heading and track of a reading that fits \[rad\]: wind, and a heading that may be magnetic.
pub const FITS: f64 = 25.0 * DEG;

/// The same of a flight that does not turn, whose track may be off its heading by chance \[rad\].
const FITS_STRAIGHT: f64 = 5.0 * DEG;

/// A reading fits better than another one if its angle is smaller by this factor.
pub const BETTER: f64 = 3.0;

/// A quarter of a turn.
pub const QUARTER: f64 = core::f64::consts::FRAC_PI_2;

/// Words of the names of columns that look like each angle, and those that make another one of them.
const LIKE: [(&str, &[&str], &[&str]); 3] = [
    ("roll", &["roll", "bank", "roulis", "alabeo", "rollio", "wanken", "phi"], &[]),
    ("pitch", &["pitch", "tangage", "cabeceo", "beccheggio", "nick", "theta"], &["trim"]),
    ("heading", &["heading", "yaw", "hdg", "azimuth", "cap", "rumbo", "psi"], &["gps", "track"]),
];

/// Words of the names of columns that are no angles of the vehicle.
const NOT_ANGLES: [&str; 20] = [
    "rate", "speed", "vel", "acc", "accel", "cmd", "command", "target", "des", "desired", "std", "sigma",
    "error", "err", "wind", "gimbal", "trim", "rc", "in", "bug",
];

impl Draft<'_> {
    /// The unit of an attitude that states none and has no angle above a turn in radians: the one in which the heading follows the track. A
    /// heading that follows the track when it counts from the east is asked about, since the pitch may have another sign then too.
    pub(super) fn attitude(&mut self) {
        if !self.has_all(&ATTITUDE) {
            return;
        }
        let is_stated = |key: &&str| self.found(key).is_some_and(|found| !found.unit.is_empty());
        let is_open = !ATTITUDE.iter().any(is_stated);
        let angles: Vec<f64> = ATTITUDE.iter().filter_map(|key| self.numbers(key)).flatten().collect();
        let is_small = is_open
            && ATTITUDE.iter().all(|key| largest(&self.numbers(key).unwrap_or_default()) <= 4.0 * QUARTER)
            && angles.iter().any(|angle| angle.fract() != 0.0);
        let si = |unit: &str| if unit == "rad" { 1.0 } else { DEG };
        let stated = self.found("heading").map_or("", |found| found.unit);
        let units: &[&str] = if is_small { &["", "rad"] } else { &[stated] };
        let reading = self.reading();
        let is_place = |motion: &Motion| motion.first_place(reading, false).is_some();
        let motion = self.motion().filter(is_place);
        let turn = |unit: &str, of_heading: fn(f64) -> f64| {
            let turn = motion.as_ref()?.turn(reading, |heading| of_heading(heading * si(unit)));
            turn.filter(|turn| turn.is_finite())
        };
        let compass: Vec<Option<f64>> = units.iter().map(|unit| turn(unit, |heading| heading)).collect();
        let east: Vec<Option<f64>> =
            units.iter().map(|unit| turn(unit, |heading| QUARTER - heading)).collect();
        let least = |turns: &[Option<f64>]| turns.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        let [of_compass, of_east] = [least(&compass), least(&east)];
        let is_turning = motion.as_ref().is_some_and(|motion| motion.turns(reading));
        let is_followed = of_east < if is_turning { FITS } else { FITS_STRAIGHT };
        if of_compass > FITS && BETTER * of_east < of_compass && is_followed {
            let fits = units.iter().zip(&east).filter(|(_, turn)| turn.is_some_and(|turn| turn < FITS));
            let units: Vec<&str> = fits.map(|(unit, _)| *unit).collect();
            return self.ask_for_attitude(
                &units,
                "the heading follows the track if it counts from the east, anticlockwise",
            );
        }
        if !is_small {
            return;
        }
        // Those from the east have no unit here.
        let mut turns: Vec<(&str, f64)> = ["deg", "rad"]
            .into_iter()
            .zip(&compass)
            .chain(["", ""].into_iter().zip(&east))
            .filter_map(|(unit, turn)| Some((unit, (*turn)?)))
            .collect();
        turns.sort_by(|(_, one), (_, other)| one.total_cmp(other));
        let unit = match turns[..] {
            [(unit, best), (_, next), ..] if best < FITS && BETTER * best < next && !unit.is_empty() => unit,
            [] if self.is_position_in_radians() => "rad",
            _ => {
                return self
                    .ask_for_attitude(units, "no angle of the attitude is above 6.28: are they radians?");
            }
        };
        self.take_attitude(unit);
    }

    /// Reads the attitude in this unit, and says so.
    fn take_attitude(&mut self, unit: &str) {
        for key in ATTITUDE {
            let Some(place) = self.place(key) else { continue };
            let part = if unit == "rad" { ", unit = \"rad\"" } else { "" };
            self.replace(key, self.column(place, part));
            let name = excerpt(&self.grid.names[place]);
            let words = if unit == "rad" { "radians" } else { "degrees" };
            self.doubt(format!("{name} is taken as {words}: no angle of the attitude is above 6.28, and the heading follows the track"));
        }
    }

    /// Asks about columns that look like an attitude where none is read: another unit, another name.
    pub(super) fn attitude_like(&mut self) {
        let is_read = self.has_all(&ATTITUDE) || self.has_all(&QUATERNION) || self.is_attitude_asked;
        if is_read || self.value("attitude").is_some() {
            return;
        }
        let found = LIKE.map(|(key, like, unlike)| {
            let is_like = |place: &usize| {
                let words = words(&self.grid.names[*place]);
                let is_in = |known: &[&str]| words.iter().any(|word| known.contains(&word.as_str()));
                is_in(like) && !is_in(&NOT_ANGLES) && !is_in(unlike) && self.has_numbers(*place)
            };
            self.place(key).or_else(|| (0..self.grid.names.len()).find(is_like))
        });
        let [Some(roll), Some(pitch), Some(heading)] = found else { return };
        let places = [roll, pitch, heading];
        let angles = places.map(|place| largest(&self.grid.numbers(place)));
        let of_unit = |part: &str, words: &str| {
            let lines: Vec<String> = ATTITUDE
                .iter()
                .zip(places)
                .map(|(key, place)| format!("{key} = {}", self.column(place, part)))
                .collect();
            format!("{}  # {words}", lines.join("\n"))
        };
        let mut answers = vec![of_unit("", "degrees")];
        if angles.iter().all(|angle| *angle <= 4.0 * QUARTER) {
            answers.push(of_unit(", unit = \"rad\"", "radians"));
        }
        if angles.iter().any(|angle| *angle > 400.0) {
            answers.push(of_unit(", scale = 0.01", "hundredths of a degree"));
            answers.push(of_unit(", unit = \"rad\", scale = 0.001", "thousandths of a radian"));
        }
        answers.push("attitude = \"coordinated\"  # they are something else".to_owned());
        let names = places.map(|place| excerpt(&self.grid.names[place]));
        for key in ATTITUDE {
            self.remove(key);
        }
        self.is_attitude_asked = true;
        let sentence = format!("are {}, {} and {} the attitude?", names[0], names[1], names[2]);
        self.ask(Question { sentence, answers });
    }

    pub(super) fn is_position_in_radians(&self) -> bool {
        self.value("latitude").is_some_and(|value| value.contains("\"rad\""))
    }

    /// How the position is read.
    pub(super) fn reading(&self) -> &'static Reading {
        &READINGS[if self.is_position_in_radians() { READINGS.len() - 1 } else { self.reading }]
    }

    fn ask_for_attitude(&mut self, units: &[&str], sentence: &str) {
        let [Some(roll), Some(pitch), Some(heading)] = ATTITUDE.map(|key| self.place(key)) else { return };
        let mut answers = Vec::new();
        for unit in units.iter().rev() {
            let part = if unit.is_empty() { String::new() } else { format!(", unit = \"{unit}\"") };
            let roll = self.column(roll, &part);
            for (pitch_part, heading_part, words) in [
                ("", "", "clockwise from north"),
                ("", ", sign = -1, add = 90", "anticlockwise from east"),
                (
                    ", sign = -1",
                    ", sign = -1, add = 90",
                    "anticlockwise from east; the pitch is positive nose down",
                ),
            ] {
                let pitch = self.column(pitch, &format!("{part}{pitch_part}"));
                let heading = self.column(heading, &format!("{part}{heading_part}"));
                let unit = if *unit == "rad" { "radians" } else { "degrees" };
                answers
                    .push(format!("roll = {roll}\npitch = {pitch}\nheading = {heading}  # {unit}, {words}"));
            }
        }
        for key in ATTITUDE {
            self.remove(key);
        }
        self.is_attitude_asked = true;
        self.ask(Question { sentence: sentence.to_owned(), answers });
    }
}
