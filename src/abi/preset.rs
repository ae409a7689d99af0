//! Presets of the errors of sensors and of the start.

use super::boundary::enter_without_simulator;
use super::choice::one_of;
use super::failure::{Failure, SINS_OK, sins_status};
use super::initial::sins_initial_errors;
use super::memory::Output;
use super::parameters::Parameters;
use super::sensor_params::{sins_accel_params, sins_gyro_params};
use crate::sensors::Grade;

/// Grades of sensors.
pub type sins_grade = i32;

/// Strategic: gyro bias 0.001 deg/h and accelerometer bias 1e-6 g, each 1 sigma (El-Sheimy and Youssef 2020, table 1, upper
/// ends of the grade), angle random walk 0.0002 deg/sqrt(h), scale factor 20 ppm (Airbus Astrix 200). The table states 30 to 100 m/h
/// for this grade, which holds in straight flight. In turns the scale factor dominates. From a perfect start, the CEP after an hour is
/// 190 m on the built-in racetrack, and 35 m without the scale factor error. On the built-in patrol it is 1.6 km and 38 m.
pub const SINS_GRADE_STRATEGIC: sins_grade = 1;
/// Navigation: Honeywell HG9900, brochure N61-1638. It states no accelerometer noise, so the preset has none: set your own.
pub const SINS_GRADE_NAVIGATION: sins_grade = 2;
/// Tactical: Honeywell HG1700, brochure N61-1619. No scale factor or misalignment is stated.
pub const SINS_GRADE_TACTICAL: sins_grade = 3;
/// Industrial: Analog Devices ADIS16475-1, page 1 of its data sheet, rev. D. It states no accelerometer noise, so the preset
/// has none: set your own. The range of the sensors is 125 deg/s and 8 g; the angle between two axes differs from 90 deg by
/// 0.1 deg, 1 sigma.
pub const SINS_GRADE_INDUSTRIAL: sins_grade = 4;
/// Consumer: InvenSense MPU-6050, uncalibrated, product specification rev. 3.4. Its tolerances are taken as 3 sigma.
pub const SINS_GRADE_CONSUMER: sins_grade = 5;
/// The paper's simulation 2: constant gyro bias 0.01 deg/h and angle random walk 0.005 deg/sqrt(h), constant accelerometer
/// bias 1e-5 g and white noise 5e-6 g, taken as a density of 5e-6 g/sqrt(Hz) (for a bandwidth of 1 Hz, because the paper
/// states none).
pub const SINS_GRADE_PAPER_SIMULATION2: sins_grade = 6;

fn grade_of(grade: i32) -> Result<Grade, Failure> {
    const GRADES: [(i32, Grade); 6] = [
        (SINS_GRADE_STRATEGIC, Grade::Strategic),
        (SINS_GRADE_NAVIGATION, Grade::Navigation),
        (SINS_GRADE_TACTICAL, Grade::Tactical),
        (SINS_GRADE_INDUSTRIAL, Grade::Industrial),
        (SINS_GRADE_CONSUMER, Grade::Consumer),
        (SINS_GRADE_PAPER_SIMULATION2, Grade::PaperSimulation2),
    ];
    one_of("grade", grade, &GRADES, "sins_grade")
}

/// Fills params with the gyro errors of a grade, of enum sins_grade. Biases, scale factor errors and misalignments are
/// drawn at turn-on with the standard deviations that the source of the grade states; errors that it does not state are 0.
///
/// SINS_ERROR_INVALID_ARGUMENT: no such grade.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_gyro_preset(grade: i32, params: *mut sins_gyro_params) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(params, "params")? };
        output.write(&sins_gyro_params::from_parameters(&grade_of(grade)?.parameters().0));
        Ok(SINS_OK)
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
        output.write(&sins_accel_params::from_parameters(&grade_of(grade)?.parameters().1));
        Ok(SINS_OK)
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
        output.write(&sins_initial_errors::from_parameters(&grade_of(grade)?.start()));
        Ok(SINS_OK)
    })
}
