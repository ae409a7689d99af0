//! All error parameters of a run.

use crate::error::Error;
use crate::mounting::MountingParameters;
use crate::sensors::{
    AltimeterParameters, GravityDisturbanceParameters, InitialErrorParameters, Sensor, TriadParameters,
};
use crate::simulator::Simulator;

/// What is set of the sensors, of the start, of the mounting and of gravity. The default is ideal.
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
    /// Of what the INS believes of its mounting, with the mounting itself.
    pub mounting: MountingParameters,
    /// Of the gravity that the INS computes.
    pub gravity: GravityDisturbanceParameters,
}

impl ErrorParameters {
    /// What is set in a simulator, at any moment of its life.
    pub fn of(simulator: &Simulator) -> Self {
        Self {
            gyro: *simulator.gyro(),
            accel: *simulator.accel(),
            altimeter: *simulator.altimeter(),
            initial: *simulator.initial_errors(),
            mounting: simulator.mounting(),
            gravity: *simulator.gravity_disturbance(),
        }
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

    pub(super) fn triad(&self, sensor: Sensor) -> &TriadParameters {
        match sensor {
            Sensor::Gyro => &self.gyro,
            Sensor::Accelerometer => &self.accel,
        }
    }

    pub(super) fn triad_mut(&mut self, sensor: Sensor) -> &mut TriadParameters {
        match sensor {
            Sensor::Gyro => &mut self.gyro,
            Sensor::Accelerometer => &mut self.accel,
        }
    }

    /// These parameters without errors. The kind of alignment, the reference temperature and the true mounting are not
    /// effects, and stay.
    pub(super) fn ideal(&self) -> Self {
        let mut ideal = Self::default();
        ideal.initial.alignment = self.initial.alignment;
        ideal.mounting = self.mounting.believed();
        ideal.gyro.reference_temperature_c = self.gyro.reference_temperature_c;
        ideal.accel.reference_temperature_c = self.accel.reference_temperature_c;
        ideal
    }

    /// Sets them all.
    pub fn set_to(&self, simulator: &mut Simulator) -> Result<(), Error> {
        simulator.set_gyro(&self.gyro)?;
        simulator.set_accel(&self.accel)?;
        simulator.set_altimeter(&self.altimeter)?;
        simulator.set_initial_errors(&self.initial)?;
        simulator.set_mounting(&self.mounting)?;
        simulator.set_gravity_disturbance(&self.gravity)
    }
}
