//! Results of one column: deviations, coefficients, and whether the coefficients explain the deviations.

use sins::allan::{Estimator, Fit, Interval, Point, TERMS, Term};
use sins::math::chi_square_quantile;

use super::log::{Log, Series};
use super::quantity::Sensor;
use crate::drawing::series::mean;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::say;
use crate::units::significant;

/// Confidence of all intervals.
pub const CONFIDENCE: f64 = 0.95;

/// The fit does not explain a deviation if both conditions hold: chance alone makes such a difference once in ten thousand cases,
/// and the ratio of deviation and fit is large enough to be seen in the curve.
const CERTAIN: f64 = 0.9999;
const VISIBLE: f64 = 1.05;

/// A deviation [rad/s] or [m/s²].
#[derive(Debug, Clone, Copy)]
pub struct Estimate {
    pub tau_s: f64,
    pub deviation: f64,
    pub interval: Interval,
    /// Equivalent degrees of freedom.
    pub degrees: f64,
    /// Deviation of the fit.
    pub fitted: f64,
}

/// A coefficient in SI.
#[derive(Debug, Clone, Copy)]
pub struct Coefficient {
    pub term: Term,
    pub value: f64,
    pub interval: Interval,
}

impl Coefficient {
    /// Whether the record shows that the coefficient is not zero.
    pub fn is_resolved(&self) -> bool {
        self.interval.low > 0.0 && !self.is_at_bound()
    }

    /// Whether the estimate is the upper end of its own interval and the lower end is far below. Such an estimate results from the
    /// constraint of the fit and is not a finding. An estimate at the upper end of a short interval is a finding.
    pub fn is_at_bound(&self) -> bool {
        let Interval { low, high } = self.interval;
        self.value > 0.0 && self.value >= high && low < 0.5 * self.value
    }
}

/// Results of one column.
pub struct Analysis {
    pub name: String,
    pub sensor: Sensor,
    pub estimates: Vec<Estimate>,
    pub coefficients: [Coefficient; TERMS],
    pub fit: Fit,
}

impl Analysis {
    /// Results of all columns of a log.
    pub fn of_log(log: &Log) -> Result<Vec<Self>, Failure> {
        log.series.iter().try_for_each(|series| at_rest(series, log.interval_s))?;
        let progress = Progress::counting("analysing", 1 + log.series.len());
        let estimator = Estimator::new(log.count(), log.interval_s)?;
        progress.count();
        let analysis = |series| {
            let analysis = Self::of_series(series, &estimator);
            progress.count();
            analysis
        };
        let (good, bad): (Vec<_>, Vec<_>) = log.series.iter().map(analysis).partition(Result::is_ok);
        let refused = bad.into_iter().filter_map(Result::err);
        if good.is_empty() {
            return Err(Failure::all(refused.collect()));
        }
        // A sensor without noise does not hide the others.
        refused.for_each(|failure| say(&format!("left out: {failure}")));
        good.into_iter().collect()
    }

    fn of_series(series: &Series, estimator: &Estimator) -> Result<Self, Failure> {
        let found = estimator
            .estimate(&series.increments)
            .map_err(|error| Failure::new(format!("column \"{}\": {error}", series.name)))?;
        let coefficients = Term::ALL.map(|term| Coefficient {
            term,
            value: found.fit.squares[term as usize].sqrt(),
            interval: root(found.interval(term, CONFIDENCE)),
        });
        let estimates = found.points.iter().map(|point| estimate(point, &found.fit)).collect();
        let (name, sensor) = (series.name.clone(), series.sensor);
        Ok(Self { name, sensor, estimates, coefficients, fit: found.fit })
    }

    /// Among the deviations that the fit does not explain, the one with the largest ratio to the fit. If there is one, the record
    /// contains more than the five terms.
    pub fn unexplained(&self) -> Option<&Estimate> {
        let ratio = |estimate: &&Estimate| (estimate.deviation / estimate.fitted).ln().abs();
        let missed = self.estimates.iter().filter(|estimate| {
            let sum = estimate.degrees * (estimate.deviation / estimate.fitted).powi(2);
            let end = |probability: f64| chi_square_quantile(probability, estimate.degrees);
            let usual = Interval { low: end(0.5 - 0.5 * CERTAIN), high: end(0.5 + 0.5 * CERTAIN) };
            !usual.contains(sum) && ratio(estimate) > VISIBLE.ln()
        });
        missed.max_by(|a, b| ratio(a).total_cmp(&ratio(b)))
    }
}

/// Rejects a column whose means over a second change as those of no sensor at rest do.
fn at_rest(series: &Series, interval_s: f64) -> Result<(), Failure> {
    let block = ((1.0 / interval_s).round() as usize).max(1);
    let means = series.increments.chunks_exact(block).map(|values| mean(values) / interval_s);
    let (low, high) =
        means.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), mean| (mean.min(low), mean.max(high)));
    let (limit, si, unit) = match series.sensor {
        Sensor::Gyro => (1.0, 1f64.to_radians(), "deg/s"),
        Sensor::Accelerometer => (0.5, 1.0, "m/s2"),
    };
    let change = (high - low) / si;
    if change <= limit {
        return Ok(());
    }
    Err(Failure::new(format!(
        "column \"{}\": the means over a second change by {} {unit}, so the record is in motion; noise coefficients need a \
         record of a sensor at rest (limit {limit} {unit})",
        series.name,
        significant(change)
    )))
}

fn estimate(point: &Point, fit: &Fit) -> Estimate {
    Estimate {
        tau_s: point.tau_s,
        deviation: point.variance.sqrt(),
        interval: root(point.interval(CONFIDENCE)),
        degrees: point.degrees,
        fitted: fit.variance(point.tau_s).sqrt(),
    }
}

fn root(interval: Interval) -> Interval {
    Interval { low: interval.low.sqrt(), high: interval.high.sqrt() }
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// A log of noise and a sinusoid. The noise is good enough for drawings: sums of uniform numbers of a linear congruential
    /// generator.
    pub fn made(count: usize, sinusoid: f64) -> Log {
        let mut state = 1_u64;
        let mut uniform = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let increments = (0..count)
            .map(|k| 1e-6 * ((0..12).map(|_| uniform()).sum::<f64>() + sinusoid * (k as f64 / 30.0).sin()))
            .collect();
        let series = vec![Series { name: "w<x>_rad".into(), sensor: Sensor::Gyro, increments }];
        Log { name: "made.csv".into(), interval_s: 0.01, series }
    }

    #[test]
    fn white_noise_is_recovered_and_nothing_else() {
        let analysis = &Analysis::of_log(&made(20_000, 0.0)).unwrap()[0];
        let [q, n, b, k, r] = analysis.coefficients;
        // Twelve uniform numbers have a variance of 1: N is 1e-6 / √0.01.
        assert!(n.is_resolved() && n.interval.contains(1e-5), "{n:?}");
        assert!(n.interval.contains(n.value) && n.interval.high < 1.1 * n.interval.low, "{n:?}");
        for absent in [q, b, k, r] {
            assert!(!absent.is_resolved() && absent.interval.high > 0.0, "{absent:?}");
        }
        assert!(analysis.unexplained().is_none());
    }

    #[test]
    fn a_sinusoid_is_not_explained() {
        let log = made(20_000, 2.0);
        assert!(Analysis::of_log(&log).unwrap()[0].unexplained().is_some());
    }

    #[test]
    fn a_dead_column_is_reported() {
        let mut log = made(1000, 0.0);
        log.series[0].increments.fill(9.81e-2);
        assert!(Analysis::of_log(&log).err().unwrap().to_string().contains("w<x>_rad"));
    }
}
