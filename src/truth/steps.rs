//! Checks from one sample to the next: motion that no vehicle makes is rejected.

use nalgebra::Vector3;

use super::TruthPoint;
use super::limits::IntakeLimits;
use crate::base::error::{Error, ErrorKind, Rule};
use crate::base::math::{atan2, relative_rotation, rotation_vector};

/// Displacement by which a coarse position may contradict the velocity before it is a jump [m]: longitudes in degrees of single
/// precision are 0.85 m apart.
pub(super) const POSITION_SLACK_M: f64 = 10.0;

/// |q0·q1| of two attitudes 170° apart.
const HALF_TURN_COSINE: f64 = 0.087_155_742_747_658_17;

/// |q0·q1| of two attitudes 35° apart: [`FORESEEN_INTERVALS`] + 1 such turns are less than half a turn.
const SLOW_COSINE: f64 = 0.953_716_950_748_226_9;

/// Largest ratio of an interval to the interval before it at which that interval predicts the turn.
const FORESEEN_INTERVALS: f64 = 4.1;

/// Fastest that positions may move where there is no velocity [m/s].
const MAX_SPEED_M_S: f64 = 20e3;

/// The points before the next one.
pub(super) struct Steps<'a> {
    pub last: &'a TruthPoint,
    /// The two before that, newest first.
    pub before: [Option<&'a TruthPoint>; 2],
}

