//! Range, where the output saturates.

use nalgebra::Vector3;

use super::parameters::TriadParameters;

/// The mean signal of an increment is limited to ±r; r = 0 means no limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Range {
    /// r [u].
    limit: Vector3<f64>,
}

impl Range {
    pub fn new() -> Self {
        Self { limit: Vector3::zeros() }
    }

    /// Sets the parameters. Returns whether they call for the effect.
    pub fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.limit = parameters.range;
        self.limit != Vector3::zeros()
    }

    /// Acts on an increment over `dt` [s]. With a `dt` of 1 it acts on a signal [u]. Returns whether the signal was
    /// beyond the range.
    #[inline]
    pub fn apply(&self, dt: f64, measured: &mut Vector3<f64>) -> bool {
        let mut saturated = false;
        for axis in 0..3 {
            let limit = self.limit[axis] * dt;
            if self.limit[axis] != 0.0 && measured[axis].abs() > limit {
                measured[axis] = limit.copysign(measured[axis]);
                saturated = true;
            }
        }
        saturated
    }
}
