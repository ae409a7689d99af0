//! `sins ensemble`: a scene flown many times, each run with its own random errors, and how large the errors get.
//!
//! The data flow is `command`, `specification` (of `requirement`s) → `plan` → `flight` → `results`, `checkpoint` → `table` →
//! `study` → `bands`, `ends`, `verdict` → `document` (page), `print` (terminal).

mod bands;
mod checkpoint;
mod command;
mod document;
mod ends;
mod flight;
mod plan;
mod print;
mod radii;
mod requirement;
mod results;
mod single;
mod specification;
mod study;
mod table;
mod verdict;

pub use command::Order;

use std::path::PathBuf;

use crate::drawing::document::PAGE_MARK;
use crate::failure::{Failure, Kind};
use crate::interrupt;
use crate::output::Outputs;
use crate::parallel::cores;
use crate::terminal;
use crate::written;
use checkpoint::Checkpoint;
use plan::Plan;
use results::Results;
use study::Study;

pub fn run(order: &Order) -> Result<(), Failure> {
    let mut given = order.scene.load_for(&order.hours, command::FOR_LOGS)?;
    let mut requirements = Vec::new();
    for name in &order.meets {
        let (read, path) = specification::load(name)?;
        requirements.extend(read);
        given.inputs.extend(path);
    }
    let plan = Plan::new(order, &given, requirements)?;
    if plan.runs > 1 && !given.scene.is_random() {
        let what = "nothing is random in this scene: all runs would be equal. --preset navigation sets random errors; --runs 1 flies one run";
        return Err(Failure::new(format!("{}: {what}", given.origin)));
    }
    let (folder, name) = order.output.places(&given)?;
    let mut outputs = Outputs::new(&given.inputs, order.output.force);
    // The outputs are opened before the flight, so that one that cannot be written is reported at once.
    outputs.folder(&folder)?;
    let file = |ending: &str| folder.join(format!("{name}_ensemble{ending}"));
    // It reserves the name of the ensemble, the checkpoint too.
    let statistics_file = outputs.file(&file(".csv"), table::MARK)?;
    let mut checkpoint = Checkpoint::new(file(".checkpoint"), &given, &plan, order.output.force)?;
    let mut results = checkpoint.read(&plan)?;
    let mut runs_file = outputs.file(&file("_runs.csv"), table::RUNS_MARK)?;
    let page_file = outputs.file(&file(".html"), PAGE_MARK)?;
    let verdicts_file = match order.meets[..] {
        [] => None,
        _ => Some(outputs.file(&file("_meets.csv"), &verdict::COLUMNS.join(","))?),
    };

    let own = [&page_file, &statistics_file, &runs_file].into_iter().chain(&verdicts_file);
    let paths: Vec<PathBuf> = own.map(|file| file.path().to_owned()).collect();
    let quiet = order.output.is_quiet(&given);
    let threads = order.threads.map_or_else(cores, |threads| threads as usize);
    let before = results.runs(&plan);
    if before > 0 && !quiet {
        terminal::say(&format!("{}: {before} of {} runs are flown", checkpoint.path().display(), plan.runs));
    }
    interrupt::graceful();
    let flown = flight::fly(&given, &plan, threads, &mut results, &mut checkpoint, quiet);
    let flown = flown.map_err(|failure| match failure.kind() {
        Kind::Interrupted => Failure::of_kind(Kind::Interrupted, interrupted(&plan, &results, &checkpoint)),
        _ => failure,
    })?;

    let rows = table::rows(&given, &plan, &results)?;
    let study = Study { given: &given, name: &name, plan: &plan, results: &results, rows };
    let judged = verdict::verdicts(&study)?;
    let (page, verdicts) = (document::page(&study, &judged)?, verdict::file(&judged)?);
    let runs = table::write_runs(&plan, &results, &mut runs_file);
    let finished = Failure::each([
        statistics_file.finish(table::statistics(&study.rows)),
        runs.map_err(|error| Failure::of_output(runs_file.path(), &error)).and_then(|()| runs_file.commit()),
        page_file.finish(page),
        verdicts_file.map_or(Ok(()), |file| file.finish(verdicts)),
    ]);
    let printed = match quiet {
        true => Ok(()),
        false => {
            let list = written::text(&paths, Some(&written::open(&paths[0])));
            terminal::print(&(print::text(&study, &judged, &flown, threads) + &list))
        }
    };
    match finished {
        Ok(()) => checkpoint.remove()?,
        // The runs are not lost.
        Err(failure) => {
            let kept = checkpoint.write(&plan, &results);
            return Err(match kept {
                Ok(()) => failure.with(&checkpoint.kept(&plan, &results)),
                Err(_) => failure,
            });
        }
    }
    printed?;
    if results.diverged.len() as u64 == plan.runs {
        return Err(Failure::of_kind(Kind::Failed, "every run diverged before the end"));
    }
    verdict::failure(&judged).map_or(Ok(()), Err)
}

fn interrupted(plan: &Plan, results: &Results, checkpoint: &Checkpoint) -> String {
    match results.runs(plan) {
        0 => "interrupted before the first runs were flown".to_owned(),
        _ => format!("interrupted; {}", checkpoint.kept(plan, results)),
    }
}
