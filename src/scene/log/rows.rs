//! The rows of a log: lines, values, samples.

use csv::StringRecord;
use nalgebra::Vector3;

use super::columns::{COUNT, Column, FORCE, RATE, TEMPERATURE, VELOCITY, name, quantity_of};
use super::{LogError, MAX_LINE, fault};
use crate::base::error::Error;
use crate::base::math::Euler;
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
    row: &mut StringRecord,
) -> Result<Option<u64>, LogError> {
    let before = reader.position().clone();
    let line = || {
        // The reader's position is that before the empty lines and comments that it passes over.
        let rest = text.get(before.byte() as usize..).unwrap_or_default();
        let is_skipped = |line: &&[u8]| line.starts_with(b"#") || matches!(*line, b"" | b"\r");
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

/// The sample of a row, with each value in its range.
pub fn sample(
    row: &StringRecord,
    line: u64,
    columns: &[Option<Column>; COUNT],
) -> Result<FlightSample, LogError> {
    let mut values = [0.0; COUNT];
    for (quantity, column) in columns.iter().enumerate() {
        let Some(column) = column else { continue };
        let Some(text) = row.get(column.place) else {
            return Err(fault(
                line,
                column.place + 1,
                format!("the line ends before {}", column.name(quantity)),
            ));
        };
        match text.parse::<f64>() {
            Ok(value) if value.is_finite() => values[quantity] = value * column.si,
            _ => {
                let name = column.name(quantity);
                let sentence = format!("{name}: expected a finite number, found \"{}\"", excerpt(text));
                return Err(fault(line, column.place + 1, sentence));
            }
        }
    }
    let triple = |first: usize| {
        columns[first].map(|_| Vector3::new(values[first], values[first + 1], values[first + 2]))
    };
    let [time_s, latitude_rad, longitude_rad, height_m, roll, pitch, heading, ..] = values;
    let sample = FlightSample {
        time_s,
        place: Geodetic { latitude_rad, longitude_rad, height_m },
        v_n: triple(VELOCITY),
        euler: Euler { roll, pitch, heading },
        omega_ib_b: triple(RATE),
        f_b: triple(FORCE),
        temperature_c: columns[TEMPERATURE].map(|_| values[TEMPERATURE]),
    };
    sample.validate().map_err(|error| out_of_range(&error, line, columns))?;
    Ok(sample)
}

/// A value out of its range: its column and its limits in the unit of the column.
fn out_of_range(error: &Error, line: u64, columns: &[Option<Column>; COUNT]) -> LogError {
    let quantity = quantity_of(error);
    let Some((quantity, column)) = quantity.and_then(|index| columns[index].map(|column| (index, column)))
    else {
        return fault(line, 1, error.to_string());
    };
    let own = Error { field: name(quantity), index: None, ..*error };
    let sentence = match column.si {
        1.0 => own.to_string(),
        si => own.in_unit(si).sentence_about(&column.name(quantity)),
    };
    fault(line, column.place + 1, sentence)
}
