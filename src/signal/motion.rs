//! The motion within one interval, as polynomials of u = time since its start over its length, 0 to 1.

use nalgebra::{Matrix3, Vector3};

use super::Increment;
use super::derivatives::Derivatives;
use crate::base::math::{
    GAUSS_2, GAUSS_3, GAUSS_5, Pair, RotationSeries, VectorPair, axis_cross, inverse_right_jacobian,
    right_jacobian, rotation_matrix, rotation_quaternion,
};
use crate::truth::TruthPoint;

/// Nodes and weights of quadrature, two nodes at once.
const GAUSS2: [[Pair; 2]; 1] = by_twos(&GAUSS_2);
const GAUSS3: [[Pair; 2]; 2] = by_twos(&GAUSS_3);
const GAUSS5: [[Pair; 2]; 3] = by_twos(&GAUSS_5);

/// The first node with the last, and so on; the middle one with itself, the second time of weight 0.
const fn by_twos<const N: usize, const PAIRS: usize>(rule: &[(f64, f64); N]) -> [[Pair; 2]; PAIRS] {
    let mut pairs = [[Pair([0.0; 2]); 2]; PAIRS];
    let mut place = 0;
    while place < PAIRS {
        let mirrored = N - 1 - place;
        let ((node, weight), (other_node, other_weight)) = (rule[place], rule[mirrored]);
        let other_weight = if mirrored == place { 0.0 } else { other_weight };
        pairs[place] = [Pair([node, other_node]), Pair([weight, other_weight])];
        place += 1;
    }
    pairs
}

/// Rotation within a sub-interval up to which two and three nodes integrate to rounding [rad]. Two nodes have an error of the
/// fourth derivative over 4320, 2e-16 of the increment; three nodes of the sixth derivative over 2e6, 8e-15 of it.
const GAUSS2_MAX_ROTATION: f64 = 0.001;
const GAUSS3_MAX_ROTATION: f64 = 0.05;

/// Truth at an instant of the interval, Earth-fixed axes, for the error equations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionNode {
    /// Position [m].
    pub r_e: Vector3<f64>,
    /// Velocity against the Earth [m/s].
    pub v_e: Vector3<f64>,
    /// Specific force [m/s²].
    pub f_e: Vector3<f64>,
}

/// The rotation of the attitude over one interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turning {
    /// Length T [s].
    pub interval_s: f64,
    /// Rotation vector against inertial space since the start = Σ rotation[i] u^(i+1) [rad].
    rotation: [Vector3<f64>; 3],
}

impl Turning {
    /// This rotation in other axes; `turn` turns vectors into them.
    pub fn in_axes(&self, turn: impl Fn(&Vector3<f64>) -> Vector3<f64>) -> Self {
        Self { rotation: self.rotation.map(|c| turn(&c)), ..*self }
    }

    /// Rotation vector against inertial space from the start to `u` [rad].
    fn turned_by(&self, u: f64) -> Vector3<f64> {
        let [c1, c2, c3] = &self.rotation;
        (c1 + (c2 + c3 * u) * u) * u
    }

    /// Angular rate against inertial space at `u` [rad/s].
    pub fn angular_rate(&self, u: f64) -> Vector3<f64> {
        let [c1, c2, c3] = &self.rotation;
        let phi_rate = c1 + (c2 * 2.0 + c3 * (3.0 * u)) * u;
        right_jacobian(&self.turned_by(u), &phi_rate) * (1.0 / self.interval_s)
    }
}

/// Attitude and velocity over one interval, and with gravity the specific force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntervalMotion<'a> {
    /// Length T [s].
    pub interval_s: f64,
    earth_rate: f64,
    start: &'a TruthPoint,
    end: &'a TruthPoint,
    /// Rotation vector against inertial space since the start = Σ rotation[i] u^(i+1), sensor axes [rad].
    rotation: [Vector3<f64>; 3],
    /// Velocity = Σ velocity[i] u^i, Earth-fixed axes [m/s].
    velocity: [Vector3<f64>; 4],
    /// T times specific force = Σ force[i] u^i, Earth-fixed axes [m/s].
    force: [Vector3<f64>; 4],
}

