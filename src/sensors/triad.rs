//! Three sensors and the effects that are active in them.

use core::slice::{from_mut, from_ref};

use nalgebra::Vector3;

use super::asymmetry::Asymmetry;
use super::bandwidth::Bandwidth;
use super::bias::Bias;
use super::dead_zone::DeadZone;
use super::failing::FailingTriad;
use super::failure::{Axis, Failure, SensorOutput};
use super::flicker::Flicker;
use super::g_sensitivity::GSensitivity;
use super::gauss_markov::GaussMarkov;
use super::kept::Kept;
use super::linear::Linear;
use super::outputs::Outputs;
use super::parameters::{Sensor, TriadParameters};
use super::plan::{Effect, Plan};
use super::quadratic::Quadratic;
use super::quantization::Quantization;
use super::ramp::Ramp;
use super::random_walk::RandomWalk;
use super::range::Range;
use super::rate_random_walk::RateRandomWalk;
use super::size_effect::SizeEffect;
use super::stream::StreamKey;
use super::temperature::Temperature;
use crate::error::Error;
use crate::signal::{Increment, MAX_INCREMENTS, Turning};
use crate::snapshot::{Reader, Stored, stored};
use crate::truth::INTERVALS_S;

/// A triad of gyros or accelerometers. An ideal one leaves the increments untouched, to the bit.
#[derive(Debug, Clone, PartialEq)]
pub struct Triad {
    sensor: Sensor,
    size_effect: SizeEffect,
    bandwidth: Bandwidth,
    linear: Linear,
    asymmetry: Asymmetry,
    quadratic: Quadratic,
    g_sensitivity: GSensitivity,
    temperature: Temperature,
    bias: Bias,
    gauss_markov: GaussMarkov,
    flicker: Flicker,
    rate_random_walk: RateRandomWalk,
    ramp: Ramp,
    random_walk: RandomWalk,
    dead_zone: DeadZone,
    range: Range,
    quantization: Quantization,
    failing: FailingTriad,
    plan: Plan,
    /// Length of the increments for which the units are made [s]; 0: for none yet.
    dt: Kept<f64>,
    /// Whether an output has been beyond the range since the flag was taken.
    saturated: bool,
}

stored!(Triad {
    size_effect,
    bandwidth,
    gauss_markov,
    flicker,
    rate_random_walk,
    ramp,
    random_walk,
    quantization,
    dt: INTERVALS_S.1,
} rebuilt {
    sensor, linear, asymmetry, quadratic, g_sensitivity, bias, dead_zone, range, plan, saturated, temperature, failing,
} then |triad, from| {
    let shortest_s = INTERVALS_S.0 / MAX_INCREMENTS as f64;
    from.require(*triad.dt == 0.0 || *triad.dt >= shortest_s, *triad.dt, "is no length of an increment")?;
    triad.set_interval(*triad.dt);
    Ok(())
});

impl Triad {
    /// An ideal triad whose random effects, if ever switched on, draw from the streams of `key`.
    pub fn new(key: StreamKey, sensor: Sensor) -> Self {
        Self {
            sensor,
            size_effect: SizeEffect::new(),
            bandwidth: Bandwidth::new(),
            linear: Linear::new(key, sensor),
            asymmetry: Asymmetry::new(),
            quadratic: Quadratic::new(),
            g_sensitivity: GSensitivity::new(),
            temperature: Temperature::new(),
            bias: Bias::new(key, sensor),
            gauss_markov: GaussMarkov::new(key, sensor),
            flicker: Flicker::new(key, sensor),
            rate_random_walk: RateRandomWalk::new(key, sensor),
            ramp: Ramp::new(),
            random_walk: RandomWalk::new(key, sensor),
            dead_zone: DeadZone::new(),
            range: Range::new(),
            quantization: Quantization::new(),
            failing: FailingTriad::new(key, sensor.source()),
            plan: Plan::IDEAL,
            dt: Kept::new(0.0),
            saturated: false,
        }
    }

