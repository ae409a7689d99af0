//! The command line of `sins ensemble`.

use std::ffi::OsString;
use std::path::PathBuf;

use crate::given::Settings;

/// How a log is flown that comes without a scene: the recommended simulator with sensors of navigation grade.
pub const FOR_LOGS: &str = crate::budget::FOR_LOGS;

/// Flies a scene many times, each run with its own random errors, and reports how large the errors get and how often
///
/// Writes into DIR: NAME_ensemble.csv, statistics of the runs over time; NAME_ensemble_runs.csv, the errors of each run at the end;
/// NAME_ensemble.html, their pictures. Run k has the errors that `sins fly` gives with options.run=k. The files are the same to the
/// byte for any number of threads. Ctrl-C leaves NAME_ensemble.checkpoint: the same command continues from there.
#[derive(Debug, clap::Args)]
pub struct Order {
    /// A built-in scene, a file SCENE.toml, or a flight log LOG.csv, which is flown with sensors of navigation grade
    #[arg(value_name = "SCENE")]
    pub scene: Option<OsString>,
    /// Flies this flight log instead of the scene's own flight
    #[arg(long, value_name = "LOG.csv")]
    pub log: Option<PathBuf>,
    #[command(flatten)]
    pub settings: Settings,
    /// How many runs
    #[arg(long, default_value_t = 1000)]
    pub runs: u64,
    /// Number of the first run [default: the scene's options.run]
    #[arg(long, value_name = "RUN")]
    pub first_run: Option<u64>,
    /// How many threads fly [default: one on each core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=4096))]
    pub threads: Option<u16>,
    /// Time between two rows of statistics [s] [default: a 200th of the flight]
    #[arg(long, value_name = "SECONDS")]
    pub every: Option<f64>,
    /// Folder of all outputs [default: the scene's output.folder, or sins_out]
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Base name of the outputs [default: the scene's output.name, or the name of its file]
    #[arg(long)]
    pub name: Option<String>,
    /// Neither progress nor summary
    #[arg(short, long)]
    pub quiet: bool,
    /// Replaces files that are not of this program's making
    #[arg(long)]
    pub force: bool,
}
