//! The file of the measured increments.

use std::io::Write;

use sins::ImuInterval;

use crate::rows::number;

/// Columns: end of the interval, and output of gyros and accelerometers over the interval.
pub const COLUMNS: [&str; 7] = [
    "time_s",
    "angle_increment_x_rad",
    "angle_increment_y_rad",
    "angle_increment_z_rad",
    "velocity_increment_x_m_s",
    "velocity_increment_y_m_s",
    "velocity_increment_z_m_s",
];

pub fn write_row(output: &mut impl Write, imu: &ImuInterval) -> std::io::Result<()> {
    write!(output, "{}", number(imu.time_s))?;
    for value in imu.measured.angle.iter().chain(imu.measured.velocity.iter()) {
        write!(output, ",{}", number(*value))?;
    }
    writeln!(output)
}
