//! Results of one column: deviations, coefficients, and whether the coefficients explain the deviations.

use sins_allan::{Estimate, Estimator, Filter, Fit, Interval, Point, TERMS, Term};

use super::values;
use crate::drawing::series::mean;
use crate::failure::Failure;
use crate::imu::Sensor;
use crate::imu::{Log, Series};
use crate::progress::Progress;
use crate::terminal::say;
use crate::units::significant;

/// Confidence of all intervals.
pub const CONFIDENCE: f64 = 0.95;

/// Confidence at which a term is written into a scene: chance alone shows one of a few terms of a few axes much more often than one alone.
pub const CERTAINTY: f64 = 0.997;

/// A deviation [rad/s] or [m/s²].
#[derive(Debug, Clone, Copy)]
pub struct Deviation {
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
    /// Its interval; `None`: the fit does not explain the curve, so no interval would hold. Without an upper end: the record does not show
    /// the coefficient.
    pub interval: Option<Interval>,
    /// What a scene with the noise of the record has of it, in a fit of the terms that the record shows at [`CERTAINTY`]; `None`: it is not
    /// one of them.
    pub written: Option<f64>,
}

impl Coefficient {
    /// Whether the record shows that the coefficient is not zero.
    pub fn is_resolved(&self) -> bool {
        self.interval.is_some_and(|interval| interval.low > 0.0) && !self.is_at_bound()
    }

    /// Whether the estimate is the upper end of its own interval and the lower end is far below. Such an estimate results from the
    /// constraint of the fit and is not a finding. An estimate at the upper end of a short interval is a finding.
    pub fn is_at_bound(&self) -> bool {
        let Some(Interval { low, high }) = self.interval else { return false };
        self.value > 0.0 && self.value >= high && low < 0.5 * self.value
    }
}

/// Results of one column.
pub struct Analysis {
    pub name: String,
    pub sensor: Sensor,
    /// Place of the column among those of its sensor, and how many there are.
    pub axis: (usize, usize),
    pub estimates: Vec<Deviation>,
    pub coefficients: [Coefficient; TERMS],
    pub fit: Fit,
    /// The first averaging time of the fit [s], if shorter ones are left out.
    pub from_s: Option<f64>,
    /// Whether the fit explains the deviations from there on, and the values are those of a noise.
    pub is_explained: bool,
    /// What no noise of a sensor does.
    pub fault: Option<String>,
    /// Among the deviations that the fit does not explain, the place of that with the largest ratio to it.
    missed: Option<usize>,
    /// What is between the noise and the rows, if the times that are left out show it.
    pub filter: Option<Filter>,
    /// How often a value is that of the row before, as a part of all rows, beyond what coarse values are by chance.
    pub repeats: f64,
}

