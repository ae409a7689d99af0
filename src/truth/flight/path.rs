//! Position: the integral of the velocity over the ellipsoid, piece by piece.

use nalgebra::{Quaternion, Vector3, Vector4};

use super::FlightStart;
use super::profile::Segment;
use crate::base::error::{Error, ErrorKind, Rule};
use crate::base::math::{inverse_right_jacobian, rotated_z, rotation_quaternion, sin_cos};
use crate::base::memory::room_for_one_more;
use crate::earth::{Earth, navigation_axes};
use crate::truth::{FlightSample, check_height};

/// Chebyshev coefficients of a piece.
const N: usize = 16;
/// Longest piece, and shortest piece [s]: a flight that needs shorter ones is rejected as too rapid.
const MAX_PIECE_S: f64 = 600.0;
const MIN_PIECE_S: f64 = 1e-4;
/// Largest number of pieces of a flight: 110 MB.
const MAX_PIECES: usize = 200_000;
/// Largest size of the last coefficients of a piece: 1e-16 rad and 1e-9 m of height.
const TAIL_RAD: f64 = 1e-16;
const TAIL_M: f64 = 1e-9;

/// A piece of the path: carried axes and height as Chebyshev series of the time within it.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    start_s: f64,
    length_s: f64,
    /// Carried axes to Earth-fixed axes at its start.
    q_ew: Quaternion<f64>,
    /// Rotation vector since the start [rad], height since the start [m].
    series: [Vector4<f64>; N],
    height_m: f64,
}

/// The whole path.
#[derive(Debug, Clone)]
pub(super) struct Path {
    pieces: Vec<Piece>,
}

/// Chebyshev nodes on 0..1 and the matrices of the method.
struct Basis {
    nodes: [f64; N],
    /// Values at the nodes to coefficients.
    analysis: [[f64; N]; N],
}

impl Basis {
    fn new() -> Self {
        let angle = |j: usize| core::f64::consts::PI * (j as f64 + 0.5) / N as f64;
        let nodes = core::array::from_fn(|j| 0.5 - 0.5 * sin_cos(angle(j)).1);
        let analysis = core::array::from_fn(|k| {
            core::array::from_fn(|j| {
                // T_k at the node cos(π - angle).
                let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
                let scale = if k == 0 { 1.0 } else { 2.0 } / N as f64;
                sign * scale * sin_cos(k as f64 * angle(j)).1
            })
        });
        Self { nodes, analysis }
    }

    /// Series of the integral from 0, over a piece of length `length`, of the function with `values` at the nodes.
    fn integral(&self, values: &[Vector4<f64>; N], length: f64) -> [Vector4<f64>; N] {
        let c: [Vector4<f64>; N] = core::array::from_fn(|k| {
            values
                .iter()
                .zip(&self.analysis[k])
                .fold(Vector4::zeros(), |sum, (value, &weight)| sum + value * weight)
        });
        // ∫T_k = T_{k+1}/(2(k+1)) - T_{k-1}/(2(k-1)) on -1..1; half the length on 0..1.
        let at = |k: usize| if k < N { c[k] } else { Vector4::zeros() };
        let mut series: [Vector4<f64>; N] = core::array::from_fn(|k| match k {
            0 => Vector4::zeros(),
            1 => (c[0] - at(2) * 0.5) * (0.5 * length),
            _ => (c[k - 1] - at(k + 1)) * (0.25 * length / k as f64),
        });
        // The constant makes it vanish at 0, where T_k = (-1)^k.
        series[0] = (1..N)
            .fold(Vector4::zeros(), |sum, k| if k % 2 == 0 { sum - series[k] } else { sum + series[k] });
        series
    }
}

/// Clenshaw's sum at `u` in 0..1.
fn evaluate(series: &[Vector4<f64>; N], u: f64) -> Vector4<f64> {
    let x = 2.0 * u - 1.0;
    let (mut b1, mut b2) = (Vector4::zeros(), Vector4::zeros());
    for coefficient in series[1..].iter().rev() {
        (b1, b2) = (coefficient + b1 * (2.0 * x) - b2, b1);
    }
    series[0] + b1 * x - b2
}

impl Path {
    /// The path from `start` through `segments`.
    pub fn integrate(earth: &Earth, start: &FlightStart, segments: &[Segment]) -> Result<Self, Error> {
        let basis = Basis::new();
        let mut pieces = Vec::new();
        let mut q_ew = navigation_axes(start.latitude_rad, start.longitude_rad);
        let mut height_m = start.height_m;
        for (index, segment) in segments.iter().enumerate() {
            let [knots @ .., end] = segment.knots();
            for (i, &from) in knots.iter().enumerate() {
                let to = if i + 1 < knots.len() { knots[i + 1] } else { end };
                let mut t = from;
                let mut length = to - from;
                while t < to {
                    let limit = if segment.is_rest() { f64::INFINITY } else { MAX_PIECE_S };
                    length = length.min(limit).min(to - t);
                    // No very short piece at the end.
                    if to - t - length < 1e-9 * length {
                        length = to - t;
                    }
                    let Some(piece) = Piece::solve(earth, &basis, segment, t, length, q_ew, height_m) else {
                        length *= 0.5;
                        if length < MIN_PIECE_S {
                            let rule = Rule::Sentence(
                                "the motion at this time is too fast: the path cannot be integrated to rounding accuracy",
                            );
                            return Err(Error::invalid("time_s", segment.start_s + t, rule));
                        }
                        continue;
                    };
                    piece.check_height().map_err(|error| error.at(index))?;
                    (q_ew, height_m) = piece.at(1.0);
                    t = if length == to - t { to } else { t + length };
                    if pieces.len() == MAX_PIECES {
                        let rule = Rule::Sentence("the flight needs too much memory; shorten it");
                        return Err(Error::of(ErrorKind::OutOfMemory, "pieces", pieces.len(), rule));
                    }
                    room_for_one_more(&mut pieces)?;
                    pieces.push(piece);
                    length *= 1.5;
                }
            }
        }
        Ok(Self { pieces })
    }

