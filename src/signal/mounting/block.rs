//! The sensor block in flight.

use nalgebra::{Matrix3, Vector3};

use super::{MountingParameters, Placement, centripetal, lever_arm_velocity};
use crate::base::math::{
    VectorPair, relative_rotation, rotate, rotate_inverse, rotation_matrix, rotation_vector,
};
use crate::base::snapshot::{SIGNALS, stored};
use crate::earth::Earth;
use crate::earth::state::{BodyAxes, EarthFixedState};
use crate::signal::{DERIVATIVES, Increment, IntervalMotion, MotionNode};
use crate::truth::TruthPoint;

/// A mounted block: what its sensors sense, where it is, and what the INS believes of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    earth_rate: f64,
    placement: Placement,
    believed: Placement,
    /// C_sb
    to_block: Matrix3<f64>,
    /// ω_ib at the last sample, body axes [rad/s].
    rate_b: Vector3<f64>,
    /// Mean error of the gyros over the last interval, block axes [rad/s].
    gyro_error_s: Vector3<f64>,
}

stored!(Block { rate_b: DERIVATIVES, gyro_error_s: SIGNALS } rebuilt { earth_rate, placement, believed, to_block });

/// Placement and angular rate of the block, as an INS believes them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Belief {
    placement: Placement,
    /// ω_is, block axes [rad/s].
    rate_s: Vector3<f64>,
    earth_rate: f64,
}

impl Belief {
    /// The inverse of [`Self::reference_point`].
    pub fn block(&self, reference_point: &EarthFixedState) -> EarthFixedState {
        let rate_b = rotate(&self.placement.q_bs, &self.rate_s);
        self.placement.block(reference_point, &rate_b, self.earth_rate)
    }

    /// The INS's output for the reference point, from its solution `block` of the block.
    pub fn reference_point(&self, block: &EarthFixedState) -> EarthFixedState {
        self.placement.reference_point(block, &self.rate_s, self.earth_rate)
    }
}

/// Errors of the reference point in the output of an INS whose solution of the block is error-free, and the arm by which the
/// block's own errors reach the reference point. True body axes; velocities are relative to inertial axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MountingErrors {
    /// The believed arm, laid along the believed body axes [m].
    pub arm_b: Vector3<f64>,
    /// Velocity of the believed arm [m/s].
    pub arm_rate_b: Vector3<f64>,
    /// Position error, computed less true [m].
    pub position_b: Vector3<f64>,
    /// Velocity error, computed less true [m/s].
    pub velocity_b: Vector3<f64>,
    /// Misalignment φ, computed less true [rad].
    pub misalignment_b: Vector3<f64>,
}

impl Block {
    /// The block of a vehicle that turns at `rate_b` [rad/s] relative to inertial space; the Earth turns at `earth_rate` [rad/s].
    pub fn new(
        parameters: &MountingParameters,
        axes: BodyAxes,
        earth_rate: f64,
        rate_b: Vector3<f64>,
    ) -> Self {
        let placement = Placement::new(parameters.lever_arm_m, &parameters.boresight, axes);
        let believed = parameters.believed_placement(axes);
        Self {
            earth_rate,
            placement,
            believed,
            to_block: rotation_matrix(&placement.q_bs).transpose(),
            rate_b,
            gyro_error_s: Vector3::zeros(),
        }
    }

    /// This block in a vehicle whose present angular rate is `rate_b` [rad/s].
    pub fn turning_at(&self, rate_b: Vector3<f64>) -> Self {
        Self { rate_b, ..*self }
    }

    /// Turns the `increments` of the reference point into the increments of the block, over the interval of `motion`, which begins
    /// at `start`.
    ///
    /// If the generator has revised the rate at the start, the velocity of the block there is revised too. Returns by how much it
    /// increases [m/s], Earth-fixed axes. No sensor measured this difference, so the navigator of the block adds it.
    #[inline(never)]
    pub fn mount(
        &mut self,
        earth: &Earth,
        motion: &IntervalMotion<'_>,
        start: &TruthPoint,
        start_is_revised: bool,
        increments: &mut [Increment],
    ) -> Option<Vector3<f64>> {
        let arm_b = &self.placement.arm_b;
        let revised_e = start_is_revised.then(|| {
            let before = core::mem::replace(&mut self.rate_b, motion.angular_rate(0.0));
            start.to_earth * (self.rate_b - before).cross(arm_b)
        });
        let part = 1.0 / increments.len() as f64;
        let dt = motion.interval_s * part;
        for (m, increment) in increments.iter_mut().enumerate() {
            let (middle, end) = ((m as f64 + 0.5) * part, (m as f64 + 1.0) * part);
            let end_rate_b = motion.angular_rate(end);
            let by_arm = lever_arm_velocity(&(end_rate_b - self.rate_b), &(increment.angle / dt), dt, arm_b);
            let to_earth = motion.to_earth(middle);
            let gravitation_b = to_earth.tr_mul(&gravitation_along(earth, start, &(to_earth * arm_b)));
            *increment = Increment {
                angle: self.to_block * increment.angle,
                velocity: self.to_block * (increment.velocity + by_arm - gravitation_b * dt),
            };
            self.rate_b = end_rate_b;
        }
        revised_e
    }

