//! The vertical channel. A free channel is unstable (e-fold 569 s), so a barometric height damps it, or it is held to the truth.

use crate::base::math::exp_m1;
use crate::base::snapshot::{codes, stored};
use crate::earth::Earth;
use crate::earth::state::EarthFixedState;
use crate::truth::INTERVALS_S;

/// What stabilizes the vertical channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum VerticalMode {
    /// Third-order loop on a barometric height, time constant 100 s. Its response to an error of the vertical accelerometer differs
    /// from that of a continuous loop by the fraction 3.5e-5 at a sample rate of 1 Hz, and its response to an initial velocity error by
    /// 6.5e-4. Both are of second order in the sample interval: 3.5e-7 and 6.5e-6 at 10 Hz.
    #[default]
    Damped,
    /// Height and vertical velocity set to the truth at each sample.
    FollowTruth,
    /// Nothing stabilizes the vertical channel: any error grows e-fold every 569 s.
    Free,
}

codes!(VerticalMode { Damped = 0 "damped", FollowTruth = 1 "follow", Free = 2 "free" });

/// Aid of the vertical channel at the end of an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum VerticalAid {
    /// No aid: the channel is free.
    None,
    /// The truth: height [m] and velocity up [m/s].
    Truth {
        /// Height above the ellipsoid [m].
        height_m: f64,
        /// Velocity up [m/s].
        velocity_up_m_s: f64,
    },
    /// A barometric height [m].
    Barometer {
        /// Height above the ellipsoid [m].
        height_m: f64,
    },
}

/// Height [m] and velocity up [m/s] of a point of the vehicle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VerticalState {
    /// Above the ellipsoid [m].
    pub height_m: f64,
    /// [m/s]
    pub velocity_up_m_s: f64,
}

impl VerticalState {
    /// Of `state`.
    pub fn of(earth: &Earth, state: &EarthFixedState) -> Self {
        let vertical = earth.vertical(&state.r_e);
        Self { height_m: vertical.height_m, velocity_up_m_s: vertical.up_e.dot(&state.v_e) }
    }
}

impl VerticalAid {
    /// The aid of the point at `from`, converted to the point of the same vehicle whose solution is `to`.
    pub fn moved(self, from: &VerticalState, to: &VerticalState) -> Self {
        let up = to.height_m - from.height_m;
        match self {
            Self::None => self,
            Self::Barometer { height_m } => Self::Barometer { height_m: height_m + up },
            Self::Truth { height_m, velocity_up_m_s } => Self::Truth {
                height_m: height_m + up,
                velocity_up_m_s: velocity_up_m_s + (to.velocity_up_m_s - from.velocity_up_m_s),
            },
        }
    }
}

/// Third-order barometric loop (Kayton and Fried 1997, §7.5): with e = height - barometric height,
/// h' = v - c1 e, v' = a - c2 e - d, d' = c3 e; c1 = 3/τ, c2 = 3/τ² + κ, c3 = 1/τ³: all three poles at -1/τ, where κ = 2 g/R
/// of gravity makes the free channel unstable.
///
/// In steps of any length t: between two samples the navigator is free, and e'' = κ e + d, if d is its only error. The residuals e0
/// and e1 at both ends give e' at the start. From there the loop would move (e, e', d) by Φ of its poles, and the free channel
/// moves them by F. The correction is Φ - F applied to (e0, e0'), less the effect of d:
/// ```text
/// F = | C    S  |    Φ = exp(-x) | 1 - 2 x + x²/2    t (1 - x/2) |    e0' = (e1 - C e0 - d (C - 1)/κ)/S
///     | κ S  C  |                | (x² - 3 x)/τ      1 + x - x²  |    by d: d (C - 1)/κ in height,
///     | 0    0  |                | (x - x²/2)/τ²     x²/(2 τ)    |          d S in velocity
/// ```
/// x = t/τ, C = cosh(√κ t), S = sinh(√κ t)/√κ. An acceleration a that is not yet in d also bends e within the interval. The loop
/// misses it by (a - d) t²/12, which is of second order (`tests/physics/vertical_loop.rs`). If there was no residual before, e0 is
/// e1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VerticalLoop {
    /// d, the estimate of the vertical channel's constant error [m/s²].
    pub(super) bias_m_s2: f64,
    /// e at the last sample, as corrected [m].
    pub(super) residual_m: f64,
    pub(super) gains: Gains,
}

stored!(VerticalLoop { bias_m_s2: 1e30, residual_m: 1e30, gains });

/// Gains of the loop for an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Gains {
    /// Length of the interval [s]; 0: there was no residual before, and there are no gains.
    pub t: f64,
    /// Rows for the corrections of height [m] and velocity [m/s] and for the change of d [m/s²], of e0, e1 and d.
    rows: [[f64; 3]; 3],
}

stored!(Gains { t: INTERVALS_S.1 } rebuilt { rows } then |gains, from| {
    from.require(gains.t == 0.0 || gains.t >= INTERVALS_S.0, gains.t, "is no interval")?;
    *gains = Gains::new(gains.t);
    Ok(())
});

/// Corrections of the vertical channel over one interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VerticalCorrection {
    /// To the height [m].
    pub height_m: f64,
    /// To the velocity up [m/s].
    pub velocity_up_m_s: f64,
    /// Displacement within the interval [m] that corresponds to the correction of the velocity, if the velocity error grew evenly
    /// from 0; 0 if the correction is a feedback.
    pub displacement_m: f64,
}

