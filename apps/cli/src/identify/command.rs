//! The command line of `sins identify`.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use nalgebra::Matrix3;
use sins::analysis::identify::check::CheckRequest;
use sins::analysis::identify::{Also, Prior, Request};
use sins::sensors::Grade;

use super::check::truth_sigma;
use crate::failure::Failure;
use crate::given::{Settings, Trust, whole};
use crate::imu::{Wanted, wanted};
use crate::places::beside;

/// Scene of a log that has no scene.
pub const FOR_LOGS: &str = "[flight]\nfile = \"log\"\n";

/// Finds the errors that a recorded IMU has, and writes them as a scene that flies
///
/// Compares the record with what perfect sensors measure along the true path. Finds how the clock of the record is shifted, which
/// axis is which, then biases, scale factors, misalignments and the noise of each sensor, with 95 % intervals. What the motion does not
/// show is reported as not seen, with a motion that would show it, and is not written.
///
/// The record has three columns of rates or angle increments and three of forces or velocity increments, each three in the order x, y, z,
/// and time stamps. The unit of a column is in brackets, "AngleRateX (rad/s)", at the end of its name, gyro_x_deg_s, or that of a known
/// recorder; docs/identify.md names them. Columns of other names are described by an [imu] (--imu-map). The scene has the [imu] by which
/// the record was read. A record of another motion or in other units, or whose clock jumps, is rejected.
#[derive(Debug, clap::Args)]
pub struct Order {
    /// The true path: a flight log LOG.csv, a scene, or a built-in scene
    #[arg(value_name = "TRUTH")]
    pub truth: OsString,
    /// The record of the IMU; it may be the table of the path ("-": standard input)
    #[arg(long, value_name = "RECORD.csv")]
    pub imu: PathBuf,
    #[command(flatten)]
    pub settings: Settings,
    #[command(flatten)]
    pub trust: Trust,
    /// The scene [default: RECORD_sensor.toml in the folder of the record; of standard input imu_sensor.toml]
    #[arg(short, long, value_name = "SENSOR.toml")]
    pub output: Option<PathBuf>,
    /// Also draws what was found as a page: parameters on their priors, what the record has beside them, drifts of --check
    #[arg(long, value_name = "PAGE.html")]
    pub page: Option<PathBuf>,
    /// Also draws the drifts of --check into this file
    #[arg(long, value_name = "FILE.svg", requires = "check")]
    pub picture: Option<PathBuf>,
    /// What is known of the sensors: strategic, navigation, tactical, industrial or consumer
    ///
    /// The default is consumer, the widest. A prior that is too narrow moves the estimates.
    #[arg(long, value_name = "GRADE", default_value = "consumer")]
    pub prior: String,
    /// Columns of the record, separated by commas, if its names do not say them: "wx=deg/s"
    #[arg(long = "imu-columns", value_name = "NAME[=UNIT]", value_delimiter = ',', value_parser = wanted)]
    pub imu_columns: Vec<Wanted>,
    /// Reads the record by the [imu] of this file, which names the column of each sensor [default: the [imu] of TRUTH, if it has one]
    #[arg(long = "imu-map", value_name = "FILE.toml", conflicts_with = "imu_columns")]
    pub imu_map: Option<PathBuf>,
    /// Samples per second of a record without time stamps
    #[arg(long, value_name = "HZ")]
    pub rate: Option<f64>,
    /// Time of the path less time of the record [s], if it is known to 10 s
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    pub shift: Option<f64>,
    /// Frequency above which the path lacks motion, as "motion above 0.45 Hz is lost" of `sins log` states it
    ///
    /// Record and path are compared by their means over a period of it.
    #[arg(long, value_name = "HZ")]
    pub cutoff: Option<f64>,
    /// Parameters that are found beside the others: lever-arm, g-sensitivity, asymmetry, temperature
    ///
    /// A record whose motion does not tell them from the others tells all of them less well.
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    pub also: Vec<AlsoName>,
    /// Axes of the path along x, y and z of the record, if they are known: "y x -z"
    #[arg(long, value_name = "AXES", allow_hyphen_values = true)]
    pub axes: Option<String>,
    /// Reads forces that are negative where the sensor is pushed forward
    #[arg(long)]
    pub reversed: bool,
    /// Identifies the first half of the record only, and checks in the other half how far the sensors drift
    ///
    /// The other half is navigated from many starts, with the errors removed that were found. Twins, sensors drawn from what was found,
    /// fly the same starts. The verdict compares their drifts: agrees, the model is too good, or too bad.
    #[arg(long)]
    pub check: bool,
    /// Standard deviations of the errors of the path, with which each flight of the twins begins: "velocity_m_s=0.03"
    ///
    /// Names: position_m, velocity_m_s, tilt_arcmin, heading_arcmin; those that are not stated are 0.
    #[arg(long, value_name = "NAME=NUMBER", value_delimiter = ',', requires = "check")]
    pub truth_sigma: Vec<String>,
    /// Number of twins, 40 to 1000
    #[arg(long, value_name = "COUNT", default_value_t = 100, value_parser = whole(40, 1000), requires = "check")]
    pub twins: u64,
    /// Prints what was found as JSON in the place of the table
    #[arg(long)]
    pub json: bool,
    /// Also replaces files that this program did not write
    #[arg(long)]
    pub force: bool,
}

