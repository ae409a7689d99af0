//! A look at a table: the `[log]` that reads it, of a known format or guessed from names, units and values.

use super::guess::{guess, unit};
use super::known::{KNOWN, Known};
use super::quantity::{Dimension, QUANTITIES, unit_of};
use super::{Clock, LogMapping, Separator, TimeFormat};
use crate::base::math::{hypot, sin_cos};
use crate::base::units::DEG;
use crate::scene::excerpt;
use crate::scene::written::text_in_quotes;

/// What a table has.
#[derive(Debug, Clone, PartialEq)]
pub struct Survey {
    /// The format, if it is a known one.
    pub format: Option<&'static str>,
    /// Lines of `[log]`.
    pub text: String,
    /// What is not sure, in sentences.
    pub doubts: Vec<String>,
}

/// Lines in which the names are looked for, and rows whose values are looked at.
const LINES: usize = 20;
const ROWS: usize = 5000;

/// Fewest columns with a name that says its quantity.
const FEWEST: usize = 3;

/// Speeds over ground of vehicles [m/s], and the radius of the Earth [m], for comparisons.
const SPEEDS: core::ops::RangeInclusive<f64> = 0.3..=1000.0;
const RADIUS_M: f64 = 6.371e6;

/// Largest radian of a latitude.
const QUARTER: f64 = core::f64::consts::FRAC_PI_2;

/// A table, as it is cut into cells.
struct Grid<'t> {
    separator: Separator,
    /// The line of the names, from 1.
    header: usize,
    names: Vec<&'t str>,
    /// The lines of units, above or below the names.
    units: Vec<Vec<&'t str>>,
    /// Rows behind the names that are none.
    skip: usize,
    rows: Vec<Vec<&'t str>>,
}

/// The `[log]` of a table; `None`: no line at its beginning has names of quantities.
pub fn survey(table: &str) -> Option<Survey> {
    let grid = Grid::of(table)?;
    let mut survey = Survey { format: None, text: String::new(), doubts: Vec::new() };
    match known(&grid.names) {
        Some(known) => grid.of_known(known, &mut survey),
        None => grid.guessed(&mut survey),
    }
    grid.complete(&mut survey);
    let rate_hz = grid.layout(&mut survey);
    let has =
        |survey: &Survey, key: &str| survey.text.lines().any(|line| line.starts_with(&format!("{key} =")));
    if !has(&survey, "attitude") && ["roll", "pitch", "heading"].iter().any(|key| !has(&survey, key)) {
        survey.text.push_str("attitude = \"coordinated\"\n");
        survey
            .doubts
            .push("the table has no attitude: that of a coordinated flight without wind is taken".to_owned());
    }
    let is_slow = rate_hz.is_some_and(|rate| rate < SLOW_HZ);
    if !has(&survey, "smooth") && (is_slow || has(&survey, "attitude")) {
        survey.text.push_str("smooth = \"auto\"\n");
    }
    Some(survey)
}

/// The known format whose columns are all there.
fn known(names: &[&str]) -> Option<&'static Known> {
    KNOWN.iter().find(|known| known.columns.iter().all(|column| names.contains(column)))
}

/// Rate below which rows are smoothed [Hz]: at this rate a turn is seen by a few rows.
const SLOW_HZ: f64 = 10.0;

impl<'t> Grid<'t> {
    fn of(table: &'t str) -> Option<Self> {
        let lines: Vec<&str> = table.trim_start_matches('\u{feff}').lines().take(LINES + ROWS).collect();
        let separators = [Separator::Comma, Separator::Semicolon, Separator::Tab, Separator::Bar];
        let quantities = |cells: &[&str]| {
            let mut found: Vec<usize> =
                cells.iter().filter_map(|name| guess(name)).map(|guess| guess.quantity).collect();
            found.sort_unstable();
            found.dedup();
            found.len()
        };
        let mut best: Option<(usize, Separator, usize)> = None;
        for separator in separators {
            for (place, line) in lines.iter().enumerate().take(LINES) {
                let cells = cells(line, separator);
                let count = if known(&cells).is_some() { usize::MAX } else { quantities(&cells) };
                if count >= FEWEST && best.is_none_or(|(most, ..)| count > most) {
                    best = Some((count, separator, place));
                }
            }
        }
        let (_, separator, place) = best?;
        let names = cells(lines[place], separator);
        let is_units = |row: &Vec<&str>| {
            let count = row.iter().filter(|cell| unit(cell).is_some()).count();
            row.len().abs_diff(names.len()) <= 1 && count >= FEWEST
        };
        let mut behind = lines[place + 1..].iter().map(|line| cells(line, separator)).peekable();
        let mut skip = 0;
        // Units, or a second line of names.
        let mut units: Vec<Vec<&str>> = Vec::new();
        while let Some(row) = behind.next_if(|row| is_units(row) || quantities(row) >= FEWEST) {
            // The reader passes comments.
            skip += usize::from(!row[0].starts_with('#'));
            units.push(row);
        }
        units.extend(lines[..place].iter().map(|line| cells(line, separator)).filter(is_units));
        Some(Self { separator, header: place + 1, names, units, skip, rows: behind.collect() })
    }

