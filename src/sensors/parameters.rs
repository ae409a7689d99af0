//! Parameters that a host sets for a triad of gyros or of accelerometers.

use core::slice::{from_mut, from_ref};

use nalgebra::{Matrix3, Vector3};

use super::stream::Source;
use super::table::PARAMETERS;
use crate::base::parameter::{Field, Parameter};
use crate::base::snapshot::{ANY, stored};
use crate::signal::Increment;

const COUNT: usize = PARAMETERS.len();

// `TriadParameters`, which build.rs writes from `table.rs`.
include!(concat!(env!("OUT_DIR"), "/triad_parameters.rs"));

/// Kind of a triad.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sensor {
    /// Angular rate; the unit u of the parameters is rad/s.
    Gyro,
    /// Specific force; the unit u of the parameters is m/s².
    Accelerometer,
}

impl Sensor {
    pub(super) fn source(self) -> Source {
        match self {
            Self::Gyro => Source::Gyro,
            Self::Accelerometer => Source::Accelerometer,
        }
    }

    /// The triad's part of an increment.
    pub(super) fn part_of(self, increment: &Increment) -> Vector3<f64> {
        match self {
            Self::Gyro => increment.angle,
            Self::Accelerometer => increment.velocity,
        }
    }
}

impl Parameter {
    /// The field of the parameter for sensors of this kind; `None`: they do not have the parameter.
    pub const fn of(&self, sensor: Sensor) -> Option<Field> {
        match sensor {
            Sensor::Gyro => self.gyro,
            Sensor::Accelerometer => self.accel,
        }
    }

    /// Whether it is the correlation time of the process whose standard deviation is the parameter `sigma`.
    pub fn is_time_of(&self, sigma: &str) -> bool {
        let is_of = |field: Field| field.range.needed_by() == Some(sigma);
        self.gyro.is_some_and(is_of) || self.accel.is_some_and(is_of)
    }
}
