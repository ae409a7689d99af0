//! Ensembles: many runs of one simulator over the same truth. The runs differ only in their random draws.
//!
//! Run k of an ensemble is, to the bit, the [`Simulator`] with `options.key.run = first_run + k`.

mod part;
mod read;
mod snapshot;
pub mod statistics;

use crate::base::error::{Error, ErrorKind, Rule, check_integer};
use crate::base::memory::{probe, room};
use crate::errors::NavigationErrors;
use crate::errors::correction::Correction;
use crate::sensors::{Failure, SensorOutput, StreamKey};
use crate::simulator::{ErrorSource, Options, Simulator, Step, nothing_to_correct};
use crate::truth::{FlightSample, Pushed};
use part::{PART_RUNS, Part};

/// Largest number of runs of an ensemble.
pub const MAX_RUNS: u32 = u32::MAX;

/// Number of samples that a part flies before the next part flies.
const TOGETHER: usize = 32;

/// Runs `first_run` to `first_run + runs - 1` of one simulator over the same samples.
///
/// A run diverges if its step fails although the step of the truth succeeds. It keeps the state before that step, is not flown any
/// further, and is reported by [`Self::diverged`]. The truth and the other runs continue, even if all runs have diverged: the
/// results of a run never depend on the other runs of the ensemble.
#[derive(Debug)]
pub struct Ensemble {
    first_run: u64,
    options: Options,
    /// Parts of [`PART_RUNS`] runs, at least one; the last one may have fewer.
    parts: Vec<Part>,
}

impl Ensemble {
    /// Runs `first_run` to `first_run + runs - 1` with the options, the seed and the settings of `template`, which was set up and
    /// has neither samples nor a step.
    pub fn new(template: &Simulator, first_run: u64, runs: usize) -> Result<Self, Error> {
        Self::of_width(template, first_run, runs, usize::MAX)
    }

    /// As [`Self::new`], with instructions for up to `width` numbers at a time, to compare their bits and times. With a width of 1 each
    /// run is flown as by a simulator.
    #[doc(hidden)]
    pub fn of_width(template: &Simulator, first_run: u64, runs: usize, width: usize) -> Result<Self, Error> {
        if template.has_started() || template.waiting_samples() > 0 {
            return Err(Error::bad_state(
                "an ensemble is made of a simulator before its first sample, or after a reset",
            ));
        }
        check_integer("runs", runs, 1, MAX_RUNS.into())?;
        let last_first = u64::MAX - (runs as u64 - 1);
        if first_run > last_first {
            return Err(Error::invalid("first_run", first_run, Rule::BetweenIntegers(0, last_first)));
        }
        let options = *template.options();
        let part = |first: usize| {
            let count = PART_RUNS.min(runs - first);
            Part::new(template, &options, first_run + first as u64, count, width)
        };
        let of_runs = |bytes: Option<usize>| move |error: Error| of_runs(error, runs, bytes);
        let first = part(0).map_err(of_runs(None))?;
        let bytes = first.runs.bytes_of_run().saturating_mul(runs);
        let lacks = of_runs(Some(bytes));
        // All of it at once before any of it: memory that is given away part by part fills the machine before it is missing.
        let mut parts = probe(bytes).and_then(|()| room(runs.div_ceil(PART_RUNS))).map_err(lacks)?;
        parts.push(first);
        for first in (PART_RUNS..runs).step_by(PART_RUNS) {
            parts.push(part(first).map_err(lacks)?);
        }
        Ok(Self { first_run, options, parts })
    }

    /// Number of the first run.
    pub fn first_run(&self) -> u64 {
        self.first_run
    }

    /// Number of runs.
    pub fn runs(&self) -> usize {
        self.parts.iter().map(|part| part.runs.runs()).sum()
    }

    /// Does the same with all parts. Their truth is the same, so the answer is the same.
    fn each<T>(&mut self, mut act: impl FnMut(&mut Part) -> T) -> T {
        let answer = act(&mut self.parts[0]);
        self.parts[1..].iter_mut().for_each(|part| _ = act(part));
        answer
    }

