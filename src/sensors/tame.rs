//! Sensors of which a step has nothing to fear.

use nalgebra::{Matrix3, Vector3};

use super::flicker::FLICKER_DEVIATION;
use super::parameters::TriadParameters;
use crate::error::TEMPERATURE_RANGE_C;

/// Signals [u] that throw no solution out of its range within one interval.
const TAME_SIGNAL: f64 = 2000.0;

/// From the first to the last time stamp that there can be [s].
const LONGEST_S: f64 = 2e10;

impl TriadParameters {
    /// Whether a step has nothing to fear of such sensors: what they add to signals that a navigator can follow stays
    /// below 2000 u and 100 u √s, with ten standard deviations of all random terms over all time, or their range does.
    /// Terms that grow faster than the signal, and those that remember or differentiate it, have no such bound of their own.
    pub fn is_tame(&self) -> bool {
        if self.range.iter().all(|&range| range > 0.0 && range <= TAME_SIGNAL) {
            return true;
        }
        let zero = Vector3::zeros();
        let random = self.bias_sigma
            + self.markov_sigma
            + self.flicker * FLICKER_DEVIATION
            + self.rate_random_walk * LONGEST_S.sqrt();
        let kelvin = TEMPERATURE_RANGE_C.1 - TEMPERATURE_RANGE_C.0;
        let thermal = self.bias_temperature.abs() * kelvin + self.bias_temperature2.abs() * kelvin * kelvin;
        let thermal_scale = self.scale_factor_temperature.abs() * kelvin
            + self.scale_factor_temperature2.abs() * kelvin * kelvin;
        let largest = self.bias.abs() + self.ramp.abs() * LONGEST_S + random * 10.0 + thermal;
        // Ones everywhere in scale factor and misalignment have the norm 3.
        let gain = (self.misalignment + Matrix3::from_diagonal(&self.scale_factor)).norm()
            + 10.0 * self.linear_sigma().norm()
            + 0.5 * self.scale_factor_asymmetry.amax()
            + thermal_scale.amax();
        largest.amax() <= TAME_SIGNAL
            && self.random_walk.amax() <= 100.0
            && gain <= 3.0
            && self.g_sensitivity.norm() <= 0.1
            && self.scale_factor_nonlinearity == zero
            && self.vibration_rectification_s2_m == zero
            && self.bandwidth_hz == zero
            && self.lever_arm_m == Matrix3::zeros()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each effect alone, at a size that can throw a solution away, and at one of the laboratory.
    #[test]
    fn wild_sensors_are_not_tame_and_those_with_a_range_are() {
        let one = Vector3::repeat(1.0);
        let ideal = TriadParameters::default();
        assert!(ideal.is_tame());
        let wild = [
            TriadParameters { bias: one * 3000.0, ..ideal },
            TriadParameters { bias_sigma: one * 300.0, ..ideal },
            TriadParameters { markov_sigma: one * 300.0, ..ideal },
            TriadParameters { random_walk: one * 1000.0, ..ideal },
            TriadParameters { flicker: one * 100.0, ..ideal },
            TriadParameters { rate_random_walk: one * 1e-2, ..ideal },
            TriadParameters { ramp: one * -1e-6, ..ideal },
            TriadParameters { scale_factor: one, misalignment: Matrix3::repeat(1.0), ..ideal },
            TriadParameters {
                scale_factor_asymmetry: one,
                misalignment: Matrix3::repeat(1.0) - Matrix3::identity(),
                scale_factor: one * 0.9,
                ..ideal
            },
            TriadParameters { scale_factor_sigma: one * 0.2, ..ideal },
            TriadParameters { misalignment_sigma: Matrix3::repeat(0.2), ..ideal },
            TriadParameters { scale_factor_nonlinearity: Vector3::x() * 1e-9, ..ideal },
            TriadParameters { vibration_rectification_s2_m: Vector3::z() * -1e-9, ..ideal },
            TriadParameters { g_sensitivity: Matrix3::identity(), ..ideal },
            TriadParameters { lever_arm_m: Matrix3::identity() * 1e-3, ..ideal },
            TriadParameters { bandwidth_hz: Vector3::y() * 100.0, ..ideal },
            TriadParameters { bias_temperature: one * 2.0, ..ideal },
            TriadParameters { bias_temperature2: one * -1.5e-3, ..ideal },
            TriadParameters { scale_factor_temperature: one * -2.5e-3, ..ideal },
            TriadParameters { scale_factor_temperature2: one * 2e-6, ..ideal },
        ];
        for (index, parameters) in wild.iter().enumerate() {
            assert!(!parameters.is_tame(), "{index}");
            assert!(TriadParameters { range: one * 1000.0, ..*parameters }.is_tame(), "{index}");
            assert!(!TriadParameters { range: Vector3::new(1.0, 0.0, 1.0), ..*parameters }.is_tame());
            assert!(!TriadParameters { range: one * 1e5, ..*parameters }.is_tame());
        }
        let of_the_laboratory = TriadParameters {
            bias: one * 1e-3,
            bias_sigma: one * 1e-2,
            markov_sigma: one * 1e-3,
            random_walk: one * 1e-3,
            rate_random_walk: one * 1e-5,
            ramp: one * 1e-9,
            flicker: one * 1e-4,
            quantization: one * 1e-4,
            scale_factor: one * 0.03,
            scale_factor_asymmetry: one * 1e-3,
            g_sensitivity: Matrix3::identity() * 2e-4,
            dead_zone: one * 1e-3,
            bias_temperature: one * 1e-4,
            bias_temperature2: one * 1e-6,
            scale_factor_temperature: one * 1e-4,
            scale_factor_temperature2: one * 1e-7,
            scale_factor_sigma: one * 0.03,
            misalignment_sigma: Matrix3::repeat(0.02),
            ..ideal
        };
        assert!(of_the_laboratory.is_tame());
    }
}