/// A parameter that is found if it is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum AlsoName {
    LeverArm,
    GSensitivity,
    Asymmetry,
    Temperature,
}

impl Order {
    /// File of the scene.
    pub fn output(&self) -> PathBuf {
        let record = if self.imu == Path::new("-") { Path::new("imu.csv") } else { &self.imu };
        self.output.clone().unwrap_or_else(|| beside(record, "_sensor.toml"))
    }

    /// What a check is made with, if one is wanted.
    pub fn check_request(&self) -> Result<Option<CheckRequest>, Failure> {
        let truth = truth_sigma(&self.truth_sigma)?;
        let request = CheckRequest { twins: self.twins as usize, truth, ..CheckRequest::default() };
        Ok(self.check.then_some(request))
    }

    /// Checks that not both inputs are standard input, that no setting of the record is without effect, and the name of the page.
    pub fn check_inputs(&self) -> Result<(), Failure> {
        if let Some(page) =
            self.page.as_ref().filter(|page| page.extension().is_none_or(|ending| ending != "html"))
        {
            return Err(Failure::new(format!(
                "--page {}: expected a name that ends in .html",
                page.display()
            )));
        }
        let of_imu = self.settings.set.iter().find(|text| text.trim_start().starts_with("imu."));
        if let Some(text) = of_imu.filter(|_| !self.imu_columns.is_empty()) {
            return Err(Failure::new(format!(
                "--set {text}: has no effect beside --imu-columns, by which the record is read without an [imu]; expected one of both"
            )));
        }
        if self.truth == "-" && self.imu == Path::new("-") {
            return Err(Failure::new(
                "TRUTH and --imu are both \"-\": standard input is one file; expected the name of the other",
            ));
        }
        Ok(())
    }

    /// The name of the record in a sentence.
    pub fn record(&self) -> &Path {
        if self.imu == Path::new("-") { Path::new("standard input") } else { &self.imu }
    }

