//! Confidence intervals of Allan variances and of the coefficients.

use nalgebra::SVector;

use super::chi_square::{bisected, chi_square_quantile, normal_quantile};
use super::fit::Fit;
use super::terms::TERMS;

/// From low to high.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    pub low: f64,
    pub high: f64,
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

/// What the square of coefficient `term` may be: all values with which what was found is neither among the highest nor
/// among the lowest (1 - confidence) / 2.
///
/// The fit without constraint is linear in the variances, so that its variance follows from theirs and from their
/// covariances, v(x) = v₀ + v₁ x + v₂ x² where x² is what the noise of this term itself leaves. That part is like χ² with
/// ν = 2 / v₂ degrees of freedom and brings a third cumulant of 8 x³ / ν²; the rest is taken as normal. The distribution
/// with these three moments is Pearson's third, a shifted χ². A negative square is taken for zero, which makes its
/// interval longer.
pub fn of_square(fit: &Fit, term: usize, confidence: f64) -> Interval {
    let found = fit.free[term].max(0.0);
    let (low, high) = (0.5 - 0.5 * confidence, 0.5 + 0.5 * confidence);
    let quantile = |square: f64, probability: f64| {
        let mut squares = SVector::<f64, TERMS>::from(fit.squares);
        squares[term] = square;
        let form = &fit.spread[term];
        let variance = squares.dot(&(form * squares));
        let own = form[(term, term)];
        let cumulant = 2.0 * own * own * square.powi(3);
        square + variance.sqrt() * pearson(cumulant / variance.powf(1.5), probability)
    };
    let is_resolved = quantile(0.0, high) < found;
    let lower = if is_resolved { bisected(0.0, found, |x| quantile(x, high) < found) } else { 0.0 };
    let mut above = found.max(quantile(0.0, high)).max(f64::MIN_POSITIVE);
    let mut doublings = 0;
    while quantile(above, low) < found && doublings < 200 {
        above *= 2.0;
        doublings += 1;
    }
    let upper = bisected(found, above, |x| quantile(x, low) < found);
    // The constrained fit is what is told: the interval has it.
    Interval { low: lower.min(fit.squares[term]), high: upper.max(fit.squares[term]) }
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
