//! The request for a budget.

use crate::analysis::recommend::SolutionError;
use crate::base::error::{Error, check_integer, check_range};

/// Number of runs, and limits of what may be left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BudgetRequest {
    /// Runs of each random effect, within the limits [`Self::RUNS`].
    pub runs: u64,
    /// Limits of the error that all left-out effects may cause together, at any time of the scene; 0: no limit.
    pub limits: SolutionError,
}

impl Default for BudgetRequest {
    fn default() -> Self {
        Self { runs: 16, limits: SolutionError::default() }
    }
}

impl BudgetRequest {
    /// Least number of runs, below which a 1σ is too uncertain, and largest number.
    pub const RUNS: (u64, u64) = (8, 1000);

    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        check_integer("request.runs", self.runs, Self::RUNS.0, Self::RUNS.1)?;
        check_range("request.position_m", self.limits.position_m, 0.0, 1e12)?;
        check_range("request.velocity_m_s", self.limits.velocity_m_s, 0.0, 1e12)?;
        check_range("request.attitude_rad", self.limits.attitude_rad, 0.0, 1e12)
    }

    /// Whether there is a limit.
    pub fn has_limits(&self) -> bool {
        self.limits != SolutionError::default()
    }

    /// The largest ratio of `error` to a limit; 0 without limits.
    pub fn share(&self, error: &SolutionError) -> f64 {
        error.share_of(&self.limits)
    }
}