    /// Turns a vector from body axes to the block's.
    pub fn in_block_axes(&self, vector_b: &Vector3<f64>) -> Vector3<f64> {
        self.to_block * vector_b
    }

    /// Turns a vector from the block's axes to body axes.
    pub fn in_body_axes(&self, vector_s: &Vector3<f64>) -> Vector3<f64> {
        self.to_block.tr_mul(vector_s)
    }

    /// Takes the sums of the increments of the last interval, of length `t` [s]: without errors and as navigated on.
    pub fn observe(&mut self, error_free: &Increment, navigated: &Increment, t: f64) {
        self.gyro_error_s = (navigated.angle - error_free.angle) / t;
    }

    /// The true state of the block while the vehicle is at `truth`, the last sample.
    pub fn state(&self, truth: &TruthPoint) -> EarthFixedState {
        self.placement.block(&truth.state, &self.rate_b, self.earth_rate)
    }

    /// The INS's belief of the mounting at the last sample. Its rate is the rate of gyros that are read much faster than the
    /// increments, with their mean error.
    pub fn belief(&self) -> Belief {
        let rate_s = self.to_block * self.rate_b + self.gyro_error_s;
        Belief { placement: self.believed, rate_s, earth_rate: self.earth_rate }
    }

    /// The belief of an INS that knows its mounting and has perfect gyros.
    pub fn true_belief(&self) -> Belief {
        Belief { placement: self.placement, rate_s: self.to_block * self.rate_b, earth_rate: self.earth_rate }
    }

    /// Velocity and specific force of the block at the start, in the middle and at the end of `motion`. The position is not moved,
    /// because gravity and curvature at the other end of the arm differ by a millionth.
    pub fn nodes(&self, motion: &IntervalMotion<'_>) -> [MotionNode; 3] {
        let arm_b = &self.placement.arm_b;
        let [start, middle, end] = [0.0, 0.5, 1.0].map(|u| motion.angular_rate(u));
        let inverse_t = 1.0 / motion.interval_s;
        // Derivatives of the parabola through the three rates. Their integral by Simpson's rule is the change of the rate.
        let changes = [
            (middle * 4.0 - start * 3.0 - end) * inverse_t,
            (end - start) * inverse_t,
            (start - middle * 4.0 + end * 3.0) * inverse_t,
        ];
        let by_arm = |rate: &Vector3<f64>, change: &Vector3<f64>| {
            VectorPair::new(&rate.cross(arm_b), &(change.cross(arm_b) + centripetal(rate, arm_b)))
        };
        let [d0, d1, d2] = changes;
        let by_arm_e = motion.to_earth_axes(&[by_arm(&start, &d0), by_arm(&middle, &d1), by_arm(&end, &d2)]);
        let mut nodes = motion.nodes();
        for (node, by_arm_e) in nodes.iter_mut().zip(&by_arm_e) {
            node.v_e += by_arm_e.first();
            node.f_e += by_arm_e.second();
        }
        nodes
    }

    /// Errors of the INS at the last sample that its mounting causes and, in the velocity of the arm, its gyros. With
    /// B = C_bs C~_bsᵀ and C~_eb = C_eb B, the believed arm is B l~ in true body axes.
    pub fn errors(&self) -> MountingErrors {
        let (q, believed) = (&self.placement.q_bs, &self.believed.q_bs);
        let arm_b = rotate(q, &rotate_inverse(believed, &self.believed.arm_b));
        let excess_b = arm_b - self.placement.arm_b;
        MountingErrors {
            arm_b,
            arm_rate_b: self.rate_b.cross(&arm_b),
            position_b: -excess_b,
            velocity_b: -self.rate_b.cross(&excess_b) - self.in_body_axes(&self.gyro_error_s).cross(&arm_b),
            misalignment_b: -rotation_vector(&relative_rotation(&q.conjugate(), &believed.conjugate())),
        }
    }
}

/// γ(r + l) - γ(r) at `point` [m/s²], Earth-fixed axes, l = `arm_e` [m]: the change of gravity, less the change of its centrifugal
/// part.
fn gravitation_along(earth: &Earth, point: &TruthPoint, arm_e: &Vector3<f64>) -> Vector3<f64> {
    let rate2 = earth.rate_rad_s * earth.rate_rad_s;
    let centrifugal_e = Vector3::new(arm_e.x, arm_e.y, 0.0) * rate2;
    earth.gravity(&(point.state.r_e + arm_e)) - point.gravity_e - centrifugal_e
}