impl<'a> IntervalMotion<'a> {
    /// The cubic through both ends: velocity with acceleration, rotation vector (`phi` over the interval) with its rate.
    #[inline]
    pub(super) fn new(
        start: &'a TruthPoint,
        end: &'a TruthPoint,
        ends: &[Derivatives; 2],
        phi: &Vector3<f64>,
        earth_rate: f64,
    ) -> Self {
        let t = end.interval_s;
        let d0 = ends[0].omega_ib_b * t;
        let d1 = inverse_right_jacobian(phi, &(ends[1].omega_ib_b * t));
        let rotation = [d0, phi * 3.0 - 2.0 * d0 - d1, d0 + d1 - phi * 2.0];

        let (a0, a1) = (ends[0].a_e * t, ends[1].a_e * t);
        let dv = end.state.v_e - start.state.v_e;
        let velocity = [start.state.v_e, a0, 3.0 * dv - 2.0 * a0 - a1, a0 + a1 - 2.0 * dv];

        // f = a + 2 W×v - g. Gravity is linear between the ends, except for the curvature of the path, which is u (1 - u) T a/2
        // high, in the gradient of a sphere.
        let coriolis = |v: &Vector3<f64>| axis_cross(2.0 * earth_rate * t, v);
        let inverse_r2 = 1.0 / start.state.r_e.norm_squared();
        let gradient = -start.gravity_e.dot(&start.state.r_e) * inverse_r2;
        let bow =
            (dv - start.state.r_e * (3.0 * start.state.r_e.dot(&dv) * inverse_r2)) * (0.5 * t * t * gradient);
        let gravity_change = (end.gravity_e - start.gravity_e) * t;
        let force = [
            velocity[1] + coriolis(&velocity[0]) - start.gravity_e * t,
            2.0 * velocity[2] + coriolis(&velocity[1]) - gravity_change - bow,
            3.0 * velocity[3] + coriolis(&velocity[2]) + bow,
            coriolis(&velocity[3]),
        ];
        Self { interval_s: t, earth_rate, start, end, rotation, velocity, force }
    }

    /// Integrals of angular rate and specific force over each of `increments.len()` equal parts.
    pub fn integrate(&self, increments: &mut [Increment]) {
        let polynomials = SensedPolynomials {
            rotation: self.rotation.map(|c| VectorPair::both(&c)),
            force: self.force_in_start_axes().map(|f| VectorPair::both(&f)),
        };
        let part = 1.0 / increments.len() as f64;
        let rotation_bound: f64 = self.rotation.iter().map(|c| c.x.abs() + c.y.abs() + c.z.abs()).sum();
        match rotation_bound * part {
            turn if turn < GAUSS2_MAX_ROTATION => polynomials.integrate(&GAUSS2, part, increments),
            turn if turn < GAUSS3_MAX_ROTATION => polynomials.integrate(&GAUSS3, part, increments),
            _ => polynomials.integrate(&GAUSS5, part, increments),
        }
    }

    /// The force polynomial in the sensor axes of the start, which stay fixed in inertial space. It contains the rotation of the
    /// Earth to second order.
    fn force_in_start_axes(&self) -> [Vector3<f64>; 4] {
        let wt = self.earth_rate * self.interval_s;
        let [f0, f1, f2, f3] = &self.force;
        let (k0, k1) = (axis_cross(wt, f0), axis_cross(wt, f1));
        let inertial = [
            *f0,
            f1 + k0,
            f2 + k1 + 0.5 * axis_cross(wt, &k0),
            f3 + axis_cross(wt, f2) + 0.5 * axis_cross(wt, &k1),
        ];
        inertial.map(|f| self.start.to_earth.tr_mul(&f))
    }

    /// Angular rate against inertial space at `u`, sensor axes [rad/s].
    pub fn angular_rate(&self, u: f64) -> Vector3<f64> {
        self.turning().angular_rate(u)
    }

    /// The rotation of the attitude.
    pub fn turning(&self) -> Turning {
        Turning { interval_s: self.interval_s, rotation: self.rotation }
    }

    /// Matrix of the attitude at `u`: sensor axes to Earth-fixed axes.
    pub fn to_earth(&self, u: f64) -> Matrix3<f64> {
        let turned = rotation_quaternion(&self.turning().turned_by(u));
        // The Earth has turned since the start.
        let earth_turn = Vector3::new(0.0, 0.0, -self.earth_rate * self.interval_s * u);
        rotation_matrix(&(rotation_quaternion(&earth_turn) * self.start.state.q_eb * turned))
    }

    /// Displacement over the interval by its velocity, Earth-fixed axes [m].
    pub fn displacement(&self) -> Vector3<f64> {
        let [v0, v1, v2, v3] = &self.velocity;
        (v0 + v1 * 0.5 + v2 * (1.0 / 3.0) + v3 * 0.25) * self.interval_s
    }

    /// Truth at the start, in the middle and at the end.
    #[inline(always)]
    pub fn nodes(&self) -> [MotionNode; 3] {
        let [v0, v1, v2, v3] = &self.velocity;
        let [f0, f1, f2, f3] = &self.force;
        let (t, rate) = (self.interval_s, 1.0 / self.interval_s);
        let (start, end) = (&self.start.state, &self.end.state);
        let to_middle = (v0 * 0.5 + v1 * 0.125 + v2 * (1.0 / 24.0) + v3 * (1.0 / 64.0)) * t;
        [
            MotionNode { r_e: start.r_e, v_e: start.v_e, f_e: f0 * rate },
            MotionNode {
                r_e: start.r_e + to_middle,
                v_e: v0 + v1 * 0.5 + v2 * 0.25 + v3 * 0.125,
                f_e: (f0 + f1 * 0.5 + f2 * 0.25 + f3 * 0.125) * rate,
            },
            MotionNode { r_e: end.r_e, v_e: end.v_e, f_e: (f0 + f1 + f2 + f3) * rate },
        ]
    }

