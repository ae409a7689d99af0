//! Growth of the errors of a piece over a duration.
//!
//! The piece, of length T, is flown N times end to end; N is the smallest number of pieces that fills the duration. Each time the
//! algorithm makes the same errors, with the same sign. Let p, v and a be its worst errors of position, velocity and attitude in
//! the first piece. Over the rest, τ = (N - 1) T, they are the initial errors, and p/T, v/T and a/T are steady inputs. A part of
//! them counts twice, because an attitude error has caused some of v, and v some of p.
//!
//! The attitude error relative to the Earth adds up to N a. It turns the change of velocity within a piece, V', into the velocity
//! error w = V' (N - 1) a, and gravity into a horizontal acceleration. An error x of position then follows
//!
//! ```text
//! x'' = -ω² x + f,   x(0) = p,   x'(0) = v + w + p/T,   f = v/T + g a + g a t/T        Schuler's pendulum, ω² = g/R
//! x'' = +κ² x + d,   the same start,                    d = v/T + 2 (W + V/R) v_level     a free vertical channel, κ² = 2 g/R
//! ```
//!
//! and its velocity error is x' - p/T. The term with 2 (W + V/R) has the accelerations of Coriolis and of the path's curvature at
//! the speed V. With
//!
//! ```text
//! s = max sin(ωt)/ω,   c = max (1 - cos ωt),   r = (τ - sin(ωτ)/ω)/ω²   over t = 0..τ
//! S = sinh(κτ)/κ,      C = cosh(κτ) - 1
//! ```
//!
//! the largest errors are at most the sums of the responses to each input. [`Growth::of`] adds them. A vertical channel that is
//! damped or follows the truth stays below the horizontal ones. Each error counts as if it were all horizontal and all vertical.
//!
//! If the duration is not longer than the piece, the errors are those of the piece. A flight that is harder than its piece, and
//! errors that turn with Schuler's 84 minutes, can be larger than this.

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
/// Limit of κτ: a free vertical channel has diverged there, and the exponential function stays in the range of numbers.
const MAX_EXPONENT: f64 = 300.0;
/// Part of a piece by which the duration may exceed a whole number of pieces: time stamps are rounded.
const ROUNDING: f64 = 1e-6;

/// Response of a channel after the first piece: a pendulum, or a channel that diverges.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Channel {
    /// 1/ω or 1/κ [s]
    time_s: f64,
    /// s or S [s]
    sine_s: f64,
    /// c or C
    cosine: f64,
}

impl Channel {
    /// Position and velocity that the inputs add: position `p`, steady velocity `p_rate`, initial velocity `v`, steady
    /// acceleration `f`.
    fn response(&self, p: f64, p_rate: f64, v: f64, f: f64) -> (f64, f64) {
        let Self { time_s, sine_s, cosine } = *self;
        let time2 = time_s * time_s;
        ((v + p_rate) * sine_s + f * cosine * time2, (f + p / time2) * sine_s + p_rate * cosine)
    }
}

/// How the errors of a piece grow: linear in each of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growth {
    /// T [s]
    piece_s: f64,
    /// N
    pieces: f64,
    /// V' (N - 1) [m/s]
    turned_m_s: f64,
    level: Channel,
    /// r [s³]
    ramp_s3: f64,
    /// A free vertical channel, and 2 (W + V/R) [1/s].
    free: Option<(Channel, f64)>,
}

impl Growth {
    /// From `piece` to `duration_s` [s].
    pub fn new(piece: &Piece, duration_s: f64, vertical: VerticalMode) -> Self {
        let pieces = (duration_s / piece.duration_s - ROUNDING).ceil().max(1.0);
        let tau = (pieces - 1.0) * piece.duration_s;
        let x = tau / SCHULER_S;
        let (sin, cos) = sin_cos(x);
        let level = Channel {
            time_s: SCHULER_S,
            sine_s: SCHULER_S * if x < core::f64::consts::FRAC_PI_2 { sin } else { 1.0 },
            cosine: if x < core::f64::consts::PI { 1.0 - cos } else { 2.0 },
        };
        let free = (vertical == VerticalMode::Free).then(|| {
            let x = (tau / VERTICAL_S).min(MAX_EXPONENT);
            let (up, down) = (exp_m1(x), exp_m1(-x));
            let [sine_s, cosine] = [0.5 * (up - down) * VERTICAL_S, 0.5 * (up + down)];
            let coupling = 2.0 * (EARTH_RATE_RAD_S + piece.speed_m_s / RADIUS_M);
            (Channel { time_s: VERTICAL_S, sine_s, cosine }, coupling)
        });
        Self {
            piece_s: piece.duration_s,
            pieces,
            turned_m_s: piece.velocity_change_m_s * (pieces - 1.0),
            level,
            ramp_s3: (tau - sin * SCHULER_S).max(0.0) * (SCHULER_S * SCHULER_S),
            free,
        }
    }

    /// The worst errors over the duration, from those of the piece.
    pub fn of(&self, error: &SolutionError) -> SolutionError {
        let SolutionError { position_m: p, velocity_m_s: v, attitude_rad: a } = *error;
        let [p_rate, v_rate, tilt_rate] = [p, v, G * a].map(|error| error / self.piece_s);
        let start = v + self.turned_m_s * a;
        let (position, velocity) = self.level.response(p, p_rate, start, v_rate + G * a);
        let mut position_m = p + position + tilt_rate * self.ramp_s3;
        let mut velocity_m_s = start + velocity + tilt_rate * self.level.cosine * (SCHULER_S * SCHULER_S);
        if let Some((channel, coupling)) = &self.free {
            let (position, velocity) = channel.response(p, p_rate, start, v_rate + coupling * velocity_m_s);
            position_m += position + p * channel.cosine;
            velocity_m_s += velocity + start * channel.cosine;
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
                let piece = Piece { duration_s, ..Piece::default() };
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
