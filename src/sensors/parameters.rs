//! What a host sets of a triad of gyros or of accelerometers.

use nalgebra::{Matrix3, Vector3};

use super::flicker::FLICKER_DEVIATION;
use super::stream::Source;
use crate::error::{Error, Rule, check_range, check_ranges};

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
    /// Of accelerometers: place of each against the reference point [m], row = sensor.
    pub lever_arm_m: Matrix3<f64>,
    /// Of accelerometers: vibration rectification, the g² term [s²/m].
    pub vibration_rectification_s2_m: Vector3<f64>,
}

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
        }
    }
}

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
};

/// Correlation times [s] for which the discretisation holds every digit; a longer one is a constant, a shorter one white.
pub(super) const MARKOV_TIME_RANGE_S: (f64, f64) = (1e-9, 1e15);

/// Signals [u] that throw no solution out of its range within one interval.
const TAME_SIGNAL: f64 = 2000.0;

/// From the first to the last time stamp that there can be [s].
const LONGEST_S: f64 = 2e10;

impl Sensor {
    pub(super) fn source(self) -> Source {
        match self {
            Self::Gyro => Source::Gyro,
            Self::Accelerometer => Source::Accelerometer,
        }
    }
}

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
        let largest = self.bias.abs() + self.ramp.abs() * LONGEST_S + random * 10.0;
        // Ones everywhere in scale factor and misalignment have the norm 3.
        let gain = (self.misalignment + Matrix3::from_diagonal(&self.scale_factor)).norm()
            + 0.5 * self.scale_factor_asymmetry.amax();
        largest.amax() <= TAME_SIGNAL
            && self.random_walk.amax() <= 100.0
            && gain <= 3.0
            && self.g_sensitivity.norm() <= 0.1
            && self.scale_factor_nonlinearity == zero
            && self.vibration_rectification_s2_m == zero
            && self.bandwidth_hz == zero
            && self.lever_arm_m == Matrix3::zeros()
    }

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
        check_matrix(names.g_sensitivity, &self.g_sensitivity, 1.0)?;
        check_matrix(names.lever_arm, &self.lever_arm_m, 100.0)?;
        for row in 0..3 {
            for column in 0..3 {
                let value = self.misalignment[(row, column)];
                let index = 3 * row + column;
                check_range(names.misalignment, value, -1.0, 1.0).map_err(|error| error.at(index))?;
                if row == column && value != 0.0 {
                    let rule = Rule::Words("must be 0 on the diagonal; use scale_factor");
                    return Err(Error::invalid(names.misalignment, value, rule).at(index));
                }
            }
        }
        self.check_belongs(sensor, names)
    }

    /// Terms that the other kind of sensor has.
    fn check_belongs(&self, sensor: Sensor, names: &Names) -> Result<(), Error> {
        let rule = Rule::Words("must be 0: of the other kind of sensor");
        let foreign = match sensor {
            Sensor::Gyro => [
                (names.lever_arm, self.lever_arm_m.amax()),
                (names.vibration_rectification, self.vibration_rectification_s2_m.amax()),
            ],
            Sensor::Accelerometer => [(names.g_sensitivity, self.g_sensitivity.amax()); 2],
        };
        match foreign.iter().find(|(_, value)| *value != 0.0) {
            Some(&(field, value)) => Err(Error::invalid(field, value, rule)),
            None => Ok(()),
        }
    }
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
            TriadParameters { scale_factor_nonlinearity: Vector3::x() * 1e-9, ..ideal },
            TriadParameters { vibration_rectification_s2_m: Vector3::z() * -1e-9, ..ideal },
            TriadParameters { g_sensitivity: Matrix3::identity(), ..ideal },
            TriadParameters { lever_arm_m: Matrix3::identity() * 1e-3, ..ideal },
            TriadParameters { bandwidth_hz: Vector3::y() * 100.0, ..ideal },
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
            ..ideal
        };
        assert!(of_the_laboratory.is_tame());
    }

    #[test]
    fn a_term_of_the_other_kind_of_sensor_is_refused() {
        let arm = TriadParameters { lever_arm_m: Matrix3::identity(), ..Default::default() };
        assert!(arm.validate(Sensor::Accelerometer).is_ok());
        assert_eq!(
            arm.validate(Sensor::Gyro).unwrap_err().to_string(),
            "gyro.lever_arm_m = 1: must be 0: of the other kind of sensor"
        );
        let unbalance = TriadParameters { g_sensitivity: Matrix3::identity(), ..Default::default() };
        assert!(
            unbalance.validate(Sensor::Gyro).is_ok() && unbalance.validate(Sensor::Accelerometer).is_err()
        );
    }
}
