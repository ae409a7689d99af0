//! The rows of a log: lines, values, samples.

use csv::StringRecord;
use nalgebra::{Quaternion, Vector3};

use super::clock::Clock;
use super::columns::{COUNT, Columns, has, has_quaternion};
use super::quantity::{
    FORCE, FORWARD, GEOID, Q0, RATE, SPEED, TEMPERATURE, TRACK, VARIATION, VELOCITY, name, quantity_of,
};
use super::{LogError, LogMapping, MAX_LINE, Separator, fault};
use crate::base::error::Error;
use crate::base::math::{Euler, attitude_from_euler, euler_from_attitude, rotate, sin_cos};
use crate::earth::Geodetic;
use crate::scene::excerpt;
use crate::truth::FlightSample;

/// Checks a line with its end, so that each row has a line number of its own.
pub fn check_line(line: &[u8]) -> Result<(), String> {
    let line = line.strip_suffix(b"\n").map_or(line, |line| line.strip_suffix(b"\r").unwrap_or(line));
    if line.contains(&0) {
        return Err("a zero byte: not a text".to_owned());
    }
    if line.len() > MAX_LINE {
        return Err(format!("a line of {} bytes: a line has at most {MAX_LINE}", line.len()));
    }
    if line.contains(&b'\r') {
        return Err("a carriage return without a line feed: lines end with LF or CR LF".to_owned());
    }
    Ok(())
}

/// Reads the next row of `text` and gives its line; `None` at the end.
pub fn next_row(
    reader: &mut csv::Reader<&[u8]>,
    text: &[u8],
    comment: u8,
    row: &mut StringRecord,
) -> Result<Option<u64>, LogError> {
    let before = reader.position().clone();
    let line = || {
        // The reader's position is that before the empty lines and comments that it passes over.
        let rest = text.get(before.byte() as usize..).unwrap_or_default();
        let is_skipped = |line: &&[u8]| line.starts_with(&[comment]) || matches!(*line, b"" | b"\r");
        before.line() + rest.split(|byte| *byte == b'\n').take_while(is_skipped).count() as u64
    };
    match reader.read_record(row) {
        Ok(true) => Ok(Some(line())),
        Ok(false) => Ok(None),
        Err(error) => {
            let sentence = match error.kind() {
                csv::ErrorKind::Utf8 { .. } => "not UTF-8".to_owned(),
                _ => "not a row of comma-separated values".to_owned(),
            };
            Err(fault(line(), 1, sentence))
        }
    }
}

/// What the rows have in common.
pub struct Table<'m> {
    pub columns: Columns,
    pub mapping: &'m LogMapping,
    /// Whether the log is read by a mapping: cells may then be missing.
    pub is_mapped: bool,
    pub clock: Clock,
}

