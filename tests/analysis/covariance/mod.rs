//! The covariance of the navigation errors: at rest against a matrix exponential of the textbook's equations, against single runs
//! with one random draw, and over starts, reads and slews.

mod at_rest;
mod ellipse;
mod first_seconds;
mod single_runs;
mod starts_and_reads;

use crate::support::G;

const MICRO_G: f64 = 1e-6 * G;

/// Relative error that the propagation may have: one stretch of it is a second, in which the Earth turns by 7.3e-5 rad.
const MODEL: f64 = 7.3e-5;
