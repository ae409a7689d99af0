//! The command line of `sins allan`.

use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::imu::{Wanted, wanted};
use crate::places::beside;

/// Draws the Allan deviation of an IMU log, and finds the noise coefficients that explain it
///
/// Computes the overlapping Allan deviation of up to six columns of gyros and accelerometers, with 95 % intervals. Fits the
/// coefficients of quantization Q, random walk N, bias instability B, rate random walk K and ramp R, and prints them as a table.
///
/// The unit of a column is the end of its name. Angular rates: _rad_s, _deg_s, _mdeg_s, _deg_h; angles over an interval: _rad, _deg,
/// _arcsec; specific forces: _m_s2, _g, _mg, _ug; velocities over an interval: _m_s, _mm_s. It may stand in brackets: "gyro x [deg/s]".
/// Without --columns, the command reads all rates and forces, and the angles and velocities whose name contains "increment" or "delta".
/// Time stamps are in the column time_s, time_ms, time_us or time_ns, or in one that --columns names. Stamps may scatter; gaps split the
/// record into pieces, whose estimates are joined. A record in motion is rejected: the mean of a column over a second may change by 1
/// deg/s or 0.5 m/s2, or by what noise of the size of its changes from second to second explains.
///
/// Neighbouring values of many records depend on each other: behind a low-pass, by averaging, or because a slow sensor's values are
/// repeated. The averaging times that this reaches are left out of the fit, and named. If the coefficients do not explain the curve, they
/// have no intervals.
#[derive(Debug, PartialEq, clap::Args)]
pub struct Order {
    /// A log that `sins fly --imu` wrote, or one of your own ("-": standard input)
    #[arg(value_name = "LOG.csv")]
    pub log: PathBuf,
    /// Output file: OUT.svg or OUT.html [default: LOG_allan.html in the folder of the log; of standard input imu_allan.html]
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// Also writes averaging times and deviations into this file, and the coefficients into POINTS_fit.csv
    #[arg(long = "csv", value_name = "POINTS.csv")]
    pub points: Option<PathBuf>,
    /// Also writes a scene at rest whose sensors have the noise of the record
    ///
    /// The columns of a sensor are its axes x, y and z, in the order of the log; a single column stands for all three. Coefficients that
    /// the record does not show are left out, and those that it shows at a confidence below 99.7 %
    /// are comments.
    /// `sins fly SCENE.toml --imu IMU.csv` makes a record that can be compared.
    #[arg(long = "write", value_name = "SCENE.toml")]
    pub scene: Option<PathBuf>,
    /// Samples per second; needed if the log has no time stamps. Stamps of a log that has them are not used then: each row is the next
    /// sample
    #[arg(long = "rate", value_name = "HZ", value_parser = rate)]
    pub rate_hz: Option<f64>,
    /// Takes the sensor to be at rest, whatever its record looks like
    #[arg(long)]
    pub still: bool,
    /// Reads only these columns, separated by commas. If a name does not end with a unit, add it: "GyrX=deg/s"
    ///
    /// The column of the time stamps has a unit of time, s, ms, us or ns, or iso (2024-05-01T12:30:00Z) or hms (12:30:00): "t=us". If it is
    /// the only one here, all columns of rates and forces are read.
    #[arg(long, value_name = "NAME[=UNIT]", value_delimiter = ',', value_parser = wanted)]
    pub columns: Vec<Wanted>,
    /// Reads the log by the [imu] of this file, which names the column of each sensor
    #[arg(long = "imu-map", value_name = "FILE.toml", conflicts_with = "columns")]
    pub imu_map: Option<PathBuf>,
    /// Also replaces files that this program did not write
    #[arg(long)]
    pub force: bool,
}

impl Order {
    /// File of the output.
    pub fn output(&self) -> PathBuf {
        let log = if self.log == Path::new("-") { Path::new("imu.csv") } else { &self.log };
        self.output.clone().unwrap_or_else(|| beside(log, "_allan.html"))
    }

    /// Whether the output is a page, not a picture.
    pub fn is_page(&self) -> Result<bool, Failure> {
        let output = self.output();
        match output.extension().and_then(|ending| ending.to_str()) {
            Some("svg") => Ok(false),
            Some("html") => Ok(true),
            _ => {
                let what = format!("-o {}: expected a name that ends in .svg or .html", output.display());
                Err(Failure::new(what))
            }
        }
    }

    /// File of the coefficients.
    pub fn fit(&self) -> Option<PathBuf> {
        self.points.as_ref().map(|points| beside(points, "_fit.csv"))
    }
}

fn rate(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(rate) if rate > 0.0 && rate.is_finite() => Ok(rate),
        _ => Err("expected a number of samples per second, greater than 0".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parsed::parsed;

    #[test]
    fn columns_come_with_units_or_without() {
        let arguments = [
            "log.csv",
            "-o",
            "a.svg",
            "--rate",
            "200",
            "--columns",
            "wx:deg_s, f_z_g,a b=m/s²",
            "--csv",
            "p.csv",
        ];
        let order: Order = parsed(&arguments).unwrap();
        let columns = [("wx", Some("deg_s")), ("f_z_g", None), ("a b", Some("m_s2"))]
            .map(|(name, unit)| Wanted { name: name.into(), unit: unit.map(str::to_owned) });
        assert_eq!((order.columns.as_slice(), order.rate_hz), (&columns[..], Some(200.0)));
        assert_eq!((order.log.as_os_str(), order.fit()), ("log.csv".as_ref(), Some("p_fit.csv".into())));
    }

    #[test]
    fn the_page_stands_beside_the_log_by_default() {
        let order: Order = parsed(&["logs/imu.csv"]).unwrap();
        assert_eq!(order.output(), PathBuf::from("logs/imu_allan.html"));
        assert!(order.is_page().unwrap());
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (arguments, named) in [
            (&["-o", "a.svg"][..], "LOG.csv"),
            (&["log.csv", "-o", "a.svg", "--rate=-1"], "-1"),
            (&["log.csv", "-o", "a.svg", "second.csv"], "second.csv"),
        ] {
            assert!(parsed::<Order>(arguments).unwrap_err().contains(named), "{arguments:?}");
        }
        let failure = parsed::<Order>(&["log.csv", "-o", "a.png"]).unwrap().is_page().unwrap_err();
        assert!(failure.to_string().contains("a.png"));
    }
}
