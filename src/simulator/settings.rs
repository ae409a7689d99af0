//! Settings of the sensors by a host, before the first sample or in flight. They are read back before a flight, in flight, and from a
//! loaded snapshot.

use super::{Mode, Simulator};
use crate::base::error::Error;
use crate::sensors::{
    AltimeterParameters, Failure, GravityDisturbanceParameters, InitialErrorParameters, Sensor, SensorOutput,
    TriadParameters,
};
use crate::signal::mounting::MountingParameters;
use crate::truth::TruthPoint;

pub(super) const INCREMENTS_HAVE_NO_TEMPERATURE: &str =
    "temperature coefficients need samples with a temperature; increments have none";

impl Simulator {
    /// Sets the gyro errors, from the next interval on.
    pub fn set_gyro(&mut self, parameters: &TriadParameters) -> Result<(), Error> {
        parameters.validate(Sensor::Gyro)?;
        self.check_temperatures_for(parameters)?;
        self.imperfections.change(|set| set.gyro = *parameters);
        Ok(())
    }

    /// Sets the accelerometer errors, from the next interval on.
    pub fn set_accel(&mut self, parameters: &TriadParameters) -> Result<(), Error> {
        parameters.validate(Sensor::Accelerometer)?;
        self.check_temperatures_for(parameters)?;
        self.imperfections.change(|set| set.accel = *parameters);
        Ok(())
    }

    /// Sets the errors of the barometric height, from the next interval on.
    pub fn set_altimeter(&mut self, parameters: &AltimeterParameters) -> Result<(), Error> {
        parameters.validate()?;
        self.imperfections.change(|set| set.altimeter = *parameters);
        Ok(())
    }

    /// Lets an output fail from the next interval on. The failure replaces one that the output already has; `None` clears it. A
    /// reposition keeps failures; a reset clears them all. The alignment at the start ignores failures.
    pub fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>) -> Result<(), Error> {
        if let Some(failure) = &failure {
            failure.validate(output)?;
        }
        let last = self.imu().map(|imu| imu.mean_measured());
        self.imperfections.set_failure(output, failure, last.as_ref());
        Ok(())
    }

    /// Sets the errors with which the navigation starts; before the first step.
    pub fn set_initial_errors(&mut self, parameters: &InitialErrorParameters) -> Result<(), Error> {
        parameters.validate()?;
        self.refuse_after_start(
            "initial errors can be set before the first step, after a reset or after a reposition",
        )?;
        self.imperfections.change(|set| set.initial = *parameters);
        Ok(())
    }

    /// Sets where the sensor block sits and what the INS believes of it; before the first step. Navigation on increments navigates
    /// the block itself.
    pub fn set_mounting(&mut self, parameters: &MountingParameters) -> Result<(), Error> {
        parameters.validate()?;
        self.refuse_after_start(
            "the mounting can be set before the first step, after a reset or after a reposition",
        )?;
        self.imperfections.change(|set| set.mounting = *parameters);
        Ok(())
    }

    /// Sets true gravity less normal gravity along the track; before the first step. Increments of the host contain their own
    /// disturbance.
    pub fn set_gravity_disturbance(
        &mut self,
        parameters: &GravityDisturbanceParameters,
    ) -> Result<(), Error> {
        parameters.validate()?;
        self.refuse_after_start(
            "the gravity disturbance can be set before the first step, after a reset or after a reposition",
        )?;
        self.imperfections.change(|set| set.gravity = *parameters);
        Ok(())
    }

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
        self.intake.newest().map(TruthPoint::stamp_s)
    }

    fn refuse_after_start(&self, why: &'static str) -> Result<(), Error> {
        match self.mode {
            Mode::Waiting => Ok(()),
            _ => Err(Error::bad_state(why)),
        }
    }

    /// Rejects temperature coefficients if the samples or increments to be flown have no temperature.
    fn check_temperatures_for(&self, parameters: &TriadParameters) -> Result<(), Error> {
        if parameters.depend_on_temperature() { self.check_temperatures() } else { Ok(()) }
    }

    /// Rejects a state in which an effect would have no temperature.
    pub(super) fn check_temperatures(&self) -> Result<(), Error> {
        if let Mode::Navigating(_) = self.mode {
            return Err(Error::bad_state(INCREMENTS_HAVE_NO_TEMPERATURE));
        }
        if !self.intake.waiting_have_temperatures() {
            return Err(Error::bad_state(
                "samples without a temperature wait; step, reset or reposition before temperature coefficients are set",
            ));
        }
        Ok(())
    }
}
