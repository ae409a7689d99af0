//! The command line of `sins_report allan`.

use std::ffi::OsString;
use std::path::PathBuf;

use crate::failure::Failure;

pub const USAGE: &str = "\
Usage: sins_report allan LOG.csv -o OUT.svg|OUT.html [--rate HZ] [--columns NAME[:UNIT],...] [--csv POINTS.csv]

Overlapping Allan deviation of gyro and accelerometer columns, up to six, with 95 % intervals; the coefficients of
quantization Q, random walk N, bias instability B, rate random walk K and ramp R that explain it. Prints them as a table.

The unit of a column is the end of its name:
  rates          _rad_s  _deg_s  _deg_h      forces                _m_s2  _g  _mg  _ug
  angles         _rad  _deg  _arcsec         velocities            _m_s
Angles and velocities are increments over an interval. Without --columns all rates and forces are taken, and increments
whose name has \"increment\" or \"delta\" in it. time_s (or _ms, _us, _ns) has the stamps: they may jitter by less than
half an interval; a gap is refused.

  -o, --output FILE           where to draw
  --rate HZ                   samples a second; not the mean of the stamps, or there are none
  --columns NAME[:UNIT],...   these columns; UNIT as above without its first _, where the name has none
  --csv POINTS.csv            also averaging times and deviations; POINTS_fit.csv gets the coefficients
  -h, --help                  this text";

/// A column that is wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    pub name: String,
    /// Where the name has none.
    pub unit: Option<String>,
}

/// What the command line asks for.
#[derive(Debug, PartialEq)]
pub struct Order {
    pub log: PathBuf,
    pub output: PathBuf,
    pub points: Option<PathBuf>,
    pub rate_hz: Option<f64>,
    /// None: all that are sensors by their names.
    pub columns: Vec<Wanted>,
}

/// Reads the arguments after `allan`; none: help is wanted.
pub fn order(arguments: impl IntoIterator<Item = OsString>) -> Result<Option<Order>, Failure> {
    use lexopt::prelude::*;
    let mut parser = lexopt::Parser::from_args(arguments);
    let (mut log, mut output, mut points, mut rate_hz) = (None, None, None, None);
    let mut columns = Vec::new();
    while let Some(argument) = parser.next()? {
        match argument {
            Short('h') | Long("help") => return Ok(None),
            Short('o') | Long("output") => output = Some(PathBuf::from(parser.value()?)),
            Long("csv") => points = Some(PathBuf::from(parser.value()?)),
            Long("rate") => rate_hz = Some(rate(&parser.value()?.string()?)?),
            Long("columns") => columns.extend(parser.value()?.string()?.split(',').map(wanted)),
            Value(path) if log.is_none() => log = Some(PathBuf::from(path)),
            _ => return Err(argument.unexpected().into()),
        }
    }
    let log = log.ok_or_else(|| Failure::new("expected LOG.csv"))?;
    let output = output.ok_or_else(|| Failure::new("expected -o and the file to draw into"))?;
    match output.extension().and_then(|ending| ending.to_str()) {
        Some("svg" | "html") => Ok(Some(Order { log, output, points, rate_hz, columns })),
        _ => {
            Err(Failure::new(format!("-o {}: expected a name that ends in .svg or .html", output.display())))
        }
    }
}

fn rate(text: &str) -> Result<f64, Failure> {
    match text.parse::<f64>() {
        Ok(rate) if rate > 0.0 && rate.is_finite() => Ok(rate),
        _ => Err(Failure::new(format!("--rate {text}: expected samples a second"))),
    }
}

fn wanted(text: &str) -> Wanted {
    match text.split_once(':') {
        Some((name, unit)) => Wanted { name: name.trim().to_owned(), unit: Some(unit.trim().to_owned()) },
        None => Wanted { name: text.trim().to_owned(), unit: None },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(arguments: &[&str]) -> Result<Option<Order>, String> {
        order(arguments.iter().map(OsString::from)).map_err(|failure| failure.to_string())
    }

    #[test]
    fn columns_come_with_units_or_without() {
        let arguments =
            ["log.csv", "-o", "a.svg", "--rate", "200", "--columns", "wx:deg_s, f_z_g", "--csv", "p.csv"];
        let order = parsed(&arguments).unwrap().unwrap();
        let columns = [("wx", Some("deg_s")), ("f_z_g", None)]
            .map(|(name, unit)| Wanted { name: name.into(), unit: unit.map(str::to_owned) });
        assert_eq!((order.columns.as_slice(), order.rate_hz), (&columns[..], Some(200.0)));
        assert_eq!((order.log, order.points), ("log.csv".into(), Some("p.csv".into())));
    }

    #[test]
    fn what_is_wrong_is_named() {
        assert_eq!(parsed(&["--help"]), Ok(None));
        for (arguments, named) in [
            (&["-o", "a.svg"][..], "LOG.csv"),
            (&["log.csv"], "-o"),
            (&["log.csv", "-o", "a.png"], "a.png"),
            (&["log.csv", "-o", "a.svg", "--rate", "-1"], "--rate -1"),
            (&["log.csv", "-o", "a.svg", "second.csv"], "second.csv"),
        ] {
            assert!(parsed(arguments).unwrap_err().contains(named), "{arguments:?}");
        }
    }
}
