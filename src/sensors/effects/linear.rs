//! Scale factor error and misalignment, given and drawn at turn-on.

use nalgebra::{Matrix3, Vector3};

use super::super::parameters::TriadParameters;
use super::super::stream::EffectStreams;
use super::effect::{DrawnOfInput, Effect, Input, OfInput};
use super::outputs::BatchOutputs;
use super::states::{States, Visitor};
use crate::base::snapshot::stored;
use crate::signal::RUNS;

/// δ = K ideal, K = diag(scale factor) + misalignment (dKG, dKA of the paper's equations (2) and (3)). Each element has an
/// additional σ z, with z drawn once a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sensors) struct Linear {
    /// z, one standard normal number an element.
    turn_on: Matrix3<f64>,
    matrix: Matrix3<f64>,
}

stored!(Linear {} rebuilt { turn_on, matrix });

/// Standard deviation of each element.
pub(crate) fn sigma(parameters: &TriadParameters) -> Matrix3<f64> {
    parameters.misalignment_sigma + Matrix3::from_diagonal(&parameters.scale_factor_sigma)
}

impl Effect for Linear {
    fn new(streams: &EffectStreams) -> Self {
        let mut scale_factors = streams.triad(0);
        let mut misalignments = streams.triad(1);
        let turn_on = Matrix3::from_fn(|row, column| {
            let streams = if row == column { &mut scale_factors } else { &mut misalignments };
            streams[row].normal()
        });
        Self { turn_on, matrix: Matrix3::zeros() }
    }

    fn set(&mut self, parameters: &TriadParameters) -> bool {
        let given = parameters.misalignment + Matrix3::from_diagonal(&parameters.scale_factor);
        let sigma = sigma(parameters);
        self.matrix = given + sigma.component_mul(&self.turn_on);
        // By the parameters alone, as those of the bias.
        given != Matrix3::zeros() || sigma != Matrix3::zeros()
    }

    fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.constants(self.matrix.iter_mut());
    }
}

impl OfInput for Linear {
    #[inline]
    fn error(&self, input: &Input) -> Vector3<f64> {
        Self::error_by(&self.matrix, input)
    }
}

impl DrawnOfInput for Linear {
    #[inline(always)]
    fn apply_each(states: &mut States<'_>, inputs: &[Input], outputs: &mut BatchOutputs<'_>) {
        let matrices = states.constants::<9>();
        for (input, output) in inputs.iter().zip(outputs.iter_mut()) {
            for lane in 0..RUNS {
                // The rows keep the matrix column by column.
                let matrix = Matrix3::from_fn(|row, column| matrices[3 * column + row][lane]);
                let error = Self::error_by(&matrix, input);
                for axis in 0..3 {
                    output[axis][lane] += error[axis];
                }
            }
        }
    }
}

impl Linear {
    #[inline(always)]
    fn error_by(matrix: &Matrix3<f64>, input: &Input) -> Vector3<f64> {
        matrix * input.signal
    }
}
