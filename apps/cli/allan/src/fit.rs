//! The coefficients whose terms add up to the measured Allan variances.

use nalgebra::{SMatrix, SVector};

use super::covariance::{Covariance, Form};
use super::terms::{Band, TERMS, Term};
use sins::math::hypot;

type Vector = SVector<f64, TERMS>;

/// Rounds of weighting by the variances that the last fit implies. After two rounds the weights keep three digits.
const ROUNDS: usize = 4;

/// Smallest relative error that the weights assume of a variance: the five terms describe real sensors no better.
const LEAST_ERROR: f64 = 0.01;

/// Coefficients fitted to the Allan variances of one record. Arrays have the order of [`Term::ALL`].
#[derive(Debug, Clone)]
pub struct Fit {
    /// The band of its flicker noise.
    pub band: Band,
    /// The first averaging time that the fit uses, in [`Estimator::taus_s`](super::Estimator::taus_s). 0: all.
    pub first: usize,
    /// Squares of the coefficients: weighted least squares under the constraint that none is negative. If shorter times are left out,
    /// that of quantization may be: it is then the share of a filter, or of averages, which white noise has at times beyond its memory,
    /// -c / τ².
    pub squares: [f64; TERMS],
    /// Squares of the coefficients without that constraint: linear in the variances and without bias, but sometimes negative.
    pub free: [f64; TERMS],
    /// Variance of each of `free`, as a form in the squares of the coefficients.
    pub(super) spread: [Form; TERMS],
}

impl Fit {
    /// Fits `variances` at `taus_s`, from the time `first` on, with the weights 1 / var(σ²), where var(σ²) follows from the fit itself and
    /// the `covariance` of the record. Variances at the shortest times are known to a thousandth, but no model is as exact. So no variance
    /// counts as known better than to [`LEAST_ERROR`]: otherwise the shortest times would determine the coefficients of the longest.
    pub(super) fn new(
        taus_s: &[f64],
        variances: &[f64],
        covariance: &Covariance,
        band: Band,
        first: usize,
    ) -> Self {
        let (squares, deviations) = weighted(taus_s, variances, covariance, band, first, ALL);
        let (taus_s, variances) = (&taus_s[first..], &variances[first..]);
        let gains = Equations::new(taus_s, variances, &deviations, band).gains();
        let free = gains.iter().zip(variances).map(|(gain, variance)| gain * *variance).sum::<Vector>();
        Self { band, first, squares, free: free.into(), spread: spread(&gains, covariance, first) }
    }

    /// Squares of the coefficients of these terms alone, fitted to the same variances. Beyond a filter its share is fitted too.
    pub(super) fn squares_of(
        &self,
        taus_s: &[f64],
        variances: &[f64],
        covariance: &Covariance,
        terms: &[bool; TERMS],
    ) -> [f64; TERMS] {
        let bit = |(term, is_one): (usize, &bool)| usize::from(*is_one) << term;
        let set = terms.iter().enumerate().map(bit).sum::<usize>() | usize::from(self.first > 0);
        weighted(taus_s, variances, covariance, self.band, self.first, set).0
    }

    /// σ²(τ) of the fit at the averaging time `tau_s` [s].
    pub fn variance(&self, tau_s: f64) -> f64 {
        self.band.total(&self.squares, tau_s)
    }

    /// Squares of the coefficients of the noises: none is negative.
    pub(super) fn noises(&self) -> [f64; TERMS] {
        noises(&self.squares)
    }

    /// Variance of each of `free`, for the noises of the fit.
    pub(super) fn variances_of_free(&self) -> [f64; TERMS] {
        let squares = Vector::from(self.noises());
        core::array::from_fn(|term| squares.dot(&(self.spread[term] * squares)))
    }
}

/// The set of all terms, a bit each.
const ALL: usize = (1 << TERMS) - 1;

/// Squares of the coefficients of the terms in `set`, as of [`Fit::new`], and the deviations of the variances that weighted them.
fn weighted(
    taus_s: &[f64],
    variances: &[f64],
    covariance: &Covariance,
    band: Band,
    first: usize,
    set: usize,
) -> ([f64; TERMS], Vec<f64>) {
    let (taus_s, variances) = (&taus_s[first..], &variances[first..]);
    // To begin with, the relative errors of independent pieces of the record.
    let longest = taus_s.last().copied().unwrap_or(1.0);
    let mut deviations: Vec<f64> =
        taus_s.iter().zip(variances).map(|(tau, v)| v * (tau / longest).sqrt().max(LEAST_ERROR)).collect();
    let mut squares = Equations::new(taus_s, variances, &deviations, band).constrained(first > 0, set);
    for _ in 0..ROUNDS {
        for (i, deviation) in deviations.iter_mut().enumerate() {
            let variance = covariance.variance(first + i, &noises(&squares));
            *deviation = hypot(variance.sqrt(), LEAST_ERROR * variances[i]);
        }
        squares = Equations::new(taus_s, variances, &deviations, band).constrained(first > 0, set);
    }
    (squares, deviations)
}

fn noises(squares: &[f64; TERMS]) -> [f64; TERMS] {
    squares.map(|square| square.max(0.0))
}