    /// Pushes one flight sample, for all runs.
    pub fn push_sample(&mut self, sample: &FlightSample) -> Result<Pushed, Error> {
        self.each(|part| part.push_sample(sample))
    }

    /// Flies one sample interval with all runs that have not diverged. An error is an error of the truth; then nothing has changed.
    pub fn step(&mut self) -> Result<Step, Error> {
        self.each(Part::step)
    }

    /// Pushes and steps `count` samples, which `sample` gives. The bits are those of single calls; it is faster if the runs need
    /// more than the cache of a core. Returns whether a sample ended a gap; or the error with the index of its sample, before which
    /// all samples were flown.
    pub fn run<E: From<Error>>(
        &mut self,
        count: usize,
        sample: impl Fn(usize) -> Result<FlightSample, E>,
    ) -> Result<bool, (usize, E)> {
        let mut has_gap = false;
        for first in (0..count).step_by(TOGETHER) {
            has_gap |= self.each(|part| {
                let mut has_gap = false;
                for index in first..count.min(first + TOGETHER) {
                    let of_sample = |error: Error| (index, error.into());
                    let sample = sample(index).map_err(|error| (index, error))?;
                    has_gap |= part.push_sample(&sample).map_err(of_sample)? == Pushed::BehindGap;
                    while part.step().map_err(of_sample)? == Step::Done {}
                }
                Ok(has_gap)
            })?;
        }
        Ok(has_gap)
    }

    /// Follows a jump of the truth to `sample`: every run starts again there, diverged ones too; noise continues.
    pub fn reposition(&mut self, sample: &FlightSample) -> Result<(), Error> {
        self.each(|part| part.reposition(sample))
    }

    /// Returns to the state before the first sample: same parameters, seed and draws, no failures, no diverged run.
    pub fn reset(&mut self) {
        self.each(Part::reset);
    }

    /// Lets an output of every run fail from the next interval on; `None` clears it.
    pub fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>) -> Result<(), Error> {
        failure.map_or(Ok(()), |failure| failure.validate(output))?;
        self.each(|part| part.runs.set_failure(output, failure));
        Ok(())
    }

    /// Corrects a run, as [`Simulator::correct`] does. The first compensation of a run allocates.
    pub fn correct(&mut self, run: u64, correction: &Correction) -> Result<(), Error> {
        let place = self.place_of(run)?;
        correction.validate()?;
        self.parts[place / PART_RUNS].correct(place % PART_RUNS, correction)
    }

    /// Removes from each run that has not diverged what `correction` gives for the key of its random numbers and for its errors. A run
    /// that cannot be corrected diverges.
    #[cold]
    pub fn correct_each(
        &mut self,
        correction: impl Fn(StreamKey, &NavigationErrors) -> Correction,
    ) -> Result<(), Error> {
        if self.intervals() == 0 {
            return Err(nothing_to_correct());
        }
        for place in 0..self.runs() {
            let run = self.first_run + place as u64;
            let Ok(Some((_, errors))) = self.errors(run, ErrorSource::Navigation) else { continue };
            let key = StreamKey { run, ..self.options.key };
            if self.correct(run, &correction(key, &errors)).is_err() {
                self.parts[place / PART_RUNS].diverge(place % PART_RUNS);
            }
        }
        Ok(())
    }

    /// Size of a run [bytes].
    #[doc(hidden)]
    pub fn bytes_of_run(&self) -> usize {
        self.parts[0].runs.bytes_of_run()
    }

    /// Number of intervals flown since the start or the last reposition.
    pub fn intervals(&self) -> u64 {
        self.parts[0].intervals
    }
}

/// `error` about these runs, which take `bytes` bytes, if it is a lack of memory; `None`: they take more than it lacks.
fn of_runs(error: Error, runs: usize, bytes: Option<usize>) -> Error {
    let least = bytes.map(Into::into).or(error.value);
    match (error.kind, least) {
        (ErrorKind::OutOfMemory, Some(least)) => {
            let rule = Rule::SentenceWith("not enough memory; bytes that they take at least:", least);
            Error::of(ErrorKind::OutOfMemory, "runs", runs, rule)
        }
        _ => error,
    }
}

#[cfg(test)]
mod tests {
    mod subnormal;
}
