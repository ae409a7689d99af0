//! How a triad senses the increments of an interval, and how it undoes an interval.

use core::slice::{from_mut, from_ref};

use nalgebra::Vector3;

use super::super::input::Input;
use super::super::outputs::Outputs;
use super::super::plan::Effect;
use super::{Sensor, Triad};
use crate::signal::Increment;

impl Triad {
    /// The triad's output for one ideal increment over `dt` [s].
    pub fn sense(&mut self, ideal: &Increment, dt: f64) -> Vector3<f64> {
        let mut measured = *ideal;
        self.sense_each(from_ref(ideal), dt, from_mut(&mut measured));
        match self.sensor {
            Sensor::Gyro => measured.angle,
            Sensor::Accelerometer => measured.velocity,
        }
    }

    /// Turns the triad's part of `measured` into the triad's outputs. Before the call, this part equals the same part of the
    /// increments `ideal`, each over `dt` [s]. The active effects act one after the other, each on all increments. [`Self::undo`]
    /// can undo the interval.
    #[inline]
    pub fn sense_each(&mut self, ideal: &[Increment], dt: f64, measured: &mut [Increment]) {
        self.dt.keep();
        self.follow_length(dt);
        if self.plan.acts_on_signal() {
            self.act_on_signal(ideal, dt, measured);
        }
        for step in self.plan.after_signal() {
            let outputs = Outputs::new(self.sensor, measured);
            match self.plan.effect(step) {
                Effect::Bias => self.bias.apply(dt, outputs),
                Effect::GaussMarkov => self.gauss_markov.apply(outputs),
                Effect::RandomWalk => self.random_walk.apply(outputs),
                _ => self.act(step, dt, outputs),
            }
        }
    }

    /// Computes the input of the sensors from the increments, and adds the errors that depend on this input.
    #[inline(never)]
    fn act_on_signal(&mut self, ideal: &[Increment], dt: f64, measured: &mut [Increment]) {
        for step in self.plan.before_input() {
            if self.plan.effect(step) == Effect::Bandwidth {
                self.bandwidth.keep();
            }
        }
        for (ideal, output) in ideal.iter().zip(Outputs::new(self.sensor, measured).iter_mut()) {
            self.sense_input(ideal, dt, output);
            let input = Input { signal: *output, force: ideal.velocity, dt };
            for step in self.plan.of_input() {
                *output += self.error_of_input(self.plan.effect(step), &input);
            }
        }
    }

    /// Takes the length `dt` [s] of the increments, if it differs. Time stamps differ in their last digits; the effect of this on a
    /// variance is far too small to be visible.
    #[inline]
    pub(super) fn follow_length(&mut self, dt: f64) {
        if (dt - *self.dt).abs() > 1e-7 * dt {
            self.set_interval(dt);
        }
    }

    /// Turns `input`, the triad's part of `ideal`, into the input of its sensors.
    #[inline(always)]
    pub(super) fn sense_input(&mut self, ideal: &Increment, dt: f64, input: &mut Vector3<f64>) {
        for step in self.plan.before_input() {
            match self.plan.effect(step) {
                Effect::Size => self.size_effect.apply(&ideal.angle, dt, input),
                Effect::Bandwidth => self.bandwidth.apply(dt, input),
                _ => {}
            }
        }
    }

    /// Error of an effect that depends on the input.
    #[inline(always)]
    pub(super) fn error_of_input(&self, effect: Effect, input: &Input) -> Vector3<f64> {
        match effect {
            Effect::Linear => self.linear.error(input),
            Effect::Asymmetry => self.asymmetry.error(input),
            Effect::Quadratic => self.quadratic.error(input),
            Effect::GSensitivity => self.g_sensitivity.error(input),
            Effect::Temperature => self.temperature.error(input),
            _ => Vector3::zeros(),
        }
    }

    /// Lets the effect of a step act on all increments. Few triads have these effects, so their code is kept apart from the code of
    /// the others.
    #[inline(never)]
    fn act(&mut self, step: usize, dt: f64, mut outputs: Outputs<'_>) {
        let outputs = outputs.iter_mut();
        match self.plan.effect(step) {
            Effect::Flicker => {
                self.flicker.keep();
                outputs.for_each(|output| self.flicker.apply(output));
            }
            Effect::RateRandomWalk => {
                self.rate_random_walk.keep();
                outputs.for_each(|output| self.rate_random_walk.apply(dt, output));
            }
            Effect::Ramp => {
                self.ramp.keep();
                outputs.for_each(|output| self.ramp.apply(dt, output));
            }
            Effect::AddedFailure => outputs.for_each(|output| self.failing.add(dt, output)),
            Effect::DeadZone => outputs.for_each(|output| self.dead_zone.apply(dt, output)),
            Effect::Range => outputs.for_each(|output| self.saturated |= self.range.apply(dt, output)),
            Effect::Quantization => {
                self.quantization.keep();
                outputs.for_each(|output| self.quantization.apply(output));
            }
            Effect::Outage => outputs.for_each(|output| self.failing.replace(dt, output)),
            // `act_on_signal` and `sense_each` handle the other effects.
            _ => {}
        }
    }

    /// Whether an output has been beyond the range since the last call.
    #[inline]
    pub fn take_saturated(&mut self) -> bool {
        core::mem::take(&mut self.saturated)
    }

    /// Undoes the last interval: restores what [`Self::begin_interval`] and [`Self::sense_each`] changed.
    #[cold]
    pub fn undo(&mut self) {
        for step in self.plan.steps() {
            match self.plan.effect(step) {
                Effect::Size => self.size_effect.undo(),
                Effect::Bandwidth => self.bandwidth.undo(),
                Effect::GaussMarkov => self.gauss_markov.undo(),
                Effect::Flicker => self.flicker.undo(),
                Effect::RateRandomWalk => self.rate_random_walk.undo(),
                Effect::Ramp => self.ramp.undo(),
                Effect::RandomWalk => self.random_walk.undo(),
                Effect::AddedFailure | Effect::Outage => self.failing.undo(),
                Effect::Quantization => self.quantization.undo(),
                // These effects keep nothing from one interval to the next.
                Effect::Linear
                | Effect::Asymmetry
                | Effect::Quadratic
                | Effect::GSensitivity
                | Effect::Temperature
                | Effect::Bias
                | Effect::DeadZone
                | Effect::Range => {}
            }
        }
        self.dt.undo();
        self.set_interval(*self.dt);
    }

    /// Takes the length of the increments to come [s]; 0: not known yet.
    #[cold]
    pub(super) fn set_interval(&mut self, dt: f64) {
        *self.dt = dt;
        if dt == 0.0 {
            return;
        }
        self.bandwidth.set_interval(dt);
        self.gauss_markov.set_interval(dt);
        self.flicker.set_interval(dt);
        self.rate_random_walk.set_interval(dt);
        self.random_walk.set_interval(dt);
    }
}