    /// Takes validated parameters and decides what is to be done for each increment from now on. Processes that were
    /// active go on from where they are.
    pub fn set(&mut self, parameters: &TriadParameters) {
        self.plan = Plan::new(&[
            (Effect::Size, self.size_effect.set(parameters)),
            (Effect::Bandwidth, self.bandwidth.set(parameters)),
            (Effect::Linear, self.linear.set(parameters)),
            (Effect::Asymmetry, self.asymmetry.set(parameters)),
            (Effect::Quadratic, self.quadratic.set(parameters)),
            (Effect::GSensitivity, self.g_sensitivity.set(parameters)),
            (Effect::Temperature, self.temperature.set(parameters)),
            (Effect::Bias, self.bias.set(parameters)),
            (Effect::GaussMarkov, self.gauss_markov.set(parameters)),
            (Effect::Flicker, self.flicker.set(parameters)),
            (Effect::RateRandomWalk, self.rate_random_walk.set(parameters)),
            (Effect::Ramp, self.ramp.set(parameters)),
            (Effect::RandomWalk, self.random_walk.set(parameters)),
            (Effect::AddedFailure, self.failing.any_adds()),
            (Effect::DeadZone, self.dead_zone.set(parameters)),
            (Effect::Range, self.range.set(parameters)),
            (Effect::Quantization, self.quantization.set(parameters)),
            (Effect::Outage, self.failing.any_replaces()),
        ]);
        self.set_interval(*self.dt);
    }

    /// Takes a failure of one axis, or clears it, beside the parameters that are set; `last` is its output before [u], if there
    /// was one.
    pub fn set_failure(
        &mut self,
        axis: Axis,
        failure: Option<Failure>,
        last: Option<f64>,
        parameters: &TriadParameters,
    ) {
        self.failing.set(axis, failure, last);
        self.set(parameters);
    }

    /// The failure that is set of one axis.
    pub fn failure(&self, axis: Axis) -> Option<Failure> {
        self.failing.failure(axis)
    }

    /// The failures: a snapshot needs them before the parameters are set, which make a plan of both.
    pub(crate) fn failures(&self) -> &impl Stored {
        &self.failing
    }

    /// Reads them.
    pub(crate) fn load_failures(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        self.failing.load(from)?;
        self.failing.check(match self.sensor {
            Sensor::Gyro => SensorOutput::Gyro,
            Sensor::Accelerometer => SensorOutput::Accelerometer,
        })
    }

    /// Whether an axis has a failure.
    pub fn has_failed(&self) -> bool {
        self.failing.any_adds() || self.failing.any_replaces()
    }

    /// Whether an axis has no signal in this interval: dead, or dropped out.
    #[inline]
    pub fn is_silent(&self) -> bool {
        self.failing.are_silent()
    }

    /// Whether the accelerometers are off each other.
    pub fn has_size_effect(&self) -> bool {
        self.size_effect.is_active()
    }

    /// A sample interval of `t` [s] begins, with the temperatures `ends_c` [°C] at its ends and the motion that its increments are
    /// of, as far as they are known. Needed where an effect of temperature, the size effect or a failure is set.
    pub fn begin_interval(&mut self, t: f64, ends_c: Option<[f64; 2]>, turning: Option<Turning>) {
        self.failing.begin_interval(t);
        self.size_effect.begin_interval(turning);
        if let Some(ends_c) = ends_c {
            self.temperature.begin_interval(ends_c);
        }
    }

    /// Whether no effect is active.
    pub fn is_ideal(&self) -> bool {
        self.plan.is_ideal()
    }

    /// The signals jump: filters settle at once where they are next. Noise goes on.
    pub fn reposition(&mut self) {
        self.bandwidth.reposition();
    }

    /// What the triad makes of one ideal increment over `dt` [s].
    pub fn sense(&mut self, ideal: &Increment, dt: f64) -> Vector3<f64> {
        let mut measured = *ideal;
        self.sense_each(from_ref(ideal), dt, from_mut(&mut measured));
        match self.sensor {
            Sensor::Gyro => measured.angle,
            Sensor::Accelerometer => measured.velocity,
        }
    }

