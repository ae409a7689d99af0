//! Scale factor asymmetry.

use nalgebra::Vector3;

use super::input::Input;
use super::parameters::TriadParameters;

/// δ = a/2 |s|: the scale factor of positive signals s exceeds the scale factor of negative signals by a. Their mean is
/// unchanged (K' of IEEE Std 1293). The error of an increment is exact if the signal keeps its sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Asymmetry {
    /// a/2
    half: Vector3<f64>,
}

impl Asymmetry {
    pub fn new() -> Self {
        Self { half: Vector3::zeros() }
    }

    /// Sets the parameters. Returns whether they call for the effect.
    pub fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.half = parameters.scale_factor_asymmetry * 0.5;
        self.half != Vector3::zeros()
    }

    /// Error [u s].
    #[inline]
    pub fn error(&self, input: &Input) -> Vector3<f64> {
        self.half.component_mul(&input.signal.abs())
    }
}
