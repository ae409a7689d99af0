//! Flight logs from files, pipes and standard input.

use std::path::{Path, PathBuf};

use sins::log::{FilesError, FlightLog, LogError, LogMapping, foreign, survey};
use sins::scene::Scene;

use super::beside::beside;
use super::file::{open, read_whole};
use super::kind::{FileKind, is_record};
use crate::failure::Failure;
use crate::terminal::quoted;

/// A log, and the files beside it that were joined with it.
pub struct ReadLog {
    pub log: FlightLog,
    pub others: Vec<PathBuf>,
}

/// The log at `path`, read and repaired as `scene` says; "-" means standard input.
pub fn read_log(path: &Path, scene: &Scene) -> Result<ReadLog, Failure> {
    let bytes = read_bytes(path)?;
    let ReadLog { log, others } = parse_log(path, &bytes, &scene.log)?;
    let log = log.smoothed(&scene.options.earth()).map_err(|error| of_log(path, error))?;
    Ok(ReadLog { log, others })
}

/// The rows of the log at `path`, whose bytes these are, with those of the files beside it that `mapping` names.
pub fn parse_log(path: &Path, bytes: &[u8], mapping: &LogMapping) -> Result<ReadLog, Failure> {
    let mut others = Vec::new();
    let read = |name: &str| {
        let other = beside(path, name)?;
        let bytes = read_bytes(&other)?;
        others.push(other);
        Ok::<_, Failure>(bytes)
    };
    match FlightLog::parse_files(bytes, mapping, read) {
        Ok(log) => Ok(ReadLog { log, others }),
        Err(FilesError::Unread(failure)) => Err(failure),
        Err(FilesError::Of(name, error)) if name.is_empty() => Err(unread(path, bytes, mapping, *error)),
        Err(FilesError::Of(name, error)) => Err(of_log(&path.with_file_name(name), *error)),
    }
}

/// The failure about a log at `path` that is not read: what it is instead, or, if nothing names its columns and they can be found, how.
fn unread(path: &Path, bytes: &[u8], mapping: &LogMapping, error: LogError) -> Failure {
    let is_plain = *mapping == mapping.of_own_columns();
    if let (LogError::Fault(_), Some(kind @ (FileKind::Own(_) | FileKind::Records))) =
        (&error, FileKind::of(bytes).filter(|_| is_plain))
    {
        let what = format!("is {kind}: expected a flight log, a table of comma-separated values");
        return Failure::of_line(path, 1, &what);
    }
    // Tables of other programs begin with lines of their own.
    let is_of_columns = error.is_about_columns() || is_plain && foreign(bytes).is_some();
    let may_help = is_of_columns && mapping.columns == LogMapping::default().columns;
    let failure = of_log(path, error);
    if !may_help || is_record(bytes) || path == Path::new("-") || survey(bytes).is_none() {
        return failure;
    }
    let file = quoted(path);
    Failure::new(format!(
        "{failure}\n`sins log {file} --map columns.toml` finds its columns, and `sins fly {file} --columns columns.toml` flies it"
    ))
}

/// The failure about a log at `path`.
pub fn of_log(path: &Path, error: LogError) -> Failure {
    match error {
        LogError::Fault(fault) if fault.line == 0 => Failure::of_file(path, &fault.sentence),
        LogError::Fault(fault) => Failure::of_line(path, fault.line as u64, &fault.sentence),
        LogError::Memory(error) => Failure::of_file(path, &error),
    }
}

/// The bytes of the log at `path`; "-" means standard input.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    if path == Path::new("-") {
        read_whole(path, std::io::stdin().lock())
    } else {
        read_whole(path, open(path)?)
    }
}
