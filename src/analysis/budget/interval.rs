//! The uncertainty of a 1σ from a number of runs.

use crate::base::math::wilson_hilferty;

/// The 97.5 % quantile of the normal distribution.
const Z: f64 = 1.959_963_984_540_054;

/// The 95 % interval of a 1σ, as factors of its estimate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SigmaInterval {
    /// √(N/χ²(97.5 %)).
    pub low: f64,
    /// √(N/χ²(2.5 %)).
    pub high: f64,
}

impl SigmaInterval {
    /// Of `runs` runs, 8 or more: as many degrees of freedom, as the mean is known to be 0.
    ///
    /// By the approximation of Wilson and Hilferty, whose factors are accurate to 0.7 % from 8 runs on.
    pub fn of(runs: u64) -> Self {
        let factor = |z: f64| 1.0 / wilson_hilferty(z, runs as f64).sqrt();
        Self { low: factor(Z), high: factor(-Z) }
    }
}
