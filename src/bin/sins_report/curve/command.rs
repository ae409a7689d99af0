//! The command line of `sins_report curve`.

use std::ffi::OsString;
use std::path::PathBuf;

use super::embedded::{self, Embedded};
use crate::failure::Failure;

pub const USAGE: &str = "\
Usage: sins_report curve -o DIR [--scene NAME]... [--quick] [--instructions FILE] [LOG.csv ...]

Measures what accuracy costs: schemes, subsamples, sample rates and axes by time and by error, without sensor errors.
Writes into DIR: curve.csv, a row for each configuration; scenes.csv; SCENE.svg; table.md, which it prints as well.

  -o, --output DIR      where to write
  --scene NAME          rest, cruise, aerobatics, vibration, pole or all; all if neither scene nor log is given
  --quick               two minutes of each scene instead of an hour, and fewer repetitions
  --instructions FILE   adds the instructions of a step, as benches/instructions.sh matrix prints them
  LOG.csv               a flight log of your own, as sins_harness flight takes it
  -h, --help            this text";

/// How much is flown and timed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effort {
    /// Length of the embedded scenes [s].
    pub duration_s: f64,
    /// Rounds of the timing.
    pub rounds: usize,
    /// Runs with sensor errors.
    pub sensor_runs: u64,
}

const FULL: Effort = Effort { duration_s: 3600.0, rounds: 31, sensor_runs: 8 };
const QUICK: Effort = Effort { duration_s: 120.0, rounds: 5, sensor_runs: 4 };

/// What the command line asks for.
#[derive(Debug, PartialEq)]
pub struct Order {
    pub output: PathBuf,
    pub scenes: Vec<&'static Embedded>,
    pub logs: Vec<PathBuf>,
    pub instructions: Option<PathBuf>,
    pub effort: Effort,
}

/// Reads the arguments after `curve`; none: help is wanted.
pub fn order(arguments: impl IntoIterator<Item = OsString>) -> Result<Option<Order>, Failure> {
    use lexopt::prelude::*;
    let mut parser = lexopt::Parser::from_args(arguments);
    let (mut output, mut instructions, mut effort) = (None, None, FULL);
    let (mut scenes, mut logs): (Vec<&Embedded>, Vec<PathBuf>) = (Vec::new(), Vec::new());
    while let Some(argument) = parser.next()? {
        match argument {
            Short('h') | Long("help") => return Ok(None),
            Short('o') | Long("output") => output = Some(PathBuf::from(parser.value()?)),
            Long("instructions") => instructions = Some(PathBuf::from(parser.value()?)),
            Long("quick") => effort = QUICK,
            Long("scene") => match parser.value()?.string()?.as_str() {
                "all" => scenes.extend(&embedded::ALL),
                name => scenes.push(named(name)?),
            },
            Value(path) => logs.push(PathBuf::from(path)),
            _ => return Err(argument.unexpected().into()),
        }
    }
    let output = output.ok_or_else(|| Failure::new("expected -o and the folder to write into"))?;
    if scenes.is_empty() && logs.is_empty() {
        scenes.extend(&embedded::ALL);
    }
    Ok(Some(Order { output, scenes, logs, instructions, effort }))
}

fn named(name: &str) -> Result<&'static Embedded, Failure> {
    embedded::ALL.iter().find(|scene| scene.name == name).ok_or_else(|| {
        let names: Vec<&str> = embedded::ALL.iter().map(|scene| scene.name).collect();
        Failure::new(format!("--scene {name}: expected all or one of {}", names.join(", ")))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(arguments: &[&str]) -> Result<Option<Order>, String> {
        order(arguments.iter().map(OsString::from)).map_err(|failure| failure.to_string())
    }

    fn names(arguments: &[&str]) -> Vec<&'static str> {
        parsed(arguments).unwrap().unwrap().scenes.iter().map(|scene| scene.name).collect()
    }

    #[test]
    fn scenes_and_logs() {
        assert_eq!(names(&["-o", "d"]).len(), embedded::ALL.len());
        assert_eq!(names(&["-o", "d", "--scene", "pole", "--scene", "rest"]), ["pole", "rest"]);
        assert_eq!(names(&["-o", "d", "own.csv"]), [""; 0]);
        assert_eq!(names(&["-o", "d", "own.csv", "--scene", "all"]).len(), embedded::ALL.len());
        let order = parsed(&["own.csv", "--quick", "--instructions", "i.csv", "-o", "d"]).unwrap().unwrap();
        assert_eq!((order.effort, order.logs), (QUICK, vec!["own.csv".into()]));
        assert_eq!((order.output, order.instructions), ("d".into(), Some("i.csv".into())));
    }

    #[test]
    fn what_is_wrong_is_named() {
        assert_eq!(parsed(&["--help"]), Ok(None));
        assert!(parsed(&[]).unwrap_err().contains("-o"));
        assert!(parsed(&["-o", "d", "--scene", "moon"]).unwrap_err().contains("moon"));
        assert!(parsed(&["-o", "d", "--slow"]).unwrap_err().contains("--slow"));
    }
}
