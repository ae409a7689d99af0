//! Three sensors and the effects that are active in them.

mod runs;
mod sense;
mod steady;

pub(crate) use runs::SharedInput;

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
use crate::signal::{MAX_INCREMENTS, Turning};
use crate::snapshot::{Reader, Stored, stored};
use crate::truth::INTERVALS_S;

/// A triad of gyros or accelerometers. An ideal triad does not change a bit of the increments.
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
    failing: Kept<FailingTriad>,
    plan: Plan,
    /// Length of the increments for which the effects are prepared [s]; 0: not prepared yet.
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
            failing: Kept::new(FailingTriad::new(key, sensor.source())),
            plan: Plan::IDEAL,
            dt: Kept::new(0.0),
            saturated: false,
        }
    }

    /// Takes validated parameters, and decides which effects act on each increment from now on. Processes that were active continue
    /// from their current states.
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

    /// Sets or clears the failure of one axis. `last` is the last output of the axis [u], if there was one. `parameters` are the
    /// parameters that are already set.
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

    /// The failure that is set for one axis.
    pub fn failure(&self, axis: Axis) -> Option<Failure> {
        self.failing.failure(axis)
    }

    /// The failures. A snapshot needs them before it sets the parameters, because `set` makes a plan of both.
    pub(crate) fn failures(&self) -> &FailingTriad {
        &self.failing
    }

    /// Reads the failures.
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

    /// Whether an accelerometer is away from the block's own point.
    pub fn has_size_effect(&self) -> bool {
        self.size_effect.is_active()
    }

    /// Begins a sample interval of `t` [s]. `ends_c` are the temperatures at its ends [°C], and `turning` is the motion that its
    /// increments belong to; each is `None` if it is not known. The call is needed if an effect of temperature, the size effect or
    /// a failure is set.
    pub fn begin_interval(&mut self, t: f64, ends_c: Option<[f64; 2]>, turning: Option<Turning>) {
        self.failing.keep();
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

    /// Follows a jump of the signals: filters settle at once at the next signals. Noise continues.
    pub fn reposition(&mut self) {
        self.bandwidth.reposition();
    }
}
