//! Runs that are flown together: as many as fit into the cache of a core.

use crate::base::error::Error;
use crate::errors::correction::Correction;
use crate::simulator::{Options, SideBySide, Simulator, Step, nothing_to_correct};
use crate::truth::{FlightSample, Intake, Pushed};

/// Largest number of runs in a part; a step uses 0.3 MB of them.
pub(super) const PART_RUNS: usize = 512;

/// Runs and their truth. The truth continues if runs diverge, and is the same in all parts of an ensemble.
#[derive(Debug)]
pub(super) struct Part {
    pub intake: Intake,
    pub intervals: u64,
    pub runs: SideBySide,
}

impl Part {
    pub fn new(
        template: &Simulator,
        options: &Options,
        first_run: u64,
        runs: usize,
        width: usize,
    ) -> Result<Self, Error> {
        let runs = SideBySide::new(template, first_run, runs, width)?;
        let intake = Intake::new(options.earth(), options.axes, options.intake)?;
        Ok(Self { intake, intervals: 0, runs })
    }

    pub fn push_sample(&mut self, sample: &FlightSample) -> Result<Pushed, Error> {
        self.runs.check_temperature(sample)?;
        let pushed = self.intake.push(sample)?;
        if let (Pushed::FirstVelocity, Some(current)) = (pushed, self.intake.current()) {
            self.runs.take_first_velocity(current);
        }
        Ok(pushed)
    }

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

    pub fn reposition(&mut self, sample: &FlightSample) -> Result<(), Error> {
        self.runs.check_temperature(sample)?;
        self.intake.restart(sample)?;
        self.intervals = 0;
        self.runs.reposition();
        Ok(())
    }

    /// Corrects the run at `place`.
    pub fn correct(&mut self, place: usize, correction: &Correction) -> Result<(), Error> {
        let Some(point) = self.intake.current() else { return Err(nothing_to_correct()) };
        self.runs.correct(place, point, correction)
    }

    /// Marks the run at `place` as diverged.
    pub fn diverge(&mut self, place: usize) {
        if let Some(point) = self.intake.current() {
            self.runs.diverge(place, point);
        }
    }

    pub fn reset(&mut self) {
        self.intake.clear();
        self.intervals = 0;
        self.runs.reset();
    }
}