    /// What is known before the record.
    pub fn request(&self) -> Result<Request, Failure> {
        let grade = match self.prior.as_str() {
            "strategic" => Grade::Strategic,
            "navigation" => Grade::Navigation,
            "tactical" => Grade::Tactical,
            "industrial" => Grade::Industrial,
            "consumer" => Grade::Consumer,
            other => {
                let grades = "strategic, navigation, tactical, industrial or consumer";
                return Err(Failure::new(format!("--prior {other}: expected {grades}")));
            }
        };
        if let Some(rate) = self.rate.filter(|rate| !(1e-3..=1e6).contains(rate)) {
            return Err(Failure::new(format!("--rate {rate}: expected 0.001 to 1e6 samples per second")));
        }
        if let Some(shift) = self.shift.filter(|shift| !shift.is_finite()) {
            return Err(Failure::new(format!("--shift {shift}: expected a finite number of seconds")));
        }
        if let Some(cutoff) = self.cutoff.filter(|cutoff| !(1e-3..=1e6).contains(cutoff)) {
            return Err(Failure::new(format!("--cutoff {cutoff}: expected 0.001 to 1e6 Hz")));
        }
        let axes = self.axes.as_deref().map(axes).transpose()?;
        let has = |name: AlsoName| self.also.contains(&name);
        let also = Also {
            lever_arm: has(AlsoName::LeverArm),
            g_sensitivity: has(AlsoName::GSensitivity),
            asymmetry: has(AlsoName::Asymmetry),
            temperature: has(AlsoName::Temperature),
        };
        if also.lever_arm && self.check {
            return Err(Failure::new(
                "--also lever-arm: --check flies from the point of the path; expected one of both",
            ));
        }
        Ok(Request { prior: Prior::of(grade), axes, shift_s: self.shift, cutoff_hz: self.cutoff, also })
    }
}

/// The exchange of axes of a text such as "y x -z".
fn axes(text: &str) -> Result<Matrix3<f64>, Failure> {
    let mut exchange = Matrix3::<f64>::zeros();
    let words: Vec<&str> = text.split([' ', ',']).filter(|word| !word.is_empty()).collect();
    for (row, word) in words.iter().enumerate().take(3) {
        let (sign, name) = word.strip_prefix('-').map_or((1.0, *word), |name| (-1.0, name));
        if let Some(column) = ["x", "y", "z"].iter().position(|axis| *axis == name.trim_start_matches('+')) {
            exchange[(row, column)] = sign;
        }
    }
    let is_one = words.len() == 3 && (exchange.determinant() - 1.0).abs() < 1e-9;
    if is_one {
        return Ok(exchange);
    }
    Err(Failure::new(format!(
        "--axes {text}: expected x, y and z once each with or without \"-\", and no reflection, as \"y x -z\""
    )))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parsed::parsed;

    fn request(more: &[&str]) -> Result<Request, String> {
        let arguments: Vec<&str> = ["a.csv", "--imu", "b.csv"].iter().chain(more).copied().collect();
        parsed::<Order>(&arguments)?.request().map_err(|failure| failure.to_string())
    }

    #[test]
    fn what_is_known_is_read() {
        let known = request(&["--axes", "-y x z", "--shift", "-3.5", "--prior", "tactical"]).unwrap();
        assert_eq!(known.axes, Some(Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0)));
        assert_eq!((known.shift_s, known.prior), (Some(-3.5), Prior::of(Grade::Tactical)));
        assert_eq!(
            parsed::<Order>(&["a", "--imu", "d/b.csv"]).unwrap().output(),
            PathBuf::from("d/b_sensor.toml")
        );
        let of_input = parsed::<Order>(&["a", "--imu", "-"]).unwrap();
        assert_eq!(of_input.output(), PathBuf::from("imu_sensor.toml"));
        assert!(of_input.check_inputs().is_ok());
        let both = parsed::<Order>(&["-", "--imu", "-"]).unwrap().check_inputs().unwrap_err().to_string();
        assert!(both.contains("both \"-\""), "{both}");
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (more, named) in [
            (&["--axes", "x y -z"][..], "--axes x y -z: expected x, y and z once"),
            (&["--axes", "x x z"], "no reflection"),
            (&["--axes", "x y"], "--axes x y"),
            (&["--prior", "best"], "--prior best: expected strategic"),
            (&["--rate", "0"], "--rate 0: expected"),
            (&["--shift", "inf"], "--shift inf"),
            (&["--cutoff", "0"], "--cutoff 0: expected 0.001 to 1e6 Hz"),
            (&["--imu-map", "a.toml", "--imu-columns", "wx=deg/s"], "--imu-columns"),
        ] {
            assert!(request(more).unwrap_err().contains(named), "{more:?}");
        }
    }
}