    /// Quantities that come together, and those that every flight has.
    fn complete(&self, survey: &mut Survey) {
        let mut has_velocity = false;
        for group in [["east", "north", "up"], ["speed", "track", "climb"], ["roll", "pitch", "heading"]] {
            let is_of = |line: &str, key: &str| line.starts_with(&format!("{key} ="));
            let found: Vec<&str> =
                group.into_iter().filter(|key| survey.text.lines().any(|line| is_of(line, key))).collect();
            let is_attitude = group[0] == "roll";
            let is_second = has_velocity && !is_attitude && !found.is_empty();
            if found.len() == group.len() && !is_second {
                has_velocity |= !is_attitude;
                continue;
            }
            let is_left_out = |line: &&str| !group.iter().any(|key| is_of(line, key));
            let rest: String =
                survey.text.lines().filter(is_left_out).map(|line| format!("{line}\n")).collect();
            survey.text = rest;
            if is_second {
                survey
                    .doubts
                    .push(format!("{} are left out: east, north and up are the velocity", group.join(", ")));
            } else if !found.is_empty() {
                let lacking: Vec<&str> = group.into_iter().filter(|key| !found.contains(key)).collect();
                survey.doubts.push(format!(
                    "{} is left out: there is no {}",
                    found.join(", "),
                    lacking.join(", ")
                ));
            }
        }
        let has = |survey: &Survey, key: &str| {
            survey.text.lines().any(|line| line.starts_with(&format!("{key} =")))
        };
        if !has(survey, "height") {
            survey.text.push_str("height = 0\n");
            survey.doubts.push("there is no height: it is taken as 0".to_owned());
        }
        if !has(survey, "time") {
            survey.text.push_str("time_format = \"row\"\nrate_hz = 1\n");
            survey.doubts.push("there is no time: a row is taken as a second".to_owned());
        }
        for key in ["latitude", "longitude"] {
            if !has(survey, key) {
                survey.doubts.push(format!("no column is known as the {key}: name it"));
            }
        }
    }

    /// The lines about separator, header, comments and time; the rate of the rows.
    fn layout(&self, survey: &mut Survey) -> Option<f64> {
        let mut layout = String::new();
        if let Some((word, _)) = Separator::WORDS.iter().find(|(_, separator)| *separator == self.separator)
            && self.separator != Separator::Comma
        {
            layout += &format!("separator = \"{word}\"\n");
        }
        if self.names[0].starts_with('#') {
            layout += "comment = \"!\"\n";
        }
        if self.header > 1 {
            layout += &format!("header = {}\n", self.header);
        }
        if self.skip > 0 {
            layout += &format!("skip = {}\n", self.skip);
        }
        survey.text.insert_str(0, &layout);
        let value = |key: &str| {
            let begin = format!("{key} = ");
            survey.text.lines().find_map(|line| line.strip_prefix(begin.as_str()))
        };
        let column = value("time")?;
        let name = column.split('"').nth(1)?;
        let place = self.names.iter().position(|known| *known == name)?;
        let word = value("time_format").map_or("s", |quoted| quoted.trim_matches('"'));
        let (_, time_format) = *TimeFormat::WORDS.iter().find(|(known, _)| *known == word)?;
        let mut clock = Clock::new(&LogMapping { time_format, ..LogMapping::default() });
        let times: Vec<f64> =
            self.rows.iter().filter_map(|row| clock.next(&self.point(row.get(place)?))).collect();
        let scale = ["ms", "us"].into_iter().find(|unit| column.contains(&format!("unit = \"{unit}\"")));
        let scale = scale.and_then(|unit| unit_of(Dimension::Time, unit)).map_or(1.0, |(_, si)| si);
        let [first, .., last] = times[..] else { return None };
        Some((times.len() - 1) as f64 / ((last - first) * scale))
            .filter(|rate| rate.is_finite() && *rate > 0.0)
    }

