//! What a host sets of a triad of gyros or of accelerometers.

use nalgebra::{Matrix3, Vector3};

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
    /// Scale factor error.
    pub scale_factor: Vector3<f64>,
    /// Misalignment [rad]: row = sensor, column = axis it should not feel; the diagonal is 0.
    pub misalignment: Matrix3<f64>,
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
            scale_factor: zero,
            misalignment: Matrix3::zeros(),
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
    scale_factor: &'static str,
    misalignment: &'static str,
}

const GYRO_NAMES: Names = Names {
    bias: "gyro.bias_rad_s",
    bias_sigma: "gyro.bias_sigma_rad_s",
    markov_sigma: "gyro.markov_sigma_rad_s",
    markov_time: "gyro.markov_time_s",
    random_walk: "gyro.random_walk_rad_sqrt_s",
    scale_factor: "gyro.scale_factor",
    misalignment: "gyro.misalignment_rad",
};

const ACCEL_NAMES: Names = Names {
    bias: "accel.bias_m_s2",
    bias_sigma: "accel.bias_sigma_m_s2",
    markov_sigma: "accel.markov_sigma_m_s2",
    markov_time: "accel.markov_time_s",
    random_walk: "accel.velocity_random_walk_m_s_sqrt_s",
    scale_factor: "accel.scale_factor",
    misalignment: "accel.misalignment_rad",
};

/// Correlation times [s] for which the discretisation holds every digit; a longer one is a constant, a shorter one white.
pub(super) const MARKOV_TIME_RANGE_S: (f64, f64) = (1e-9, 1e15);

impl Sensor {
    pub(super) fn source(self) -> Source {
        match self {
            Self::Gyro => Source::Gyro,
            Self::Accelerometer => Source::Accelerometer,
        }
    }
}

impl TriadParameters {
    /// Whether ten standard deviations of all terms stay below 2000 u and 100 u √s: what a step has to expect of
    /// accelerometers.
    pub fn is_tame(&self) -> bool {
        let largest = self.bias.abs() + (self.bias_sigma + self.markov_sigma) * 10.0;
        largest.amax() <= 2000.0 && self.random_walk.amax() <= 100.0
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
        check_ranges(names.scale_factor, self.scale_factor.as_slice(), -1.0, 1.0)?;
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
        Ok(())
    }
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