impl Analysis {
    /// Results of all columns of a log.
    pub fn of_log(log: &Log) -> Result<Vec<Self>, Failure> {
        if !log.is_still {
            log.series.iter().try_for_each(|series| at_rest(series, log.interval_s))?;
        }
        let progress = Progress::counting("analysing", 1 + log.series.len());
        let estimator = Estimator::of_pieces(&log.pieces, log.interval_s)?;
        progress.count();
        let analysis = |series: &Series| {
            let of_sensor = || log.series.iter().filter(|other| other.sensor == series.sensor);
            let axis = of_sensor().position(|other| std::ptr::eq(other, series)).unwrap_or(0);
            let analysis = Self::of_series(series, &log.pieces, (axis, of_sensor().count()), &estimator);
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

    fn of_series(
        series: &Series,
        pieces: &[usize],
        axis: (usize, usize),
        estimator: &Estimator,
    ) -> Result<Self, Failure> {
        let found = estimator
            .estimate(&series.increments)
            .map_err(|error| Failure::new(format!("column \"{}\": {error}", series.name)))?;
        let from = found.fit.first;
        let fault = values::fault(&series.increments, pieces, estimator.taus_s()[0]);
        let is_explained = found.is_explained && fault.is_none();
        let coefficients = Term::ALL.map(|term| {
            if term == Term::Quantization && from > 0 {
                let interval = Some(Interval { low: 0.0, high: f64::INFINITY });
                return Coefficient { term, value: 0.0, interval, written: None };
            }
            let interval = is_explained.then(|| root(found.interval(term, CONFIDENCE)));
            let value = found.fit.squares[term as usize].max(0.0).sqrt();
            Coefficient { term, value, interval, written: None }
        });
        let coefficients = with_written(coefficients, estimator, &found);
        Ok(Self {
            name: series.name.clone(),
            sensor: series.sensor,
            axis,
            estimates: found.points.iter().map(|point| estimate(point, &found.fit)).collect(),
            coefficients,
            from_s: (from > 0).then(|| found.points[from].tau_s),
            is_explained,
            fault,
            missed: found.unexplained(),
            filter: estimator.filter(&found),
            repeats: values::repeats(&series.increments),
            fit: found.fit,
        })
    }

    /// Among the deviations that the fit does not explain, the one with the largest ratio to it.
    pub fn unexplained(&self) -> Option<&Deviation> {
        self.missed.map(|place| &self.estimates[place])
    }
}

/// Terms that are alike at an end of the curve hide each other: if those that are certain do not explain the deviations alone, all that are
/// resolved are written.
fn with_written(
    mut coefficients: [Coefficient; TERMS],
    estimator: &Estimator,
    found: &Estimate,
) -> [Coefficient; TERMS] {
    let is_certain = |one: &Coefficient| found.interval(one.term, CERTAINTY).low > 0.0;
    let terms = coefficients.map(|one| one.is_resolved() && is_certain(&one));
    let squares = estimator.squares_of(found, &terms);
    let is_explained = found.is_explained_by(&squares);
    for (one, square) in coefficients.iter_mut().zip(squares) {
        one.written = match is_explained {
            true => Some(square).filter(|square| *square > 0.0 && terms[one.term as usize]).map(f64::sqrt),
            false => Some(one.value).filter(|_| one.is_resolved()),
        };
    }
    coefficients
}

/// The largest range of normal numbers over their standard deviation, of as many as a record of a year has seconds.
const RANGE: f64 = 12.0;

/// Rejects a column whose means over a second change as those of no sensor at rest do: by more than the limit, and more than noise of the
/// size of their changes from second to second.
fn at_rest(series: &Series, interval_s: f64) -> Result<(), Failure> {
    let block = ((1.0 / interval_s).round() as usize).max(1);
    let means: Vec<f64> =
        series.increments.chunks_exact(block).map(|values| mean(values) / interval_s).collect();
    let ends = |(low, high): (f64, f64), mean: &f64| (mean.min(low), mean.max(high));
    let (low, high) = means.iter().fold((f64::INFINITY, f64::NEG_INFINITY), ends);
    let steps: Vec<f64> = means.windows(2).map(|two| (two[1] - two[0]).powi(2) / 2.0).collect();
    let noise = if steps.is_empty() { 0.0 } else { mean(&steps).sqrt() };
    let (limit, si, unit) = match series.sensor {
        Sensor::Gyro => (1.0, 1f64.to_radians(), "deg/s"),
        Sensor::Accelerometer => (0.5, 1.0, "m/s2"),
    };
    let change = (high - low) / si;
    if change <= limit || high - low <= RANGE * noise {
        return Ok(());
    }
    Err(Failure::new(format!(
        "column \"{}\": the means over a second change by {} {unit}, so the record is in motion; noise coefficients need a \
         record of a sensor at rest (limit {limit} {unit}; --still: it is at rest)",
        series.name,
        significant(change)
    )))
}

fn estimate(point: &Point, fit: &Fit) -> Deviation {
    Deviation {
        tau_s: point.tau_s,
        deviation: point.variance.sqrt(),
        interval: root(point.interval(CONFIDENCE)),
        degrees: point.degrees,
        fitted: fit.variance(point.tau_s).max(0.0).sqrt(),
    }
}

fn root(interval: Interval) -> Interval {
    Interval { low: interval.low.sqrt(), high: interval.high.sqrt() }
}

#[cfg(test)]
pub mod tests {
    use super::*;
    use crate::draws::Draws;

    /// A log of noise and a sinusoid. The noise is nearly normal, which is good enough for drawings.
    pub fn made(count: usize, sinusoid: f64) -> Log {
        made_of(1, count, sinusoid)
    }

    pub fn made_of(seed: u64, count: usize, sinusoid: f64) -> Log {
        let mut draws = Draws::new(seed);
        logged(
            (0..count).map(|k| 1e-6 * (draws.nearly_normal() + sinusoid * (k as f64 / 30.0).sin())).collect(),
        )
    }

    /// A log of one column.
    pub fn logged(increments: Vec<f64>) -> Log {
        let count = increments.len();
        let series = vec![Series { name: "w<x>_rad".into(), sensor: Sensor::Gyro, increments }];
        let (pieces, remarks) = (vec![count], Vec::new());
        Log {
            name: "made.csv".into(),
            interval_s: 0.01,
            series,
            pieces,
            remarks,
            is_counted: false,
            is_still: false,
            times_s: Vec::new(),
            lengths_s: Vec::new(),
            taken: None,
        }
    }

    #[test]
    fn white_noise_is_recovered_and_nothing_else() {
        let mut within = 0;
        for seed in 1..=100 {
            let analysis = &Analysis::of_log(&made_of(seed, 20_000, 0.0)).unwrap()[0];
            let [q, n, b, k, r] = analysis.coefficients;
            // Twelve uniform numbers have a variance of 1: N is 1e-6 / √0.01.
            let interval = n.interval.unwrap();
            within += u32::from(interval.contains(1e-5));
            if seed == 1 {
                assert!(n.is_resolved(), "{n:?}");
                assert!(interval.contains(n.value) && interval.high < 1.1 * interval.low, "{n:?}");
                for absent in [q, b, k, r] {
                    assert!(!absent.is_resolved() && absent.interval.unwrap().high > 0.0, "{absent:?}");
                }
                assert!(analysis.unexplained().is_none());
            }
        }
        // Of 100 intervals of 95 % 95 contain the truth, with a deviation of 2.2.
        assert!(within >= 88, "{within} of 100");
    }

    #[test]
    fn a_sinusoid_is_not_explained() {
        let log = made(20_000, 2.0);
        let analysis = &Analysis::of_log(&log).unwrap()[0];
        assert!(!analysis.is_explained && analysis.unexplained().is_some());
        assert!(analysis.coefficients.iter().all(|coefficient| coefficient.interval.is_none()));
    }

    #[test]
    fn a_dead_column_is_reported() {
        let mut log = made(1000, 0.0);
        log.series[0].increments.fill(9.81e-2);
        assert!(Analysis::of_log(&log).err().unwrap().to_string().contains("w<x>_rad"));
    }
}
