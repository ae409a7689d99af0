//! Confidence intervals of Allan variances and of the coefficients. `tests/allan_estimator.rs` counts how often those of 95 %
//! hold the truth: 93 to 98.5 % for normal noises, more where a ramp is.

use nalgebra::SVector;

use super::chi_square::{bisected, chi_square_quantile, normal_quantile};
use super::covariance::Covariance;
use super::fit::Fit;
use super::terms::{TERMS, Term, total};

/// From low to high.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    pub low: f64,
    pub high: f64,
}

/// An Allan variance and how many degrees of freedom it has.
#[derive(Debug, Clone, Copy)]
pub struct Point {
    pub tau_s: f64,
    pub variance: f64,
    pub degrees: f64,
}

impl Interval {
    pub fn contains(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }
}

/// What a true variance may be where `variance` was measured with so many `degrees` of freedom: ν σ² / χ².
pub fn of_variance(variance: f64, degrees: f64, confidence: f64) -> Interval {
    let end = |probability: f64| variance * degrees / chi_square_quantile(probability, degrees);
    Interval { low: end(0.5 + 0.5 * confidence), high: end(0.5 - 0.5 * confidence) }
}

/// Equivalent degrees of freedom 2 σ⁴ / var(σ²) of the Allan variance at averaging time `i`, for the noises of the fit. A
/// ramp counts as random walk: at the end of a curve the two look alike, and a ramp, that leaves nothing to chance, would
/// make a random walk's interval far too short.
pub fn degrees_of_freedom(fit: &Fit, covariance: &Covariance, i: usize, tau_s: f64) -> f64 {
    const WALK: usize = 3;
    const RAMP: usize = 4;
    let mut squares = fit.squares;
    squares[WALK] += squares[RAMP] * Term::Ramp.shape(tau_s) / Term::RateRandomWalk.shape(tau_s);
    squares[RAMP] = 0.0;
    2.0 * total(&squares, tau_s).powi(2) / covariance.variance(i, &squares)
}

/// What the square of coefficient `term` may be: all values with which what was found is neither among the highest nor
/// among the lowest share of the chances.
///
/// The fit without constraint is linear in the variances, so that its variance follows from theirs and from their
/// covariances, v(x) = v₀ + v₁ x + v₂ x² where x² is what the noise of this term itself leaves. That part is like χ² with
/// ν = 2 / v₂ degrees of freedom and brings a third cumulant of 8 x³ / ν²; the rest is taken as normal. The distribution
/// with these three moments is Pearson's third, a shifted χ². A negative square is taken for zero, which makes its
/// interval longer.
fn of_free_square(fit: &Fit, term: usize, (low, high): (f64, f64)) -> Interval {
    let found = fit.free[term].max(0.0);
    let quantile = |square: f64, probability: f64| {
        let mut squares = SVector::<f64, TERMS>::from(fit.squares);
        squares[term] = square;
        let form = &fit.spread[term];
        let variance = squares.dot(&(form * squares));
        if variance <= 0.0 {
            return square;
        }
        let own = form[(term, term)];
        let cumulant = 2.0 * own * own * square.powi(3);
        square + variance.sqrt() * pearson(cumulant / variance.powf(1.5), probability)
    };
    let is_resolved = quantile(0.0, high) < found;
    let lower = if is_resolved { bisected(0.0, found, |x| quantile(x, high) < found) } else { 0.0 };
    let mut above = found.max(quantile(0.0, high)).max(f64::MIN_POSITIVE);
    // The own noise of a term with few degrees of freedom may leave no upper end: the bound below is its end then.
    while quantile(above, low) < found && above < f64::MAX / 4.0 {
        above *= 2.0;
    }
    Interval { low: lower, high: bisected(found, above, |x| quantile(x, low) < found) }
}

/// What the square of coefficient `term` may be: the interval of the fit, and no term is more than the whole, as at every
/// averaging time the others only add. The time that bounds the term closest is chosen by the fit, not by the measured
/// variances, whose lowest would be too low. Both upper ends have a quarter of the chances left out, so that together they
/// have at most half.
pub fn of_square(fit: &Fit, term: usize, points: &[Point], confidence: f64) -> Interval {
    let left_out = 1.0 - confidence;
    let bound = |point: &Point, variance: f64| {
        let lowest = chi_square_quantile(0.25 * left_out, point.degrees);
        variance * point.degrees / lowest / Term::ALL[term].shape(point.tau_s)
    };
    let expected = |point: &Point| bound(point, fit.variance(point.tau_s));
    let closest = points.iter().min_by(|a, b| expected(a).total_cmp(&expected(b)));
    let bound = closest.map_or(f64::INFINITY, |point| bound(point, point.variance));
    let free = of_free_square(fit, term, (0.25 * left_out, 1.0 - 0.5 * left_out));
    // The constrained fit is what is told: the interval has it.
    let told = fit.squares[term];
    Interval { low: free.low.min(told), high: free.high.min(bound).max(told) }
}

/// Quantile of Pearson's third distribution with mean 0, variance 1 and this skewness.
fn pearson(skewness: f64, probability: f64) -> f64 {
    // Below it differs from a normal one by less than 1e-4.
    if skewness < 1e-4 {
        return normal_quantile(probability);
    }
    let degrees = 8.0 / (skewness * skewness);
    (chi_square_quantile(probability, degrees) - degrees) / (2.0 * degrees).sqrt()
}
