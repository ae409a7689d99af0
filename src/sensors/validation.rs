//! The ranges of what a host sets of a triad.

use nalgebra::{Matrix3, Vector3};

use super::parameters::{Sensor, TriadParameters};
use crate::error::{Error, Rule, check_range, check_ranges, check_temperature};

/// Correlation times [s] for which the discretisation holds every digit; a longer one is a constant, a shorter one white.
pub(super) const MARKOV_TIME_RANGE_S: (f64, f64) = (1e-9, 1e15);

/// The fields as the interface spells them.
struct Names {
    bias: &'static str,
    bias_sigma: &'static str,
    markov_sigma: &'static str,
    markov_time: &'static str,
    random_walk: &'static str,
    rate_random_walk: &'static str,
    ramp: &'static str,
    flicker: &'static str,
    quantization: &'static str,
    scale_factor: &'static str,
    scale_factor_asymmetry: &'static str,
    scale_factor_nonlinearity: &'static str,
    misalignment: &'static str,
    g_sensitivity: &'static str,
    range: &'static str,
    bandwidth: &'static str,
    dead_zone: &'static str,
    lever_arm: &'static str,
    vibration_rectification: &'static str,
    reference_temperature: &'static str,
    bias_temperature: &'static str,
    bias_temperature2: &'static str,
    scale_factor_temperature: &'static str,
    scale_factor_temperature2: &'static str,
    scale_factor_sigma: &'static str,
    misalignment_sigma: &'static str,
}

const GYRO_NAMES: Names = Names {
    bias: "gyro.bias_rad_s",
    bias_sigma: "gyro.bias_sigma_rad_s",
    markov_sigma: "gyro.markov_sigma_rad_s",
    markov_time: "gyro.markov_time_s",
    random_walk: "gyro.random_walk_rad_sqrt_s",
    rate_random_walk: "gyro.rate_random_walk_rad_s_sqrt_s",
    ramp: "gyro.rate_ramp_rad_s2",
    flicker: "gyro.flicker_rad_s",
    quantization: "gyro.quantization_rad",
    scale_factor: "gyro.scale_factor",
    scale_factor_asymmetry: "gyro.scale_factor_asymmetry",
    scale_factor_nonlinearity: "gyro.scale_factor_nonlinearity_s_rad",
    misalignment: "gyro.misalignment_rad",
    g_sensitivity: "gyro.g_sensitivity_rad_s_per_m_s2",
    range: "gyro.range_rad_s",
    bandwidth: "gyro.bandwidth_hz",
    dead_zone: "gyro.dead_zone_rad_s",
    lever_arm: "gyro.lever_arm_m",
    vibration_rectification: "gyro.vibration_rectification_s2_m",
    reference_temperature: "gyro.reference_temperature_c",
    bias_temperature: "gyro.bias_temperature_rad_s_per_k",
    bias_temperature2: "gyro.bias_temperature2_rad_s_per_k2",
    scale_factor_temperature: "gyro.scale_factor_temperature_per_k",
    scale_factor_temperature2: "gyro.scale_factor_temperature2_per_k2",
    scale_factor_sigma: "gyro.scale_factor_sigma",
    misalignment_sigma: "gyro.misalignment_sigma_rad",
};

