//! Checks from one sample to the next: motion that no vehicle makes is rejected.

use nalgebra::Vector3;

use super::TruthPoint;
use super::limits::IntakeLimits;
use crate::error::{Error, ErrorKind, Rule};
use crate::math::{atan2, relative_rotation, rotation_vector};

/// Displacement by which a coarse position may contradict the velocity before it is a jump [m]: longitudes in degrees of single
/// precision are 0.85 m apart.
const POSITION_SLACK_M: f64 = 10.0;

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
        let last = self.last;
        let limit = limits.max_acceleration_m_s2;
        let (unexplained, allowed) = match point.sample.v_n {
            Some(_) => self.contradiction(point, limit),
            None => self.leap(point, limit)?,
        };
        if unexplained.norm_squared() > allowed * allowed {
            return jump(
                "sample position: displacement that the velocity does not explain [m]",
                unexplained.norm_squared().sqrt(),
                Rule::AtMost(
                    "must be at most 10 m plus the effect of max_acceleration_m_s2 in this interval:",
                    allowed,
                ),
            );
        }
        let change2 = (point.state.v_e - last.state.v_e).norm_squared();
        // A velocity from coarse positions has a noise of metres per second. Then only the displacement is checked.
        let measured = point.sample.v_n.is_some() && last.sample.v_n.is_some();
        let interval = point.interval_s;
        if measured && change2 > (limit * interval) * (limit * interval) {
            return jump(
                "sample.velocity_enu_m_s: acceleration since the previous sample [m/s2]",
                change2.sqrt() / interval,
                Rule::AtMost("must be at most max_acceleration_m_s2 =", limit),
            );
        }
        self.check_turn(point)
    }

    /// Displacement [m] that the velocities at both ends do not explain, and its limit.
    fn contradiction(&self, point: &TruthPoint, limit: f64) -> (Vector3<f64>, f64) {
        let (last, interval) = (self.last, point.interval_s);
        let is_unknown = last.sample.v_n.is_none() && self.before[0].is_none();
        let v_start = if is_unknown { point.state.v_e } else { last.state.v_e };
        let mean = 0.5 * (point.state.v_e + v_start);
        let unexplained = point.state.r_e - last.state.r_e - mean * interval;
        (unexplained, POSITION_SLACK_M + 0.5 * limit * interval * interval)
    }

    /// For samples without velocities: displacement that the mean velocity over up to two previous intervals does not
    /// explain. The velocity at the point itself would explain eleven twelfths of any jump, because it follows from it.
    fn leap(&self, point: &TruthPoint, limit: f64) -> Result<(Vector3<f64>, f64), Error> {
        let (last, interval) = (self.last, point.interval_s);
        let displacement = point.state.r_e - last.state.r_e;
        let speed2 = displacement.norm_squared() / (interval * interval);
        if speed2 > MAX_SPEED_M_S * MAX_SPEED_M_S {
            return jump(
                "sample position: speed since the previous sample [m/s]",
                speed2.sqrt(),
                Rule::AtMost("must be at most", MAX_SPEED_M_S),
            );
        }
        let Some(far) = self.before[1].or(self.before[0]) else {
            return Ok((Vector3::zeros(), POSITION_SLACK_M));
        };
        let span = last.time_s - far.time_s;
        let unexplained = displacement - (last.state.r_e - far.state.r_e) * (interval / span);
        Ok((unexplained, POSITION_SLACK_M + 0.5 * limit * interval * (interval + span)))
    }

    /// Rejects turns of 170° and more, because their sense is unknown.
    #[inline(always)]
    fn check_turn(&self, point: &TruthPoint) -> Result<(), Error> {
        let last = self.last;
        let (from, to) = (&last.state.q_eb, &point.state.q_eb);
        let cosine = from.dot(to).abs();
        if cosine < HALF_TURN_COSINE {
            let angle = 2.0 * atan2((1.0 - cosine * cosine).max(0.0).sqrt(), cosine);
            return jump(
                "sample attitude: rotation since the previous sample [rad]",
                angle,
                Rule::Sentence(
                    "must be below 170 degrees; beyond it the direction of the rotation is unknown",
                ),
            );
        }
        Ok(())
    }

    /// Rejects turns that only seem to be below 170° because a part of a whole turn cannot be seen. Evidence: a spin-up of 1e5 °/s² at
    /// 50 Hz steps from 160° to 200° an interval, which looks like -160°.
    #[inline(always)]
    fn check_foreseen_turn(&self, point: &TruthPoint) -> Result<(), Error> {
        let last = self.last;
        let (from, to) = (&last.state.q_eb, &point.state.q_eb);
        let cosine = from.dot(to).abs();
        let before = self.before[0];
        if before.is_some_and(|_| point.interval_s > FORESEEN_INTERVALS * last.interval_s) {
            return Ok(());
        }
        let foreseen = match (last.sample.omega_ib_b, point.sample.omega_ib_b, before) {
            // This includes the turn of the Earth, 1e-4 rad.
            (Some(start), Some(end), _) => (start + end) * (0.5 * point.interval_s),
            (.., Some(before)) => {
                let q_before = &before.state.q_eb;
                if cosine > SLOW_COSINE && q_before.dot(from).abs() > SLOW_COSINE {
                    return Ok(());
                }
                let turn_before = rotation_vector(&relative_rotation(q_before, from));
                turn_before * (point.interval_s / last.interval_s)
            }
            _ => return Ok(()),
        };
        let turn = rotation_vector(&relative_rotation(from, to));
        let change = (turn - foreseen).norm_squared().sqrt();
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

fn jump<T>(field: &'static str, value: f64, rule: Rule) -> Result<T, Error> {
    Err(Error::of(ErrorKind::Discontinuity, field, value, rule))
}
