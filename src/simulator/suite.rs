//! The sensors of a simulator and what the host set of them.

use nalgebra::Vector3;

use super::Options;
use crate::mounting::MountingParameters;
use crate::sensors::{
    Altimeter, AltimeterParameters, GravityDisturbance, InitialErrorParameters, Sensor, Triad,
    TriadParameters,
};
use crate::signal::Increment;

/// Which outputs were beyond their range in an interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Saturation {
    /// A gyro.
    pub gyro: bool,
    /// An accelerometer.
    pub accel: bool,
}

/// Sensor models and what the host set of them.
#[derive(Debug, Clone)]
pub(super) struct SensorSuite {
    pub gyro: Triad,
    pub accel: Triad,
    pub altimeter: Altimeter,
    /// Of the gravity that the accelerometers feel.
    pub gravity: GravityDisturbance,
    pub initial: InitialErrorParameters,
    /// Where gyros and accelerometers sit, if not at the reference point.
    mounting: Option<MountingParameters>,
    gyro_parameters: TriadParameters,
    accel_parameters: TriadParameters,
    is_tame: bool,
    altimeter_parameters: AltimeterParameters,
}

impl SensorSuite {
    pub fn new(options: &Options) -> Self {
        Self {
            gyro: Triad::new(options.key, Sensor::Gyro),
            accel: Triad::new(options.key, Sensor::Accelerometer),
            altimeter: Altimeter::new(options.key, 0.0),
            gravity: GravityDisturbance::new(options.key),
            initial: InitialErrorParameters::default(),
            mounting: None,
            gyro_parameters: TriadParameters::default(),
            accel_parameters: TriadParameters::default(),
            is_tame: true,
            altimeter_parameters: AltimeterParameters::default(),
        }
    }

    /// The same parameters, all processes and streams back at their start.
    pub fn restarted(&self, options: &Options) -> Self {
        let mut fresh = Self::new(options);
        fresh.initial = self.initial;
        fresh.set_mounting(self.mounting);
        fresh.gravity.set(self.gravity.parameters());
        fresh.set_gyro(&self.gyro_parameters);
        fresh.set_accel(&self.accel_parameters);
        fresh.set_altimeter(&self.altimeter_parameters);
        fresh
    }

    pub fn set_gyro(&mut self, parameters: &TriadParameters) {
        self.gyro_parameters = *parameters;
        self.judge_tameness();
        self.gyro.set(parameters);
    }

    pub fn set_accel(&mut self, parameters: &TriadParameters) {
        self.accel_parameters = *parameters;
        self.judge_tameness();
        self.accel.set(parameters);
    }

    pub fn set_mounting(&mut self, mounting: Option<MountingParameters>) {
        self.mounting = mounting;
        self.judge_tameness();
    }

    pub fn mounting(&self) -> Option<&MountingParameters> {
        self.mounting.as_ref()
    }

    /// An arm adds ω² l and ω' l to what the truth's velocity bounds.
    fn judge_tameness(&mut self) {
        self.is_tame = self.gyro_parameters.is_tame()
            && self.accel_parameters.is_tame()
            && self.mounting.is_none_or(|mounting| mounting.lever_arm_m == Vector3::zeros());
    }

    pub fn set_altimeter(&mut self, parameters: &AltimeterParameters) {
        self.altimeter_parameters = *parameters;
        self.altimeter.set(parameters);
    }

    /// The truth jumped to `height_m`: what follows the signals settles there at once, noise goes on.
    pub fn reposition(&mut self, height_m: f64) {
        self.gyro.reposition();
        self.accel.reposition();
        self.altimeter.reposition(height_m);
    }

    /// What the two triads make of the ideal increments of an interval, each over `dt` [s].
    #[inline]
    pub fn sense(&mut self, ideal: &[Increment], dt: f64, measured: &mut [Increment]) -> Saturation {
        for (measured, ideal) in measured.iter_mut().zip(ideal) {
            *measured =
                Increment { angle: self.gyro.sense(ideal, dt), velocity: self.accel.sense(ideal, dt) };
        }
        Saturation { gyro: self.gyro.take_saturated(), accel: self.accel.take_saturated() }
    }

    /// Whether gyros and accelerometers cannot throw a solution out of its range in one interval.
    pub fn are_tame(&self) -> bool {
        self.is_tame
    }

    /// Whether gyros and accelerometers are ideal.
    pub fn are_ideal(&self) -> bool {
        self.gyro.is_ideal() && self.accel.is_ideal()
    }

    /// Whether nothing makes the INS err: the altimeter is ideal too, gravity is normal and the mounting known.
    pub fn all_are_ideal(&self) -> bool {
        self.are_ideal()
            && self.altimeter_parameters == AltimeterParameters::default()
            && !self.gravity.is_on()
            && self.mounting.as_ref().is_none_or(MountingParameters::is_believed)
    }
}
