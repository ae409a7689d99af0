//! Errors that follow the temperature.

use nalgebra::Vector3;

use super::super::parameters::TriadParameters;
use super::super::stream::EffectStreams;
use super::effect::{Conditions, Effect, Input, OfInput};
use crate::base::snapshot::stored;

/// With θ = T - T_ref, bias b1 θ + b2 θ² and scale factor error s1 θ + s2 θ² (thermal coefficients, IEEE Std 952 and 1293).
///
/// T is linear from one sample to the next. Over an interval in which T changes by d and θ has the mean m, the mean of θ² is
/// m² + d²/12. The integral of the bias is exact. The integral of the scale factor error is exact for a constant signal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sensors) struct Temperature {
    /// T_ref [°C].
    reference_c: f64,
    /// b1 [u/K], b2 [u/K²].
    bias: [Vector3<f64>; 2],
    /// s1 [1/K], s2 [1/K²].
    scale_factor: [Vector3<f64>; 2],
    mean: Errors,
}

/// The errors at a temperature, or their means over an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Errors {
    /// [u]
    bias: Vector3<f64>,
    scale_factor: Vector3<f64>,
}

impl Errors {
    const NONE: Self = Self { bias: Vector3::new(0.0, 0.0, 0.0), scale_factor: Vector3::new(0.0, 0.0, 0.0) };

    /// Integral of the errors over the input [u s].
    fn integral(&self, input: &Input) -> Vector3<f64> {
        self.bias * input.dt + self.scale_factor.component_mul(&input.signal)
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
}

stored!(Temperature {} rebuilt { reference_c, bias, scale_factor, mean });

impl Effect for Temperature {
    fn new(_: &EffectStreams) -> Self {
        let zero = [Vector3::zeros(); 2];
        Self { reference_c: 0.0, bias: zero, scale_factor: zero, mean: Errors::NONE }
    }

    fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.reference_c = parameters.reference_temperature_c;
        self.bias = [parameters.bias_temperature, parameters.bias_temperature2];
        self.scale_factor = [parameters.scale_factor_temperature, parameters.scale_factor_temperature2];
        parameters.depend_on_temperature()
    }

    fn begin_interval(&mut self, conditions: &Conditions) {
        if let Some(ends_c) = conditions.ends_c {
            let change = ends_c[1] - ends_c[0];
            self.mean = self.errors(ends_c[0] + 0.5 * change, change * change / 12.0);
        }
    }
}

impl OfInput for Temperature {
    fn steady_error(&self, input: &Input, temperature_c: Option<f64>) -> Vector3<f64> {
        temperature_c.map(|c| self.errors(c, 0.0).integral(input)).unwrap_or_default()
    }

    #[inline]
    fn error(&self, input: &Input) -> Vector3<f64> {
        self.mean.integral(input)
    }
}

impl Temperature {
    /// Errors at the mean temperature `mean_c` [°C] with the variance `variance` [K²] about it.
    fn errors(&self, mean_c: f64, variance: f64) -> Errors {
        let mean = mean_c - self.reference_c;
        let square = mean * mean + variance;
        let at = |[first, second]: &[Vector3<f64>; 2]| first * mean + second * square;
        Errors { bias: at(&self.bias), scale_factor: at(&self.scale_factor) }
    }
}
