//! Flight records that are no tables: each is read to rows of numbers under names of columns, which a `[log]` may name too.

mod fdr;
mod gpx;
mod igc;

use super::column::LogColumn;
use super::foreign::Foreign;
use super::mapping::LogMapping;
use super::unread::Unread;
use super::{LogError, fault};
use crate::base::memory::room_for_one_more;
use crate::base::records::rounded;

/// The rows of a flight record.
pub struct FlightRecord {
    /// Names of the columns; the first is the time.
    pub names: &'static [&'static str],
    /// What else it has of the motion, in the columns behind these.
    pub beside: Vec<Unread>,
    /// What was assumed, in a sentence.
    pub note: String,
    /// The numbers, row by row; NaN: none of what stands beside.
    values: Vec<f64>,
    /// The line of each row in the file, from 1.
    lines: Vec<u64>,
}

impl FlightRecord {
    /// The record of this kind in a text; `None`: files of this kind are no records.
    pub fn read(kind: Foreign, text: &str) -> Result<Option<Self>, LogError> {
        match kind {
            Foreign::Igc => igc::record(text).map(Some),
            Foreign::Gpx => gpx::record(text).map(Some),
            Foreign::Fdr => fdr::record(text).map(Some),
            Foreign::Other(_) => Ok(None),
        }
    }

    /// No rows under these names.
    fn new(names: &'static [&'static str]) -> Self {
        Self { names, beside: Vec::new(), note: String::new(), values: Vec::new(), lines: Vec::new() }
    }

    /// Adds a row, which stands on `line`, with what it has beside.
    fn push(&mut self, line: u64, row: &[f64], beside: &[f64]) -> Result<(), LogError> {
        for &value in row.iter().chain(beside) {
            room_for_one_more(&mut self.values).map_err(LogError::Memory)?;
            self.values.push(value);
        }
        room_for_one_more(&mut self.lines).map_err(LogError::Memory)?;
        self.lines.push(line);
        Ok(())
    }

    /// Number of rows.
    fn count(&self) -> u64 {
        self.lines.len() as u64
    }

    /// The rows, each with its line.
    pub fn rows(&self) -> impl Iterator<Item = (&[f64], u64)> {
        self.values.chunks_exact(self.names.len() + self.beside.len()).zip(self.lines.iter().copied())
    }

    /// The intervals between rows in words. A repeated stamp has none: its row is left out.
    fn spacing(&self) -> String {
        let times = || self.rows().map(|(row, _)| row[0]);
        let intervals = times().zip(times().skip(1)).map(|(before_s, time_s)| time_s - before_s);
        let [shortest_s, longest_s] = intervals
            .filter(|interval_s| *interval_s > 0.0)
            .fold([f64::INFINITY, 0.0], |ends: [f64; 2], one| [ends[0].min(one), ends[1].max(one)]);
        let [shortest, longest] = [shortest_s, longest_s].map(|interval_s| rounded(interval_s, 6));
        if shortest == longest {
            format!("{longest} s apart")
        } else {
            format!("{shortest} to {longest} s apart")
        }
    }

    /// The mapping with what a record needs: its path is smoothed, and its attitude is that of a coordinated flight unless the record or
    /// the mapping has another. A fault names what only a table has.
    pub fn complete(&self, mapping: &LogMapping) -> Result<LogMapping, LogError> {
        let LogMapping { columns, is_track_magnetic, missing, .. } = mapping;
        let kept = LogMapping {
            columns: columns.clone(),
            is_track_magnetic: *is_track_magnetic,
            missing: *missing,
            ..mapping.of_own_columns()
        };
        if kept != *mapping || columns.iter().any(LogColumn::is_of_cells) {
            let what = "log: a flight record is no table: it has no lines, separators, comments, formats of times, parts, minutes and hemispheres";
            return Err(fault(0, 1, what.to_owned()));
        }
        let has_attitude = self.names.iter().any(|name| name.starts_with("roll"));
        Ok(LogMapping {
            smooth: true,
            is_coordinated: mapping.is_coordinated || !has_attitude && !mapping.names_attitude(),
            ..kept
        })
    }
}

/// What is left out, as the end of a sentence; nothing if all counts are 0.
pub fn left_out(counts: &[(u64, &str)]) -> String {
    let of = |(count, what): &(u64, &str)| (*count > 0).then(|| format!("{count} {what}"));
    let parts: Vec<String> = counts.iter().filter_map(of).collect();
    if parts.is_empty() { String::new() } else { format!("; left out: {}", parts.join(", ")) }
}
