//! `sins_ensemble`: the life of an ensemble, and its steps.

use super::boundary::handle::{hand_out, with_object};
use super::boundary::tables::ENSEMBLES;
use super::boundary::{enter, enter_without_simulator};
use super::failure::{CallError, SINS_GAP, SINS_OK, sins_status};
use super::memory::{Array, read};
use super::sample::sins_flight_sample;
use super::sensor_failure::{ARGUMENTS, output, sins_failure};
use super::simulator::{look_at, pushed, sins_sim, stepped};
use crate::ensemble::Ensemble;
use crate::simulator::Simulator;

/// An ensemble: many runs of one simulator over the same samples. A handle is a checked key, like that of a sins_sim, and is
/// never confused with one. sins_last_error(NULL, ...) on the same thread gives the failures of its functions.
#[repr(C)]
pub struct sins_ensemble {
    _opaque: [u8; 0],
}

/// Runs `body` on the ensemble of a handle, as the inside of an exported function.
pub(super) fn with_ensemble(
    ensemble: *const sins_ensemble,
    body: impl FnOnce(&mut Ensemble) -> Result<sins_status, CallError>,
) -> sins_status {
    with_object(&ENSEMBLES, ensemble, body)
}

/// Creates an ensemble of the runs first_run to first_run + runs - 1. configured is a simulator on which options, sensor
/// errors, initial errors, mounting, gravity disturbance and failures are set, and to which no sample was pushed. The call
/// copies it, and does not change it. Run k of the ensemble gives the same bits as a simulator with the same settings and
/// sins_options.run = k. Three options of configured have no effect: run, truth_summary and covariance.
///
/// No run depends on another run. So different threads, processes and machines may fly ensembles of different runs, and their
/// statistics can be merged. The library starts no thread.
///
/// What all runs share is computed once a step, and many runs are flown side by side: each takes a fraction of the time of a
/// simulator, and 1.7 to 2.6 KB of memory. A run of a small ensemble takes at most 1.1 times as long as a simulator.
/// docs/ensembles.md has the times. Not for a real-time frame: it allocates.
///
/// After an error *ensemble is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason.
///
/// SINS_ERROR_BAD_STATE: configured has taken a sample since it was created or reset, or navigates on increments.
/// SINS_ERROR_INVALID_ARGUMENT: runs not from 1 to 4294967295, or first_run + runs - 1 above 2^64 - 1.
/// SINS_ERROR_OUT_OF_MEMORY: no memory for all runs, which the call checks before it allocates; or 4096 ensembles exist.
///
/// ```c
/// sins_sim *drawn = NULL;
/// sins_ensemble *ensemble = NULL;
/// static sins_statistics statistics;
/// sins_figures figures;
/// SINS_INIT(statistics);
/// SINS_INIT(figures);
/// SINS_INIT(sample);
/// gyro.bias_sigma_rad_s[0] = gyro.bias_sigma_rad_s[1] = 0.01 * SINS_DEG_PER_HOUR;
/// sins_create(NULL, &drawn);
/// sins_set_gyro(drawn, &gyro);
/// sins_ensemble_create(drawn, 0, 100, &ensemble);
/// for (sample.time_s = 0.0; sample.time_s <= 60.0; sample.time_s += 1.0) {
///     sins_ensemble_push_sample(ensemble, &sample);
///     sins_ensemble_step(ensemble);
/// }
/// sins_ensemble_get_statistics(ensemble, SINS_ERRORS_NAVIGATION, &statistics);
/// sins_statistics_figures(&statistics, &figures);
/// printf("%d runs\n", (int)statistics.runs);  // 100 runs
/// sins_ensemble_destroy(ensemble);
/// sins_destroy(drawn);
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_create(
    configured: *const sins_sim,
    first_run: u64,
    runs: usize,
    ensemble: *mut *mut sins_ensemble,
) -> sins_status {
    enter_without_simulator(|| {
        let make = |template: &Simulator| Ensemble::new(template, first_run, runs);
        // SAFETY: the host's promise.
        unsafe {
            hand_out(&ENSEMBLES, ensemble, "ensemble", || Ok(look_at(configured, "configured", make)??))
        }
    })
}

