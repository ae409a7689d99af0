//! What is read of an ensemble, and corrections of its runs.

use super::answer::write_or_need;
use super::choice::Choice;
use super::correction::{sins_compensation, sins_correction};
use super::ensemble::{sins_ensemble, with_ensemble};
use super::errors::sins_errors;
use super::failure::{CallError, SINS_NEED_SAMPLE, SINS_OK, sins_status};
use super::imu::sins_imu;
use super::memory::{Array, Output, put, put_if_wanted, read};
use super::solution::sins_navigation;
use crate::base::error::{Error, Rule};
use crate::simulator::ErrorSource;

/// Reads the number of the first run, and how many runs there are; either pointer may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_get_runs(
    ensemble: *mut sins_ensemble,
    first_run: *mut u64,
    runs: *mut usize,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        unsafe { put_if_wanted(first_run, ensemble.first_run()) };
        // SAFETY: the host's promise.
        unsafe { put_if_wanted(runs, ensemble.runs()) };
        Ok(SINS_OK)
    })
}

/// Reads the truth, which all runs share, as sins_get_truth() does.
///
/// SINS_NEED_SAMPLE: no sample yet.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_get_truth(
    ensemble: *mut sins_ensemble,
    truth: *mut sins_navigation,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(truth, "truth")? };
        Ok(write_or_need(&output, ensemble.truth().map(|truth| sins_navigation::of(&truth))))
    })
}

/// Reads the navigated solution of a run, as sins_get_navigation() does. run is from first_run to first_run + runs - 1.
///
/// SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such run. SINS_ERROR_DIVERGED: the run has diverged (the
/// sentence of sins_last_error() states the time of its last good solution); or as sins_get_navigation().
/// SINS_ERROR_SINGULAR: as sins_get_navigation().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_get_navigation(
    ensemble: *mut sins_ensemble,
    run: u64,
    navigation: *mut sins_navigation,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(navigation, "navigation")? };
        let solution = ensemble.navigation(run)?;
        Ok(write_or_need(&output, solution.map(|solution| sins_navigation::of(&solution))))
    })
}

/// Reads the errors of the navigated solution of a run, as sins_get_errors() does; source is of enum sins_errors_source.
///
/// SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such run or source. SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL
/// while the error model is off. SINS_ERROR_DIVERGED, SINS_ERROR_SINGULAR: as sins_ensemble_get_navigation().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_get_errors(
    ensemble: *mut sins_ensemble,
    run: u64,
    source: i32,
    errors: *mut sins_errors,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(errors, "errors")? };
        let found = ensemble.errors_and_pole(run, ErrorSource::of("source", source)?)?;
        let found = found.map(|(time_s, errors, near_pole)| sins_errors::new(time_s, &errors, near_pole));
        Ok(write_or_need(&output, found))
    })
}

/// Reads the errors of all runs into an array, as sins_ensemble_get_errors() does for one: element k is run first_run + k. A run that
/// has diverged or cannot start is flagged SINS_ERRORS_NOT_COMPUTED, and its errors are 0. errors[0].struct_size is the size in bytes
/// of each element of errors; that of the other elements may be anything. No allocation, no system call.
///
/// SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such source. SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL while the
/// error model is off. SINS_ERROR_BUFFER_TOO_SMALL: capacity is less than the number of runs. SINS_ERROR_SINGULAR: before the first
/// step, no run can start at the first sample.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_get_all_errors(
    ensemble: *mut sins_ensemble,
    source: i32,
    errors: *mut sins_errors,
    capacity: usize,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        let places = unsafe { Array::new(errors, capacity, "errors")? };
        let source = ErrorSource::of("source", source)?;
        if capacity < ensemble.runs() {
            return Err(CallError::buffer("capacity", capacity, ensemble.runs()));
        }
        let Some(truth) = ensemble.truth() else {
            return Ok(SINS_NEED_SAMPLE);
        };
        for place in 0..ensemble.runs() {
            let found = ensemble.errors_unless_diverged(place, source)?;
            let errors = found
                .map_or(sins_errors::not_computed(truth.time_s), |(time_s, errors, near_pole)| {
                    sins_errors::new(time_s, &errors, near_pole)
                });
            places.write(place, &errors)?;
        }
        Ok(SINS_OK)
    })
}

/// Reads ideal and measured signals of the last interval of a run, as sins_get_imu() does.
///
/// SINS_NEED_SAMPLE: no interval yet. SINS_ERROR_INVALID_ARGUMENT: no such run. SINS_ERROR_DIVERGED: the run has diverged.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_get_imu(
    ensemble: *mut sins_ensemble,
    run: u64,
    imu: *mut sins_imu,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(imu, "imu")? };
        Ok(write_or_need(&output, ensemble.imu(run)?.map(|imu| sins_imu::from(&imu))))
    })
}

/// Reads the run number of diverged run `index`, from 0. The run numbers are in ascending order. sins_statistics.diverged is
/// the number of diverged runs.
///
/// SINS_ERROR_INVALID_ARGUMENT: index is not below the count of diverged runs.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_get_diverged(
    ensemble: *mut sins_ensemble,
    index: usize,
    run: *mut u64,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        if run.is_null() {
            return Err(CallError::null("run"));
        }
        let Some(diverged) = ensemble.diverged().nth(index) else {
            let rule = Rule::Below(ensemble.diverged().count() as f64);
            return Err(Error::invalid("index", index, rule).into());
        };
        // SAFETY: the host's promise.
        unsafe { put(run, diverged, "run") }
    })
}

/// Removes errors of one run, as sins_correct() does. The first compensation of sensors in each group of 16 runs allocates.
///
/// SINS_ERROR_INVALID_ARGUMENT: no such run; or as sins_correct(). SINS_ERROR_DIVERGED: the run has diverged; or as
/// sins_correct(). SINS_ERROR_BAD_STATE, SINS_ERROR_SINGULAR: as sins_correct(). SINS_ERROR_OUT_OF_MEMORY: no memory.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_correct(
    ensemble: *mut sins_ensemble,
    run: u64,
    correction: *const sins_correction,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        ensemble.correct(run, &unsafe { read(correction, "correction")? }.to_correction()?)?;
        Ok(SINS_OK)
    })
}

/// Reads the compensation in force of one run, as sins_get_compensation() does.
///
/// SINS_ERROR_INVALID_ARGUMENT: no such run. SINS_ERROR_DIVERGED: the run has diverged.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_get_compensation(
    ensemble: *mut sins_ensemble,
    run: u64,
    compensation: *mut sins_compensation,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(compensation, "compensation")? };
        Ok(output.write(&(&ensemble.compensation(run)?).into()))
    })
}