const ACCEL_NAMES: Names = Names {
    bias: "accel.bias_m_s2",
    bias_sigma: "accel.bias_sigma_m_s2",
    markov_sigma: "accel.markov_sigma_m_s2",
    markov_time: "accel.markov_time_s",
    random_walk: "accel.velocity_random_walk_m_s_sqrt_s",
    rate_random_walk: "accel.acceleration_random_walk_m_s2_sqrt_s",
    ramp: "accel.ramp_m_s3",
    flicker: "accel.flicker_m_s2",
    quantization: "accel.quantization_m_s",
    scale_factor: "accel.scale_factor",
    scale_factor_asymmetry: "accel.scale_factor_asymmetry",
    scale_factor_nonlinearity: "accel.scale_factor_nonlinearity_s2_m",
    misalignment: "accel.misalignment_rad",
    g_sensitivity: "accel.g_sensitivity_rad_s_per_m_s2",
    range: "accel.range_m_s2",
    bandwidth: "accel.bandwidth_hz",
    dead_zone: "accel.dead_zone_m_s2",
    lever_arm: "accel.lever_arm_m",
    vibration_rectification: "accel.vibration_rectification_s2_m",
    reference_temperature: "accel.reference_temperature_c",
    bias_temperature: "accel.bias_temperature_m_s2_per_k",
    bias_temperature2: "accel.bias_temperature2_m_s2_per_k2",
    scale_factor_temperature: "accel.scale_factor_temperature_per_k",
    scale_factor_temperature2: "accel.scale_factor_temperature2_per_k2",
    scale_factor_sigma: "accel.scale_factor_sigma",
    misalignment_sigma: "accel.misalignment_sigma_rad",
};

impl TriadParameters {
    /// Checks every field. The limits keep a wild host from overflowing the navigator, no more.
    pub fn validate(&self, sensor: Sensor) -> Result<(), Error> {
        let (names, limit) = match sensor {
            Sensor::Gyro => (&GYRO_NAMES, 100.0),
            Sensor::Accelerometer => (&ACCEL_NAMES, 1e4),
        };
        check_ranges(names.bias, self.bias.as_slice(), -limit, limit)?;
        check_ranges(names.bias_sigma, self.bias_sigma.as_slice(), 0.0, limit)?;
        check_ranges(names.markov_sigma, self.markov_sigma.as_slice(), 0.0, limit)?;
        for axis in 0..3 {
            check_markov_time(names.markov_time, self.markov_time_s[axis], self.markov_sigma[axis])
                .map_err(|error| error.at(axis))?;
        }
        check_ranges(names.random_walk, self.random_walk.as_slice(), 0.0, limit)?;
        check_ranges(names.rate_random_walk, self.rate_random_walk.as_slice(), 0.0, limit)?;
        check_ranges(names.ramp, self.ramp.as_slice(), -limit, limit)?;
        check_ranges(names.flicker, self.flicker.as_slice(), 0.0, limit)?;
        check_zero_or_ranges(names.quantization, &self.quantization, 1e-15, 1.0)?;
        check_ranges(names.scale_factor, self.scale_factor.as_slice(), -1.0, 1.0)?;
        check_ranges(names.scale_factor_asymmetry, self.scale_factor_asymmetry.as_slice(), -1.0, 1.0)?;
        check_ranges(names.scale_factor_nonlinearity, self.scale_factor_nonlinearity.as_slice(), -1.0, 1.0)?;
        check_zero_or_ranges(names.range, &self.range, 1e-9, 1e6)?;
        check_zero_or_ranges(names.bandwidth, &self.bandwidth_hz, 1e-3, 1e6)?;
        check_ranges(names.dead_zone, self.dead_zone.as_slice(), 0.0, limit)?;
        check_ranges(names.vibration_rectification, self.vibration_rectification_s2_m.as_slice(), -1.0, 1.0)?;
        check_temperature(names.reference_temperature, self.reference_temperature_c)?;
        check_ranges(names.bias_temperature, self.bias_temperature.as_slice(), -limit, limit)?;
        check_ranges(names.bias_temperature2, self.bias_temperature2.as_slice(), -limit, limit)?;
        check_ranges(names.scale_factor_temperature, self.scale_factor_temperature.as_slice(), -1.0, 1.0)?;
        check_ranges(names.scale_factor_temperature2, self.scale_factor_temperature2.as_slice(), -1.0, 1.0)?;
        check_matrix(names.g_sensitivity, &self.g_sensitivity, 1.0)?;
        check_matrix(names.lever_arm, &self.lever_arm_m, 100.0)?;
        check_ranges(names.scale_factor_sigma, self.scale_factor_sigma.as_slice(), 0.0, 1.0)?;
        check_misalignment(names.misalignment, &self.misalignment, -1.0, SCALE_FACTOR)?;
        check_misalignment(names.misalignment_sigma, &self.misalignment_sigma, 0.0, SCALE_FACTOR_SIGMA)?;
        self.check_belongs(sensor, names)
    }