    /// The keys of a known format, as far as their columns are there.
    fn of_known(&self, known: &Known, survey: &mut Survey) {
        survey.format = Some(known.name);
        let mut last = "";
        for line in known.keys.lines() {
            let key = line.split(" =").next().unwrap_or_default();
            let is_quantity = QUANTITIES.iter().any(|quantity| quantity.key == key);
            let column = line.split('"').nth(1).unwrap_or_default();
            if !is_quantity || (key != last && self.names.contains(&column)) {
                survey.text += &format!("{line}\n");
                last = key;
            }
        }
        survey.doubts.extend((!known.doubt.is_empty()).then(|| known.doubt.to_owned()));
    }

    /// Keys from the names of the columns.
    fn guessed(&self, survey: &mut Survey) {
        let guesses: Vec<_> = self.names.iter().map(|name| guess(name)).collect();
        for (quantity, about) in QUANTITIES.iter().enumerate() {
            let places = (0..self.names.len())
                .filter(|place| guesses[*place].is_some_and(|guess| guess.quantity == quantity));
            let mut places: Vec<usize> = places.collect();
            places.sort_by_key(|place| guesses[*place].map_or(0, |guess| guess.rank));
            let Some((&place, others)) = places.split_first() else { continue };
            let name = self.names[place];
            for other in others {
                survey.doubts.push(format!(
                    "{}: {} is taken, {} is not",
                    about.key,
                    excerpt(name),
                    excerpt(self.names[*other])
                ));
            }
            let Some(guess) = guesses[place] else { continue };
            if about.dimension == Dimension::Time {
                self.time(place, guess.unit, survey);
                continue;
            }
            let stated = self.units.iter().find_map(|row| {
                unit_of(about.dimension, unit(row.get(place)?)?).filter(|_| unit(row[place]) != Some(""))
            });
            let mut unit =
                if guess.unit.is_empty() { stated.map_or("", |(unit, _)| unit) } else { guess.unit };
            if unit.is_empty() {
                unit = self.unstated(about.key, about.dimension, place, survey);
            }
            let usual = unit_of(about.dimension, "").map_or("", |(unit, _)| unit);
            let quoted = text_in_quotes(name);
            let unit =
                if unit.is_empty() || unit == usual { String::new() } else { format!(", unit = \"{unit}\"") };
            let sign = if guess.sign < 0.0 { ", sign = -1" } else { "" };
            survey.text += &match (unit.as_str(), sign) {
                ("", "") => format!("{} = {quoted}\n", about.key),
                _ => format!("{} = {{ col = {quoted}{unit}{sign} }}\n", about.key),
            };
            let lower = name.to_lowercase();
            let is_magnetic = lower.contains("magnetic") || lower == "hdg";
            if is_magnetic
                && (about.key == "heading" || about.key == "track")
                && self.place("variation").is_none()
            {
                survey.doubts.push(format!("{} may be magnetic: set variation", excerpt(name)));
            }
            let is_true =
                |key| self.place(key).is_none_or(|place| !self.names[place].to_lowercase().contains("mag"));
            if about.key == "variation" && is_true("heading") && is_true("track") {
                survey.text.truncate(
                    survey.text.len() - survey.text.lines().last().map_or(0, |line| line.len() + 1),
                );
                survey.doubts.push(format!(
                    "{} is not used: no name says that the heading is magnetic",
                    excerpt(name)
                ));
            }
            if about.key == "height"
                && !name.to_lowercase().contains("wgs")
                && !name.to_lowercase().contains("ellips")
            {
                survey
                    .doubts
                    .push(format!("{} may be above the sea: set geoid if it matters", excerpt(name)));
            }
        }
    }

