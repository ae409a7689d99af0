//! Flight logs from files, pipes and standard input.

use std::io::Read;
use std::path::Path;

use sins::log::{FlightLog, LogError, LogMapping, survey};
use sins::scene::Scene;

use super::file::reject_device;
use super::record::Table;
use crate::failure::Failure;
use crate::terminal::quoted;

/// The log at `path`, read and repaired as `scene` says, and the table that it was read from; "-" means standard input. The `[log]` of
/// the scene is completed for a flight record, and becomes that of the one table of several files.
pub fn read_log(path: &Path, scene: &mut Scene) -> Result<(FlightLog, Table), Failure> {
    let mut table = read_table(path)?;
    table.complete(&mut scene.log);
    table.join(path, &mut scene.log)?;
    let log = scene.read_log(&table.text).map_err(|error| unread(path, &table, &scene.log, error))?;
    Ok((log, table))
}

/// The failure about a table at `path` that is not read. If nothing names its columns and they can be found, it says how.
pub fn unread(path: &Path, table: &Table, mapping: &LogMapping, error: LogError) -> Failure {
    let is_about_columns = error.is_about_columns() && mapping.columns == LogMapping::default().columns;
    let failure = of_log(path, error);
    if !is_about_columns || table.note.is_some() || path == Path::new("-") || survey(&table.text).is_none() {
        return failure;
    }
    let file = quoted(path);
    Failure::new(format!("{failure}\n`sins log {file} --map columns.toml` looks for the columns"))
}

/// The failure about a log at `path`.
pub fn of_log(path: &Path, error: LogError) -> Failure {
    match error {
        LogError::Fault(fault) if fault.line == 0 => Failure::of_file(path, &fault.sentence),
        LogError::Fault(fault) => Failure::of_line(path, fault.line as u64, &fault.sentence),
        LogError::Memory(error) => Failure::of_file(path, &error),
    }
}

/// The table of the log at `path`; "-" means standard input.
pub fn read_table(path: &Path) -> Result<Table, Failure> {
    reject_device(path)?;
    let read = if path == Path::new("-") {
        let mut bytes = Vec::new();
        std::io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes)
    } else {
        std::fs::read(path)
    };
    Table::of_file(path, read.map_err(|error| Failure::of_input(path, &error))?)
}
