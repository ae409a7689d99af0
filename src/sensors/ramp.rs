//! Rate ramp, of accelerometers acceleration ramp.

use nalgebra::Vector3;

use super::kept::Kept;
use super::parameters::TriadParameters;
use crate::snapshot::stored;

/// b = R t, t since the run began or the ramp was set; ∫b dt over dt = (b + R dt/2) dt (IEEE Std 952, C.1.6).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ramp {
    /// R [u/s].
    slope: Vector3<f64>,
    /// b [u].
    value: Kept<Vector3<f64>>,
}

stored!(Ramp { value: 1e15 } rebuilt { slope });

impl Ramp {
    pub fn new() -> Self {
        Self { slope: Vector3::zeros(), value: Kept::new(Vector3::zeros()) }
    }

    /// Takes parameters; whether they call for the effect. Another slope bends the ramp; without one there is no ramp.
    pub fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.slope = parameters.ramp;
        *self.value = self.value.zip_map(&self.slope, |value, slope| if slope == 0.0 { 0.0 } else { value });
        self.slope != Vector3::zeros()
    }

    /// b [u]
    pub fn value(&self) -> Vector3<f64> {
        *self.value
    }

    /// Adds the integral over `dt` [s].
    #[inline]
    pub fn apply(&mut self, dt: f64, measured: &mut Vector3<f64>) {
        let change = self.slope * dt;
        *measured += (*self.value + change * 0.5) * dt;
        *self.value += change;
    }

    /// An interval begins, which [`Self::undo`] takes back.
    #[inline]
    pub fn keep(&mut self) {
        self.value.keep();
    }

    /// Takes the last interval back.
    pub fn undo(&mut self) {
        self.value.undo();
    }
}
