//! Flight records that are no tables, and logs of several files: they become tables of the library's own columns.

mod fdr;
mod gpx;
mod igc;
mod joined;

use std::io::Read;
use std::path::{Path, PathBuf};

use sins::log::{FDR, GPX, IGC, foreign};
use sins::log::{LogMapping, decoded};

use super::file::{BEGIN, open};
use crate::failure::Failure;
use crate::units::six_digits;

/// A log as a table.
pub struct Table {
    /// Comma-separated values.
    pub text: Vec<u8>,
    /// What was assumed of a flight record, or how files were joined, in a sentence; `None`: the file is a table itself.
    pub note: Option<String>,
    /// Files that were joined with it.
    pub others: Vec<PathBuf>,
    /// Whether it was a flight record, and if so, whether it has columns of the attitude.
    is_record: bool,
    has_attitude: bool,
}

/// Line of a fault, from 1, or 0 for the whole file; and what is wrong there.
type Fault = (u64, String);

impl Table {
    /// The table of a file: the file itself, or what a flight record holds.
    pub fn of_file(path: &Path, file: Vec<u8>) -> Result<Self, Failure> {
        let text = decoded(&file).map_err(|error| Failure::of_file(path, &error))?;
        let read = match foreign(text.as_bytes()) {
            Some(IGC) => igc::table,
            Some(GPX) => gpx::table,
            Some(FDR) => fdr::table,
            _ => {
                let others = Vec::new();
                return Ok(Self { text: file, note: None, others, is_record: false, has_attitude: false });
            }
        };
        let has_attitude = foreign(text.as_bytes()) == Some(FDR);
        let (rows, note) = read(text.as_bytes()).map_err(|(line, sentence)| match line {
            0 => Failure::of_file(path, &sentence),
            line => Failure::of_line(path, line, &sentence),
        })?;
        let text = rows.text.into_bytes();
        Ok(Self { text, note: Some(note), others: Vec::new(), is_record: true, has_attitude })
    }

    /// Adds what a flight record needs to `mapping`: its path is smoothed, and its attitude is that of a coordinated flight unless
    /// the record or the mapping has another.
    pub fn complete(&self, mapping: &mut LogMapping) {
        if self.is_record {
            mapping.smooth = true;
            mapping.is_coordinated |= !self.has_attitude && !mapping.names_attitude();
        }
    }
}

/// Whether the file at `path` is a flight record, by its beginning.
pub fn is_record(path: &Path) -> bool {
    let mut begin = Vec::new();
    let is_read =
        path.is_file() && open(path).is_ok_and(|file| file.take(BEGIN).read_to_end(&mut begin).is_ok());
    is_read && decoded(&begin).is_ok_and(|text| matches!(foreign(text.as_bytes()), Some(IGC | GPX | FDR)))
}

/// The rows of a table. Each stands on the line of its fix in the file, so that messages about a row have the line of the file; where
/// a file has several fixes on a line, the rows behind them stand lower.
struct Rows {
    text: String,
    /// The line that the next row would stand on.
    line: u64,
    /// Number of rows.
    count: u64,
    /// Time of the last row [s].
    last_s: Option<f64>,
    /// The shortest and the longest interval between two rows [s].
    intervals_s: [f64; 2],
}

impl Rows {
    /// No rows below the names of columns, on the first line.
    fn new(names: &str) -> Self {
        let intervals_s = [f64::INFINITY, 0.0];
        Self { text: format!("{names}\n"), line: 2, count: 0, last_s: None, intervals_s }
    }

    /// Adds the row of a fix that stands on `line`: its time, and the other columns.
    fn push(&mut self, line: u64, time_s: f64, others: &[f64]) {
        let empty = line.saturating_sub(self.line);
        self.text.extend(std::iter::repeat_n('\n', empty as usize));
        self.text += &time_s.to_string();
        others.iter().for_each(|value| self.text += &format!(",{value}"));
        self.text.push('\n');
        self.line += empty + 1;
        self.count += 1;
        let interval_s = self.last_s.map_or(0.0, |last_s| time_s - last_s);
        // A repeated stamp has no interval: the library leaves its row out.
        if interval_s > 0.0 {
            let [shortest_s, longest_s] = self.intervals_s;
            self.intervals_s = [shortest_s.min(interval_s), longest_s.max(interval_s)];
        }
        self.last_s = Some(time_s);
    }

    /// The intervals in words.
    fn spacing(&self) -> String {
        let [shortest, longest] = self.intervals_s.map(six_digits);
        if shortest == longest {
            format!("{longest} s apart")
        } else {
            format!("{shortest} to {longest} s apart")
        }
    }
}

/// What is left out of a record, as the end of a sentence; nothing if all counts are 0.
fn left_out(counts: &[(u64, &str)]) -> String {
    let of = |(count, what): &(u64, &str)| (*count > 0).then(|| format!("{count} {what}"));
    let parts: Vec<String> = counts.iter().filter_map(of).collect();
    if parts.is_empty() { String::new() } else { format!("; left out: {}", parts.join(", ")) }
}
