//! The command line of `sins_report budget`.

use std::ffi::OsString;
use std::path::PathBuf;

use sins::budget::BudgetRequest;
use sins::sensors::Grade;

use super::grade;
use crate::failure::Failure;

pub const USAGE: &str = "\
Usage: sins_report budget -o DIR [OPTIONS] [SCENE ...]

Tells which effects of the sensors matter: flies each alone, and all together. A SCENE is simulation2, the paper's patrol, or
the CSV file of a flight log of your own, as sins_harness flight takes it; simulation2 if none is given. Writes into DIR:
budget.html; SCENE.svg; budget.csv, a row for each effect; table.md, which it prints as well.

  -o, --output DIR      where to write
  -h, --help            this text

Of the scenes after them:
  --sensors GRADE       strategic, navigation, tactical, industrial, consumer or simulation2; unless stated simulation2 for
                        the patrol, navigation for logs
  --hours HOURS         length of the patrol, 1 unless stated (48: half an hour of work)
  --runs RUNS           runs of each random effect, 8 to 1000, 16 unless stated
  --position METRES     what the effects that are left out may change together, at any time
  --velocity M_PER_S
  --attitude ARCSEC     (0: no limit)";

const ARCSEC: f64 = std::f64::consts::PI / 648_000.0;

/// What is flown.
#[derive(Debug, Clone, PartialEq)]
pub enum Flown {
    /// The patrol, so long [s].
    Patrol(f64),
    Log(PathBuf),
}

/// A scene with its sensors, and what is asked of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Ask {
    pub flown: Flown,
    pub grade: Grade,
    pub request: BudgetRequest,
}

/// What the command line asks for.
#[derive(Debug, PartialEq)]
pub struct Order {
    pub output: PathBuf,
    pub asks: Vec<Ask>,
}

/// Reads the arguments after `budget`; none: help is wanted.
pub fn order(arguments: impl IntoIterator<Item = OsString>) -> Result<Option<Order>, Failure> {
    use lexopt::prelude::*;
    let mut parser = lexopt::Parser::from_args(arguments);
    let (mut output, mut asks): (Option<PathBuf>, Vec<Ask>) = (None, Vec::new());
    let (mut grade, mut hours, mut request) = (None, 1.0, BudgetRequest::default());
    let ask = |path: PathBuf, grade: Option<Grade>, hours: f64, request| {
        if path.as_os_str() == "simulation2" {
            let flown = Flown::Patrol(hours * 3600.0);
            Ask { flown, grade: grade.unwrap_or(Grade::PaperSimulation2), request }
        } else {
            Ask { flown: Flown::Log(path), grade: grade.unwrap_or(Grade::Navigation), request }
        }
    };
    while let Some(argument) = parser.next()? {
        match argument {
            Short('h') | Long("help") => return Ok(None),
            Short('o') | Long("output") => output = Some(PathBuf::from(parser.value()?)),
            Long("sensors") => grade = Some(grade::named(&parser.value()?.string()?)?),
            Long("hours") => hours = parser.value()?.parse()?,
            Long("runs") => request.runs = parser.value()?.parse()?,
            Long("position") => request.limits.position_m = parser.value()?.parse()?,
            Long("velocity") => request.limits.velocity_m_s = parser.value()?.parse()?,
            Long("attitude") => request.limits.attitude_rad = ARCSEC * parser.value()?.parse::<f64>()?,
            Value(path) => asks.push(ask(path.into(), grade, hours, request)),
            _ => return Err(argument.unexpected().into()),
        }
        request.validate()?;
        if !(0.001..=1000.0).contains(&hours) {
            return Err(Failure::new(format!("--hours {hours}: expected 0.001 to 1000")));
        }
    }
    let output = output.ok_or_else(|| Failure::new("expected -o and the folder to write into"))?;
    if asks.is_empty() {
        asks.push(ask("simulation2".into(), grade, hours, request));
    }
    Ok(Some(Order { output, asks }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(arguments: &[&str]) -> Result<Option<Order>, String> {
        order(arguments.iter().map(OsString::from)).map_err(|failure| failure.to_string())
    }

    fn asks(arguments: &[&str]) -> Vec<Ask> {
        parsed(&[&["-o", "d"], arguments].concat()).unwrap().unwrap().asks
    }

    #[test]
    fn options_are_of_the_scenes_after_them() {
        let all = asks(&[
            "simulation2",
            "--sensors",
            "tactical",
            "--position",
            "5",
            "a.csv",
            "--runs",
            "64",
            "b.csv",
        ]);
        assert_eq!(all[0], asks(&[])[0]);
        assert_eq!((all[0].flown.clone(), all[0].grade), (Flown::Patrol(3600.0), Grade::PaperSimulation2));
        assert_eq!((all[1].flown.clone(), all[1].grade), (Flown::Log("a.csv".into()), Grade::Tactical));
        assert_eq!((all[0].request.limits.position_m, all[1].request.limits.position_m), (0.0, 5.0));
        assert_eq!((all[1].request.runs, all[2].request.runs), (16, 64));
        assert_eq!(asks(&["own.csv"])[0].grade, Grade::Navigation);
        assert!(
            (asks(&["--attitude", "3600"])[0].request.limits.attitude_rad - 1f64.to_radians()).abs() < 1e-15
        );
    }

    #[test]
    fn what_is_wrong_is_named() {
        assert_eq!(parsed(&["--help"]), Ok(None));
        assert!(parsed(&["simulation2"]).unwrap_err().contains("-o"));
        for (arguments, named) in [
            (["--sensors", "best"], "best"),
            (["--hours", "0"], "--hours 0"),
            (["--runs", "3"], "request.runs = 3"),
            (["--position", "-1"], "request.position_m = -1"),
            (["--quick", "x"], "--quick"),
        ] {
            assert!(parsed(&arguments).unwrap_err().contains(named), "{arguments:?}");
        }
    }
}
