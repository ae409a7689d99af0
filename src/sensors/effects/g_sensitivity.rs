//! Sensitivity of gyros to specific force.

use nalgebra::{Matrix3, Vector3};

use super::super::parameters::TriadParameters;
use super::super::stream::EffectStreams;
use super::effect::{Effect, Input, OfInput};
use crate::base::snapshot::stored;

/// δω_i = Σ_j G_ij f_j + k_i f_i². The row of G is the gyro, its column is the axis of the force (mass unbalance and its cross
/// terms). k acts along each gyro's own axis (anisoelasticity; IEEE Std 528). The force is the true force at the block's own point.
///
/// For an increment Δv of force over dt, the first term is exact. The second term assumes a constant force over the increment:
/// k Δv² / dt. For a sine of frequency f it loses the share 1 - (sin x / x)², x = π f dt, of the mean square.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sensors) struct GSensitivity {
    /// G [(rad/s)/(m/s²)].
    linear: Matrix3<f64>,
    /// k [(rad/s)/(m/s²)²].
    quadratic: Vector3<f64>,
}

stored!(GSensitivity {} rebuilt { linear, quadratic });

impl Effect for GSensitivity {
    fn new(_: &EffectStreams) -> Self {
        Self { linear: Matrix3::zeros(), quadratic: Vector3::zeros() }
    }

    fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.linear = parameters.g_sensitivity;
        self.quadratic = parameters.g2_sensitivity;
        self.linear != Matrix3::zeros() || self.quadratic != Vector3::zeros()
    }
}

impl OfInput for GSensitivity {
    #[inline]
    fn error(&self, input: &Input) -> Vector3<f64> {
        let squares = input.force.component_mul(&input.force) / input.dt;
        self.linear * input.force + self.quadratic.component_mul(&squares)
    }
}
