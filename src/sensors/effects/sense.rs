//! How the effects act on the increments of an interval, of one run or of the runs of a batch, and on constant signals.

use core::slice::from_mut;

use nalgebra::Vector3;

use super::{Aside, BatchOutputs, EffectPlace, Effects, Input, Outputs, SHARED_ERRORS, Stage, States};
use crate::base::error::Error;
use crate::base::memory::room;
use crate::sensors::Sensor;
use crate::signal::{Increment, MAX_INCREMENTS, RUNS};

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

impl Effects {
    /// Where the active effects act, in order.
    pub fn places(&self) -> impl Iterator<Item = EffectPlace> {
        self.plan.places()
    }

    /// Whether no effect is active.
    pub fn are_none(&self) -> bool {
        self.plan.is_ideal()
    }

    /// Computes the input of the sensors from the increments, and adds the errors that depend on this input.
    #[inline]
    pub fn act_on_signal(
        &mut self,
        ideal: &[Increment],
        dt: f64,
        sensor: Sensor,
        measured: &mut [Increment],
    ) {
        if self.plan.of(Stage::OfInput).end > 0 {
            self.do_act_on_signal(ideal, dt, Outputs::new(sensor, measured));
        }
    }

    #[inline(never)]
    fn do_act_on_signal(&mut self, ideal: &[Increment], dt: f64, mut outputs: Outputs<'_>) {
        self.keep_input();
        for (ideal, output) in ideal.iter().zip(outputs.iter_mut()) {
            self.sense_input(ideal, dt, output);
            let input = Input { signal: *output, force: ideal.velocity, dt };
            for step in self.plan.of(Stage::DrawnOfInput) {
                *output += self.drawn_error(step, &input);
            }
            for step in self.plan.of(Stage::OfInput) {
                *output += self.error_of_input(step, &input);
            }
        }
    }

    /// Computes in `shared` what is the same for all runs in an interval with the increments `ideal`, each over `dt` [s].
    pub fn share(&mut self, ideal: &[Increment], dt: f64, sensor: Sensor, shared: &mut SharedInput) {
        let SharedInput { inputs, errors, error_count } = shared;
        inputs.clear();
        errors.clear();
        *error_count = self.plan.of(Stage::OfInput).len();
        for ideal in ideal {
            let mut signal = sensor.part_of(ideal);
            self.sense_input(ideal, dt, &mut signal);
            let input = Input { signal, force: ideal.velocity, dt };
            let mut of_input = [Vector3::zeros(); SHARED_ERRORS];
            for (error, step) in of_input.iter_mut().zip(self.plan.of(Stage::OfInput)) {
                *error = self.error_of_input(step, &input);
            }
            inputs.push(input);
            errors.push(of_input);
        }
    }

    /// [`Self::act_on_signal`] for the runs of a batch in the interval that was [shared](Self::share).
    #[inline(always)]
    pub fn act_on_signal_each(
        &self,
        shared: &SharedInput,
        states: &mut States<'_>,
        outputs: &mut BatchOutputs<'_>,
    ) {
        for (output, input) in outputs.iter_mut().zip(&shared.inputs) {
            *output = [0, 1, 2].map(|axis: usize| [input.signal[axis]; RUNS]);
        }
        self.add_drawn_each(states, &shared.inputs, outputs);
        for (output, errors) in outputs.iter_mut().zip(&shared.errors) {
            for error in &errors[..shared.error_count] {
                for axis in 0..3 {
                    output[axis].iter_mut().for_each(|output| *output += error[axis]);
                }
            }
        }
    }

    /// Takes the states that depend on the signals from `other`, which had the same signals.
    pub fn follow(&mut self, other: &Self) {
        self.follow_input(other);
        self.follow_errors(other);
    }

    /// The error [u] that an average over the present errors would have at the angular rate `rate` [rad/s], the specific force
    /// `force` [m/s²] and the temperature `temperature_c` [°C]; `None`: the reference temperature. It excludes what an average
    /// removes: white noise and quantization.
    pub fn steady_error(
        &self,
        sensor: Sensor,
        rate: &Vector3<f64>,
        force: &Vector3<f64>,
        temperature_c: Option<f64>,
    ) -> Vector3<f64> {
        let (ideal, of_input) = self.steady_error_of_signal(sensor, rate, force, temperature_c);
        shown_error(ideal, &(of_input + self.steady_added()), 1.0, |shown| self.limit(shown))
    }

    /// The error [u] of the mean output over the next `t` [s], with the constant signals of [`Self::steady_error`]. The effects act as on
    /// one increment of this length, which is exact for each of them, and their states move on to its end. The draws come from streams
    /// of their own, so that the streams of the effects stay where they are.
    pub fn mean_error(
        &mut self,
        t: f64,
        sensor: Sensor,
        rate: &Vector3<f64>,
        force: &Vector3<f64>,
        temperature_c: Option<f64>,
    ) -> Vector3<f64> {
        let (ideal, of_input) = self.steady_error_of_signal(sensor, rate, force, temperature_c);
        self.set_interval(t);
        let mut aside = Aside::NOTHING;
        self.visit(&mut aside);
        let mut added = Increment::ZERO;
        self.add(t, sensor, from_mut(&mut added));
        aside.next = 0;
        self.visit(&mut aside);
        let error = of_input + sensor.part_of(&added) / t;
        shown_error(ideal, &error, t, |shown| {
            let mut output = Increment { angle: *shown, velocity: *shown };
            self.finish(t, sensor, from_mut(&mut output));
            *shown = sensor.part_of(&output);
        })
    }

    /// Ideal signal, and the error that depends on it [u].
    fn steady_error_of_signal<'a>(
        &self,
        sensor: Sensor,
        rate: &'a Vector3<f64>,
        force: &'a Vector3<f64>,
        temperature_c: Option<f64>,
    ) -> (&'a Vector3<f64>, Vector3<f64>) {
        let ideal = match sensor {
            Sensor::Gyro => rate,
            Sensor::Accelerometer => force,
        };
        let change = self.steady_change(rate);
        let input = Input { signal: ideal + change, force: *force, dt: 1.0 };
        let error = change
            + self.steady_drawn_error(&input, temperature_c)
            + self.steady_error_of_input(&input, temperature_c);
        (ideal, error)
    }
}

/// The error [u] after `limit` has acted on the signal over `t` [s]. Adding and subtracting the signal has rounding errors, so this is
/// done only where the limits change something.
fn shown_error(
    ideal: &Vector3<f64>,
    error: &Vector3<f64>,
    t: f64,
    limit: impl FnOnce(&mut Vector3<f64>),
) -> Vector3<f64> {
    let unlimited = (ideal + error) * t;
    let mut shown = unlimited;
    limit(&mut shown);
    Vector3::from_fn(|i, _| if shown[i] == unlimited[i] { error[i] } else { shown[i] / t - ideal[i] })
}
