//! A log while its rows are read.

use csv::StringRecord;

use super::columns::Columns;
use super::marks::DecimalMarks;
use super::parse::Take;
use super::rows::{Cells, Table};
use super::unread::Evidence;
use super::{Clock, FlightLog, LogError, LogMapping, fault};
use crate::base::memory::room_for_one_more;
use crate::base::text::{Fault, excerpt};
use crate::judge::{At, Finding};
use crate::truth::FlightSample;

/// A log, and which rows were left out.
pub struct Reading<'m> {
    table: Table<'m>,
    log: FlightLog,
    /// The columns that are not read.
    evidence: Evidence,
    /// Rows without a value: how many, and the line of the first.
    left_out: Option<(u64, u64)>,
    /// Rows of other vehicles.
    others: u64,
    /// Rows at the time and the place of the row before.
    repeats: u64,
    /// Rows before the time of the row before: how many, line and time of the first [s].
    late: Option<(u64, u64, f64)>,
}

impl<'m> Reading<'m> {
    pub fn new(
        title: String,
        columns: Columns,
        notes: Vec<Fault>,
        mapping: &'m LogMapping,
        evidence: Evidence,
    ) -> Self {
        let log = FlightLog {
            title,
            samples: Vec::new(),
            lines: Vec::new(),
            notes,
            of_rows: Vec::new(),
            rows: Vec::new(),
            has_attitude: !mapping.is_coordinated,
            mapping: None,
            smoothing: mapping.smoothing(),
            unread: (Vec::new(), 0),
        };
        let is_mapped = mapping.is_foreign();
        let (clock, marks) = (Clock::new(mapping), DecimalMarks::new());
        let table = Table { columns, mapping, is_mapped, clock, marks };
        Self { table, log, evidence, left_out: None, others: 0, repeats: 0, late: None }
    }

    /// Adds a note about the whole log.
    fn note(&mut self, sentence: String) {
        self.log.notes.push(Fault { sentence, ..Fault::default() });
    }

    /// Leaves the row on `line` out.
    fn leave_out(&mut self, line: u64) {
        self.left_out.get_or_insert((0, line)).0 += 1;
    }

    /// Takes the row on `line`.
    pub fn row(&mut self, cells: Cells<'_>, line: u64) -> Result<(), LogError> {
        let Some(sample) = self.table.sample(&cells, line, self.log.samples.last())? else {
            self.leave_out(line);
            return Ok(());
        };
        if let Some((last, what)) =
            self.log.samples.last().and_then(|last| Some((last, begins_anew(last, &sample)?)))
        {
            let sentence = format!(
                "time_s = {}: follows {}: is it {what}? Add its seconds to the times from here on",
                sample.time_s, last.time_s
            );
            return Err(fault(line, 1, sentence));
        }
        match self.log.samples.last() {
            Some(last) if self.log.smoothing.is_some() && sample.time_s <= last.time_s => {
                match sample.time_s == last.time_s && sample.place == last.place {
                    true => self.repeats += 1,
                    false => self.late.get_or_insert((0, line, sample.time_s)).0 += 1,
                }
                Ok(())
            }
            _ => {
                self.push(sample, line)?;
                let taken = match cells {
                    Cells::Texts(row) => self.evidence.take(row, sample.time_s),
                    Cells::Numbers(row) => self.evidence.take_numbers(row, sample.time_s),
                };
                taken.map_err(LogError::Memory)
            }
        }
    }

    /// Adds the sample of a line, which is later than the one before.
    fn push(&mut self, sample: FlightSample, line: u64) -> Result<(), LogError> {
        let FlightLog { samples, lines, .. } = &mut self.log;
        if let Some(last) = samples.last()
            && sample.time_s <= last.time_s
        {
            let sentence =
                format!("time_s = {}: not later than the sample before, {}", sample.time_s, last.time_s);
            return Err(fault(line, 1, sentence));
        }
        let first_s = samples.first().map_or(sample.time_s, |first| first.time_s);
        let latest_s = FlightSample::LATEST_S;
        if sample.time_s - first_s > latest_s {
            let sentence = format!(
                "time_s = {:e}: must be at most {latest_s:e} s after the first sample, {first_s:e}",
                sample.time_s
            );
            return Err(fault(line, 1, sentence));
        }
        room_for_one_more(samples).map_err(LogError::Memory)?;
        room_for_one_more(lines).map_err(LogError::Memory)?;
        samples.push(sample);
        lines.push(line);
        Ok(())
    }

    /// The log, whose last line is `last`.
    pub fn finish(mut self, last: u64) -> Result<FlightLog, LogError> {
        self.table.marks.check(&self.table.columns)?;
        if let Some((count, line)) = self.left_out {
            let rows = if count == 1 { "row is" } else { "rows are" };
            let sentence = format!("{count} {rows} left out, the first here: a value is missing");
            self.log.notes.push(Fault { line: line as usize, column: 1, sentence, ..Fault::default() });
        }
        if self.others > 0 {
            let LogMapping { only_column, only, .. } = self.table.mapping;
            let (column, only) = (excerpt(only_column), excerpt(only));
            self.note(format!("{} rows of others are left out: {column} is not {only}", self.others));
        }
        if self.repeats > 0 {
            let rows = if self.repeats == 1 { "row is" } else { "rows are" };
            self.note(format!("{} {rows} left out: at the time of the row before", self.repeats));
        }
        let mut log = self.log;
        log.unread = self.evidence.finish();
        if let Some((count, line, time_s)) = self.late {
            let at = At { row: log.samples.partition_point(|sample| sample.time_s < time_s) as u64, time_s };
            let rows = count + log.samples.len() as u64;
            log.of_rows.push((Finding::of_late_rows(count, rows, at), line));
        }
        if log.samples.len() < 2 {
            let sentence = format!("{} samples: a flight has at least two", log.samples.len());
            return Err(fault(last + 1, 1, sentence));
        }
        Ok(log)
    }
}

impl Take for Reading<'_> {
    fn row(&mut self, row: &StringRecord, line: u64) -> Result<(), LogError> {
        Reading::row(self, Cells::Texts(row), line)
    }

    fn leave_out(&mut self, line: u64) {
        Reading::leave_out(self, line);
    }

    fn cut_off(&mut self, line: u64) {
        let sentence = "the last line is cut off, and left out".to_owned();
        self.log.notes.push(Fault { line: line as usize, column: 1, sentence, ..Fault::default() });
    }

    fn other(&mut self) {
        self.others += 1;
    }

    fn is_empty(&self) -> bool {
        self.log.samples.is_empty()
    }
}

/// What begins anew in a row whose time is less by a day or a week: these rows are no others of an earlier time.
fn begins_anew(last: &FlightSample, next: &FlightSample) -> Option<&'static str> {
    const ENDS: [(f64, &str); 2] = [(86400.0, "midnight"), (604_800.0, "the end of a GPS week")];
    const NEAR_S: f64 = 60.0;
    let is_end = |(end_s, _): &(f64, &str)| {
        last.time_s <= *end_s && last.time_s > end_s - NEAR_S && (0.0..NEAR_S).contains(&next.time_s)
    };
    ENDS.into_iter().find(is_end).map(|(_, what)| what)
}