    /// The keys of the time.
    fn time(&self, place: usize, unit: &str, survey: &mut Survey) {
        let name = self.names[place];
        let quoted = text_in_quotes(name);
        let first = self.rows.first().and_then(|row| row.get(place)).copied().unwrap_or_default();
        let is_read = |time_format| {
            Clock::new(&LogMapping { time_format, ..LogMapping::default() })
                .next(&self.point(first))
                .is_some()
        };
        let format = [TimeFormat::Number, TimeFormat::Iso, TimeFormat::Hms]
            .into_iter()
            .find(|format| is_read(*format));
        let Some(format) = format.filter(|format| *format != TimeFormat::Hms || first.contains(':')) else {
            survey.doubts.push(format!("{} is no time that can be read: {}", excerpt(name), excerpt(first)));
            return;
        };
        if let Some((word, _)) = TimeFormat::WORDS.iter().find(|(_, known)| *known == format)
            && format != TimeFormat::Number
        {
            survey.text += &format!("time = {quoted}\ntime_format = \"{word}\"\n");
            return;
        }
        let times = self.numbers(place);
        let mut steps: Vec<f64> =
            times.windows(2).map(|two| two[1] - two[0]).filter(|step| *step > 0.0).collect();
        steps.sort_by(f64::total_cmp);
        let step = steps.get(steps.len() / 2).copied().unwrap_or(0.0);
        let is_possible =
            |(_, si): &(&str, f64)| self.speed(DEG, *si).is_some_and(|speed| SPEEDS.contains(&speed));
        let likely =
            [("s", 1.0), ("ms", 1e-3), ("us", 1e-6)].into_iter().find(is_possible).map(|(unit, _)| unit);
        let unit = match (unit, likely, step) {
            ("", Some(likely), _) => likely,
            ("", None, step) if step >= 3000.0 => "us",
            ("", None, step) if step >= 3.0 => "ms",
            _ => unit,
        };
        let has_unit = !(unit.is_empty() || unit == "s");
        if has_unit && guess(name).is_none_or(|guess| guess.unit.is_empty()) {
            survey.doubts.push(format!("{} is taken as {unit}: its usual step is {step}", excerpt(name)));
        }
        survey.text += &if has_unit {
            format!("time = {{ col = {quoted}, unit = \"{unit}\" }}\n")
        } else {
            format!("time = {quoted}\n")
        };
    }

    /// The unit of a column that states none, by its values.
    fn unstated(&self, key: &str, dimension: Dimension, place: usize, survey: &mut Survey) -> &'static str {
        let name = excerpt(self.names[place]);
        match dimension {
            Dimension::Angle if key == "latitude" || key == "longitude" => {
                // Both in one unit. Near the equator and Greenwich degrees are as small: the speed tells.
                let is_small = |key: &str, most: f64| {
                    let values = self.place(key).map_or(Vec::new(), |place| self.numbers(place));
                    !values.is_empty() && values.iter().all(|value| value.abs() <= most)
                };
                let is_slow = self.speed(1.0, 1.0).is_none_or(|speed| speed <= *SPEEDS.end());
                if is_small("latitude", QUARTER) && is_small("longitude", 4.0 * QUARTER) && is_slow {
                    survey
                        .doubts
                        .push(format!("{name} is taken as radians: no latitude is above {QUARTER:.2}"));
                    return "rad";
                }
            }
            Dimension::Angle if key != "variation" => {
                let angles = ["roll", "pitch", "heading", "track"]
                    .map(|key| self.place(key).map_or(Vec::new(), |place| self.numbers(place)));
                let is_moving = angles.iter().flatten().any(|value| *value != 0.0);
                let are_radians =
                    is_moving && angles.iter().flatten().all(|value| value.abs() <= 4.0 * QUARTER);
                let is_whole = angles.iter().flatten().all(|value| value.fract() == 0.0);
                let of_position = survey.text.contains("unit = \"rad\"");
                if are_radians && !is_whole {
                    let unit = if of_position || !angles[2].is_empty() && largest_of(&angles[2]) > 2.0 {
                        "rad"
                    } else {
                        ""
                    };
                    let taken = if unit.is_empty() { "degrees" } else { "radians" };
                    survey.doubts.push(format!(
                        "{name} is taken as {taken}: no angle of the attitude is above {:.2}",
                        4.0 * QUARTER
                    ));
                    return unit;
                }
            }
            Dimension::Length => survey.doubts.push(format!("{name} is taken as m: nothing states its unit")),
            Dimension::Speed => {
                survey.doubts.push(format!("{name} is taken as m/s: nothing states its unit"))
            }
            _ => {}
        }
        ""
    }

    /// A cell with a decimal point: between semicolons decimals may follow a comma.
    fn point(&self, cell: &str) -> String {
        if self.separator == Separator::Semicolon { cell.replace(',', ".") } else { cell.to_owned() }
    }

    /// The place of the column with a quantity.
    fn place(&self, key: &str) -> Option<usize> {
        let has = |name: &&str| guess(name).is_some_and(|guess| QUANTITIES[guess.quantity].key == key);
        self.names.iter().position(has)
    }

    /// The median speed over ground, if positions are of this unit and times of that one [m/s].
    fn speed(&self, angle_si: f64, time_si: f64) -> Option<f64> {
        let [latitudes, longitudes] =
            ["latitude", "longitude"].map(|key| self.place(key).map(|place| self.numbers(place)));
        let (latitudes, longitudes, times) = (latitudes?, longitudes?, self.numbers(self.place("time")?));
        if latitudes.len() != times.len() || longitudes.len() != times.len() {
            return None;
        }
        let mut speeds: Vec<f64> = (1..times.len())
            .filter(|row| times[*row] > times[row - 1])
            .map(|row| {
                let of = |values: &[f64]| (values[row] - values[row - 1]) * angle_si;
                let (_, cos) = sin_cos(latitudes[row] * angle_si);
                let metres = RADIUS_M * hypot(of(&latitudes), of(&longitudes) * cos);
                metres / ((times[row] - times[row - 1]) * time_si)
            })
            .collect();
        speeds.sort_by(f64::total_cmp);
        speeds.get(speeds.len() / 2).copied()
    }

    /// The numbers of a column.
    fn numbers(&self, place: usize) -> Vec<f64> {
        let number = |row: &Vec<&str>| {
            self.point(row.get(place)?).parse().ok().filter(|value: &f64| value.is_finite())
        };
        self.rows.iter().filter_map(number).collect()
    }
}

