//! A flight log of the user.

use std::fs;
use std::path::Path;

use sins::log::{FlightLog, LogError};
use sins::truth::FlightSample;

use crate::failure::Failure;

/// The samples of the log at `path`.
pub fn read(path: &Path) -> Result<Vec<FlightSample>, Failure> {
    let text = fs::read(path).map_err(|error| Failure::of_file(path, &format!("cannot be read: {error}")))?;
    match FlightLog::parse(&text) {
        Ok(log) => Ok(log.samples().to_vec()),
        Err(LogError::Fault(fault)) => Err(Failure::of_line(path, fault.line as u64, &fault.sentence)),
        Err(LogError::Memory(error)) => Err(Failure::of_file(path, &error)),
    }
}

/// What the log at `path` is called: the file without its ending.
pub fn name(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}
