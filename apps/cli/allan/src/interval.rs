//! Confidence intervals of Allan variances and of the coefficients. `tests/estimator/intervals.rs` counts how often intervals of 95 %
//! hold the truth: 93 to 98.5 % for normal noises, more often with a ramp.

use nalgebra::SVector;

use super::covariance::Covariance;
use super::fit::Fit;
use super::quantile::{chi_square_quantile, normal_quantile};
use super::terms::{TERMS, Term};

/// Values from `low` to `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

/// Allan variance at one averaging time.
#[derive(Debug, Clone, Copy)]
pub struct Point {
    /// Averaging time τ \[s\].
    pub tau_s: f64,
    /// Allan variance σ²(τ).
    pub variance: f64,
    /// Equivalent degrees of freedom of the variance.
    pub degrees: f64,
}

impl Point {
    /// Interval that holds the true variance with the probability `confidence`: ν σ² / χ², with ν degrees of freedom.
    pub fn interval(&self, confidence: f64) -> Interval {
        let end =
            |probability: f64| self.variance * self.degrees / chi_square_quantile(probability, self.degrees);
        Interval { low: end(0.5 + 0.5 * confidence), high: end(0.5 - 0.5 * confidence) }
    }
}

impl Interval {
    /// Whether `value` lies within the interval, ends included.
    pub fn contains(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }
}

/// Equivalent degrees of freedom 2 σ⁴ / var(σ²) of the Allan variance at averaging time `i`, for the noises of the fit. A
/// ramp counts as rate random walk. At the end of a curve the two look alike, and a ramp, which is not random, would make the
/// interval of a random walk far too short.
pub fn degrees_of_freedom(fit: &Fit, covariance: &Covariance, i: usize, tau_s: f64) -> f64 {
    const WALK: usize = 3;
    const RAMP: usize = 4;
    let mut squares = fit.noises();
    squares[WALK] += squares[RAMP] * Term::Ramp.shape(tau_s) / Term::RateRandomWalk.shape(tau_s);
    squares[RAMP] = 0.0;
    let variance = fit.band.total(&squares, tau_s);
    2.0 * (variance * variance) / covariance.variance(i, &squares)
}

/// Interval of the square x of coefficient `term`, by the fit without constraint: all x for which the square that was found is
/// neither below the quantile of the probability `low` nor above the quantile of the probability `high`.
///
/// The fit without constraint is linear in the variances. So its variance follows from their covariances: v(x) = v₀ + v₁ x +
/// v₂ x², where v₂ x² is due to the noise of this term itself. That part has nearly a χ² distribution with ν = 2 / v₂ degrees of
/// freedom, and a third cumulant of 8 x³ / ν². The rest is taken as normal. The distribution with these three moments is
/// Pearson's third, a shifted χ². A negative square counts as zero, which makes its interval longer.
fn of_free_square(fit: &Fit, term: usize, (low, high): (f64, f64)) -> Interval {
    let found = fit.free[term].max(0.0);
    let quantile = |square: f64, probability: f64| {
        let mut squares = SVector::<f64, TERMS>::from(fit.noises());
        squares[term] = square;
        let form = &fit.spread[term];
        let variance = squares.dot(&(form * squares));
        if variance <= 0.0 {
            return square;
        }
        let own = form[(term, term)];
        let cumulant = 2.0 * own * own * (square * square * square);
        square + variance.sqrt() * pearson(cumulant / (variance * variance.sqrt()), probability)
    };
    let is_resolved = quantile(0.0, high) < found;
    let lower = if is_resolved { bisected(0.0, found, |x| quantile(x, high) < found) } else { 0.0 };
    let mut above = found.max(quantile(0.0, high)).max(f64::MIN_POSITIVE);
    // There may be no upper end if the noise of the term itself has few degrees of freedom: `of_square` then bounds it.
    while quantile(above, low) < found && above < f64::MAX / 4.0 {
        above *= 2.0;
    }
    Interval { low: lower, high: bisected(found, above, |x| quantile(x, low) < found) }
}

/// Interval of the square of coefficient `term`. Its upper end is the lower of two: the upper end of the fit, and the largest
/// square with which this term alone makes no more than the whole variance (if the fit has all times), at the averaging time where that
/// bound is closest. The fit chooses this time, because the lowest of the measured variances would be too low. Each of the two ends is
/// exceeded with a quarter of the probability left out, so both together with at most half of it.
pub fn of_square(fit: &Fit, term: usize, points: &[Point], confidence: f64) -> Interval {
    let left_out = 1.0 - confidence;
    let bound = |point: &Point, variance: f64| {
        let lowest = chi_square_quantile(0.25 * left_out, point.degrees);
        variance * point.degrees / lowest / fit.band.shape(Term::ALL[term], point.tau_s)
    };
    let expected = |point: &Point| bound(point, fit.variance(point.tau_s));
    // A filter takes away from the variance, by an amount that is not known as well: then there is no such bound.
    let bounding = if fit.first == 0 { points } else { &[] };
    let closest = bounding.iter().min_by(|a, b| expected(a).total_cmp(&expected(b)));
    let bound = closest.map_or(f64::INFINITY, |point| bound(point, point.variance));
    let free = of_free_square(fit, term, (0.25 * left_out, 1.0 - 0.5 * left_out));
    // The constrained fit is the reported one: the interval contains it.
    let reported = fit.squares[term];
    Interval { low: free.low.min(reported), high: free.high.min(bound).max(reported) }
}

/// Place between `low` and `high` where `is_below` turns false.
fn bisected(mut low: f64, mut high: f64, is_below: impl Fn(f64) -> bool) -> f64 {
    while high - low > 1e-10 * low.abs().max(high.abs()) {
        let middle = 0.5 * (low + high);
        if is_below(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Quantile of Pearson's third distribution with mean 0, variance 1 and this skewness.
fn pearson(skewness: f64, probability: f64) -> f64 {
    // Below this skewness the distribution differs from a normal one by less than 1e-4.
    if skewness < 1e-4 {
        return normal_quantile(probability);
    }
    let degrees = 8.0 / (skewness * skewness);
    (chi_square_quantile(probability, degrees) - degrees) / (2.0 * degrees).sqrt()
}
