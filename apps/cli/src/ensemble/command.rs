//! The command line of `sins ensemble`.

use std::ffi::OsString;

use super::plan::MOST_RUNS;
use crate::given::{Hours, SceneArguments, whole};
use crate::places::OutputArguments;

/// Scene of a log that has no scene: the recommended simulator with sensors of navigation grade.
pub const FOR_LOGS: &str = crate::budget::FOR_LOGS;

/// Flies a scene many times, each run with its own random errors, and reports how large the errors get and how often
///
/// Writes into DIR: NAME_ensemble.csv, statistics of the runs over time; NAME_ensemble_runs.csv, the errors of each run at the end;
/// NAME_ensemble.html, a page with pictures of both. Run k has the errors that `sins fly` gives with options.run=k. The files are the same
/// to the byte for any number of threads. Ctrl-C leaves NAME_ensemble.checkpoint: the same command continues from there. A log without a
/// scene is flown with sensors of navigation grade. With --meets also NAME_ensemble_meets.csv: for each requirement, the number of runs
/// within the limit, the interval of their fraction, and the verdict.
#[derive(Debug, clap::Args)]
pub struct Order {
    #[command(flatten)]
    pub scene: SceneArguments,
    #[command(flatten)]
    pub hours: Hours,
    /// Number of runs
    #[arg(long, default_value_t = 1000, value_parser = whole(1, MOST_RUNS))]
    pub runs: u64,
    /// Number of the first run [default: the scene's options.run]
    #[arg(long, value_name = "RUN", value_parser = whole(0, u64::MAX))]
    pub first_run: Option<u64>,
    /// Number of threads [default: one on each core]
    #[arg(long, value_name = "N", value_parser = whole(1, 4096))]
    pub threads: Option<u64>,
    /// Time between two rows of statistics [default: a 200th of the flight]
    #[arg(long, value_name = "SECONDS")]
    pub every: Option<f64>,
    /// Requirements: a file, or airliner, navigation_grade, rnp10; the exit code tells whether the runs meet all of them
    #[arg(long, value_name = "FILE|NAME")]
    pub meets: Vec<OsString>,
    #[command(flatten)]
    pub output: OutputArguments,
}
