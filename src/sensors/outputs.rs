//! Outputs of a triad for the increments of an interval.

use nalgebra::Vector3;

use super::parameters::Sensor;
use crate::signal::Increment;

/// The triad's part of each increment.
#[derive(Debug)]
pub(super) struct Outputs<'a> {
    sensor: Sensor,
    increments: &'a mut [Increment],
}

impl<'a> Outputs<'a> {
    pub fn new(sensor: Sensor, increments: &'a mut [Increment]) -> Self {
        Self { sensor, increments }
    }

    /// The outputs, one after the other.
    #[inline(always)]
    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut Vector3<f64>> {
        let sensor = self.sensor;
        self.increments.iter_mut().map(move |increment| match sensor {
            Sensor::Gyro => &mut increment.angle,
            Sensor::Accelerometer => &mut increment.velocity,
        })
    }
}
