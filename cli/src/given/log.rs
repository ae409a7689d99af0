//! Flight logs from files, pipes and standard input.

use std::io::Read;
use std::path::Path;

use sins::scene::Scene;
use sins::scene::log::{FlightLog, LogError};

use super::file::reject_device;
use crate::failure::Failure;

/// The log at `path`, read and repaired as `scene` says; "-" means standard input.
pub fn read_log(path: &Path, scene: &Scene) -> Result<FlightLog, Failure> {
    scene.read_log(&read_table(path)?).map_err(|error| of_log(path, error))
}

/// The failure about a log at `path`.
pub fn of_log(path: &Path, error: LogError) -> Failure {
    match error {
        LogError::Fault(fault) if fault.line == 0 => Failure::of_file(path, &fault.sentence),
        LogError::Fault(fault) => Failure::of_line(path, fault.line as u64, &fault.sentence),
        LogError::Memory(error) => Failure::of_file(path, &error),
    }
}

/// The text of the table at `path`; "-" means standard input.
pub fn read_table(path: &Path) -> Result<Vec<u8>, Failure> {
    reject_device(path)?;
    let read = if path == Path::new("-") {
        let mut bytes = Vec::new();
        std::io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes)
    } else {
        std::fs::read(path)
    };
    read.map_err(|error| Failure::of_input(path, &error))
}
