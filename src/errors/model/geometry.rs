//! Local axes and curvature at a point of the true path.

use nalgebra::Vector3;

use crate::base::math::Pair;
use crate::earth::{Earth, Vertical};

/// Lower limit of the cosine of latitude: tan L stays finite at a pole, where it has no meaning.
const MIN_COS: f64 = 1e-9;

/// East, north, up and the radii at a position.
#[derive(Debug, Clone, Copy)]
pub(super) struct LocalGeometry {
    pub east: Vector3<f64>,
    pub north: Vector3<f64>,
    pub up: Vector3<f64>,
    pub sin: f64,
    pub cos: f64,
    /// M = RM + h, N = RN + h [m]
    pub m: f64,
    pub n: f64,
}

/// East at a pole. A call, so that the usual case does not select between two vectors component by component.
#[cold]
#[inline(never)]
fn east_at_pole() -> Vector3<f64> {
    Vector3::y()
}

impl LocalGeometry {
    pub fn new(earth: &Earth, vertical: &Vertical) -> Self {
        let up = vertical.up_e;
        let cos = (up.x * up.x + up.y * up.y).sqrt();
        let east = if cos > 0.0 {
            let east = Pair::new(-up.y, up.x) / Pair::both(cos);
            Vector3::new(east.first(), east.second(), 0.0)
        } else {
            east_at_pole()
        };
        let radii = earth.radii(up.z);
        Self {
            east,
            north: up.cross(&east),
            up,
            sin: up.z,
            cos: cos.max(MIN_COS),
            m: radii.meridian_m + vertical.height_m,
            n: radii.transverse_m + vertical.height_m,
        }
    }

    /// Local components of a vector in Earth-fixed axes.
    pub fn in_local_axes(&self, v: &Vector3<f64>) -> Vector3<f64> {
        Vector3::new(self.east.dot(v), self.north.dot(v), self.up.dot(v))
    }

    /// Local components of two vectors in Earth-fixed axes.
    #[inline(always)]
    pub fn two_in_local_axes(&self, one: &Vector3<f64>, other: &Vector3<f64>) -> [Vector3<f64>; 2] {
        let two = |i: usize| Pair::new(one[i], other[i]);
        let (x, y, z) = (two(0), two(1), two(2));
        let along = |axis: &Vector3<f64>| x * axis.x + y * axis.y + z * axis.z;
        let (x, y, z) = (along(&self.east), along(&self.north), along(&self.up));
        [Vector3::new(x.first(), y.first(), z.first()), Vector3::new(x.second(), y.second(), z.second())]
    }

    /// Earth-fixed components of a vector in local axes.
    pub fn in_earth_axes(&self, v: &Vector3<f64>) -> Vector3<f64> {
        self.east * v.x + self.north * v.y + self.up * v.z
    }

    /// Changes of latitude [rad], longitude [rad] and height [m] for a displacement [m].
    pub fn change_of_place(&self, position_n: &Vector3<f64>) -> Vector3<f64> {
        let limit = core::f64::consts::PI;
        let longitude = (position_n.x / (self.n * self.cos)).clamp(-limit, limit);
        Vector3::new(position_n.y / self.m, longitude, position_n.z)
    }

    /// Rotation of the local axes for a displacement: dth = (-dL, dλ cos L, dλ sin L) [rad].
    pub fn rotation_of_axes(&self, position_n: &Vector3<f64>) -> Vector3<f64> {
        let east = position_n.x / self.n;
        Vector3::new(-position_n.y / self.m, east, east * self.sin / self.cos)
    }
}
