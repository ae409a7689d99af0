//! Additional acceleration of a point away from the reference point of a rigid body.

use nalgebra::Vector3;

/// Integral over `dt` [s] of the acceleration ω'×r + ω×(ω×r) at the place `arm` = r [m], as a velocity [m/s] in body axes, while ω
/// changes by `change` = d about its mean `mean` = m [rad/s]:
/// ```text
/// ∫ω'×r dt     = d×r
/// ∫ω×(ω×r) dt  = (m×(m×r) + d×(d×r)/12) dt
/// ```
/// This is exact for a rate that changes linearly; the next term is (ω'' dt²)²/720 of the arm.
#[inline]
pub(crate) fn lever_arm_velocity(
    change: &Vector3<f64>,
    mean: &Vector3<f64>,
    dt: f64,
    arm: &Vector3<f64>,
) -> Vector3<f64> {
    change.cross(arm) + (centripetal(mean, arm) + centripetal(change, arm) * (1.0 / 12.0)) * dt
}

/// ω×(ω×r)
#[inline]
pub(crate) fn centripetal(rate: &Vector3<f64>, arm: &Vector3<f64>) -> Vector3<f64> {
    rate.cross(&rate.cross(arm))
}
