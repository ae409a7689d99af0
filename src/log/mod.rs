//! Flight logs: true motion as a table of comma-separated values.
//!
//! The first line that is not a comment (`#`) names the columns, in any order; columns of other names are ignored, and noted if
//! they look like a quantity that the log lacks. Angles are in radians (`latitude_rad`) or in degrees (`latitude_deg`). Velocity, angular
//! rate and specific force come with three columns each or not at all, temperature with one. A row with more fields than columns is
//! rejected, because decimal commas cause it.

mod clock;
mod column;
mod columns;
mod foreign;
mod grid;
mod guess;
mod hemisphere;
mod known;
mod mapping;
mod nameless;
mod quantity;
mod rows;
pub mod smooth;
mod smoothed;
mod survey;
mod text;

use csv::StringRecord;

use crate::base::error::{Error, ErrorKind, Rule, check_integer};
use crate::base::memory::{room, room_for_one_more};
use crate::base::text::{About, Fault, excerpt};
use crate::judge::{At, Finding, Judge};
use crate::truth::FlightSample;
use columns::{columns, only_place, unread};
use rows::{Table, check_line, names_of, next_row, reader, single_blanks};

pub use clock::Clock;
pub use column::{ColumnFrom, LogColumn};
pub use foreign::{FDR, GPX, IGC, foreign};
pub(crate) use hemisphere::sides;
pub use mapping::{LogMapping, Separator, TimeFormat};
#[cfg(test)]
pub(crate) use quantity::ROLL;
pub use quantity::{QUANTITIES, column_of, quantity_of};
pub(crate) use quantity::{Quantity, unit_of, units_of};
pub use smoothed::RowOfPath;
pub use survey::{Survey, survey};
pub use text::decoded;

/// Largest number of columns of a log, and of bytes of a line.
pub const MAX_COLUMNS: usize = 1000;
const MAX_LINE: usize = 1 << 16;

/// A flight log in memory.
#[derive(Debug, Clone, PartialEq)]
pub struct FlightLog {
    /// The comment in its first line; empty: none.
    pub title: String,
    samples: Vec<FlightSample>,
    /// The line of each sample, from 1; none of samples without a text.
    lines: Vec<u64>,
    notes: Vec<Fault>,
    /// Whether its samples have an attitude; otherwise that of a coordinated flight takes its place.
    has_attitude: bool,
    /// What was found in the rows of a smoothed log, and the line of each.
    of_rows: Vec<(Finding, u64)>,
    /// The rows that the path of a smoothed log was fitted to.
    rows: Vec<RowOfPath>,
    /// As which it was read; `None`: the default, also of a log without a text.
    mapping: Option<Box<LogMapping>>,
}

/// Why a text is not a valid log.
#[derive(Debug, Clone, PartialEq)]
pub enum LogError {
    /// The text has a fault.
    Fault(Fault),
    /// There is no memory for the samples.
    Memory(Error),
}

impl LogError {
    /// The columns of the table are not those of a log: a fault about the section `log`, which may name them.
    fn of_columns(line: u64, sentence: String) -> Self {
        let about = About { path: "log".to_owned(), ..About::default() };
        Self::Fault(Fault { line: line as usize, column: 1, sentence, about })
    }

    /// Whether a section `[log]` with names of columns may help.
    pub fn is_about_columns(&self) -> bool {
        matches!(self, Self::Fault(fault) if fault.about.path == "log")
    }
}

fn fault(line: u64, column: usize, sentence: String) -> LogError {
    LogError::Fault(Fault { line: line as usize, column, sentence, ..Fault::default() })
}

impl FlightLog {
    /// Reads the log in a text: at least two samples, in the order of time, with values in their ranges. How they follow each
    /// other is checked when they are pushed.
    pub fn parse(text: &[u8]) -> Result<Self, LogError> {
        Self::parse_with(text, &LogMapping::default())
    }

    /// As [`FlightLog::parse`], of a table that is read as `mapping` says. A row in which a value is missing is then left out; so is, of
    /// a log that will be smoothed, a row that is not later than the one before.
    pub fn parse_with(text: &[u8], mapping: &LogMapping) -> Result<Self, LogError> {
        let text = decoded(text).map_err(LogError::Memory)?;
        Self::parse_log(text.as_bytes(), mapping).map_err(|error| match (&error, foreign(text.as_bytes())) {
            (LogError::Fault(_), Some(what)) if !mapping.is_foreign() => {
                fault(1, 1, format!("is {what}: expected a flight log, a table of comma-separated values"))
            }
            _ => error,
        })
    }

