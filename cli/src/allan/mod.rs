//! The Allan deviation of an IMU log, and the noises that explain it.
//!
//! The data flow is `command` → `quantity`, `log` → `analysis` → `diagram`, `document`, `table`, `records`. `sheet` has the units
//! of data sheets. The library has the estimator, [`sins::allan`].

mod analysis;
mod command;
mod diagram;
mod document;
mod log;
mod quantity;
mod records;
mod sheet;
mod table;

pub use command::Order;

use crate::drawing::document::PAGE_MARK;
use crate::drawing::file::PICTURE_MARK;
use crate::failure::Failure;
use crate::output::Outputs;
use crate::terminal::print;
use analysis::Analysis;
use log::Log;

/// Analyses the log of `order`, writes the files and prints the table.
pub fn run(order: &Order) -> Result<(), Failure> {
    let is_page = order.is_page()?;
    let mut outputs = Outputs::new(std::slice::from_ref(&order.log), order.force);
    let drawn_file = outputs.file(&order.output(), if is_page { PAGE_MARK } else { PICTURE_MARK })?;
    let points =
        order.points.as_ref().map(|path| outputs.file(path, &records::POINTS.join(","))).transpose()?;
    let fit = order.fit().map(|path| outputs.file(&path, &records::COEFFICIENTS.join(","))).transpose()?;
    let log = Log::read(order)?;
    let analyses = Analysis::of_log(&log)?;
    drawn_file.finish(if is_page {
        document::page(&log, &analyses)?
    } else {
        document::picture(&log, &analyses)?
    })?;
    if let Some(file) = points {
        file.finish(records::points(&analyses)?)?;
    }
    if let Some(file) = fit {
        file.finish(records::coefficients(&analyses)?)?;
    }
    print(&table::table(&log, &analyses))
}
