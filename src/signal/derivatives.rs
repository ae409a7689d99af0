//! Acceleration and angular rate at a sample: from the host, or else from the samples around it.

use nalgebra::Vector3;

use crate::base::math::{end_derivative_weights, relative_rotation, rotation_vector};
use crate::base::snapshot::stored;
use crate::truth::TruthPoint;

/// Derivatives of the motion at a sample.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Derivatives {
    /// Acceleration against the Earth, Earth-fixed axes [m/s²].
    pub a_e: Vector3<f64>,
    /// Angular rate against inertial space, sensor axes [rad/s].
    pub omega_ib_b: Vector3<f64>,
}

/// Derivatives of accepted samples are smaller [m/s², rad/s]: with weights of 1/5e-5 s they are at most 1e14.
pub(crate) const DERIVATIVES: f64 = 1e18;

stored!(Derivatives { a_e: DERIVATIVES, omega_ib_b: DERIVATIVES });

/// Another sample, relative to the one at which derivatives are computed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Neighbour {
    pub v_e: Vector3<f64>,
    /// Time from that sample [s].
    pub offset_s: f64,
    /// Rotation vector from the attitude of that sample [rad].
    pub rotation: Vector3<f64>,
}

impl Neighbour {
    pub fn new(from: &TruthPoint, point: &TruthPoint, offset_s: f64) -> Self {
        let rotation = rotation_vector(&relative_rotation(&from.state.q_eb, &point.state.q_eb));
        Self { v_e: point.state.v_e, offset_s, rotation }
    }
}

/// The derivatives that the host gave at `point`, if it gave all.
pub(super) fn given(point: &TruthPoint) -> Option<Derivatives> {
    Some(Derivatives { a_e: point.a_e?, omega_ib_b: point.omega_ib_b()? })
}

/// The usable samples before `next`.
pub(super) fn neighbours_behind(
    next: &TruthPoint,
    current: &TruthPoint,
    second: Option<&TruthPoint>,
    third: Option<&TruthPoint>,
) -> [Option<Neighbour>; 3] {
    let to_second = -next.interval_s - current.interval_s;
    [
        Some(Neighbour::new(next, current, -next.interval_s)),
        second.map(|point| Neighbour::new(next, point, to_second)),
        second.zip(third).map(|(between, point)| Neighbour::new(next, point, to_second - between.interval_s)),
    ]
}

/// The derivatives at `point`: from the host, or else from one to three other samples. `earth_rate_b` is the Earth rate there.
pub(super) fn derivatives_at(
    point: &TruthPoint,
    earth_rate_b: &Vector3<f64>,
    others: [Option<Neighbour>; 3],
) -> Derivatives {
    if let Some(given) = given(point) {
        return given;
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
        omega_ib_b: point.omega_ib_b().unwrap_or(omega_eb_b + earth_rate_b),
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
