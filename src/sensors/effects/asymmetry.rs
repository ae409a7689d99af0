//! Scale factor asymmetry.

use nalgebra::Vector3;

use super::super::parameters::TriadParameters;
use super::super::stream::EffectStreams;
use super::effect::{Effect, Input, OfInput};
use crate::base::snapshot::stored;

/// δ = a/2 |s|: the scale factor of positive signals s exceeds the scale factor of negative signals by a. Their mean is
/// unchanged (K' of IEEE Std 1293). The error of an increment is exact if the signal keeps its sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sensors) struct Asymmetry {
    /// a/2
    half: Vector3<f64>,
}

stored!(Asymmetry {} rebuilt { half });

impl Effect for Asymmetry {
    fn new(_: &EffectStreams) -> Self {
        Self { half: Vector3::zeros() }
    }

    fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.half = parameters.scale_factor_asymmetry * 0.5;
        self.half != Vector3::zeros()
    }
}

impl OfInput for Asymmetry {
    #[inline]
    fn error(&self, input: &Input) -> Vector3<f64> {
        self.half.component_mul(&input.signal.abs())
    }
}
