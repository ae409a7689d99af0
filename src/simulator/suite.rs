//! The sensors of a simulator and what the host set of them.

use super::Options;
use crate::error::Error;
use crate::sensors::{
    Altimeter, AltimeterParameters, InitialErrorParameters, Sensor, Triad, TriadParameters,
};
use crate::signal::Increment;
use crate::snapshot::{Reader, Stored, Writer, stored};

/// Which outputs were beyond their range in an interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Saturation {
    /// A gyro.
    pub gyro: bool,
    /// An accelerometer.
    pub accel: bool,
}

stored!(Saturation { gyro, accel });

/// Sensor models and what the host set of them.
#[derive(Debug, Clone)]
pub(super) struct SensorSuite {
    pub gyro: Triad,
    pub accel: Triad,
    pub altimeter: Altimeter,
    pub initial: InitialErrorParameters,
    gyro_parameters: TriadParameters,
    accel_parameters: TriadParameters,
    is_tame: bool,
    altimeter_parameters: AltimeterParameters,
}

/// The parameters first: they are set again, and the state of what they call for is laid over that.
impl Stored for SensorSuite {
    fn save(&self, to: &mut Writer<'_>) {
        let Self {
            gyro,
            accel,
            altimeter,
            initial,
            gyro_parameters,
            accel_parameters,
            is_tame: _,
            altimeter_parameters,
        } = self;
        gyro_parameters.save(to);
        accel_parameters.save(to);
        altimeter_parameters.save(to);
        initial.save(to);
        gyro.save(to);
        accel.save(to);
        altimeter.save(to);
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        let mut triad = TriadParameters::default();
        triad.load(from)?;
        triad.validate(Sensor::Gyro)?;
        self.set_gyro(&triad);
        triad.load(from)?;
        triad.validate(Sensor::Accelerometer)?;
        self.set_accel(&triad);
        let mut altimeter = AltimeterParameters::default();
        altimeter.load(from)?;
        altimeter.validate()?;
        self.set_altimeter(&altimeter);
        self.initial.load(from)?;
        self.initial.validate()?;
        self.gyro.load(from)?;
        self.accel.load(from)?;
        self.altimeter.load(from)
    }
}

impl SensorSuite {
    pub fn new(options: &Options) -> Self {
        Self {
            gyro: Triad::new(options.key, Sensor::Gyro),
            accel: Triad::new(options.key, Sensor::Accelerometer),
            altimeter: Altimeter::new(options.key, 0.0),
            initial: InitialErrorParameters::default(),
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
        fresh.set_gyro(&self.gyro_parameters);
        fresh.set_accel(&self.accel_parameters);
        fresh.set_altimeter(&self.altimeter_parameters);
        fresh
    }

    pub fn set_gyro(&mut self, parameters: &TriadParameters) {
        self.gyro_parameters = *parameters;
        self.is_tame = parameters.is_tame() && self.accel_parameters.is_tame();
        self.gyro.set(parameters);
    }

    pub fn set_accel(&mut self, parameters: &TriadParameters) {
        self.accel_parameters = *parameters;
        self.is_tame = parameters.is_tame() && self.gyro_parameters.is_tame();
        self.accel.set(parameters);
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

    /// Whether the altimeter is ideal too.
    pub fn all_are_ideal(&self) -> bool {
        self.are_ideal() && self.altimeter_parameters == AltimeterParameters::default()
    }
}
