//! Intake of samples: they are checked against each other, placed on the time base, and put into a bounded queue.

use nalgebra::Vector3;

use super::limits::{IntakeLimits, MAX_GAP_S, MIN_INTERVAL_S, OFF_PERIOD, STAMP_ROUNDING};
use super::ring::Ring;
use super::steps::{POSITION_SLACK_M, Steps};
use super::{FlightSample, QUEUE_CAPACITY, Recent, TruthPoint};
use crate::base::error::{Error, ErrorKind, Rule, check_range};
use crate::base::math::end_derivative_weights;
use crate::earth::Earth;
use crate::earth::state::BodyAxes;

/// Earliest time that a sample can be moved to [s]: it leaves room for the samples before it, at most 18 intervals.
const EARLIEST_MOVED_S: f64 = -FlightSample::LATEST_S + 20.0 * MAX_GAP_S;

/// Latest time that a sample can be moved to [s], likewise. A sample that came before its place in the stated period has
/// room after it, and so has a snapshot of it.
const LATEST_MOVED_S: f64 = FlightSample::LATEST_S - 20.0 * MAX_GAP_S;

/// How an accepted sample follows the ones before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pushed {
    /// The sample is the first one, or ends an interval of usual length.
    Regular,
    /// The sample ends a gap: an interval of more than 2.5 times each of the two before it.
    BehindGap,
    /// The sample is the second one: the first has no velocity of its own, and now gets one from both positions.
    FirstVelocity,
}

/// Takes samples in.
#[derive(Debug, Clone)]
pub struct Intake {
    pub(super) earth: Earth,
    pub(super) axes: BodyAxes,
    pub(super) limits: IntakeLimits,
    pub(super) ring: Ring,
    /// First time stamp [s] and number of periods since, if a period is stated.
    pub(super) first_time_s: f64,
    pub(super) ticks: f64,
}

impl Intake {
    /// An empty intake. An intake allocates only here and in a copy.
    pub fn new(earth: Earth, axes: BodyAxes, limits: IntakeLimits) -> Result<Self, Error> {
        Ok(Self { earth, axes, limits, ring: Ring::new()?, first_time_s: 0.0, ticks: 0.0 })
    }

    /// Another with the same samples; unlike a clone it reports a lack of memory.
    pub(crate) fn copy(&self) -> Result<Self, Error> {
        let &Self { earth, axes, limits, ref ring, first_time_s, ticks } = self;
        Ok(Self { earth, axes, limits, ring: ring.copy()?, first_time_s, ticks })
    }

    /// Forgets all samples.
    pub fn clear(&mut self) {
        self.ring.clear();
        (self.first_time_s, self.ticks) = (0.0, 0.0);
    }

    /// Forgets all samples and begins with `sample`; on an error nothing has changed. As the first sample, it is checked
    /// only by itself.
    pub fn restart(&mut self, sample: &FlightSample) -> Result<(), Error> {
        let first = self.first_point(sample)?;
        self.begin(first);
        Ok(())
    }

    /// Forgets all samples: the flight continues from `point`, a [`Self::first_point`], as if it had come there.
    pub fn go_on_from(&mut self, point: TruthPoint) {
        self.begin(point);
        self.take();
    }

    /// The point of `sample` as if it were the first sample.
    pub fn first_point(&self, sample: &FlightSample) -> Result<TruthPoint, Error> {
        sample.validate()?;
        // Adding 0 turns -0 into +0: a loaded snapshot has +0, because it adds multiples of a period to this time.
        let first = FlightSample { time_s: sample.time_s + 0.0, ..*sample };
        Ok(TruthPoint::new(&self.earth, self.axes, &first, first.time_s, 0.0))
    }

    fn begin(&mut self, first: TruthPoint) {
        self.clear();
        self.first_time_s = first.time_s;
        self.ring.push(first);
    }