fn largest_of(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
}

/// The cells of a line. A comma within quotes separates none.
fn cells(line: &str, separator: Separator) -> Vec<&str> {
    let separator = char::from(separator.byte());
    let mut is_quoted = false;
    let is_end = |letter: char| {
        is_quoted ^= letter == '"';
        letter == separator && !is_quoted
    };
    line.split(is_end).map(|cell| cell.trim().trim_matches('"').trim()).collect()
}

#[cfg(test)]
mod tests {
    use super::super::FlightLog;
    use super::*;
    use crate::scene::Scene;

    /// Surveys a table, and reads it as the survey says.
    fn read(table: &str) -> (Survey, FlightLog) {
        let survey = survey(table).unwrap_or_else(|| panic!("{table}"));
        let text = format!("[flight]\nfile = \"a.csv\"\n[log]\n{}", survey.text);
        let scene = Scene::parse(text.as_bytes()).unwrap_or_else(|faults| panic!("{faults:?}\n{text}"));
        let mapping: &LogMapping = &scene.log;
        let log = FlightLog::parse_with(table.as_bytes(), mapping)
            .unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        (survey, log)
    }

    /// A sample of each known format: two seconds, at 48° north and 11° east, at 300 m, climbing, banked to the right.
    const SAMPLES: [(&str, &str); 13] = [
        (
            "Garmin G1000",
            "#airframe_info, log_version=\"1.00\"\n#yyy-mm-dd, hh:mm:ss, hh:mm, degrees, degrees, ft msl, ft wgs, deg, deg, kt, fpm, deg, deg, deg\n\
             Lcl Date, Lcl Time, UTCOfst, Latitude, Longitude, AltMSL, AltGPS, Pitch, Roll, GndSpd, VSpd, HDG, TRK, MagVar\n\
             2024-05-01, 12:00:00, +02:00, 48.0, 11.0, 800, 984.252, 2, 5, 100, 300, 356, 356, 4\n\
             2024-05-01, 12:00:01, +02:00, 48.00046, 11.0, 805, 989.252, 2, 5, 100, 300, 356, 356, 4\n",
        ),
        (
            "Garmin G5",
            "UTC Date (yyyy-mm-dd),UTC Time (hh:mm:ss),Latitude (WGS84 deg),Longitude (WGS84 deg),GPS Altitude (WGS84 ft),GPS Velocity E (m/s),GPS Velocity N (m/s),GPS Velocity U (m/s),Pitch (deg),Roll (deg),Magnetic Heading (deg),Magnetic Variation (deg)\n\
             UTC Date,UTC Time,Latitude,Longitude,Altitude,VelE,VelN,VelU,Pitch,Roll,Heading,MagVar\n\
             2024-05-01,12:00:00,48.0,11.0,984.252,0,50,1,2,5,356,4\n2024-05-01,12:00:01,48.00045,11.0,987.5,0,50,1,2,5,356,4\n",
        ),
        (
            "Garmin G3X",
            "Date (yyyy-mm-dd),UTC Time (hh:mm:ss),Latitude (deg),Longitude (deg),GPS Altitude (ft),GPS Velocity E (m/sec),GPS Velocity N (m/sec),GPS Velocity U (m/sec),Pitch (deg),Roll (deg),Magnetic Heading (deg)\n\
             2024-05-01,12:00:00,48.0,11.0,984.252,0,50,1,2,5,356\n2024-05-01,12:00:01,48.00045,11.0,987.5,0,50,1,2,5,356\n",
        ),
        (
            "X-Plane Data.txt",
            "   _real,_time |    __lat,__deg |    __lon,__deg |    __alt,ftmsl |    pitch,__deg |    _roll,__deg |    hding,_true |\n\
             0.0 | 48.0 | 11.0 | 984.252 | 2 | 5 | 0 |\n0.1 | 48.000045 | 11.0 | 984.6 | 2 | 5 | 0 |\n",
        ),
        (
            "FlightGear",
            "Time,/position/latitude-deg,/position/longitude-deg,/position/altitude-ft,/velocities/speed-north-fps,/velocities/speed-east-fps,/velocities/speed-down-fps,/orientation/roll-deg,/orientation/pitch-deg,/orientation/heading-deg\n\
             0,48.0,11.0,984.252,164.042,0,-3.28,5,2,0\n50,48.0000225,11.0,984.4,164.042,0,-3.28,5,2,0\n",
        ),
        (
            "SimConnect",
            "Time,PLANE LATITUDE,PLANE LONGITUDE,PLANE ALTITUDE,VELOCITY WORLD X,VELOCITY WORLD Y,VELOCITY WORLD Z,PLANE PITCH DEGREES,PLANE BANK DEGREES,PLANE HEADING DEGREES TRUE\n\
             0,48.0,11.0,984.252,0,3.28,164.042,-0.0349,-0.08727,0\n0.05,48.0000225,11.0,984.4,0,3.28,164.042,-0.0349,-0.08727,0\n",
        ),
        (
            "Sky Dolly",
            "Timestamp,UTC,Latitude,Longitude,Altitude,Pitch,Bank,Heading,Speed\n\
             0,12:00,48.0,11.0,984,-2,-5,0,164\n1000,12:00,48.00045,11.0,987,-2,-5,0,164\n",
        ),
        (
            "ArduPilot (POS)",
            "TimeUS,Lat,Lng,Alt,RelHomeAlt\n0,48.0,11.0,300,0\n100000,48.000045,11.0,300.1,0\n",
        ),
        (
            "AirData",
            "time(millisecond),datetime(utc),latitude,longitude,altitude_above_seaLevel(feet), xSpeed(mph), ySpeed(mph), zSpeed(mph), compass_heading(degrees), pitch(degrees), roll(degrees)\n\
             0,2024-05-01 12:00:00,48.0,11.0,984.252,111.8,0,-2,0,2,5\n100,2024-05-01 12:00:00,48.000045,11.0,984.6,111.8,0,-2,0,2,5\n",
        ),
        (
            "OpenSky states",
            "time,icao24,lat,lon,velocity,heading,vertrate,callsign,baroaltitude,geoaltitude,lastposupdate\n\
             1700000000,3c6444,48.0,11.0,50,0,1,X,290,300,1700000000\n1700000001,3c6444,48.00045,11.0,50,0,1,X,291,301,1700000001\n",
        ),
        (
            "traffic",
            "timestamp,icao24,latitude,longitude,altitude,groundspeed,track,vertical_rate,callsign\n\
             2024-05-01 12:00:00+00:00,3c6444,48.0,11.0,984.252,97.2,0,200,X\n2024-05-01 12:00:01+00:00,3c6444,48.00045,11.0,987.5,97.2,0,200,X\n",
        ),
        (
            "NCAR research aircraft",
            "Time,LATC,LONC,GGALT,GGVEW,GGVNS,GGVSPD,PITCH,ROLL,THDG\n\
             43200,48.0,11.0,300,0,50,1,2,5,0\n43201,48.00045,11.0,301,0,50,1,2,5,0\n",
        ),
        (
            "JSBSim",
            "Time,Latitude (deg),Latitude Geodetic (deg),Longitude (deg),Altitude ASL (ft),V_{North} (ft/s),V_{East} (ft/s),V_{Down} (ft/s),Phi (deg),Theta (deg),Psi (deg)\n\
             0,47.8,48.0,11.0,984.252,164.042,0,-3.28,5,2,0\n0.01,47.8,48.0000045,11.0,984.3,164.042,0,-3.28,5,2,0\n",
        ),
    ];

