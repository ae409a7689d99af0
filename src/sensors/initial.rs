//! Errors with which the navigation starts.

use nalgebra::Vector3;

use super::stream::{Purpose, Source, Stream, StreamKey};
use crate::snapshot::codes;
use crate::state::StateErrors;

pub use crate::surroundings::InitialErrorParameters;

/// Where the misalignment at the start comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Alignment {
    /// The given misalignment, relative to the true attitude.
    #[default]
    Given,
    /// The given misalignment, relative to the attitude that levelling and gyrocompassing find with the sensor errors
    /// of the start.
    LevelAndGyrocompass,
    /// The given misalignment, relative to the attitude of the true heading that levelling finds with the sensor errors of the start.
    Level,
}

codes!(Alignment { Given = 0 "given", LevelAndGyrocompass = 1 "gyrocompass", Level = 2 "level" });

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
