//! How times are written in a column: the formats that read its cells.

use super::super::TimeFormat;
use super::motion::{READINGS, median};
use super::times::MATCHES;
use super::{Draft, clock};

/// The formats of texts, the likeliest first.
const TEXTS: [TimeFormat; 5] =
    [TimeFormat::Iso, TimeFormat::Dmy, TimeFormat::Mdy, TimeFormat::Hms, TimeFormat::Mmss];

/// A format that reads none of so many cells at the beginning is none of the column.
const FIRST: usize = 20;

/// Names of columns whose numbers of six digits are hours, minutes and seconds.
const CLOCKS: [&str; 3] = ["utc", "gmt", "clock"];

/// Sizes of numbers that may be times of the clock, the size of their last digit, and how they are read: hhmmss, hhmmssmmm, yymmddhhmmss,
/// yyyymmddhhmmss.
const PACKED: [(core::ops::Range<f64>, f64, TimeFormat); 4] = [
    (0.0..24e4, 1.0, TimeFormat::Hms),
    (1e7..24e7, 1e-3, TimeFormat::Hms),
    (1e11..1e12, 1.0, TimeFormat::Iso),
    (1e13..1e14, 1.0, TimeFormat::Iso),
];

/// The numbers hhmmss exceed seconds by this much more at the end of a minute, and at that of an hour.
const JUMPS: [f64; 2] = [40.0, 4040.0];

impl Draft<'_> {
    fn reads(&self, cell: &str, format: TimeFormat) -> bool {
        // A time has colons, or as 20260314T094320 none.
        let is_text =
            format == TimeFormat::Number || cell.contains(':') || cell.as_bytes().get(8) == Some(&b'T');
        is_text && clock(format).next(&self.grid.separator.with_point(cell)).is_some()
    }

    /// Whether most cells of a column are numbers.
    pub(super) fn has_numbers(&self, place: usize) -> bool {
        let cells = || self.grid.cells(place);
        let are_read = |count: usize| cells().take(count).filter(|cell| self.reads(cell, TimeFormat::Number));
        are_read(FIRST).next().is_some() && 2 * are_read(usize::MAX).count() > cells().count()
    }

    /// The formats in which the cells of a column may be times: those that read most of them. Several: nothing in the column tells.
    pub(super) fn time_formats(&self, place: usize) -> Vec<TimeFormat> {
        if self.has_numbers(place) {
            return self.formats_of_numbers(place);
        }
        let cells = || self.grid.cells(place);
        let count = |format: TimeFormat| {
            let is_possible = cells().take(FIRST).any(|cell| self.reads(cell, format));
            if is_possible { cells().filter(|cell| self.reads(cell, format)).count() } else { 0 }
        };
        let counts = TEXTS.map(|format| (format, count(format)));
        let most = counts.iter().map(|(_, count)| *count).max().unwrap_or(0);
        if 2 * most <= cells().count() {
            return Vec::new();
        }
        let found = counts.into_iter().filter(|(_, count)| *count == most);
        let found: Vec<TimeFormat> = found.map(|(format, _)| format).collect();
        match found[..] {
            // Day or month first: both may read each cell, which is said.
            [TimeFormat::Dmy, ..] => vec![TimeFormat::Dmy],
            // Both read 1:02:03, which no stopwatch needs to be asked about.
            [TimeFormat::Hms, ..] if cells().any(|cell| cell.matches(':').count() == 2) => {
                vec![TimeFormat::Hms]
            }
            _ => found,
        }
    }

    /// Numbers, or hours, minutes and seconds as 091459.5 or 091459500, also behind a date, as 20261128091459: their last two pairs of
    /// digits are below 60, and they jump at the end of a minute, or their name says so.
    fn formats_of_numbers(&self, place: usize) -> Vec<TimeFormat> {
        let numbers = self.grid.numbers(place);
        let first = numbers.first().copied().unwrap_or(-1.0);
        let Some((_, size, clock)) = PACKED.into_iter().find(|(range, ..)| range.contains(&first)) else {
            return vec![TimeFormat::Number];
        };
        let is_day = |number: &f64| {
            let date = (number / 1e6).trunc();
            let [month, day] = [(date / 100.0).trunc() % 100.0, date % 100.0];
            (1.0..=12.0).contains(&month) && (1.0..=31.0).contains(&day)
        };
        // Numbers with a unit behind them are those of durations.
        if clock == TimeFormat::Iso && !numbers.iter().all(is_day) {
            return vec![TimeFormat::Number];
        }
        let of_day = |number: f64| if clock == TimeFormat::Iso { number % 1e6 } else { number * size };
        let numbers: Vec<f64> = numbers.into_iter().map(of_day).collect();
        let is_face = |number: &f64| {
            let [hours, minutes] = [(number / 1e4).trunc(), (number / 100.0).trunc() % 100.0];
            (0.0..24.0).contains(&hours) && minutes < 60.0 && number % 100.0 < 60.0
        };
        if !numbers.iter().all(is_face) {
            return vec![TimeFormat::Number];
        }
        let steps = || numbers.windows(2).map(|two| two[1] - two[0]);
        let usual = median(steps().filter(|step| *step > 0.0)).unwrap_or(0.0);
        let is_excess = |step: f64, excess: f64| (step - usual - excess).abs() <= usual;
        let mut edges = numbers.windows(2).filter(|two| (two[0] / 100.0).trunc() != (two[1] / 100.0).trunc());
        let jumps = |two: &[f64]| JUMPS.iter().any(|jump| is_excess(two[1] - two[0], *jump));
        let name = self.grid.names[place].to_lowercase();
        let is_named = CLOCKS.iter().any(|word| name.contains(word));
        // The first zero may be lost, and those of the first minutes of a day say nothing.
        let has_hours = numbers.iter().all(|number| *number >= 1e4);
        if usual < JUMPS[0] && edges.clone().any(jumps) || is_named && has_hours {
            return vec![clock];
        }
        let is_regular = edges.clone().next().is_some() && edges.all(|two| is_excess(two[1] - two[0], 0.0));
        if has_hours && !is_regular {
            return vec![TimeFormat::Number, clock];
        }
        vec![TimeFormat::Number]
    }

    /// Whether the positions have the speed of the table, roughly, with times in this format; `None`: the table has no speed, or no
    /// positions in degrees or radians.
    pub(super) fn agrees(&self, place: usize, format: TimeFormat) -> Option<bool> {
        let motion = self.motion_over(Some((place, format)))?.by_stamps();
        let readings = [&READINGS[0], &READINGS[READINGS.len() - 1]];
        let possible = readings.into_iter().filter(|reading| motion.first_place(reading, false).is_some());
        let ratios: Vec<f64> = possible.filter_map(|reading| motion.fit(reading, false, 1.0).ratio).collect();
        (!ratios.is_empty()).then(|| ratios.iter().any(|ratio| MATCHES.contains(ratio)))
    }

    /// The mean rate of the rows, by the times of a column in its unit.
    pub(super) fn rate_over(&self, place: usize, format: TimeFormat) -> Option<f64> {
        let mut clock = clock(format);
        let separator = self.grid.separator;
        let times = self.grid.cells(place).filter_map(|cell| clock.next(&separator.with_point(cell)));
        let times: Vec<f64> = times.collect();
        let [first, .., last] = times[..] else { return None };
        Some((times.len() - 1) as f64 / (last - first)).filter(|rate| *rate > 0.0)
    }
}
