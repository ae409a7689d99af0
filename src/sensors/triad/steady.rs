//! The error of a triad that does not average out.

use nalgebra::Vector3;

use super::super::input::Input;
use super::{Sensor, Triad};

impl Triad {
    /// The error [u] that an alignment at this moment would have at the angular rate `rate` [rad/s], the specific force `force`
    /// [m/s²] and the temperature `temperature_c` [°C]; `None`: the reference temperature. It excludes white noise and
    /// quantization, because an alignment averages them out, and failures, because they come after it.
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
        let input = Input { signal: ideal + size_error, force: *force, dt: 1.0 };
        let error = self.linear.error(&input)
            + self.bias.value()
            + self.gauss_markov.value()
            + size_error
            + self.asymmetry.error(&input)
            + self.quadratic.error(&input)
            + self.g_sensitivity.error(&input)
            + self.flicker.value()
            + self.rate_random_walk.value()
            + self.ramp.value();
        let thermal = temperature_c.map(|c| self.temperature.steady_error(c, &input));
        let error = error + thermal.unwrap_or_default();
        // Adding and subtracting the signal has rounding errors, so this is done only where the limits change something.
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
