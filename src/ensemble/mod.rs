//! Ensembles: many runs of one simulator over the same truth, which differ in their random draws alone.
//!
//! Run k of an ensemble is, to the bit, the [`Simulator`] with `options.key.run = first_run + k`.

mod read;
mod snapshot;

use crate::error::{Error, Rule, check_integer};
use crate::sensors::{Failure, SensorOutput};
use crate::simulator::{Options, Simulator, Step, push_simulator};
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
    runs: Vec<Simulator>,
    /// Of each run.
    diverged: Vec<bool>,
}

impl Ensemble {
    /// Runs `first_run` to `first_run + runs - 1` with the options, the seed and the settings of `template`, which was set up and
    /// has neither samples nor a step.
    pub fn new(template: &Simulator, first_run: u64, runs: usize) -> Result<Self, Error> {
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
        let mut simulators = crate::memory::room(runs)?;
        let mut diverged = crate::memory::room(runs)?;
        diverged.resize(runs, false);
        for run in (first_run..=u64::MAX).take(runs) {
            let mut options = Options { truth_summary: false, ..*template.options() };
            options.key.run = run;
            push_simulator(&mut simulators, &options)?;
            if let Some(simulator) = simulators.last_mut() {
                set_up(simulator, template)?;
            }
        }
        let options = *template.options();
        let intake = Intake::new(options.earth(), options.axes, options.intake)?;
        Ok(Self { first_run, options, intake, intervals: 0, runs: simulators, diverged })
    }

    /// Number of the first run.
    pub fn first_run(&self) -> u64 {
        self.first_run
    }

    /// How many runs.
    pub fn runs(&self) -> usize {
        self.runs.len()
    }

    /// Takes one flight-control sample in, for all runs.
    pub fn push_sample(&mut self, sample: &FlightSample) -> Result<Pushed, Error> {
        self.check_temperature(sample)?;
        let pushed = self.intake.push(sample)?;
        for run in living(&mut self.runs, &self.diverged) {
            run.push_sample(sample)?;
        }
        Ok(pushed)
    }

    /// Flies one sample interval with all runs that have not diverged. An error is one of the truth, and then nothing has changed.
    pub fn step(&mut self) -> Result<Step, Error> {
        let is_first = self.intervals == 0;
        let recent = if is_first { self.intake.first_interval() } else { self.intake.recent() };
        let Some(recent) = recent else { return Ok(Step::NeedSample) };
        self.options.check_truth(recent.next)?;
        for (run, diverged) in self.runs.iter_mut().zip(&mut self.diverged) {
            if *diverged {
                continue;
            }
            if let Err(error) = run.step() {
                // No run could align here, so that this is the first of them.
                if is_of_truth(&error) {
                    return Err(error);
                }
                *diverged = true;
            }
        }
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
        for run in &mut self.runs {
            run.reposition(sample)?;
        }
        self.diverged.fill(false);
        Ok(())
    }

    /// Back to before the first sample: same parameters, seed and draws, no failures, no run diverged.
    pub fn reset(&mut self) {
        self.intake.clear();
        self.intervals = 0;
        self.runs.iter_mut().for_each(Simulator::reset);
        self.diverged.fill(false);
    }

    /// Lets an output of every run fail from the next interval on; `None` clears it.
    pub fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>) -> Result<(), Error> {
        // Refused, if at all, by the first.
        self.runs.iter_mut().try_for_each(|run| run.set_failure(output, failure))
    }

    /// Intervals flown since the start or the last reposition.
    pub fn intervals(&self) -> u64 {
        self.intervals
    }

    fn check_temperature(&self, sample: &FlightSample) -> Result<(), Error> {
        self.runs.first().map_or(Ok(()), |run| run.check_temperature(sample))
    }
}

/// The runs that have not diverged.
fn living<'a>(
    runs: &'a mut [Simulator],
    diverged: &'a [bool],
) -> impl Iterator<Item = &'a mut Simulator> + use<'a> {
    runs.iter_mut().zip(diverged).filter(|(_, diverged)| !**diverged).map(|(run, _)| run)
}

/// Whether an error of a run's start is one of the place, where no run can align.
fn is_of_truth(error: &Error) -> bool {
    error.field == "cosine of sample.latitude_rad"
}

/// Sets what the host set of `template`.
fn set_up(simulator: &mut Simulator, template: &Simulator) -> Result<(), Error> {
    simulator.set_gyro(template.gyro())?;
    simulator.set_accel(template.accel())?;
    simulator.set_altimeter(template.altimeter())?;
    simulator.set_initial_errors(template.initial_errors())?;
    simulator.set_mounting(&template.mounting())?;
    simulator.set_gravity_disturbance(template.gravity_disturbance())?;
    SensorOutput::ALL
        .into_iter()
        .try_for_each(|output| simulator.set_failure(output, template.failure(output)))
}
