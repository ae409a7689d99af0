//! What is read of an ensemble.

use super::Ensemble;
use crate::error::{Error, ErrorKind, Rule};
use crate::errors::NavigationErrors;
use crate::simulator::{ErrorSource, ImuInterval, Simulator, Solution};

impl Ensemble {
    /// The truth, which all runs share; `None` before the first sample.
    pub fn truth(&self) -> Option<Solution> {
        let living = self.runs.iter().zip(&self.diverged).find(|(_, diverged)| !**diverged);
        if let Some((run, _)) = living {
            return run.truth().ok().flatten();
        }
        let point = self.intake.current().or(self.intake.front())?;
        Some(Solution::of_truth(&self.options, &self.options.earth(), point))
    }

    /// The navigated solution of a run; `None` before the first sample. [`ErrorKind::Diverged`]: the run has diverged.
    pub fn navigation(&self, run: u64) -> Result<Option<Solution>, Error> {
        self.run(run)?.navigation()
    }

    /// Time [s] and errors of the navigated solution of a run; `None` before the first sample. [`ErrorKind::Diverged`]: the run
    /// has diverged.
    pub fn errors(&self, run: u64, source: ErrorSource) -> Result<Option<(f64, NavigationErrors)>, Error> {
        self.run(run)?.errors(source)
    }

    /// Ideal and measured signals of the last interval of a run; `None` before the first. [`ErrorKind::Diverged`]: the run has
    /// diverged.
    pub fn imu(&self, run: u64) -> Result<Option<ImuInterval>, Error> {
        Ok(self.run(run)?.imu())
    }

    /// The runs that have diverged, in the order of their numbers.
    pub fn diverged(&self) -> impl Iterator<Item = u64> + '_ {
        (self.first_run..=u64::MAX).zip(&self.diverged).filter(|(_, diverged)| **diverged).map(|(run, _)| run)
    }

    /// A run by its number, unless it has diverged.
    fn run(&self, run: u64) -> Result<&Simulator, Error> {
        let place = run.checked_sub(self.first_run).and_then(|place| usize::try_from(place).ok());
        let found = place.and_then(|place| Some((self.runs.get(place)?, self.diverged.get(place)?)));
        match found {
            Some((simulator, false)) => Ok(simulator),
            Some((simulator, true)) => {
                let time_s = simulator.truth().ok().flatten().map_or(0.0, |truth| truth.time_s);
                let rule = Rule::WordsAnd("has diverged; its last good solution was at time_s =", time_s);
                Err(Error::of(ErrorKind::Diverged, "run", run, rule))
            }
            None => {
                let last = self.first_run + (self.runs.len() as u64 - 1);
                Err(Error::invalid("run", run, Rule::Between(self.first_run as f64, last as f64)))
            }
        }
    }
}
