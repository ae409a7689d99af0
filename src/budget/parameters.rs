//! The error parameters that a budget needs: those of one sensor, or none.

use crate::sensors::{Sensor, TriadParameters};
use crate::simulator::ErrorParameters;

impl ErrorParameters {
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

    /// These parameters without errors. Kind and length of the alignment, the reference temperature and the true mounting are not
    /// effects, and stay.
    pub(super) fn ideal(&self) -> Self {
        let mut ideal = Self::default();
        ideal.initial.alignment = self.initial.alignment;
        ideal.initial.alignment_s = self.initial.alignment_s;
        ideal.mounting = self.mounting.believed();
        ideal.gyro.reference_temperature_c = self.gyro.reference_temperature_c;
        ideal.accel.reference_temperature_c = self.accel.reference_temperature_c;
        ideal
    }
}
