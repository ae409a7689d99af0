//! The command line of `sins budget`.

use std::ffi::OsString;
use std::path::PathBuf;

use sins::analysis::budget::BudgetRequest;

use crate::failure::Failure;
use crate::given::{Settings, Trust, whole};
use crate::limits::{LimitArguments, of_option};

/// Scene of a log that has no scene: the recommended simulator with sensors of navigation grade.
pub const FOR_LOGS: &str = "\
[flight]
file = \"log\"
[gyro]
preset = \"navigation\"
[accelerometer]
preset = \"navigation\"
";

/// Finds which errors of a scene matter: flies each error alone, and all errors together
///
/// Writes into DIR: budget.html; SCENE.svg; budget.csv, a row for each effect; table.md, which it also prints. Errors of
/// sensors, altimeter, start, mounting and gravity are those that the scene sets; failures and updates are not flown.
///
/// With limits it also finds the effects that can be left out: without all of them together, the root mean square over the runs of
/// the change of each error is within its limit at any time. Single runs change by more.
#[derive(Debug, clap::Args)]
pub struct Order {
    /// Built-in scenes, files SCENE.toml, or flight logs LOG.csv; logs are flown with sensors of navigation grade
    #[arg(value_name = "SCENE", default_value = "simulation2")]
    pub scenes: Vec<OsString>,
    #[command(flatten)]
    pub settings: Settings,
    #[command(flatten)]
    pub trust: Trust,
    /// Folder of all outputs
    #[arg(short, long, value_name = "DIR", default_value = "sins_out/budget")]
    pub out: PathBuf,
    /// Hours of each scene or log to fly, at most
    #[arg(long, default_value_t = 1.0)]
    pub hours: f64,
    /// Number of runs with all effects together, if any effect is random, 8 to 1000
    #[arg(long, default_value_t = 16, value_parser = whole(8, 1000))]
    pub runs: u64,
    #[command(flatten)]
    limits: LimitArguments,
    /// Also measures the time that a step saves on this machine without each error
    #[arg(long)]
    pub time_steps: bool,
    /// Also replaces files that this program did not write
    #[arg(long)]
    pub force: bool,
}

impl Order {
    /// Request for each scene.
    pub fn request(&self) -> Result<BudgetRequest, Failure> {
        if !(0.001..=1000.0).contains(&self.hours) {
            return Err(Failure::new(format!("--hours {}: expected 0.001 to 1000", self.hours)));
        }
        let request = BudgetRequest { runs: self.runs, limits: self.limits.errors() };
        request.validate().map_err(|error| of_option(&error))?;
        Ok(request)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parsed::parsed;

    fn request(arguments: &[&str]) -> Result<BudgetRequest, String> {
        parsed::<Order>(arguments)?.request().map_err(|failure| failure.to_string())
    }

    #[test]
    fn limits_are_in_their_units() {
        let asked = request(&["--attitude", "3600", "--position", "5", "--runs", "64"]).unwrap();
        assert!((asked.limits.attitude_rad - 1f64.to_radians()).abs() < 1e-15);
        assert_eq!((asked.limits.position_m, asked.runs), (5.0, 64));
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (arguments, named) in [
            (["--hours", "0"], "--hours 0"),
            (["--runs", "3"], "expected a whole number from 8 to 1000"),
            (["--position", "1e13"], "--position = 1e13"),
            (["--quick", "x"], "--quick"),
        ] {
            assert!(request(&arguments).unwrap_err().contains(named), "{arguments:?}");
        }
    }
}
