//! Corrections of the runs of an ensemble.

use super::correction::{sins_compensation, sins_correction};
use super::ensemble::{sins_ensemble, with_ensemble};
use super::failure::{SINS_OK, sins_status};
use super::memory::{Output, read};

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
        output.write(&(&ensemble.compensation(run)?).into());
        Ok(SINS_OK)
    })
}