    #[test]
    fn every_known_format_is_recognized_and_read() {
        assert_eq!(KNOWN.map(|known| known.name), SAMPLES.map(|(name, _)| name));
        for (name, table) in SAMPLES {
            let (survey, log) = read(table);
            assert_eq!(survey.format, Some(name), "{survey:?}");
            let sample = log.samples()[0];
            assert_eq!(log.samples().len(), 2, "{name}");
            assert!((sample.place.latitude_rad.to_degrees() - 48.0).abs() < 1e-9, "{name}: {sample:?}");
            assert!((sample.place.longitude_rad.to_degrees() - 11.0).abs() < 1e-9, "{name}: {sample:?}");
            assert!((sample.place.height_m - 300.0).abs() < 0.1, "{name}: {sample:?}");
            if !survey.text.contains("coordinated") {
                let angles =
                    [sample.euler.roll, sample.euler.pitch, sample.euler.heading].map(f64::to_degrees);
                assert!(
                    (angles[0] - 5.0).abs() < 1e-2 && (angles[1] - 2.0).abs() < 1e-2,
                    "{name}: {angles:?}"
                );
                let heading = if name == "Garmin G3X" { 356.0 } else { 0.0 };
                assert!(
                    (angles[2] - heading).rem_euclid(360.0).min((heading - angles[2]).rem_euclid(360.0))
                        < 1e-6,
                    "{name}: {angles:?}"
                );
            }
            if let Some(v_n) = sample.v_n {
                let [east, north, up]: [f64; 3] = v_n.into();
                assert!(
                    east.abs() < 1e-9 && (north - 50.0).abs() < 2.0 && up > 0.8 && up < 2.0,
                    "{name}: {v_n:?}"
                );
            }
        }
    }

