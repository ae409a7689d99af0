//! Presets of sensor errors.

use super::boundary::enter_without_simulator;
use super::failure::{Failure, SINS_OK, sins_status};
use super::memory::Output;
use super::options::one_of;
use super::sensors::{sins_accel_params, sins_gyro_params};
use crate::sensors::paper_simulation2;

/// The paper's simulation 2: gyro bias 0.01 deg/h and angle random walk 0.005 deg/sqrt(h), accelerometer bias 1e-5 g and
/// white noise 5e-6 g, read as a density of 5e-6 g/sqrt(Hz) (1 Hz of bandwidth; the paper states none).
pub const SINS_GRADE_PAPER_SIMULATION2: i32 = 6;

fn check_grade(grade: i32) -> Result<(), Failure> {
    let rule = "must be SINS_GRADE_PAPER_SIMULATION2, 6: the other grades are not in this release";
    one_of("grade", grade, &[(SINS_GRADE_PAPER_SIMULATION2, ())], rule)
}

/// Fills params with the gyro errors of a grade, SINS_GRADE_...
///
/// SINS_ERROR_INVALID_ARGUMENT: no such grade.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_gyro_preset(grade: i32, params: *mut sins_gyro_params) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(params, "params")? };
        check_grade(grade)?;
        output.write(&sins_gyro_params::from_parameters(&paper_simulation2().0));
        Ok(SINS_OK)
    })
}

/// Fills params with the accelerometer errors of a grade, SINS_GRADE_...
///
/// SINS_ERROR_INVALID_ARGUMENT: no such grade.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_accel_preset(grade: i32, params: *mut sins_accel_params) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(params, "params")? };
        check_grade(grade)?;
        output.write(&sins_accel_params::from_parameters(&paper_simulation2().1));
        Ok(SINS_OK)
    })
}
