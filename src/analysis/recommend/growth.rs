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
//! x'' = -ω² x + f + j t,   x(0) = p,   x'(0) = v + w + p/T,   f = v/T + g a,   j = g a/T       Schuler's pendulum, ω² = g/R
//! x'' = +κ² x + d,         the same start,                    d = v/T + 2 (W + V/R) v_level    a free vertical channel, κ² = 2 g/R
//! ```
//!
//! and its velocity error is x' - p/T. The term with 2 (W + V/R) has the accelerations of Coriolis and of the path's curvature at
//! the speed V and the velocity error v_level of the pendulum. The largest errors are at most the sums of the responses to each input.
//! With the largest values over t = 0..τ of
//!
//! ```text
//! pendulum       s = sin(ωt)/ω     c = 1 - cos ωt      1 of cos ωt       r = (t - sin(ωt)/ω)/ω²
//! free channel   s = sinh(κt)/κ    c = cosh κt - 1     1 + c of cosh κt
//! ```
//!
//! they are, for each channel with its 1/ω or 1/κ = σ,
//!
//! ```text
//! position   p (1 or 1 + c)       + (v + w + p/T) s + f c σ²     + j r       of the pendulum
//! velocity   (v + w) (1 or 1 + c) + (f + p/σ²) s    + (p/T) c    + j c σ²    of the pendulum
//! ```
//!
//! Each error counts as if it were all horizontal and all vertical: the errors of both channels are added, the initial ones once. A
//! vertical channel that is damped or follows the truth stays below the horizontal ones.
//!
//! If the duration is not longer than the piece, the errors are those of the piece. A flight that is harder than its piece, and
//! errors that turn with Schuler's 84 minutes, can be larger than this.

use super::{Piece, SolutionError};
use crate::base::math::{exp_m1, sin_cos};
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

/// A channel after the first piece: the pendulum, or the free vertical channel.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Channel {
    /// σ² [s²]
    sigma2: f64,
    /// s [s]
    sine_s: f64,
    /// c
    cosine: f64,
}

impl Channel {
    fn pendulum(tau: f64) -> Self {
        let x = tau / SCHULER_S;
        let (sin, cos) = sin_cos(x);
        Self {
            sigma2: SCHULER_S * SCHULER_S,
            sine_s: SCHULER_S * if x < core::f64::consts::FRAC_PI_2 { sin } else { 1.0 },
            cosine: if x < core::f64::consts::PI { 1.0 - cos } else { 2.0 },
        }
    }

    fn free(tau: f64) -> Self {
        let x = (tau / VERTICAL_S).min(MAX_EXPONENT);
        let (up, down) = (exp_m1(x), exp_m1(-x));
        Self {
            sigma2: VERTICAL_S * VERTICAL_S,
            sine_s: 0.5 * (up - down) * VERTICAL_S,
            cosine: 0.5 * (up + down),
        }
    }

    /// Position and velocity in addition to the initial ones, `p` and `v`: by these, by the steady velocity `p_rate`, and by the
    /// steady acceleration `f`. Without the parts p c and v c of a free channel.
    fn response(&self, p: f64, p_rate: f64, v: f64, f: f64) -> (f64, f64) {
        let Self { sigma2, sine_s, cosine } = *self;
        ((v + p_rate) * sine_s + f * cosine * sigma2, (f + p / sigma2) * sine_s + p_rate * cosine)
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
    /// r of the pendulum [s³]
    ramp_s3: f64,
    /// A free vertical channel, and 2 (W + V/R) [1/s].
    free: Option<(Channel, f64)>,
}

impl Growth {
    /// From `piece` to `duration_s` [s].
    pub fn new(piece: &Piece, duration_s: f64, vertical: VerticalMode) -> Self {
        let pieces = (duration_s / piece.duration_s - ROUNDING).ceil().max(1.0);
        let tau = (pieces - 1.0) * piece.duration_s;
        let sine_at_end_s = sin_cos(tau / SCHULER_S).0 * SCHULER_S;
        let coupling = 2.0 * (EARTH_RATE_RAD_S + piece.speed_m_s / RADIUS_M);
        Self {
            piece_s: piece.duration_s,
            pieces,
            turned_m_s: piece.velocity_change_m_s * (pieces - 1.0),
            level: Channel::pendulum(tau),
            ramp_s3: (tau - sine_at_end_s).max(0.0) * (SCHULER_S * SCHULER_S),
            free: (vertical == VerticalMode::Free).then(|| (Channel::free(tau), coupling)),
        }
    }

    /// The worst errors over the duration, from those of the piece.
    pub fn of(&self, error: &SolutionError) -> SolutionError {
        let SolutionError { position_m: p, velocity_m_s: v, attitude_rad: a } = *error;
        let [p_rate, v_rate, jerk] = [p, v, G * a].map(|error| error / self.piece_s);
        let v = v + self.turned_m_s * a;
        let Channel { sigma2, cosine, .. } = self.level;
        let (position, velocity) = self.level.response(p, p_rate, v, v_rate + G * a);
        let mut position_m = p + position + jerk * self.ramp_s3;
        let mut velocity_m_s = v + velocity + jerk * cosine * sigma2;
        if let Some((channel, coupling)) = &self.free {
            let (position, velocity) = channel.response(p, p_rate, v, v_rate + coupling * velocity_m_s);
            position_m += position + p * channel.cosine;
            velocity_m_s += velocity + v * channel.cosine;
        }
        SolutionError { position_m, velocity_m_s, attitude_rad: self.pieces * a }
    }
}
