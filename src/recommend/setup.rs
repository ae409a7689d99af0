//! What of a configured simulator the error of its algorithm depends on.

use super::Rung;
use crate::error::Error;
use crate::mounting::MountingParameters;
use crate::simulator::{Options, Simulator, heap_simulator};

/// Options and mounting: they decide which motion is integrated, and how. A block off the reference point feels every jolt of
/// the attitude as specific force.
///
/// Errors of sensors, altimeter and start, gravity beyond the normal field and a wrong belief of the mounting do not belong to
/// it. They move an algorithm's solution and its reference's alike; the difference of both changes in second order alone.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Setup {
    /// Options, of which the algorithm is replaced.
    pub options: Options,
    /// Where the sensor block sits; what the INS wrongly believes of that does not matter.
    pub mounting: MountingParameters,
}

impl Setup {
    /// That of a simulator, at any moment of its life.
    pub fn of(simulator: &Simulator) -> Self {
        Self { options: *simulator.options(), mounting: simulator.mounting() }
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
    pub(super) fn simulator(&self) -> Result<Box<[Simulator]>, Error> {
        let mut memory = heap_simulator(&self.options)?;
        for simulator in &mut *memory {
            simulator.set_mounting(&self.mounting.believed())?;
        }
        Ok(memory)
    }
}

impl From<Options> for Setup {
    /// A block at the reference point.
    fn from(options: Options) -> Self {
        Self { options, ..Self::default() }
    }
}