    fn parse_log(text: &[u8], mapping: &LogMapping) -> Result<Self, LogError> {
        for (line, number) in text.split_inclusive(|byte| *byte == b'\n').zip(1..) {
            check_line(line).map_err(|sentence| fault(number, 1, sentence))?;
        }
        let comment = mapping.comment.as_bytes().first().copied().unwrap_or(b'#');
        // The reader takes a comment without a line end, which can only be the last line, for a row.
        let last = text.iter().rposition(|byte| *byte == b'\n').map_or(0, |newline| newline + 1);
        let text = if text[last..].starts_with(&[comment]) { &text[..last] } else { text };
        let with_single_blanks =
            if mapping.separator == Separator::Blanks { single_blanks(text)? } else { Vec::new() };
        let text = if with_single_blanks.is_empty() { text } else { &with_single_blanks };
        let mut reader = reader(text, mapping.separator, Some(comment));
        let mut row = StringRecord::new();
        let first = loop {
            match next_row(&mut reader, text, comment, &mut row)? {
                Some(line) if line < mapping.header => {}
                first => break first,
            }
        };
        let expected = "as time_s,latitude_rad,longitude_rad,height_m,roll_rad,pitch_rad,heading_rad";
        let Some(line) = first else {
            return Err(fault(1, 1, format!("no header: expected the names of the columns, {expected}")));
        };
        if row.len() > MAX_COLUMNS {
            return Err(fault(line, 1, format!("{} columns: a log has at most {MAX_COLUMNS}", row.len())));
        }
        let has_names = mapping.header > 0;
        let names = if has_names { names_of(&row, mapping.separator) } else { row.clone() };
        let columns = columns(&names, line, mapping)?;
        let (header, width) = (row.clone(), names.len());
        let notes = if has_names { unread(&names, line, &columns, mapping) } else { Vec::new() };
        let mut log = Self {
            title: title(text, comment),
            samples: Vec::new(),
            lines: Vec::new(),
            notes,
            of_rows: Vec::new(),
            rows: Vec::new(),
            has_attitude: !mapping.is_coordinated,
            mapping: (*mapping != LogMapping::default()).then(|| Box::new(mapping.clone())),
        };
        let is_mapped = mapping.is_foreign();
        let mut table = Table { columns, mapping, is_mapped, clock: Clock::new(mapping) };
        let (mut left_out, mut repeats, mut to_skip) = (None, 0_u64, mapping.skip);
        let mut late: Option<(u64, u64, f64)> = None;
        let (only, mut others) = (only_place(&names, line, mapping)?, 0_u64);
        // Without names the first row is one of values.
        let mut first = (!has_names).then_some(line);
        loop {
            let line = match first.take() {
                Some(line) => Some(line),
                None => next_row(&mut reader, text, comment, &mut row)?,
            };
            let Some(line) = line else { break };
            if to_skip > 0 {
                to_skip -= 1;
                continue;
            }
            // A recorder that begins anew writes the names anew; a line of blanks has one cell.
            let is_blank = row.len() < width && row.iter().all(str::is_empty);
            if is_mapped && (is_blank || has_names && row == header) {
                continue;
            }
            let is_beyond = |field: &str| !is_mapped || !field.is_empty();
            if row.len() > width && row.iter().skip(width).any(is_beyond) {
                // Decimal commas do this: each value is cut in two, and what stands behind it moves to the next column.
                let sentence = format!(
                    "{} fields, and the header names {width} columns; are there decimal commas?",
                    row.len()
                );
                return Err(fault(line, width + 1, sentence));
            }
            if only.is_some_and(|place| row.get(place) != Some(&mapping.only)) {
                others += 1;
                continue;
            }
            let Some(sample) = table.sample(&row, line)? else {
                let (count, first) = left_out.unwrap_or((0_u64, line));
                left_out = Some((count + 1, first));
                continue;
            };
            if mapping.smooths()
                && let Some(last) = log.samples.last()
                && sample.time_s <= last.time_s
            {
                match sample.time_s == last.time_s && sample.place == last.place {
                    true => repeats += 1,
                    false => late.get_or_insert((0, line, sample.time_s)).0 += 1,
                }
                continue;
            }
            log.push(sample, line)?;
        }
        if let Some((count, line)) = left_out {
            let rows = if count == 1 { "row is" } else { "rows are" };
            let sentence = format!("{count} {rows} left out, the first here: a value is missing");
            log.notes.push(Fault { line: line as usize, column: 1, sentence, ..Fault::default() });
        }
        if others > 0 {
            let (column, only) = (excerpt(&mapping.only_column), excerpt(&mapping.only));
            let sentence = format!("{others} rows of others are left out: {column} is not {only}");
            log.notes.push(Fault { sentence, ..Fault::default() });
        }
        if repeats > 0 {
            let rows = if repeats == 1 { "row is" } else { "rows are" };
            let sentence = format!("{repeats} {rows} left out: at the time of the row before");
            log.notes.push(Fault { sentence, ..Fault::default() });
        }
        if let Some((count, line, time_s)) = late {
            let at = At { row: log.samples.partition_point(|sample| sample.time_s < time_s) as u64, time_s };
            let rows = count + log.samples.len() as u64;
            log.of_rows.push((Finding::of_late_rows(count, rows, at), line));
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

    /// Adds the sample of a line, which is later than the one before.
    fn push(&mut self, sample: FlightSample, line: u64) -> Result<(), LogError> {
        if let Some(last) = self.samples.last()
            && sample.time_s <= last.time_s
        {
            let sentence =
                format!("time_s = {}: not later than the sample before, {}", sample.time_s, last.time_s);
            return Err(fault(line, 1, sentence));
        }
        let first_s = self.samples.first().map_or(sample.time_s, |first| first.time_s);
        let latest_s = FlightSample::LATEST_S;
        if sample.time_s - first_s > latest_s {
            let sentence = format!(
                "time_s = {:e}: must be at most {latest_s:e} s after the first sample, {first_s:e}",
                sample.time_s
            );
            return Err(fault(line, 1, sentence));
        }
        room_for_one_more(&mut self.samples).map_err(LogError::Memory)?;
        room_for_one_more(&mut self.lines).map_err(LogError::Memory)?;
        self.samples.push(sample);
        self.lines.push(line);
        Ok(())
    }

    /// An empty log with room for `count` samples that come from no text.
    pub(crate) fn with_room(count: usize) -> Result<Self, Error> {
        check_integer("count", count, 2, u64::MAX)?;
        let samples = room(count)?;
        Ok(Self {
            title: String::new(),
            samples,
            lines: Vec::new(),
            notes: Vec::new(),
            of_rows: Vec::new(),
            rows: Vec::new(),
            has_attitude: true,
            mapping: None,
        })
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

    /// Whether it was read as `mapping` says.
    pub(crate) fn was_read_as(&self, mapping: &LogMapping) -> bool {
        self.mapping.as_deref().map_or(*mapping == LogMapping::default(), |own| own == mapping)
    }

    /// What is no fault, and yet hardly meant: columns that are not read, and look like a quantity.
    pub fn notes(&self) -> &[Fault] {
        &self.notes
    }

    /// Whether its samples have an attitude; otherwise that of a coordinated flight takes its place.
    pub fn has_attitude(&self) -> bool {
        self.has_attitude
    }

    /// Pushes its first `count` samples into `judge`, and what was found in the rows of a smoothed log. An error has the number of a
    /// sample.
    pub fn judge(&self, judge: &mut Judge, count: usize) -> Result<(), (usize, Error)> {
        if !self.has_attitude {
            judge.ignore_attitude();
        }
        judge.add_of_rows(self.of_rows.iter().map(|(finding, _)| *finding));
        for (index, sample) in self.samples.iter().take(count).enumerate() {
            judge.push(sample).map_err(|error| (index, error))?;
        }
        Ok(())
    }

    /// The rows that the path of a smoothed log was fitted to, from its start on, also those without weight; empty: it is no path.
    pub fn rows(&self) -> &[RowOfPath] {
        &self.rows
    }

    /// What was found in the rows when they were read or smoothed, each with its line.
    pub fn of_rows(&self) -> &[(Finding, u64)] {
        &self.of_rows
    }

    /// The line of a finding of its judge, from 1.
    pub fn line_of(&self, finding: &Finding) -> Option<u64> {
        let of_row = self.of_rows.iter().find(|(known, _)| known == finding).map(|(_, line)| *line);
        of_row.or_else(|| self.line(finding.at.row as usize)).filter(|_| finding.count > 0)
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
fn title(text: &[u8], comment: u8) -> String {
    let mark = char::from(comment);
    let first = text.split(|byte| *byte == b'\n').next().unwrap_or_default();
    let first = String::from_utf8_lossy(first);
    let comment = first.strip_prefix(mark).unwrap_or_default();
    comment.trim_start_matches(mark).trim().chars().filter(|letter| !letter.is_control()).take(160).collect()
}
