//! A place and an attitude in the vehicle.

use nalgebra::{Quaternion, Vector3};

use crate::math::{Euler, attitude_from_euler, rotate, rotate_inverse};
use crate::state::{BodyAxes, EarthFixedState};

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

#[cfg(test)]
mod tests {
    use super::*;

    const EARTH_RATE: f64 = 7.292_115e-5;

    /// A point, its angular rate and a block away from it.
    fn scene(axes: BodyAxes) -> (EarthFixedState, Vector3<f64>, Placement) {
        let point = EarthFixedState {
            r_e: Vector3::new(4e6, -3e6, 4e6),
            v_e: Vector3::new(100.0, 50.0, -200.0),
            q_eb: attitude_from_euler(&Euler { roll: 0.3, pitch: -0.7, heading: 4.0 }),
        };
        let boresight = Euler { roll: 1.0, pitch: 0.4, heading: 2.5 };
        let placement = Placement::new(Vector3::new(3.0, -7.0, 1.5), &boresight, axes);
        (point, Vector3::new(0.5, -1.2, 0.3), placement)
    }

    #[test]
    fn there_and_back_is_where_it_was() {
        for axes in [BodyAxes::RightForwardUp, BodyAxes::ForwardRightDown] {
            let (point, omega_ib_b, placement) = scene(axes);
            let block = placement.block(&point, &omega_ib_b, EARTH_RATE);
            let omega_is_s = rotate_inverse(&placement.q_bs, &omega_ib_b);
            let back = placement.reference_point(&block, &omega_is_s, EARTH_RATE);
            // Rounding: half a unit in the last place of 4e6 m there and one back; a few units of 200 m/s and of 1.
            assert!((back.r_e - point.r_e).amax() < 2.0 * 4e6 * f64::EPSILON);
            assert!((back.v_e - point.v_e).amax() < 8.0 * 200.0 * f64::EPSILON);
            assert!((back.q_eb - point.q_eb).norm() < 8.0 * f64::EPSILON);
        }
    }

    /// The velocity of the block is the derivative of its place in Earth-fixed axes, by central differences of h = 1e-3 s:
    /// |ω|³ l h²/6 = 3e-6 of truncation, 4e6 eps/h = 9e-7 m/s of rounding.
    #[test]
    fn the_blocks_velocity_is_the_derivative_of_its_place() {
        let (point, omega_ib_b, placement) = scene(BodyAxes::RightForwardUp);
        let omega_eb_b = omega_ib_b - rotate_inverse(&point.q_eb, &Vector3::new(0.0, 0.0, EARTH_RATE));
        let h = 1e-3;
        let at = |t: f64| {
            let q_eb = point.q_eb * crate::math::rotation_quaternion(&(omega_eb_b * t));
            placement.block(
                &EarthFixedState { r_e: point.r_e + point.v_e * t, v_e: point.v_e, q_eb },
                &omega_ib_b,
                EARTH_RATE,
            )
        };
        let difference = (at(h).r_e - at(-h).r_e) / (2.0 * h) - at(0.0).v_e;
        assert!(difference.norm() < 5e-6, "{difference:?}");
    }

    /// A block that is turned right by a quarter turn has its forward axis along the wing. It is the same block in both conventions
    /// of axes.
    #[test]
    fn boresight_angles_mean_the_same_block_in_any_axes() {
        let quarter = Euler { heading: core::f64::consts::FRAC_PI_2, ..Euler::default() };
        let near = |a: Vector3<f64>, b: Vector3<f64>| (a - b).norm() < 8.0 * f64::EPSILON;
        let rfu = Placement::new(Vector3::zeros(), &quarter, BodyAxes::RightForwardUp).q_bs;
        assert!(near(rotate(&rfu, &Vector3::y()), Vector3::x()));
        let frd = Placement::new(Vector3::zeros(), &quarter, BodyAxes::ForwardRightDown).q_bs;
        assert!(near(rotate(&frd, &Vector3::x()), Vector3::y()));
        let rolled = Euler { roll: 0.1, ..Euler::default() };
        let frd = Placement::new(Vector3::zeros(), &rolled, BodyAxes::ForwardRightDown).q_bs;
        assert!(
            near(rotate(&frd, &Vector3::y()), Vector3::new(0.0, 0.1f64.cos(), 0.1f64.sin())),
            "right wing down"
        );
        let level = Placement::new(Vector3::zeros(), &Euler::default(), BodyAxes::ForwardRightDown).q_bs;
        assert_eq!(level, Quaternion::identity());
    }
}
