//! Bounds of the errors with which the sensors of an INS at rest show the rotation of the Earth, and gravity.

use nalgebra::Vector3;

use super::{Mode, Simulator};
use crate::base::units::STANDARD_GRAVITY as GRAVITY;
use crate::errors::covariance::{Signals, Variances};
use crate::mechanization::VerticalLoop;
use crate::sensors::{PARAMETERS, Sensor, Triad, TriadParameters};
use crate::truth::TruthPoint;

/// What the loop of the vertical channel estimates of gravity's anomalies, and of an altimeter that drifts \[m/s²\].
const BESIDE_SENSORS_M_S2: f64 = 5e-4;

/// A bound of an error: the size of what is set, and the standard deviation of what is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bound {
    pub set: f64,
    pub sigma: f64,
}

impl Bound {
    /// The bound for this number of standard deviations.
    pub fn at(&self, sigmas: f64) -> f64 {
        self.set + sigmas * self.sigma
    }

    /// The bound of the error times `factor`.
    pub fn times(&self, factor: f64) -> Self {
        Self { set: self.set * factor, sigma: self.sigma * factor }
    }

    /// The bound of the sum of two independent errors.
    pub fn plus(&self, other: &Self) -> Self {
        Self { set: self.set + other.set, sigma: crate::base::math::hypot(self.sigma, other.sigma) }
    }
}

impl Simulator {
    /// Bound of the error of the mean angular rate about any axis, over the last `t` \[s\] \[rad/s\]. `temperatures_c` are those at the
    /// start of this time and now; a drawn walk began `since_start_s` \[s\] before it.
    pub(crate) fn mean_rate_error(
        &self,
        signals: &Signals,
        t: f64,
        temperatures_c: [Option<f64>; 2],
        since_start_s: f64,
    ) -> Bound {
        let Bound { set, sigma } = self.mean_error(Sensor::Gyro, signals, t, temperatures_c, since_start_s);
        Bound { set: set + self.gyro().quantization.amax() / t, sigma }
    }

    /// Bound of the error of the mean specific force along any axis \[m/s²\], with the arguments of `mean_rate_error`.
    pub(crate) fn mean_force_error(
        &self,
        signals: &Signals,
        t: f64,
        temperatures_c: [Option<f64>; 2],
        since_start_s: f64,
    ) -> Bound {
        self.mean_error(Sensor::Accelerometer, signals, t, temperatures_c, since_start_s)
    }

    /// Bound of the mean error of `sensor` that is set or drawn, without the quantization of gyros.
    fn mean_error(
        &self,
        sensor: Sensor,
        signals: &Signals,
        t: f64,
        temperatures_c: [Option<f64>; 2],
        since_start_s: f64,
    ) -> Bound {
        let [start, now] = self.set_errors(sensor, signals, t, temperatures_c);
        let variances = Variances::of_means(&self.imperfections.parameters(), signals, t, since_start_s);
        let variances = if sensor == Sensor::Gyro { variances.gyro } else { variances.accel };
        Bound { set: size(&start).max(size(&now)), sigma: variances.amax().sqrt() }
    }

    /// Bound of the change of the mean error of the specific force between two windows of length `window_s`, `apart_s` \[s\] apart, the
    /// last of which ends now \[m/s²\].
    pub(crate) fn force_error_change(
        &self,
        signals: &Signals,
        (window_s, apart_s): (f64, f64),
        temperatures_c: [Option<f64>; 2],
    ) -> Bound {
        let [start, now] = self.set_errors(Sensor::Accelerometer, signals, apart_s, temperatures_c);
        let parameters = self.imperfections.parameters();
        let variances = Variances::of_differences(&parameters, signals, (window_s, apart_s));
        // A remainder of at most q/2 that changes with the slope 4/a of the weight of each of two windows of length a.
        let of_pulses = 4.0 * self.accel().quantization.amax() / window_s;
        Bound { set: size(&(now - start)) + of_pulses, sigma: variances.accel.amax().sqrt() }
    }

    /// Begins the loop of the vertical channel anew if no accelerometer errors of up to `sigmas` standard deviations explain what it
    /// estimates: it comes from failures, or from a solution that was wrong before. A drawn walk began `since_start_s` \[s\] ago.
    pub(crate) fn limit_vertical_bias(&mut self, sigmas: f64, since_start_s: f64) {
        const OVER_S: f64 = VerticalLoop::TIME_CONSTANT_S;
        let signals = Signals { rate_s: Vector3::zeros(), force_s: Vector3::repeat(GRAVITY) };
        let now_c = self.true_point().and_then(TruthPoint::temperature_c);
        let of_sensors = self.mean_force_error(&signals, OVER_S, [now_c; 2], since_start_s);
        if let Mode::Flying(chain) = &mut self.mode {
            chain.limit_vertical_bias(of_sensors.at(sigmas) + BESIDE_SENSORS_M_S2);
        }
    }

    /// The errors of a triad that are set, `t` \[s\] ago and now \[u\].
    fn set_errors(
        &self,
        sensor: Sensor,
        signals: &Signals,
        t: f64,
        temperatures_c: [Option<f64>; 2],
    ) -> [Vector3<f64>; 2] {
        let (triad, parameters) = match sensor {
            Sensor::Gyro => (&self.imperfections.gyro, self.gyro()),
            Sensor::Accelerometer => (&self.imperfections.accel, self.accel()),
        };
        let set = without_random(parameters);
        let mut triad: Triad = triad.clone();
        triad.set(&set);
        let [then, now] = temperatures_c
            .map(|temperature_c| triad.steady_error(&signals.rate_s, &signals.force_s, temperature_c));
        [then - set.ramp * t, now]
    }
}

fn size(vector: &Vector3<f64>) -> f64 {
    vector.norm_squared().sqrt()
}

/// The same parameters with nothing drawn.
fn without_random(parameters: &TriadParameters) -> TriadParameters {
    let mut set = *parameters;
    for (parameter, numbers) in PARAMETERS.iter().zip(set.numbers_mut()) {
        if parameter.is_random {
            numbers.fill(0.0);
        }
    }
    set
}
