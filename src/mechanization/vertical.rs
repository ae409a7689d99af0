//! The vertical channel: by itself it is unstable (e-fold 569 s), so it is damped by a barometric height or held to the
//! truth.

use crate::earth::Earth;
use crate::math::exp_m1;
use crate::snapshot::{codes, stored};
use crate::state::EarthFixedState;
use crate::truth::INTERVALS_S;

/// How the vertical channel is kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum VerticalMode {
    /// Third-order loop on a barometric height.
    #[default]
    Damped,
    /// Height and vertical velocity set to the truth at each sample.
    FollowTruth,
    /// Left to itself.
    Free,
}

codes!(VerticalMode { Damped = 0, FollowTruth = 1, Free = 2 });

/// What the vertical channel is told at the end of an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum VerticalAid {
    /// Nothing.
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
    /// What the aid of the point at `from` says of a point of the same vehicle, which the solution has at `to`.
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
/// h' = v - c1 e, v' = a - c2 e - d, d' = c3 e; c1 = 3/τ, c2 = 3/τ² + 2 g/R, c3 = 1/τ³: all three poles at -1/τ.
///
/// In steps of t with the gains whose poles are those of the continuous loop, exp(-t/τ), so that no interval is too long:
/// with q = 1 - exp(-t/τ), c1 t = q (3 - 3 q + q²), c2 t = 3/2 q² (2 - q)/t + 2 g/R t, c3 t = q³/t².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VerticalLoop {
    /// d, the estimate of the vertical channel's constant error [m/s²].
    bias_m_s2: f64,
    /// Length of the interval [s] that the gains c1 t [1], c2 t [1/s], c3 t [1/s²] are for; 0: for none yet.
    t: f64,
    gains: [f64; 3],
}

stored!(VerticalLoop { bias_m_s2: 1e30, t: INTERVALS_S.1 } rebuilt { gains } then |channel, from| {
    from.require(channel.t == 0.0 || channel.t >= INTERVALS_S.0, channel.t, "is no interval")?;
    if channel.t > 0.0 {
        channel.set_interval(channel.t);
    }
    Ok(())
});

/// Corrections of the vertical channel over one interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VerticalCorrection {
    /// To the height [m].
    pub height_m: f64,
    /// To the velocity up [m/s].
    pub velocity_up_m_s: f64,
    /// Displacement within the interval [m] that the correction of the velocity stands for, where that was wrong by a
    /// share that grew evenly from 0; 0 where the correction is a feedback.
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
    /// 2 g/R [1/s²], which makes the free channel unstable.
    const GRAVITY_GRADIENT: f64 = 3.08e-6;

    /// A loop that has found no error yet.
    pub fn new() -> Self {
        Self { bias_m_s2: 0.0, t: 0.0, gains: [0.0; 3] }
    }

    /// Corrections for a residual `residual_m` = height - barometric height over an interval `t` [s].
    #[inline]
    pub fn correct(&mut self, residual_m: f64, t: f64) -> VerticalCorrection {
        // Time stamps differ in their last digits.
        if (t - self.t).abs() > 1e-7 * t {
            self.set_interval(t);
        }
        let [c1, c2, c3] = self.gains;
        let correction = VerticalCorrection {
            height_m: -c1 * residual_m,
            velocity_up_m_s: -(c2 * residual_m + self.bias_m_s2 * t),
            displacement_m: 0.0,
        };
        self.bias_m_s2 += c3 * residual_m;
        correction
    }

    #[cold]
    fn set_interval(&mut self, t: f64) {
        let q = -exp_m1(-t / Self::TIME_CONSTANT_S);
        self.t = t;
        self.gains = [
            q * (3.0 - q * (3.0 - q)),
            1.5 * q * q * (2.0 - q) / t + Self::GRAVITY_GRADIENT * t,
            q * q * q / (t * t),
        ];
    }
}

impl Default for VerticalLoop {
    fn default() -> Self {
        Self::new()
    }
}