/// Waits until the calls of other threads on this handle have returned, and destroys the ensemble. The handle is never used
/// again.
///
/// SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_destroy(ensemble: *mut sins_ensemble) -> sins_status {
    enter(|| ENSEMBLES.remove(ensemble.addr()))
}

/// Puts one flight sample into the queue (16 samples) of all runs.
///
/// SINS_GAP and the errors: as sins_push_sample().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_push_sample(
    ensemble: *mut sins_ensemble,
    sample: *const sins_flight_sample,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        let sample = unsafe { read(sample, "sample")? };
        Ok(pushed(ensemble.push_sample(&sample.to_sample()?)?))
    })
}

/// Flies one sample interval with all runs that have not diverged. No allocation, no system call.
///
/// A run has diverged if its solution leaves its limits (SINS_ERROR_DIVERGED of sins_step()), or comes too close to a pole in
/// geographic axes (SINS_ERROR_SINGULAR). A diverged run is not flown any further, and its reads return SINS_ERROR_DIVERGED.
/// sins_ensemble_get_diverged() reports it, and sins_ensemble_get_statistics() counts it. The other runs and the truth
/// continue, even if all runs have diverged. sins_ensemble_reposition() and sins_ensemble_reset() start all runs again.
///
/// SINS_NEED_SAMPLE: no complete interval is waiting. SINS_ERROR_SINGULAR: the truth is too close to a pole, in geographic
/// axes or for an alignment by gyrocompassing; the step is made for no run.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_step(ensemble: *mut sins_ensemble) -> sins_status {
    with_ensemble(ensemble, |ensemble| Ok(stepped(ensemble.step()?)))
}

/// Pushes and steps an array of count samples. With thousands of runs this is faster than single calls. Any split of a flight
/// into calls gives the same bits as pushing and stepping sample by sample. samples[0].struct_size is the size in bytes of
/// each element of samples; struct_size of the other samples may be 0.
///
/// SINS_GAP: all samples were flown, and at least one of them ended a gap. An error of sins_ensemble_push_sample() or
/// sins_ensemble_step() ends the call at the sample that caused the error; sins_last_error() names this sample. The samples
/// before it were flown, this sample and the rest were not. A sample that could be pushed but not flown waits in the queue.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_run(
    ensemble: *mut sins_ensemble,
    samples: *const sins_flight_sample,
    count: usize,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise; samples are only read.
        let samples = unsafe { Array::new(samples.cast_mut(), count, "samples")? };
        run(ensemble, &samples)
    })
}

fn run(ensemble: &mut Ensemble, samples: &Array<sins_flight_sample>) -> Result<sins_status, CallError> {
    // What waited in the queue before the call goes first.
    while stepped(ensemble.step()?) == SINS_OK {}
    let sample = |index| samples.read(index).and_then(sins_flight_sample::to_sample);
    let of_sample = |(index, failure): (usize, CallError)| failure.of_sample(index);
    let has_gap = ensemble.run(samples.count(), sample).map_err(of_sample)?;
    Ok(if has_gap { SINS_GAP } else { SINS_OK })
}

/// Restarts all runs, as sins_reposition() does: the truth jumps to the sample, and every run, diverged or not, starts again
/// there with its initial errors.
///
/// SINS_ERROR_INVALID_ARGUMENT: as sins_push_sample().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_reposition(
    ensemble: *mut sins_ensemble,
    sample: *const sins_flight_sample,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        let sample = unsafe { read(sample, "sample")? };
        ensemble.reposition(&sample.to_sample()?)?;
        Ok(SINS_OK)
    })
}

/// Returns to the state before the first sample, as sins_reset() does: the same parameters, no failures, no diverged run, and
/// the random streams at their start.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_reset(ensemble: *mut sins_ensemble) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        ensemble.reset();
        Ok(SINS_OK)
    })
}

/// Sets or clears a failure of one output in every run, as sins_set_failure() does. No allocation, no system call.
///
/// SINS_ERROR_INVALID_ARGUMENT: as sins_set_failure().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_set_failure(
    ensemble: *mut sins_ensemble,
    sensor: i32,
    axis: i32,
    failure: *const sins_failure,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        let failure = unsafe { read(failure, "failure")? };
        ensemble.set_failure(output(ARGUMENTS, sensor, axis)?, failure.to_failure()?)?;
        Ok(SINS_OK)
    })
}
