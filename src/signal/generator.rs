//! The generator: the motion of each interval, in order, from the derivatives at its ends.

use nalgebra::{Quaternion, Vector3};

use super::derivatives::{Derivatives, Neighbour, derivatives_at, given, neighbours_behind};
use super::motion::IntervalMotion;
use crate::base::math::{
    end_derivative_weights, inverse_right_jacobian, relative_rotation, rotated_z, rotation_increment,
    rotation_vector,
};
use crate::base::snapshot::stored;
use crate::truth::{Recent, TruthPoint};

/// Total rotation over a stencil beyond which the rotation vectors from its end are ambiguous [rad] (150°).
const MAX_STENCIL_ROTATION: f64 = 2.6;

/// Total rotation over a stencil up to which [`composed`] is accurate enough [rad].
const MAX_SERIES_ROTATION: f64 = 0.5;

/// Rotation n over an interval up to which the second order of the Earth's turn b needs only its first term in n [rad]. The next
/// term is b² n³/720, 5e-17 rad for an interval of a second.
const MAX_SMALL_TURN: f64 = 0.02;

/// Rotation against the Earth over an interval, sensor axes.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Turn {
    /// Rotation vector [rad].
    vector: Vector3<f64>,
    /// Its length [rad].
    angle: f64,
}

impl Turn {
    const NONE: Self = Self { vector: Vector3::new(0.0, 0.0, 0.0), angle: 0.0 };

    fn new(against_earth: &Quaternion<f64>) -> Self {
        let vector = rotation_vector(against_earth);
        Self { vector, angle: vector.norm_squared().sqrt() }
    }
}

/// Computes the ideal signals of each interval between two samples.
#[derive(Debug, Clone, PartialEq)]
pub struct SignalGenerator {
    earth_rate: f64,
    /// Derivatives at the last sample, if they come from a full stencil or from the host.
    settled: Option<Derivatives>,
    /// Whether derivatives at the start of an interval differed from those at the end of the previous interval.
    start_is_revised: bool,
    /// Rotations of the last two intervals, newest first.
    turns: [Turn; 2],
    /// Weights of the last stencil, which regular samples use again.
    stencil: Stencil,
}

stored!(SignalGenerator { settled } rebuilt { earth_rate, start_is_revised, turns, stencil });

impl SignalGenerator {
    /// Starts on an Earth that turns at `earth_rate` [rad/s].
    pub fn new(earth_rate: f64) -> Self {
        Self {
            earth_rate,
            settled: None,
            start_is_revised: false,
            turns: [Turn::NONE; 2],
            stencil: Stencil::NONE,
        }
    }

    /// Takes the rotations of the last intervals from the points at their ends, newest first, as if the intervals had been flown.
    pub fn look_back(&mut self, points: &[Option<&TruthPoint>; 3]) {
        let turn = |end: Option<&TruthPoint>, start: Option<&TruthPoint>| match (end, start) {
            (Some(end), Some(start)) => Turn::new(&relative_rotation(&start.state.q_eb, &end.state.q_eb)),
            _ => Turn::NONE,
        };
        self.turns = [turn(points[0], points[1]), turn(points[1], points[2])];
    }

    /// The values of the current sample that [`Self::go_back`] needs.
    #[inline]
    pub(crate) fn settled(&self) -> Option<Derivatives> {
        self.settled
    }

    /// Undoes the interval that `recent` ends. `settled` is the value of [`Self::settled`] at its start.
    pub(crate) fn go_back(&mut self, settled: Option<Derivatives>, recent: &Recent<'_>) {
        let [second, third] = recent.before;
        self.settled = settled;
        self.look_back(&[Some(recent.current), second, third]);
    }

