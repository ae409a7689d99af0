//! Dead zone.

use nalgebra::Vector3;

use super::parameters::TriadParameters;

/// The output is 0 while the mean signal of an increment lies within ±d, and what it is without the effect elsewhere (dead
/// band, IEEE Std 528).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DeadZone {
    /// d [u].
    half_width: Vector3<f64>,
}

impl DeadZone {
    pub fn new() -> Self {
        Self { half_width: Vector3::zeros() }
    }

    /// Takes parameters; whether they call for the effect.
    pub fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.half_width = parameters.dead_zone;
        self.half_width != Vector3::zeros()
    }

    /// Acts on an increment over `dt` [s]; on a signal [u], with 1.
    #[inline]
    pub fn apply(&self, dt: f64, measured: &mut Vector3<f64>) {
        for axis in 0..3 {
            if self.half_width[axis] != 0.0 && measured[axis].abs() <= self.half_width[axis] * dt {
                measured[axis] = 0.0;
            }
        }
    }
}
