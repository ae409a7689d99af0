//! The triads of many runs. One triad has the parameters and states that all runs share; rows have the states of each
//! run.

#![expect(clippy::needless_range_loop, reason = "a lane goes through many rows")]

use nalgebra::Vector3;

use super::super::bias::Bias;
use super::super::failing::FailingTriad;
use super::super::input::Input;
use super::super::linear::Linear;
use super::super::plan::Effect;
use super::super::states::{Count, From, Into, StateRows, Visitor};
use super::{Sensor, Triad};
use crate::error::Error;
use crate::memory::room;
use crate::signal::{Increment, IncrementRows, MAX_INCREMENTS, RUNS};

/// Number of errors that depend on the input and are the same in all runs.
const SHARED_ERRORS: usize = 4;

/// Input and errors of an interval that are the same for the triads of all runs.
#[derive(Debug, Clone)]
pub(crate) struct SharedInput {
    inputs: Vec<Input>,
    errors: Vec<[Vector3<f64>; SHARED_ERRORS]>,
    error_count: usize,
}

impl SharedInput {
    /// Room for the longest interval.
    pub fn new() -> Result<Self, Error> {
        Ok(Self { inputs: room(MAX_INCREMENTS)?, errors: room(MAX_INCREMENTS)?, error_count: 0 })
    }
}

impl Triad {
    /// Visits the states of the active effects of this run.
    fn visit(&mut self, visitor: &mut impl Visitor) {
        for step in self.plan.steps() {
            match self.plan.effect(step) {
                Effect::Linear => self.linear.visit(visitor),
                Effect::Bias => self.bias.visit(visitor),
                Effect::GaussMarkov => self.gauss_markov.visit(visitor),
                Effect::Flicker => self.flicker.visit(visitor),
                Effect::RateRandomWalk => self.rate_random_walk.visit(visitor),
                Effect::Ramp => self.ramp.visit(visitor),
                Effect::RandomWalk => self.random_walk.visit(visitor),
                Effect::Quantization => self.quantization.visit(visitor),
                // Their states are the same in all runs, or are kept outside the rows.
                Effect::Size
                | Effect::Bandwidth
                | Effect::Asymmetry
                | Effect::Quadratic
                | Effect::GSensitivity
                | Effect::Temperature
                | Effect::AddedFailure
                | Effect::DeadZone
                | Effect::Range
                | Effect::Outage => {}
            }
        }
    }

    /// Rows for the states of runs with these parameters.
    pub(crate) fn rows(&mut self) -> Result<StateRows, Error> {
        let mut count = Count::default();
        self.visit(&mut count);
        count.rows()
    }

    /// Copies the states of this run into a lane.
    pub(crate) fn put_into(&mut self, rows: &mut StateRows, lane: usize) {
        self.visit(&mut Into { rows, lane, next: Count::default() });
    }

    /// Copies the states of this run from a lane.
    pub(crate) fn take_from(&mut self, rows: &StateRows, lane: usize) {
        self.visit(&mut From { rows, lane, next: Count::default() });
    }

    /// Takes over the states of the failures of another run, which has the same failures.
    pub(crate) fn take_failures(&mut self, failures: &FailingTriad) {
        (*self.failing).clone_from(failures);
    }

    /// Takes the states that depend on the signals from `other`, which had the same signals.
    pub(crate) fn follow_as(&mut self, other: &Self) {
        self.size_effect.clone_from(&other.size_effect);
        self.bandwidth.clone_from(&other.bandwidth);
        self.temperature.clone_from(&other.temperature);
        self.dt.clone_from(&other.dt);
        self.set_interval(*other.dt);
    }

