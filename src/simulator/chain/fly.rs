//! Flies one interval after the other, and undoes an interval if the solution leaves its limits.

use core::ops::Range;

use super::Chain;
use crate::base::error::Error;
use crate::errors::SensorErrors;
use crate::errors::covariance::FlownInterval;
use crate::mechanization::{Mechanization, VerticalAid, VerticalMode, check_state};
use crate::signal::mounting::Block;
use crate::signal::{Increment, IntervalMotion, MAX_INCREMENTS, SignalGenerator};
use crate::simulator::aid::vertical_aid;
use crate::simulator::chain::view::Views;
use crate::simulator::imperfections::IntervalConditions;
use crate::simulator::imu::LastInterval;
use crate::simulator::signals::Signals;
use crate::simulator::{Imperfections, ImuFlags, Options};
use crate::truth::Recent;

impl Chain {
    /// Flies the interval that `recent` ends; on an error nothing has changed.
    pub fn advance(&mut self, recent: &Recent<'_>, imperfections: &mut Imperfections) -> Result<(), Error> {
        self.options.check_truth(recent.next)?;
        let count = self.options.subsamples * self.options.updates_over(recent);
        // The increments of the last interval stay until this one is known to be good.
        let first = Signals::place_after(self.parts.start);
        let parts = first..first + count;
        let generate = |generator: &mut SignalGenerator, ideal: &mut [Increment]| {
            let motion = generator.advance(recent);
            motion.integrate(ideal);
            motion
        };
        if self.is_plain {
            self.fly(parts, recent, generate, imperfections)?;
        } else {
            self.fly_extended(parts, recent, generate, imperfections)?;
        }
        if self.accuracy.is_due(recent.next.time_s) {
            let errors = self.navigation_errors(recent.next);
            self.accuracy.add(recent.next.time_s, &errors, recent.next.is_near_pole());
        }
        Ok(())
    }

