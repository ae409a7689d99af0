//! Acceleration and angular rate at the samples, from the samples.

use nalgebra::{Quaternion, Vector3};

use crate::math::{end_derivative_weights, rotate_inverse, rotation_increment, rotation_vector};
use crate::truth::TruthPoint;

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

/// What an interval between two samples needs.
#[derive(Debug, Clone, Copy)]
pub(super) struct IntervalEnds {
    pub start: Derivatives,
    pub end: Derivatives,
    /// Rotation vector against inertial space over the interval, sensor axes at its start [rad].
    pub rotation: Vector3<f64>,
}

/// A sample before the newest, seen from the newest.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Past {
    v_e: Vector3<f64>,
    q_eb: Quaternion<f64>,
    /// Time from the newest sample, negative [s].
    offset_s: f64,
    /// Rotation vector from the newest attitude [rad].
    rotation: Vector3<f64>,
    /// Upper bound of the rotation since then [rad].
    turned: f64,
}

/// The last samples and the derivatives at the newest.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stencil {
    earth_rate: f64,
    newest: TruthPoint,
    /// Earth rate in sensor axes at the newest [rad/s].
    earth_rate_b: Vector3<f64>,
    derivatives: Option<Derivatives>,
    /// Whether `derivatives` came from as many points as a stencil ever has (or from the host).
    settled: bool,
    /// Up to three samples before the newest, newest first.
    past: [Option<Past>; 3],
}

impl Stencil {
    pub fn new(first: TruthPoint, earth_rate: f64) -> Self {
        let earth_rate_b = rotate_inverse(&first.state.q_eb, &Vector3::new(0.0, 0.0, earth_rate));
        Self { earth_rate, newest: first, earth_rate_b, derivatives: None, settled: false, past: [None; 3] }
    }

    pub fn newest(&self) -> &TruthPoint {
        &self.newest
    }

    /// Derivatives at both ends of the interval to `next`, which becomes the newest.
    ///
    /// Four points, backward: at both ends the error is then the same, and cancels at the middle of the interval.
    /// While there are fewer, both ends take all there are.
    pub fn advance(&mut self, next: &TruthPoint) -> IntervalEnds {
        let interval = next.interval_s;
        let (newest, q_next) = (self.newest.state, next.state.q_eb);
        let from_next = q_next.conjugate();
        let back = rotation_vector(&(from_next * newest.q_eb));
        let turned = back.norm_squared().sqrt();
        let mut past = [None; 3];
        past[0] =
            Some(Past { v_e: newest.v_e, q_eb: newest.q_eb, offset_s: -interval, rotation: back, turned });
        for j in 0..2 {
            past[j + 1] = self.past[j].filter(|p| p.turned + turned < MAX_STENCIL_ROTATION).map(|p| Past {
                offset_s: p.offset_s - interval,
                rotation: rotation_vector(&(from_next * p.q_eb)),
                turned: p.turned + turned,
                ..p
            });
        }

        let earth_rate_b = rotate_inverse(&q_next, &Vector3::new(0.0, 0.0, self.earth_rate));
        let end = given_or(next, &earth_rate_b, &past);
        let start = match self.derivatives {
            Some(derivatives) if self.settled => derivatives,
            _ => {
                let ahead =
                    Past { v_e: next.state.v_e, q_eb: q_next, offset_s: interval, rotation: -back, turned };
                given_or(&self.newest, &self.earth_rate_b, &[Some(ahead), self.past[0], self.past[1]])
            }
        };
        // Against the Earth q0* q1, which is exact at rest, then the Earth's own turn meanwhile.
        let against_earth = newest.q_eb.conjugate() * q_next;
        let earth_turn = rotation_increment(&(earth_rate_b * interval));
        let rotation = rotation_vector(&(against_earth + against_earth * earth_turn));

        self.settled = (next.sample.omega_ib_b.is_some() && next.a_e.is_some()) || past[2].is_some();
        self.derivatives = Some(end);
        self.past = past;
        self.newest = *next;
        self.earth_rate_b = earth_rate_b;
        IntervalEnds { start, end, rotation }
    }
}

/// What the host gave at `point`, else what the other points make of it; `earth_rate_b` is the Earth rate there.
fn given_or(point: &TruthPoint, earth_rate_b: &Vector3<f64>, others: &[Option<Past>; 3]) -> Derivatives {
    if let (Some(a_e), Some(omega_ib_b)) = (point.a_e, point.sample.omega_ib_b) {
        return Derivatives { a_e, omega_ib_b };
    }
    let (a_e, omega_eb_b) = derivatives_at(&point.state.v_e, others);
    Derivatives {
        a_e: point.a_e.unwrap_or(a_e),
        omega_ib_b: point.sample.omega_ib_b.unwrap_or(omega_eb_b + earth_rate_b),
    }
}

/// Acceleration against the Earth [m/s²] and angular rate against the Earth in sensor axes [rad/s] at a sample of velocity
/// `v_e` from one to three others.
fn derivatives_at(v_e: &Vector3<f64>, others: &[Option<Past>; 3]) -> (Vector3<f64>, Vector3<f64>) {
    let weighted = |points: &[Past], weights: &[f64]| {
        points.iter().zip(weights).fold(
            (Vector3::zeros(), Vector3::zeros()),
            |(a_e, omega), (point, &weight)| {
                (a_e + (point.v_e - v_e) * weight, omega + point.rotation * weight)
            },
        )
    };
    match *others {
        [Some(a), Some(b), Some(c)] => {
            weighted(&[a, b, c], &end_derivative_weights(&[a.offset_s, b.offset_s, c.offset_s]))
        }
        [Some(a), Some(b), None] => weighted(&[a, b], &end_derivative_weights(&[a.offset_s, b.offset_s])),
        [Some(a), None, _] => weighted(&[a], &end_derivative_weights(&[a.offset_s])),
        _ => weighted(&[], &[]),
    }
}
