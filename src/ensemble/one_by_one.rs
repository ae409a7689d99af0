//! Runs that go one after the other: each a simulator.

use crate::error::Error;
use crate::memory::room;
use crate::sensors::{Failure, SensorOutput};
use crate::simulator::{Simulator, is_of_truth, push_simulator};
use crate::truth::FlightSample;

/// Simulators, and whether each has diverged.
#[derive(Debug, Default)]
pub(super) struct OneByOne {
    pub simulators: Vec<Simulator>,
    pub diverged: Vec<bool>,
}

impl OneByOne {
    /// Runs from `first_run` on with the settings of `template`.
    pub fn new(template: &Simulator, first_run: u64, runs: usize) -> Result<Self, Error> {
        let mut made = Self::with_room(runs)?;
        for run in (first_run..=u64::MAX).take(runs) {
            let mut options = template.options().of_run();
            options.key.run = run;
            push_simulator(&mut made.simulators, &options)?;
            if let Some(simulator) = made.simulators.last_mut() {
                set_up(simulator, template)?;
            }
        }
        Ok(made)
    }

    fn with_room(runs: usize) -> Result<Self, Error> {
        let (simulators, mut diverged) = (room(runs)?, room(runs)?);
        diverged.resize(runs, false);
        Ok(Self { simulators, diverged })
    }

    pub fn first(&self) -> Option<&Simulator> {
        self.simulators.first()
    }

    /// A sample that the truth has taken.
    pub fn push_sample(&mut self, sample: &FlightSample) -> Result<(), Error> {
        let living = self.simulators.iter_mut().zip(&self.diverged).filter(|(_, diverged)| !**diverged);
        for (run, _) in living {
            run.push_sample(sample)?;
        }
        Ok(())
    }

    /// Flies an interval with all runs that have not diverged. An error is one of the truth, and then nothing has changed.
    pub fn step(&mut self) -> Result<(), Error> {
        for (run, diverged) in self.simulators.iter_mut().zip(&mut self.diverged) {
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
        Ok(())
    }

    pub fn reposition(&mut self, sample: &FlightSample) -> Result<(), Error> {
        for run in &mut self.simulators {
            run.reposition(sample)?;
        }
        self.diverged.fill(false);
        Ok(())
    }

    pub fn reset(&mut self) {
        self.simulators.iter_mut().for_each(Simulator::reset);
        self.diverged.fill(false);
    }

    pub fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>) -> Result<(), Error> {
        // Refused, if at all, by the first.
        self.simulators.iter_mut().try_for_each(|run| run.set_failure(output, failure))
    }
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
