//! Three sensors and the effects that are active in them.

use nalgebra::Vector3;

use super::bias::Bias;
use super::gauss_markov::GaussMarkov;
use super::linear::Linear;
use super::parameters::{Sensor, TriadParameters};
use super::random_walk::RandomWalk;
use super::stream::StreamKey;

/// The effects that a parameter calls for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Active {
    linear: bool,
    bias: bool,
    gauss_markov: bool,
    random_walk: bool,
}

/// A triad of gyros or accelerometers. An ideal one leaves the increments untouched, to the bit.
#[derive(Debug, Clone, PartialEq)]
pub struct Triad {
    linear: Linear,
    bias: Bias,
    gauss_markov: GaussMarkov,
    random_walk: RandomWalk,
    active: Active,
    /// Length of the increments for which the units are made [s]; 0: for none yet.
    dt: f64,
}

impl Triad {
    /// An ideal triad whose random effects, if ever switched on, draw from the streams of `key`.
    pub fn new(key: StreamKey, sensor: Sensor) -> Self {
        Self {
            linear: Linear::new(),
            bias: Bias::new(key, sensor),
            gauss_markov: GaussMarkov::new(key, sensor),
            random_walk: RandomWalk::new(key, sensor),
            active: Active::default(),
            dt: 0.0,
        }
    }

    /// Takes validated parameters and decides what is to be done for each increment from now on. Processes that were
    /// active go on from where they are.
    pub fn set(&mut self, parameters: &TriadParameters) {
        self.active = Active {
            linear: self.linear.set(parameters),
            bias: self.bias.set(parameters),
            gauss_markov: self.gauss_markov.set(parameters),
            random_walk: self.random_walk.set(parameters),
        };
        if self.dt > 0.0 {
            self.set_interval(self.dt);
        }
    }

    /// Whether no effect is active.
    pub fn is_ideal(&self) -> bool {
        self.active == Active::default()
    }

    /// What the triad makes of the ideal increment over `dt` [s]: the effects act in this order.
    #[inline]
    pub fn sense(&mut self, ideal: &Vector3<f64>, dt: f64) -> Vector3<f64> {
        // Time stamps differ in their last digits; what that changes of a variance is far below anything visible.
        if (dt - self.dt).abs() > 1e-7 * dt {
            self.set_interval(dt);
        }
        let mut measured = *ideal;
        if self.active.linear {
            self.linear.apply(ideal, &mut measured);
        }
        if self.active.bias {
            self.bias.apply(dt, &mut measured);
        }
        if self.active.gauss_markov {
            self.gauss_markov.apply(&mut measured);
        }
        if self.active.random_walk {
            self.random_walk.apply(&mut measured);
        }
        measured
    }

    fn set_interval(&mut self, dt: f64) {
        self.dt = dt;
        self.gauss_markov.set_interval(dt);
        self.random_walk.set_interval(dt);
    }

    /// The error [u] that an alignment at this moment would see while the ideal signal is `ideal` [u]: all but the white
    /// noise, which an alignment averages out.
    pub fn steady_error(&self, ideal: &Vector3<f64>) -> Vector3<f64> {
        self.linear.error(ideal) + self.bias.value() + self.gauss_markov.value()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const KEY: StreamKey = StreamKey { seed: 7, run: 3 };
    const IDEAL: Vector3<f64> = Vector3::new(0.1, -0.2, -0.0);

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
        assert_eq!(measured.map(f64::to_bits), IDEAL.map(f64::to_bits));
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
        let zero = Vector3::zeros();
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
        let measured = triad.sense(&Vector3::new(2.0, 0.0, 0.0), 0.01);
        assert_eq!(measured, Vector3::new(2.002, 0.005, 2e-4));
        assert_eq!(triad.steady_error(&Vector3::new(200.0, 0.0, 0.0)), Vector3::new(0.2, 0.5, 0.02));
    }
}
