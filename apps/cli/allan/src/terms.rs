//! The five terms of the Allan variance of gyros and accelerometers: the share of each in σ²(τ), and its covariance in time.

use core::f64::consts::{LN_2, PI};

use sins::math::{exp, ln};
use sins::sensors::FLICKER_PROCESSES;

/// Term of the Allan variance: the square of its coefficient times [`Term::shape`] is its share of σ²(τ) (IEEE Std 952-1997,
/// annex C). With u as the unit of the rate, \[rad/s\] or \[m/s²\]:
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Term {
    /// Quantization Q \[u s\]: σ² = 3 Q² / τ².
    Quantization,
    /// Angle or velocity random walk N \[u √s\]: σ² = N² / τ.
    RandomWalk,
    /// Bias instability B \[u\]: σ² = (2 ln 2 / π) B², σ = 0.664 B.
    Flicker,
    /// Rate random walk K \[u/√s\]: σ² = K² τ / 3.
    RateRandomWalk,
    /// Ramp R \[u/s\], a straight line, not a noise: σ² = R² τ² / 2.
    Ramp,
}

/// Number of terms.
pub const TERMS: usize = 5;

/// Number of terms that are noises: all except the ramp, which is the last.
pub(super) const NOISES: usize = 4;

impl Term {
    /// All terms, by rising slope of log σ over log τ: -1, -1/2, 0, 1/2, 1. Arrays of coefficients have this order.
    pub const ALL: [Self; TERMS] =
        [Self::Quantization, Self::RandomWalk, Self::Flicker, Self::RateRandomWalk, Self::Ramp];

    /// Letter of the coefficient: Q, N, B, K or R.
    pub fn letter(self) -> &'static str {
        match self {
            Self::Quantization => "Q",
            Self::RandomWalk => "N",
            Self::Flicker => "B",
            Self::RateRandomWalk => "K",
            Self::Ramp => "R",
        }
    }

    /// σ²(τ) for a coefficient of 1, at the averaging time `tau_s` [s].
    pub fn shape(self, tau_s: f64) -> f64 {
        match self {
            Self::Quantization => 3.0 / (tau_s * tau_s),
            Self::RandomWalk => 1.0 / tau_s,
            Self::Flicker => 2.0 * LN_2 / PI,
            Self::RateRandomWalk => tau_s / 3.0,
            Self::Ramp => tau_s * tau_s / 2.0,
        }
    }

    /// Generalised covariance of the integrated noise at the distance `t_s` [s] for a coefficient of 1 (Greenhall and Riley,
    /// PTTI 2003). It is valid in fourth differences, such as products of two second differences. The error of quantization is
    /// white: it has a covariance at distance 0 only. A ramp has none.
    pub fn covariance(self, t_s: f64) -> f64 {
        let t = t_s.abs();
        match self {
            Self::Quantization => f64::from(t == 0.0),
            Self::RandomWalk => -0.5 * t,
            Self::Flicker if t == 0.0 => 0.0,
            Self::Flicker => t * t * ln(t) / (2.0 * PI),
            Self::RateRandomWalk => t * t * t / 12.0,
            Self::Ramp => 0.0,
        }
    }
}

/// Where the spectrum of flicker noise ends, at high frequencies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Band {
    /// Nowhere.
    Unlimited,
    /// As the sensors of this library make it ([`Term::Flicker`] from 2 s on): white below 1 s.
    Limited,
}

impl Band {
    /// [`Term::shape`] with flicker noise of this band.
    pub fn shape(self, term: Term, tau_s: f64) -> f64 {
        let markov = |(time_s, deviation): (f64, f64)| {
            let x = tau_s / time_s;
            let unit = if x < 1e-3 {
                x * (2.0 / 3.0 - x * (0.5 - x * 7.0 / 30.0))
            } else {
                2.0 / x * (1.0 - (3.0 - 4.0 * exp(-x) + exp(-2.0 * x)) / (2.0 * x))
            };
            deviation * deviation * unit
        };
        match (self, term) {
            (Self::Limited, Term::Flicker) => FLICKER_PROCESSES.into_iter().map(markov).sum(),
            _ => term.shape(tau_s),
        }
    }

    /// [`Term::covariance`] with flicker noise of this band.
    pub fn covariance(self, term: Term, t_s: f64) -> f64 {
        let markov = |(time_s, deviation): (f64, f64)| {
            let u = t_s.abs() / time_s;
            let unit = if u < 1e-3 { u * u * (0.5 - u * (1.0 / 6.0 - u / 24.0)) } else { u - 1.0 + exp(-u) };
            -(deviation * deviation) * (time_s * time_s) * unit
        };
        match (self, term) {
            (Self::Limited, Term::Flicker) => FLICKER_PROCESSES.into_iter().map(markov).sum(),
            _ => term.covariance(t_s),
        }
    }

    /// [`total`] with flicker noise of this band.
    pub fn total(self, squares: &[f64; TERMS], tau_s: f64) -> f64 {
        Term::ALL.iter().zip(squares).map(|(term, square)| square * self.shape(*term, tau_s)).sum()
    }
}

/// σ²(τ) at the averaging time `tau_s` [s], of coefficients with these `squares` in the order of [`Term::ALL`].
pub fn total(squares: &[f64; TERMS], tau_s: f64) -> f64 {
    Term::ALL.iter().zip(squares).map(|(term, square)| square * term.shape(tau_s)).sum()
}
