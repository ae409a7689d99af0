//! All that errs in a run, as it is set.

use crate::error::Error;
use crate::sensors::{AltimeterParameters, InitialErrorParameters, Sensor, TriadParameters};
use crate::simulator::Simulator;

/// What is set of the sensors and of the start. The default is ideal.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ErrorParameters {
    /// Of the gyros.
    pub gyro: TriadParameters,
    /// Of the accelerometers.
    pub accel: TriadParameters,
    /// Of the altimeter.
    pub altimeter: AltimeterParameters,
    /// Of the start.
    pub initial: InitialErrorParameters,
}

impl ErrorParameters {
    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        self.gyro.validate(Sensor::Gyro)?;
        self.accel.validate(Sensor::Accelerometer)?;
        self.altimeter.validate()?;
        self.initial.validate()
    }

    /// The same with ideal sensors and a start without errors; where its misalignment comes from and which temperature is that
    /// of reference are no effects and stay.
    pub(super) fn ideal(&self) -> Self {
        let mut ideal = Self::default();
        ideal.initial.alignment = self.initial.alignment;
        ideal.gyro.reference_temperature_c = self.gyro.reference_temperature_c;
        ideal.accel.reference_temperature_c = self.accel.reference_temperature_c;
        ideal
    }

    /// Sets them all.
    pub fn set_to(&self, simulator: &mut Simulator) -> Result<(), Error> {
        simulator.set_gyro(&self.gyro)?;
        simulator.set_accel(&self.accel)?;
        simulator.set_altimeter(&self.altimeter)?;
        simulator.set_initial_errors(&self.initial)
    }
}
