//! The way in: samples are checked against each other, put on the time base and into a bounded queue.

use nalgebra::Vector3;

use super::ring::Ring;
use super::{FlightSample, QUEUE_CAPACITY, Recent, TruthPoint};
use crate::earth::Earth;
use crate::error::{Error, ErrorKind, Rule};
use crate::math::{atan2, end_derivative_weights, relative_rotation, rotation_vector};
use crate::state::BodyAxes;

/// Displacement that a coarse position may contradict the velocity by before it is a teleport [m]: single-precision
/// longitudes in degrees are 0.85 m apart.
const POSITION_SLACK_M: f64 = 10.0;

/// Shortest interval between samples [s].
const MIN_INTERVAL_S: f64 = 5e-5;

/// What the difference of two time stamps may miss an interval by: four units in their last place.
const STAMP_ROUNDING: f64 = 4.0 * f64::EPSILON;

/// |q0·q1| of two attitudes 170° apart.
const HALF_TURN_COSINE: f64 = 0.087_155_742_747_658_17;

/// |q0·q1| of two attitudes 35° apart: four times such a turn and another one are less than half a turn.
const SLOW_COSINE: f64 = 0.953_716_950_748_226_9;

/// How many times longer than the interval before an interval may be for the turn in it to be foreseen.
const FORESEEN_INTERVALS: f64 = 4.1;

/// Fastest that positions may move where there is no velocity [m/s].
const MAX_SPEED_M_S: f64 = 20e3;

/// What separates a bad sample from a hard manoeuvre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntakeLimits {
    /// Longest interval between samples [s].
    pub max_gap_s: f64,
    /// Largest mean acceleration between two samples [m/s²].
    pub max_acceleration_m_s2: f64,
    /// Sample period [s] if the host states one: sample k is then at exactly k periods from the first.
    pub period_s: Option<f64>,
}

impl Default for IntakeLimits {
    fn default() -> Self {
        Self { max_gap_s: 2.5, max_acceleration_m_s2: 2000.0, period_s: None }
    }
}

/// Takes samples in.
#[derive(Debug, Clone)]
pub struct Intake {
    earth: Earth,
    axes: BodyAxes,
    limits: IntakeLimits,
    ring: Ring,
    /// First time stamp [s] and number of periods since, where a period is stated.
    first_time_s: f64,
    ticks: f64,
}

impl Intake {
    /// An empty intake.
    pub fn new(earth: Earth, axes: BodyAxes, limits: IntakeLimits) -> Self {
        Self { earth, axes, limits, ring: Ring::EMPTY, first_time_s: 0.0, ticks: 0.0 }
    }

    /// Number of points that wait.
    pub fn waiting(&self) -> usize {
        self.ring.waiting()
    }

    /// The oldest point that waits.
    pub fn front(&self) -> Option<&TruthPoint> {
        self.ring.front()
    }

    /// The point taken last.
    pub fn current(&self) -> Option<&TruthPoint> {
        self.ring.taken(0)
    }

