//! How far the bias of a sensor has walked at the end of the record.

use super::noise::COEFFICIENTS;
use super::parameter::Place;
use super::solve::{Fitted, Vector};
use super::whiten::Steps;
use crate::base::error::Error;

/// The random walk of a sensor at the end of the record, which begins at 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Walk {
    /// Mean \[rad/s\] or \[m/s²\], with the parameters that were found.
    pub mean: f64,
    /// Standard deviation, if the parameters are exact.
    pub sigma: f64,
    /// Change by errors of the coefficients of the sensor.
    by: [f64; COEFFICIENTS],
}

impl Walk {
    /// Mean of the sensor number `sensor` if the parameters have these errors.
    pub fn with(&self, sensor: usize, errors: &Vector) -> f64 {
        let coefficients = Place::coefficients(sensor, errors);
        self.mean - self.by.iter().zip(&coefficients).map(|(by, error)| by * error).sum::<f64>()
    }
}

/// The walks of the six sensors, each with the most probable shape of its noise.
pub(super) fn walks(fitted: &Fitted) -> Result<[Walk; 6], Error> {
    let steps = Steps::new(&fitted.rows.blocks)?;
    let mut walks = [Walk::default(); 6];
    for (sensor, walk) in walks.iter_mut().enumerate() {
        let evidence = &fitted.evidences[sensor];
        let filter = steps.filter(evidence.shape)?;
        let last = filter.whiten(&fitted.rows.of_sensor[sensor], |_, _| ());
        walk.by = core::array::from_fn(|k| last[1 + k]);
        walk.sigma = (evidence.square * filter.walk_variance).sqrt();
        walk.mean = last[0];
        walk.mean = walk.with(sensor, &fitted.solution[0].0);
    }
    Ok(walks)
}
