//! `sins report`: recorded runs as one page that needs nothing from outside.
//!
//! The data flow is `run`, `summary` → `path` → `trajectory`, `errors`, `radial`, `spectrum`, `sensors` → `figures`, `sentence`,
//! `warnings` → `overview`, `comparison`, `page`, `picture`.

mod comparison;
mod errors;
mod figures;
mod overview;
mod page;
mod path;
mod picture;
mod radial;
mod rows;
mod run;
mod sensors;
mod sentence;
mod spectrum;
mod summary;
mod trajectory;
mod unit;
mod warnings;

use std::path::{Path, PathBuf};

use crate::drawing::document::PAGE_MARK;
use crate::drawing::file::PICTURE_MARK;
use crate::failure::Failure;
use crate::output::{OutputFile, Outputs};
use crate::places::OUTPUT_FOLDER;
use crate::progress::Progress;
use crate::terminal::print;
use crate::written;
use run::Run;

/// Ends of the names of files beside records.
const BESIDE: [&str; 3] = ["_summary.csv", "_unit.csv", "_rows.csv"];

/// Largest number of runs on a page: each has its curves there, and its records in memory while it is drawn.
const MOST_RUNS: usize = 100;

/// Draws recorded runs on one self-contained page (sins_out/report.html)
#[derive(Debug, clap::Args)]
pub struct Order {
    /// Records that `sins fly` wrote, each with its RUN_summary.csv in the same folder. Arguments that end in _summary.csv,
    /// _unit.csv or _rows.csv are ignored: *.csv means all runs of a folder, at most 100
    #[arg(required = true, value_name = "RUN.csv")]
    runs: Vec<PathBuf>,
    /// The page [default: sins_out/report.html]
    #[arg(short, long, value_name = "FILE.html")]
    output: Option<PathBuf>,
    /// Also draws velocity and position errors of the first run into this file
    #[arg(long, value_name = "FILE.svg")]
    picture: Option<PathBuf>,
    /// Also replaces files that this program did not write
    #[arg(long)]
    force: bool,
}

pub fn run(order: &Order) -> Result<(), Failure> {
    let is_beside = |path: &str| BESIDE.iter().any(|ending| path.ends_with(ending));
    let is_run = |path: &&PathBuf| !is_beside(&path.to_string_lossy());
    let paths: Vec<&PathBuf> = order.runs.iter().filter(is_run).collect();
    if paths.is_empty() {
        return Err(Failure::new(
            "expected at least one RUN.csv; found only files that end in _summary.csv, _unit.csv or _rows.csv",
        ));
    }
    if paths.len() > MOST_RUNS {
        return Err(Failure::new(format!(
            "{} runs: a page has at most {MOST_RUNS}; `sins ensemble` flies many runs, and draws their statistics",
            paths.len()
        )));
    }
    let inputs: Vec<PathBuf> =
        paths.iter().flat_map(|path| [(*path).clone(), run::summary_path(path)]).collect();
    let mut outputs = Outputs::new(&inputs, order.force);
    let output = match &order.output {
        Some(path) => path.clone(),
        None => {
            outputs.folder(Path::new(OUTPUT_FOLDER))?;
            Path::new(OUTPUT_FOLDER).join("report.html")
        }
    };
    let page_file = outputs.file(&output, PAGE_MARK)?;
    let picture_file = order.picture.as_ref().map(|path| outputs.file(path, PICTURE_MARK)).transpose()?;
    draw(&paths, page_file, picture_file)?;
    let paths: Vec<&PathBuf> = [Some(&output), order.picture.as_ref()].into_iter().flatten().collect();
    print(&written::text(&paths, Some(&written::open(&output))))
}

/// Draws recorded runs on a page, and the first one as a picture.
pub fn draw(
    paths: &[impl AsRef<Path>],
    page_file: OutputFile,
    picture_file: Option<OutputFile>,
) -> Result<(), Failure> {
    let working = Progress::working("reading and drawing");
    let runs = paths.iter().map(|path| Run::read(path.as_ref())).collect::<Result<Vec<_>, _>>()?;
    let page = page::page(&runs)?;
    let picture = picture_file.map(|file| picture::picture(&runs[0]).map(|text| (file, text))).transpose()?;
    drop(working);
    Failure::each([page_file.finish(page), picture.map_or(Ok(()), |(file, text)| file.finish(text))])
}