    /// Terms that the other kind of sensor has.
    fn check_belongs(&self, sensor: Sensor, names: &Names) -> Result<(), Error> {
        match sensor {
            Sensor::Gyro => {
                check_foreign(names.lever_arm, self.lever_arm_m.transpose().as_slice())?;
                check_foreign(names.vibration_rectification, self.vibration_rectification_s2_m.as_slice())
            }
            Sensor::Accelerometer => {
                check_foreign(names.g_sensitivity, self.g_sensitivity.transpose().as_slice())
            }
        }
    }
}

fn check_foreign(field: &'static str, values: &[f64]) -> Result<(), Error> {
    match values.iter().position(|value| *value != 0.0) {
        Some(index) => {
            let rule = Rule::Words("must be 0: of the other kind of sensor");
            Err(Error::invalid(field, values[index], rule).at(index))
        }
        None => Ok(()),
    }
}

const SCALE_FACTOR: Rule = Rule::Words("must be 0 on the diagonal; use scale_factor");
const SCALE_FACTOR_SIGMA: Rule = Rule::Words("must be 0 on the diagonal; use scale_factor_sigma");

/// Checks each element, row by row, to be from `low` to 1, and 0 on the diagonal, or else the rule `diagonal` tells.
fn check_misalignment(
    field: &'static str,
    matrix: &Matrix3<f64>,
    low: f64,
    diagonal: Rule,
) -> Result<(), Error> {
    for (index, &value) in matrix.transpose().iter().enumerate() {
        check_range(field, value, low, 1.0).map_err(|error| error.at(index))?;
        if index % 4 == 0 && value != 0.0 {
            return Err(Error::invalid(field, value, diagonal).at(index));
        }
    }
    Ok(())
}

/// Checks each element of a matrix, row by row, to be within ±`limit`.
fn check_matrix(field: &'static str, matrix: &Matrix3<f64>, limit: f64) -> Result<(), Error> {
    check_ranges(field, matrix.transpose().as_slice(), -limit, limit)
}

/// Checks each element to be 0, which is off, or from `low` to `high`.
fn check_zero_or_ranges(
    field: &'static str,
    values: &Vector3<f64>,
    low: f64,
    high: f64,
) -> Result<(), Error> {
    for (index, &value) in values.iter().enumerate() {
        if value != 0.0 {
            check_range(field, value, low, high).map_err(|error| error.at(index))?;
        }
    }
    Ok(())
}

/// A correlation time is needed where there is a standard deviation.
pub(super) fn check_markov_time(field: &'static str, time_s: f64, sigma: f64) -> Result<(), Error> {
    let (shortest, longest) = MARKOV_TIME_RANGE_S;
    if sigma > 0.0 {
        check_range(field, time_s, shortest, longest)
    } else {
        check_range(field, time_s, 0.0, longest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_term_of_the_other_kind_of_sensor_is_refused() {
        let mut arm = TriadParameters::default();
        arm.lever_arm_m[(1, 2)] = -0.5;
        assert!(arm.validate(Sensor::Accelerometer).is_ok());
        assert_eq!(
            arm.validate(Sensor::Gyro).unwrap_err().to_string(),
            "gyro.lever_arm_m[5] = -0.5: must be 0: of the other kind of sensor"
        );
        let unbalance = TriadParameters { g_sensitivity: Matrix3::identity(), ..Default::default() };
        assert!(
            unbalance.validate(Sensor::Gyro).is_ok() && unbalance.validate(Sensor::Accelerometer).is_err()
        );
    }
}
