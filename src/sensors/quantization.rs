//! Quantization of the output increments.

use nalgebra::Vector3;

use super::kept::Kept;
use super::parameters::TriadParameters;
use super::states::{States, Visitor};
use crate::signal::{IncrementRows, RUNS};
use crate::snapshot::{SIGNALS, stored};

/// The output is rounded to a whole number of pulses of q [u s]. The remainder, at most q/2, is carried to the next increment, so
/// that the integral is never wrong by more than q/2. The quantization noise of IEEE Std 952 is Q = q/√12.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Quantization {
    /// q [u s].
    pulse: Vector3<f64>,
    /// Remainder [u s].
    residual: Kept<Vector3<f64>>,
}

stored!(Quantization { residual: SIGNALS } rebuilt { pulse });

impl Quantization {
    pub fn new() -> Self {
        Self { pulse: Vector3::zeros(), residual: Kept::new(Vector3::zeros()) }
    }

    /// Sets the parameters. Returns whether they call for the effect.
    pub fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.pulse = parameters.quantization;
        *self.residual =
            self.residual.zip_map(&self.pulse, |rest, pulse| if pulse == 0.0 { 0.0 } else { rest });
        self.pulse != Vector3::zeros()
    }

    /// Acts on an increment.
    #[inline]
    pub fn apply(&mut self, measured: &mut Vector3<f64>) {
        for axis in 0..3 {
            let pulse = self.pulse[axis];
            if pulse != 0.0 {
                Self::quantize(pulse, &mut measured[axis], &mut self.residual[axis]);
            }
        }
    }

    /// Rounds the sum of `measured` and the last remainder to whole pulses.
    #[inline(always)]
    fn quantize(pulse: f64, measured: &mut f64, residual: &mut f64) {
        let all = *measured + *residual;
        *measured = (all / pulse).round() * pulse;
        *residual = all - *measured;
    }

    /// Visits the state of a run.
    pub fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.numbers(self.residual.iter_mut());
    }

    /// [`Self::apply`] for each increment of the runs of a block.
    #[inline(always)]
    pub fn apply_each(&self, states: &mut States<'_>, outputs: &mut [IncrementRows], first: usize) {
        let residuals = states.numbers::<3>();
        for output in outputs {
            for axis in 0..3 {
                let pulse = self.pulse[axis];
                if pulse != 0.0 {
                    for lane in 0..RUNS {
                        Self::quantize(pulse, &mut output[first + axis][lane], &mut residuals[axis][lane]);
                    }
                }
            }
        }
    }

    /// Begins an interval, which [`Self::undo`] can undo.
    #[inline]
    pub fn keep(&mut self) {
        self.residual.keep();
    }

    /// Undoes the last interval.
    pub fn undo(&mut self) {
        self.residual.undo();
    }
}