    #[test]
    fn other_tables_are_guessed() {
        let (found, log) = read(
            "my logger\ntime;lat;lon;alt;ve;vn;vd;roll;pitch;yaw\nms;deg;deg;ft;kt;kt;kt;deg;deg;deg\n\
             0;48.0;11.0;984.252;0;97.192;-2;5;2;10\n100;48.000045;11.0;984.6;0;97.192;-2;5;2;10\n",
        );
        assert_eq!(found.format, None);
        let expected = "separator = \"semicolon\"\nheader = 2\nskip = 1\ntime = { col = \"time\", unit = \"ms\" }\nlatitude = \"lat\"\nlongitude = \"lon\"\nheight = { col = \"alt\", unit = \"ft\" }\n";
        assert!(found.text.starts_with(expected), "{}", found.text);
        let sample = log.samples()[1];
        assert!((sample.time_s - 0.1).abs() < 1e-12 && (sample.place.height_m - 300.1).abs() < 0.01);
        assert!((sample.v_n.unwrap().y - 50.0).abs() < 0.01 && sample.v_n.unwrap().z > 0.0);

        let radians = "t,latitude,longitude,altitude,phi,theta,psi\n0,0.8377,0.19,300,0,0,6.1\n1,0.83771,0.19,300,0,0,6.1\n";
        let found = survey_of(radians);
        assert!(
            found.text.contains("latitude = { col = \"latitude\", unit = \"rad\" }")
                && found.text.contains("smooth = \"auto\""),
            "{found:?}"
        );
        assert!(
            found.doubts.iter().any(|doubt| doubt.contains("radians"))
                && found.doubts.iter().any(|doubt| doubt.contains("as m:")),
            "{found:?}"
        );

        let (found, log) =
            read("Zeit;lat;lon;alt;speed;yaw\n0;48,5;11,25;300,5;50;90\n0,5;48,5;11,2503;300,5;50;90\n");
        assert!(
            (log.samples()[0].place.latitude_rad.to_degrees() - 48.5).abs() < 1e-9
                && (log.duration_s() - 1.0).abs() < 1e-9
        );
        for doubt in [
            "speed is left out: there is no track, climb",
            "heading is left out: there is no roll, pitch",
            "a row is taken as a second",
        ] {
            assert!(
                found.doubts.iter().any(|found| found == doubt || found.ends_with(doubt)),
                "{doubt}: {found:?}"
            );
        }
        let (found, log) = read(
            "t,lat,lon,gs,track,climb,ve,vn,vu,roll,pitch,yaw\n0,48,11,50,0,1,0,50,1,0,0,0\n0.1,48.00005,11,50,0,1,0,50,1,0,0,0\n",
        );
        assert!(
            !found.text.contains("speed")
                && found.text.contains("height = 0")
                && log.samples()[0].v_n.is_some(),
            "{found:?}"
        );

        for (table, words, latitude) in [
            // Radians with decimal commas; degrees near the equator and Greenwich; a second in steps of 5 s.
            (
                "t;lat;lon;alt\n0;0,8377;0,19;300\n1;0,83771;0,19;300\n",
                "latitude = { col = \"lat\", unit = \"rad\" }",
                47.9966,
            ),
            ("t,lat,lon,alt\n0,0.5,1,300\n1,0.50045,1,300\n", "latitude = \"lat\"", 0.5),
            ("t,lat,lon,alt\n1700000000,48,11,300\n1700000005,48.002,11,300\n", "time = \"t\"\n", 48.0),
            ("t,lat,lon,alt\n0,48,11,300\n2500,48.0000011,11,300\n", "unit = \"us\"", 48.0),
            ("# t,lat,lon,alt\n0,48,11,300\n1,48.0005,11,300\n", "comment = \"!\"\n", 48.0),
            (
                "t,lat,lon,alt\n# s,deg,deg,ft\n0,48,11,300\n1,48.0005,11,300\n",
                "height = { col = \"alt\", unit = \"ft\" }",
                48.0,
            ),
            (
                "t;lat;lon;alt\n12:00:00,0;48;11;300\n12:00:00,1;48,00005;11;300\n",
                "time_format = \"hms\"",
                48.0,
            ),
        ] {
            let (found, log) = read(table);
            assert!(found.text.contains(words), "{words}: {found:?}");
            assert!(
                (log.samples()[0].place.latitude_rad.to_degrees() - latitude).abs() < 1e-3
                    && log.samples().len() == 2,
                "{found:?}"
            );
        }
        let angles =
            "t,lat,lon,alt,roll,pitch,yaw\n0,48,11,300,0.3,0.02,3.1\n1,48.0005,11,300,0.3,0.02,3.1\n";
        assert!(
            survey_of(angles).text.contains("roll = { col = \"roll\", unit = \"rad\" }"),
            "{:?}",
            survey_of(angles)
        );
        let north = "t,lat,lon,alt,roll,pitch,True Heading,Declination\n0,48,11,300,1,2,90,4\n1,48.0005,11,300,1,2,90,4\n";
        assert!(
            !survey_of(north).text.contains("variation")
                && survey_of(north).doubts.iter().any(|doubt| doubt.contains("not used"))
        );
        let north = "t,lat,lon,alt,roll,pitch,Magnetic Heading,Declination\n0,48,11,300,1,2,90,4\n1,48.0005,11,300,1,2,90,4\n";
        assert!(survey_of(north).text.contains("variation = \"Declination\"\n"));

        let positions = "timestamp,lat,lon,altitude,heading\n1714564800000,48.0,11.0,300,90\n1714564801000,48.0,11.001,300,90\n";
        let (found, _) = read(positions);
        assert!(
            found.text.contains("unit = \"ms\"") && found.text.contains("attitude = \"coordinated\""),
            "{found:?}"
        );
        assert_eq!(survey("1,2,3\n4,5,6\n"), None);
        assert_eq!(survey(""), None);
    }

    fn survey_of(table: &str) -> Survey {
        survey(table).unwrap()
    }
}
