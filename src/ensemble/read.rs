//! What is read of an ensemble.

use super::{Ensemble, is_of_truth};
use crate::error::{Error, ErrorKind, Rule};
use crate::errors::NavigationErrors;
use crate::sensors::{Failure, SensorOutput};
use crate::simulator::{ErrorSource, ImuInterval, Simulator, Solution};
use crate::statistics::Statistics;

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

    /// The same, with whether the truth is near a pole.
    pub(crate) fn errors_and_pole(
        &self,
        run: u64,
        source: ErrorSource,
    ) -> Result<Option<(f64, NavigationErrors, bool)>, Error> {
        self.run(run)?.errors_and_pole(source)
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

    /// Statistics of the errors of all runs at this moment; runs that have diverged are counted. Before the first step a run that
    /// cannot start is one of them.
    ///
    /// [`ErrorKind::BadState`]: no sample yet, or the error model is off.
    pub fn statistics(&self, source: ErrorSource) -> Result<Statistics, Error> {
        let mut statistics = Statistics::EMPTY;
        self.add_to(&mut statistics, source)?;
        Ok(statistics)
    }

    /// The same, added to `statistics`, which may be empty. On an error they are of no use.
    pub(crate) fn add_to(&self, statistics: &mut Statistics, source: ErrorSource) -> Result<(), Error> {
        for (run, diverged) in self.runs.iter().zip(&self.diverged) {
            if *diverged {
                statistics.add_diverged()?;
                continue;
            }
            match run.errors(source) {
                Ok(Some((_, errors))) => statistics.add(&errors)?,
                Ok(None) => return Err(Error::bad_state("no sample yet")),
                Err(error)
                    if matches!(error.kind, ErrorKind::Diverged | ErrorKind::Singular)
                        && !is_of_truth(&error) =>
                {
                    statistics.add_diverged()?;
                }
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }

    /// The failure of an output, which all runs share; `None`: it is sound.
    pub fn failure(&self, output: SensorOutput) -> Option<Failure> {
        self.runs.first().and_then(|run| run.failure(output))
    }

    /// Time stamp of the sample that was pushed last [s]; `None`: none yet.
    pub fn last_sample_time_s(&self) -> Option<f64> {
        self.intake.newest().map(|point| point.sample.time_s)
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
