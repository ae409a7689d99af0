//! The file of the measured increments: those on which the INS navigates.

use std::io::Write;

use sins::Simulator;

use crate::rows::number;

/// Columns: end of the part; length of its update; its place in the update, from 1; parts of the update; output of gyros and
/// accelerometers over the part.
pub const COLUMNS: [&str; 10] = [
    "time_s",
    "update_s",
    "part",
    "parts",
    "angle_increment_x_rad",
    "angle_increment_y_rad",
    "angle_increment_z_rad",
    "velocity_increment_x_m_s",
    "velocity_increment_y_m_s",
    "velocity_increment_z_m_s",
];

/// Writes the parts of the last interval, which ends at `time_s`.
pub fn write_rows(output: &mut impl Write, simulator: &Simulator, time_s: f64) -> std::io::Result<()> {
    let updates = || (0..).map_while(|update| simulator.measured_update(update));
    let mut left: usize = updates().map(|(parts, _)| parts.len()).sum();
    for (parts, update_s) in updates() {
        for (place, part) in parts.iter().enumerate() {
            left -= 1;
            let end_s = time_s - left as f64 * (update_s / parts.len() as f64);
            write!(output, "{},{},{},{}", number(end_s), number(update_s), place + 1, parts.len())?;
            for value in part.angle.iter().chain(part.velocity.iter()) {
                write!(output, ",{}", number(*value))?;
            }
            writeln!(output)?;
        }
    }
    Ok(())
}
