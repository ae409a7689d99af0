//! Bias: a given constant and one drawn at turn-on.

use nalgebra::Vector3;

use super::outputs::Outputs;
use super::parameters::{Sensor, TriadParameters};
use super::states::{States, Visitor};
use super::stream::{Purpose, Stream, StreamKey};
use crate::signal::{IncrementRows, RUNS};

/// ε_b = bias + σ z, z drawn once a run (the paper's random constant).
///
/// Departure: the paper prints ε_b = 0 for its derivative.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bias {
    /// z, one standard normal number an axis.
    turn_on: Vector3<f64>,
    value: Vector3<f64>,
}

impl Bias {
    pub fn new(key: StreamKey, sensor: Sensor) -> Self {
        let [mut x, mut y, mut z] = Stream::triad(key, sensor.source(), Purpose::TurnOnBias);
        Self { turn_on: Vector3::new(x.normal(), y.normal(), z.normal()), value: Vector3::zeros() }
    }

    /// Sets the parameters. Returns whether they call for the effect.
    pub fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.value = parameters.bias + parameters.bias_sigma.component_mul(&self.turn_on);
        self.value != Vector3::zeros()
    }

    /// The bias [u].
    pub fn value(&self) -> Vector3<f64> {
        self.value
    }

    /// Adds the integral over each increment of length `dt` [s].
    #[inline]
    pub fn apply(&self, dt: f64, mut outputs: Outputs<'_>) {
        let integral = self.value * dt;
        outputs.iter_mut().for_each(|output| *output += integral);
    }

    /// Visits the state of a run.
    pub fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.constants(self.value.iter_mut());
    }

    /// [`Self::apply`] for the runs of a block.
    #[inline(always)]
    pub fn apply_each(states: &mut States<'_>, dt: f64, outputs: &mut [IncrementRows], first: usize) {
        let value = states.constants::<3>();
        for output in outputs {
            for axis in 0..3 {
                for lane in 0..RUNS {
                    output[first + axis][lane] += value[axis][lane] * dt;
                }
            }
        }
    }
}