    /// Pairs of vectors in sensor axes at the start, in the middle and at the end, turned to Earth-fixed axes.
    #[inline(always)]
    pub fn to_earth_axes(&self, pairs: &[VectorPair; 3]) -> [VectorPair; 3] {
        self.turn_to_earth().of(pairs)
    }

    /// The rotation that [`Self::to_earth_axes`] applies.
    #[inline(always)]
    pub fn turn_to_earth(&self) -> TurnToEarth {
        let [c1, c2, c3] = &self.rotation;
        let phi = 0.5 * c1 + 0.25 * c2 + 0.125 * c3;
        let n2 = phi.norm_squared();
        let series = RotationSeries::new(n2);
        TurnToEarth {
            phi: VectorPair::both(&phi),
            linear: 1.0 - n2 * series.cubic,
            square: series.square,
            start: self.start.to_earth,
            end: self.end.to_earth,
            earth_angle: 0.5 * self.earth_rate * self.interval_s,
        }
    }
}

/// Turns vectors from sensor axes at the start, in the middle and at the end of an interval to Earth-fixed axes.
#[derive(Debug, Clone, Copy)]
pub struct TurnToEarth {
    /// Rotation vector from the start to the middle [rad], and its coefficients.
    phi: VectorPair,
    linear: f64,
    square: f64,
    start: Matrix3<f64>,
    end: Matrix3<f64>,
    /// Rotation of the Earth in half the interval [rad].
    earth_angle: f64,
}

impl TurnToEarth {
    /// Two vectors at each instant.
    #[inline(always)]
    pub fn of(&self, [start, middle, end]: &[VectorPair; 3]) -> [VectorPair; 3] {
        let cross = self.phi.cross(middle);
        let turned = *middle
            + cross.times(Pair::both(self.linear))
            + self.phi.cross(&cross).times(Pair::both(self.square));
        let middle = VectorPair::of_matrix(&self.start, &turned);
        // At most 2e-3 rad, so the second order is enough.
        let angle = Pair::both(self.earth_angle);
        let half_square = angle * angle * 0.5;
        let middle = VectorPair {
            x: middle.x + middle.y * angle - middle.x * half_square,
            y: middle.y - middle.x * angle - middle.y * half_square,
            z: middle.z,
        };
        [VectorPair::of_matrix(&self.start, start), middle, VectorPair::of_matrix(&self.end, end)]
    }
}

/// Rotation vector = Σ rotation[i] u^(i+1) and T times specific force in the axes of the start = Σ force[i] u^i, each
/// coefficient twice, for two instants at once.
struct SensedPolynomials {
    rotation: [VectorPair; 3],
    force: [VectorPair; 4],
}

impl SensedPolynomials {
    /// Integrals over each of the equal parts, of length `part`.
    #[inline(always)]
    fn integrate<const N: usize>(&self, nodes: &[[Pair; 2]; N], part: f64, increments: &mut [Increment]) {
        for (m, increment) in increments.iter_mut().enumerate() {
            let (mut angle, mut velocity) = (VectorPair::ZERO, VectorPair::ZERO);
            for &[node, weight] in nodes {
                let (rate, force) = self.sensed((Pair::both(m as f64) + node) * part);
                angle += rate.times(weight);
                velocity += force.times(weight);
            }
            *increment = Increment { angle: angle.sum() * part, velocity: velocity.sum() * part };
        }
    }

    /// T times angular rate against inertial space and specific force at two instants, sensor axes.
    #[inline(always)]
    fn sensed(&self, u: Pair) -> (VectorPair, VectorPair) {
        let [c1, c2, c3] = &self.rotation;
        let [f0, f1, f2, f3] = &self.force;
        let phi = (*c1 + (*c2 + c3.times(u)).times(u)).times(u);
        let phi_rate = *c1 + (c2.times(Pair::both(2.0)) + c3.times(u * 3.0)).times(u);
        let force = *f0 + (*f1 + (*f2 + f3.times(u)).times(u)).times(u);
        let n2 = phi.dot(&phi);
        let (square, cubic) = RotationSeries::of_pair(n2);
        let cross = phi.cross(&phi_rate);
        let rate = phi_rate - cross.times(square) + phi.cross(&cross).times(cubic);
        let cross = phi.cross(&force);
        let force = force - cross.times(Pair::both(1.0) - n2 * cubic) + phi.cross(&cross).times(square);
        (rate, force)
    }
}
