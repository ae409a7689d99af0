//! The way in: samples are checked against each other, put on the time base and into a bounded queue.

use nalgebra::{SVector, Vector3};

use super::{FlightSample, TruthPoint};
use crate::earth::Earth;
use crate::error::{Error, ErrorKind, Rule};
use crate::math::end_derivative_weights;
use crate::state::BodyAxes;

/// Samples that may wait for a step.
pub const QUEUE_CAPACITY: usize = 16;

/// Displacement that a coarse position may contradict the velocity by before it is a teleport [m]: single-precision
/// longitudes in degrees are 0.85 m apart.
const POSITION_SLACK_M: f64 = 10.0;

/// Shortest interval between samples [s].
const MIN_INTERVAL_S: f64 = 5e-5;

/// |q0·q1| of two attitudes 170° apart.
const HALF_TURN_COSINE: f64 = 0.087_155_742_747_658_17;

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
    queue: Queue,
    /// The last point taken, whether still in the queue or not.
    last: Option<TruthPoint>,
    /// Time [s] and Earth-fixed position [m] of the points before, newest first, for velocity from position.
    trail: [Option<(f64, Vector3<f64>)>; 3],
    /// First time stamp [s] and number of periods since, where a period is stated.
    first_time_s: f64,
    ticks: f64,
}

impl Intake {
    /// An empty intake.
    pub fn new(earth: Earth, axes: BodyAxes, limits: IntakeLimits) -> Self {
        Self {
            earth,
            axes,
            limits,
            queue: Queue::EMPTY,
            last: None,
            trail: [None; 3],
            first_time_s: 0.0,
            ticks: 0.0,
        }
    }

    /// Forgets everything that was taken in.
    pub fn clear(&mut self) {
        self.queue = Queue::EMPTY;
        self.last = None;
        self.trail = [None; 3];
    }

    /// Number of points that wait.
    pub fn waiting(&self) -> usize {
        self.queue.len
    }

    /// The oldest point that waits.
    pub fn front(&self) -> Option<&TruthPoint> {
        self.queue.front()
    }

    /// Takes the oldest point out.
    pub fn pop(&mut self) -> Option<TruthPoint> {
        self.queue.pop()
    }

    /// Checks `sample` and puts it into the queue.
    pub fn push(&mut self, sample: &FlightSample) -> Result<(), Error> {
        sample.validate()?;
        if self.queue.len == QUEUE_CAPACITY {
            let rule =
                Rule::WordsAnd("step before the next sample; samples that may wait:", QUEUE_CAPACITY as f64);
            return Err(Error::of(ErrorKind::QueueFull, "queued samples", self.queue.len as f64, rule));
        }
        let (time_s, interval_s, ticks) = self.place_in_time(sample.time_s)?;
        let point = self.point(sample, time_s, interval_s);
        if let Some(last) = &self.last {
            self.check_jump(last, &point)?;
            if last.sample.v_n.is_none() && self.trail[1].is_none() {
                // The first velocity is known only now: the mean of the first interval.
                if let Some(first) = self.queue.back() {
                    first.set_velocity(&self.earth, point.state.v_e);
                }
            }
        } else {
            self.first_time_s = sample.time_s;
        }
        self.ticks = ticks;
        self.trail.rotate_right(1);
        self.trail[0] = Some((point.time_s, point.state.r_e));
        self.last = Some(point);
        self.queue.push(point);
        Ok(())
    }

    /// Time on the time base, interval to the point before, ticks since the first sample.
    fn place_in_time(&self, stamp_s: f64) -> Result<(f64, f64, f64), Error> {
        let Some(last) = &self.last else { return Ok((stamp_s, 0.0, 0.0)) };
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
        if interval_s < MIN_INTERVAL_S {
            return order(Rule::WordsAnd(
                "must be at least 5e-5 s after the previous sample, at",
                last.time_s,
            ));
        }
        if interval_s > self.limits.max_gap_s {
            let rule = Rule::WordsAnd(
                "the gap after the previous sample must be at most max_gap_s =",
                self.limits.max_gap_s,
            );
            return Err(Error::of(ErrorKind::Discontinuity, "sample.time_s", stamp_s, rule));
        }
        Ok((time_s, interval_s, ticks))
    }

