//! Size effect: accelerometers that do not sit at one point.

use nalgebra::{Matrix3, Vector3};

use super::super::kept::Kept;
use super::super::parameters::TriadParameters;
use super::super::stream::EffectStreams;
use super::effect::{Conditions, Effect, OnInput};
use crate::base::snapshot::{SIGNALS, stored};
use crate::signal::mounting::{centripetal, lever_arm_velocity};
use crate::signal::{MAX_INCREMENTS, Turning};
use crate::truth::INTERVALS_S;

/// Accelerometer i at r_i senses along its axis the force f_i of the block's own point plus (ω'×r_i + ω×(ω×r_i))_i (Savage 1998,
/// part 2; Titterton and Weston). [`lever_arm_velocity`] is the integral of the additional part over an increment. ω at the ends of
/// the increment comes from the motion that the increment belongs to.
///
/// For foreign increments, ω at the end of an increment is the derivative of a cubic through four angles: at this end and at the
/// ends of the three increments before, which may have any lengths. There is no latency. At increments of h the error of ω is
/// h³ω'''/4. The velocity has this error once and does not accumulate it. The error in the centripetal part is of fourth order. At
/// the start the cubic is replaced by a polynomial through the angles that exist: a constant rate has no transient.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sensors) struct SizeEffect {
    /// Row = place of an accelerometer [m].
    arms: Matrix3<f64>,
    /// Motion that the increments of the interval belong to, and the share of the motion that is past; `None` for foreign
    /// increments.
    turning: Option<(Turning, f64)>,
    /// The last increment and the one before it; `None` where there is no such increment yet.
    past: Kept<[Option<Past>; 2]>,
    /// ω at the end of the last increment [rad/s].
    rate: Kept<Vector3<f64>>,
}

/// A past increment.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Past {
    /// Length [s].
    dt: f64,
    /// Mean rate [rad/s].
    mean: Vector3<f64>,
}

stored!(SizeEffect { past, rate: SIGNALS } rebuilt { arms, turning });
stored!(Past { dt: INTERVALS_S.1, mean: SIGNALS } then |past, from| {
    let shortest_s = INTERVALS_S.0 / MAX_INCREMENTS as f64;
    from.require(past.dt >= shortest_s, past.dt, "is no length of an increment")
});

impl Effect for SizeEffect {
    fn new(_: &EffectStreams) -> Self {
        Self {
            arms: Matrix3::zeros(),
            turning: None,
            past: Kept::new([None; 2]),
            rate: Kept::new(Vector3::zeros()),
        }
    }

    fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.arms = parameters.lever_arm_m;
        if !self.is_active() {
            *self.past = [None; 2];
        }
        self.is_active()
    }

    fn begin_interval(&mut self, conditions: &Conditions) {
        if !self.is_active() {
            return;
        }
        self.past.keep();
        self.rate.keep();
        if let Some(turning) = &conditions.turning {
            *self.rate = turning.angular_rate(0.0);
        }
        self.turning = conditions.turning.map(|turning| (turning, 0.0));
    }

    fn undo(&mut self) {
        self.past.undo();
        self.rate.undo();
    }
}

impl OnInput for SizeEffect {
    #[inline]
    fn apply(&mut self, angle: &Vector3<f64>, dt: f64, input: &mut Vector3<f64>) {
        let mean = angle / dt;
        let change = match &mut self.turning {
            Some((turning, past)) => {
                *past += dt / turning.interval_s;
                let start = core::mem::replace(&mut *self.rate, turning.angular_rate(*past));
                *self.rate - start
            }
            None => self.change_of_foreign(Past { dt, mean }),
        };
        *input += self.along_axes(|arm| lever_arm_velocity(&change, &mean, dt, arm));
    }

    fn steady_change(&self, rate: &Vector3<f64>) -> Vector3<f64> {
        self.along_axes(|arm| centripetal(rate, arm))
    }
}

impl SizeEffect {
    /// Whether an accelerometer is away from the block's own point.
    pub fn is_active(&self) -> bool {
        self.arms != Matrix3::zeros()
    }

    /// Change of ω over the foreign increment `now`, which follows only from this increment and the increments before it.
    fn change_of_foreign(&mut self, now: Past) -> Vector3<f64> {
        let end = self.rate_at_end(&now);
        let start = if self.past[0].is_some() { *self.rate } else { end };
        *self.past = [Some(now), self.past[0]];
        *self.rate = end;
        end - start
    }

    /// ω at the end of the increment `now`, by Newton's divided differences of the angle.
    fn rate_at_end(&self, now: &Past) -> Vector3<f64> {
        let [Some(last), before] = *self.past else { return now.mean };
        let two = now.dt + last.dt;
        let second = (now.mean - last.mean) / two;
        let Some(before) = before else { return now.mean + second * now.dt };
        let third = (second - (last.mean - before.mean) / (last.dt + before.dt)) / (two + before.dt);
        now.mean + (second + third * two) * now.dt
    }

    /// For each accelerometer, the component along its axis of the acceleration at its arm. `acceleration` gives the acceleration
    /// at an arm.
    #[inline]
    fn along_axes(&self, acceleration: impl Fn(&Vector3<f64>) -> Vector3<f64>) -> Vector3<f64> {
        Vector3::from_fn(|axis, _| acceleration(&self.arms.row(axis).transpose())[axis])
    }
}
