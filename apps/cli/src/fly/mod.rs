//! `sins fly`: flies a scene, writes its records and figures, and prints a summary.
//!
//! The data flow is `crate::given` → `flight` → `sins::record`, `imu` → `figures` → `summary` (file), `print` (terminal).

mod bus;
mod figures;
mod flight;
mod imu;
mod navigation;
mod print;
mod rows;
mod shown;
mod summary;
mod unit;

use std::path::{Path, PathBuf};

use sins::Error;
use sins::scene::Play;
use sins::unit::bus::Inputs;

use crate::failure::{Failure, Kind};
use crate::given::{Given, Hours, Json, SceneArguments};
use crate::interrupt;
use crate::output::{OutputFile, Outputs};
use crate::places::{OutputArguments, below};
use crate::rows::ROW_COLUMNS;
use crate::terminal::print;
use crate::written;
use bus::Bus;
use sins::record::COLUMNS;

pub use bus::line as bus_line;
pub use figures::Figures;
pub use flight::{Files, InFlight, Stopped};
pub use print::text;
pub use shown::Shown;
pub use summary::{LONGEST, MARK};
pub use unit::{COLUMNS as UNIT_COLUMNS, UnitFiles};

/// Scene of a log that has no scene: the recommended simulator with ideal sensors.
pub const FOR_LOGS: &str = "[flight]\nfile = \"log\"\n";

/// Flies a scene, writes its records (DIR/NAME.csv) and figures (DIR/NAME_summary.csv), and prints a summary
///
/// The states of a unit ([unit] in the scene) are written into DIR/NAME_unit.csv, the rows of a log that was smoothed into
/// DIR/NAME_rows.csv.
///
/// A log without a scene is flown with ideal sensors.
#[derive(Debug, clap::Args)]
pub struct Order {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    hours: Hours,
    #[command(flatten)]
    output: OutputArguments,
    #[command(flatten)]
    json: Json,
    /// Also writes the measured increments on which the INS navigates into this file in DIR, a row for each part of an update
    #[arg(long, value_name = "FILE.csv")]
    imu: Option<String>,
    /// Also writes the ARINC 429 words of the scene's unit into this file in DIR. A scene without a unit has one that navigates
    #[arg(long, value_name = "FILE.csv")]
    bus: Option<String>,
    /// How late the words are [ms], 0 to 200
    #[arg(long, value_name = "MS", requires = "bus", default_value_t = 0.0)]
    bus_delay: f64,
}

pub fn run(order: &Order) -> Result<(), Failure> {
    let given = order.scene.load_judged(&order.hours, order.json, FOR_LOGS)?;
    let (folder, name) = order.output.places(&given)?;
    let imu = order.imu.as_ref().or(Some(&given.scene.output.imu).filter(|imu| !imu.is_empty()));
    let imu = imu.map(|file| below(&folder, file, "output.imu", "--imu")).transpose()?;
    let play = ready(&given)?;
    let every_s = play.itinerary().every_s();
    let mut outputs = Outputs::new(&given.inputs, order.output.force);
    // The outputs are opened before the flight, so that one that cannot be written is reported at once.
    outputs.folder(&folder)?;
    let file = |ending: &str| folder.join(format!("{name}{ending}"));
    let mut summary_file = outputs.file(&file("_summary.csv"), summary::MARK)?;
    summary_file.reserve(summary::LONGEST)?;
    let files = Files {
        records: outputs.file(&file(".csv"), &COLUMNS.join(","))?,
        imu: match &imu {
            Some(path) => {
                outputs.folder_of(path)?;
                Some(outputs.file(path, &imu::COLUMNS.join(","))?)
            }
            None => None,
        },
        unit: unit(order, &given, &mut outputs, &folder, &file("_unit.csv"))?,
    };
    let rows = given.rows_of_path();
    let rows_file = (!rows.is_empty()).then(|| outputs.file(&file("_rows.csv"), &ROW_COLUMNS.join(",")));
    let rows_file = rows_file.transpose()?;
    let quiet = order.json.is_wanted || order.output.is_quiet(&given);
    interrupt::graceful();
    let (files, flown, ended) = flight::fly(&given, play, files, quiet)?;
    if let Err(failure) = &ended
        && (failure.kind() == Kind::Input || flown.records == 0)
    {
        return ended.map(|_| ());
    }
    let figures = Figures::gather(&given, &name, every_s, &flown, ended.is_err());
    let finished = figures.and_then(|figures| {
        let of_rows = rows_file.as_ref().map(|file| file.path().to_owned());
        let paths = [files.paths(), vec![summary_file.path().to_owned()]].concat();
        let paths: Vec<PathBuf> = paths.into_iter().chain(of_rows).collect();
        let last = given.sample((flown.steps as usize).min(given.count - 1))?;
        // A disk that is full is told behind the figures.
        let finished = Failure::each([
            rows_file.map_or(Ok(()), |file| rows::write(file, rows, last.time_s)),
            finish(&figures, files, summary_file),
        ]);
        let next = written::report(&paths);
        let text = || text(&figures, &file(".csv")) + &written::text(&paths, next.as_deref());
        finished.and(if quiet { Ok(()) } else { print(&text()) })
    });
    match ended {
        // The files say themselves what the disk did not take.
        Err(failure) if failure.kind() == Kind::Unwritten => finished.and(Err(failure)),
        // A failure of the flight has priority.
        _ => ended.and(finished),
    }
}

