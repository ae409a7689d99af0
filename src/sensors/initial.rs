//! Errors with which the navigation starts.

use nalgebra::Vector3;

use super::stream::{Purpose, Source, Stream, StreamKey};
use crate::earth::state::StateErrors;

pub use crate::surroundings::{Alignment, InitialErrorParameters};

impl InitialErrorParameters {
    /// The errors of the run `key`, without the errors of the alignment.
    pub fn draw(&self, key: StreamKey) -> StateErrors {
        let drawn = |given: &Vector3<f64>, sigma: &Vector3<f64>, purpose| {
            let mut streams = Stream::triad(key, Source::InitialErrors, purpose);
            given + sigma.component_mul(&Vector3::from_fn(|axis, _| streams[axis].normal()))
        };
        StateErrors {
            position_n: drawn(&self.position_n, &self.position_sigma_n, Purpose::InitialPosition),
            velocity_n: drawn(&self.velocity_n, &self.velocity_sigma_n, Purpose::InitialVelocity),
            misalignment_n: drawn(
                &self.misalignment_n,
                &self.misalignment_sigma_n,
                Purpose::InitialMisalignment,
            ),
        }
    }
}
