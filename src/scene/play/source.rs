//! Where the samples of a scene in flight come from.

use std::sync::Arc;

use nalgebra::Vector3;

use super::super::{Samples, Scene};
use crate::base::error::Error;
use crate::log::FlightLog;
use crate::truth::FlightSample;
use crate::truth::flight::Flight;

/// Where the samples come from.
#[derive(Debug, Clone)]
pub enum Source {
    /// A flight that is built in or made of manoeuvres.
    Flight(Arc<Flight>),
    /// A flight log.
    Log(Arc<FlightLog>),
    /// The host, sample by sample.
    Host,
}

impl Source {
    /// The flight of `scene`, which is not a log.
    pub fn flight_of(scene: &Scene) -> Result<Self, Error> {
        Ok(Self::Flight(Arc::new(scene.flight()?)))
    }

    /// The samples that `scene` flies; `None`: those of the host have no end.
    pub fn samples(&self, scene: &Scene) -> Result<Option<Samples>, Error> {
        match self {
            Self::Flight(_) => scene.samples(None).map(Some),
            Self::Log(log) => scene.samples(Some(log)).map(Some),
            Self::Host => Ok(None),
        }
    }

    /// Sample `index`, from 0, of a flight sampled at the rate of `scene`, or of the log.
    pub fn sample(&self, index: usize, scene: &Scene) -> Result<FlightSample, Error> {
        match self {
            // Rounding must not move the last time past the end.
            Self::Flight(flight) => flight.sample_at((index as f64 / scene.rate_hz).min(flight.duration_s())),
            Self::Log(log) => {
                let sample = log.samples().get(index).copied();
                let sample = sample.ok_or_else(|| Error::bad_state("the log has no further sample"))?;
                Ok(if index == 0 { with_velocity(sample, log.samples().get(1), scene) } else { sample })
            }
            Self::Host => Err(Error::bad_state("the samples come from the host: push them")),
        }
    }

    /// The line of the log on which sample `index` stands.
    pub fn line(&self, index: usize) -> Option<u64> {
        match self {
            Self::Log(log) => log.line(index),
            Self::Flight(_) | Self::Host => None,
        }
    }
}

/// The first sample of a log without velocities with the mean velocity up to the next: what the simulator takes when it has both. So the
/// first record has it.
fn with_velocity(first: FlightSample, next: Option<&FlightSample>, scene: &Scene) -> FlightSample {
    let Some(next) = next.filter(|next| first.v_n.is_none() && next.time_s > first.time_s) else {
        return first;
    };
    let (way_e, [east, north, up]) =
        scene.simulator_options().earth().displacement(&next.place, &first.place);
    let mean_e = way_e / (next.time_s - first.time_s);
    FlightSample { v_n: Some(Vector3::new(mean_e.dot(&east), mean_e.dot(&north), mean_e.dot(&up))), ..first }
}
