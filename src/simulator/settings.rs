//! What can be set before the first step alone, as the start of the INS depends on it.

use super::{Mode, Simulator};
use crate::error::Error;
use crate::mounting::MountingParameters;
use crate::sensors::{GravityDisturbanceParameters, InitialErrorParameters};

impl Simulator {
    /// Sets the errors with which the navigation starts; before the first step.
    pub fn set_initial_errors(&mut self, parameters: &InitialErrorParameters) -> Result<(), Error> {
        parameters.validate()?;
        self.refuse_after_start(
            "initial errors can be set before the first step, after a reset or after a reposition",
        )?;
        self.sensors.initial = *parameters;
        Ok(())
    }

    /// Sets where the sensor block sits and what the INS believes of it; before the first step. Navigation on increments is
    /// that of the block itself.
    pub fn set_mounting(&mut self, parameters: &MountingParameters) -> Result<(), Error> {
        parameters.validate()?;
        self.refuse_after_start(
            "the mounting can be set before the first step, after a reset or after a reposition",
        )?;
        self.sensors.set_mounting((*parameters != MountingParameters::default()).then_some(*parameters));
        Ok(())
    }

    /// Sets true gravity less normal gravity along the track; before the first step. Increments of the host have felt their
    /// own.
    pub fn set_gravity_disturbance(
        &mut self,
        parameters: &GravityDisturbanceParameters,
    ) -> Result<(), Error> {
        parameters.validate()?;
        self.refuse_after_start(
            "the gravity disturbance can be set before the first step, after a reset or after a reposition",
        )?;
        self.sensors.gravity.set(parameters);
        Ok(())
    }

    fn refuse_after_start(&self, why: &'static str) -> Result<(), Error> {
        match self.mode {
            Mode::Waiting => Ok(()),
            _ => Err(Error::bad_state(why)),
        }
    }
}
