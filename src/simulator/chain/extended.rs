//! Parts that only some flights have in addition to the plain chain: a mounting, gravity beyond the normal field, a closed loop.

use nalgebra::Vector3;

use super::Chain;
use crate::mechanization::{VerticalAid, VerticalMode};
use crate::signal::mounting::Block;
use crate::signal::{Increment, IntervalMotion};
use crate::simulator::aid::{aid_vertical, vertical_aid};
use crate::simulator::chain::view::Views;
use crate::simulator::imu::LastInterval;
use crate::simulator::{Imperfections, ImuInterval};
use crate::truth::{Recent, TruthPoint};

impl Chain {
    /// Applies mounting, closed loop and gravity to the generator's signals. The closed loop's shadow flies the signals without the
    /// gravity disturbance, because it computes with normal gravity.
    #[inline(never)]
    pub(super) fn complete_ideal_signals(
        &mut self,
        motion: &IntervalMotion<'_>,
        recent: &Recent<'_>,
        imperfections: &mut Imperfections,
    ) {
        let mut signals = core::mem::take(&mut self.signals);
        let ideal = &mut signals.ideal[self.parts.clone()];
        self.mount_and_trim(motion, recent, !imperfections.are_none(), ideal);
        if let Some(disturbance) = &mut self.disturbance {
            disturbance.fly(
                &self.earth,
                recent,
                motion,
                self.block.as_ref(),
                &mut imperfections.gravity,
                ideal,
            );
        }
        self.signals = signals;
    }

    /// Applies mounting and closed loop to the ideal signals, which is the same for all runs. Returns by how much the navigators of
    /// the runs must be shifted [m/s], Earth-fixed axes; this chain's navigator is already shifted. `navigator_errs`: something
    /// makes the INS err.
    #[inline(never)]
    pub(super) fn mount_and_trim(
        &mut self,
        motion: &IntervalMotion<'_>,
        recent: &Recent<'_>,
        navigator_errs: bool,
        ideal: &mut [Increment],
    ) -> Option<Vector3<f64>> {
        let (next, t) = (recent.next, recent.next.interval_s);
        let mut shift_e = None;
        if let Some(block) = &mut self.block {
            let revised = self.generator.take_revised();
            shift_e = block.mount(&self.earth, motion, recent.current, revised, ideal);
            if let Some(dv_e) = &shift_e {
                self.mechanization.shift_velocity(dv_e);
                if let Some(closed_loop) = &mut self.closed_loop {
                    closed_loop.shift_velocity(dv_e);
                }
            }
        }
        if let Some(closed_loop) = &mut self.closed_loop {
            closed_loop.trim(ideal, t);
            if let Some(shadow) = closed_loop.shadow(&self.mechanization, navigator_errs) {
                shadow.navigate(ideal, self.options.subsamples, t);
                let aid = vertical_aid(self.options.vertical, next, Some);
                aid_vertical(shadow, &self.earth, &aid, t, self.block.as_ref().map(Block::true_belief));
            }
        }
        shift_e
    }

    /// Aids the vertical channel of a chain that is not plain, and updates block and closed loop after the interval to `next`.
    #[inline(never)]
    pub(super) fn aid_and_observe(&mut self, next: &TruthPoint, aid: &VerticalAid, on_ideal: bool) {
        let t = next.interval_s;
        if let Some(block) = &mut self.block {
            let (ideal, navigated) = self.signals.of(&self.parts, on_ideal);
            block.observe(&Increment::sum(ideal), &Increment::sum(navigated), t);
        }
        let belief = self.block.as_ref().map(Block::belief);
        aid_vertical(&mut self.mechanization, &self.earth, aid, t, belief);
        self.close_loop(next);
    }

    /// Flies what all runs share: [`Self::mount_and_trim`], and the closed loop at the end of the interval. The navigators of the runs
    /// are elsewhere. Returns by how much they must be shifted, and whether this part is within its limits; if not, it is as it was before.
    #[inline(never)]
    pub(super) fn fly_shared(
        &mut self,
        motion: &IntervalMotion<'_>,
        recent: &Recent<'_>,
        navigators_err: bool,
        ideal: &mut [Increment],
    ) -> (Option<Vector3<f64>>, bool) {
        let before = self.closed_loop.clone().map(|closed_loop| (closed_loop, self.mechanization));
        let shift_e = self.mount_and_trim(motion, recent, navigators_err, ideal);
        let (Some(closed_loop), Some(before)) = (&mut self.closed_loop, before) else {
            return (shift_e, true);
        };
        let next = recent.next;
        let has_shadow = closed_loop.shadow_mut().is_some();
        if !has_shadow {
            // Nothing makes the INS err: this navigator equals the navigator of each run.
            self.mechanization.navigate(ideal, self.options.subsamples, next.interval_s);
            let aid = vertical_aid(self.options.vertical, next, Some);
            let belief = self.block.as_ref().map(Block::belief);
            aid_vertical(&mut self.mechanization, &self.earth, &aid, next.interval_s, belief);
        }
        self.close_loop(next);
        let is_good = self.closed_loop.as_ref().is_none_or(|closed_loop| closed_loop.check().is_ok())
            && (has_shadow || self.mechanization.check().is_ok());
        if !is_good {
            (self.closed_loop, self.mechanization) = (Some(before.0), before.1);
        }
        (shift_e, is_good)
    }

    /// Concludes an interval that all runs have flown.
    pub(super) fn conclude_shared(
        &mut self,
        motion: &IntervalMotion<'_>,
        recent: &Recent<'_>,
        ideal: &[Increment],
    ) {
        let imu = ImuInterval {
            time_s: recent.next.time_s,
            interval_s: recent.next.interval_s,
            ideal: Increment::sum(ideal),
            ..ImuInterval::default()
        };
        let vertical_unaided = self.options.vertical == VerticalMode::Free;
        self.views = Views::default();
        self.last = LastInterval::Summed { imu, vertical_unaided };
        self.conclude(motion, recent);
    }

    fn close_loop(&mut self, next: &TruthPoint) {
        if let Some(closed_loop) = &mut self.closed_loop {
            let truth = self.block.as_ref().map_or(next.state, |block| block.state(next));
            closed_loop.observe(&self.mechanization, &truth, next.time_s);
        }
    }
}
