//! Rate ramp of gyros, acceleration ramp of accelerometers.

use nalgebra::Vector3;

use super::kept::Kept;
use super::parameters::TriadParameters;
use super::states::{States, Visitor};
use crate::signal::{IncrementRows, RUNS};
use crate::snapshot::stored;

/// b = R t, t since the run began or the ramp was set; ∫b dt over dt = (b + R dt/2) dt (IEEE Std 952, C.1.6).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ramp {
    /// R [u/s].
    slope: Vector3<f64>,
    /// b [u].
    value: Kept<Vector3<f64>>,
}

stored!(Ramp { value: 1e15 } rebuilt { slope });

impl Ramp {
    pub fn new() -> Self {
        Self { slope: Vector3::zeros(), value: Kept::new(Vector3::zeros()) }
    }

    /// Sets the parameters. Returns whether they call for the effect. With a new slope the ramp continues from its
    /// current value; a slope of 0 ends the ramp.
    pub fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.slope = parameters.ramp;
        *self.value = self.value.zip_map(&self.slope, |value, slope| if slope == 0.0 { 0.0 } else { value });
        self.slope != Vector3::zeros()
    }

    /// b [u]
    pub fn value(&self) -> Vector3<f64> {
        *self.value
    }

    /// Adds the integral over `dt` [s].
    #[inline]
    pub fn apply(&mut self, dt: f64, measured: &mut Vector3<f64>) {
        *measured += Self::advance(&self.slope, &mut self.value, dt);
    }

    /// Moves `value` on by `dt` [s]. Returns the integral of `value`.
    #[inline(always)]
    fn advance(slope: &Vector3<f64>, value: &mut Vector3<f64>, dt: f64) -> Vector3<f64> {
        let change = slope * dt;
        let integral = (*value + change * 0.5) * dt;
        *value += change;
        integral
    }

    /// Visits the state of a run.
    pub fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.numbers(self.value.iter_mut());
    }

    /// [`Self::apply`] for each increment of the runs of a block.
    #[inline(always)]
    pub fn apply_each(&self, states: &mut States<'_>, dt: f64, outputs: &mut [IncrementRows], first: usize) {
        let values = states.numbers::<3>();
        for output in outputs {
            for lane in 0..RUNS {
                let mut value = Vector3::from_fn(|i, _| values[i][lane]);
                let integral = Self::advance(&self.slope, &mut value, dt);
                for axis in 0..3 {
                    values[axis][lane] = value[axis];
                    output[first + axis][lane] += integral[axis];
                }
            }
        }
    }

    /// Begins an interval, which [`Self::undo`] can undo.
    #[inline]
    pub fn keep(&mut self) {
        self.value.keep();
    }

    /// Undoes the last interval.
    pub fn undo(&mut self) {
        self.value.undo();
    }
}
