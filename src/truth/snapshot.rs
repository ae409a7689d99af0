//! The samples that an intake keeps, in a snapshot and back.

use nalgebra::Vector3;

use super::limits::{INTERVALS_S, OFF_PERIOD, STAMP_ROUNDING};
use super::ring::LOOK_BACK;
use super::steps::Steps;
use super::{FlightSample, Intake, QUEUE_CAPACITY, TruthPoint};
use crate::base::error::{Error, ErrorKind, Rule, check_range};
use crate::base::snapshot::{Numbers, Reader, Stored, Writer};

/// Stores the samples that the ring keeps. When they are read, their points are computed again, and checked as if the host had
/// pushed them.
impl Stored for Intake {
    fn save(&self, to: &mut Writer<'_>) {
        // The ticks follow from the last sample.
        let Self { earth: _, axes: _, limits: _, ring, first_time_s, ticks: _ } = self;
        first_time_s.save(to);
        to.count(ring.behind());
        to.count(ring.waiting());
        for point in ring.kept() {
            point.sample.save(to);
            point.interval_s.save(to);
            if point.sample.v_n.is_none() {
                point.state.v_e.save(to);
            }
        }
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        from.enter("snapshot: time of the first sample");
        self.first_time_s.load(from, 1e10)?;
        from.enter("snapshot: number of samples");
        let behind = from.count(LOOK_BACK)?;
        let waiting = from.count(QUEUE_CAPACITY)?;
        for _ in 0..behind + waiting {
            let mut sample = FlightSample::default();
            sample.load(from)?;
            from.enter("snapshot: interval before a sample");
            let mut interval_s = 0.0;
            interval_s.load(from, INTERVALS_S.1)?;
            let mut v_e = None;
            if sample.v_n.is_none() {
                from.enter("snapshot: velocity of a sample");
                Numbers::load(v_e.insert(Vector3::zeros()), from, 1e12)?;
            }
            self.put_back(&sample, interval_s, v_e)?;
        }
        for _ in 0..behind {
            self.take();
        }
        Ok(())
    }
}

impl Intake {
    /// Checks a sample that was in the ring, and puts it back; the oldest comes first. It is `interval_s` [s] after the one before.
    /// `v_e` is its velocity [m/s] if the sample itself has none.
    fn put_back(
        &mut self,
        sample: &FlightSample,
        interval_s: f64,
        v_e: Option<Vector3<f64>>,
    ) -> Result<(), Error> {
        sample.validate()?;
        let (time_s, ticks) = self.on_time_base(sample.time_s);
        self.check_kept_time(sample.time_s, time_s, interval_s)?;
        let mut point = TruthPoint::new(&self.earth, self.axes, sample, time_s, interval_s);
        if let Some(v_e) = v_e {
            point.set_velocity(&self.earth, v_e);
        }
        // A sample without a velocity was checked against a mean velocity, of points that are no longer kept, or of a later one.
        let knows_velocity = |point: &TruthPoint| point.sample.v_n.is_some();
        if let Some(last) = self.ring.pushed(0).filter(|last| knows_velocity(last) && knows_velocity(&point))
        {
            let steps = Steps { last, before: [self.ring.pushed(1), None] };
            // The interval before the oldest sample is lost too. Without it the turn of the oldest interval cannot be
            // predicted.
            if steps.before[0].is_some() {
                steps.check(&point, &self.limits)?;
            } else {
                steps.check_without_foresight(&point, &self.limits)?;
            }
        }
        self.ticks = ticks;
        self.ring.push(point);
        Ok(())
    }

    /// Rejects a kept sample at `stamp_s` (`time_s` on the time base) if no flight can have it `interval_s` after the last one. If time
    /// was moved, the rounding of the stamps has changed since the interval was taken.
    fn check_kept_time(&self, stamp_s: f64, time_s: f64, interval_s: f64) -> Result<(), Error> {
        let rounding = STAMP_ROUNDING * FlightSample::LATEST_S;
        let refuse = |value, why| {
            Err(Error::of(ErrorKind::TimeOrder, "snapshot: time of a sample", value, Rule::Sentence(why)))
        };
        if let Some(period) = self.limits.period_s
            && (stamp_s - time_s).abs() > OFF_PERIOD * period + rounding
        {
            return refuse(stamp_s, "is off the stated sample period");
        }
        let Some(last) = self.ring.pushed(0) else {
            // The first sample of a flight has no interval before it.
            let shortest = if interval_s == 0.0 { 0.0 } else { INTERVALS_S.0 };
            return check_range("snapshot: interval before a sample", interval_s, shortest, INTERVALS_S.1);
        };
        let (shortest, longest) = (INTERVALS_S.0, self.limits.max_gap_s + rounding);
        check_range("snapshot: interval before a sample", interval_s, shortest, longest)?;
        if (time_s - last.time_s - interval_s).abs() > rounding {
            return refuse(stamp_s, "is not an interval after the sample before");
        }
        Ok(())
    }
}
