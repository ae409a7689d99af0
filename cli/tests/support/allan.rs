//! The estimator of the program, applied to records of one length.
#![allow(dead_code)] // each test uses a part of it, the program the rest

#[path = "../../src/allan/estimate/mod.rs"]
pub mod estimate;

use estimate::covariance::Covariance;
use estimate::deviation::{allan_variance, factors, integral};
use estimate::fit::Fit;
use estimate::interval::{self, Interval, Point, degrees_of_freedom};

/// Averaging times, and what is known of them before a record is seen.
pub struct Records {
    pub count: usize,
    pub dt: f64,
    pub factors: Vec<usize>,
    pub taus_s: Vec<f64>,
    covariance: Covariance,
}

/// What a record says.
pub struct Found {
    pub fit: Fit,
    pub points: Vec<Point>,
}

impl Records {
    pub fn new(count: usize, dt: f64) -> Self {
        let factors = factors(count);
        let taus_s = factors.iter().map(|factor| *factor as f64 * dt).collect();
        let covariance = Covariance::new(count, dt, &factors);
        Self { count, dt, factors, taus_s, covariance }
    }

    pub fn variances(&self, increments: &[f64]) -> Vec<f64> {
        let theta = integral(increments);
        self.factors.iter().map(|factor| allan_variance(&theta, self.dt, *factor)).collect()
    }

    pub fn analyse(&self, increments: &[f64]) -> Found {
        let variances = self.variances(increments);
        let fit = Fit::new(&self.taus_s, &variances, &self.covariance);
        let point = |(i, (&tau_s, &variance)): (usize, (&f64, &f64))| {
            let degrees = degrees_of_freedom(&fit, &self.covariance, i, tau_s);
            Point { tau_s, variance, degrees }
        };
        let points = self.taus_s.iter().zip(&variances).enumerate().map(point).collect();
        Found { fit, points }
    }
}

impl Found {
    /// Of the square of a coefficient.
    pub fn interval(&self, term: usize, confidence: f64) -> Interval {
        interval::of_square(&self.fit, term, &self.points, confidence)
    }
}
