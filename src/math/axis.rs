//! Products with vectors along the axis of the Earth.

use nalgebra::Vector3;

/// (0, 0, `w`) × `v`
#[inline]
pub fn axis_cross(w: f64, v: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(-w * v.y, w * v.x, 0.0)
}
