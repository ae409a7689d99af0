//! Limits beyond which a solution counts as diverged.

use nalgebra::Vector3;

use super::norm::MAX_NORM_ERROR;
use crate::base::error::{Error, ErrorKind, Rule};
use crate::earth::Earth;
use crate::earth::state::EarthFixedState;

/// Heights above the ellipsoid [m] and speed [m/s] beyond which a solution counts as diverged: far beyond what a sample may have,
/// and far below what the equations can represent.
pub(super) const HEIGHTS_M: (f64, f64) = (-500e3, 20_000e3);
pub(super) const MAX_SPEED_M_S: f64 = 100e3;

/// Distances from the centre of any ellipsoid that are within these heights at any latitude [m].
pub(super) const WELL_WITHIN_M: (f64, f64) = (6.0e6, 26.0e6);

/// Checks the height and the speed of `state` as [`Mechanization::check`] does.
pub(crate) fn check_state(earth: &Earth, state: &EarthFixedState) -> Result<(), Error> {
    check(quick_height(earth, &state.r_e), state.v_e.norm_squared(), 0.0)
}

/// (r² - a²) / 2a if it decides; else the height [m]. It is more than the height outside the ellipsoid, and differs from it by less
/// than 50 km inside.
#[inline]
pub(super) fn quick_height(earth: &Earth, r_e: &Vector3<f64>) -> f64 {
    let a = earth.equatorial_radius_m;
    let height = (r_e.norm_squared() - a * a) / (2.0 * a);
    let (low, high) = HEIGHTS_M;
    if height > low + 50e3 && height < high { height } else { earth.vertical(r_e).height_m }
}

/// Checks the height [m], the squared speed [m²/s²] and the squared norm of the attitude's quaternion, less 1. The comparisons fail for NaN
/// too.
pub(super) fn check(height: f64, speed2: f64, norm_error: f64) -> Result<(), Error> {
    let (low, high) = HEIGHTS_M;
    let is_near = height > low && height < high;
    let is_slow = speed2 < MAX_SPEED_M_S * MAX_SPEED_M_S;
    let (field, value, rule) = match (is_near, is_slow) {
        (true, true) if norm_error.abs() <= MAX_NORM_ERROR => return Ok(()),
        (true, true) => (
            "navigated attitude: squared norm of the quaternion",
            1.0 + norm_error,
            Rule::Sentence("must be 1"),
        ),
        (true, false) => ("navigated speed_m_s", speed2.sqrt(), Rule::Below(MAX_SPEED_M_S)),
        (false, _) => ("navigated height_m", height, Rule::Between(low, high)),
    };
    Err(Error::of(ErrorKind::Diverged, field, value, rule))
}
