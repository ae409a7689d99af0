//! Sensitivity of gyros to specific force.

use nalgebra::{Matrix3, Vector3};

use super::input::Input;
use super::parameters::TriadParameters;

/// δω = G f: row = gyro, column = axis of the force (mass unbalance and its cross terms, IEEE Std 528); of increments, exactly.
/// The force is the true one at the block's own point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct GSensitivity {
    /// G [(rad/s)/(m/s²)].
    matrix: Matrix3<f64>,
}

impl GSensitivity {
    pub fn new() -> Self {
        Self { matrix: Matrix3::zeros() }
    }

    /// Takes parameters; whether they call for the effect.
    pub fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.matrix = parameters.g_sensitivity;
        self.matrix != Matrix3::zeros()
    }

    /// Error [rad].
    #[inline]
    pub fn error(&self, input: &Input) -> Vector3<f64> {
        self.matrix * input.force
    }
}