    /// Carried axes to Earth-fixed axes, and height [m], at `time_s` of the flight.
    pub fn at(&self, time_s: f64) -> (Quaternion<f64>, f64) {
        let after = self.pieces.partition_point(|piece| piece.start_s <= time_s);
        let piece = &self.pieces[after.saturating_sub(1)];
        piece.at(((time_s - piece.start_s) / piece.length_s).min(1.0))
    }
}

impl Piece {
    fn at(&self, u: f64) -> (Quaternion<f64>, f64) {
        let moved = evaluate(&self.series, u);
        let q = self.q_ew * rotation_quaternion(&moved.xyz());
        (q / q.norm_squared().sqrt(), self.height_m + moved.w)
    }

    /// Rejects a piece with heights that no flight sample may have.
    fn check_height(&self) -> Result<(), Error> {
        let swing = self.series.iter().map(|coefficient| coefficient.w.abs()).sum::<f64>();
        let (low, high) = FlightSample::HEIGHT_RANGE_M;
        if low <= self.height_m - swing && self.height_m + swing <= high {
            return Ok(());
        }
        for side in [1.0, -1.0] {
            check_height("height reached in manoeuvre", self.at(self.extreme(side)).1)?;
        }
        Ok(())
    }

    /// Time at which the piece is highest, or with a side of -1 lowest: found between two of equally spaced nodes by ternary search.
    fn extreme(&self, side: f64) -> f64 {
        const NODES: u32 = 64;
        let height = |u: f64| side * self.at(u).1;
        let nodes = (0..=NODES).map(|node| f64::from(node) / f64::from(NODES));
        let best = nodes.max_by(|a, b| height(*a).total_cmp(&height(*b))).unwrap_or(0.0);
        let (mut low, mut high) =
            ((best - 1.0 / f64::from(NODES)).max(0.0), (best + 1.0 / f64::from(NODES)).min(1.0));
        // (2/3)^64 of the distance of two nodes is less than the rounding of the time.
        for _ in 0..64 {
            let third = (high - low) / 3.0;
            if height(low + third) < height(high - third) {
                low += third;
            } else {
                high -= third;
            }
        }
        low
    }

    /// Picard iteration on ρ' = J⁻¹(ρ) ω(ρ, h, t), h' = v_up. `None`: the series does not resolve the motion.
    fn solve(
        earth: &Earth,
        basis: &Basis,
        segment: &Segment,
        from_s: f64,
        length_s: f64,
        q_ew: Quaternion<f64>,
        height_m: f64,
    ) -> Option<Self> {
        let start_s = segment.start_s + from_s;
        let mut piece = Self { start_s, length_s, q_ew, series: [Vector4::zeros(); N], height_m };
        if segment.is_rest() {
            return Some(piece);
        }
        let velocity = basis.nodes.map(|u| segment.at(start_s + u * length_s).velocity());
        for _ in 0..20 {
            let rates = core::array::from_fn(|j| {
                let moved = evaluate(&piece.series, basis.nodes[j]);
                let rho = moved.xyz();
                let omega = transport_rate(
                    earth,
                    &(q_ew * rotation_quaternion(&rho)),
                    height_m + moved.w,
                    &velocity[j],
                );
                inverse_right_jacobian(&rho, &omega).push(velocity[j].z)
            });
            let series = basis.integral(&rates, length_s);
            let change =
                series.iter().zip(&piece.series).map(|(a, b)| (a - b).xyz().amax()).fold(0.0, f64::max);
            piece.series = series;
            if change < 0.1 * TAIL_RAD {
                break;
            }
        }
        let tail = piece.series[N - 2].abs() + piece.series[N - 1].abs();
        (tail.xyz().max() < TAIL_RAD && tail.w < TAIL_M).then_some(piece)
    }
}

/// Rate of the carried axes against the Earth for the velocity `v_w`, both in carried axes: no component up.
fn transport_rate(earth: &Earth, q_ew: &Quaternion<f64>, height_m: f64, v_w: &Vector3<f64>) -> Vector3<f64> {
    let axis = rotated_z(&q_ew.conjugate());
    let (inverse_n, meridian_excess) = earth.curvature_terms(axis.z, height_m);
    let along_meridian = (axis.x * v_w.x + axis.y * v_w.y) * meridian_excess;
    Vector3::new(
        -(v_w.y * inverse_n + along_meridian * axis.y),
        v_w.x * inverse_n + along_meridian * axis.x,
        0.0,
    )
}
