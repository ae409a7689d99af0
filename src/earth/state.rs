//! Position, velocity and attitude of a vehicle in two forms: Earth-fixed, with which the blocks compute, and geographic, which is
//! read.

use nalgebra::{Quaternion, Vector3};

use crate::base::math::{
    Euler, euler_from_attitude, rotate, rotate_inverse, sin_cos_each_inlined, wrap_angle,
};
use crate::base::snapshot::codes;
use crate::earth::{Earth, Geodetic, navigation_axes, navigation_axes_from_half_angles};

/// Distance from the Earth's axis [m] below which longitude, heading, east and north turn fast: at a pole they are undefined.
pub const NEAR_POLE_M: f64 = 20e3;

/// Directions of the sensor axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BodyAxes {
    /// Sensor axes: x right, y forward, z up (the paper's).
    #[default]
    RightForwardUp,
    /// Sensor axes: x forward, y right, z down.
    ForwardRightDown,
}

codes!(BodyAxes { RightForwardUp = 0 "rfu", ForwardRightDown = 1 "frd" });

impl BodyAxes {
    /// Attitude of the sensor axes for the attitude `q` of the axes right-forward-up. The function is its own inverse, because the
    /// two sets of axes differ by half a turn about the bisector of x and y. It needs only products with √½, so that it loses no
    /// component.
    pub fn exchange(self, q: &Quaternion<f64>) -> Quaternion<f64> {
        match self {
            Self::RightForwardUp => *q,
            Self::ForwardRightDown => {
                let s = core::f64::consts::FRAC_1_SQRT_2;
                Quaternion::new(-s * (q.i + q.j), s * (q.w - q.k), s * (q.w + q.k), s * (q.i - q.j))
            }
        }
    }

    /// Converts a rotation within the vehicle from axes right-forward-up to these axes.
    pub fn in_vehicle(self, q: &Quaternion<f64>) -> Quaternion<f64> {
        match self {
            Self::RightForwardUp => *q,
            Self::ForwardRightDown => Quaternion::new(q.w, q.j, q.i, -q.k),
        }
    }
}

/// Position, velocity and attitude of a body in Earth-fixed axes: regular everywhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EarthFixedState {
    /// Position [m].
    pub r_e: Vector3<f64>,
    /// Velocity relative to the Earth [m/s].
    pub v_e: Vector3<f64>,
    /// Attitude: rotates sensor axes to Earth-fixed axes.
    pub q_eb: Quaternion<f64>,
}

/// Position, velocity and attitude in geographic terms.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Navigation {
    /// Latitude, longitude (-π..π), height.
    pub place: Geodetic,
    /// Velocity relative to the Earth, east-north-up [m/s].
    pub v_n: Vector3<f64>,
    /// Attitude: rotates sensor axes to east-north-up.
    pub q_nb: Quaternion<f64>,
    /// Roll, pitch, heading (0..2π) of the vehicle.
    pub euler: Euler,
}

/// Errors of a state, computed less true, in the local axes of the truth, east-north-up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StateErrors {
    /// Position [m].
    pub position_n: Vector3<f64>,
    /// Velocity [m/s].
    pub velocity_n: Vector3<f64>,
    /// Misalignment φ [rad].
    pub misalignment_n: Vector3<f64>,
}

impl StateErrors {
    /// No errors: all zero.
    pub const NONE: Self = Self {
        position_n: Vector3::new(0.0, 0.0, 0.0),
        velocity_n: Vector3::new(0.0, 0.0, 0.0),
        misalignment_n: Vector3::new(0.0, 0.0, 0.0),
    };
}

impl EarthFixedState {
    /// The state in geographic terms.
    pub fn navigation(&self, earth: &Earth, axes: BodyAxes) -> Navigation {
        self.navigation_inlined(earth, axes)
    }

