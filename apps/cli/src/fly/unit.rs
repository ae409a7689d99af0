//! The files of a unit in flight: its own has a row at each record and at each change of its state.

use std::io::Write;

use sins::records;
use sins::unit::bus::Word;
use sins::unit::{State, Unit};
use sins::{Error, ImuInterval, Simulator};

use super::bus::Bus;
use crate::failure::Failure;
use crate::output::OutputFile;

/// Columns of the file.
pub const COLUMNS: [&str; 5] = ["time_s", "state", "to_go_s", "valid", "reasons"];

/// The file of a unit, if it is the scene's, and its bus.
pub struct UnitFiles {
    file: Option<OutputFile>,
    bus: Option<Bus>,
    written: Option<State>,
}

impl UnitFiles {
    pub fn new(mut file: Option<OutputFile>, bus: Option<Bus>) -> Result<Self, Failure> {
        if let Some(file) = &mut file {
            write_line(file, &COLUMNS.join(","))?;
        }
        Ok(Self { file, bus, written: None })
    }

    /// Sends the words that are due in the last interval.
    pub fn send(
        &mut self,
        unit: &Unit,
        simulator: &Simulator,
        interval: &ImuInterval,
    ) -> Result<Vec<Word>, Error> {
        let from_s = interval.time_s - interval.interval_s;
        match &mut self.bus {
            Some(bus) => bus.due(unit, simulator, from_s, interval.time_s),
            None => Ok(Vec::new()),
        }
    }

    /// Writes words.
    pub fn write(&mut self, words: &[Word]) -> Result<(), Failure> {
        self.bus.as_mut().map_or(Ok(()), |bus| bus.write(words))
    }

    /// Writes a row if the state has changed, or if it `is_due`. Returns a state that is new.
    pub fn record(&mut self, unit: &Unit, time_s: f64, is_due: bool) -> Result<Option<State>, Failure> {
        let Some(file) = &mut self.file else { return Ok(None) };
        let status = unit.status();
        let new = (self.written != Some(status.state)).then_some(status.state);
        if !is_due && new.is_none() {
            return Ok(None);
        }
        self.written = Some(status.state);
        let (valid, reasons) = (status.validity.words(), status.reasons.words());
        let state = status.state.word();
        let time = records::line([time_s]);
        write_line(file, &format!("{time},{state},{:.1},{valid},{reasons}", status.to_go_s))?;
        Ok(new)
    }

    /// The files.
    pub fn files(&self) -> impl Iterator<Item = &OutputFile> {
        self.file.iter().chain(self.bus.as_ref().map(Bus::file))
    }

    /// Reports an error of the disk.
    pub fn check(&mut self) -> Result<(), Failure> {
        self.file.as_mut().map_or(Ok(()), OutputFile::check)?;
        self.bus.as_mut().map_or(Ok(()), Bus::check)
    }

    /// Puts its files in place, as far as the disk has taken them.
    pub fn commit(self) -> Result<(), Failure> {
        Failure::each([
            self.file.map_or(Ok(()), OutputFile::commit_lines),
            self.bus.map_or(Ok(()), Bus::commit),
        ])
    }
}

fn write_line(file: &mut OutputFile, line: &str) -> Result<(), Failure> {
    writeln!(file, "{line}").map_err(|error| Failure::of_output(file.path(), &error))
}
