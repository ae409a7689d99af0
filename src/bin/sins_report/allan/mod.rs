//! The Allan deviation of an IMU log, and the noises that explain it.
//!
//! The data flow is `command` → `quantity`, `log` → `estimate`, `analysis` → `diagram`, `document`, `table`, `records`;
//! `sheet` has the units of data sheets.

mod analysis;
mod command;
mod diagram;
mod document;
mod estimate;
mod log;
mod quantity;
mod records;
mod sheet;
mod table;

pub use command::{Order, USAGE, order};

use crate::failure::Failure;
use crate::write;
use analysis::Analysis;
use log::Log;

/// Analyses the log of `order`, writes the files and prints the table.
pub fn run(order: &Order) -> Result<(), Failure> {
    let log = Log::read(order)?;
    let analyses = Analysis::of_log(&log)?;
    let is_page = order.output.extension().is_some_and(|ending| ending == "html");
    let drawn = if is_page { document::page(&log, &analyses)? } else { document::picture(&log, &analyses)? };
    write(&order.output, &drawn)?;
    if let Some(path) = &order.points {
        write(path, &records::points(&analyses)?)?;
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        write(&path.with_file_name(format!("{stem}_fit.csv")), &records::coefficients(&analyses)?)?;
    }
    print!("{}", table::table(&log, &analyses));
    Ok(())
}
