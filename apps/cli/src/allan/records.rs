//! Deviations and coefficients as CSV, in SI.

use super::analysis::Analysis;
use super::sheet;
use crate::failure::Failure;
use crate::rows::text;

/// Columns of the deviations.
pub const POINTS: [&str; 7] =
    ["column", "averaging_time_s", "deviation", "low", "high", "degrees_of_freedom", "fit"];

/// Columns of the coefficients.
pub const COEFFICIENTS: [&str; 6] = ["column", "coefficient", "value", "low", "high", "unit"];

/// A row for each column and averaging time.
pub fn points(analyses: &[Analysis]) -> Result<String, Failure> {
    let rows = analyses.iter().flat_map(|analysis| {
        analysis.estimates.iter().map(|e| {
            let numbers = [e.tau_s, e.deviation, e.interval.low, e.interval.high, e.degrees, e.fitted];
            let mut row = vec![analysis.name.clone()];
            row.extend(numbers.map(|number| format!("{number:.9e}")));
            row
        })
    });
    text(&POINTS, rows)
}

/// A row for each column and term; a coefficient whose low end is 0 is not resolved. An end that the record does not show is empty.
pub fn coefficients(analyses: &[Analysis]) -> Result<String, Failure> {
    let rows = analyses.iter().flat_map(|analysis| {
        analysis.coefficients.iter().map(|c| {
            let mut row = vec![analysis.name.clone(), c.term.letter().to_owned()];
            let ends = c.interval.map_or([f64::NAN; 2], |interval| [interval.low, interval.high]);
            row.push(format!("{:.9e}", c.value));
            row.extend(ends.map(|end| if end.is_finite() { format!("{end:.9e}") } else { String::new() }));
            row.push(sheet::si_name(analysis.sensor, c.term).to_owned());
            row
        })
    });
    text(&COEFFICIENTS, rows)
}

#[cfg(test)]
mod tests {
    use super::super::analysis::tests::made;
    use super::*;

    #[test]
    fn every_row_has_its_columns() {
        let analyses = Analysis::of_log(&made(2000, 0.0)).unwrap();
        let points = points(&analyses).unwrap();
        assert_eq!(points.lines().count(), 1 + analyses[0].estimates.len());
        let second = points.lines().nth(1).unwrap();
        assert!(second.starts_with("w<x>_rad,1.000000000e-2,") && second.split(',').count() == 7, "{second}");
        let coefficients = coefficients(&analyses).unwrap();
        assert_eq!(coefficients.lines().count(), 1 + 5);
        assert!(coefficients.lines().nth(2).unwrap().ends_with(",rad/√s"), "{coefficients}");
    }
}