    /// Flies the interval of `motion`, which `generator` has given, with `count` increments; the ideal ones are the first of `signals`,
    /// which has the increments of no interval before. On an error nothing has changed.
    pub fn advance_with<'r>(
        &mut self,
        generator: &SignalGenerator,
        motion: &IntervalMotion<'r>,
        recent: &Recent<'r>,
        count: usize,
        signals: &mut Signals,
        imperfections: &mut Imperfections,
    ) -> Result<(), Error> {
        // The ideal increments stay, because mounting and closed loop change them.
        let parts = MAX_INCREMENTS..MAX_INCREMENTS + count;
        signals.ideal.copy_within(..count, parts.start);
        core::mem::swap(&mut self.signals, signals);
        let result = if self.is_plain {
            self.fly(parts, recent, |_, _| *motion, imperfections)
        } else {
            self.generator.clone_from(generator);
            self.fly_extended(parts, recent, |_, _| *motion, imperfections)
        };
        if let (Ok(()), Some(imu)) = (&result, self.imu()) {
            let vertical_unaided = self.last.vertical_unaided().unwrap_or_default();
            self.last = LastInterval::Summed { imu, vertical_unaided };
            self.parts = 0..0;
        }
        core::mem::swap(&mut self.signals, signals);
        result
    }

    /// Flies a chain that is not plain.
    #[cold]
    #[inline(never)]
    fn fly_extended<'r>(
        &mut self,
        parts: Range<usize>,
        recent: &Recent<'r>,
        motion: impl FnOnce(&mut SignalGenerator, &mut [Increment]) -> IntervalMotion<'r>,
        imperfections: &mut Imperfections,
    ) -> Result<(), Error> {
        let (block, disturbance, closed_loop) = (self.block, self.disturbance, self.closed_loop.clone());
        let result = self.fly(parts, recent, motion, imperfections);
        if result.is_err() {
            (self.block, self.disturbance, self.closed_loop) = (block, disturbance, closed_loop);
        } else if let Some(summary) = &mut self.summary {
            summary.add(&self.earth, self.options.axes, recent);
        }
        result
    }

    /// Checks that all solutions are within their limits: the solutions of the sensors' own point, of the shadow and of the
    /// reference point.
    pub(super) fn check(&self) -> Result<(), Error> {
        if let Some(closed_loop) = &self.closed_loop {
            closed_loop.check()?;
        }
        self.check_in(&self.mechanization, self.block.as_ref())
    }

    /// Checks the solution of the sensors' own point in `block`, and that of the reference point.
    pub(super) fn check_in(&self, mechanization: &Mechanization, block: Option<&Block>) -> Result<(), Error> {
        mechanization.check()?;
        match block {
            Some(block) => check_state(&self.earth, &block.belief().reference_point(&mechanization.state())),
            None => Ok(()),
        }
    }

    /// Flies with the increments at the places `parts`; `motion` gives the motion and its ideal increments. Only the end of the navigation
    /// shows whether the interval is good. Changes before it can be undone, and the errors are computed after it.
    #[inline(never)]
    fn fly<'r>(
        &mut self,
        parts: Range<usize>,
        recent: &Recent<'r>,
        motion: impl FnOnce(&mut SignalGenerator, &mut [Increment]) -> IntervalMotion<'r>,
        imperfections: &mut Imperfections,
    ) -> Result<(), Error> {
        let next = recent.next;
        let t = next.interval_s;
        let (settled, solution) = (self.generator.settled(), self.mechanization.solution());
        let last = core::mem::replace(&mut self.parts, parts.clone());
        self.views = Views::default();

        // Signal generator.
        let motion = motion(&mut self.generator, &mut self.signals.ideal[parts.clone()]);
        if !self.is_plain {
            self.complete_ideal_signals(&motion, recent, imperfections);
        }
        let ideal = &self.signals.ideal[parts.clone()];

        // Sensors.
        let mut on_ideal = imperfections.triads_are_ideal();
        let mut flags = ImuFlags::default();
        let mut increments = if on_ideal {
            ideal
        } else {
            let measured = &mut self.signals.measured[parts.clone()];
            imperfections.begin_interval(t, || IntervalConditions::of(recent, &motion, self.block.as_ref()));
            flags = imperfections.sense(ideal, t / ideal.len() as f64, measured);
            &*measured
        };

        // Mechanization.
        let mut measured = None;
        if let Some(compensation) = &self.compensation {
            let dt = t / parts.len() as f64;
            measured = Some(self.signals.compensate(&parts, on_ideal, compensation, dt));
            on_ideal = false;
            increments = &self.signals.measured[parts.clone()];
        }
        let aid = vertical_aid(self.options.vertical, next, |height_m| {
            imperfections.altimeter.sense(height_m, next.interval_s)
        });
        self.mechanization.navigate(increments, self.options.subsamples, t);
        let result = if self.is_plain {
            self.mechanization.aid_vertical(&aid, t);
            self.mechanization.check()
        } else {
            self.aid_and_observe(next, &aid, on_ideal);
            self.check()
        };
        if let Err(error) = result {
            self.generator.go_back(settled, recent);
            self.mechanization.go_back(&solution);
            self.parts = last;
            Self::undo_imperfections(&self.options, self.disturbance.is_some(), imperfections);
            return Err(error);
        }
        self.last = LastInterval::InParts {
            time_s: next.time_s,
            interval_s: t,
            on_ideal,
            measured,
            flags,
            vertical_unaided: aid == VerticalAid::None,
        };

        // Errors.
        if let Some(model) = &mut self.error_model {
            let (ideal, navigated) = self.signals.of(&parts, on_ideal);
            let mut errors = SensorErrors::between(ideal, navigated, t);
            if let Some(disturbance) = &self.disturbance {
                errors = errors.plus(disturbance.apparent_errors());
            }
            model.advance(&motion, next, &errors, &aid, self.block.as_ref());
        }
        for covariance in &mut *self.covariance {
            let (ideal, block) = (&self.signals.ideal[self.parts.clone()], self.block.as_ref());
            let is_aided = aid != VerticalAid::None;
            let flown =
                FlownInterval { motion: &motion, current: recent.current, next, ideal, is_aided, block };
            covariance.advance(&flown, &imperfections.parameters());
        }
        self.conclude(&motion, recent);
        Ok(())
    }

    /// Adds the truth of an interval to the closure, and counts the interval.
    #[inline]
    pub(super) fn conclude(&mut self, motion: &IntervalMotion<'_>, recent: &Recent<'_>) {
        let next = recent.next;
        let inconsistency = motion.displacement() - (next.state.r_e - recent.current.state.r_e);
        self.closure.advance(&self.earth, next, &inconsistency);
        self.intervals += 1;
    }

    /// Undoes the interval in each sensor and model that took part in it.
    #[cold]
    #[inline(never)]
    pub(super) fn undo_imperfections(
        options: &Options,
        is_disturbed: bool,
        imperfections: &mut Imperfections,
    ) {
        if !imperfections.triads_are_ideal() {
            imperfections.undo();
        }
        if options.vertical == VerticalMode::Damped {
            imperfections.altimeter.undo();
        }
        if is_disturbed {
            imperfections.gravity.undo();
        }
    }
}

impl Options {
    /// Number of mechanization updates over the interval that `recent` ends. In a gap, an interval much longer than the intervals before
    /// it because samples were lost or the host stopped for a moment, the updates are as long as before the gap,
    /// if there is enough memory for their increments. An update that is too long loses a part of a manoeuvre for good.
    ///
    /// Evidence: 1 s lost in a weave of 4 g at 100 Hz. The error 500 s later is 15 km with one update, and 5 cm with these updates.
    #[inline]
    pub(in crate::simulator) fn updates_over(&self, recent: &Recent<'_>) -> usize {
        match recent.gap_ratio() {
            None => self.updates_per_sample,
            Some(ratio) => {
                let most = MAX_INCREMENTS / (self.updates_per_sample * self.subsamples);
                self.updates_per_sample * ratio.min(most as f64).round() as usize
            }
        }
    }
}
