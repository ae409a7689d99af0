//! Scale factor error and misalignment.

use nalgebra::{Matrix3, Vector3};

use super::parameters::TriadParameters;

/// δ = K ideal, K = diag(scale factor) + misalignment (dKG, dKA of the paper's equations (2) and (3)).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Linear {
    matrix: Matrix3<f64>,
}

impl Linear {
    pub fn new() -> Self {
        Self { matrix: Matrix3::zeros() }
    }

    /// Takes parameters; whether they call for the effect.
    pub fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.matrix = parameters.misalignment + Matrix3::from_diagonal(&parameters.scale_factor);
        self.matrix != Matrix3::zeros()
    }

    /// Error [u] for the ideal signal [u].
    #[inline]
    pub fn error(&self, ideal: &Vector3<f64>) -> Vector3<f64> {
        self.matrix * ideal
    }
}
