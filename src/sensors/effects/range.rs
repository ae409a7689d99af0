//! Range, where the output saturates.

use nalgebra::Vector3;

use super::super::parameters::TriadParameters;
use super::super::stream::EffectStreams;
use super::effect::{Effect, OnOutput};
use super::outputs::{BatchOutputs, Outputs};
use super::states::States;
use crate::base::snapshot::stored;
use crate::signal::RUNS;

/// The mean signal of an increment is limited to ±r; r = 0 means no limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sensors) struct Range {
    /// r [u].
    limit: Vector3<f64>,
    /// Whether an output has been beyond the range since the flag was taken.
    saturated: bool,
}

stored!(Range {} rebuilt { limit, saturated });

impl Effect for Range {
    fn new(_: &EffectStreams) -> Self {
        Self { limit: Vector3::zeros(), saturated: false }
    }

    fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.limit = parameters.range;
        self.limit != Vector3::zeros()
    }
}

impl OnOutput for Range {
    #[inline(never)]
    fn apply(&mut self, dt: f64, mut outputs: Outputs<'_>) {
        outputs.iter_mut().for_each(|output| self.saturated |= self.act(dt, output));
    }

    #[inline(always)]
    fn apply_each(&self, _: &mut States<'_>, outputs: &mut BatchOutputs<'_>) {
        let dt = outputs.dt;
        outputs.each_run(RUNS, |_, output, saturated| *saturated |= u64::from(self.act(dt, output)));
    }

    fn limit(&self, signal: &mut Vector3<f64>) {
        self.act(1.0, signal);
    }
}

impl Range {
    /// Whether an output has been beyond the range since the last call.
    #[inline]
    pub fn take_saturated(&mut self) -> bool {
        core::mem::take(&mut self.saturated)
    }

    /// Acts on an increment over `dt` [s]. Returns whether the signal was beyond the range.
    #[inline(always)]
    fn act(&self, dt: f64, measured: &mut Vector3<f64>) -> bool {
        let mut saturated = false;
        for axis in 0..3 {
            let limit = self.limit[axis] * dt;
            if self.limit[axis] != 0.0 && measured[axis].abs() > limit {
                measured[axis] = limit.copysign(measured[axis]);
                saturated = true;
            }
        }
        saturated
    }
}
