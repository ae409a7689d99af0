//! Limits of the samples: which intervals there can be, and what a vehicle can do in one.

use super::sample::FlightSample;
use crate::base::snapshot::{ANY, stored};

/// Shortest interval between samples, and longest that a host may allow [s].
pub(crate) const MIN_INTERVAL_S: f64 = 5e-5;
pub(crate) const MAX_GAP_S: f64 = 1e3;

/// Largest rounding error of the difference of two time stamps, as a share of a stamp: four units in the last place.
pub(super) const STAMP_ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Shortest and longest interval, with the rounding of time stamps [s].
pub(crate) const INTERVALS_S: (f64, f64) = {
    let rounding = STAMP_ROUNDING * FlightSample::LATEST_S;
    (MIN_INTERVAL_S - rounding, MAX_GAP_S + rounding)
};

/// Largest deviation of a time stamp from the stated period, in periods.
pub(super) const OFF_PERIOD: f64 = 0.4;

/// Limits beyond which a sample is bad, and not a hard manoeuvre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntakeLimits {
    /// Longest interval between samples [s].
    pub max_gap_s: f64,
    /// Largest mean acceleration between two samples [m/s²].
    pub max_acceleration_m_s2: f64,
    /// Sample period [s] if the host states one: sample k is then at exactly k periods from the first.
    pub period_s: Option<f64>,
}

impl Default for IntakeLimits {
    fn default() -> Self {
        Self { max_gap_s: 2.5, max_acceleration_m_s2: 2000.0, period_s: None }
    }
}

stored!(IntakeLimits { max_gap_s: ANY, max_acceleration_m_s2: ANY, period_s: ANY });
