//! All that makes an INS err, as a host sets it.

use super::{Options, Simulator, heap_simulator};
use crate::error::Error;
use crate::mounting::MountingParameters;
use crate::sensors::{
    AltimeterParameters, GravityDisturbanceParameters, InitialErrorParameters, Sensor, TriadParameters,
};

/// Settings of the sensors, of the start, of the mounting and of gravity. The default is ideal.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ErrorParameters {
    /// Errors of the gyros.
    pub gyro: TriadParameters,
    /// Errors of the accelerometers.
    pub accel: TriadParameters,
    /// Errors of the altimeter.
    pub altimeter: AltimeterParameters,
    /// Errors at the start.
    pub initial: InitialErrorParameters,
    /// Where the sensor block sits, and where the INS believes that it sits.
    pub mounting: MountingParameters,
    /// True gravity less the normal gravity with which the INS computes.
    pub gravity: GravityDisturbanceParameters,
}

impl ErrorParameters {
    /// The settings of a simulator, at any time.
    pub fn of(simulator: &Simulator) -> Self {
        *simulator.imperfections.set()
    }

    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        self.gyro.validate(Sensor::Gyro)?;
        self.accel.validate(Sensor::Accelerometer)?;
        self.altimeter.validate()?;
        self.initial.validate()?;
        self.mounting.validate()?;
        self.gravity.validate()
    }

    /// Sets all error parameters of a simulator.
    pub fn set_to(&self, simulator: &mut Simulator) -> Result<(), Error> {
        simulator.set_gyro(&self.gyro)?;
        simulator.set_accel(&self.accel)?;
        simulator.set_altimeter(&self.altimeter)?;
        simulator.set_initial_errors(&self.initial)?;
        simulator.set_mounting(&self.mounting)?;
        simulator.set_gravity_disturbance(&self.gravity)
    }

    /// A simulator before its first sample that has these errors.
    pub(crate) fn simulator(&self, options: &Options) -> Result<Box<[Simulator; 1]>, Error> {
        let mut memory = heap_simulator(options)?;
        self.set_to(&mut memory[0])?;
        Ok(memory)
    }
}
