//! Reads of an ensemble.

use super::Ensemble;
use super::part::{PART_RUNS, Part};
use crate::base::error::{Error, ErrorKind, Rule};
use crate::ensemble::statistics::Statistics;
use crate::errors::NavigationErrors;
use crate::errors::correction::Compensation;
use crate::sensors::{Failure, SensorOutput};
use crate::simulator::{ErrorSource, ImuFlags, ImuInterval, Solution, is_of_truth};

impl Ensemble {
    /// The truth, which all runs share; `None` before the first sample.
    pub fn truth(&self) -> Option<Solution> {
        let Part { intake, runs, .. } = &self.parts[0];
        let flown = intake.current().and_then(|point| runs.truth(point));
        if flown.is_some() {
            return flown;
        }
        let point = intake.current().or(intake.front())?;
        Some(Solution::of_truth(&self.options, &self.options.earth(), point))
    }

    /// The navigated solution of a run; `None` before the first sample. [`ErrorKind::Diverged`]: the run has diverged.
    pub fn navigation(&self, run: u64) -> Result<Option<Solution>, Error> {
        let (Part { intake, runs, .. }, place) = self.at(self.place_of(run)?);
        runs.navigation(place, intake)
    }

    /// Time [s] and errors of the navigated solution of a run; `None` before the first sample. [`ErrorKind::Diverged`]: the run
    /// has diverged.
    pub fn errors(&self, run: u64, source: ErrorSource) -> Result<Option<(f64, NavigationErrors)>, Error> {
        Ok(self.errors_and_pole(run, source)?.map(|(time_s, errors, _)| (time_s, errors)))
    }

    /// Time [s] and errors as [`Self::errors`], and whether the truth is near a pole.
    pub(crate) fn errors_and_pole(
        &self,
        run: u64,
        source: ErrorSource,
    ) -> Result<Option<(f64, NavigationErrors, bool)>, Error> {
        self.errors_at(self.place_of(run)?, source)
    }

    /// Ideal and measured signals of the last interval of a run; `None` before the first. [`ErrorKind::Diverged`]: the run has
    /// diverged.
    pub fn imu(&self, run: u64) -> Result<Option<ImuInterval>, Error> {
        let (part, place) = self.at(self.place_of(run)?);
        Ok(part.runs.imu(place))
    }

    /// Flags of the signals of the last interval of each run, in the order of their numbers; none is set before the first. A run that
    /// has diverged keeps those of its last interval.
    pub fn imu_flags(&self) -> impl Iterator<Item = ImuFlags> {
        self.parts.iter().flat_map(|part| part.runs.imu_flags())
    }

    /// Compensation of the sensors of a run. [`ErrorKind::Diverged`]: the run has diverged.
    pub fn compensation(&self, run: u64) -> Result<Compensation, Error> {
        let (part, place) = self.at(self.place_of(run)?);
        Ok(part.runs.compensation(place))
    }

    /// The runs that have diverged, in the order of their numbers.
    pub fn diverged(&self) -> impl Iterator<Item = u64> + '_ {
        let places = (0..self.runs()).filter(|&place| self.diverged_s(place).is_some());
        places.map(|place| self.first_run + place as u64)
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

    /// Adds the statistics of all runs at this moment to `statistics`, which may be empty. After an error `statistics` is not
    /// usable.
    pub(crate) fn add_to(&self, statistics: &mut Statistics, source: ErrorSource) -> Result<(), Error> {
        for place in 0..self.runs() {
            match self.errors_unless_diverged(place, source)? {
                Some((_, errors, _)) => statistics.add(&errors)?,
                None => statistics.add_diverged()?,
            }
        }
        Ok(())
    }

    /// Time [s] and errors of the run at `place`, and whether the truth is near a pole; `None`: the run has diverged, or cannot start.
    pub(crate) fn errors_unless_diverged(
        &self,
        place: usize,
        source: ErrorSource,
    ) -> Result<Option<(f64, NavigationErrors, bool)>, Error> {
        if self.diverged_s(place).is_some() {
            return Ok(None);
        }
        match self.errors_at(place, source) {
            Ok(None) => Err(Error::bad_state("no sample yet")),
            Err(error)
                if matches!(error.kind, ErrorKind::Diverged | ErrorKind::Singular)
                    && !is_of_truth(&error) =>
            {
                Ok(None)
            }
            found => found,
        }
    }

    /// The failure of an output, which all runs share; `None`: no failure.
    pub fn failure(&self, output: SensorOutput) -> Option<Failure> {
        self.parts[0].runs.failure(output)
    }

    /// Time stamps of the start and the end of the interval that was flown last, as [`Simulator::last_interval_s`](crate::Simulator).
    pub fn last_interval_s(&self) -> Option<[f64; 2]> {
        self.parts[0].intake.last_interval_s()
    }

    /// Time stamp of the sample that was pushed last [s]; `None`: none yet.
    pub fn last_sample_time_s(&self) -> Option<f64> {
        self.parts[0].intake.newest().map(|point| point.stamp_s())
    }

    /// Time [s] and errors of the run at `place`, and whether the truth is near a pole.
    fn errors_at(
        &self,
        place: usize,
        source: ErrorSource,
    ) -> Result<Option<(f64, NavigationErrors, bool)>, Error> {
        let (Part { intake, runs, .. }, place) = self.at(place);
        runs.errors_and_pole(place, intake, source)
    }

    /// Time of the last good solution of the run at `place`, if it has diverged [s].
    pub(super) fn diverged_s(&self, place: usize) -> Option<f64> {
        let (part, place) = self.at(place);
        part.runs.diverged_s(place)
    }

    /// The part that has the run at `place`, and its place there.
    pub(super) fn at(&self, place: usize) -> (&Part, usize) {
        (&self.parts[place / PART_RUNS], place % PART_RUNS)
    }

    /// The place of a run, unless the run has diverged.
    pub(super) fn place_of(&self, run: u64) -> Result<usize, Error> {
        let place = run.checked_sub(self.first_run).and_then(|place| usize::try_from(place).ok());
        let Some(place) = place.filter(|&place| place < self.runs()) else {
            let last = self.first_run + (self.runs() as u64 - 1);
            return Err(Error::invalid("run", run, Rule::BetweenIntegers(self.first_run, last)));
        };
        match self.diverged_s(place) {
            None => Ok(place),
            Some(time_s) => {
                let rule =
                    Rule::SentenceWith("has diverged; its last good solution was at time_s =", time_s.into());
                Err(Error::of(ErrorKind::Diverged, "run", run, rule))
            }
        }
    }
}
