//! Growth of the errors of a piece over a duration.
//!
//! The piece is flown N times end to end, N the smallest whole number of pieces that fills the duration D: each time the
//! algorithm errs as it did the first time, with the same sign. Over the τ = (N - 1) T after the first piece, of length T,
//! its worst errors p (position), v (velocity) and a (attitude against the Earth) are the start, and p/T, v/T and a/T are
//! steady rates, of which a part is counted twice: an attitude error has made some of v, and v some of p.
//!
//! The attitude error, in axes that do not know of the position, only adds up: a(D) = N a. The level channels are those of
//! Schuler's pendulum, ω² = g/R; its response to a velocity, to an acceleration and to one that grows is at most
//!
//! ```text
//! s = max sin(ωt)/ω,   c/ω² = max (1 - cos ωt)/ω²,   (τ - sin(ωτ)/ω)/ω²       over t = 0..τ
//! v(D) = v + (v/T + g a) s + (g a/T) c/ω² + p ω² s + p/T c + w
//! p(D) = p + (v + p/T + w) s + (v/T + g a) c/ω² + (g a/T) (τ - sin(ωτ)/ω)/ω²
//! ```
//!
//! with w = V' (N - 1) a what an attitude error brought along makes of the piece's change of velocity V'. A vertical channel
//! that is damped or follows the truth stays below that. Left free it has κ² = 2 g/R and adds, of any of the errors as if it
//! were all vertical and of the level velocity v(D) by Coriolis' and the centrifugal acceleration, d = 2 (W + V/R) v(D) at a
//! speed V,
//!
//! ```text
//! S = sinh(κτ)/κ,   C = cosh(κτ) - 1
//! v: v C + p κ² S + (v/T + d) S + p/T C + w C            p: p C + (v + p/T + w) S + (v/T + d) C/κ²
//! ```
//!
//! Over D ≤ T the errors are those of the piece. Not covered: a flight that is harder than its piece, and errors that turn
//! with Schuler's 84 minutes.

use super::{Piece, SolutionError};
use crate::math::{exp_m1, sin_cos};
use crate::mechanization::VerticalMode;

/// Gravity, above that of any place on the ellipsoid [m/s²].
const G: f64 = 9.84;
/// 1/ω above that of any place on the ellipsoid: √(6.400e6 m / 9.78 m/s²) [s].
const SCHULER_S: f64 = 809.0;
/// 1/κ below that of any place on the ellipsoid: √(6.335e6 m / (2 · 9.84 m/s²)) [s].
const VERTICAL_S: f64 = 567.0;
/// Earth's rate [rad/s] and, below its smallest radius of curvature, a radius [m].
const EARTH_RATE_RAD_S: f64 = 7.3e-5;
const RADIUS_M: f64 = 6.33e6;
/// κτ from which a free vertical channel has lost everything; beyond, the exponential would leave the range of numbers.
const MAX_EXPONENT: f64 = 300.0;
/// How much a whole number of pieces may be missed by: time stamps are rounded.
const ROUNDING: f64 = 1e-6;

/// How the errors of a piece grow: linear in each of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growth {
    piece_s: f64,
    /// N
    pieces: f64,
    /// s [s], c [1], (τ - sin(ωτ)/ω)/ω² [s³] of the level channels.
    level: [f64; 3],
    /// S [s] and C [1] of a free vertical channel, and 2 (W + V/R) [1/s].
    free: Option<[f64; 3]>,
    /// V' (N - 1) [m/s]
    turned_m_s: f64,
}

