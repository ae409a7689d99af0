//! What a scene does over the time of its flight: temperature, failures and updates.

use super::{Failing, PlannedFailure, Scene, Temperature};
use crate::base::error::{Error, Rule, check_range, check_within};
use crate::ensemble::Ensemble;
use crate::errors::NavigationErrors;
use crate::errors::correction::Correction;
use crate::sensors::{Failure, SensorOutput, StreamKey};
use crate::simulator::Simulator;
use crate::truth::{FlightSample, Pushed};

impl Failing {
    /// Whether the two spans overlap.
    pub fn meets(&self, other: &Self) -> bool {
        self.from_s < other.until_s && other.from_s < self.until_s
    }

    fn has(&self, time_s: f64) -> bool {
        self.from_s <= time_s && time_s < self.until_s
    }
}

/// Times of a planned failure or update [s].
pub(super) const TIMES_S: (f64, f64) = (0.0, 1e9);

impl PlannedFailure {
    /// A failure from `from_s` to `until_s`, infinite: to the end of the flight [s].
    pub fn new(output: SensorOutput, failure: Failure, from_s: f64, until_s: f64) -> Result<Self, Error> {
        failure.validate(output)?;
        check_within("failure.from_s", from_s, TIMES_S)?;
        if until_s <= from_s {
            let rule = Rule::SentenceWith("must be more than from_s =", from_s.into());
            return Err(Error::invalid("failure.until_s", until_s, rule));
        }
        if until_s != f64::INFINITY {
            check_within("failure.until_s", until_s, TIMES_S)?;
        }
        Ok(Self { output, failing: Failing { from_s, until_s }, failure })
    }
}

impl Temperature {
    /// At `time_s` [s] since the start of the flight [°C].
    pub fn at(&self, time_s: f64) -> f64 {
        self.at_start_c + self.change_c_s * time_s
    }
}

/// Largest number of planned failures, and of planned updates.
pub(super) const MAX_ITEMS: usize = 4096;

/// Largest size of the time stamp of a flight's first sample [s]: twice that of a sample, because moved time moves it too.
pub(super) const LATEST_START_S: f64 = 2e10;

/// Largest error of the time of a failure or an update by the rounding of time stamps, in intervals.
pub(super) const ROUNDING: f64 = 1e-9;

/// What flies a scene: one simulator, or an ensemble of them.
pub trait FliesScene {
    /// Takes a sample.
    fn push_sample(&mut self, sample: &FlightSample) -> Result<Pushed, Error>;
    /// Time stamp of the sample that was pushed last [s]; `None`: none yet.
    fn last_sample_time_s(&self) -> Option<f64>;
    /// Time stamps of the start and the end of the interval that was flown last [s]; `None`: none since the start or the last jump.
    fn last_interval_s(&self) -> Option<[f64; 2]>;
    /// Removes from each run what `correction` gives for the key of its random numbers and for its errors.
    fn correct_each(
        &mut self,
        correction: &dyn Fn(StreamKey, &NavigationErrors) -> Correction,
    ) -> Result<(), Error>;
    /// The failure of an output; `None`: it has no failure.
    fn failure(&self, output: SensorOutput) -> Option<Failure>;
    /// Lets an output fail, or clears its failure.
    fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>) -> Result<(), Error>;
}

macro_rules! flies_scene {
    ($($type:ty),*) => {
        $(impl FliesScene for $type {
            fn push_sample(&mut self, sample: &FlightSample) -> Result<Pushed, Error> {
                self.push_sample(sample)
            }

            fn last_sample_time_s(&self) -> Option<f64> {
                self.last_sample_time_s()
            }

            fn last_interval_s(&self) -> Option<[f64; 2]> {
                self.last_interval_s()
            }

            fn correct_each(
                &mut self,
                correction: &dyn Fn(StreamKey, &NavigationErrors) -> Correction,
            ) -> Result<(), Error> {
                self.correct_each(correction)
            }

            fn failure(&self, output: SensorOutput) -> Option<Failure> {
                self.failure(output)
            }

            fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>) -> Result<(), Error> {
                self.set_failure(output, failure)
            }
        })*
    };
}
flies_scene!(Simulator, Ensemble);

impl Scene {
    /// Prepares the interval that `sample` ends: call it for each sample before the push, and step before the next call.
    /// `start_s` is the time stamp of the flight's first sample. The sample gets the scene's temperature; a failure
    /// begins, or ends, with the first interval that starts at its time or later. Outputs for which the scene plans no failure
    /// are left alone. An update is made where the first interval ends at its time or later.
    pub fn prepare(
        &self,
        flown: &mut dyn FliesScene,
        start_s: f64,
        sample: &mut FlightSample,
    ) -> Result<(), Error> {
        let Some(time_s) = self.begin(flown, start_s, sample)? else { return Ok(()) };
        self.update(flown, start_s, time_s)?;
        self.fail(flown, time_s)
    }

    /// Checks `sample` and gives it the scene's temperature. Returns the time since the start at which its interval begins [s], a rounding
    /// late; `None`: it is the first sample, which ends no interval.
    pub(super) fn begin(
        &self,
        flown: &dyn FliesScene,
        start_s: f64,
        sample: &mut FlightSample,
    ) -> Result<Option<f64>, Error> {
        check_range("flight_start_s", start_s, -LATEST_START_S, LATEST_START_S)?;
        sample.validate()?;
        if let Some(temperature) = &self.temperature {
            sample.temperature_c = Some(temperature.at(sample.time_s - start_s));
        }
        // A flight's first sample ends no interval; its failures begin with the interval behind it.
        let begin_s = flown.last_sample_time_s();
        Ok(begin_s.map(|begin_s| begin_s - start_s + ROUNDING * (sample.time_s - begin_s)))
    }

    /// Sets the failures of the interval that begins at `time_s` [s].
    pub(super) fn fail(&self, flown: &mut dyn FliesScene, time_s: f64) -> Result<(), Error> {
        for output in SensorOutput::ALL {
            let mut planned = self.failures.iter().filter(|planned| planned.output == output).peekable();
            if planned.peek().is_none() {
                continue;
            }
            let due = planned.find(|planned| planned.failing.has(time_s)).map(|planned| planned.failure);
            if flown.failure(output) != due {
                flown.set_failure(output, due)?;
            }
        }
        Ok(())
    }

    /// Plans another failure, which has been validated. Failures of one output must not overlap in time.
    pub fn add_failure(&mut self, planned: PlannedFailure) -> Result<(), Error> {
        check_range("failures of the scene", (self.failures.len() + 1) as f64, 0.0, MAX_ITEMS as f64)?;
        let meets =
            |other: &&PlannedFailure| other.output == planned.output && other.failing.meets(&planned.failing);
        if let Some(other) = self.failures.iter().find(meets) {
            let rule = Rule::SentenceWith(
                "overlaps in time with a failure of the same output from",
                other.failing.from_s.into(),
            );
            return Err(Error::invalid("failure.from_s", planned.failing.from_s, rule));
        }
        self.failures.push(planned);
        Ok(())
    }
}
