//! Three sensors and the effects that are active in them.

use nalgebra::Vector3;

use super::asymmetry::Asymmetry;
use super::bandwidth::Bandwidth;
use super::bias::Bias;
use super::dead_zone::DeadZone;
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
use crate::signal::Increment;
use crate::snapshot::stored;

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
    bias: Bias,
    gauss_markov: GaussMarkov,
    flicker: Flicker,
    rate_random_walk: RateRandomWalk,
    ramp: Ramp,
    random_walk: RandomWalk,
    dead_zone: DeadZone,
    range: Range,
    quantization: Quantization,
    plan: Plan,
    /// Length of the increments for which the units are made [s]; 0: for none yet.
    dt: f64,
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
    dt: 1e3,
} rebuilt {
    sensor, linear, asymmetry, quadratic, g_sensitivity, bias, dead_zone, range, plan, saturated,
} then |triad, _| {
    if triad.dt > 0.0 {
        triad.set_interval(triad.dt);
    }
    Ok(())
});

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
            bias: Bias::new(key, sensor),
            gauss_markov: GaussMarkov::new(key, sensor),
            flicker: Flicker::new(key, sensor),
            rate_random_walk: RateRandomWalk::new(key, sensor),
            ramp: Ramp::new(),
            random_walk: RandomWalk::new(key, sensor),
            dead_zone: DeadZone::new(),
            range: Range::new(),
            quantization: Quantization::new(),
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
            (Effect::Bias, self.bias.set(parameters)),
            (Effect::GaussMarkov, self.gauss_markov.set(parameters)),
            (Effect::Flicker, self.flicker.set(parameters)),
            (Effect::RateRandomWalk, self.rate_random_walk.set(parameters)),
            (Effect::Ramp, self.ramp.set(parameters)),
            (Effect::RandomWalk, self.random_walk.set(parameters)),
            (Effect::DeadZone, self.dead_zone.set(parameters)),
            (Effect::Range, self.range.set(parameters)),
            (Effect::Quantization, self.quantization.set(parameters)),
        ]);
        if self.dt > 0.0 {
            self.set_interval(self.dt);
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
            Effect::Flicker => self.flicker.apply(measured),
            Effect::RateRandomWalk => self.rate_random_walk.apply(dt, measured),
            Effect::Ramp => self.ramp.apply(dt, measured),
            Effect::DeadZone => self.dead_zone.apply(dt, measured),
            Effect::Range => self.saturated |= self.range.apply(dt, measured),
            Effect::Quantization => self.quantization.apply(measured),
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

    /// The error [u] that an alignment at this moment would see at the angular rate `rate` [rad/s] and the specific force
    /// `force` [m/s²]: all but the white noise and the quantization, which an alignment averages out.
    pub fn steady_error(&self, rate: &Vector3<f64>, force: &Vector3<f64>) -> Vector3<f64> {
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

#[cfg(test)]
mod tests {
    use super::*;

    const KEY: StreamKey = StreamKey { seed: 7, run: 3 };
    const IDEAL: Increment =
        Increment { angle: Vector3::new(0.1, -0.2, -0.0), velocity: Vector3::new(0.3, -0.0, 9.8) };

    fn noisy() -> TriadParameters {
        let ones = Vector3::repeat(1.0);
        TriadParameters { markov_sigma: ones, markov_time_s: ones, random_walk: ones, ..Default::default() }
    }

    #[test]
    fn an_ideal_triad_is_transparent_to_the_bit() {
        let mut triad = Triad::new(KEY, Sensor::Gyro);
        triad.set(&TriadParameters::default());
        let measured = triad.sense(&IDEAL, 0.01);
        assert!(triad.is_ideal());
        assert_eq!(measured.map(f64::to_bits), IDEAL.angle.map(f64::to_bits));
    }

    #[test]
    fn switching_an_effect_leaves_the_draws_of_the_others() {
        let dt = 0.01;
        let mut both = Triad::new(KEY, Sensor::Gyro);
        both.set(&noisy());
        let mut walk = Triad::new(KEY, Sensor::Gyro);
        walk.set(&TriadParameters { markov_sigma: Vector3::zeros(), ..noisy() });
        let mut markov = Triad::new(KEY, Sensor::Gyro);
        markov.set(&TriadParameters { random_walk: Vector3::zeros(), ..noisy() });
        let zero = Increment::ZERO;
        for step in 0..100 {
            if step == 50 {
                // In flight: the other process goes on as if nothing had happened.
                both.set(&TriadParameters { random_walk: Vector3::zeros(), ..noisy() });
            }
            let sum = both.sense(&zero, dt);
            let mut parts = markov.sense(&zero, dt);
            if step < 50 {
                // The sum is formed in the order of the effects: Markov first.
                let noise = walk.sense(&zero, dt);
                parts += noise;
            }
            assert_eq!(sum, parts, "step {step}");
        }
    }

    #[test]
    fn errors_are_in_the_units_of_the_parameters() {
        let mut triad = Triad::new(KEY, Sensor::Accelerometer);
        let mut parameters = TriadParameters { bias: Vector3::new(0.0, 0.5, 0.0), ..Default::default() };
        parameters.scale_factor.x = 1e-3;
        parameters.misalignment[(2, 0)] = 1e-4;
        triad.set(&parameters);
        let velocity = Vector3::new(2.0, 0.0, 0.0);
        let measured = triad.sense(&Increment { velocity, ..Increment::ZERO }, 0.01);
        assert_eq!(measured, Vector3::new(2.002, 0.005, 2e-4));
        let error = triad.steady_error(&Vector3::zeros(), &Vector3::new(200.0, 0.0, 0.0));
        assert_eq!(error, Vector3::new(0.2, 0.5, 0.02));
    }
}
