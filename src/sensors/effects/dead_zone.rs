//! Dead zone.

use nalgebra::Vector3;

use super::super::parameters::TriadParameters;
use super::super::stream::EffectStreams;
use super::effect::{Effect, OnOutput};
use super::outputs::{BatchOutputs, Outputs};
use super::states::States;
use crate::base::snapshot::stored;
use crate::signal::RUNS;

/// The output is 0 while the mean signal of an increment is within ±d. Outside ±d the effect changes nothing (dead band, IEEE Std
/// 528).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sensors) struct DeadZone {
    /// d [u].
    half_width: Vector3<f64>,
}

stored!(DeadZone {} rebuilt { half_width });

impl Effect for DeadZone {
    fn new(_: &EffectStreams) -> Self {
        Self { half_width: Vector3::zeros() }
    }

    fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.half_width = parameters.dead_zone;
        self.half_width != Vector3::zeros()
    }
}

impl OnOutput for DeadZone {
    #[inline(never)]
    fn apply(&mut self, dt: f64, mut outputs: Outputs<'_>) {
        outputs.iter_mut().for_each(|output| self.act(dt, output));
    }

    #[inline(always)]
    fn apply_each(&self, _: &mut States<'_>, outputs: &mut BatchOutputs<'_>) {
        let dt = outputs.dt;
        outputs.each_run(RUNS, |_, output, _| self.act(dt, output));
    }

    fn limit(&self, signal: &mut Vector3<f64>) {
        self.act(1.0, signal);
    }
}

impl DeadZone {
    /// Acts on an increment over `dt` [s].
    #[inline(always)]
    fn act(&self, dt: f64, measured: &mut Vector3<f64>) {
        for axis in 0..3 {
            if self.half_width[axis] != 0.0 && measured[axis].abs() <= self.half_width[axis] * dt {
                measured[axis] = 0.0;
            }
        }
    }
}