impl Table<'_> {
    /// The sample of a row, with each value in its range; `None`: a value is missing.
    pub fn sample(&mut self, row: &StringRecord, line: u64) -> Result<Option<FlightSample>, LogError> {
        let mut values = [0.0; COUNT];
        // A row without times has the next one, whatever is missing.
        let mut is_whole = true;
        if self.columns[0].is_none() {
            values[0] = self.clock.next("").unwrap_or_default();
        }
        for (quantity, column) in self.columns.iter().enumerate() {
            let Some(column) = column else { continue };
            let Some(place) = column.place else {
                values[quantity] = column.offset;
                continue;
            };
            let name = &column.name;
            let Some(text) = row.get(place) else {
                return Err(fault(line, place + 1, format!("the line ends before {name}")));
            };
            if self.is_mapped && is_missing(text, self.mapping.missing) {
                is_whole = false;
                continue;
            }
            let is_time = quantity == 0;
            let number = match is_time {
                true if self.mapping.separator == Separator::Comma => self.clock.next(text),
                true => self.clock.next(&text.replace(',', ".")),
                false => number(text, self.mapping.separator),
            };
            let Some(number) = number else {
                let what = if is_time { self.clock.expected() } else { "a finite number" };
                let sentence = format!("{name}: expected {what}, found \"{}\"", excerpt(text));
                return Err(fault(line, place + 1, sentence));
            };
            let factor = if is_time && !self.clock.is_number() { 1.0 } else { column.factor };
            values[quantity] = number * factor;
            // Without an offset a value keeps its bits, also -0.
            if column.offset != 0.0 {
                values[quantity] += column.offset;
            }
        }
        if !is_whole {
            return Ok(None);
        }
        let sample = self.of_values(&values);
        sample.validate().map_err(|error| out_of_range(&error, line, &self.columns))?;
        Ok(Some(sample))
    }

    fn of_values(&self, values: &[f64; COUNT]) -> FlightSample {
        let columns = &self.columns;
        let three = |first: usize| Vector3::new(values[first], values[first + 1], values[first + 2]);
        let triple = |first: usize| columns[first].as_ref().map(|_| three(first));
        let &[time_s, latitude_rad, longitude_rad, mut height_m, roll, pitch, mut heading, ..] = values;
        let variation_rad = values[VARIATION];
        if columns[GEOID].is_some() {
            height_m += values[GEOID];
        }
        let euler = if has_quaternion(columns) {
            // Forward-right-down to north-east-down is right-forward-up to east-north-up with x and y exchanged, and z reversed.
            let [w, x, y, z] = [0, 1, 2, 3].map(|index| values[Q0 + index]);
            euler_from_attitude(&Quaternion::new(w, y, x, -z).normalize())
        } else {
            if columns[VARIATION].is_some() {
                heading += variation_rad;
            }
            Euler { roll, pitch, heading }
        };
        let v_n = if has(columns, SPEED..FORWARD) {
            let magnetic_rad = if self.mapping.is_track_magnetic { variation_rad } else { 0.0 };
            let (sine, cosine) = sin_cos(values[TRACK] + magnetic_rad);
            let speed = values[SPEED];
            Some(Vector3::new(speed * sine, speed * cosine, values[SPEED + 2]))
        } else if has(columns, FORWARD..Q0) {
            let [forward, right, down] = three(FORWARD).into();
            Some(rotate(&attitude_from_euler(&euler), &Vector3::new(right, forward, -down)))
        } else {
            triple(VELOCITY)
        };
        FlightSample {
            time_s,
            place: Geodetic { latitude_rad, longitude_rad, height_m },
            v_n,
            euler,
            omega_ib_b: triple(RATE),
            f_b: triple(FORCE),
            temperature_c: columns[TEMPERATURE].as_ref().map(|_| values[TEMPERATURE]),
        }
    }
}

/// Whether a cell has no value.
fn is_missing(text: &str, missing: Option<f64>) -> bool {
    let is_it = |missing: f64| text.parse::<f64>().is_ok_and(|number| number == missing);
    text.is_empty() || text.eq_ignore_ascii_case("nan") || missing.is_some_and(is_it)
}

/// The number in a cell. Where fields are not separated by commas, decimals may follow one.
fn number(text: &str, separator: Separator) -> Option<f64> {
    let number = text.parse().ok().or_else(|| {
        let may_have_comma = separator != Separator::Comma && text.matches(',').count() == 1;
        may_have_comma.then(|| text.replace(',', ".").parse().ok()).flatten()
    });
    number.filter(|number: &f64| number.is_finite())
}

/// A value out of its range: its column and its limits in the unit of the column.
fn out_of_range(error: &Error, line: u64, columns: &Columns) -> LogError {
    let quantity = quantity_of(error);
    let column = quantity.and_then(|index| Some((index, columns[index].as_ref()?)));
    let Some((quantity, column)) = column else {
        return fault(line, 1, error.to_string());
    };
    let own = Error { field: name(quantity), index: None, ..*error };
    let sentence = if column.name == name(quantity) {
        own.to_string()
    } else if column.offset == 0.0 && column.factor > 0.0 {
        own.in_unit(column.factor).sentence_about(&column.name)
    } else {
        own.sentence_about(&column.name)
    };
    fault(line, column.place.map_or(1, |place| place + 1), sentence)
}