impl VerticalCorrection {
    /// Sets height and velocity to the truth: `height_m` and `velocity_up_m_s` are truth less computed, over an interval
    /// `t` [s].
    ///
    /// Evidence for the displacement: without its Coriolis integral an accelerometer bias of 1e-5 g up at 100 Hz costs
    /// 5e-7 m east in 120 s.
    pub fn to_truth(height_m: f64, velocity_up_m_s: f64, t: f64) -> Self {
        Self { height_m, velocity_up_m_s, displacement_m: 0.5 * velocity_up_m_s * t }
    }
}

impl VerticalLoop {
    /// τ [s]
    pub const TIME_CONSTANT_S: f64 = 100.0;
    /// κ = 2 g/R [1/s²].
    pub const GRAVITY_GRADIENT: f64 = 3.08e-6;

    /// A loop that has found no error yet.
    pub fn new() -> Self {
        Self { bias_m_s2: 0.0, residual_m: 0.0, gains: Gains::NONE }
    }

    /// Corrections for a residual `residual_m` = height - barometric height at the end of an interval `t` [s].
    #[inline]
    pub fn correct(&mut self, residual_m: f64, t: f64) -> VerticalCorrection {
        if self.gains.begin(t) {
            self.residual_m = residual_m;
        }
        self.answer(residual_m)
    }

    /// The corrections, after [`Gains::begin`] for the interval.
    #[inline(always)]
    pub(super) fn answer(&mut self, residual_m: f64) -> VerticalCorrection {
        let [height_m, velocity_up_m_s, bias_m_s2] = self
            .gains
            .rows
            .map(|[start, end, bias]| start * self.residual_m + end * residual_m + bias * self.bias_m_s2);
        self.bias_m_s2 += bias_m_s2;
        self.residual_m = residual_m + height_m;
        VerticalCorrection { height_m, velocity_up_m_s, displacement_m: 0.0 }
    }

    /// No barometric height at the end of an interval: the next residual has none before it.
    #[inline]
    pub fn skip(&mut self) {
        self.gains.t = 0.0;
    }

    /// Begins anew if its estimate is beyond `limit_m_s2`.
    pub(crate) fn limit_bias(&mut self, limit_m_s2: f64) {
        if self.bias_m_s2.abs() > limit_m_s2 {
            *self = Self::new();
        }
    }

    /// Its estimate [m/s²] and its last residual [m].
    pub(crate) fn states(&self) -> [f64; 2] {
        [self.bias_m_s2, self.residual_m]
    }

    /// The same loop in other states.
    #[inline(always)]
    pub(crate) fn with_states(&self, [bias_m_s2, residual_m]: [f64; 2]) -> Self {
        Self { bias_m_s2, residual_m, ..*self }
    }
}

impl Gains {
    pub const NONE: Self = Self { t: 0.0, rows: [[0.0; 3]; 3] };

    /// Takes the length `t` [s] of the interval that ends. Returns whether there was no residual before.
    #[inline(always)]
    pub fn begin(&mut self, t: f64) -> bool {
        // Intervals of one rate differ in the last digits of their time stamps.
        let is_other = (t - self.t).abs() > 1e-7 * t;
        let is_first = is_other && self.t == 0.0;
        if is_other {
            *self = Self::new(t);
        }
        is_first
    }

    /// Gains for an interval of length `t` [s]; 0: none.
    #[cold]
    pub fn new(t: f64) -> Self {
        if t == 0.0 {
            return Self::NONE;
        }
        let lambda = 1.0 / VerticalLoop::TIME_CONSTANT_S;
        let (x, kappa) = (t * lambda, VerticalLoop::GRAVITY_GRADIENT);
        // 1 is subtracted, so that the differences of short intervals keep their digits.
        let decay_less_1 = exp_m1(-x);
        let decay = 1.0 + decay_less_1;
        let growth_less_1 = exp_m1(kappa.sqrt() * t);
        let growth = 1.0 + growth_less_1;
        let cosh_less_1 = growth_less_1 * growth_less_1 / (2.0 * growth);
        let sinh = 0.5 * (growth_less_1 + growth_less_1 / growth) / kappa.sqrt();
        // exp(-x) (1 + y) - 1
        let decayed = |y: f64| decay_less_1 + decay * y;
        let half_x2 = 0.5 * x * x;
        // Rows of Φ - F, and the effect of d on the free channel.
        let rows = [
            (
                decayed(half_x2 - 2.0 * x) - cosh_less_1,
                decay * t * (1.0 - 0.5 * x) - sinh,
                cosh_less_1 / kappa,
            ),
            (decay * lambda * (x * x - 3.0 * x) - kappa * sinh, decayed(x - x * x) - cosh_less_1, sinh),
            (decay * lambda * lambda * (x - half_x2), decay * lambda * half_x2, 0.0),
        ];
        let rows = rows.map(|(of_e, of_rate, by_bias)| {
            let end = of_rate / sinh;
            [of_e - end * (1.0 + cosh_less_1), end, -by_bias - end * cosh_less_1 / kappa]
        });
        Self { t, rows }
    }
}

impl Default for VerticalLoop {
    fn default() -> Self {
        Self::new()
    }
}