/// What `sins fly` would refuse before the flight and in its first interval.
pub fn check(given: &Given) -> Result<(), Failure> {
    let output = &given.scene.output;
    let (folder, _) = OutputArguments::default().places(given)?;
    if !output.imu.is_empty() {
        below(&folder, &output.imu, "output.imu", "--imu")?;
    }
    let mut play = ready(given)?;
    let mut fly = |index| -> Result<(), Error> {
        let sample = given.sample(index)?;
        play.push(&sample).map(|_| ()).map_err(|stopped| stopped.error)
    };
    (0..given.count.min(2)).try_for_each(|index| fly(index).map_err(|error| given.failure_at(index, &error)))
}

/// The scene before its first sample.
fn ready(given: &Given) -> Result<Play, Failure> {
    given.play().map_err(|error| Failure::new(format!("{}: {error}", given.origin)))
}

/// Puts all files in place, each as far as the disk has taken it. The records are last, because the report looks for the summary beside
/// the records.
pub fn finish(figures: &Figures, files: Files, summary_file: OutputFile) -> Result<(), Failure> {
    let Files { records, imu, unit } = files;
    let text = summary::text(figures)?;
    Failure::each([
        imu.map_or(Ok(()), OutputFile::commit_lines),
        unit.map_or(Ok(()), UnitFiles::commit),
        summary_file.finish(text),
        records.commit_lines(),
    ])
}

/// The files of the unit, if the scene has a unit or the words of one are wanted.
fn unit(
    order: &Order,
    given: &Given,
    outputs: &mut Outputs,
    folder: &Path,
    path: &Path,
) -> Result<Option<UnitFiles>, Failure> {
    let has_unit = given.scene.unit.start.is_some();
    let file = has_unit.then(|| outputs.file(path, &unit::COLUMNS.join(","))).transpose()?;
    let bus = match &order.bus {
        None => None,
        Some(_) if !(0.0..=200.0).contains(&order.bus_delay) => {
            return Err(Failure::new(format!("--bus-delay {}: must be from 0 to 200", order.bus_delay)));
        }
        Some(name) => {
            let path = below(folder, name, "--bus", "--bus")?;
            outputs.folder_of(&path)?;
            let inputs = Inputs { axes: given.scene.options.axes, ..Inputs::default() };
            let file = outputs.file(&path, &bus::COLUMNS.join(","))?;
            Some(Bus::new(file, order.bus_delay / 1e3, inputs)?)
        }
    };
    if !has_unit && bus.is_none() {
        return Ok(None);
    }
    UnitFiles::new(file, bus).map(Some)
}
