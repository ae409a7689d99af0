//! A place and an attitude in the vehicle.

use nalgebra::{Quaternion, Vector3};

use crate::base::math::{Euler, attitude_from_euler, rotate, rotate_inverse};
use crate::earth::state::{BodyAxes, EarthFixedState};

/// Where a block sits in the vehicle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// l, from the reference point to the block, body axes [m].
    pub arm_b: Vector3<f64>,
    /// Rotates block axes to body axes.
    pub q_bs: Quaternion<f64>,
}

impl Placement {
    /// A block at `arm_b` [m], with its axes at the attitude `boresight` relative to the vehicle's.
    pub fn new(arm_b: Vector3<f64>, boresight: &Euler, axes: BodyAxes) -> Self {
        Self { arm_b, q_bs: axes.in_vehicle(&attitude_from_euler(boresight)) }
    }

    /// State of the block while the reference point has `point` and turns at `omega_ib_b` [rad/s]:
    /// r_s = r + C l, v_s = v + C (ω×l), C_es = C C_bs, with ω relative to the Earth, which turns at `earth_rate` [rad/s].
    pub fn block(
        &self,
        point: &EarthFixedState,
        omega_ib_b: &Vector3<f64>,
        earth_rate: f64,
    ) -> EarthFixedState {
        let (arm_e, arm_rate_e) = self.arm_and_rate(&point.q_eb, omega_ib_b, earth_rate);
        EarthFixedState { r_e: point.r_e + arm_e, v_e: point.v_e + arm_rate_e, q_eb: point.q_eb * self.q_bs }
    }

    /// The inverse: state of the reference point from the state of the block, which turns at `omega_is_s` [rad/s].
    pub fn reference_point(
        &self,
        block: &EarthFixedState,
        omega_is_s: &Vector3<f64>,
        earth_rate: f64,
    ) -> EarthFixedState {
        let q_eb = block.q_eb * self.q_bs.conjugate();
        let (arm_e, arm_rate_e) = self.arm_and_rate(&q_eb, &rotate(&self.q_bs, omega_is_s), earth_rate);
        EarthFixedState { r_e: block.r_e - arm_e, v_e: block.v_e - arm_rate_e, q_eb }
    }

    /// C l [m] and C (ω_eb×l) [m/s], Earth-fixed axes.
    fn arm_and_rate(
        &self,
        q_eb: &Quaternion<f64>,
        omega_ib_b: &Vector3<f64>,
        earth_rate: f64,
    ) -> (Vector3<f64>, Vector3<f64>) {
        let omega_eb_b = omega_ib_b - rotate_inverse(q_eb, &Vector3::new(0.0, 0.0, earth_rate));
        (rotate(q_eb, &self.arm_b), rotate(q_eb, &omega_eb_b.cross(&self.arm_b)))
    }
}
