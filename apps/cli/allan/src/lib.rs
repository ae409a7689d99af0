//! Allan variance of a recorded rate, and the noise coefficients that explain it.
//!
//! A record is the output of one axis of a sensor: its increments, angles \[rad\] or velocities \[m/s\], over equal intervals.
//! [`Estimator`] computes from it the overlapping Allan variances σ²(τ), in the unit of the rate squared, \[(rad/s)²\] or
//! \[(m/s²)²\]. It then fits the coefficients of the five [`Term`]s of IEEE Std 952-1997, annex C, to them. Variances and
//! coefficients have confidence intervals, for Gaussian noise.
//!
//! The data flow is `pieces`, `deviation` → `terms`, `lags`, `covariance` → `fit` → `explained` → `interval`, `filter`; `quantile` has the
//! quantiles of their intervals.
//!
//! Sources: IEEE Std 952-1997, annex C; Riley, *Handbook of Frequency Stability Analysis*, NIST SP 1065, 2008; Greenhall and
//! Riley, "Uncertainty of Stability Variances Based on Finite Differences", PTTI 2003.

#![deny(missing_docs)]
#![forbid(unsafe_code)]
#![cfg_attr(
    not(test),
    deny(clippy::disallowed_methods, clippy::unwrap_used, clippy::expect_used, clippy::panic)
)]

mod covariance;
mod deviation;
mod explained;
mod filter;
mod fit;
mod interval;
mod lags;
mod pieces;
mod quantile;
mod terms;

pub use deviation::FEWEST_SAMPLES;
pub use filter::Filter;
pub use fit::Fit;
pub use interval::{Interval, Point};
pub use terms::{Band, TERMS, Term, total};

use std::sync::OnceLock;

use covariance::Covariance;
use deviation::{allan_variance, factors, integral};
use pieces::Pieces;
use sins::{Error, Rule};

/// Allan variances from the lowest to the highest that the fit can take: their fourth powers stay within the range of numbers.
const VARIANCES: (f64, f64) = (1e-70, 1e70);

/// Shortest and longest interval of a record [s].
const LEAST_S: f64 = 1e-9;
const MOST_S: f64 = 1e9;

/// Estimator for records of one length, or in pieces of the same lengths.
///
/// It holds what does not depend on the numbers of a record: averaging times, and covariances of the variances.
#[derive(Debug, Clone)]
pub struct Estimator {
    pieces: Pieces,
    interval_s: f64,
    factors: Vec<usize>,
    taus_s: Vec<f64>,
    covariance: Covariance,
    /// The same with flicker noise of the limited band, once a record asks for it.
    limited: OnceLock<Covariance>,
}

/// Allan variances of one record, and the coefficients that explain them.
#[derive(Debug, Clone)]
pub struct Estimate {
    /// Allan variance at each averaging time, shortest first.
    pub points: Vec<Point>,
    /// Coefficients whose terms add up to the variances.
    pub fit: Fit,
    /// Whether they explain the variances from [`Fit::first`] on. If not, the record has more than the five noises, and the intervals
    /// of the coefficients do not hold.
    pub is_explained: bool,
    /// Another fit that explains as many variances, with flicker noise of another band. The intervals hold for both.
    pub other: Option<Fit>,
}

impl Estimator {
    /// For records of `count` samples, [`FEWEST_SAMPLES`] or more, over intervals of `interval_s` \[s\], 1e-9 to 1e9.
    pub fn new(count: usize, interval_s: f64) -> Result<Self, Error> {
        Self::of_pieces(&[count], interval_s)
    }

    /// For records with gaps: pieces of so many samples, the longest of [`FEWEST_SAMPLES`] or more, one behind the other. Each averaging
    /// time is that of all pieces that are long enough.
    pub fn of_pieces(lengths: &[usize], interval_s: f64) -> Result<Self, Error> {
        let pieces = Pieces::new(lengths);
        let longest = pieces.longest();
        if longest < FEWEST_SAMPLES {
            let rule = Rule::AtLeast("must be at least", FEWEST_SAMPLES.into());
            return Err(Error::invalid("count", longest, rule));
        }
        if !(LEAST_S..=MOST_S).contains(&interval_s) {
            let rule = if interval_s.is_finite() { Rule::Between(LEAST_S, MOST_S) } else { Rule::Finite };
            return Err(Error::invalid("interval_s", interval_s, rule));
        }
        let factors = factors(longest);
        let taus_s = factors.iter().map(|factor| *factor as f64 * interval_s).collect();
        let covariance = Covariance::new(&pieces, interval_s, &factors, Band::Unlimited);
        Ok(Self { pieces, interval_s, factors, taus_s, covariance, limited: OnceLock::new() })
    }

