//! Presets of the errors of sensors and of the start.

use super::boundary::enter_without_simulator;
use super::choice::{Choice, choices};
use super::failure::sins_status;
use super::memory::Output;
use super::parameters::Parameters;
use super::settings::{sins_accel_params, sins_gyro_params, sins_initial_errors};
use crate::sensors::Grade;

include!(concat!(env!("OUT_DIR"), "/sins_grade.rs"));

/// Fills params with the gyro errors of a grade, of enum sins_grade. Biases, scale factor errors and misalignments are
/// drawn at turn-on with the standard deviations that the source of the grade states; errors that it does not state are 0.
///
/// SINS_ERROR_INVALID_ARGUMENT: no such grade.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_gyro_preset(grade: i32, params: *mut sins_gyro_params) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(params, "params")? };
        Ok(output.write(&sins_gyro_params::from_parameters(&Grade::of("grade", grade)?.parameters().0)))
    })
}

/// Fills params with the accelerometer errors of a grade, as sins_gyro_preset().
///
/// SINS_ERROR_INVALID_ARGUMENT: no such grade.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_accel_preset(grade: i32, params: *mut sins_accel_params) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(params, "params")? };
        Ok(output.write(&sins_accel_params::from_parameters(&Grade::of("grade", grade)?.parameters().1)))
    })
}

/// Fills errors with the errors of the start of a grade. The position is that of GPS: 8 m horizontally and 13 m vertically, 95 %
/// (Standard Positioning Service Performance Standard, 2020). Strategic and navigation grade level and gyrocompass for 10 minutes
/// (Boeing 737 MAX: 5 to 17 minutes). The other grades level for 30 s, and their heading is that of a magnetic compass, 1 sigma:
/// tactical 1 deg (Caruso, Honeywell), industrial 2 deg, consumer 4 deg (Tomasch and Winer 2018). The paper states no errors of
/// the start: all are 0.
///
/// SINS_ERROR_INVALID_ARGUMENT: no such grade.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_initial_preset(
    grade: i32,
    errors: *mut sins_initial_errors,
) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(errors, "errors")? };
        Ok(output.write(&sins_initial_errors::from_parameters(&Grade::of("grade", grade)?.start())))
    })
}
