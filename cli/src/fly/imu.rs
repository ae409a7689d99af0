//! The file of the measured increments: one row for each part on which the INS navigated.

use std::io::Write;

use sins::Simulator;

use crate::rows::number;

/// Columns: end of the part, and output of gyros and accelerometers over the part.
pub const COLUMNS: [&str; 7] = [
    "time_s",
    "angle_increment_x_rad",
    "angle_increment_y_rad",
    "angle_increment_z_rad",
    "velocity_increment_x_m_s",
    "velocity_increment_y_m_s",
    "velocity_increment_z_m_s",
];

/// Writes the parts of the interval flown last.
pub fn write_rows(output: &mut impl Write, simulator: &Simulator) -> std::io::Result<()> {
    let Some(interval) = simulator.imu() else { return Ok(()) };
    let parts = || (0..).map_while(|update| simulator.measured_update(update)).flat_map(|(parts, _)| parts);
    let part_s = interval.interval_s / parts().count() as f64;
    let mut left = parts().count();
    for part in parts() {
        left -= 1;
        write!(output, "{}", number(interval.time_s - left as f64 * part_s))?;
        for value in part.angle.iter().chain(part.velocity.iter()) {
            write!(output, ",{}", number(*value))?;
        }
        writeln!(output)?;
    }
    Ok(())
}
