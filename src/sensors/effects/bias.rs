//! Bias: a given constant and one drawn at turn-on.

use nalgebra::Vector3;

use super::super::parameters::TriadParameters;
use super::super::stream::EffectStreams;
use super::effect::{Added, Effect};
use super::outputs::{BatchOutputs, Outputs};
use super::process::{Kind, Processes};
use super::states::{States, Visitor};
use crate::base::snapshot::stored;
use crate::signal::RUNS;

/// ε_b = bias + σ z, z drawn once a run (the paper's random constant).
///
/// Departure: the paper prints ε_b = 0 for its derivative.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sensors) struct Bias {
    /// z, one standard normal number an axis.
    turn_on: Vector3<f64>,
    value: Vector3<f64>,
}

stored!(Bias {} rebuilt { turn_on, value });

impl Effect for Bias {
    fn new(streams: &EffectStreams) -> Self {
        let [mut x, mut y, mut z] = streams.triad(0);
        Self { turn_on: Vector3::new(x.normal(), y.normal(), z.normal()), value: Vector3::zeros() }
    }

    fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.value = parameters.bias + parameters.bias_sigma.component_mul(&self.turn_on);
        // By the parameters alone: the product of a subnormal sigma is 0 in some runs, and all runs have the same effects.
        parameters.bias != Vector3::zeros() || parameters.bias_sigma != Vector3::zeros()
    }

    fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.constants(self.value.iter_mut());
    }
}

impl Added for Bias {
    const PROCESSES: Processes = Processes {
        count: 1,
        are_walks: false,
        of: |triad, axis, _| (Kind::Constant, triad.bias_sigma[axis]),
    };

    #[inline]
    fn apply(&mut self, dt: f64, mut outputs: Outputs<'_>) {
        let integral = self.value * dt;
        outputs.iter_mut().for_each(|output| *output += integral);
    }

    #[inline(always)]
    fn apply_each(&self, states: &mut States<'_>, outputs: &mut BatchOutputs<'_>) {
        let (value, dt) = (states.constants::<3>(), outputs.dt);
        for output in outputs.iter_mut() {
            for axis in 0..3 {
                for lane in 0..RUNS {
                    output[axis][lane] += value[axis][lane] * dt;
                }
            }
        }
    }

    fn value(&self) -> Vector3<f64> {
        self.value
    }
}
