//! `sins_record` as a line of a file.

use core::ffi::c_char;

use super::boundary::enter_without_simulator;
use super::covariance::sins_covariance;
use super::errors::sins_record_errors;
use super::failure::{Failure, sins_status};
use super::memory::{numbers_of, read};
use super::record::sins_record;
use super::solution::sins_record_solution;
use super::text::put_text;
use crate::error::{Error, Rule};
use crate::memory::probe;
use crate::records;

/// Room for the text of a line [bytes].
const ROOM: usize = 1 << 14;

/// Number of the errors of gyros and accelerometers.
const SENSOR_ERRORS: usize = 6;

/// Writes a record as one line of comma-separated values, without the newline. The program sins writes its files of records
/// in this format. If record is NULL, the line has the names of the columns. The decimal numbers are exact: reading them
/// gives the same doubles. sensor_errors is an array of count = 6 numbers: x, y, z of the mean gyro error [rad/s], then x, y,
/// z of the mean accelerometer error [m/s2], since the previous record. NULL with count 0: all are 0. covariance adds columns
/// of standard deviations; NULL: none. buffer, capacity and needed as in sins_last_error(); a line has at most 1600 bytes.
/// Not for a real-time frame: it allocates.
///
/// SINS_ERROR_INVALID_ARGUMENT: count is neither 6 nor 0.
/// SINS_ERROR_OUT_OF_MEMORY: no memory for the text.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_record_line(
    record: *const sins_record,
    sensor_errors: *const f64,
    count: usize,
    covariance: *const sins_covariance,
    buffer: *mut c_char,
    capacity: usize,
    needed: *mut usize,
) -> sins_status {
    enter_without_simulator(|| {
        probe(ROOM)?;
        // SAFETY: the host's promise.
        let text = unsafe { line(record, sensor_errors, count, covariance)? };
        // SAFETY: the host's promise.
        unsafe { put_text(text.as_bytes(), buffer, capacity, needed) }
    })
}

/// # Safety
/// As [`sins_record_line`].
unsafe fn line(
    record: *const sins_record,
    sensor_errors: *const f64,
    count: usize,
    covariance: *const sins_covariance,
) -> Result<String, Failure> {
    if record.is_null() {
        return Ok(records::head(!covariance.is_null()));
    }
    if count != 0 && count != SENSOR_ERRORS {
        return Err(
            Error::invalid("count", count, Rule::Sentence("must be 6, or 0 without sensor_errors")).into()
        );
    }
    // SAFETY: as this function.
    let (record, sensors) =
        unsafe { (read(record, "record")?, numbers_of(sensor_errors, count, "sensor_errors")?) };
    let mut values = vec![record.time_s];
    [&record.truth, &record.navigation].into_iter().for_each(|solution| add_solution(&mut values, solution));
    [&record.navigation_errors, &record.model_errors]
        .into_iter()
        .for_each(|errors| add_errors(&mut values, errors));
    values.extend(if count == 0 { [0.0; SENSOR_ERRORS].to_vec() } else { sensors });
    if !covariance.is_null() {
        // SAFETY: as this function.
        let covariance = unsafe { read(covariance, "covariance")? };
        values.extend(covariance.position_sigma_enu_m);
        values.extend(covariance.velocity_sigma_enu_m_s);
        values.extend(covariance.misalignment_sigma_enu_rad);
    }
    Ok(records::line(values))
}

fn add_solution(values: &mut Vec<f64>, solution: &sins_record_solution) {
    values.extend([solution.latitude_rad, solution.longitude_rad, solution.height_m]);
    values.extend(solution.velocity_enu_m_s);
    values.extend([solution.roll_rad, solution.pitch_rad, solution.heading_rad]);
}

fn add_errors(values: &mut Vec<f64>, errors: &sins_record_errors) {
    values.extend(errors.position_enu_m);
    values.extend(errors.velocity_enu_m_s);
    values.extend(errors.misalignment_enu_rad);
    values.extend([errors.roll_rad, errors.pitch_rad, errors.heading_rad, f64::from(errors.flags)]);
}
