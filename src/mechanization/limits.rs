//! Limits beyond which a solution counts as diverged.

use nalgebra::Vector3;

use crate::earth::Earth;
use crate::error::{Error, ErrorKind, Rule};
use crate::state::EarthFixedState;

/// Heights above the ellipsoid [m] and speed [m/s] beyond which a solution counts as diverged: far beyond what a sample may have,
/// and far below what the equations can represent.
pub(super) const HEIGHTS_M: (f64, f64) = (-500e3, 20_000e3);
pub(super) const MAX_SPEED_M_S: f64 = 100e3;

/// Distances from the centre of any ellipsoid that are within these heights at any latitude [m].
pub(super) const WELL_WITHIN_M: (f64, f64) = (6.0e6, 26.0e6);

/// Checks the height and the speed of `state` as [`Mechanization::check`] does.
pub(crate) fn check_state(earth: &Earth, state: &EarthFixedState) -> Result<(), Error> {
    let (height, speed2) = (quick_height(earth, &state.r_e), state.v_e.norm_squared());
    if is_good(height, speed2) { Ok(()) } else { diverged(height, speed2, 0.0) }
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

#[inline]
pub(super) fn is_good(height: f64, speed2: f64) -> bool {
    let (low, high) = HEIGHTS_M;
    height > low && height < high && speed2 < MAX_SPEED_M_S * MAX_SPEED_M_S
}

#[cold]
pub(super) fn diverged(height: f64, speed2: f64, norm_error: f64) -> Result<(), Error> {
    let (low, high) = HEIGHTS_M;
    let (field, value, rule) = if !(height > low && height < high) {
        ("navigated height_m", height, Rule::Between(low, high))
    } else if speed2 < MAX_SPEED_M_S * MAX_SPEED_M_S {
        ("navigated attitude: squared norm of the quaternion", 1.0 + norm_error, Rule::Sentence("must be 1"))
    } else {
        ("navigated speed_m_s", speed2.sqrt(), Rule::Below(MAX_SPEED_M_S))
    };
    Err(Error::of(ErrorKind::Diverged, field, value, rule))
}
