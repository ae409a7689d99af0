//! What a host sets of a triad of gyros or of accelerometers.

use nalgebra::{Matrix3, Vector3};

use super::stream::Source;
use crate::snapshot::{ANY, stored};

/// Which triad.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sensor {
    /// Angular rate; the unit u of the parameters is rad/s.
    Gyro,
    /// Specific force; the unit u of the parameters is m/s².
    Accelerometer,
}

/// Errors of a triad of sensors, axis by axis in sensor axes; u = rad/s or m/s². All zero is an ideal triad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TriadParameters {
    /// Constant bias [u].
    pub bias: Vector3<f64>,
    /// Standard deviation of the turn-on bias, drawn once a run [u].
    pub bias_sigma: Vector3<f64>,
    /// Standard deviation of the first-order Gauss-Markov bias [u].
    pub markov_sigma: Vector3<f64>,
    /// Its correlation time [s].
    pub markov_time_s: Vector3<f64>,
    /// White noise N: angle or velocity random walk [u √s].
    pub random_walk: Vector3<f64>,
    /// Rate or acceleration random walk K [u/√s].
    pub rate_random_walk: Vector3<f64>,
    /// Ramp R [u/s].
    pub ramp: Vector3<f64>,
    /// Flicker noise, bias instability B [u]: the flat part of the Allan deviation is 0.664 B.
    pub flicker: Vector3<f64>,
    /// Pulse of the output increments [u s].
    pub quantization: Vector3<f64>,
    /// Scale factor error.
    pub scale_factor: Vector3<f64>,
    /// Scale factor error of positive less that of negative signals.
    pub scale_factor_asymmetry: Vector3<f64>,
    /// Scale factor error that grows with the size of the signal [1/u].
    pub scale_factor_nonlinearity: Vector3<f64>,
    /// Misalignment [rad]: row = sensor, column = axis it should not feel; the diagonal is 0.
    pub misalignment: Matrix3<f64>,
    /// Of gyros: g-sensitivity [(rad/s)/(m/s²)], row = gyro, column = axis of the force.
    pub g_sensitivity: Matrix3<f64>,
    /// Where the output saturates [u]; 0: nowhere.
    pub range: Vector3<f64>,
    /// Bandwidth, -3 dB [Hz]; 0: without limit.
    pub bandwidth_hz: Vector3<f64>,
    /// Signals up to this size give nothing [u].
    pub dead_zone: Vector3<f64>,
    /// Of accelerometers: place of each against the block's own point [m], sensor axes, row = sensor.
    pub lever_arm_m: Matrix3<f64>,
    /// Of accelerometers: vibration rectification, the g² term [s²/m].
    pub vibration_rectification_s2_m: Vector3<f64>,
    /// Temperature at which the four terms below are 0 [°C].
    pub reference_temperature_c: f64,
    /// Bias that grows with the temperature [u/K].
    pub bias_temperature: Vector3<f64>,
    /// And with its square [u/K²].
    pub bias_temperature2: Vector3<f64>,
    /// Scale factor error that grows with the temperature [1/K].
    pub scale_factor_temperature: Vector3<f64>,
    /// And with its square [1/K²].
    pub scale_factor_temperature2: Vector3<f64>,
    /// Standard deviation of the scale factor error, drawn once a run.
    pub scale_factor_sigma: Vector3<f64>,
    /// Standard deviation of each misalignment, drawn once a run [rad]; the diagonal is 0.
    pub misalignment_sigma: Matrix3<f64>,
}

stored!(TriadParameters {
    bias: ANY,
    bias_sigma: ANY,
    markov_sigma: ANY,
    markov_time_s: ANY,
    random_walk: ANY,
    rate_random_walk: ANY,
    ramp: ANY,
    flicker: ANY,
    quantization: ANY,
    scale_factor: ANY,
    scale_factor_asymmetry: ANY,
    scale_factor_nonlinearity: ANY,
    misalignment: ANY,
    g_sensitivity: ANY,
    range: ANY,
    bandwidth_hz: ANY,
    dead_zone: ANY,
    lever_arm_m: ANY,
    vibration_rectification_s2_m: ANY,
    reference_temperature_c: ANY,
    bias_temperature: ANY,
    bias_temperature2: ANY,
    scale_factor_temperature: ANY,
    scale_factor_temperature2: ANY,
    scale_factor_sigma: ANY,
    misalignment_sigma: ANY,
});

impl Default for TriadParameters {
    fn default() -> Self {
        let zero = Vector3::zeros();
        Self {
            bias: zero,
            bias_sigma: zero,
            markov_sigma: zero,
            markov_time_s: zero,
            random_walk: zero,
            rate_random_walk: zero,
            ramp: zero,
            flicker: zero,
            quantization: zero,
            scale_factor: zero,
            scale_factor_asymmetry: zero,
            scale_factor_nonlinearity: zero,
            misalignment: Matrix3::zeros(),
            g_sensitivity: Matrix3::zeros(),
            range: zero,
            bandwidth_hz: zero,
            dead_zone: zero,
            lever_arm_m: Matrix3::zeros(),
            vibration_rectification_s2_m: zero,
            reference_temperature_c: 0.0,
            bias_temperature: zero,
            bias_temperature2: zero,
            scale_factor_temperature: zero,
            scale_factor_temperature2: zero,
            scale_factor_sigma: zero,
            misalignment_sigma: Matrix3::zeros(),
        }
    }
}

impl TriadParameters {
    /// Whether a temperature has to be known.
    pub fn depend_on_temperature(&self) -> bool {
        let zero = Vector3::zeros();
        self.bias_temperature != zero
            || self.bias_temperature2 != zero
            || self.scale_factor_temperature != zero
            || self.scale_factor_temperature2 != zero
    }

    /// Standard deviations of scale factor errors and misalignments, as one matrix.
    pub(super) fn linear_sigma(&self) -> Matrix3<f64> {
        self.misalignment_sigma + Matrix3::from_diagonal(&self.scale_factor_sigma)
    }
}

impl Sensor {
    pub(super) fn source(self) -> Source {
        match self {
            Self::Gyro => Source::Gyro,
            Self::Accelerometer => Source::Accelerometer,
        }
    }
}
