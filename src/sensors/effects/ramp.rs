//! Rate ramp of gyros, acceleration ramp of accelerometers.

use nalgebra::Vector3;

use super::super::kept::Kept;
use super::super::parameters::TriadParameters;
use super::super::stream::EffectStreams;
use super::effect::{Added, Effect};
use super::outputs::{BatchOutputs, Outputs};
use super::process::Processes;
use super::states::{States, Visitor};
use crate::base::snapshot::{WALKS, stored};
use crate::signal::RUNS;

/// b = R t, t since the run began or the ramp was set; ∫b dt over dt = (b + R dt/2) dt (IEEE Std 952, C.1.6).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sensors) struct Ramp {
    /// R [u/s].
    slope: Vector3<f64>,
    /// b [u].
    value: Kept<Vector3<f64>>,
}

stored!(Ramp { value: WALKS } rebuilt { slope });

impl Effect for Ramp {
    fn new(_: &EffectStreams) -> Self {
        Self { slope: Vector3::zeros(), value: Kept::new(Vector3::zeros()) }
    }

    // With a new slope the ramp continues from its current value; a slope of 0 ends the ramp.
    fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.slope = parameters.ramp;
        *self.value = self.value.zip_map(&self.slope, |value, slope| if slope == 0.0 { 0.0 } else { value });
        self.slope != Vector3::zeros()
    }

    fn undo(&mut self) {
        self.value.undo();
    }

    fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.numbers(self.value.iter_mut());
    }
}

impl Added for Ramp {
    const PROCESSES: Processes = Processes::NONE;

    #[inline(never)]
    fn apply(&mut self, dt: f64, mut outputs: Outputs<'_>) {
        self.value.keep();
        outputs.iter_mut().for_each(|output| *output += Self::advance(&self.slope, &mut self.value, dt));
    }

    #[inline(always)]
    fn apply_each(&self, states: &mut States<'_>, outputs: &mut BatchOutputs<'_>) {
        let (values, dt) = (states.numbers::<3>(), outputs.dt);
        for output in outputs.iter_mut() {
            for lane in 0..RUNS {
                let mut value = Vector3::from_fn(|i, _| values[i][lane]);
                let integral = Self::advance(&self.slope, &mut value, dt);
                for axis in 0..3 {
                    values[axis][lane] = value[axis];
                    output[axis][lane] += integral[axis];
                }
            }
        }
    }

    fn value(&self) -> Vector3<f64> {
        *self.value
    }
}

impl Ramp {
    /// Moves `value` on by `dt` [s]. Returns the integral of `value`.
    #[inline(always)]
    fn advance(slope: &Vector3<f64>, value: &mut Vector3<f64>, dt: f64) -> Vector3<f64> {
        let change = slope * dt;
        let integral = (*value + change * 0.5) * dt;
        *value += change;
        integral
    }
}
