//! Figures that are computed from statistics: means, covariances, radii.

use nalgebra::{SMatrix, SVector};

use super::{FRACTION_BITS, STATES, Statistics, resolution};
use crate::base::error::Error;

/// Figures of many runs at one instant. States: position east, north, up \[m\]; velocity \[m/s\]; misalignment \[rad\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Figures {
    /// Runs, those left out of the other figures too.
    pub runs: u64,
    /// Runs that have diverged.
    pub diverged: u64,
    /// Runs with an error outside its range.
    pub out_of_range: u64,
    /// Runs in the figures whose error model is outside its validity.
    pub outside_validity: u64,
    /// Mean of each state; 0 without a run.
    pub mean: SVector<f64, STATES>,
    /// Covariance of the states about their means, with the divisor n - 1; 0 for less than two runs.
    pub covariance: SMatrix<f64, STATES, STATES>,
    /// Root mean square of each state; 0 without a run.
    pub rms: SVector<f64, STATES>,
    /// Root mean square of the horizontal radial position error [m].
    pub radial_rms_m: f64,
    /// Horizontal radius within which half of the runs are [m], to [`super::RADIAL_ERROR`] of itself or 0.5 mm.
    pub cep50_m: f64,
    /// Horizontal radius within which 95 % of the runs are [m], likewise.
    pub r95_m: f64,
    /// Largest horizontal radial position error [m].
    pub largest_radial_m: f64,
}

impl Statistics {
    /// The figures of these statistics.
    ///
    /// [`crate::ErrorKind::InvalidArgument`]: they are damaged or of another release.
    pub fn figures(&self) -> Result<Figures, Error> {
        self.check()?;
        let n = self.good() as f64;
        let unit = FRACTION_BITS.map(resolution);
        let over = |sum: f64, count: f64| if count > 0.0 { sum / count } else { 0.0 };
        let mean = SVector::from_fn(|state, _| over(self.sum(state) as f64, n) * unit[state]);
        let covariance = SMatrix::from_fn(|row, column| {
            over(self.scatter(row, column), n - 1.0) * unit[row] * unit[column]
        });
        let mean_square =
            |state: usize| over(self.product(state, state) as f64, n) * unit[state] * unit[state];
        Ok(Figures {
            runs: self.runs,
            diverged: self.diverged,
            out_of_range: self.out_of_range,
            outside_validity: self.outside_validity,
            mean,
            covariance,
            rms: SVector::from_fn(|state, _| mean_square(state).sqrt()),
            radial_rms_m: (mean_square(0) + mean_square(1)).sqrt(),
            cep50_m: self.radius(50),
            r95_m: self.radius(95),
            largest_radial_m: self.largest_radial as f64 * unit[0],
        })
    }

    /// Σ (x - mean of x)(y - mean of y) of two states [resolutions squared]:
    /// ```text
    /// Σxy - Σx Σy/n = Σxy - n mx my - mx ry - my rx - rx ry/n,   Σx = n mx + rx,   Σy = n my + ry,   0 <= rx, ry < n
    /// ```
    /// with integers mx and my. All terms but the last make Σ(x - mx)(y - my), an integer of less than 127 bits; the steps to it may
    /// wrap. The last one is less than n. So nothing is lost where means are large and the scatter is small.
    pub(super) fn scatter(&self, x: usize, y: usize) -> f64 {
        let n = i128::from(self.good());
        if n == 0 {
            return 0.0;
        }
        let divided = |sum: i128| (sum.div_euclid(n), sum.rem_euclid(n));
        let ((mx, rx), (my, ry)) = (divided(self.sum(x)), divided(self.sum(y)));
        let about_integers = self
            .product(x, y)
            .wrapping_sub(n.wrapping_mul(mx).wrapping_mul(my))
            .wrapping_sub(mx.wrapping_mul(ry))
            .wrapping_sub(my.wrapping_mul(rx));
        let (whole, rest) = (rx * ry / n, rx * ry % n);
        about_integers.wrapping_sub(whole) as f64 - rest as f64 / n as f64
    }
}