    /// Makes of its part of `measured`, which is that of the increments `ideal`, each over `dt` [s], what the triad gives: the
    /// active effects act one after the other, each on all increments. [`Self::undo`] takes an interval back.
    #[inline]
    pub fn sense_each(&mut self, ideal: &[Increment], dt: f64, measured: &mut [Increment]) {
        // Time stamps differ in their last digits; what that changes of a variance is far below anything visible.
        self.dt.keep();
        if (dt - *self.dt).abs() > 1e-7 * dt {
            self.set_interval(dt);
        }
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

    /// What the sensors feel of the increments, and its errors that grow with it.
    #[inline(never)]
    fn act_on_signal(&mut self, ideal: &[Increment], dt: f64, measured: &mut [Increment]) {
        for step in self.plan.before_felt() {
            if self.plan.effect(step) == Effect::Bandwidth {
                self.bandwidth.keep();
            }
        }
        for (ideal, output) in ideal.iter().zip(Outputs::new(self.sensor, measured).iter_mut()) {
            for step in self.plan.before_felt() {
                match self.plan.effect(step) {
                    Effect::Size => self.size_effect.apply(&ideal.angle, dt, output),
                    Effect::Bandwidth => self.bandwidth.apply(dt, output),
                    _ => {}
                }
            }
            let felt = *output;
            for step in self.plan.of_felt() {
                match self.plan.effect(step) {
                    Effect::Linear => *output += self.linear.error(&felt),
                    Effect::Asymmetry => *output += self.asymmetry.error(&felt),
                    Effect::Quadratic => *output += self.quadratic.error(&felt, dt),
                    Effect::GSensitivity => *output += self.g_sensitivity.error(&ideal.velocity),
                    Effect::Temperature => self.temperature.apply(&felt, dt, output),
                    _ => {}
                }
            }
        }
    }

    /// Lets the effect of a step act on all increments, one that few triads have: out of the way of the others.
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
            // Of `act_on_signal` and `sense_each`.
            _ => {}
        }
    }

    /// Whether an output has been beyond the range since this was asked last.
    #[inline]
    pub fn take_saturated(&mut self) -> bool {
        core::mem::take(&mut self.saturated)
    }

    /// Takes the last interval back: what [`Self::begin_interval`] and [`Self::sense_each`] changed is as it was before.
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
                // They keep nothing from one interval to the next.
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

    /// Takes the length of the increments to come [s]; 0: of none yet.
    #[cold]
    fn set_interval(&mut self, dt: f64) {
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

    /// The error [u] that an alignment at this moment would see at the angular rate `rate` [rad/s], the specific force
    /// `force` [m/s²] and the temperature `temperature_c` [°C], without which that of reference: all but the white noise and the
    /// quantization, which an alignment averages out, and failures, which come after it.
    pub fn steady_error(
        &self,
        rate: &Vector3<f64>,
        force: &Vector3<f64>,
        temperature_c: Option<f64>,
    ) -> Vector3<f64> {
        let ideal = match self.sensor {
            Sensor::Gyro => rate,
            Sensor::Accelerometer => force,
        };
        let size_error = self.size_effect.steady_error(rate);
        let felt = ideal + size_error;
        let error = self.linear.error(&felt)
            + self.bias.value()
            + self.gauss_markov.value()
            + size_error
            + self.asymmetry.error(&felt)
            + self.quadratic.error(&felt, 1.0)
            + self.g_sensitivity.error(force)
            + self.flicker.value()
            + self.rate_random_walk.value()
            + self.ramp.value();
        let thermal = temperature_c.map(|c| self.temperature.steady_error(c, &felt));
        let error = error + thermal.unwrap_or_default();
        // Adding and taking away the signal rounds: only where the limits change something.
        let unlimited = ideal + error;
        let mut shown = unlimited;
        self.dead_zone.apply(1.0, &mut shown);
        self.range.apply(1.0, &mut shown);
        shown.zip_zip_map(
            &unlimited,
            &ideal.zip_map(&error, |i, e| (i, e)),
            |shown, unlimited, (ideal, error)| {
                if shown == unlimited { error } else { shown - ideal }
            },
        )
    }
}