/// Variance of each coefficient: Σ g g' cov(σ², σ²') over all pairs of averaging times from `first` on, where g are its gains.
fn spread(gains: &[Vector], covariance: &Covariance, first: usize) -> [Form; TERMS] {
    let mut spread = [Form::zeros(); TERMS];
    for i in 0..gains.len() {
        for j in 0..gains.len() {
            for (p, form) in spread.iter_mut().enumerate() {
                *form += covariance.form(first + i, first + j) * (gains[i][p] * gains[j][p]);
            }
        }
    }
    spread
}

/// Normal equations of the variances over their standard deviations, the columns scaled to unit length.
struct Equations {
    rows: Vec<Vector>,
    scale: Vector,
    normal: SMatrix<f64, TERMS, TERMS>,
    right: Vector,
    /// Standard deviations of the variances.
    deviations: Vec<f64>,
}

impl Equations {
    fn new(taus_s: &[f64], variances: &[f64], deviations: &[f64], band: Band) -> Self {
        let row = |(tau_s, deviation): (&f64, &f64)| {
            Vector::from(Term::ALL.map(|t| band.shape(t, *tau_s) / deviation))
        };
        let mut rows: Vec<Vector> = taus_s.iter().zip(deviations).map(row).collect();
        let scale = rows.iter().map(|row| row.component_mul(row)).sum::<Vector>().map(f64::sqrt);
        rows.iter_mut().for_each(|row| row.component_div_assign(&scale));
        let normal = rows.iter().map(|row| row * row.transpose()).sum();
        let right =
            rows.iter().zip(variances.iter().zip(deviations)).map(|(row, (v, d))| row * (v / d)).sum();
        Self { rows, scale, normal, right, deviations: deviations.to_vec() }
    }

    /// The solution with the least squares among the solutions with terms of the set `most` (of all: 31) that have no negative coefficient,
    /// except that of quantization if `is_filtered`.
    fn constrained(&self, is_filtered: bool, most: usize) -> [f64; TERMS] {
        let sets = (1..=ALL).filter(|set| set & !most == 0);
        let candidates = sets.filter_map(|set| self.solved(set));
        // The sum of squared residuals is the sum without any term, less the inner product with the right side.
        let best = candidates
            .filter(|x| x.iter().skip(usize::from(is_filtered)).all(|square| *square >= 0.0))
            .max_by(|a, b| a.dot(&self.right).total_cmp(&b.dot(&self.right)));
        best.unwrap_or_else(Vector::zeros).component_div(&self.scale).into()
    }

    /// The solution with the terms whose bits are in `set`, the others zero.
    fn solved(&self, set: usize) -> Option<Vector> {
        let mut normal = self.normal;
        let mut right = self.right;
        for p in (0..TERMS).filter(|p| set >> p & 1 == 0) {
            normal.row_mut(p).fill(0.0);
            normal.column_mut(p).fill(0.0);
            normal[(p, p)] = 1.0;
            right[p] = 0.0;
        }
        Some(normal.cholesky()?.solve(&right))
    }

    /// Derivative of each coefficient of the solution with all terms by each variance.
    fn gains(&self) -> Vec<Vector> {
        let Some(factors) = self.normal.cholesky() else {
            return vec![Vector::zeros(); self.rows.len()];
        };
        let gain =
            |(row, deviation): (&Vector, &f64)| factors.solve(row).component_div(&self.scale) / *deviation;
        self.rows.iter().zip(&self.deviations).map(gain).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::deviation::factors;
    use super::super::pieces::Pieces;
    use super::super::terms::total;
    use super::*;

    fn fitted(squares: [f64; TERMS]) -> Fit {
        let (count, interval_s) = (100_000, 0.01);
        let factors = factors(count);
        let taus_s: Vec<f64> = factors.iter().map(|factor| *factor as f64 * interval_s).collect();
        let variances: Vec<f64> = taus_s.iter().map(|tau_s| total(&squares, *tau_s)).collect();
        let covariance = Covariance::new(&Pieces::new(&[count]), interval_s, &factors, Band::Unlimited);
        Fit::new(&taus_s, &variances, &covariance, Band::Unlimited, 0)
    }

    #[test]
    fn exact_variances_give_their_coefficients_back() {
        let squares = [1e-14, 2e-12, 3e-14, 1e-15, 4e-18];
        let fit = fitted(squares);
        for found in [fit.free, fit.squares] {
            let are_right =
                found.iter().zip(&squares).all(|(found, square)| (found / square - 1.0).abs() < 1e-6);
            assert!(are_right, "{found:?}");
        }
    }

    #[test]
    fn no_coefficient_is_negative() {
        // The variances are below white noise at long averaging times: the free fit has a negative term, the constrained one none.
        let fit = fitted([0.0, 1e-10, -1e-13, 0.0, 0.0]);
        assert!(fit.free[2] < -0.99e-13, "{:?}", fit.free);
        assert!(fit.squares.iter().all(|square| *square >= 0.0), "{:?}", fit.squares);
        assert!((fit.squares[1] / 1e-10 - 1.0).abs() < 0.01);
    }
}
