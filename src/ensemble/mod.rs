//! Ensembles: many runs of one simulator over the same truth, which differ in their random draws alone.
//!
//! Run k of an ensemble is, to the bit, the [`Simulator`] with `options.key.run = first_run + k`.

mod part;
mod read;
mod snapshot;

use crate::error::{Error, Rule, check_integer};
use crate::instruction_set::InstructionSet;
use crate::memory::room;
use crate::sensors::{Failure, SensorOutput};
use crate::simulator::{Options, Simulator, Step};
use crate::truth::{FlightSample, Pushed};
use part::{PART_RUNS, Part};

/// Runs of an ensemble at the most.
pub const MAX_RUNS: u32 = u32::MAX;

/// Samples that a part flies before the next one does.
const TOGETHER: usize = 32;

/// Runs `first_run` to `first_run + runs - 1` of one simulator over the same samples.
///
/// A run whose step fails where the truth's own could be made is a diverged one: it stays as it was before that step, takes no
/// further part, and is reported by [`Self::diverged`]. The truth and the other runs go on, even if no run is left: what an
/// ensemble does never depends on which other runs are in it.
#[derive(Debug)]
pub struct Ensemble {
    first_run: u64,
    options: Options,
    /// All but the last have [`PART_RUNS`] runs.
    first: Part,
    others: Vec<Part>,
}

impl Ensemble {
    /// Runs `first_run` to `first_run + runs - 1` with the options, the seed and the settings of `template`, which was set up and
    /// has neither samples nor a step.
    pub fn new(template: &Simulator, first_run: u64, runs: usize) -> Result<Self, Error> {
        Self::of_width(template, first_run, runs, usize::MAX)
    }

    /// The same with instructions for up to `width` numbers at a time: to compare their bits and their times.
    #[doc(hidden)]
    pub fn of_width(template: &Simulator, first_run: u64, runs: usize, width: usize) -> Result<Self, Error> {
        let set = InstructionSet::up_to(width);
        if template.has_started() || template.waiting_samples() > 0 {
            return Err(Error::bad_state(
                "an ensemble is made of a simulator before its first sample, or after a reset",
            ));
        }
        check_integer("runs", runs, 1, MAX_RUNS.into())?;
        let last_first = u64::MAX - (runs as u64 - 1);
        if first_run > last_first {
            return Err(Error::invalid("first_run", first_run, Rule::Between(0.0, last_first as f64)));
        }
        let options = *template.options();
        let part = |first: usize| {
            let count = PART_RUNS.min(runs - first);
            Part::new(template, &options, first_run + first as u64, count, set)
        };
        let mut others = room((runs - 1) / PART_RUNS)?;
        for first in (0..runs).step_by(PART_RUNS).skip(1) {
            others.push(part(first)?);
        }
        Ok(Self { first_run, options, first: part(0)?, others })
    }

    /// Number of the first run.
    pub fn first_run(&self) -> u64 {
        self.first_run
    }

    /// How many runs.
    pub fn runs(&self) -> usize {
        self.parts().map(|part| part.runs.runs()).sum()
    }

    fn parts(&self) -> impl Iterator<Item = &Part> {
        core::iter::once(&self.first).chain(&self.others)
    }

    /// Lets all parts do the same. Their truth is the same, and so is the answer.
    fn each<T>(&mut self, mut act: impl FnMut(&mut Part) -> T) -> T {
        let answer = act(&mut self.first);
        for part in &mut self.others {
            act(part);
        }
        answer
    }

    /// Takes one flight-control sample in, for all runs.
    pub fn push_sample(&mut self, sample: &FlightSample) -> Result<Pushed, Error> {
        self.each(|part| part.push_sample(sample))
    }

    /// Flies one sample interval with all runs that have not diverged. An error is one of the truth, and then nothing has changed.
    pub fn step(&mut self) -> Result<Step, Error> {
        self.each(Part::step)
    }

    /// Pushes and steps `count` samples, which `sample` gives: to the same bits as single calls, and faster where the runs are more
    /// than a core's cache. Whether a sample ended a gap; else the error with the index of its sample, before which all were flown.
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

    /// The truth jumps to `sample`: every run starts again there, the diverged ones too; noise goes on.
    pub fn reposition(&mut self, sample: &FlightSample) -> Result<(), Error> {
        self.each(|part| part.reposition(sample))
    }

    /// Back to before the first sample: same parameters, seed and draws, no failures, no run diverged.
    pub fn reset(&mut self) {
        self.each(Part::reset);
    }

    /// Lets an output of every run fail from the next interval on; `None` clears it.
    pub fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>) -> Result<(), Error> {
        failure.map_or(Ok(()), |failure| failure.validate(output))?;
        self.each(|part| part.set_failure(output, failure));
        Ok(())
    }

    /// Bytes that each run takes.
    #[doc(hidden)]
    pub fn bytes_of_run(&self) -> usize {
        self.first.runs.bytes_of_run()
    }

    /// Intervals flown since the start or the last reposition.
    pub fn intervals(&self) -> u64 {
        self.first.intervals
    }
}
