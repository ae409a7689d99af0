//! What makes neighbouring values depend on each other: the filter behind which white noise has the variances at short times.

use core::f64::consts::{PI, SQRT_2};

use nalgebra::Complex;

use super::interval::Point;
use super::terms::Term;
use super::{Estimate, Estimator};
use sins::math::{exp, ln, sin_cos};

/// A filter between the noise of a sensor and its rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Filter {
    /// A low-pass of first order, with this bandwidth \[Hz\].
    FirstOrder(f64),
    /// A Butterworth low-pass of second order, with this bandwidth \[Hz\].
    SecondOrder(f64),
    /// Each row is the mean of the last values, this many.
    Mean(usize),
}

/// Largest factor between a variance and that behind the filter.
const CLOSE: f64 = 1.15;

/// Bandwidths that are tried: each 2 % below the one before, from half the rate of the rows down to a thousandth of it.
const STEP: f64 = 0.98;
const BANDWIDTHS: core::ops::Range<i32> = 0..310;

/// Most rows over which a filter is looked for.
const MOST_ROWS: usize = 1000;

impl Filter {
    /// Autocovariance of rows of white noise with the density 1 behind the filter, at distances of up to `most` rows; and the density of
    /// the rows at frequency 0, to which what the filter leaves beyond half their rate is folded down.
    fn covariances(self, most: usize, interval_s: f64) -> (Vec<f64>, f64) {
        // A low-pass has rate / 2 (Re + Im) of the powers of one number.
        let low_pass = |rate: f64, turn: f64| {
            let one = Complex::new(1.0, 0.0);
            let (sin, cos) = sin_cos(turn * interval_s);
            let row = Complex::new(cos, sin) * exp(-rate * interval_s);
            let of = |power: Complex<f64>| 0.5 * rate * (power.re + power.im);
            let powers = core::iter::successors(Some(one), |power| Some(power * row));
            let covariances: Vec<f64> = powers.map(of).take(most + 1).collect();
            let density = interval_s * (covariances[0] + 2.0 * of(row / (one - row)));
            (covariances, density)
        };
        match self {
            Self::FirstOrder(bandwidth_hz) => low_pass(2.0 * PI * bandwidth_hz, 0.0),
            Self::SecondOrder(bandwidth_hz) => {
                let rate = SQRT_2 * PI * bandwidth_hz;
                low_pass(rate, rate)
            }
            Self::Mean(rows) => {
                let length_s = rows as f64 * interval_s;
                let covariance = |k| (1.0 - k as f64 / rows as f64).max(0.0) / length_s;
                ((0..=most).map(covariance).collect(), 1.0)
            }
        }
    }

    /// σ²(τ) of means of so many rows each, in order, for white noise whose rows have the density 1 behind the filter.
    fn variances(self, factors: &[usize], interval_s: f64) -> Vec<f64> {
        let rows = 2 * factors.last().copied().unwrap_or(0);
        let (covariances, density) = self.covariances(rows, interval_s);
        // Var(Σ of n rows) = n c(0) + 2 Σ (n - k) c(k): it grows by c(0) + 2 Σ c(k) with each row.
        let mut of_sum = Vec::with_capacity(rows + 1);
        let (mut sum, mut growth) = (0.0, covariances[0]);
        for covariance in &covariances[1..] {
            of_sum.push(sum);
            sum += growth;
            growth += 2.0 * covariance;
        }
        of_sum.push(sum);
        let variance = |&factor: &usize| {
            let m = factor as f64;
            (4.0 * of_sum[factor] - of_sum[2 * factor]) / (2.0 * m * m * density)
        };
        factors.iter().map(variance).collect()
    }
}

impl Estimator {
    /// The filter that explains the variances at the times that the fit of `found` leaves out, as white noise behind it; `None` if none are
    /// left out, or if neither a low-pass of first or second order nor a mean of rows explains each of them within 15 %.
    pub fn filter(&self, found: &Estimate) -> Option<Filter> {
        let (fit, interval_s) = (&found.fit, self.interval_s);
        let factors = &self.factors[..fit.first];
        if !found.is_explained || factors.is_empty() || factors[factors.len() - 1] > MOST_ROWS {
            return None;
        }
        let mut others = fit.squares;
        let density = std::mem::take(&mut others[Term::RandomWalk as usize]);
        others[Term::Quantization as usize] = 0.0;
        // What white noise has of the variances, over its density.
        let share = |point: &Point| (point.variance - fit.band.total(&others, point.tau_s)) / density;
        let shares: Vec<f64> = found.points[..fit.first].iter().map(share).collect();
        let miss = |(share, variance): (&f64, f64)| {
            let ratio = share / variance;
            if ratio > 0.0 { ln(ratio).abs() } else { f64::INFINITY }
        };
        let worst = |filter: Filter| {
            shares.iter().zip(filter.variances(factors, interval_s)).map(miss).fold(0.0, f64::max)
        };
        let bandwidths = BANDWIDTHS.map(|k| 0.5 / interval_s * exp(f64::from(k) * ln(STEP)));
        let passes = bandwidths.flat_map(|hz| [Filter::FirstOrder(hz), Filter::SecondOrder(hz)]);
        let means = (2..=factors[factors.len() - 1]).map(Filter::Mean);
        let best =
            passes.chain(means).map(|filter| (worst(filter), filter)).min_by(|a, b| a.0.total_cmp(&b.0))?;
        (best.0 < ln(CLOSE)).then_some(best.1)
    }
}

#[cfg(test)]
mod tests {
    use super::super::terms::Band;
    use super::*;

    /// Far below its bandwidth a filter does nothing; each row of means of n has 1 / n² of the variance.
    #[test]
    fn variances_are_those_of_white_noise_at_long_times() {
        for filter in [Filter::FirstOrder(20.0), Filter::SecondOrder(20.0), Filter::Mean(4)] {
            let (factor, interval_s) = (4000, 0.01);
            let white = Band::Unlimited.shape(Term::RandomWalk, factor as f64 * interval_s);
            let ratio = filter.variances(&[factor], interval_s)[0] / white;
            assert!((ratio - 1.0).abs() < 3e-3, "{filter:?}: {ratio}");
        }
        assert!((Filter::Mean(4).variances(&[1], 0.01)[0] / (100.0 / 16.0) - 1.0).abs() < 1e-12);
    }
}