    /// The motion of the interval that `recent` ends; the intervals come in order.
    ///
    /// Derivatives come from four points, backward. The error is then the same at both ends, and cancels at the middle of the
    /// interval. While there are fewer points, both ends use all of them. After a gap T in positions alone three points are used:
    /// the fourth would turn velocity errors δ at intervals t into acceleration errors δ T/t².
    pub fn advance<'a>(&mut self, recent: &Recent<'a>) -> IntervalMotion<'a> {
        let Recent { next, current, before } = *recent;
        let against_earth = relative_rotation(&current.state.q_eb, &next.state.q_eb);
        let turn = Turn::new(&against_earth);
        let earth_rate_b = self.earth_rate_at(next);

        // Only points since which the rotation is unambiguous.
        let since_second = turn.angle + self.turns[0].angle;
        let since_third = since_second + self.turns[1].angle;
        let second = before[0].filter(|_| since_second < MAX_STENCIL_ROTATION);
        let is_noisy = !current.has_velocity() && next.ends_gap(current);
        let third = before[1].filter(|_| since_third < MAX_STENCIL_ROTATION && !is_noisy);
        let end = match (given(next), second, third) {
            (Some(given), ..) => given,
            (None, Some(second), Some(third)) if since_third < MAX_SERIES_ROTATION => {
                let rotations = self.rotations_back(&turn.vector);
                let points = [current, second, third];
                let offsets = [next.interval_s, current.interval_s, second.interval_s];
                self.derivatives_on_stencil(next, &earth_rate_b, &points, &offsets, &rotations)
            }
            _ => derivatives_at(next, &earth_rate_b, neighbours_behind(next, current, second, third)),
        };
        let start = self.settled.unwrap_or_else(|| {
            self.start_is_revised = true;
            let interval = next.interval_s;
            let ahead = Neighbour { v_e: next.state.v_e, offset_s: interval, rotation: turn.vector };
            let behind = before[0]
                .filter(|_| self.turns[0].angle < MAX_STENCIL_ROTATION)
                .map(|point| Neighbour::new(current, point, -current.interval_s));
            let far = before[0].zip(third).map(|(between, point)| {
                Neighbour::new(current, point, -current.interval_s - between.interval_s)
            });
            derivatives_at(current, &self.earth_rate_at(current), [Some(ahead), behind, far])
        });

        let rotation = against_inertial_space(&against_earth, &turn, &(earth_rate_b * next.interval_s));
        self.settled = (given(next).is_some() || third.is_some()).then_some(end);
        self.turns = [turn, self.turns[0]];
        IntervalMotion::new(current, next, &[start, end], &rotation, self.earth_rate)
    }

    /// Whether, since the last call, derivatives at the start of an interval differed from those at the end of the previous
    /// interval. This happens while there are few samples, because each new sample improves the derivatives.
    pub fn take_revised(&mut self) -> bool {
        core::mem::take(&mut self.start_is_revised)
    }

    /// Rotation vectors from the newest of four samples back to the three before, from the rotation vectors between neighbours.
    /// `turn` is the last of these.
    fn rotations_back(&self, turn: &Vector3<f64>) -> [Vector3<f64>; 3] {
        let first = -turn;
        let second = composed(&first, &-self.turns[0].vector);
        let third = composed(&second, &-self.turns[1].vector);
        [first, second, third]
    }

    /// Derivatives at `next` on the full stencil: `points` newest first, the intervals that end at `next`, at the first and
    /// at the second of them [s], and the rotation vectors to the points [rad].
    fn derivatives_on_stencil(
        &mut self,
        next: &TruthPoint,
        earth_rate_b: &Vector3<f64>,
        points: &[&TruthPoint; 3],
        intervals: &[f64; 3],
        rotations: &[Vector3<f64>; 3],
    ) -> Derivatives {
        if self.stencil.intervals != *intervals {
            self.stencil = Stencil::new(intervals);
        }
        let [w1, w2, w3] = self.stencil.weights;
        let v_e = &next.state.v_e;
        let [v1, v2, v3] = points.map(|point| point.state.v_e - v_e);
        let [r1, r2, r3] = rotations;
        Derivatives {
            a_e: next.a_e.unwrap_or(v1 * w1 + v2 * w2 + v3 * w3),
            omega_ib_b: next.omega_ib_b().unwrap_or(r1 * w1 + r2 * w2 + r3 * w3 + earth_rate_b),
        }
    }

    /// Earth rate in the sensor axes of a sample [rad/s].
    fn earth_rate_at(&self, point: &TruthPoint) -> Vector3<f64> {
        rotated_z(&point.state.q_eb.conjugate()) * self.earth_rate
    }
}

/// Weights of a full stencil.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Stencil {
    /// Lengths of its intervals [s], newest first.
    intervals: [f64; 3],
    /// Weights of the differences to the three points before [1/s].
    weights: [f64; 3],
}

impl Stencil {
    const NONE: Self = Self { intervals: [0.0; 3], weights: [0.0; 3] };

    fn new(intervals: &[f64; 3]) -> Self {
        let [a, b, c] = *intervals;
        Self { intervals: *intervals, weights: end_derivative_weights(&[-a, -a - b, -a - b - c]) }
    }
}

/// Rotation vector of exp(a) exp(b), by the series of Baker, Campbell and Hausdorff to the fourth order. The neglected term is |a|³
/// |a×b| / 720: in rates it is two orders of the interval below the error of a cubic through four points.
fn composed(a: &Vector3<f64>, b: &Vector3<f64>) -> Vector3<f64> {
    let c = a.cross(b);
    let ac = a.cross(&c);
    a + b + 0.5 * c + (ac - b.cross(&c)) * (1.0 / 12.0) - b.cross(&ac) * (1.0 / 24.0)
}

/// Rotation vector against inertial space: the rotation against the Earth, then the rotation of the Earth meanwhile, `earth_turn`,
/// in the axes at the end. Without a rotation against the Earth it is exactly `earth_turn`.
fn against_inertial_space(
    against_earth: &Quaternion<f64>,
    turn: &Turn,
    earth_turn: &Vector3<f64>,
) -> Vector3<f64> {
    if turn.angle < MAX_SMALL_TURN {
        let first_order = inverse_right_jacobian(&turn.vector, earth_turn);
        return turn.vector + first_order - earth_turn.cross(&turn.vector.cross(earth_turn)) * (1.0 / 12.0);
    }
    let earth_turn = rotation_increment(earth_turn);
    rotation_vector(&(against_earth + against_earth * earth_turn))
}