    /// The sample in Earth-fixed axes, its velocity from position where it has none.
    fn point(&self, sample: &FlightSample, time_s: f64, interval_s: f64) -> TruthPoint {
        let mut point = TruthPoint::new(&self.earth, self.axes, sample, time_s, interval_s);
        if sample.v_n.is_none() {
            point.set_velocity(&self.earth, self.velocity_from_positions(time_s, &point.state.r_e));
        }
        point
    }

    /// Derivative of the polynomial through this position and up to three before it, at this one.
    fn velocity_from_positions(&self, time_s: f64, r_e: &Vector3<f64>) -> Vector3<f64> {
        // Positions relative to this one, so that the large part of the coordinates does not enter.
        let before = |j: usize| self.trail[j].map(|(t, r)| (t - time_s, r - r_e));
        match (before(0), before(1), before(2)) {
            (Some(a), Some(b), Some(c)) => weighted([a, b, c], end_derivative_weights(&[a.0, b.0, c.0])),
            (Some(a), Some(b), None) => weighted([a, b], end_derivative_weights(&[a.0, b.0])),
            (Some(a), None, _) => weighted([a], end_derivative_weights(&[a.0])),
            _ => Vector3::zeros(),
        }
    }

    /// Refuses what no vehicle does between two samples.
    fn check_jump(&self, last: &TruthPoint, point: &TruthPoint) -> Result<(), Error> {
        let jump = |field, value, rule| Err(Error::of(ErrorKind::Discontinuity, field, value, rule));
        let limit = self.limits.max_acceleration_m_s2;
        let interval = point.interval_s;
        let acceleration = (point.state.v_e - last.state.v_e).norm_squared().sqrt() / interval;
        // A velocity from coarse positions is noise of metres a second: there the displacement alone is judged.
        if acceleration > limit && point.sample.v_n.is_some() && last.sample.v_n.is_some() {
            return jump(
                "sample.velocity_enu_m_s: acceleration since the previous sample [m/s2]",
                acceleration,
                Rule::WordsAnd("must be at most max_acceleration_m_s2 =", limit),
            );
        }
        let mean = 0.5 * (point.state.v_e + last.state.v_e);
        let displacement = (point.state.r_e - last.state.r_e - mean * interval).norm_squared().sqrt();
        let allowed = POSITION_SLACK_M + 0.5 * limit * interval * interval;
        if displacement > allowed {
            return jump(
                "sample position: displacement that the velocity does not explain [m]",
                displacement,
                Rule::WordsAnd("must be at most 10 m + max_acceleration_m_s2 interval^2 / 2 =", allowed),
            );
        }
        let cosine = last.state.q_eb.dot(&point.state.q_eb).abs();
        if cosine < HALF_TURN_COSINE {
            let angle = 2.0 * crate::math::atan2((1.0 - cosine * cosine).max(0.0).sqrt(), cosine);
            return jump(
                "sample attitude: rotation since the previous sample [rad]",
                angle,
                Rule::Words("must be below 170 degrees; beyond it the sense of the rotation is unknown"),
            );
        }
        Ok(())
    }
}

/// Σ w_j r_j over points relative to the newest, whose own weight is the last and whose r is zero.
fn weighted<const N: usize, const M: usize>(
    points: [(f64, Vector3<f64>); N],
    weights: [f64; M],
) -> Vector3<f64> {
    points.iter().zip(weights).fold(SVector::zeros(), |sum, (point, weight)| sum + point.1 * weight)
}

/// First in, first out, without an allocation.
#[derive(Debug, Clone)]
struct Queue {
    points: [Option<TruthPoint>; QUEUE_CAPACITY],
    first: usize,
    len: usize,
}

impl Queue {
    const EMPTY: Self = Self { points: [None; QUEUE_CAPACITY], first: 0, len: 0 };

    fn front(&self) -> Option<&TruthPoint> {
        self.points[self.first].as_ref()
    }

    /// The newest, to be completed.
    fn back(&mut self) -> Option<&mut TruthPoint> {
        self.points[(self.first + self.len + QUEUE_CAPACITY - 1) % QUEUE_CAPACITY].as_mut()
    }

    fn push(&mut self, point: TruthPoint) {
        self.points[(self.first + self.len) % QUEUE_CAPACITY] = Some(point);
        self.len += 1;
    }

    fn pop(&mut self) -> Option<TruthPoint> {
        let point = self.points[self.first].take()?;
        self.first = (self.first + 1) % QUEUE_CAPACITY;
        self.len -= 1;
        Some(point)
    }
}