    /// `navigation` without a call.
    #[inline(always)]
    pub(crate) fn navigation_inlined(&self, earth: &Earth, axes: BodyAxes) -> Navigation {
        let place = earth.to_geodetic(&self.r_e);
        let (sines, cosines) = sin_cos_each_inlined(&[0.5 * place.latitude_rad, 0.5 * place.longitude_rad]);
        let q_en = navigation_axes_from_half_angles(&sines, &cosines);
        Navigation::new(place, rotate_inverse(&q_en, &self.v_e), q_en.conjugate() * self.q_eb, axes)
    }
}

impl Navigation {
    /// Computes the attitude angles, and wraps the longitude to -π..π.
    #[inline(always)]
    pub fn new(place: Geodetic, v_n: Vector3<f64>, q_nb: Quaternion<f64>, axes: BodyAxes) -> Self {
        let place = Geodetic { longitude_rad: wrap_angle(place.longitude_rad), ..place };
        // The angles are copied one by one: the compiler then keeps the other values in registers, not in memory.
        let Euler { roll, pitch, heading } = euler_from_attitude(&axes.exchange(&q_nb));
        Self { place, v_n, q_nb, euler: Euler { roll, pitch, heading } }
    }

    /// The state in Earth-fixed axes.
    pub fn earth_fixed(&self, earth: &Earth) -> EarthFixedState {
        let q_en = navigation_axes(self.place.latitude_rad, self.place.longitude_rad);
        EarthFixedState {
            r_e: earth.to_earth_fixed(&self.place),
            v_e: rotate(&q_en, &self.v_n),
            q_eb: q_en * self.q_nb,
        }
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::FRAC_PI_2;

    use super::*;
    use crate::base::math::attitude_from_euler;

    #[test]
    fn geographic_and_earth_fixed_views_are_inverse() {
        let earth = Earth::default();
        for latitude_rad in [3e-7 - FRAC_PI_2, -0.3, 0.0, 0.9, FRAC_PI_2 - 1e-13] {
            let place = Geodetic { latitude_rad, longitude_rad: -2.9, height_m: 1234.5 };
            let q_nb = attitude_from_euler(&Euler { roll: 0.2, pitch: 1.2, heading: 4.0 });
            let navigation =
                Navigation::new(place, Vector3::new(100.0, -200.0, 3.0), q_nb, BodyAxes::default());
            let back = navigation.earth_fixed(&earth).navigation(&earth, BodyAxes::default());
            // Near the axis, longitude and heading have a common error of 1 nm over the distance to the axis.
            let angle = 4e-16 + 2e-9 / earth.distance_from_axis(navigation.place);
            assert!((back.place.latitude_rad - latitude_rad).abs() < 4e-16);
            assert!((back.place.longitude_rad + 2.9).abs() < angle + 4e-16);
            assert!((back.v_n - navigation.v_n).norm() < 300.0 * (angle + 1e-15));
            assert!(
                (back.euler.pitch - 1.2).abs() < 1e-15 && (back.euler.heading - 4.0).abs() < angle + 4e-15
            );
        }
    }

    #[test]
    fn forward_right_down_exchanges_x_and_y_and_turns_z() {
        let q = attitude_from_euler(&Euler { roll: 0.2, pitch: 0.4, heading: 1.0 });
        let frd = BodyAxes::ForwardRightDown.exchange(&q);
        let near = |a: Vector3<f64>, b: Vector3<f64>| (a - b).norm() < 8.0 * f64::EPSILON;
        assert!(near(rotate(&frd, &Vector3::x()), rotate(&q, &Vector3::y())));
        assert!(near(rotate(&frd, &Vector3::y()), rotate(&q, &Vector3::x())));
        assert!(near(rotate(&frd, &Vector3::z()), -rotate(&q, &Vector3::z())));
        let back = BodyAxes::ForwardRightDown.exchange(&frd);
        assert!((back + q).norm() < 8.0 * f64::EPSILON, "half a turn twice is a full one");
    }
}
