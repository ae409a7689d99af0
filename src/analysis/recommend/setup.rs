//! The part of a configured simulator on which the error of its algorithm depends.

use super::Rung;
use crate::base::error::Error;
use crate::signal::mounting::MountingParameters;
use crate::simulator::{Options, Simulator, heap_simulator};

/// Options and mounting: they decide which motion is integrated, and how. A block away from the reference point measures each
/// angular acceleration as specific force.
///
/// Errors of sensors, altimeter, start and believed mounting, and the gravity disturbance, are not part of it. They act on an
/// algorithm's solution and on its reference in the same way, so the difference of the two changes only in second order.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Setup {
    /// Options, of which the algorithm is replaced.
    pub options: Options,
    /// Mounting of the sensor block; errors of what the INS believes about it do not matter.
    pub mounting: MountingParameters,
}

impl Setup {
    /// The setup of a simulator, at any moment.
    pub fn of(simulator: &Simulator) -> Self {
        Self { options: *simulator.options(), mounting: *simulator.mounting() }
    }

    /// This setup with another algorithm.
    pub fn with(&self, rung: &Rung) -> Self {
        Self { options: rung.applied_to(&self.options), ..*self }
    }

    /// This setup without the closed loop, which keeps the navigation at the truth, and without the error model, which does
    /// not act on it.
    pub(super) fn physical(&self) -> Self {
        Self { options: Options { closed_loop_time_s: None, error_model: false, ..self.options }, ..*self }
    }

    /// A simulator before its first sample, without errors.
    pub(super) fn simulator(&self) -> Result<Box<[Simulator; 1]>, Error> {
        let mut memory = heap_simulator(&self.options)?;
        memory[0].set_mounting(&self.mounting.believed())?;
        Ok(memory)
    }
}

impl From<Options> for Setup {
    /// A block at the reference point.
    fn from(options: Options) -> Self {
        Self { options, ..Self::default() }
    }
}
