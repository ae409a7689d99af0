//! The requirement of a host.

use super::SolutionError;
use crate::base::error::{Error, Rule, check_range};

/// Largest error that the algorithm itself may cause at any time within a duration; 0: no limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Requirement {
    /// Duration, up to [`Self::MAX_DURATION_S`] [s]; 0, or less than the duration of the piece: that of the piece.
    pub duration_s: f64,
    /// Distance [m].
    pub position_m: f64,
    /// Speed of the difference in velocity against the Earth [m/s].
    pub velocity_m_s: f64,
    /// Angle between the attitudes against the Earth [rad].
    pub attitude_rad: f64,
    /// Margin: least ratio of the required error to the predicted error, at least 1.
    pub margin: f64,
}

impl Default for Requirement {
    fn default() -> Self {
        Self { duration_s: 0.0, position_m: 0.0, velocity_m_s: 0.0, attitude_rad: 0.0, margin: 2.0 }
    }
}

impl Requirement {
    /// Longest duration: eleven days [s].
    pub const MAX_DURATION_S: f64 = 1e6;

    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        check_range("requirement.duration_s", self.duration_s, 0.0, Self::MAX_DURATION_S)?;
        check_range("requirement.position_m", self.position_m, 0.0, 1e12)?;
        check_range("requirement.velocity_m_s", self.velocity_m_s, 0.0, 1e12)?;
        check_range("requirement.attitude_rad", self.attitude_rad, 0.0, 1e12)?;
        if self.limits() == SolutionError::default() {
            let words = "position_m, velocity_m_s or attitude_rad must be greater than 0";
            return Err(Error::invalid("requirement.position_m", self.position_m, Rule::Sentence(words)));
        }
        check_range("requirement.margin", self.margin, 1.0, 1e6)
    }

    /// The largest of the three ratios of an error, times the margin, to its limit. The requirement is met up to 1.
    pub fn share(&self, error: &SolutionError) -> f64 {
        error.times(self.margin).share_of(&self.limits())
    }

    fn limits(&self) -> SolutionError {
        let Self { position_m, velocity_m_s, attitude_rad, .. } = *self;
        SolutionError { position_m, velocity_m_s, attitude_rad }
    }
}
