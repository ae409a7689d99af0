//! Error data 2: navigation minus truth.

use super::NavigationErrors;
use crate::base::math::{rotation_vector, wrap_angle};
use crate::earth::Earth;
use crate::earth::state::Navigation;

/// Errors of `navigation` against `truth`. Position is differenced in Earth-fixed axes and attitude as a rotation vector, so that
/// no wrap of longitude or heading, no gimbal lock and no pole disturbs these errors.
#[inline(always)]
pub fn navigation_minus_truth(
    earth: &Earth,
    navigation: &Navigation,
    truth: &Navigation,
) -> NavigationErrors {
    // Terms that can call a function come first, so that the calls need not save other values.
    let longitude_rad = wrap_angle(navigation.place.longitude_rad - truth.place.longitude_rad);
    let roll_rad = wrap_angle(navigation.euler.roll - truth.euler.roll);
    let heading_rad = wrap_angle(navigation.euler.heading - truth.euler.heading);
    let misalignment_n = -rotation_vector(&(navigation.q_nb * truth.q_nb.conjugate()));
    let (displacement, [east, north, _]) = earth.displacement(&navigation.place, &truth.place);
    NavigationErrors {
        position_n: nalgebra::Vector3::new(
            displacement.dot(&east),
            displacement.dot(&north),
            navigation.place.height_m - truth.place.height_m,
        ),
        latitude_rad: navigation.place.latitude_rad - truth.place.latitude_rad,
        longitude_rad,
        velocity_n: navigation.v_n - truth.v_n,
        misalignment_n,
        roll_rad,
        pitch_rad: navigation.euler.pitch - truth.euler.pitch,
        heading_rad,
        outside_validity: false,
    }
}
