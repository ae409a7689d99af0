//! The column of the time, and what its cells mean.

use super::super::TimeFormat;
use super::super::guess::Guess;
use super::super::quantity::{Dimension, unit_of};
use super::motion::{Motion, READINGS, alone, median};
use super::{Draft, Question, SLOW_HZ, clock};
use crate::base::records::rounded;
use crate::base::text::excerpt;
use crate::truth::FlightSample;

/// Speeds over ground of vehicles \[m/s\], and rates of logs \[Hz\].
pub const SPEEDS: core::ops::RangeInclusive<f64> = 0.3..=1000.0;
const RATES: core::ops::RangeInclusive<f64> = 0.01..=2000.0;

/// Slowest speed of a drifting vehicle \[m/s\], the lowest rate of its log, and the rate from which few logs are \[Hz\].
const SLOWEST: f64 = 0.02;
const RARE_HZ: f64 = 0.02;
const OFTEN_HZ: f64 = 400.0;

/// Ratios of the speed of the positions to that of the table that another unit of the speed may have: another unit of the time has not.
pub const MATCHES: core::ops::RangeInclusive<f64> = 0.1..=5.0;

/// Times that clocks show \[s\]: since a start or 1970 until 2103, since 1601 and since the year 0 from 1978 on.
const CLOCKS_S: [core::ops::Range<f64>; 3] = [0.0..4.2e9, 1.19e10..1.58e10, 6.24e10..6.64e10];

/// The units of times, with what a column says of them.
const UNITS: [(&str, &str, f64); 10] = [
    ("s", "", 1.0),
    ("ms", ", unit = \"ms\"", 1e-3),
    ("us", ", unit = \"us\"", 1e-6),
    ("ns", ", unit = \"ns\"", 1e-9),
    ("0.1 us", ", scale = 1e-7", 1e-7),
    ("0.1 ms", ", scale = 1e-4", 1e-4),
    ("0.1 s", ", scale = 0.1", 0.1),
    ("min", ", unit = \"min\"", 60.0),
    ("h", ", unit = \"h\"", 3600.0),
    ("d", ", unit = \"d\"", 86400.0),
];

/// Largest number of columns that a question names.
const MOST: usize = 4;

/// A column that may be one of times steps in one of so many rows or more, and by as much within this part of its usual step.
const FEWEST_STEPS: usize = 20;
const REGULAR: f64 = 0.3;

/// A column whose stamps tell this part of the rows apart that another one tells is as good.
const NEARLY: f64 = 0.9;

