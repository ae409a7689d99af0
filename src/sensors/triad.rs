//! Three sensors and the effects that are active in them.

use nalgebra::Vector3;

use super::asymmetry::Asymmetry;
use super::bandwidth::Bandwidth;
use super::bias::Bias;
use super::dead_zone::DeadZone;
use super::failing::FailingTriad;
use super::failure::{Axis, Failure};
use super::flicker::Flicker;
use super::g_sensitivity::GSensitivity;
use super::gauss_markov::GaussMarkov;
use super::linear::Linear;
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
use crate::signal::Increment;

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
    dt: f64,
    /// Whether an output has been beyond the range since the flag was taken.
    saturated: bool,
}

impl Triad {
    /// An ideal triad whose random effects, if ever switched on, draw from the streams of `key`.
    pub fn new(key: StreamKey, sensor: Sensor) -> Self {
        Self {
            sensor,
            size_effect: SizeEffect::new(),
            bandwidth: Bandwidth::new(),
            linear: Linear::new(),
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
            dt: 0.0,
            saturated: false,
        }
    }

    /// Takes validated parameters and decides what is to be done for each increment from now on. Processes that were
    /// active go on from where they are.
    pub fn set(&mut self, parameters: &TriadParameters) {
        self.plan = Plan::new(&[
            (Effect::LeverArms, self.size_effect.set(parameters)),
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
            (Effect::Disturbance, self.failing.are_disturbed()),
            (Effect::DeadZone, self.dead_zone.set(parameters)),
            (Effect::Range, self.range.set(parameters)),
            (Effect::Quantization, self.quantization.set(parameters)),
            (Effect::Outage, self.failing.are_out()),
        ]);
        if self.dt > 0.0 {
            self.set_interval(self.dt);
        }
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

    /// Whether an axis has a failure.
    pub fn has_failed(&self) -> bool {
        self.failing.are_disturbed() || self.failing.are_out()
    }

    /// Whether a step has nothing to fear of the failures.
    pub fn fails_tamely(&self) -> bool {
        self.failing.are_tame()
    }

    /// Whether an axis has no signal in this interval: dead, or dropped out.
    #[inline]
    pub fn is_silent(&self) -> bool {
        self.failing.are_silent()
    }

    /// A sample interval of `t` [s] begins, with the temperatures `ends_c` [°C] at its ends where they are known. Needed where
    /// an effect of temperature or a failure is set.
    pub fn begin_interval(&mut self, t: f64, ends_c: Option<[f64; 2]>) {
        self.failing.begin_interval(t);
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
        self.size_effect.reposition();
        self.bandwidth.reposition();
    }

    /// What the triad makes of the ideal increment over `dt` [s]: the active effects act one after the other.
    #[inline(always)]
    pub fn sense(&mut self, ideal: &Increment, dt: f64) -> Vector3<f64> {
        // Time stamps differ in their last digits; what that changes of a variance is far below anything visible.
        if (dt - self.dt).abs() > 1e-7 * dt {
            self.set_interval(dt);
        }
        let mut felt = match self.sensor {
            Sensor::Gyro => ideal.angle,
            Sensor::Accelerometer => ideal.velocity,
        };
        if !self.plan.before_felt().is_empty() {
            felt = self.felt(&felt, &ideal.angle, dt);
        }
        let mut measured = felt;
        for step in self.plan.after_felt() {
            match self.plan.effect(step) {
                Effect::Linear => self.linear.apply(&felt, &mut measured),
                Effect::Bias => self.bias.apply(dt, &mut measured),
                Effect::GaussMarkov => self.gauss_markov.apply(&mut measured),
                Effect::RandomWalk => self.random_walk.apply(&mut measured),
                effect => self.apply(effect, &felt, &ideal.velocity, dt, &mut measured),
            }
        }
        measured
    }

    /// What the sensors feel of their part `ideal` of an increment with the angle `angle` [rad].
    #[inline(never)]
    fn felt(&mut self, ideal: &Vector3<f64>, angle: &Vector3<f64>, dt: f64) -> Vector3<f64> {
        let mut felt = *ideal;
        for step in self.plan.before_felt() {
            match self.plan.effect(step) {
                Effect::LeverArms => self.size_effect.apply(angle, dt, &mut felt),
                _ => self.bandwidth.apply(dt, &mut felt),
            }
        }
        felt
    }

    /// Lets an effect act that few triads have: out of the way of the others.
    #[inline(never)]
    fn apply(
        &mut self,
        effect: Effect,
        felt: &Vector3<f64>,
        velocity: &Vector3<f64>,
        dt: f64,
        measured: &mut Vector3<f64>,
    ) {
        match effect {
            Effect::Asymmetry => *measured += self.asymmetry.error(felt),
            Effect::Quadratic => *measured += self.quadratic.error(felt, dt),
            Effect::GSensitivity => *measured += self.g_sensitivity.error(velocity),
            Effect::Temperature => self.temperature.apply(felt, dt, measured),
            Effect::Flicker => self.flicker.apply(measured),
            Effect::RateRandomWalk => self.rate_random_walk.apply(dt, measured),
            Effect::Ramp => self.ramp.apply(dt, measured),
            Effect::Disturbance => self.failing.disturb(dt, measured),
            Effect::DeadZone => self.dead_zone.apply(dt, measured),
            Effect::Range => self.saturated |= self.range.apply(dt, measured),
            Effect::Quantization => self.quantization.apply(measured),
            Effect::Outage => self.failing.replace(dt, measured),
            // Of `felt` and `sense`.
            Effect::LeverArms
            | Effect::Bandwidth
            | Effect::Linear
            | Effect::Bias
            | Effect::GaussMarkov
            | Effect::RandomWalk => {}
        }
    }

    /// Whether an output has been beyond the range since this was asked last.
    #[inline]
    pub fn take_saturated(&mut self) -> bool {
        core::mem::take(&mut self.saturated)
    }

    #[cold]
    fn set_interval(&mut self, dt: f64) {
        self.dt = dt;
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
