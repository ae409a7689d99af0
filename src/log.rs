//! Flight logs: true motion as a table of comma-separated values.
//!
//! The first line that is not a comment (`#`) names the columns, in any order; columns of other names are ignored. Angles
//! are in radians (`latitude_rad`) or in degrees (`latitude_deg`). Velocity, angular rate and specific force come with
//! three columns each or not at all, temperature with one. A row with more fields than columns is rejected, because decimal
//! commas cause it.

use core::ops::Range;

use csv::{ReaderBuilder, StringRecord, Trim};
use nalgebra::Vector3;

use crate::earth::Geodetic;
use crate::error::Error;
use crate::math::Euler;
use crate::memory::room_for_one_more;
use crate::scene::{Fault, excerpt, nearest};
use crate::truth::FlightSample;
use crate::units::DEG;

/// The quantities of a log. An angle may be in degrees: the name then ends in `_deg`.
const QUANTITIES: [&str; 17] = [
    "time_s",
    "latitude_rad",
    "longitude_rad",
    "height_m",
    "roll_rad",
    "pitch_rad",
    "heading_rad",
    "velocity_east_m_s",
    "velocity_north_m_s",
    "velocity_up_m_s",
    "rate_x_rad_s",
    "rate_y_rad_s",
    "rate_z_rad_s",
    "force_x_m_s2",
    "force_y_m_s2",
    "force_z_m_s2",
    "temperature_c",
];

/// The first of the quantities that a log may leave out.
const VELOCITY: usize = 7;
const RATE: usize = 10;
const FORCE: usize = 13;
const TEMPERATURE: usize = 16;

/// The quantities that come together: all of them or none.
const TRIPLES: [Range<usize>; 3] = [VELOCITY..RATE, RATE..FORCE, FORCE..TEMPERATURE];

/// Largest number of columns of a log, and of bytes of a line.
const MAX_COLUMNS: usize = 1000;
const MAX_LINE: usize = 1 << 16;

/// A flight log in memory.
#[derive(Debug, Clone, PartialEq)]
pub struct FlightLog {
    /// The comment in its first line; empty: none.
    pub title: String,
    samples: Vec<FlightSample>,
    /// The line of each sample, from 1.
    lines: Vec<u64>,
}

/// Why a text is not a valid log.
#[derive(Debug, Clone, PartialEq)]
pub enum LogError {
    /// The text has a fault.
    Fault(Fault),
    /// There is no memory for the samples.
    Memory(Error),
}

/// Place of a quantity in a row, and its unit.
#[derive(Clone, Copy)]
struct Column {
    place: usize,
    si: f64,
}

fn fault(line: u64, column: usize, sentence: String) -> LogError {
    LogError::Fault(Fault { line: line as usize, column, sentence, ..Fault::default() })
}

impl FlightLog {
    /// Reads the log in a text: at least two samples, in the order of time. The ranges of the samples are checked when they are pushed.
    pub fn parse(text: &[u8]) -> Result<Self, LogError> {
        let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
        for (line, number) in text.split_inclusive(|byte| *byte == b'\n').zip(1..) {
            check_line(line).map_err(|sentence| fault(number, 1, sentence))?;
        }
        // The reader takes a comment without a line end, which can only be the last line, for a row.
        let last = text.iter().rposition(|byte| *byte == b'\n').map_or(0, |newline| newline + 1);
        let text = if text[last..].starts_with(b"#") { &text[..last] } else { text };
        let mut reader = ReaderBuilder::new()
            .comment(Some(b'#'))
            .flexible(true)
            .has_headers(false)
            .trim(Trim::All)
            .from_reader(text);
        let mut row = StringRecord::new();
        let names = "as time_s,latitude_rad,longitude_rad,height_m,roll_rad,pitch_rad,heading_rad";
        let Some(line) = next_row(&mut reader, text, &mut row)? else {
            return Err(fault(1, 1, format!("no header: expected the names of the columns, {names}")));
        };
        if row.len() > MAX_COLUMNS {
            return Err(fault(line, 1, format!("{} columns: a log has at most {MAX_COLUMNS}", row.len())));
        }
        let columns = columns(&row, line)?;
        let width = row.len();
        let mut log = Self { title: title(text), samples: Vec::new(), lines: Vec::new() };
        while let Some(line) = next_row(&mut reader, text, &mut row)? {
            if row.len() > width {
                // Decimal commas do this: each value is cut in two, and what stands behind it moves to the next column.
                let sentence = format!("{} fields, and the header names {width} columns", row.len());
                return Err(fault(line, width + 1, sentence));
            }
            let sample = sample(&row, line, &columns)?;
            if let Some(last) = log.samples.last()
                && sample.time_s <= last.time_s
            {
                let sentence =
                    format!("time_s = {}: not later than the sample before, {}", sample.time_s, last.time_s);
                return Err(fault(line, 1, sentence));
            }
            let first_s = log.samples.first().map_or(sample.time_s, |first| first.time_s);
            let latest_s = FlightSample::LATEST_S;
            if sample.time_s - first_s > latest_s {
                let sentence = format!(
                    "time_s = {:e}: must be at most {latest_s:e} s after the first sample, {first_s:e}",
                    sample.time_s
                );
                return Err(fault(line, 1, sentence));
            }
            room_for_one_more(&mut log.samples).map_err(LogError::Memory)?;
            room_for_one_more(&mut log.lines).map_err(LogError::Memory)?;
            log.samples.push(sample);
            log.lines.push(line);
        }
        if log.samples.len() < 2 {
            let line = 1 + text.iter().filter(|byte| **byte == b'\n').count();
            return Err(fault(
                line as u64,
                1,
                format!("{} samples: a flight has at least two", log.samples.len()),
            ));
        }
        Ok(log)
    }

