//! Settings of the host, read back: before a flight, in flight, and from a loaded snapshot.

use super::Simulator;
use crate::mounting::MountingParameters;
use crate::sensors::{
    AltimeterParameters, Failure, GravityDisturbanceParameters, InitialErrorParameters, SensorOutput,
    TriadParameters,
};
use crate::truth::TruthPoint;

impl Simulator {
    /// Errors of the gyros, as they were set.
    pub fn gyro(&self) -> &TriadParameters {
        &self.imperfections.set().gyro
    }

    /// Errors of the accelerometers, as they were set.
    pub fn accel(&self) -> &TriadParameters {
        &self.imperfections.set().accel
    }

    /// Errors of the altimeter, as they were set.
    pub fn altimeter(&self) -> &AltimeterParameters {
        &self.imperfections.set().altimeter
    }

    /// Errors with which the navigation starts, as they were set.
    pub fn initial_errors(&self) -> &InitialErrorParameters {
        &self.imperfections.set().initial
    }

    /// Where the sensor block sits, as it was set.
    pub fn mounting(&self) -> &MountingParameters {
        &self.imperfections.set().mounting
    }

    /// True less normal gravity, as it was set.
    pub fn gravity_disturbance(&self) -> &GravityDisturbanceParameters {
        &self.imperfections.set().gravity
    }

    /// The failure of an output; `None`: it has no failure.
    pub fn failure(&self, output: SensorOutput) -> Option<Failure> {
        self.imperfections.failure(output)
    }

    /// Time stamps of the start and the end of the interval that was flown last [s]; `None`: none since the start or the last jump of the
    /// truth.
    pub fn last_interval_s(&self) -> Option<[f64; 2]> {
        self.intake.last_interval_s()
    }

    /// Time stamp of the sample that was pushed last [s]; `None`: none yet.
    pub fn last_sample_time_s(&self) -> Option<f64> {
        self.intake.newest().map(|point: &TruthPoint| point.stamp_s())
    }
}
