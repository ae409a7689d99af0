//! `sins fly`: flies a scene, writes its records and figures, and prints a summary.
//!
//! The data flow is `crate::given` → `flight` → `crate::record`, `imu` → `figures` → `summary` (file), `print` (terminal).

mod figures;
mod flight;
mod imu;
mod print;
mod spacing;
mod summary;
mod unit;

use crate::failure::{Failure, Kind};
use crate::given::SceneArguments;
use crate::interrupt;
use crate::output::{OutputFile, Outputs};
use crate::places::{OutputArguments, below};
use crate::record::COLUMNS;
use crate::terminal::print;
use figures::Figures;
use flight::{Files, Flown};
use unit::UnitInFlight;

/// Scene of a log that has no scene: the recommended simulator with ideal sensors.
pub const FOR_LOGS: &str = "[flight]\nfile = \"log\"\n";

/// Flies a scene, writes its records (DIR/NAME.csv) and figures (DIR/NAME_summary.csv), and prints a summary
///
/// The states of a unit ([unit] in the scene) are written into DIR/NAME_unit.csv.
///
/// A log without a scene is flown with ideal sensors.
#[derive(Debug, clap::Args)]
pub struct Order {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    output: OutputArguments,
    /// Also writes the measured increments on which the INS navigates into this file in DIR, a row for each part of an update
    #[arg(long, value_name = "FILE.csv")]
    imu: Option<String>,
}

pub fn run(order: &Order) -> Result<(), Failure> {
    let given = order.scene.load(FOR_LOGS)?;
    let (folder, name) = order.output.places(&given)?;
    let imu = order.imu.as_ref().or(Some(&given.scene.output.imu).filter(|imu| !imu.is_empty()));
    let imu = imu.map(|file| below(&folder, file, "output.imu", "--imu")).transpose()?;
    let every = spacing::intervals(&given)?;
    let mut outputs = Outputs::new(&given.inputs, order.output.force);
    // The outputs are opened before the flight, so that one that cannot be written is reported at once.
    outputs.folder(&folder)?;
    let file = |ending: &str| folder.join(format!("{name}{ending}"));
    let summary_file = outputs.file(&file("_summary.csv"), summary::MARK)?;
    let mut files = Files {
        records: outputs.file(&file(".csv"), &COLUMNS.join(","))?,
        imu: match &imu {
            Some(path) => {
                if let Some(folder) = path.parent() {
                    outputs.folder(folder)?;
                }
                Some(outputs.file(path, &imu::COLUMNS.join(","))?)
            }
            None => None,
        },
        unit: match given.scene.unit().map_err(|error| Failure::new(error.to_string()))? {
            Some(unit) => {
                Some(UnitInFlight::new(unit, outputs.file(&file("_unit.csv"), &unit::COLUMNS.join(","))?)?)
            }
            None => None,
        },
    };
    let quiet = order.output.is_quiet(&given);
    let mut flown = Flown::default();
    interrupt::graceful(true);
    let ended = flight::fly(&given, every, &mut files, &mut flown, quiet);
    if let Err(failure) = &ended
        && (failure.kind() == Kind::Input || flown.records == 0)
    {
        return ended.map(|_| ());
    }
    let figures = Figures::gather(&given, &name, every, &flown, ended.is_err());
    let finished = figures.and_then(|figures| {
        finish(&figures, files, summary_file)?;
        if quiet { Ok(()) } else { print(&print::text(&figures, &file(".csv"))) }
    });
    // A failure of the flight has priority.
    ended.and(finished)
}

/// Puts all files in place. The records are last, because the report looks for the summary beside the records.
fn finish(figures: &Figures, files: Files, summary_file: OutputFile) -> Result<(), Failure> {
    let Files { records, imu, unit } = files;
    let text = summary::text(figures)?;
    if let Some(imu) = imu {
        imu.commit()?;
    }
    if let Some(unit) = unit {
        unit.commit()?;
    }
    summary_file.finish(text)?;
    records.commit()
}