    /// Its samples, in the order of time.
    pub fn samples(&self) -> &[FlightSample] {
        &self.samples
    }

    /// The line on which sample `index` stands, from 1.
    pub fn line(&self, index: usize) -> Option<u64> {
        self.lines.get(index).copied()
    }

    /// From the first to the last sample [s].
    pub fn duration_s(&self) -> f64 {
        match self.samples.as_slice() {
            [first, .., last] => last.time_s - first.time_s,
            _ => 0.0,
        }
    }
}

/// Checks a line with its end, so that each row has a line number of its own.
fn check_line(line: &[u8]) -> Result<(), String> {
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
fn next_row(
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

/// The comment with which a log begins.
fn title(text: &[u8]) -> String {
    let first = text.split(|byte| *byte == b'\n').next().unwrap_or_default();
    let first = String::from_utf8_lossy(first);
    let comment = first.strip_prefix('#').unwrap_or_default();
    comment.trim_start_matches('#').trim().chars().filter(|letter| !letter.is_control()).take(160).collect()
}

fn in_degrees(quantity: &str) -> Option<String> {
    // Rates can be given only in radians.
    let stem = quantity.strip_suffix("_rad")?;
    Some(format!("{stem}_deg"))
}

fn columns(header: &StringRecord, line: u64) -> Result<[Option<Column>; QUANTITIES.len()], LogError> {
    let mut columns = [None; QUANTITIES.len()];
    for (column, quantity) in columns.iter_mut().zip(QUANTITIES) {
        let degrees = in_degrees(quantity);
        for (place, name) in header.iter().enumerate() {
            let si = match name {
                _ if name == quantity => 1.0,
                _ if Some(name) == degrees.as_deref() => DEG,
                _ => continue,
            };
            if column.is_some() {
                let sentence = format!("{name}: an earlier column has that quantity");
                return Err(fault(line, place + 1, sentence));
            }
            *column = Some(Column { place, si });
        }
    }
    let is_wanted = |index: usize| {
        let triple = TRIPLES.iter().find(|triple| triple.contains(&index));
        match triple {
            Some(triple) => columns[triple.clone()].iter().any(Option::is_some),
            None => index < VELOCITY,
        }
    };
    let missing = (0..QUANTITIES.len()).filter(|&index| columns[index].is_none() && is_wanted(index));
    let missing: Vec<String> = missing.map(|index| missing_column(QUANTITIES[index], header)).collect();
    if missing.is_empty() {
        Ok(columns)
    } else {
        Err(fault(line, 1, format!("missing columns: {}", missing.join(", "))))
    }
}

/// The name of a missing column, with the name of its form in degrees and the name that may have been meant.
fn missing_column(quantity: &str, header: &StringRecord) -> String {
    let degrees = in_degrees(quantity).map_or(String::new(), |name| format!(" or {name}"));
    let unknown = header.iter().filter(|name| !QUANTITIES.contains(name));
    let near = nearest(quantity, unknown).map_or(String::new(), |name| format!(" (found {})", excerpt(name)));
    format!("{quantity}{degrees}{near}")
}

fn sample(
    row: &StringRecord,
    line: u64,
    columns: &[Option<Column>; QUANTITIES.len()],
) -> Result<FlightSample, LogError> {
    let mut values = [0.0; QUANTITIES.len()];
    for (index, column) in columns.iter().enumerate() {
        let Some(Column { place, si }) = column else { continue };
        let quantity = QUANTITIES[index];
        let Some(text) = row.get(*place) else {
            return Err(fault(line, place + 1, format!("the line ends before {quantity}")));
        };
        match text.parse::<f64>() {
            Ok(value) if value.is_finite() => values[index] = value * si,
            _ => {
                let sentence = format!("{quantity}: expected a finite number, found \"{}\"", excerpt(text));
                return Err(fault(line, place + 1, sentence));
            }
        }
    }
    let triple = |first: usize| {
        columns[first].map(|_| Vector3::new(values[first], values[first + 1], values[first + 2]))
    };
    let [time_s, latitude_rad, longitude_rad, height_m, roll, pitch, heading, ..] = values;
    Ok(FlightSample {
        time_s,
        place: Geodetic { latitude_rad, longitude_rad, height_m },
        v_n: triple(VELOCITY),
        euler: Euler { roll, pitch, heading },
        omega_ib_b: triple(RATE),
        f_b: triple(FORCE),
        temperature_c: columns[TEMPERATURE].map(|_| values[TEMPERATURE]),
    })
}
