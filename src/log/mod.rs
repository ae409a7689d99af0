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
mod imu;
mod joined;
mod known;
mod lines;
mod mapping;
mod marks;
mod nameless;
mod parse;
mod quantity;
mod reading;
mod record;
mod rows;
pub mod smooth;
mod smoothed;
mod survey;
mod text;
mod unread;
mod words;

use crate::base::error::{Error, ErrorKind, Rule, check_integer};
use crate::base::memory::{room, room_for_one_more};
use crate::base::text::{About, Fault};
use crate::judge::{Finding, Judge};
use crate::truth::FlightSample;
use smoothed::Smoothing;
use unread::Unread;

pub use clock::Clock;
pub use column::{ColumnFrom, LogColumn};
pub use foreign::{Foreign, foreign};
pub(crate) use hemisphere::sides;
pub use imu::{ImuColumn, ImuTable};
pub use joined::FilesError;
pub use mapping::{LogMapping, Separator, TimeFormat};
pub(crate) use quantity::{DDMM, Quantity, unit_of, units_of};
pub use quantity::{IMU_QUANTITIES, ImuUnit, QUANTITIES, column_of, imu_units, quantity_of};
pub use smoothed::RowOfPath;
pub use survey::{Question, Survey, nearest_names, survey};
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
    /// Whether its rows have an attitude; otherwise that of a coordinated flight takes its place.
    has_attitude: bool,
    /// What was found in the rows of a smoothed log, and the line of each.
    of_rows: Vec<(Finding, u64)>,
    /// The rows that the path of a smoothed log was fitted to.
    rows: Vec<RowOfPath>,
    /// As which it was read; `None`: the default, also of a log without a text.
    mapping: Option<Box<LogMapping>>,
    /// How its path is still to be smoothed; `None`: not at all.
    smoothing: Option<Smoothing>,
    /// The columns of its motion that were not read, and the line of their names; none once they are compared with what flies.
    unread: (Vec<Unread>, u64),
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

/// A fault at its place; `line` 0: of the log as a whole.
fn fault(line: u64, column: usize, sentence: String) -> LogError {
    let column = if line == 0 { 0 } else { column };
    LogError::Fault(Fault { line: line as usize, column, sentence, ..Fault::default() })
}

impl FlightLog {
    /// An empty log with room for `count` samples that come from no text.
    pub fn with_room(count: usize) -> Result<Self, Error> {
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
            smoothing: None,
            unread: (Vec::new(), 0),
        })
    }

    /// Appends a sample with values in their ranges, later than the one before.
    pub fn append(&mut self, sample: FlightSample) -> Result<(), Error> {
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

    /// Whether its path is to be smoothed ([`Self::smoothed`]) before it flies: its mapping says so, or it is a flight record.
    pub fn is_to_be_smoothed(&self) -> bool {
        self.smoothing.is_some()
    }

    /// What was assumed, and what is no fault, and yet hardly meant: columns that are not read, and look like a quantity.
    pub fn notes(&self) -> &[Fault] {
        &self.notes
    }

    /// Whether its rows have an attitude; otherwise that of a coordinated flight takes its place.
    pub fn has_attitude(&self) -> bool {
        self.has_attitude
    }

    /// Pushes its first `count` samples into `judge`, and what was found in the rows of a smoothed log. An error has the number of a
    /// sample.
    pub fn judge(&self, judge: &mut Judge, count: usize) -> Result<(), (usize, Error)> {
        if !self.has_attitude {
            judge.ignore_attitude();
        }
        if !self.rows.is_empty() {
            judge.expect_path();
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

    /// The line of a finding of its judge, from 1; `None`: it is of the whole log.
    pub fn line_of(&self, finding: &Finding) -> Option<u64> {
        let of_row = self.of_rows.iter().find(|(known, _)| known == finding).map(|(_, line)| *line);
        of_row.or_else(|| self.line(finding.at.row as usize)).filter(|line| *line > 0 && finding.count > 0)
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
