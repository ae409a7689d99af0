//! Acceleration and angular rate at the samples, from the samples.

use nalgebra::{Quaternion, Vector3};

use crate::math::{end_derivative_weights, rotation_vector};
use crate::truth::TruthPoint;

/// Total rotation over a stencil beyond which the rotation vectors from its end grow ambiguous [rad] (150°).
const MAX_STENCIL_ROTATION: f64 = 2.6;

/// Derivatives of the motion at a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Derivatives {
    /// Acceleration against the Earth, Earth-fixed axes [m/s²].
    pub a_e: Vector3<f64>,
    /// Angular rate against the Earth, sensor axes [rad/s].
    pub omega_eb_b: Vector3<f64>,
}

/// What an interval between two samples needs.
#[derive(Debug, Clone, Copy)]
pub(super) struct IntervalEnds {
    pub start: Derivatives,
    pub end: Derivatives,
    /// Rotation vector of the interval, sensor axes at its start [rad].
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
    newest: TruthPoint,
    derivatives: Option<Derivatives>,
    /// Whether `derivatives` came from as many points as a stencil ever has (or from the host).
    settled: bool,
    /// Up to three samples before the newest, newest first.
    past: [Option<Past>; 3],
}

impl Stencil {
    pub fn new(first: TruthPoint) -> Self {
        Self { newest: first, derivatives: None, settled: false, past: [None; 3] }
    }

    pub fn newest(&self) -> &TruthPoint {
        &self.newest
    }

    /// Moves on to `next` and gives the derivatives at both ends of the interval in between.
    ///
    /// Four points, backward: at both ends the error is then the same, and cancels at the middle of the interval.
    /// While there are fewer, both ends take all there are.
    pub fn advance(&mut self, next: &TruthPoint) -> IntervalEnds {
        let interval = next.interval_s;
        let from_next = next.state.q_eb.conjugate();
        let mut past = [None; 3];
        let back = rotation_vector(&(from_next * self.newest.state.q_eb));
        let turned = back.norm_squared().sqrt();
        past[0] = Some(Past {
            v_e: self.newest.state.v_e,
            q_eb: self.newest.state.q_eb,
            offset_s: -interval,
            rotation: back,
            turned,
        });
        for j in 0..2 {
            past[j + 1] = self.past[j].filter(|p| p.turned + turned < MAX_STENCIL_ROTATION).map(|p| Past {
                offset_s: p.offset_s - interval,
                rotation: rotation_vector(&(from_next * p.q_eb)),
                turned: p.turned + turned,
                ..p
            });
        }

        let end = given_or(next, || derivatives_at(&next.state.v_e, &past));
        let start = match self.derivatives {
            Some(derivatives) if self.settled => derivatives,
            _ => given_or(&self.newest, || {
                let ahead = Past {
                    v_e: next.state.v_e,
                    q_eb: next.state.q_eb,
                    offset_s: interval,
                    rotation: -back,
                    turned,
                };
                derivatives_at(&self.newest.state.v_e, &[Some(ahead), self.past[0], self.past[1]])
            }),
        };
        let given = next.omega_eb_b.is_some() && next.a_e.is_some();
        self.settled = given || past[2].is_some();
        self.derivatives = Some(end);
        self.past = past;
        self.newest = *next;
        IntervalEnds { start, end, rotation: -back }
    }
}

/// What the host gave at `point`, else what `stencil` makes of the samples.
fn given_or(point: &TruthPoint, stencil: impl FnOnce() -> Derivatives) -> Derivatives {
    match (point.a_e, point.omega_eb_b) {
        (Some(a_e), Some(omega_eb_b)) => Derivatives { a_e, omega_eb_b },
        (a_e, omega_eb_b) => {
            let own = stencil();
            Derivatives { a_e: a_e.unwrap_or(own.a_e), omega_eb_b: omega_eb_b.unwrap_or(own.omega_eb_b) }
        }
    }
}

/// Derivatives at a sample of velocity `v_e` from one to three others.
fn derivatives_at(v_e: &Vector3<f64>, others: &[Option<Past>; 3]) -> Derivatives {
    let weighted = |points: &[Past], weights: &[f64]| {
        points.iter().zip(weights).fold(
            Derivatives { a_e: Vector3::zeros(), omega_eb_b: Vector3::zeros() },
            |sum, (point, &weight)| Derivatives {
                a_e: sum.a_e + (point.v_e - v_e) * weight,
                omega_eb_b: sum.omega_eb_b + point.rotation * weight,
            },
        )
    };
    match *others {
        [Some(a), Some(b), Some(c)] => {
            weighted(&[a, b, c], &end_derivative_weights(&[a.offset_s, b.offset_s, c.offset_s, 0.0]))
        }
        [Some(a), Some(b), None] => {
            weighted(&[a, b], &end_derivative_weights(&[a.offset_s, b.offset_s, 0.0]))
        }
        [Some(a), None, _] => weighted(&[a], &[1.0 / a.offset_s]),
        _ => weighted(&[], &[]),
    }
}
