//! Dead zone.

use nalgebra::Vector3;

use super::parameters::TriadParameters;

/// The output is 0 while the mean signal of an increment is within ±d. Outside ±d the effect changes nothing (dead band, IEEE Std
/// 528).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DeadZone {
    /// d [u].
    half_width: Vector3<f64>,
}

impl DeadZone {
    pub fn new() -> Self {
        Self { half_width: Vector3::zeros() }
    }

    /// Sets the parameters. Returns whether they call for the effect.
    pub fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.half_width = parameters.dead_zone;
        self.half_width != Vector3::zeros()
    }

    /// Acts on an increment over `dt` [s]. With a `dt` of 1 it acts on a signal [u].
    #[inline]
    pub fn apply(&self, dt: f64, measured: &mut Vector3<f64>) {
        for axis in 0..3 {
            if self.half_width[axis] != 0.0 && measured[axis].abs() <= self.half_width[axis] * dt {
                measured[axis] = 0.0;
            }
        }
    }
}