impl Draft<'_> {
    /// Number of rows whose cell differs from the one before.
    fn changes(&self, place: usize) -> usize {
        let mut last = None;
        self.grid.cells(place).filter(|cell| last.replace(*cell) != Some(*cell)).count()
    }

    /// The keys of the time, of those columns whose names say that they have one: the first that tells the rows apart. A column of dates
    /// without a name is one too, as the index of a table.
    pub(super) fn times(&mut self, named: &[(Guess, usize)]) {
        let nameless = |(place, name): (usize, &str)| {
            let is_date = || matches!(self.time_formats(place)[..], [TimeFormat::Iso]);
            (name.is_empty() && is_date()).then_some((place, ""))
        };
        let nameless: Vec<_> = self.grid.names.iter().enumerate().filter_map(nameless).collect();
        let named = named.iter().map(|(guess, place)| (*place, guess.unit));
        let mut all: Vec<(usize, &str, Vec<TimeFormat>)> = named
            .clone()
            .chain(nameless)
            .map(|(place, unit)| (place, unit, self.time_formats(place)))
            .collect();
        all.retain(|(.., formats)| !formats.is_empty());
        let most = all.iter().map(|(place, ..)| self.changes(*place)).max().unwrap_or(0);
        let is_fine = |place: usize| self.changes(place) as f64 >= NEARLY * most as f64;
        let best = all.iter().position(|(place, ..)| is_fine(*place));
        let Some((place, unit, formats)) = best.map(|best| all.swap_remove(best)) else {
            for (place, _) in named {
                let first = self.grid.cells(place).next().map_or("nothing".to_owned(), excerpt);
                let name = excerpt(&self.grid.names[place]);
                self.doubt(format!("{name} is no time that can be read: {first}"));
            }
            return;
        };
        for (other, _) in named.filter(|(other, _)| *other != place) {
            let [own, other_name] = [place, other].map(|place| excerpt(&self.grid.names[place]));
            self.doubt(format!(
                "time: column {} ({own}) is taken, column {} ({other_name}) is not",
                place + 1,
                other + 1
            ));
        }
        self.add_place("time", place, unit);
        self.time(place, unit, &formats);
    }

    /// The keys of the time in a column.
    fn time(&mut self, place: usize, unit: &str, formats: &[TimeFormat]) {
        let grid = self.grid;
        let name = excerpt(&grid.names[place]);
        let is_open = formats.len() > 1 && (unit.is_empty() || formats[0] != TimeFormat::Number);
        let fitting: Vec<TimeFormat> =
            formats.iter().copied().filter(|format| self.agrees(place, *format) == Some(true)).collect();
        let format = match (formats, &fitting[..]) {
            (_, [only]) if is_open => *only,
            _ if is_open => {
                let sentence = format!("{name} has times that can be read in several ways");
                return self.open_time = Some((place, sentence));
            }
            ([first, ..], _) => *first,
            _ => return,
        };
        if format != TimeFormat::Number {
            if self.agrees(place, format) == Some(false) {
                return self.open_time = Some((place, contradicts(&name)));
            }
            if is_open {
                self.doubt(format!("{name} is taken as {}: so it has the speed of the table", format.word()));
            } else if self.has_numbers(place) {
                let what = match format {
                    TimeFormat::Iso => "a date and a time that are one number",
                    _ => "hours, minutes and seconds, hhmmss",
                };
                self.doubt(format!("{name} is taken as {what}"));
            }
            let is_read = |cell: &str, format| clock(format).next(&grid.separator.with_point(cell)).is_some();
            let is_sure = || {
                let is_day = |cell| is_read(cell, TimeFormat::Dmy) && !is_read(cell, TimeFormat::Mdy);
                grid.cells(place).any(is_day)
            };
            if format == TimeFormat::Dmy && !is_sure() {
                self.doubt(format!(
                    "{name} is taken as day, month, year: no day is above 12; otherwise time_format = \"mdy\""
                ));
            }
            self.set("time", self.column(place, ""));
            return self.set("time_format", format!("\"{}\"", format.word()));
        }
        let in_cell = || grid.cells(place).next().is_some_and(|cell| cell.ends_with('s')).then_some("s");
        let stated = Some(unit)
            .filter(|unit| !unit.is_empty())
            .or_else(|| grid.stated(place).find(|unit| unit_of(Dimension::Time, unit).is_some()))
            .or_else(in_cell);
        let part = match stated {
            Some("s") => "",
            Some(unit) => UNITS.iter().find(|(known, ..)| *known == unit).map_or("", |(_, part, _)| part),
            None => match self.unit_of_time(place) {
                Some(part) => part,
                None => return,
            },
        };
        let si = UNITS.iter().find(|(_, known, _)| *known == part).map_or(1.0, |(.., si)| *si);
        let column = self.column(place, &(part.to_owned() + &self.shift_of(place, si)));
        self.set("time", column);
    }

    /// What shifts times to those that a sample may have, if they count from long ago: clocks of simulators count from the year 0.
    fn shift_of(&self, place: usize, si: f64) -> String {
        let first_s = self.grid.numbers(place).first().map_or(0.0, |first| first * si);
        if first_s.abs() > FlightSample::LATEST_S {
            format!(", add = {}", -first_s.floor())
        } else {
            String::new()
        }
    }

    /// What a column of times says of its unit, if nothing states it: the unit that agrees with the speed of the table; otherwise the first
    /// one that gives a vehicle, or at rest the one that its steps suggest. `None`: a speed contradicts each, which is asked.
    fn unit_of_time(&mut self, place: usize) -> Option<&'static str> {
        let name = excerpt(&self.grid.names[place]);
        let motion = self.motion().filter(|motion| !motion.is_at_rest());
        if let Some((unit, part)) = motion.as_ref().and_then(unit_that_fits) {
            if unit != "s" {
                self.doubt(format!(
                    "{name} is taken as {unit}: the positions have the speed of the table then"
                ));
            }
            return Some(part);
        }
        let degrees = &READINGS[0];
        let motion = motion.filter(|motion| motion.first_place(degrees, false).is_some());
        let is_slow = motion.as_ref().is_some_and(is_slow);
        for (unit, part, si) in UNITS.into_iter().take(4) {
            let Some(motion) = &motion else { break };
            if !is_rate(motion, si) || !self.is_of_clock(place, si) {
                continue;
            }
            let Some(speed) = motion.speed(degrees, false, si).filter(|speed| SPEEDS.contains(speed)) else {
                continue;
            };
            if is_slow && unit != "s" {
                if motion.rate_hz(si).is_some_and(|rate_hz| rate_hz < OFTEN_HZ) {
                    self.open_time = Some((
                        place,
                        format!("{name} has several units with which the positions are those of a vehicle"),
                    ));
                    return None;
                }
                return Some("");
            }
            let ratio = motion.fit(degrees, false, si).ratio;
            // A speed in another unit is not one of another time.
            if ratio.is_some_and(|ratio| !MATCHES.contains(&ratio)) {
                self.open_time = Some((place, contradicts(&name)));
                return None;
            }
            if unit != "s" {
                self.doubt(format!(
                    "{name} is taken as {unit}: the speed over ground is then {speed:.1} m/s"
                ));
            }
            return Some(part);
        }
        if is_slow {
            return Some("");
        }
        if self.has_unusual_unit(place, motion.as_ref()) {
            self.open_time = Some((
                place,
                format!("{name} has no usual unit with which the positions are those of a vehicle"),
            ));
            return None;
        }
        Some(self.unit_of_steps(place))
    }

    /// Whether the positions are those of a vehicle in a unit that clocks hardly have, and in no usual one.
    fn has_unusual_unit(&self, place: usize, motion: Option<&Motion>) -> bool {
        let is_vehicle = |si: f64| {
            let speed = motion.and_then(|motion| motion.speed(&READINGS[0], false, si));
            speed.is_some_and(|speed| SPEEDS.contains(&speed))
        };
        // Minutes, hours and days have decimals.
        let has_decimals = || self.grid.numbers(place).iter().any(|time| time.fract() != 0.0);
        let is_of_clock = |(.., si): &(&str, &str, f64)| self.is_of_clock(place, *si);
        let is_of_no_clock = UNITS[..4].iter().any(|unit| is_vehicle(unit.2) && !is_of_clock(unit));
        let is_unusual = |unit: &(&str, &str, f64)| is_vehicle(unit.2) && is_of_clock(unit);
        (has_decimals() || is_of_no_clock) && UNITS[4..].iter().any(is_unusual)
    }

    /// The unit that the usual step of a column of times suggests.
    fn unit_of_steps(&mut self, place: usize) -> &'static str {
        let times = self.grid.numbers(place);
        let step =
            median(times.windows(2).map(|two| two[1] - two[0]).filter(|step| *step > 0.0)).unwrap_or(0.0);
        let (unit, part, _) = UNITS[if step >= 3e6 {
            3
        } else if step >= 3e3 {
            2
        } else {
            usize::from(step >= 3.0)
        }];
        if unit != "s" {
            let name = excerpt(&self.grid.names[place]);
            self.doubt(format!("{name} is taken as {unit}: its usual step is {step}"));
        }
        part
    }

    /// Whether a column in units of this size counts as a clock does.
    fn is_of_clock(&self, place: usize, si: f64) -> bool {
        let first_s = self.grid.numbers(place).first().map_or(0.0, |first| (first * si).abs());
        CLOCKS_S.iter().any(|times| times.contains(&first_s))
    }

    /// What the numbers of a column would mean as times, a line of `[log]` for each unit that gives a log and a vehicle.
    fn units_of_time(&self, place: usize) -> Vec<String> {
        let times = self.grid.numbers(place);
        let steps = || times.windows(2).map(|two| two[1] - two[0]);
        let [Some(first), Some(last)] = [times.first(), times.last()] else { return Vec::new() };
        let forward: Vec<f64> = steps().filter(|step| *step > 0.0).collect();
        let usual = median(forward.iter().copied()).unwrap_or(0.0);
        let regular = forward.iter().filter(|step| (*step - usual).abs() < REGULAR * usual).count();
        let is_time = 2 * regular >= forward.len() && forward.len() * FEWEST_STEPS >= times.len() - 1;
        if steps().any(|step| step < 0.0) || last <= first || !is_time {
            return Vec::new();
        }
        let interval = (last - first) / (times.len() - 1) as f64;
        let motion = self.motion_over(Some((place, TimeFormat::Number)));
        let answer = |(_, part, si): (&str, &str, f64)| {
            let rate_hz = Some(1.0 / (interval * si)).filter(|rate| RATES.contains(rate))?;
            let speed = motion.as_ref().and_then(|motion| motion.speed(&READINGS[0], false, si));
            let speed = speed.filter(|speed| *speed > 0.0);
            if speed.is_some_and(|speed| !SPEEDS.contains(&speed)) || !self.is_of_clock(place, si) {
                return None;
            }
            let speed = speed.map_or(String::new(), |speed| format!(", {speed:.1} m/s over ground"));
            let column = self.column(place, &(part.to_owned() + &self.shift_of(place, si)));
            let answer = format!("time = {column}  # {} Hz{speed}", rounded(rate_hz, 4));
            Some(self.with_smoothing(answer, rate_hz))
        };
        UNITS.into_iter().filter_map(answer).collect()
    }

    /// What a column would mean as one of times, lines of `[log]` for each way to read it.
    fn readings_of_time(&self, place: usize) -> Vec<String> {
        let of_format = |format: TimeFormat| match format {
            TimeFormat::Number => self.units_of_time(place),
            _ => vec![self.reading_of_format(place, format)],
        };
        self.time_formats(place).into_iter().flat_map(of_format).collect()
    }

    fn reading_of_format(&self, place: usize, format: TimeFormat) -> String {
        let first = self.grid.cells(place).next().map_or(String::new(), excerpt);
        let rate_hz = self.rate_over(place, format);
        let rate = rate_hz.map_or(String::new(), |rate_hz| format!(", {} Hz", rounded(rate_hz, 4)));
        let motion = self.motion_over(Some((place, format)));
        let speed = motion.and_then(|motion| motion.by_stamps().speed(&READINGS[0], false, 1.0));
        let speed = speed.map_or(String::new(), |speed| format!(", {speed:.1} m/s over ground"));
        let (column, word) = (self.column(place, ""), format.word());
        let answer = format!("time = {column}\ntime_format = \"{word}\"  # begins at {first}{rate}{speed}");
        self.with_smoothing(answer, rate_hz.unwrap_or(f64::INFINITY))
    }

    /// An answer about the time with the line that smooths rows of a slow rate, which the text cannot have before.
    fn with_smoothing(&self, answer: String, rate_hz: f64) -> String {
        let is_to_smooth = rate_hz < SLOW_HZ && self.value("smooth").is_none();
        if is_to_smooth { answer + "\nsmooth = \"auto\"" } else { answer }
    }

    /// Asks what a column of times means.
    pub(super) fn ask_what_time(&mut self, place: usize, sentence: String) {
        let mut answers = self.readings_of_time(place);
        if answers.is_empty() {
            answers.push(format!("time = {}", self.column(place, "")));
        }
        self.remove("time_format");
        self.ask(Question { sentence, answers });
    }

    /// Asks for the time of a table in which no column is understood as one: a row is never a second.
    pub(super) fn ask_for_time(&mut self) {
        let is_other = |place: &usize| self.places.iter().any(|found| found.place == *place);
        let mut answers = Vec::new();
        let mut columns = 0;
        for place in (0..self.grid.names.len()).filter(|place| !is_other(place)) {
            if columns == MOST {
                break;
            }
            let found = self.readings_of_time(place);
            columns += usize::from(!found.is_empty());
            answers.extend(found);
        }
        let motion = self.motion_over(None);
        let rate_hz = motion.and_then(|motion| {
            let [unit] = motion.speed_units[..] else { return None };
            motion.fit(&READINGS[0], false, 1.0).ratio.map(|ratio| unit / ratio)
        });
        let rate_hz = rate_hz.filter(|rate| RATES.contains(rate));
        let rate = match rate_hz {
            Some(rate_hz) => format!("{:.1}  # by the speed of the table", rate_hz),
            None => "RATE  # the rate of the rows in Hz, if no column has their times".to_owned(),
        };
        let answer = format!("time_format = \"row\"\nrate_hz = {rate}");
        answers.push(self.with_smoothing(answer, rate_hz.unwrap_or(f64::INFINITY)));
        let sentence = "no column is understood as the time".to_owned();
        self.remove("time_format");
        self.ask(Question { sentence, answers });
    }
}

