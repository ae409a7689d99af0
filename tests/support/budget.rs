//! Budgets, and the errors of an INS at rest in closed form to compare them with.

use nalgebra::{ComplexField, Vector3};
use sins::Options;
use sins::analysis::budget::{
    Budget, BudgetRequest, BudgetRow, ComputedSamples, ErrorParameters, error_budget,
};
use sins::analysis::recommend::SolutionError;
use sins::earth::Earth;
use sins::truth::FlightSample;

use super::closed_form::AtRest;
use super::{DEG, resting_sample};

pub const HOUR_S: u64 = 3600;
/// Latitude of `resting_sample` [rad].
pub const LATITUDE: f64 = 39.9 * DEG;

pub fn at_rest(seconds: u64, rate_hz: f64) -> Vec<FlightSample> {
    (0..=(seconds as f64 * rate_hz) as u64).map(|k| resting_sample(k as f64 / rate_hz)).collect()
}

pub fn budget_of(
    options: &Options,
    samples: &[FlightSample],
    parameters: &ErrorParameters,
    request: &BudgetRequest,
) -> Budget {
    let sample = |k: usize| Ok(samples[k]);
    error_budget(options, &ComputedSamples { count: samples.len(), sample: &sample }, parameters, request)
        .unwrap()
}

pub fn row<'a>(budget: &'a Budget, field: &str) -> &'a BudgetRow {
    budget.rows.iter().find(|row| row.effect.field == field).unwrap()
}

/// Sensor errors on the sphere of the mean radius of curvature, with the gravity at that place.
pub fn sphere(eps: Vector3<f64>, nabla: Vector3<f64>) -> AtRest {
    let earth = Earth::default();
    let radii = earth.radii(LATITUDE.sin());
    let g = earth.gravity(&earth.to_earth_fixed(&resting_sample(0.0).place)).norm();
    let r = (radii.meridian_m * radii.transverse_m).sqrt();
    AtRest { latitude_rad: LATITUDE, r, g, eps, nabla }
}

/// Lengths of the closed form's errors after `t` [s].
pub fn sizes(alone: &AtRest, t: f64) -> SolutionError {
    let closed = alone.after(t);
    SolutionError {
        position_m: closed.position.modulus(),
        velocity_m_s: closed.velocity.modulus(),
        attitude_rad: closed.phi.norm(),
    }
}

/// Largest lengths of the closed form's errors within an hour.
pub fn worst(alone: &AtRest) -> SolutionError {
    let sizes = (0..=HOUR_S).map(|t| sizes(alone, t as f64));
    sizes.fold(SolutionError::default(), |worst, error| SolutionError {
        position_m: worst.position_m.max(error.position_m),
        velocity_m_s: worst.velocity_m_s.max(error.velocity_m_s),
        attitude_rad: worst.attitude_rad.max(error.attitude_rad),
    })
}

/// Asserts equality to 0.5 %: the ellipsoid's radii differ from the sphere's by 0.2 % in both directions, the Schuler
/// frequencies differ by 0.1 %, and an hour is 4.5 rad of the Schuler oscillation.
pub fn assert_like(found: &SolutionError, expected: &SolutionError) {
    for (found, expected) in [
        (found.position_m, expected.position_m),
        (found.velocity_m_s, expected.velocity_m_s),
        (found.attitude_rad, expected.attitude_rad),
    ] {
        assert!((found / expected - 1.0).abs() < 5e-3, "{found:e} is not {expected:e}");
    }
}