impl Growth {
    /// From `piece` to `duration_s` [s].
    pub fn new(piece: &Piece, duration_s: f64, vertical: VerticalMode) -> Self {
        let pieces = (duration_s / piece.duration_s - ROUNDING).ceil().max(1.0);
        let tau = (pieces - 1.0) * piece.duration_s;
        let x = tau / SCHULER_S;
        let (sin, cos) = sin_cos(x);
        let s = if x < core::f64::consts::FRAC_PI_2 { sin } else { 1.0 };
        let c = if x < core::f64::consts::PI { 1.0 - cos } else { 2.0 };
        let ramp = (tau - sin * SCHULER_S).max(0.0) * (SCHULER_S * SCHULER_S);
        let free = (vertical == VerticalMode::Free).then(|| {
            let x = (tau / VERTICAL_S).min(MAX_EXPONENT);
            let (up, down) = (exp_m1(x), exp_m1(-x));
            let coupling = 2.0 * (EARTH_RATE_RAD_S + piece.speed_m_s / RADIUS_M);
            [0.5 * (up - down) * VERTICAL_S, 0.5 * (up + down), coupling]
        });
        Self {
            piece_s: piece.duration_s,
            pieces,
            level: [s * SCHULER_S, c, ramp],
            free,
            turned_m_s: piece.velocity_change_m_s * (pieces - 1.0),
        }
    }

    /// What the worst errors of the piece become.
    pub fn of(&self, error: &SolutionError) -> SolutionError {
        let SolutionError { position_m: p, velocity_m_s: v, attitude_rad: a } = *error;
        let [s, c, ramp] = self.level;
        let (p_rate, v_rate, a_rate) = (p / self.piece_s, v / self.piece_s, a / self.piece_s);
        let schuler2 = SCHULER_S * SCHULER_S;
        let w = self.turned_m_s * a;
        let mut velocity_m_s =
            v + (v_rate + G * a) * s + G * a_rate * c * schuler2 + p / schuler2 * s + p_rate * c + w;
        let mut position_m = p + (v + p_rate + w) * s + (v_rate + G * a) * c * schuler2 + G * a_rate * ramp;
        if let Some([s, c, coupling]) = self.free {
            let vertical2 = VERTICAL_S * VERTICAL_S;
            let drive = v_rate + coupling * velocity_m_s;
            velocity_m_s += v * c + p / vertical2 * s + drive * s + p_rate * c + w * c;
            position_m += p * c + (v + p_rate + w) * s + drive * c * vertical2;
        }
        SolutionError { position_m, velocity_m_s, attitude_rad: self.pieces * a }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Responses of Schuler's pendulum (r' = v + u, v' = -ω² r + nabla + g a, a' = eps) to each steady rate alone, the worst
    /// until `t`: position, velocity, attitude.
    fn steady(source: usize, t: f64) -> SolutionError {
        let (omega, g) = (1.0 / 806.0, 9.8);
        let mut worst = SolutionError::default();
        for step in 0..=1000 {
            let t = t * f64::from(step) / 1000.0;
            let (sin, cos) = sin_cos(omega * t);
            let (s, c) = (sin / omega, (1.0 - cos) / (omega * omega));
            let (position, velocity, attitude) = match source {
                0 => (s, -omega * omega * c, 0.0),
                1 => (c, s, 0.0),
                _ => (g * (t - s) / (omega * omega), g * c, t),
            };
            worst.position_m = worst.position_m.max(position.abs());
            worst.velocity_m_s = worst.velocity_m_s.max(velocity.abs());
            worst.attitude_rad = worst.attitude_rad.max(attitude);
        }
        worst
    }

    /// Never less than what follows, and less than twice as much: what is counted twice is a part.
    #[test]
    fn steady_rates_are_predicted_from_below_twice() {
        for source in 0..3 {
            for duration_s in [60.0, 120.0, 300.0] {
                let piece = Piece { duration_s, speed_m_s: 0.0, velocity_change_m_s: 0.0 };
                let measured = steady(source, duration_s);
                for pieces in [1.0, 2.0, 5.0, 12.0, 30.0, 100.0] {
                    let growth = Growth::new(&piece, pieces * duration_s, VerticalMode::FollowTruth);
                    let (predicted, actual) = (growth.of(&measured), steady(source, pieces * duration_s));
                    for (predicted, actual) in [
                        (predicted.position_m, actual.position_m),
                        (predicted.velocity_m_s, actual.velocity_m_s),
                        (predicted.attitude_rad, actual.attitude_rad),
                    ] {
                        let bounds = (1.0 - 1e-9) * actual..=2.0 * actual;
                        assert!(
                            bounds.contains(&predicted),
                            "{source} {duration_s} {pieces}: {predicted} {actual}"
                        );
                    }
                }
            }
        }
    }
}
