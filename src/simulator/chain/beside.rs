//! What only some flights have beside the plain chain: a mounting, gravity beyond the normal field, a closed loop.

use super::Chain;
use super::fly::navigate;
use crate::mechanization::VerticalAid;
use crate::mounting::Block;
use crate::signal::IntervalMotion;
use crate::simulator::SensorSuite;
use crate::simulator::aid::{aid_vertical, vertical_aid};
use crate::simulator::signals::Signals;
use crate::simulator::suite::IntervalConditions;
use crate::truth::{Recent, TruthPoint};

impl Chain {
    /// What mounting, closed loop and gravity make of the generator's signals. The closed loop's shadow flies them without the
    /// last, as it computes with normal gravity.
    #[inline(never)]
    pub(super) fn complete_ideal_signals(
        &mut self,
        motion: &IntervalMotion<'_>,
        recent: &Recent<'_>,
        sensors: &mut SensorSuite,
    ) {
        let (parts, next) = (self.parts.clone(), recent.next);
        let t = next.interval_s;
        let ideal = &mut self.signals.ideal[parts];
        if let Some(block) = &mut self.block {
            let revised = self.generator.take_revised();
            if let Some(dv_e) = block.mount(&self.earth, motion, recent.current, revised, ideal) {
                self.mechanization.shift_velocity(&dv_e);
                if let Some(closed_loop) = &mut self.closed_loop {
                    closed_loop.shift_velocity(&dv_e);
                }
            }
        }
        if let Some(closed_loop) = &mut self.closed_loop {
            closed_loop.trim(ideal, t);
            if let Some(shadow) = closed_loop.shadow(&self.mechanization, !sensors.all_are_ideal()) {
                navigate(shadow, self.options.subsamples, ideal, t);
                let aid = vertical_aid(self.options.vertical, next, Some);
                aid_vertical(shadow, &self.earth, &aid, t, self.block.as_ref().map(Block::true_belief));
            }
        }
        if let Some(disturbance) = &mut self.disturbance {
            sensors.gravity.advance(&self.earth, recent.current, next);
            disturbance.advance(sensors.gravity.at(&self.earth, next), motion, self.block.as_ref(), ideal);
        }
    }

    /// Keeps the vertical channel of a navigator that is not plain, and looks at what it makes of the interval to `next`.
    #[inline(never)]
    pub(super) fn aid_and_observe(&mut self, next: &TruthPoint, aid: &VerticalAid, sensors_were_ideal: bool) {
        let (parts, t) = (self.parts.clone(), next.interval_s);
        if let Some(block) = &mut self.block {
            let Signals { ideal, measured } = &self.signals;
            let increments = if sensors_were_ideal { ideal } else { measured };
            block.observe(&ideal[parts.clone()], &increments[parts], t);
        }
        let belief = self.block.as_ref().map(Block::belief);
        aid_vertical(&mut self.mechanization, &self.earth, aid, t, belief);
        if let Some(closed_loop) = &mut self.closed_loop {
            let truth = self.block.as_ref().map_or(next.state, |block| block.state(next));
            closed_loop.observe(&self.mechanization, &truth, next.time_s);
        }
    }
}

/// What the interval of `motion` brings to the sensors of `block`.
#[cold]
#[inline(never)]
pub(super) fn conditions(
    recent: &Recent<'_>,
    motion: &IntervalMotion<'_>,
    block: Option<&Block>,
) -> IntervalConditions {
    let turning = motion.turning();
    let turning = block.map_or(turning, |block| turning.in_axes(|vector_b| block.in_block_axes(vector_b)));
    IntervalConditions {
        temperatures_c: [recent.current.sample.temperature_c, recent.next.sample.temperature_c],
        turning: Some(turning),
    }
}