    /// Moves the sample that was pushed last to `time_s` [s], and the others with it. Intervals and periods stay the same to the bit.
    /// Returns how far the samples moved [s].
    pub fn move_time(&mut self, time_s: f64) -> Result<f64, Error> {
        let Some(newest) = self.ring.pushed(0) else {
            return Err(Error::bad_state("no sample yet; the first sample sets the time"));
        };
        check_range("time_s", time_s, EARLIEST_MOVED_S, LATEST_MOVED_S)?;
        let shift_s = time_s - newest.sample.time_s;
        let period_s = self.limits.period_s;
        let off_time_base = |point: &TruthPoint| {
            let most = OFF_PERIOD * period_s.unwrap_or(0.0);
            (point.sample.time_s - point.time_s).clamp(-most, most)
        };
        let newest_s = time_s + 0.0 - off_time_base(newest);
        let (mut later_s, mut ticks) = (0.0, 0.0);
        let mut moved_s = newest_s;
        self.ring.for_each_kept_mut(|point| {
            match period_s {
                // The same rounding as when a snapshot is loaded.
                Some(period) => moved_s = newest_s + ticks * period,
                None => moved_s -= later_s,
            }
            point.sample.time_s = moved_s + off_time_base(point);
            point.time_s = moved_s;
            later_s = point.interval_s;
            ticks -= period_s.map_or(0.0, |period| (point.interval_s / period).round());
        });
        (self.first_time_s, self.ticks) = (newest_s, 0.0);
        Ok(shift_s)
    }

    /// Number of points that wait.
    pub fn waiting(&self) -> usize {
        self.ring.waiting()
    }

    /// Whether each point that waits has a temperature.
    pub fn waiting_have_temperatures(&self) -> bool {
        let has = |point: &TruthPoint| point.sample.temperature_c.is_some();
        (0..self.waiting()).all(|back| self.ring.pushed(back).is_some_and(has))
    }

    /// The oldest point that waits.
    pub fn front(&self) -> Option<&TruthPoint> {
        self.ring.front()
    }

    /// The point taken last.
    pub fn current(&self) -> Option<&TruthPoint> {
        self.ring.taken(0)
    }

    /// The point pushed last, taken or not.
    pub fn newest(&self) -> Option<&TruthPoint> {
        self.ring.pushed(0)
    }

    /// The point taken last and the two before it, if there are any.
    pub fn behind(&self) -> [Option<&TruthPoint>; 3] {
        [0, 1, 2].map(|back| self.ring.taken(back))
    }

