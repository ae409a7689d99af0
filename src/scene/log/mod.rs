//! Flight logs: true motion as a table of comma-separated values.
//!
//! The first line that is not a comment (`#`) names the columns, in any order; columns of other names are ignored. Angles
//! are in radians (`latitude_rad`) or in degrees (`latitude_deg`). Velocity, angular rate and specific force come with
//! three columns each or not at all, temperature with one. A row with more fields than columns is rejected, because decimal
//! commas cause it.

mod columns;
mod rows;

use csv::{ReaderBuilder, StringRecord, Trim};

use crate::base::error::{Error, ErrorKind, Rule, check_integer};
use crate::base::memory::{room, room_for_one_more};
use crate::scene::{Fault, foreign};
use crate::truth::FlightSample;
use columns::columns;
use rows::{check_line, next_row, sample};

pub use columns::{column_of, quantity_of};

/// Largest number of columns of a log, and of bytes of a line.
const MAX_COLUMNS: usize = 1000;
const MAX_LINE: usize = 1 << 16;

/// A flight log in memory.
#[derive(Debug, Clone, PartialEq)]
pub struct FlightLog {
    /// The comment in its first line; empty: none.
    pub title: String,
    samples: Vec<FlightSample>,
    /// The line of each sample, from 1; none of samples without a text.
    lines: Vec<u64>,
}

/// Columns that a log needs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reading {
    /// Time, position and attitude.
    Whole,
    /// Time and position; columns of the attitude are not read, and the angles of the samples are 0.
    WithoutAttitude,
}

/// Why a text is not a valid log.
#[derive(Debug, Clone, PartialEq)]
pub enum LogError {
    /// The text has a fault.
    Fault(Fault),
    /// There is no memory for the samples.
    Memory(Error),
}

fn fault(line: u64, column: usize, sentence: String) -> LogError {
    LogError::Fault(Fault { line: line as usize, column, sentence, ..Fault::default() })
}

impl FlightLog {
    /// Reads the log in a text: at least two samples, in the order of time, with values in their ranges. How they follow each
    /// other is checked when they are pushed.
    pub fn parse(text: &[u8]) -> Result<Self, LogError> {
        Self::parse_as(text, Reading::Whole)
    }

    /// As [`FlightLog::parse`], of a log that has what `reading` needs.
    pub fn parse_as(text: &[u8], reading: Reading) -> Result<Self, LogError> {
        Self::parse_log(text, reading).map_err(|error| match (&error, foreign(text)) {
            (LogError::Fault(_), Some(what)) => {
                fault(1, 1, format!("is {what}: expected a flight log, a table of comma-separated values"))
            }
            _ => error,
        })
    }

    fn parse_log(text: &[u8], reading: Reading) -> Result<Self, LogError> {
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
        let columns = columns(&row, line, reading)?;
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

    /// An empty log with room for `count` samples that come from no text.
    pub(crate) fn with_room(count: usize) -> Result<Self, Error> {
        check_integer("count", count, 2, u64::MAX)?;
        Ok(Self { title: String::new(), samples: room(count)?, lines: Vec::new() })
    }

    /// Appends a sample with values in their ranges, later than the one before.
    pub(crate) fn append(&mut self, sample: FlightSample) -> Result<(), Error> {
        sample.validate()?;
        if let Some(last) = self.samples.last()
            && sample.time_s <= last.time_s
        {
            let rule = Rule::SentenceWith("must be later than the sample before, at", last.time_s.into());
            return Err(Error::of(ErrorKind::TimeOrder, "sample.time_s", sample.time_s, rule));
        }
        room_for_one_more(&mut self.samples)?;
        self.samples.push(sample);
        Ok(())
    }

    /// Its samples, in the order of time.
    pub fn samples(&self) -> &[FlightSample] {
        &self.samples
    }

    /// The line of the text on which sample `index` stands, from 1.
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

/// The comment with which a log begins.
fn title(text: &[u8]) -> String {
    let first = text.split(|byte| *byte == b'\n').next().unwrap_or_default();
    let first = String::from_utf8_lossy(first);
    let comment = first.strip_prefix('#').unwrap_or_default();
    comment.trim_start_matches('#').trim().chars().filter(|letter| !letter.is_control()).take(160).collect()
}
