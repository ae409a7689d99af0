//! Flight logs from files, pipes and standard input.

use std::fs::File;
use std::io::Read;
use std::path::Path;

pub use sins::log::Reading;
use sins::log::{FlightLog, LogError};

use crate::failure::Failure;

/// Opens an input; a device is rejected.
pub fn open(path: &Path) -> Result<File, Failure> {
    reject_device(path)?;
    File::open(path).map_err(|error| Failure::of_input(path, &error))
}

/// Rejects a device: it has no end, or waits for a keyboard.
fn reject_device(path: &Path) -> Result<(), Failure> {
    if is_device(path) {
        return Err(Failure::of_file(path, &"is a device: expected a file or a pipe"));
    }
    Ok(())
}

fn is_device(path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        let is_one = |metadata: std::fs::Metadata| {
            metadata.file_type().is_char_device() || metadata.file_type().is_block_device()
        };
        std::fs::metadata(path).is_ok_and(is_one)
    }
    #[cfg(windows)]
    {
        path.file_name().is_some_and(|name| crate::output::is_device_of_windows(&name.to_string_lossy()))
    }
}

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
