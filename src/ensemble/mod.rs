//! Ensembles: many runs of one simulator over the same truth, which differ in their random draws alone.
//!
//! Run k of an ensemble is, to the bit, the [`Simulator`] with `options.key.run = first_run + k`.

mod read;
mod snapshot;

use crate::error::{Error, Rule, check_integer};
use crate::instruction_set::InstructionSet;
use crate::sensors::{Failure, SensorOutput};
use crate::simulator::{Options, SideBySide, Simulator, Step};
use crate::truth::{FlightSample, Intake, Pushed};

/// Runs of an ensemble at the most.
pub const MAX_RUNS: u32 = u32::MAX;

/// Runs `first_run` to `first_run + runs - 1` of one simulator over the same samples.
///
/// A run whose step fails where the truth's own could be made is a diverged one: it stays as it was before that step, takes no
/// further part, and is reported by [`Self::diverged`]. The truth and the other runs go on, even if no run is left: what an
/// ensemble does never depends on which other runs are in it.
#[derive(Debug)]
pub struct Ensemble {
    first_run: u64,
    options: Options,
    /// The truth, which goes on whatever becomes of the runs.
    intake: Intake,
    intervals: u64,
    runs: SideBySide,
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
        let runs = SideBySide::new(template, first_run, runs, set)?;
        let intake = Intake::new(options.earth(), options.axes, options.intake)?;
        Ok(Self { first_run, options, intake, intervals: 0, runs })
    }

    /// Number of the first run.
    pub fn first_run(&self) -> u64 {
        self.first_run
    }

    /// How many runs.
    pub fn runs(&self) -> usize {
        self.runs.runs()
    }

    /// Takes one flight-control sample in, for all runs.
    pub fn push_sample(&mut self, sample: &FlightSample) -> Result<Pushed, Error> {
        self.check_temperature(sample)?;
        let pushed = self.intake.push(sample)?;
        if let (Pushed::FirstVelocity, Some(current)) = (pushed, self.intake.current()) {
            self.runs.take_first_velocity(current);
        }
        Ok(pushed)
    }

    /// Flies one sample interval with all runs that have not diverged. An error is one of the truth, and then nothing has changed.
    pub fn step(&mut self) -> Result<Step, Error> {
        let is_first = self.intervals == 0;
        let recent = if is_first { self.intake.first_interval() } else { self.intake.recent() };
        let Some(recent) = recent else { return Ok(Step::NeedSample) };
        self.runs.step(&recent)?;
        if is_first {
            self.intake.take();
        }
        self.intake.take();
        self.intervals += 1;
        Ok(Step::Done)
    }

    /// The truth jumps to `sample`: every run starts again there, the diverged ones too; noise goes on.
    pub fn reposition(&mut self, sample: &FlightSample) -> Result<(), Error> {
        self.check_temperature(sample)?;
        self.intake.restart(sample)?;
        self.intervals = 0;
        self.runs.reposition();
        Ok(())
    }

    /// Back to before the first sample: same parameters, seed and draws, no failures, no run diverged.
    pub fn reset(&mut self) {
        self.intake.clear();
        self.intervals = 0;
        self.runs.reset();
    }

    /// Lets an output of every run fail from the next interval on; `None` clears it.
    pub fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>) -> Result<(), Error> {
        failure.map_or(Ok(()), |failure| failure.validate(output))?;
        self.runs.set_failure(output, failure);
        Ok(())
    }

    /// Bytes that each run takes.
    #[doc(hidden)]
    pub fn bytes_of_run(&self) -> usize {
        self.runs.bytes_of_run()
    }

    /// Intervals flown since the start or the last reposition.
    pub fn intervals(&self) -> u64 {
        self.intervals
    }

    fn check_temperature(&self, sample: &FlightSample) -> Result<(), Error> {
        self.runs.check_temperature(sample)
    }
}
