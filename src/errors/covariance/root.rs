//! The square root of the covariance.

use super::factor::ROWS;
use super::sources::{COUNT, WALKS};
use crate::base::error::Error;
use crate::base::memory::filled;
use crate::errors::column::Column;
use crate::mechanization::VerticalLoop;

/// Largest number of the root. It is far beyond any error that linear equations describe, and its square is finite.
pub(super) const LARGEST: f64 = 1e30;

/// The errors x = S β + L ξ: β are the present values of the processes of unit variance, ξ are independent normal numbers. This is
/// a square root of the covariance of x and β, so rounding cannot make the covariance negative.
#[derive(Debug, Clone)]
pub(super) struct Root {
    /// S, of each process.
    pub sensitivities: Box<[Column]>,
    /// L, lower triangular.
    pub factor: Box<[Column]>,
    /// Mean of the errors, as far as random drop-outs cause it.
    pub mean: Column,
    /// Whether the mean has been beyond the limits of the linear equations since the start.
    pub mean_was_beyond: bool,
    /// Variances of the random walks [u²].
    pub walks: [f64; WALKS],
    /// The vertical loop with the gains of the last stretch.
    pub channel: VerticalLoop,
}

impl Root {
    pub fn new() -> Result<Self, Error> {
        Ok(Self {
            sensitivities: filled(COUNT, Column::zeros())?,
            factor: filled(ROWS, Column::zeros())?,
            mean: Column::zeros(),
            mean_was_beyond: false,
            walks: [0.0; WALKS],
            channel: VerticalLoop::new(),
        })
    }

    pub fn copy_from(&mut self, other: &Self) {
        self.sensitivities.copy_from_slice(&other.sensitivities);
        self.factor.copy_from_slice(&other.factor);
        (self.mean, self.mean_was_beyond) = (other.mean, other.mean_was_beyond);
        (self.walks, self.channel) = (other.walks, other.channel);
    }

    /// A number beyond [`LARGEST`], or NaN, becomes [`LARGEST`].
    pub fn bound(&mut self) {
        let bound = |number: &mut f64| {
            // False for NaN too.
            let is_within = number.abs() <= LARGEST;
            if !is_within {
                *number = LARGEST.copysign(*number);
            }
        };
        self.walks.iter_mut().for_each(bound);
        self.columns_mut().flat_map(|column| column.iter_mut()).for_each(bound);
    }

    pub fn columns_mut(&mut self) -> impl Iterator<Item = &mut Column> {
        self.sensitivities.iter_mut().chain(&mut *self.factor).chain([&mut self.mean])
    }
}
