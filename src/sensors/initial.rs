//! Errors with which the navigation starts.

use nalgebra::Vector3;

use super::stream::{Purpose, Source, Stream, StreamKey};
use crate::checks::check_off_or;
use crate::error::{Error, check_ranges};
use crate::snapshot::{ANY, codes, stored};
use crate::state::StateErrors;

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

/// Initial errors, computed less true, east-north-up axes. Each error is the sum of a given part and a part that is
/// drawn once a run.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct InitialErrorParameters {
    /// Given position error [m].
    pub position_n: Vector3<f64>,
    /// Given velocity error [m/s].
    pub velocity_n: Vector3<f64>,
    /// Given misalignment φ, a rotation vector [rad]: computed C = exp(-[φ×]) C.
    pub misalignment_n: Vector3<f64>,
    /// Standard deviation of the drawn position error [m].
    pub position_sigma_n: Vector3<f64>,
    /// Standard deviation of the drawn velocity error [m/s].
    pub velocity_sigma_n: Vector3<f64>,
    /// Standard deviation of the drawn misalignment [rad].
    pub misalignment_sigma_n: Vector3<f64>,
    /// Attitude to which the misalignment is relative.
    pub alignment: Alignment,
    /// Time of levelling and gyrocompassing, or of levelling [s]; 0: without end. A given attitude does not use it.
    pub alignment_s: f64,
}

/// Shortest and longest alignment [s].
const ALIGNMENTS_S: (f64, f64) = (1.0, 86_400.0);

codes!(Alignment { Given = 0 "given", LevelAndGyrocompass = 1 "gyrocompass", Level = 2 "level" });

stored!(InitialErrorParameters {
    position_n: ANY,
    velocity_n: ANY,
    misalignment_n: ANY,
    position_sigma_n: ANY,
    velocity_sigma_n: ANY,
    misalignment_sigma_n: ANY,
    alignment,
    alignment_s: ALIGNMENTS_S.1,
});

impl InitialErrorParameters {
    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        let pi = core::f64::consts::PI;
        check_ranges("initial.position_enu_m", self.position_n.as_slice(), -1e6, 1e6)?;
        check_ranges("initial.velocity_enu_m_s", self.velocity_n.as_slice(), -1e4, 1e4)?;
        check_ranges("initial.misalignment_enu_rad", self.misalignment_n.as_slice(), -pi, pi)?;
        check_ranges("initial.position_sigma_enu_m", self.position_sigma_n.as_slice(), 0.0, 1e5)?;
        check_ranges("initial.velocity_sigma_enu_m_s", self.velocity_sigma_n.as_slice(), 0.0, 1e3)?;
        check_ranges("initial.misalignment_sigma_enu_rad", self.misalignment_sigma_n.as_slice(), 0.0, 1.0)?;
        check_off_or("initial.alignment_s", self.alignment_s, ALIGNMENTS_S.0, ALIGNMENTS_S.1)
    }

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
