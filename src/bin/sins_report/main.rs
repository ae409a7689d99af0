//! Plots recorded runs of the simulator into one self-contained HTML file.
//!
//! A run is what the C example writes: `NAME.csv`, a row for each record, and `NAME_summary.csv`, a row for each
//! figure. The data flow is `run`, `summary` → `series`, `spectrum` → `axis`, `plot` → `figures` → `page`.
//!
//! `allan` is a command of its own: it plots the Allan deviation of an IMU log and fits the noises that explain it.
//! `budget` is a command of its own: it flies each effect of the sensors alone and draws which ones matter.
//! `curve` is a command of its own: it flies and times the mechanization and draws what accuracy costs.
#![allow(clippy::disallowed_methods, reason = "a plot needs no bits that are the same on every platform")]
#![forbid(unsafe_code)]

mod allan;
mod axis;
mod budget;
mod comparison;
mod curve;
mod errors;
mod failure;
mod figures;
mod flight_log;
mod lines;
mod overview;
mod page;
mod parallel;
mod pen;
mod picture;
mod plot;
mod rows;
mod run;
mod series;
mod spectrum;
mod summary;
mod table;
mod trajectory;
mod units;

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use failure::Failure;
use run::Run;

const USAGE: &str = "\
Usage: sins_report RUN.csv [RUN.csv ...] -o REPORT.html [--picture PICTURE.svg]
       sins_report allan LOG.csv -o OUT.svg [...]: noises of an IMU log; sins_report allan --help
       sins_report budget -o DIR [...]: which effects matter; sins_report budget --help
       sins_report curve -o DIR [...]: what accuracy costs; sins_report curve --help

Plots recorded runs into one HTML file. RUN_summary.csv has to lie beside each RUN.csv; an argument that ends in
_summary.csv is passed over, so that *.csv means all runs of a folder.

  -o, --output FILE   where to write
  --picture FILE      also velocity and position errors of the first run, as an SVG file
  -h, --help          this text";

/// What the command line asks for.
#[derive(Debug, PartialEq)]
enum Command {
    Help,
    Report { runs: Vec<PathBuf>, output: PathBuf, picture: Option<PathBuf> },
}

fn main() -> ExitCode {
    let mut arguments = std::env::args_os().skip(1).peekable();
    if arguments.next_if(|first| first == "allan").is_some() {
        return of_its_own("allan", allan::USAGE, allan::order(arguments), allan::run);
    }
    if arguments.next_if(|first| first == "budget").is_some() {
        return of_its_own("budget", budget::USAGE, budget::order(arguments), budget::run);
    }
    if arguments.next_if(|first| first == "curve").is_some() {
        return of_its_own("curve", curve::USAGE, curve::order(arguments), curve::run);
    }
    let command = match command(arguments) {
        Ok(command) => command,
        Err(failure) => {
            eprintln!("sins_report: {failure}\n\n{USAGE}");
            return ExitCode::from(2);
        }
    };
    match command {
        Command::Help => println!("{USAGE}"),
        Command::Report { runs, output, picture } => {
            if let Err(failure) = report(&runs, &output, picture.as_deref()) {
                eprintln!("sins_report: {failure}");
                return ExitCode::FAILURE;
            }
            println!("{}", output.display());
        }
    }
    ExitCode::SUCCESS
}

/// Carries out the order of the command `name`; none: tells how it is used.
fn of_its_own<Order>(
    name: &str,
    usage: &str,
    order: Result<Option<Order>, Failure>,
    run: impl Fn(&Order) -> Result<(), Failure>,
) -> ExitCode {
    let order = match order {
        Ok(order) => order,
        Err(failure) => {
            eprintln!("sins_report {name}: {failure}\n\n{usage}");
            return ExitCode::from(2);
        }
    };
    match order.map(|order| run(&order)) {
        None => println!("{usage}"),
        Some(Ok(())) => {}
        Some(Err(failure)) => {
            eprintln!("sins_report {name}: {failure}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

fn report(paths: &[PathBuf], output: &Path, picture: Option<&Path>) -> Result<(), Failure> {
    let runs = paths.iter().map(|path| Run::read(path)).collect::<Result<Vec<_>, _>>()?;
    write(output, &page::page(&runs)?)?;
    match (picture, runs.first()) {
        (Some(path), Some(run)) => write(path, &picture::picture(run)?),
        _ => Ok(()),
    }
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    std::fs::write(path, text).map_err(|error| Failure::of_file(path, &format!("cannot be written: {error}")))
}

fn command(arguments: impl IntoIterator<Item = OsString>) -> Result<Command, Failure> {
    use lexopt::prelude::*;
    let mut parser = lexopt::Parser::from_args(arguments);
    let mut runs = Vec::new();
    let (mut output, mut picture) = (None, None);
    while let Some(argument) = parser.next()? {
        match argument {
            Short('h') | Long("help") => return Ok(Command::Help),
            Short('o') | Long("output") => output = Some(PathBuf::from(parser.value()?)),
            Long("picture") => picture = Some(PathBuf::from(parser.value()?)),
            Value(path) => runs.push(PathBuf::from(path)),
            _ => return Err(argument.unexpected().into()),
        }
    }
    runs.retain(|path| !path.to_string_lossy().ends_with("_summary.csv"));
    let output = output.ok_or_else(|| Failure::new("expected -o and the file to write"))?;
    if runs.is_empty() {
        return Err(Failure::new("expected at least one RUN.csv"));
    }
    Ok(Command::Report { runs, output, picture })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(arguments: &[&str]) -> Result<Command, String> {
        command(arguments.iter().map(OsString::from)).map_err(|failure| failure.to_string())
    }

    #[test]
    fn the_command_line() {
        let report = |picture: Option<&str>| {
            let runs = vec!["a.csv".into(), "b.csv".into()];
            Ok(Command::Report { runs, output: "r.html".into(), picture: picture.map(PathBuf::from) })
        };
        assert_eq!(parsed(&["a.csv", "a_summary.csv", "b.csv", "-o", "r.html"]), report(None));
        assert_eq!(parsed(&["--picture", "p.svg", "a.csv", "b.csv", "-o", "r.html"]), report(Some("p.svg")));
        assert_eq!(parsed(&["-h"]), Ok(Command::Help));
        assert!(parsed(&["a.csv"]).unwrap_err().contains("-o"));
        assert!(parsed(&["-o", "r.html"]).unwrap_err().contains("RUN.csv"));
        assert!(parsed(&["--colour", "a.csv"]).unwrap_err().contains("--colour"));
    }
}