    /// The interval from the current point to the oldest that waits.
    pub fn recent(&self) -> Option<Recent<'_>> {
        let (next, current) = (self.ring.front()?, self.ring.taken(0)?);
        Some(Recent { next, current, before: [self.ring.taken(1), self.ring.taken(2)] })
    }

    /// The interval between the two oldest points that wait, before any was taken.
    pub fn first_interval(&self) -> Option<Recent<'_>> {
        Some(Recent { next: self.ring.second()?, current: self.ring.front()?, before: [None, None] })
    }

    /// Makes the oldest point that waits the current one.
    pub fn take(&mut self) {
        self.ring.take();
    }

    /// Checks `sample` and puts it into the queue.
    pub fn push(&mut self, sample: &FlightSample) -> Result<(), Error> {
        sample.validate()?;
        if self.waiting() == QUEUE_CAPACITY {
            let rule =
                Rule::WordsAnd("step before the next sample; samples that may wait:", QUEUE_CAPACITY as f64);
            return Err(Error::of(ErrorKind::QueueFull, "queued samples", QUEUE_CAPACITY as f64, rule));
        }
        let Some(last) = self.ring.pushed(0) else {
            self.first_time_s = sample.time_s;
            self.ticks = 0.0;
            self.ring.push(TruthPoint::new(&self.earth, self.axes, sample, sample.time_s, 0.0));
            return Ok(());
        };
        let (time_s, interval_s, ticks) = self.place_in_time(last, sample.time_s)?;
        let mut point = TruthPoint::new(&self.earth, self.axes, sample, time_s, interval_s);
        if sample.v_n.is_none() {
            point.set_velocity(&self.earth, self.velocity_from_positions(&point));
        }
        self.check_jump(last, &point)?;
        if last.sample.v_n.is_none() && self.ring.pushed(1).is_none() {
            // The first velocity is known only now: the mean of the first interval.
            if let Some(first) = self.ring.pushed_mut() {
                first.set_velocity(&self.earth, point.state.v_e);
            }
        }
        self.ticks = ticks;
        self.ring.push(point);
        Ok(())
    }

    /// Time on the time base, interval to the point before, ticks since the first sample.
    fn place_in_time(&self, last: &TruthPoint, stamp_s: f64) -> Result<(f64, f64, f64), Error> {
        let order = |rule| Err(Error::of(ErrorKind::TimeOrder, "sample.time_s", stamp_s, rule));
        let (time_s, interval_s, ticks) = match self.limits.period_s {
            None => (stamp_s, stamp_s - last.time_s, 0.0),
            Some(period) => {
                let ticks = ((stamp_s - self.first_time_s) / period).round();
                let time_s = self.first_time_s + ticks * period;
                if (stamp_s - time_s).abs() > 0.4 * period {
                    return order(Rule::WordsAnd(
                        "is off the stated sample period; the nearest sample time is",
                        time_s,
                    ));
                }
                (time_s, (ticks - self.ticks) * period, ticks)
            }
        };
        let rounding = STAMP_ROUNDING * stamp_s.abs();
        if interval_s < MIN_INTERVAL_S - rounding || interval_s <= 0.0 {
            return order(Rule::WordsAnd(
                "must be at least 5e-5 s after the previous sample, at",
                last.time_s,
            ));
        }
        if interval_s > self.limits.max_gap_s + rounding {
            let rule = Rule::WordsAnd(
                "the gap after the previous sample must be at most max_gap_s =",
                self.limits.max_gap_s,
            );
            return Err(Error::of(ErrorKind::Discontinuity, "sample.time_s", stamp_s, rule));
        }
        Ok((time_s, interval_s, ticks))
    }

    /// Derivative at `point` of the polynomial through its position and up to three before it [m/s].
    fn velocity_from_positions(&self, point: &TruthPoint) -> Vector3<f64> {
        // Relative to this position, so that the large part of the coordinates does not enter.
        let before = |back: usize| {
            let past = self.ring.pushed(back)?;
            Some((past.time_s - point.time_s, past.state.r_e - point.state.r_e))
        };
        match (before(0), before(1), before(2)) {
            (Some(a), Some(b), Some(c)) => weighted([a, b, c]),
            (Some(a), Some(b), None) => weighted([a, b]),
            (Some(a), None, _) => weighted([a]),
            _ => Vector3::zeros(),
        }
    }

    /// Refuses what no vehicle does between two samples.
    fn check_jump(&self, last: &TruthPoint, point: &TruthPoint) -> Result<(), Error> {
        let (unexplained, allowed) = match point.sample.v_n {
            Some(_) => self.contradiction(last, point),
            None => self.leap(last, point)?,
        };
        if unexplained.norm_squared() > allowed * allowed {
            return jump(
                "sample position: displacement that the velocity does not explain [m]",
                unexplained.norm_squared().sqrt(),
                Rule::WordsAnd(
                    "must be at most 10 m and what max_acceleration_m_s2 makes of the time:",
                    allowed,
                ),
            );
        }
        let change2 = (point.state.v_e - last.state.v_e).norm_squared();
        // A velocity from coarse positions is noise of metres a second: there the displacement alone is judged.
        let measured = point.sample.v_n.is_some() && last.sample.v_n.is_some();
        let (limit, interval) = (self.limits.max_acceleration_m_s2, point.interval_s);
        if measured && change2 > (limit * interval) * (limit * interval) {
            return jump(
                "sample.velocity_enu_m_s: acceleration since the previous sample [m/s2]",
                change2.sqrt() / interval,
                Rule::WordsAnd("must be at most max_acceleration_m_s2 =", limit),
            );
        }
        self.check_turn(last, point)
    }

    /// Displacement [m] that the velocities at both ends do not explain, and how much of that there may be.
    fn contradiction(&self, last: &TruthPoint, point: &TruthPoint) -> (Vector3<f64>, f64) {
        let interval = point.interval_s;
        let is_unknown = last.sample.v_n.is_none() && self.ring.pushed(1).is_none();
        let v_start = if is_unknown { point.state.v_e } else { last.state.v_e };
        let mean = 0.5 * (point.state.v_e + v_start);
        let unexplained = point.state.r_e - last.state.r_e - mean * interval;
        (unexplained, POSITION_SLACK_M + 0.5 * self.limits.max_acceleration_m_s2 * interval * interval)
    }

    /// The same without velocities: displacement that the mean velocity over up to two intervals before does not explain. The
    /// velocity at the point itself would explain eleven twelfths of any leap, being made of it.
    fn leap(&self, last: &TruthPoint, point: &TruthPoint) -> Result<(Vector3<f64>, f64), Error> {
        let interval = point.interval_s;
        let displacement = point.state.r_e - last.state.r_e;
        let speed2 = displacement.norm_squared() / (interval * interval);
        if speed2 > MAX_SPEED_M_S * MAX_SPEED_M_S {
            return jump(
                "sample position: speed since the previous sample [m/s]",
                speed2.sqrt(),
                Rule::WordsAnd("must be at most", MAX_SPEED_M_S),
            );
        }
        let Some(far) = self.ring.pushed(2).or(self.ring.pushed(1)) else {
            return Ok((Vector3::zeros(), POSITION_SLACK_M));
        };
        let span = last.time_s - far.time_s;
        let unexplained = displacement - (last.state.r_e - far.state.r_e) * (interval / span);
        let limit = self.limits.max_acceleration_m_s2;
        Ok((unexplained, POSITION_SLACK_M + 0.5 * limit * interval * (interval + span)))
    }

    /// Refuses turns whose sense is unknown: of 170° and more, and those that only seem smaller because whole turns are lost
    /// in them. Evidence: a spin-up of 1e5 °/s² at 50 Hz steps from 160° to 200° an interval, which looks like -160°.
    fn check_turn(&self, last: &TruthPoint, point: &TruthPoint) -> Result<(), Error> {
        let (from, to) = (&last.state.q_eb, &point.state.q_eb);
        let cosine = from.dot(to).abs();
        if cosine < HALF_TURN_COSINE {
            let angle = 2.0 * atan2((1.0 - cosine * cosine).max(0.0).sqrt(), cosine);
            return jump(
                "sample attitude: rotation since the previous sample [rad]",
                angle,
                Rule::Words("must be below 170 degrees; beyond it the sense of the rotation is unknown"),
            );
        }
        let before = self.ring.pushed(1);
        if before.is_some_and(|_| point.interval_s > FORESEEN_INTERVALS * last.interval_s) {
            return Ok(());
        }
        let foreseen = match (last.sample.omega_ib_b, point.sample.omega_ib_b, before) {
            // The Earth's own turn is in it, 1e-4 rad.
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
                "sample attitude: rotation since the previous sample less the one foreseen [rad]",
                change,
                Rule::Words(
                    "must be below 180 degrees, of the rotation by the angular rates or else that of the interval before; \
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

/// Derivative at the point 0 of the polynomial through points (time, value) relative to it.
fn weighted<const N: usize>(points: [(f64, Vector3<f64>); N]) -> Vector3<f64> {
    let weights = end_derivative_weights(&points.map(|(time, _)| time));
    points.iter().zip(weights).fold(Vector3::zeros(), |sum, (point, weight)| sum + point.1 * weight)
}
