//! `sins fly`: flies a scene, writes its records and figures, and prints a summary.
//!
//! The data flow is `crate::given` → `flight` → `crate::record`, `imu` → `figures` → `summary` (file), `print` (terminal).

mod figures;
mod flight;
mod imu;
mod print;
mod spacing;
mod summary;

use std::ffi::OsString;
use std::path::{Component, Path, PathBuf};

use crate::failure::{Failure, Kind};
use crate::given::{Given, Settings};
use crate::interrupt;
use crate::output::{OutputFile, Outputs};
use crate::record::COLUMNS;
use crate::terminal::print;
use figures::Figures;
use flight::{Files, Flown};

/// Folder of all outputs, where nothing else is said.
pub const OUTPUT_FOLDER: &str = "sins_out";

/// How a log is flown that comes without a scene: by the recommended simulator with ideal sensors.
pub const FOR_LOGS: &str = "[flight]\nfile = \"log\"\n";

/// Flies a scene, writes its records (DIR/NAME.csv) and figures (DIR/NAME_summary.csv), and prints a summary
#[derive(Debug, clap::Args)]
pub struct Order {
    /// A built-in scene (`sins scene list`), a file SCENE.toml, or a flight log LOG.csv ("-": standard input), which is flown with
    /// ideal sensors
    #[arg(value_name = "SCENE")]
    pub scene: Option<OsString>,
    /// Flies this flight log instead of the scene's own flight
    #[arg(long, value_name = "LOG.csv")]
    pub log: Option<PathBuf>,
    #[command(flatten)]
    pub settings: Settings,
    /// Folder of all outputs [default: the scene's output.folder, or sins_out]
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Base name of the outputs [default: the scene's output.name, or the name of its file]
    #[arg(long)]
    pub name: Option<String>,
    /// Also writes the measured increments of every sample interval into this file below DIR
    #[arg(long, value_name = "FILE.csv")]
    pub imu: Option<String>,
    /// Neither progress nor summary
    #[arg(short, long)]
    pub quiet: bool,
    /// Also replaces files that this program did not write
    #[arg(long)]
    pub force: bool,
}

/// Where the files go.
struct Places {
    folder: PathBuf,
    name: String,
    imu: Option<PathBuf>,
}

pub fn run(order: &Order) -> Result<(), Failure> {
    let given = Given::load(order.scene.as_deref(), order.log.as_deref(), &order.settings, FOR_LOGS)?;
    let places = places(order, &given)?;
    let every = spacing::intervals(&given)?;
    let mut outputs = Outputs::new(&given.inputs, order.force);
    // Before anything is flown: what cannot be written is known at once.
    outputs.folder(&places.folder)?;
    let file = |ending: &str| places.folder.join(format!("{}{ending}", places.name));
    let summary_file = outputs.file(&file("_summary.csv"), summary::MARK)?;
    let mut files = Files {
        records: outputs.file(&file(".csv"), &COLUMNS.join(","))?,
        imu: match &places.imu {
            Some(path) => {
                if let Some(folder) = path.parent() {
                    outputs.folder(folder)?;
                }
                Some(outputs.file(path, &imu::COLUMNS.join(","))?)
            }
            None => None,
        },
    };
    let quiet = order.quiet || given.scene.output.quiet;
    let mut flown = Flown::default();
    interrupt::graceful(true);
    let ended = flight::fly(&given, every, &mut files, &mut flown, quiet);
    if let Err(failure) = &ended
        && (failure.kind() == Kind::Input || flown.records == 0)
    {
        return ended.map(|_| ());
    }
    let figures = Figures::gather(&given, &places.name, every, &flown, ended.is_err());
    let finished = figures.and_then(|figures| {
        finish(&figures, files, summary_file)?;
        if quiet { Ok(()) } else { print(&print::text(&figures, &file(".csv"))) }
    });
    // What went wrong in flight comes first.
    ended.and(finished)
}

/// Puts all files in place: the records last, as the report looks for the summary beside them.
fn finish(figures: &Figures, files: Files, summary_file: OutputFile) -> Result<(), Failure> {
    let Files { records, imu } = files;
    let text = summary::text(figures)?;
    if let Some(imu) = imu {
        imu.commit()?;
    }
    summary_file.finish(&text)?;
    records.commit()
}

/// The command line's places, or else the scene's: those stay below the folder of the moment, whoever wrote the scene.
fn places(order: &Order, given: &Given) -> Result<Places, Failure> {
    let output = &given.scene.output;
    let folder = match &order.out {
        Some(folder) => folder.clone(),
        None if output.folder.is_empty() => PathBuf::from(OUTPUT_FOLDER),
        None => below(Path::new(""), &output.folder, "output.folder", "--out")?,
    };
    let name = order.name.as_ref().or(Some(&output.name).filter(|name| !name.is_empty()));
    let name = name.unwrap_or(&given.name).clone();
    if name.is_empty() || name.contains(['/', '\\']) || name.chars().any(char::is_control) {
        return Err(Failure::new(format!("--name \"{name}\": expected a name without a folder")));
    }
    let imu = order.imu.as_ref().or(Some(&output.imu).filter(|imu| !imu.is_empty()));
    let imu = imu.map(|file| below(&folder, file, "output.imu", "--imu")).transpose()?;
    Ok(Places { folder, name, imu })
}

/// `file` below `folder`; refuses what leads out of it.
fn below(folder: &Path, file: &str, key: &str, option: &str) -> Result<PathBuf, Failure> {
    let path = Path::new(file);
    let is_plain = |part: Component<'_>| matches!(part, Component::Normal(_));
    if file.contains('\0') || !path.components().all(is_plain) || path.components().next().is_none() {
        let what = format!(
            "{key} = \"{file}\": expected a name below the folder of the outputs ({option}), without .."
        );
        return Err(Failure::new(what));
    }
    Ok(folder.join(path))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_a_scene_stay_below_the_folder() {
        let of = |file| below(Path::new("out"), file, "output.imu", "--imu").map_err(|e| e.to_string());
        assert_eq!(of("a/imu.csv"), Ok(PathBuf::from("out/a/imu.csv")));
        for file in ["/etc/passwd", "../imu.csv", "a/../../imu.csv", ".", "", "./imu.csv", "a\0b"] {
            assert!(of(file).unwrap_err().contains("output.imu"), "{file:?}");
        }
    }
}
