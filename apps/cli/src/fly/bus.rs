//! The words of ARINC 429 of a flight, as a file.

use std::collections::VecDeque;
use std::io::Write;

use sins::unit::bus::{Inputs, Word, decode, words};
use sins::unit::{Status, Unit, UnitNavigation};
use sins::{Error, Simulator, records};

use crate::bus;
use crate::failure::Failure;
use crate::output::OutputFile;

/// Columns of the file.
pub const COLUMNS: [&str; 6] = ["time_s", "label", "word", "value", "unit", "status"];

/// The bus of a flight.
pub struct Bus {
    file: OutputFile,
    /// How late the words are [s].
    delay_s: f64,
    /// What the unit showed, and when; the first one is the newest that is old enough.
    past: VecDeque<(f64, Status, UnitNavigation)>,
    inputs: Inputs,
}

impl Bus {
    pub fn new(mut file: OutputFile, delay_s: f64, inputs: Inputs) -> Result<Self, Failure> {
        write_line(&mut file, &COLUMNS.join(","))?;
        Ok(Self { file, delay_s, past: VecDeque::new(), inputs })
    }

    /// Takes what `unit` shows after the interval that ends at `time_s`, and gives the words that are due in it.
    pub fn due(
        &mut self,
        unit: &Unit,
        simulator: &Simulator,
        from_s: f64,
        time_s: f64,
    ) -> Result<Vec<Word>, Error> {
        self.past.push_back((time_s, unit.status(), unit.navigation(simulator)?));
        let old_enough = time_s - self.delay_s + 1e-9;
        while self.past.get(1).is_some_and(|(at_s, ..)| *at_s <= old_enough) {
            self.past.pop_front();
        }
        let mut due = Vec::new();
        if let Some((at_s, status, shown)) = self.past.front()
            && *at_s <= old_enough
        {
            words(status, shown, &self.inputs, (from_s, time_s), |word| due.push(word))?;
        }
        Ok(due)
    }

    pub fn write(&mut self, due: &[Word]) -> Result<(), Failure> {
        due.iter().filter_map(line).try_for_each(|line| write_line(&mut self.file, &line))
    }

    /// Its file.
    pub fn file(&self) -> &OutputFile {
        &self.file
    }

    /// Reports an error of the disk.
    pub fn check(&mut self) -> Result<(), Failure> {
        self.file.check()
    }

    pub fn commit(self) -> Result<(), Failure> {
        self.file.commit_lines()
    }
}

/// The line of a word.
pub fn line(word: &Word) -> Option<String> {
    let found = decode(word.word).ok()?;
    let (time, label) = (records::line([word.time_s]), found.label);
    let value = bus::value(label, found.value);
    let status = bus::status(found.status);
    Some(format!("{time},{:03o},{:08x},{value},{},{status}", word.label, word.word, label.unit))
}

fn write_line(file: &mut OutputFile, line: &str) -> Result<(), Failure> {
    writeln!(file, "{line}").map_err(|error| Failure::of_output(file.path(), &error))
}
