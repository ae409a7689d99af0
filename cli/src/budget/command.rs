//! The command line of `sins budget`.

use std::ffi::OsString;
use std::path::PathBuf;

use sins::budget::BudgetRequest;
use sins::recommend::SolutionError;
use sins::units::ARCSEC;

use crate::failure::Failure;
use crate::given::Settings;

/// How a log is flown that comes without a scene: the recommended simulator with sensors of navigation grade.
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
/// Writes into DIR: budget.html; SCENE.svg; budget.csv, a row for each effect; table.md, which it prints as well. Errors of
/// sensors, altimeter, start, mounting and gravity count as the scene sets them; failures of sensors are not flown.
#[derive(Debug, clap::Args)]
pub struct Order {
    /// Built-in scenes, files SCENE.toml, or flight logs LOG.csv, which are flown with sensors of navigation grade
    #[arg(value_name = "SCENE", default_value = "simulation2")]
    pub scenes: Vec<OsString>,
    #[command(flatten)]
    pub settings: Settings,
    /// Folder of all outputs
    #[arg(short, long, value_name = "DIR", default_value = "sins_out/budget")]
    pub out: PathBuf,
    /// Hours of each scene that are flown at most
    #[arg(long, default_value_t = 1.0)]
    pub hours: f64,
    /// Number of runs with all effects together, if any effect is random, 8 to 1000
    #[arg(long, default_value_t = 16)]
    pub runs: u64,
    /// Limit for the change of the position error by all effects that are left out together, at any time; 0: no limit
    #[arg(long, value_name = "METRES", default_value_t = 0.0)]
    pub position: f64,
    /// Limit for the change of the velocity error, likewise; 0: no limit
    #[arg(long, value_name = "M_PER_S", default_value_t = 0.0)]
    pub velocity: f64,
    /// Limit for the change of the misalignment, likewise; 0: no limit
    #[arg(long, value_name = "ARCSEC", default_value_t = 0.0)]
    pub attitude: f64,
    /// Also replaces files that this program did not write
    #[arg(long)]
    pub force: bool,
}

impl Order {
    /// What is asked of each scene.
    pub fn request(&self) -> Result<BudgetRequest, Failure> {
        if !(0.001..=1000.0).contains(&self.hours) {
            return Err(Failure::new(format!("--hours {}: expected 0.001 to 1000", self.hours)));
        }
        let limits = SolutionError {
            position_m: self.position,
            velocity_m_s: self.velocity,
            attitude_rad: ARCSEC * self.attitude,
        };
        let request = BudgetRequest { runs: self.runs, limits };
        request.validate()?;
        Ok(request)
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;

    #[derive(Debug, Parser)]
    struct Line {
        #[command(flatten)]
        order: Order,
    }

    fn request(arguments: &[&str]) -> Result<BudgetRequest, String> {
        let line = Line::try_parse_from([&["budget"], arguments].concat()).map_err(|e| e.to_string())?;
        line.order.request().map_err(|failure| failure.to_string())
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
            (["--runs", "3"], "request.runs = 3"),
            (["--position", "1e13"], "request.position_m"),
            (["--quick", "x"], "--quick"),
        ] {
            assert!(request(&arguments).unwrap_err().contains(named), "{arguments:?}");
        }
    }
}