    /// Computes in `shared` what is the same for all runs in an interval with the increments `ideal`, each over `dt`
    /// [s].
    pub(crate) fn share(&mut self, ideal: &[Increment], dt: f64, shared: &mut SharedInput) {
        self.follow_length(dt);
        let SharedInput { inputs, errors, error_count } = shared;
        inputs.clear();
        errors.clear();
        for ideal in ideal {
            let mut signal = match self.sensor {
                Sensor::Gyro => ideal.angle,
                Sensor::Accelerometer => ideal.velocity,
            };
            self.sense_input(ideal, dt, &mut signal);
            let input = Input { signal, force: ideal.velocity, dt };
            let mut of_input = [Vector3::zeros(); SHARED_ERRORS];
            let effects = self.plan.of_input().map(|step| self.plan.effect(step));
            *error_count = 0;
            for effect in effects.filter(|effect| *effect != Effect::Linear) {
                of_input[*error_count] = self.error_of_input(effect, &input);
                *error_count += 1;
            }
            inputs.push(input);
            errors.push(of_input);
        }
    }

    /// Computes the outputs of the runs of a block in the interval that was [shared](Self::share): the triad's part of
    /// `outputs`. Each run has its own failures; copies of the last run have no failures. Runs beyond the range are
    /// marked in `saturated`. `before` gets the state of `rows` before the interval.
    #[inline(always)]
    pub(crate) fn sense_block(
        &self,
        shared: &SharedInput,
        dt: f64,
        (rows, before): (&mut StateRows, &mut StateRows),
        failures: &mut [FailingTriad],
        outputs: &mut [IncrementRows],
        saturated: &mut [u64; RUNS],
    ) {
        let first = match self.sensor {
            Sensor::Gyro => 0,
            Sensor::Accelerometer => 3,
        };
        let mut states = rows.states(before);
        for (output, input) in outputs.iter_mut().zip(&shared.inputs) {
            for axis in 0..3 {
                output[first + axis] = [input.signal[axis]; RUNS];
            }
        }
        for step in self.plan.of_input() {
            if self.plan.effect(step) == Effect::Linear {
                Linear::apply_each(&mut states, &shared.inputs, outputs, first);
            }
        }
        for (output, errors) in outputs.iter_mut().zip(&shared.errors) {
            for error in &errors[..shared.error_count] {
                for axis in 0..3 {
                    for lane in 0..RUNS {
                        output[first + axis][lane] += error[axis];
                    }
                }
            }
        }
        for step in self.plan.after_signal() {
            match self.plan.effect(step) {
                Effect::Bias => Bias::apply_each(&mut states, dt, outputs, first),
                Effect::GaussMarkov => self.gauss_markov.apply_each(&mut states, outputs, first),
                Effect::Flicker => self.flicker.apply_each(&mut states, outputs, first),
                Effect::RateRandomWalk => {
                    self.rate_random_walk.apply_each(&mut states, dt, outputs, first);
                }
                Effect::Ramp => self.ramp.apply_each(&mut states, dt, outputs, first),
                Effect::RandomWalk => self.random_walk.apply_each(&mut states, outputs, first),
                Effect::AddedFailure => {
                    let count = failures.len();
                    each_run(outputs, first, count, |lane, output| failures[lane].add(dt, output));
                }
                Effect::DeadZone => {
                    each_run(outputs, first, RUNS, |_, output| self.dead_zone.apply(dt, output))
                }
                Effect::Range => each_run(outputs, first, RUNS, |lane, output| {
                    saturated[lane] |= u64::from(self.range.apply(dt, output));
                }),
                Effect::Quantization => self.quantization.apply_each(&mut states, outputs, first),
                Effect::Outage => {
                    let count = failures.len();
                    each_run(outputs, first, count, |lane, output| failures[lane].replace(dt, output));
                }
                // Effects on the input are already applied.
                _ => {}
            }
        }
    }
}

/// Lets an effect act on the outputs of one run after the other.
#[inline(always)]
fn each_run(
    outputs: &mut [IncrementRows],
    first: usize,
    count: usize,
    mut act: impl FnMut(usize, &mut Vector3<f64>),
) {
    for output in outputs {
        for lane in 0..count.min(RUNS) {
            let mut vector = Vector3::from_fn(|i, _| output[first + i][lane]);
            act(lane, &mut vector);
            for axis in 0..3 {
                output[first + axis][lane] = vector[axis];
            }
        }
    }
}
