//! The generator: acceleration and angular rate at the samples, from the samples, and with them the motion of one interval
//! after the other.

use nalgebra::Vector3;

use super::motion::IntervalMotion;
use crate::math::{
    end_derivative_weights, relative_rotation, rotated_z, rotation_increment, rotation_vector,
};
use crate::truth::{Recent, TruthPoint};

/// Total rotation over a stencil beyond which the rotation vectors from its end grow ambiguous [rad] (150°).
const MAX_STENCIL_ROTATION: f64 = 2.6;

/// Derivatives of the motion at a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Derivatives {
    /// Acceleration against the Earth, Earth-fixed axes [m/s²].
    pub a_e: Vector3<f64>,
    /// Angular rate against inertial space, sensor axes [rad/s].
    pub omega_ib_b: Vector3<f64>,
}

/// Another sample, seen from the one where derivatives are wanted.
#[derive(Debug, Clone, Copy)]
struct Neighbour {
    v_e: Vector3<f64>,
    /// Time from there [s].
    offset_s: f64,
    /// Rotation vector from its attitude [rad].
    rotation: Vector3<f64>,
}

impl Neighbour {
    fn new(from: &TruthPoint, point: &TruthPoint, offset_s: f64) -> Self {
        let rotation = rotation_vector(&relative_rotation(&from.state.q_eb, &point.state.q_eb));
        Self { v_e: point.state.v_e, offset_s, rotation }
    }
}

/// Makes the ideal signals of the interval between each sample and the next.
#[derive(Debug, Clone, PartialEq)]
pub struct SignalGenerator {
    earth_rate: f64,
    /// At the last sample, once they come from as many points as a stencil ever has, or from the host.
    settled: Option<Derivatives>,
    /// Rotation over each of the last two intervals, newest first [rad].
    turned: [f64; 2],
}

impl SignalGenerator {
    /// Starts on an Earth that turns at `earth_rate` [rad/s].
    pub fn new(earth_rate: f64) -> Self {
        Self { earth_rate, settled: None, turned: [0.0; 2] }
    }

    /// The motion of the interval that `recent` ends; the intervals come in order.
    ///
    /// Derivatives from four points, backward: at both ends the error is then the same, and cancels at the middle of the
    /// interval. While there are fewer, both ends take all there are.
    pub fn advance<'a>(&mut self, recent: &Recent<'a>) -> IntervalMotion<'a> {
        let Recent { next, current, before } = *recent;
        let interval = next.interval_s;
        let against_earth = relative_rotation(&current.state.q_eb, &next.state.q_eb);
        let turn = rotation_vector(&against_earth);
        let turned = turn.norm_squared().sqrt();

        // The samples before, seen from `next`, as far as the rotation since then is unambiguous.
        let back = Neighbour { v_e: current.state.v_e, offset_s: -interval, rotation: -turn };
        let since_second = turned + self.turned[0];
        let since_third = since_second + self.turned[1];
        let second = before[0]
            .filter(|_| since_second < MAX_STENCIL_ROTATION)
            .map(|point| Neighbour::new(next, point, -interval - current.interval_s));
        let third = before[1].zip(before[0]).filter(|_| since_third < MAX_STENCIL_ROTATION).map(
            |(point, between)| {
                Neighbour::new(next, point, -interval - current.interval_s - between.interval_s)
            },
        );
        let earth_rate_b = self.earth_rate_at(next);
        let end = derivatives_at(next, &earth_rate_b, [Some(back), second, third]);
        let start = self.settled.unwrap_or_else(|| {
            let ahead = Neighbour { v_e: next.state.v_e, offset_s: interval, rotation: turn };
            let behind = before[0]
                .filter(|_| self.turned[0] < MAX_STENCIL_ROTATION)
                .map(|point| Neighbour::new(current, point, -current.interval_s));
            let far = before[1].zip(before[0]).filter(|_| third.is_some()).map(|(point, between)| {
                Neighbour::new(current, point, -current.interval_s - between.interval_s)
            });
            derivatives_at(current, &self.earth_rate_at(current), [Some(ahead), behind, far])
        });

        // Against the Earth q0* q1, which is exact at rest, then the Earth's own turn meanwhile.
        let earth_turn = rotation_increment(&(earth_rate_b * interval));
        let rotation = rotation_vector(&(against_earth + against_earth * earth_turn));

        let given = next.sample.omega_ib_b.is_some() && next.a_e.is_some();
        self.settled = (given || third.is_some()).then_some(end);
        self.turned = [turned, self.turned[0]];
        IntervalMotion::new(current, next, &[start, end], &rotation, self.earth_rate)
    }

    /// Earth rate in the sensor axes of a sample [rad/s].
    fn earth_rate_at(&self, point: &TruthPoint) -> Vector3<f64> {
        rotated_z(&point.state.q_eb.conjugate()) * self.earth_rate
    }
}

/// What the host gave at `point`, else what one to three others make of it; `earth_rate_b` is the Earth rate there.
fn derivatives_at(
    point: &TruthPoint,
    earth_rate_b: &Vector3<f64>,
    others: [Option<Neighbour>; 3],
) -> Derivatives {
    if let (Some(a_e), Some(omega_ib_b)) = (point.a_e, point.sample.omega_ib_b) {
        return Derivatives { a_e, omega_ib_b };
    }
    let v_e = &point.state.v_e;
    let (a_e, omega_eb_b) = match others {
        [Some(a), Some(b), Some(c)] => weighted(v_e, &[a, b, c]),
        [Some(a), Some(b), None] => weighted(v_e, &[a, b]),
        [Some(a), None, _] => weighted(v_e, &[a]),
        _ => (Vector3::zeros(), Vector3::zeros()),
    };
    Derivatives {
        a_e: point.a_e.unwrap_or(a_e),
        omega_ib_b: point.sample.omega_ib_b.unwrap_or(omega_eb_b + earth_rate_b),
    }
}

/// Derivatives of velocity and of rotation vector at the velocity `v_e` and the rotation 0.
#[inline]
fn weighted<const N: usize>(v_e: &Vector3<f64>, others: &[Neighbour; N]) -> (Vector3<f64>, Vector3<f64>) {
    let weights = end_derivative_weights(&others.map(|other| other.offset_s));
    others.iter().zip(weights).fold((Vector3::zeros(), Vector3::zeros()), |(a_e, omega), (other, weight)| {
        (a_e + (other.v_e - v_e) * weight, omega + other.rotation * weight)
    })
}