impl Steps<'_> {
    /// Rejects motion that no vehicle makes between two samples.
    pub fn check(&self, point: &TruthPoint, limits: &IntakeLimits) -> Result<(), Error> {
        self.check_without_foresight(point, limits)?;
        self.check_foreseen_turn(point)
    }

    /// As `check`, but without the check of the turn, which the previous interval would predict.
    #[inline(always)]
    pub fn check_without_foresight(&self, point: &TruthPoint, limits: &IntakeLimits) -> Result<(), Error> {
        self.check_displacement(point, limits.max_acceleration_m_s2)?;
        self.check_acceleration(point, limits.max_acceleration_m_s2)?;
        self.check_turn(point)
    }

    /// Rejects a displacement that velocities explain only with an acceleration above `limit` [m/s²].
    #[inline(always)]
    fn check_displacement(&self, point: &TruthPoint, limit: f64) -> Result<(), Error> {
        let (last, t) = (self.last, point.interval_s);
        let displacement = point.state.r_e - last.state.r_e;
        let (explained, longest_s) = if point.has_velocity() {
            // By the mean of the velocities at both ends.
            let is_unknown = !last.has_velocity() && self.before[0].is_none();
            let v_start = if is_unknown { point.state.v_e } else { last.state.v_e };
            (0.5 * (point.state.v_e + v_start) * t, t)
        } else {
            check_speed(&displacement, t)?;
            // By the mean velocity over up to two previous intervals. The velocity at the point itself would explain eleven twelfths
            // of any jump, because it follows from it.
            let Some(far) = self.before[1].or(self.before[0]) else { return Ok(()) };
            let span = last.time_s - far.time_s;
            ((last.state.r_e - far.state.r_e) * (t / span), t + span)
        };
        let unexplained2 = (displacement - explained).norm_squared();
        let allowed = POSITION_SLACK_M + 0.5 * limit * t * longest_s;
        if unexplained2 > allowed * allowed {
            return jump(
                "sample position: displacement that the velocity does not explain [m]",
                unexplained2.sqrt(),
                Rule::AtMost(
                    "must be at most 10 m plus the effect of options.max_acceleration_m_s2 in this interval:",
                    allowed.into(),
                ),
            );
        }
        Ok(())
    }

    /// Rejects a mean acceleration above `limit` [m/s²]. A velocity from coarse positions has a noise of metres per second: then only the
    /// displacement is checked.
    #[inline(always)]
    fn check_acceleration(&self, point: &TruthPoint, limit: f64) -> Result<(), Error> {
        let (last, t) = (self.last, point.interval_s);
        let change2 = (point.state.v_e - last.state.v_e).norm_squared();
        let are_measured = point.has_velocity() && last.has_velocity();
        if are_measured && change2 > (limit * t) * (limit * t) {
            return jump(
                "sample.velocity_enu_m_s: acceleration since the previous sample [m/s2]",
                change2.sqrt() / t,
                Rule::AtMost("must be at most options.max_acceleration_m_s2 =", limit.into()),
            );
        }
        Ok(())
    }

    /// Rejects turns of 170° and more, because their sense is unknown.
    #[inline(always)]
    fn check_turn(&self, point: &TruthPoint) -> Result<(), Error> {
        let cosine = half_turn_cosine(self.last, point);
        if cosine < HALF_TURN_COSINE {
            return jump(
                "sample attitude: rotation since the previous sample [rad]",
                2.0 * atan2((1.0 - cosine * cosine).max(0.0).sqrt(), cosine),
                Rule::Sentence(
                    "must be less than 2.967 (170 degrees); beyond it the direction of the rotation is unknown",
                ),
            );
        }
        Ok(())
    }

    /// Rejects turns that only seem to be below 170° because a part of a whole turn cannot be seen. Evidence: a spin-up of 1e5 °/s² at
    /// 50 Hz steps from 160° to 200° an interval, which looks like -160°.
    #[inline(always)]
    fn check_foreseen_turn(&self, point: &TruthPoint) -> Result<(), Error> {
        let (last, before, t) = (self.last, self.before[0], point.interval_s);
        if before.is_some() && t > FORESEEN_INTERVALS * last.interval_s {
            return Ok(());
        }
        let foreseen = match (last.omega_ib_b(), point.omega_ib_b(), before) {
            // This includes the turn of the Earth, 1e-4 rad.
            (Some(start), Some(end), _) => (start + end) * (0.5 * t),
            (.., Some(before)) => {
                let are_slow = half_turn_cosine(last, point) > SLOW_COSINE
                    && half_turn_cosine(before, last) > SLOW_COSINE;
                if are_slow {
                    return Ok(());
                }
                turn(before, last) * (t / last.interval_s)
            }
            _ => return Ok(()),
        };
        let change = (turn(last, point) - foreseen).norm_squared().sqrt();
        if change > core::f64::consts::PI {
            return jump(
                "sample attitude: rotation since the previous sample less the predicted rotation [rad]",
                change,
                Rule::Sentence(
                    "must be below 180 degrees; angular rates predict the rotation, or else the previous interval does; \
                     beyond it whole turns may be lost",
                ),
            );
        }
        Ok(())
    }
}

/// Rejects a `displacement` [m] in `t` [s] that is too fast for a sample without a velocity.
#[inline(always)]
fn check_speed(displacement: &Vector3<f64>, t: f64) -> Result<(), Error> {
    let speed2 = displacement.norm_squared() / (t * t);
    if speed2 > MAX_SPEED_M_S * MAX_SPEED_M_S {
        return jump(
            "sample position: speed since the previous sample [m/s]",
            speed2.sqrt(),
            Rule::AtMost("must be at most", MAX_SPEED_M_S.into()),
        );
    }
    Ok(())
}

/// |q0·q1| of the attitudes of two points: the cosine of half the turn between them.
#[inline(always)]
fn half_turn_cosine(from: &TruthPoint, to: &TruthPoint) -> f64 {
    from.state.q_eb.dot(&to.state.q_eb).abs()
}

/// Rotation vector from the attitude of a point to that of another [rad].
#[inline(always)]
fn turn(from: &TruthPoint, to: &TruthPoint) -> Vector3<f64> {
    rotation_vector(&relative_rotation(&from.state.q_eb, &to.state.q_eb))
}

fn jump<T>(field: &'static str, value: f64, rule: Rule) -> Result<T, Error> {
    Err(Error::of(ErrorKind::Discontinuity, field, value, rule))
}