    /// Averaging times τ \[s\], shortest first: three in each octave, from one interval to a ninth of the record, or of its longest piece.
    pub fn taus_s(&self) -> &[f64] {
        &self.taus_s
    }

    /// σ²(τ) of the record at each averaging time.
    ///
    /// `increments` are angles \[rad\] or velocities \[m/s\] over the intervals, finite numbers, as many as the estimator is for.
    pub fn variances(&self, increments: &[f64]) -> Result<Vec<f64>, Error> {
        if increments.len() != self.pieces.count() {
            let rule = Rule::Exactly("must be", self.pieces.count().into());
            return Err(Error::invalid("number of increments", increments.len(), rule));
        }
        if let Some(index) = increments.iter().position(|increment| !increment.is_finite()) {
            return Err(Error::invalid("increments", increments[index], Rule::Finite).at(index));
        }
        let thetas: Vec<Vec<f64>> = self.pieces.of(increments).map(integral).collect();
        Ok(self.factors.iter().map(|factor| allan_variance(&thetas, self.interval_s, *factor)).collect())
    }

    /// Variances and coefficients of a record; `increments` as for [`Self::variances`].
    ///
    /// A record without noise is rejected: at most two of its increments differ from the others, or a variance is not from 1e-70 to 1e70.
    pub fn estimate(&self, increments: &[f64]) -> Result<Estimate, Error> {
        let variances = self.variances(increments)?;
        // Equal increments can have a variance above 0: subtracting their mean leaves rounding errors.
        // The first and the last value of a record may be others.
        let usual = increments[increments.len() / 2];
        if increments.iter().filter(|increment| **increment != usual).count() <= 2 {
            return Err(Error::invalid(
                "increments",
                usual,
                Rule::Sentence("expected noise, found this value throughout"),
            ));
        }
        if let Some(variance) =
            variances.iter().find(|variance| !(VARIANCES.0..=VARIANCES.1).contains(*variance))
        {
            let rule = Rule::Sentence("expected noise: a variance must be from 1e-70 to 1e70");
            return Err(Error::invalid("Allan variance", *variance, rule));
        }
        Ok(self.explained(&variances))
    }

    /// Squares of the coefficients of these terms alone, fitted to the variances that the fit of `estimate` uses, with its flicker noise.
    pub fn squares_of(&self, estimate: &Estimate, terms: &[bool; TERMS]) -> [f64; TERMS] {
        let variances: Vec<f64> = estimate.points.iter().map(|point| point.variance).collect();
        let covariance = self.covariance(estimate.fit.band);
        estimate.fit.squares_of(&self.taus_s, &variances, covariance, terms)
    }

    fn covariance(&self, band: Band) -> &Covariance {
        let limited = || Covariance::new(&self.pieces, self.interval_s, &self.factors, band);
        match band {
            Band::Unlimited => &self.covariance,
            Band::Limited => self.limited.get_or_init(limited),
        }
    }

    /// The variances with the degrees of freedom that they have by a fit.
    fn points(&self, variances: &[f64], fit: &Fit) -> Vec<Point> {
        let point = |(i, (&tau_s, &variance)): (usize, (&f64, &f64))| {
            let degrees = interval::degrees_of_freedom(fit, self.covariance(fit.band), i, tau_s);
            Point { tau_s, variance, degrees }
        };
        self.taus_s.iter().zip(variances).enumerate().map(point).collect()
    }

    /// Equivalent degrees of freedom 2 σ⁴ / var(σ²) at the averaging time `taus_s()[i]`, for Gaussian noise that is none of the
    /// five terms: σ² is its Allan `variance` at that time, and `covariance(t_s)` the generalised covariance of its integral at the
    /// distance `t_s` \[s\], a smooth function except at 0.
    pub fn degrees_of_freedom(&self, i: usize, variance: f64, covariance: impl Fn(f64) -> f64) -> f64 {
        2.0 * variance * variance
            / covariance::variance_of_noise(&self.pieces, self.factors[i], self.interval_s, covariance)
    }
}

impl Estimate {
    /// Interval that holds the square of the coefficient of `term` with the probability `confidence`, between 0 and 1, if the fit
    /// explains the variances. Of quantization, which shows in the shortest times only, if these are in the fit.
    pub fn interval(&self, term: Term, confidence: f64) -> Interval {
        let of = |fit: &Fit| interval::of_square(fit, term as usize, &self.points, confidence);
        let own = of(&self.fit);
        self.other.as_ref().map_or(own, |other| {
            let other = of(other);
            Interval { low: own.low.min(other.low), high: own.high.max(other.high) }
        })
    }
}
