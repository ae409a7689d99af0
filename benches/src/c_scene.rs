//! The scene and its flight through the C interface.

use std::ptr::null_mut;

use sins::abi::*;
use sins::truth::FlightSample;

use crate::scene::PERIOD_S;

/// Samples in the type of the C interface.
pub fn c_samples(samples: &[FlightSample]) -> Vec<sins_flight_sample> {
    samples.iter().map(sins_flight_sample::from).collect()
}

/// Options of the C interface with the error model and the stated period.
pub fn c_options() -> sins_options {
    // SAFETY: the struct has only integers and floating-point numbers; zero is the recommended simulator.
    let mut options: sins_options = unsafe { core::mem::zeroed() };
    options.struct_size = size_of::<sins_options>() as u32;
    options.error_model = SINS_ERROR_MODEL_RK4;
    options.sample_period_s = PERIOD_S;
    options
}

/// A simulator, with the errors of simulation 2 if `noisy`.
pub fn simulator(options: &sins_options, noisy: bool) -> *mut sins_sim {
    let mut sim = null_mut();
    // SAFETY: structs of their own size.
    unsafe {
        assert_eq!(sins_create(options, &mut sim), SINS_OK);
        if noisy {
            let mut gyro: sins_gyro_params = core::mem::zeroed();
            gyro.struct_size = size_of::<sins_gyro_params>() as u32;
            let mut accel: sins_accel_params = core::mem::zeroed();
            accel.struct_size = size_of::<sins_accel_params>() as u32;
            assert_eq!(sins_gyro_preset(SINS_GRADE_PAPER_SIMULATION2, &mut gyro), SINS_OK);
            assert_eq!(sins_accel_preset(SINS_GRADE_PAPER_SIMULATION2, &mut accel), SINS_OK);
            assert_eq!(sins_set_gyro(sim, &gyro), SINS_OK);
            assert_eq!(sins_set_accel(sim, &accel), SINS_OK);
        }
    }
    sim
}

/// Flies the samples in one call.
///
/// # Safety
/// `sim` is a valid handle.
pub unsafe fn run(sim: *mut sins_sim, samples: &[sins_flight_sample]) {
    // SAFETY: the length is the number of samples.
    let status = unsafe { sins_run(sim, samples.as_ptr(), samples.len(), 0, null_mut(), 0, null_mut()) };
    assert_eq!(status, SINS_OK);
}

/// Flies the samples with push and step, each in a call of its own, and calls `read` after each step.
///
/// # Safety
/// `sim` is a valid handle at the start of a flight.
pub unsafe fn push_step(sim: *mut sins_sim, samples: &[sins_flight_sample], mut read: impl FnMut()) {
    for (k, sample) in samples.iter().enumerate() {
        // SAFETY: structs of their own size.
        unsafe {
            assert_eq!(sins_push_sample(sim, sample), SINS_OK);
            assert_eq!(sins_step(sim), if k == 0 { SINS_NEED_SAMPLE } else { SINS_OK });
        }
        read();
    }
}

/// Flies the samples as [`push_step`], and reads navigation and both errors after each step, each in a call of its own. Then it
/// calls `and`.
///
/// # Safety
/// As [`push_step`].
pub unsafe fn push_step_read(sim: *mut sins_sim, samples: &[sins_flight_sample], mut and: impl FnMut()) {
    // SAFETY: structs of their own size.
    unsafe {
        let mut navigation: sins_navigation = core::mem::zeroed();
        navigation.struct_size = size_of::<sins_navigation>() as u32;
        let mut errors: sins_errors = core::mem::zeroed();
        errors.struct_size = size_of::<sins_errors>() as u32;
        push_step(sim, samples, || {
            assert_eq!(sins_get_navigation(sim, &mut navigation), SINS_OK);
            assert_eq!(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &mut errors), SINS_OK);
            assert_eq!(sins_get_errors(sim, SINS_ERRORS_MODEL, &mut errors), SINS_OK);
            and();
        });
    }
}
