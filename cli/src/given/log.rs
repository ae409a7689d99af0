//! Flight logs from files, pipes and standard input.

use std::io::Read;
use std::path::Path;

pub use sins::scene::log::Reading;
use sins::scene::log::{FlightLog, LogError};

use super::file::reject_device;
use crate::failure::Failure;

/// The log at `path`; "-" means standard input.
pub fn read_log(path: &Path) -> Result<FlightLog, Failure> {
    read_log_as(path, Reading::Whole)
}

/// The same, with what the log needs.
pub fn read_log_as(path: &Path, reading: Reading) -> Result<FlightLog, Failure> {
    reject_device(path)?;
    let read = if path == Path::new("-") {
        let mut bytes = Vec::new();
        std::io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes)
    } else {
        std::fs::read(path)
    };
    let text = read.map_err(|error| Failure::of_input(path, &error))?;
    match FlightLog::parse_as(&text, reading) {
        Ok(log) => Ok(log),
        Err(LogError::Fault(fault)) => Err(Failure::of_line(path, fault.line as u64, &fault.sentence)),
        Err(LogError::Memory(error)) => Err(Failure::of_file(path, &error)),
    }
}
