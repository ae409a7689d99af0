//! The five noises of gyros and accelerometers: what each puts into σ²(τ), and its covariance in time.

use std::f64::consts::{LN_2, PI};

/// The square of a coefficient times [`Term::shape`] is its share of σ²(τ) (IEEE Std 952-1997, annex C).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Term {
    /// Q: σ² = 3 Q² / τ².
    Quantization,
    /// N, angle or velocity random walk: σ² = N² / τ.
    RandomWalk,
    /// B, bias instability: σ² = (2 ln 2 / π) B², σ = 0.664 B.
    Flicker,
    /// K, rate random walk: σ² = K² τ / 3.
    RateRandomWalk,
    /// R, a straight line, not a noise: σ² = R² τ² / 2.
    Ramp,
}

/// How many terms there are.
pub const TERMS: usize = 5;

/// The terms that are noises, all but the ramp.
pub const NOISES: usize = 4;

impl Term {
    /// By rising slope of σ over τ: -1, -1/2, 0, 1/2, 1. Arrays of coefficients have this order.
    pub const ALL: [Self; TERMS] =
        [Self::Quantization, Self::RandomWalk, Self::Flicker, Self::RateRandomWalk, Self::Ramp];

    /// The letter of its coefficient.
    pub fn letter(self) -> &'static str {
        match self {
            Self::Quantization => "Q",
            Self::RandomWalk => "N",
            Self::Flicker => "B",
            Self::RateRandomWalk => "K",
            Self::Ramp => "R",
        }
    }

    /// σ²(τ) for a coefficient of 1.
    pub fn shape(self, tau_s: f64) -> f64 {
        match self {
            Self::Quantization => 3.0 / (tau_s * tau_s),
            Self::RandomWalk => 1.0 / tau_s,
            Self::Flicker => 2.0 * LN_2 / PI,
            Self::RateRandomWalk => tau_s / 3.0,
            Self::Ramp => tau_s * tau_s / 2.0,
        }
    }

    /// Generalised covariance of the integrated noise at the distance `t_s` for a coefficient of 1 (Greenhall and Riley,
    /// PTTI 2003): right for fourth differences, as those of two second ones are. The error of quantization is white: it has
    /// a covariance at distance 0 only. A ramp has none.
    pub fn covariance(self, t_s: f64) -> f64 {
        let t = t_s.abs();
        match self {
            Self::Quantization => f64::from(t == 0.0),
            Self::RandomWalk => -0.5 * t,
            Self::Flicker if t == 0.0 => 0.0,
            Self::Flicker => t * t * t.ln() / (2.0 * PI),
            Self::RateRandomWalk => t * t * t / 12.0,
            Self::Ramp => 0.0,
        }
    }
}

/// σ²(τ) of the coefficients whose squares are given.
pub fn total(squares: &[f64; TERMS], tau_s: f64) -> f64 {
    Term::ALL.iter().zip(squares).map(|(term, square)| square * term.shape(tau_s)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half the variance of the second difference over τ², 3 s(0) - 4 s(τ) + s(2τ), is the shape.
    #[test]
    fn covariance_and_shape_are_of_the_same_noise() {
        for term in &Term::ALL[..NOISES] {
            for tau_s in [0.01, 1.0, 300.0] {
                let s = |k: f64| term.covariance(k * tau_s);
                let variance = (3.0 * s(0.0) - 4.0 * s(1.0) + s(2.0)) / (tau_s * tau_s);
                assert!((variance / term.shape(tau_s) - 1.0).abs() < 1e-12, "{term:?} {tau_s}");
            }
        }
    }

    #[test]
    fn each_term_has_its_slope() {
        for (term, slope) in Term::ALL.iter().zip([-2, -1, 0, 1, 2]) {
            assert!((term.shape(20.0) / term.shape(2.0) - 10f64.powi(slope)).abs() < 1e-12);
        }
        assert!((Term::Flicker.shape(1.0).sqrt() - 0.664).abs() < 5e-4);
        assert_eq!(total(&[1.0, 1.0, 0.0, 3.0, 2.0], 1.0), 3.0 + 1.0 + 1.0 + 1.0);
    }
}
