//! Errors with which the navigation starts.

use nalgebra::Vector3;

use super::initial_table::INITIAL;
use super::stream::{Purpose, Source, Stream, StreamKey};
use crate::base::error::Error;
use crate::base::rows::check;
use crate::base::snapshot::{codes, stored};
use crate::earth::state::StateErrors;

// The struct with its checks and numbers, which build.rs writes from the table.
include!(concat!(env!("OUT_DIR"), "/initial.rs"));

/// How the INS finds its attitude at the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Alignment {
    /// The INS starts with the true attitude, turned by the given and the drawn misalignment.
    #[default]
    Given,
    /// The library computes the attitude that levelling and gyrocompassing at rest would find with the sensor errors at the
    /// start. It does so even if the flight starts in motion. A vehicle that then is tilted by more than 10 degrees was level, with the
    /// heading that it has. The INS starts with this attitude, turned by the given and the
    /// drawn misalignment. Levelling comes first: it finds the tilt at which the accelerometers sense the reaction to normal gravity. At
    /// height this is not quite along the ellipsoid's normal: its horizontal part is 7.5 micro-g at 9 km and 45 degrees.
    /// Gyrocompassing then finds the heading at which the horizontal gyro rates point north. SINS_NAVIGATION_NORTH_UNKNOWN is set
    /// if the sensor errors hide north. Within 64 km of a pole the start returns SINS_ERROR_SINGULAR.
    LevelAndGyrocompass,
    /// The library computes the attitude that levelling at rest would find with the sensor errors at the start, with the true heading:
    /// the heading of a unit whose gyros cannot find north comes from another sensor. The INS starts with this attitude, turned by the
    /// given and the drawn misalignment, whose part about up is the heading error. Any latitude.
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