    /// Time stamps of the current point and of the one before it, the older one first [s].
    pub fn last_interval_s(&self) -> Option<[f64; 2]> {
        Some([self.ring.taken(1)?.stamp_s(), self.ring.taken(0)?.stamp_s()])
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
    pub fn push(&mut self, sample: &FlightSample) -> Result<Pushed, Error> {
        sample.validate()?;
        if self.waiting() == QUEUE_CAPACITY {
            let rule = Rule::SentenceWith(
                "the queue is full, step first; samples that can wait:",
                QUEUE_CAPACITY.into(),
            );
            return Err(Error::of(ErrorKind::QueueFull, "queued samples", QUEUE_CAPACITY, rule));
        }
        let Some(last) = self.ring.pushed(0) else {
            self.restart(sample)?;
            return Ok(Pushed::Regular);
        };
        let (time_s, interval_s, ticks) = self.place_in_time(last, sample)?;
        let mut point = TruthPoint::new(&self.earth, self.axes, sample, time_s, interval_s);
        if sample.v_n.is_none() {
            point.set_velocity(&self.earth, self.velocity_from_positions(&point));
        }
        Steps { last, before: [self.ring.pushed(1), self.ring.pushed(2)] }.check(&point, &self.limits)?;
        let mut pushed = Pushed::Regular;
        if point.ends_gap(last) && point.gap_ratio(last, self.ring.pushed(1)).is_some() {
            pushed = Pushed::BehindGap;
        }
        if last.sample.v_n.is_none() && self.ring.pushed(1).is_none() {
            // The first velocity is known only now: the mean of the first interval.
            if let Some(first) = self.ring.pushed_mut() {
                first.set_velocity(&self.earth, point.state.v_e);
            }
            pushed = Pushed::FirstVelocity;
        }
        self.ticks = ticks;
        self.ring.push(point);
        Ok(pushed)
    }

    /// Time on the time base and periods since the first sample, where a period is stated.
    pub(super) fn on_time_base(&self, stamp_s: f64) -> (f64, f64) {
        match self.limits.period_s {
            None => (stamp_s, 0.0),
            Some(period) => {
                let ticks = ((stamp_s - self.first_time_s) / period).round();
                (self.first_time_s + ticks * period, ticks)
            }
        }
    }

    /// Time on the time base, interval to the point before, ticks since the first sample.
    fn place_in_time(&self, last: &TruthPoint, sample: &FlightSample) -> Result<(f64, f64, f64), Error> {
        let stamp_s = sample.time_s;
        let order = |rule| Err(Error::of(ErrorKind::TimeOrder, "sample.time_s", stamp_s, rule));
        let (time_s, ticks) = self.on_time_base(stamp_s);
        let interval_s = match self.limits.period_s {
            None => stamp_s - last.time_s,
            Some(period) => {
                if (stamp_s - time_s).abs() > OFF_PERIOD * period {
                    return order(Rule::SentenceWith(
                        "is off the stated sample period; the nearest sample time is",
                        time_s.into(),
                    ));
                }
                (ticks - self.ticks) * period
            }
        };
        let rounding = STAMP_ROUNDING * stamp_s.abs();
        if interval_s < MIN_INTERVAL_S - rounding || interval_s <= 0.0 {
            return order(Rule::SentenceWith(
                "must be at least 5e-5 s after the previous sample, at",
                last.time_s.into(),
            ));
        }
        if interval_s > self.limits.max_gap_s + rounding {
            return Err(self.too_long_a_gap(last, sample, interval_s));
        }
        Ok((time_s, interval_s, ticks))
    }

    /// The error of a sample that is more than `max_gap_s` after the last accepted one. If the position moved farther than the faster of
    /// both velocities explains, the samples in between were not missing, but rejected for a jump.
    #[cold]
    fn too_long_a_gap(&self, last: &TruthPoint, sample: &FlightSample, interval_s: f64) -> Error {
        let point = TruthPoint::new(&self.earth, self.axes, sample, sample.time_s, interval_s);
        let moved_m = (point.state.r_e - last.state.r_e).norm_squared().sqrt();
        let speed2 = point.state.v_e.norm_squared().max(last.state.v_e.norm_squared());
        let max_gap_s = self.limits.max_gap_s;
        let rule = if moved_m > POSITION_SLACK_M + speed2.sqrt() * interval_s {
            Rule::GapWithJump(max_gap_s, moved_m.round())
        } else {
            Rule::SentenceWith(
                "the gap after the last accepted sample must be at most options.max_gap_s =",
                max_gap_s.into(),
            )
        };
        Error::of(ErrorKind::Discontinuity, "sample.time_s", sample.time_s, rule)
    }

    /// Velocity at `point` [m/s]: the derivative of the polynomial through its position and up to three before it. After a gap only
    /// two before it are used, because with a third one position errors ε before the gap cause a velocity error ε T/t² (T length of
    /// the gap, t intervals before it).
    fn velocity_from_positions(&self, point: &TruthPoint) -> Vector3<f64> {
        // Relative to this position, so that the large part of the coordinates does not enter.
        let before = |back: usize| {
            let past = self.ring.pushed(back)?;
            Some((past.time_s - point.time_s, past.state.r_e - point.state.r_e))
        };
        let third = || before(2).filter(|_| !self.ring.pushed(0).is_some_and(|last| point.ends_gap(last)));
        match (before(0), before(1), third()) {
            (Some(a), Some(b), Some(c)) => weighted([a, b, c]),
            (Some(a), Some(b), None) => weighted([a, b]),
            (Some(a), None, _) => weighted([a]),
            _ => Vector3::zeros(),
        }
    }
}

/// Derivative at the point 0 of the polynomial through points (time, value) relative to it.
fn weighted<const N: usize>(points: [(f64, Vector3<f64>); N]) -> Vector3<f64> {
    let weights = end_derivative_weights(&points.map(|(time, _)| time));
    points.iter().zip(weights).fold(Vector3::zeros(), |sum, (point, weight)| sum + point.1 * weight)
}
