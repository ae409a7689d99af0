//! The command line of `sins curve`.

use std::ffi::OsString;
use std::path::PathBuf;

use super::embedded::{self, Embedded};
use crate::given::{Settings, Trust};

/// Measures what accuracy costs: computing time and error of each scheme, number of subsamples, sample rate and choice of axes,
/// without sensor errors
///
/// Writes into DIR: curve.html; curve.csv, a row for each configuration; scenes.csv, a row for each scene; SCENE.svg; table.md, which it
/// also prints. Uses the ellipsoid and the gravity of a scene, but not its scheme, its axes or its sensor errors: --preset has no
/// effect.
#[derive(Debug, clap::Args)]
pub struct Order {
    /// Built-in scenes, files SCENE.toml, or flight logs LOG.csv
    #[arg(value_name = "SCENE")]
    pub given: Vec<OsString>,
    /// Built-in test flight: rest, cruise, aerobatics, vibration, pole or all; can be repeated [default: all, if no scene is given]
    #[arg(long = "flight", value_name = "NAME", value_parser = named)]
    flights: Vec<Choice>,
    #[command(flatten)]
    pub settings: Settings,
    #[command(flatten)]
    pub trust: Trust,
    /// Folder of all outputs
    #[arg(short, long, value_name = "DIR", default_value = "sins_out/curve")]
    pub out: PathBuf,
    /// Flies two minutes of each test flight instead of an hour, with fewer repetitions. A scene of manoeuvres is judged by its hardest
    /// minutes, those that `sins recommend` takes, whose errors are predicted for the whole of it
    #[arg(long)]
    quick: bool,
    /// Adds the instructions of a step from this file, which `benches/instructions.sh matrix` prints
    #[arg(long, value_name = "FILE")]
    pub instructions: Option<PathBuf>,
    /// Also replaces files that this program did not write
    #[arg(long)]
    pub force: bool,
}

/// Amount of work.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effort {
    /// Largest length of scenes that are not logs [s].
    pub duration_s: f64,
    /// Rounds of the timing.
    pub rounds: usize,
    /// Runs with sensor errors.
    pub sensor_runs: u64,
}

pub const FULL: Effort = Effort { duration_s: 3600.0, rounds: 31, sensor_runs: 8 };
const QUICK: Effort = Effort { duration_s: 120.0, rounds: 5, sensor_runs: 4 };

/// One of the flights, or all of them.
#[derive(Debug, Clone, Copy)]
struct Choice(Option<&'static Embedded>);

impl Order {
    pub fn effort(&self) -> Effort {
        if self.quick { QUICK } else { FULL }
    }

    /// The test flights to survey.
    pub fn embedded(&self) -> Vec<&'static Embedded> {
        let is_all = self.flights.iter().any(|choice| choice.0.is_none());
        if is_all || (self.flights.is_empty() && self.given.is_empty()) {
            return embedded::ALL.iter().collect();
        }
        self.flights.iter().filter_map(|choice| choice.0).collect()
    }
}

fn named(name: &str) -> Result<Choice, String> {
    if name == "all" {
        return Ok(Choice(None));
    }
    let names = || embedded::ALL.iter().map(|scene| scene.name);
    embedded::ALL.iter().find(|scene| scene.name == name).map(|scene| Choice(Some(scene))).ok_or_else(|| {
        let near = sins::scene::nearest(name, names())
            .map_or(String::new(), |near| format!("; did you mean {near}?"));
        format!("expected all or one of {}{near}", names().collect::<Vec<_>>().join(", "))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parsed::parsed;

    fn names(arguments: &[&str]) -> Vec<&'static str> {
        parsed::<Order>(arguments).unwrap().embedded().iter().map(|scene| scene.name).collect()
    }

    #[test]
    fn flights_and_scenes() {
        assert_eq!(names(&[]).len(), embedded::ALL.len());
        assert_eq!(names(&["--flight", "pole", "--flight", "rest"]), ["pole", "rest"]);
        assert_eq!(names(&["own.csv"]), [""; 0]);
        assert_eq!(names(&["own.csv", "--flight", "all"]).len(), embedded::ALL.len());
        let order = parsed::<Order>(&["own.csv", "--quick", "--instructions", "i.csv"]).unwrap();
        assert_eq!((order.effort(), order.given), (QUICK, vec!["own.csv".into()]));
        assert_eq!(order.instructions, Some("i.csv".into()));
    }

    #[test]
    fn what_is_wrong_is_named() {
        assert!(parsed::<Order>(&["--flight", "moon"]).unwrap_err().contains("moon"));
        assert!(parsed::<Order>(&["--flight", "aerobatic"]).unwrap_err().contains("aerobatics?"));
        assert!(parsed::<Order>(&["--slow"]).unwrap_err().contains("--slow"));
    }
}