/// The sentence about times that contradict the speed of the table.
fn contradicts(name: &str) -> String {
    format!("{name} has no unit with which the positions have the speed of the table")
}

/// Whether it is as slow as boats and balloons: smaller units make vehicles of them, at rates that hardly a log has.
fn is_slow(motion: &Motion) -> bool {
    let speed = motion.speed(&READINGS[0], false, 1.0).unwrap_or(0.0);
    (SLOWEST..*SPEEDS.start()).contains(&speed)
        && motion.rate_hz(1.0).is_some_and(|rate_hz| rate_hz > RARE_HZ)
}

/// Whether the rows have no higher rate than a log, if times are of this unit.
fn is_rate(motion: &Motion, time_si: f64) -> bool {
    motion.rate_hz(time_si).is_none_or(|rate_hz| rate_hz <= *RATES.end())
}

/// The unit of times with which the positions agree with the speed of the table, alone.
fn unit_that_fits(motion: &Motion) -> Option<(&'static str, &'static str)> {
    let mut fits = Vec::new();
    for reading in [&READINGS[0], &READINGS[READINGS.len() - 1]] {
        if motion.first_place(reading, false).is_none() {
            continue;
        }
        for (unit, part, si) in UNITS.into_iter().filter(|(.., si)| is_rate(motion, *si)) {
            fits.extend(motion.misfit(&motion.fit(reading, false, si)).map(|misfit| ((unit, part), misfit)));
        }
    }
    alone(fits)
}
