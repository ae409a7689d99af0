//! The Allan deviation of an IMU log, and the noises that explain it.
//!
//! The data flow is `command` → `crate::imu` → `values`, `analysis` → `diagram`, `document`, `table`, `records`, `scene`.
//! `sheet` has the units of data sheets. The estimator is a package of its own, [`sins_allan`].

mod analysis;
mod command;
mod diagram;
mod document;
mod records;
mod scene;
mod sheet;
mod table;
mod values;

pub use command::Order;
pub use document::deviations;

use std::path::PathBuf;

use sins_allan::FEWEST_SAMPLES;

use crate::drawing::document::PAGE_MARK;
use crate::drawing::file::PICTURE_MARK;
use crate::failure::Failure;
use crate::imu::{Log, Source, imu_of_file};
use crate::output::{NO_MARK, Outputs};
use crate::terminal::{print, quoted};
use crate::written;
use analysis::Analysis;

/// Most pieces between gaps that are read: of each, an averaging time has the differences.
const MOST_PIECES: usize = 100;

/// Analyses the log of `order`, writes the files and prints the table.
pub fn run(order: &Order) -> Result<(), Failure> {
    let is_page = order.is_page()?;
    let inputs: Vec<PathBuf> =
        [Some(order.log.clone()), order.imu_map.clone()].into_iter().flatten().collect();
    let mut outputs = Outputs::new(&inputs, order.force);
    let drawn_file = outputs.file(&order.output(), if is_page { PAGE_MARK } else { PICTURE_MARK })?;
    let points =
        order.points.as_ref().map(|path| outputs.file(path, &records::POINTS.join(","))).transpose()?;
    let fit = order.fit().map(|path| outputs.file(&path, &records::COEFFICIENTS.join(","))).transpose()?;
    let scene = order.scene.as_ref().map(|path| outputs.file(path, NO_MARK)).transpose()?;
    let mapping = order.imu_map.as_deref().map(|path| imu_of_file(path, &[])).transpose()?;
    let source = Source {
        path: &order.log,
        columns: &order.columns,
        flag: "--columns",
        rate_hz: order.rate_hz,
        mapping: mapping.as_ref(),
        hint: "",
        most_pieces: MOST_PIECES,
        fewest_rows: FEWEST_SAMPLES,
    };
    let log = Log { is_still: order.still, ..Log::read(&source)? };
    let analyses = Analysis::of_log(&log)?;
    let drawn = match is_page {
        true => document::page(&log, &analyses)?,
        false => document::picture(&log, &analyses)?,
    };
    // The figures are told also if no scene can be made of them.
    let scene_written = scene.map(|file| file.finish(scene::text(&log, &analyses)?));
    let tables = [(points, records::points(&analyses)?), (fit, records::coefficients(&analyses)?)];
    let tables = tables.map(|(file, text)| file.map_or(Ok(()), |file| file.finish(text)));
    let paths = [Some(order.output()), order.points.clone(), order.fit(), order.scene.clone()];
    let paths: Vec<PathBuf> = paths.into_iter().flatten().collect();
    Failure::each(
        [drawn_file.finish(drawn)]
            .into_iter()
            .chain(tables)
            .chain([print(&table::table(&log, &analyses))])
            .chain(scene_written),
    )?;
    let next = match &order.scene {
        Some(scene) => {
            format!("`sins fly {} --imu IMU.csv` makes a record that can be compared", quoted(scene))
        }
        None => written::open(&order.output()),
    };
    print(&written::text(&paths, Some(&next)))
}
