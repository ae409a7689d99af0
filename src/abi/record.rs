//! `sins_record`: one line of the output of `sins_run`, also as a line of a file.

use core::ffi::c_char;
use core::fmt::{self, Write};

use nalgebra::Vector3;

use super::answer::fill_or_need;
use super::boundary::enter_without_simulator;
use super::covariance::sins_covariance;
use super::errors::sins_record_errors;
use super::failure::{CallError, sins_status};
use super::memory::{Output, interface_struct, read, read_numbers};
use super::simulator::{sins_sim, with_simulator};
use super::solution::sins_record_solution;
use super::text::put_text;
use crate::base::error::{Error, Rule};
use crate::base::records::Number;
use crate::simulator::record::{Record, columns};
use crate::simulator::{Moment, View};

/// Truth, navigation and both errors at one instant.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_record {
    /// sizeof(sins_record); in an array only that of the first element must be set.
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// Time [s].
    pub time_s: f64,
    /// The truth, as sins_get_truth() gives it.
    pub truth: sins_record_solution,
    /// The navigated solution, as sins_get_navigation() gives it.
    pub navigation: sins_record_solution,
    /// Error data 2, as sins_get_errors() gives it with SINS_ERRORS_NAVIGATION.
    pub navigation_errors: sins_record_errors,
    /// Error data 1, as sins_get_errors() gives it with SINS_ERRORS_MODEL; flagged SINS_ERRORS_NOT_COMPUTED while the model
    /// is off.
    pub model_errors: sins_record_errors,
}

interface_struct!(sins_record, "record", 496);

pub(super) struct RecordView;

impl View for RecordView {
    type Struct = sins_record;
    const OF_TRUTH: bool = true;
    const OF_NAVIGATION: bool = true;

    #[inline(always)]
    fn fill(record: &mut sins_record, moment: Moment<'_>) {
        record.reserved = 0;
        record.time_s = moment.time_s();
        record.truth = sins_record_solution::of(&moment.truth());
        record.navigation = sins_record_solution::of(&moment.navigation());
        record.navigation_errors = sins_record_errors::of_navigation(moment);
        record.model_errors = sins_record_errors::of_model(moment);
    }
}

/// Reads truth, navigation and both errors of this moment in one call; before the first step, those at the first sample.
///
/// SINS_NEED_SAMPLE: no sample yet.
/// SINS_ERROR_BAD_STATE: navigating on increments, without a truth.
/// SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_record(sim: *mut sins_sim, record: *mut sins_record) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(record, "record")? };
        fill_or_need::<RecordView>(simulator, &output)
    })
}

/// Size of the longest line [bytes]: 60 numbers have up to 24 letters each; the names of their columns have fewer.
const LONGEST: usize = 1600;

/// Number of the errors of gyros and accelerometers.
const SENSOR_ERRORS: usize = 6;

/// Writes a record as one line of comma-separated values, without the newline. The program sins writes its files of records
/// in this format. If record is NULL, the line has the names of the columns. The decimal numbers are exact: reading them
/// gives the same doubles. sensor_errors is an array of count = 6 numbers: x, y, z of the mean gyro error [rad/s], then x, y,
/// z of the mean accelerometer error [m/s2], since the previous record. NULL with count 0: all are 0. covariance adds columns
/// of standard deviations; NULL: none. buffer, capacity and needed as in sins_last_error(); a line has at most 1600 bytes.
/// No allocation.
///
/// SINS_ERROR_INVALID_ARGUMENT: count is neither 6 nor 0.
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
        // SAFETY: the host's promise.
        let line = unsafe { line(record, sensor_errors, count, covariance)? };
        // SAFETY: the host's promise.
        unsafe { put_text(&line.bytes[..line.length], buffer, capacity, needed) }
    })
}

/// A line without the heap.
struct LineBuffer {
    bytes: [u8; LONGEST],
    length: usize,
}

impl LineBuffer {
    /// Adds a field.
    fn add(&mut self, field: impl fmt::Display) {
        let comma = if self.length == 0 { "" } else { "," };
        // No line is longer than its room.
        let _ = write!(self, "{comma}{field}");
    }
}

impl Write for LineBuffer {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let end = self.length + text.len();
        self.bytes.get_mut(self.length..end).ok_or(fmt::Error)?.copy_from_slice(text.as_bytes());
        self.length = end;
        Ok(())
    }
}

/// # Safety
/// As [`sins_record_line`].
unsafe fn line(
    record: *const sins_record,
    sensor_errors: *const f64,
    count: usize,
    covariance: *const sins_covariance,
) -> Result<LineBuffer, CallError> {
    let mut line = LineBuffer { bytes: [0; LONGEST], length: 0 };
    if record.is_null() {
        columns(!covariance.is_null()).for_each(|column| line.add(column));
        return Ok(line);
    }
    if count != 0 && count != SENSOR_ERRORS {
        return Err(
            Error::invalid("count", count, Rule::Sentence("must be 6, or 0 without sensor_errors")).into()
        );
    }
    // SAFETY: as this function.
    let record = unsafe { read(record, "record")? };
    let mut sensors = [0.0; SENSOR_ERRORS];
    // SAFETY: as this function.
    unsafe { read_numbers(sensor_errors, &mut sensors[..count], "sensor_errors")? };
    let record = Record {
        gyro_error: Vector3::from_column_slice(&sensors[..3]),
        accel_error: Vector3::from_column_slice(&sensors[3..]),
        ..record.into()
    };
    let mut add = |values: &[f64]| values.iter().for_each(|value| line.add(Number(*value)));
    add(&record.values());
    if !covariance.is_null() {
        // SAFETY: as this function.
        let covariance = unsafe { read(covariance, "covariance")? };
        add(&covariance.position_sigma_enu_m);
        add(&covariance.velocity_sigma_enu_m_s);
        add(&covariance.misalignment_sigma_enu_rad);
    }
    Ok(line)
}

impl From<sins_record> for Record {
    fn from(record: sins_record) -> Self {
        Self {
            time_s: record.time_s,
            truth: record.truth.into(),
            navigation: record.navigation.into(),
            navigation_error: record.navigation_errors.into(),
            navigation_flags: record.navigation_errors.flags as u32,
            model_error: record.model_errors.into(),
            model_flags: record.model_errors.flags as u32,
            ..Self::default()
        }
    }
}
