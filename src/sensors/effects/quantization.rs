//! Quantization of the output increments.

use nalgebra::Vector3;

use super::super::kept::Kept;
use super::super::parameters::TriadParameters;
use super::super::stream::EffectStreams;
use super::effect::{Effect, OnOutput};
use super::outputs::{BatchOutputs, Outputs};
use super::states::{States, Visitor};
use crate::base::snapshot::{SIGNALS, stored};
use crate::signal::RUNS;

/// The output is rounded to a whole number of pulses of q [u s]. The remainder, at most q/2, is carried to the next increment, so
/// that the integral is never wrong by more than q/2. The quantization noise of IEEE Std 952 is Q = q/√12.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sensors) struct Quantization {
    /// q [u s].
    pulse: Vector3<f64>,
    /// Remainder [u s].
    residual: Kept<Vector3<f64>>,
}

stored!(Quantization { residual: SIGNALS } rebuilt { pulse });

impl Effect for Quantization {
    fn new(_: &EffectStreams) -> Self {
        Self { pulse: Vector3::zeros(), residual: Kept::new(Vector3::zeros()) }
    }

    fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.pulse = parameters.quantization;
        *self.residual =
            self.residual.zip_map(&self.pulse, |rest, pulse| if pulse == 0.0 { 0.0 } else { rest });
        self.pulse != Vector3::zeros()
    }

    fn undo(&mut self) {
        self.residual.undo();
    }

    fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.numbers(self.residual.iter_mut());
    }
}

impl OnOutput for Quantization {
    #[inline(never)]
    fn apply(&mut self, _dt: f64, mut outputs: Outputs<'_>) {
        self.residual.keep();
        for axis in (0..3).filter(|&axis| self.pulse[axis] != 0.0) {
            let residual = &mut self.residual[axis];
            outputs
                .iter_mut()
                .for_each(|output| Self::quantize(self.pulse[axis], &mut output[axis], residual));
        }
    }

    #[inline(always)]
    fn apply_each(&self, states: &mut States<'_>, outputs: &mut BatchOutputs<'_>) {
        let residuals = states.numbers::<3>();
        for output in outputs.iter_mut() {
            for axis in 0..3 {
                let pulse = self.pulse[axis];
                if pulse != 0.0 {
                    for lane in 0..RUNS {
                        Self::quantize(pulse, &mut output[axis][lane], &mut residuals[axis][lane]);
                    }
                }
            }
        }
    }

    // An average removes it.
    fn limit(&self, _: &mut Vector3<f64>) {}
}

impl Quantization {
    /// Rounds the sum of `measured` and the last remainder to whole pulses.
    #[inline(always)]
    fn quantize(pulse: f64, measured: &mut f64, residual: &mut f64) {
        let all = *measured + *residual;
        *measured = (all / pulse).round() * pulse;
        *residual = all - *measured;
    }
}
