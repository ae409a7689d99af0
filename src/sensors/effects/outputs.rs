//! Outputs of a triad for the increments of an interval.

use nalgebra::Vector3;

use super::super::parameters::Sensor;
use crate::signal::{Increment, IncrementRows, RUNS, Row};

/// The triad's part of each increment.
#[derive(Debug)]
pub(in crate::sensors) struct Outputs<'a> {
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

/// The triad's part of each increment of the runs of a batch.
#[derive(Debug)]
pub(in crate::sensors) struct BatchOutputs<'a> {
    pub sensor: Sensor,
    /// Length of an increment [s].
    pub dt: f64,
    pub increments: &'a mut [IncrementRows],
    /// Not 0 for a run with an output beyond the range.
    pub saturated: &'a mut [u64; RUNS],
}

impl BatchOutputs<'_> {
    /// The outputs, one after the other: rows of the three axes.
    #[inline(always)]
    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut [Row; 3]> {
        let triad = self.sensor as usize;
        self.increments.iter_mut().map(move |increment| &mut increment.as_chunks_mut().0[triad])
    }

    /// Lets `act` change the outputs of the runs 0 to `count`, one run after the other. `act` gets the number of the run in the
    /// batch, the output, and the mark of a run beyond the range.
    #[inline(always)]
    pub fn each_run(&mut self, count: usize, mut act: impl FnMut(usize, &mut Vector3<f64>, &mut u64)) {
        let first = 3 * self.sensor as usize;
        for output in self.increments.iter_mut() {
            for (lane, saturated) in self.saturated.iter_mut().enumerate().take(count) {
                let mut vector = Vector3::from_fn(|axis, _| output[first + axis][lane]);
                act(lane, &mut vector, saturated);
                for axis in 0..3 {
                    output[first + axis][lane] = vector[axis];
                }
            }
        }
    }
}
