//! Files of records: truth, navigation, both error data and the errors of the sensors, with one line for each instant.

use core::fmt;

/// Columns of a file of records.
pub const COLUMNS: [&str; 51] = [
    "time_s",
    "truth_latitude_rad",
    "truth_longitude_rad",
    "truth_height_m",
    "truth_velocity_east_m_s",
    "truth_velocity_north_m_s",
    "truth_velocity_up_m_s",
    "truth_roll_rad",
    "truth_pitch_rad",
    "truth_heading_rad",
    "navigation_latitude_rad",
    "navigation_longitude_rad",
    "navigation_height_m",
    "navigation_velocity_east_m_s",
    "navigation_velocity_north_m_s",
    "navigation_velocity_up_m_s",
    "navigation_roll_rad",
    "navigation_pitch_rad",
    "navigation_heading_rad",
    "navigation_error_position_east_m",
    "navigation_error_position_north_m",
    "navigation_error_position_up_m",
    "navigation_error_velocity_east_m_s",
    "navigation_error_velocity_north_m_s",
    "navigation_error_velocity_up_m_s",
    "navigation_error_misalignment_east_rad",
    "navigation_error_misalignment_north_rad",
    "navigation_error_misalignment_up_rad",
    "navigation_error_roll_rad",
    "navigation_error_pitch_rad",
    "navigation_error_heading_rad",
    "navigation_error_flags",
    "model_error_position_east_m",
    "model_error_position_north_m",
    "model_error_position_up_m",
    "model_error_velocity_east_m_s",
    "model_error_velocity_north_m_s",
    "model_error_velocity_up_m_s",
    "model_error_misalignment_east_rad",
    "model_error_misalignment_north_rad",
    "model_error_misalignment_up_rad",
    "model_error_roll_rad",
    "model_error_pitch_rad",
    "model_error_heading_rad",
    "model_error_flags",
    "gyro_error_x_rad_s",
    "gyro_error_y_rad_s",
    "gyro_error_z_rad_s",
    "accel_error_x_m_s2",
    "accel_error_y_m_s2",
    "accel_error_z_m_s2",
];

/// Columns after `COLUMNS` if the covariance is on: standard deviations of the errors.
pub const SIGMA_COLUMNS: [&str; 9] = [
    "sigma_position_east_m",
    "sigma_position_north_m",
    "sigma_position_up_m",
    "sigma_velocity_east_m_s",
    "sigma_velocity_north_m_s",
    "sigma_velocity_up_m_s",
    "sigma_misalignment_east_rad",
    "sigma_misalignment_north_rad",
    "sigma_misalignment_up_rad",
];

/// The first line of a file, without the line end.
pub fn head(has_sigmas: bool) -> String {
    let sigmas = if has_sigmas { &SIGMA_COLUMNS[..] } else { &[] };
    [&COLUMNS, sigmas].concat().join(",")
}

/// A line of a file, without the line end.
pub fn line(values: impl IntoIterator<Item = f64>) -> String {
    values.into_iter().map(number).collect::<Vec<_>>().join(",")
}

/// A number as the shortest text that gives the same bits when it is read.
pub struct Number(pub f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = *self;
        let size = value.abs();
        if size == 0.0 || (1e-5..1e15).contains(&size) {
            write!(f, "{value}")
        } else {
            write!(f, "{value:e}")
        }
    }
}

/// The text of a [`Number`].
pub fn number(value: f64) -> String {
    Number(value).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_read_back() {
        for (value, text) in
            [(0.0, "0"), (-0.1, "-0.1"), (3.0, "3"), (1.25e-300, "1.25e-300"), (1e22, "1e22")]
        {
            assert_eq!(number(value), text);
            assert_eq!(text.parse::<f64>().unwrap().to_bits(), value.to_bits());
        }
    }
}
