//! `sins_ensemble`: the life of an ensemble, and its steps.

use super::boundary::{enter, enter_without_simulator};
use super::failure::{Failure, SINS_GAP, SINS_OK, sins_status};
use super::handle::{hand_out, with_object};
use super::memory::{Array, read};
use super::sample::sins_flight_sample;
use super::sensor_failure::{output, sins_failure};
use super::simulator::{look_at, pushed, sins_sim, stepped};
use super::tables::ENSEMBLES;
use crate::ensemble::Ensemble;

/// An ensemble: many runs of one simulator over the same samples. A handle is a checked key, as that of sins_sim, and never taken for
/// one. The failures of its functions are read by sins_last_error(NULL, ...) on the same thread.
#[repr(C)]
pub struct sins_ensemble {
    _opaque: [u8; 0],
}

/// Runs `body` on the ensemble of a handle, as the inside of an exported function.
pub(super) fn with_ensemble(
    ensemble: *const sins_ensemble,
    body: impl FnOnce(&mut Ensemble) -> Result<sins_status, Failure>,
) -> sins_status {
    with_object(&ENSEMBLES, ensemble, body)
}

/// Creates an ensemble of the runs first_run to first_run + runs - 1. configured is a simulator with its options, sensors, initial
/// errors, mounting, gravity and failures, which has taken no sample. The call copies it, and does not change it. The run with number
/// k gives the same bits as a simulator with the same settings and sins_options.run = k. sins_options.run, truth_summary and
/// covariance of configured have no effect.
///
/// What a run does never depends on the other runs: ensembles over disjoint runs may be flown by different threads, processes
/// and machines, and their statistics merged. The library starts no thread.
///
/// What all runs share is computed once a step, and runs go side by side: a run takes a fraction of the time of a simulator, and
/// 1.7 KB of memory. docs/ensembles.md has the times. Not for a real-time frame: it allocates.
///
/// After an error *ensemble is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason.
///
/// SINS_ERROR_BAD_STATE: configured has taken a sample since it was created or reset, or navigates on increments.
/// SINS_ERROR_INVALID_ARGUMENT: runs not from 1 to 4294967295, or first_run + runs - 1 above 2^64 - 1.
/// SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 ensembles exist.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_ensemble_create(
    configured: *const sins_sim,
    first_run: u64,
    runs: usize,
    ensemble: *mut *mut sins_ensemble,
) -> sins_status {
    enter_without_simulator(|| {
        if ensemble.is_null() {
            return Err(Failure::null("ensemble"));
        }
        let made = look_at(configured, "configured", |template| Ensemble::new(template, first_run, runs))??;
        // SAFETY: the host's promise; not null.
        unsafe { hand_out(&ENSEMBLES, made, ensemble, "ensemble")? };
        Ok(SINS_OK)
    })
}

/// Destroys an ensemble. A call on it in another thread is waited for; the handle is never used again.
///
/// SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_ensemble_destroy(ensemble: *mut sins_ensemble) -> sins_status {
    enter(|| ENSEMBLES.remove(ensemble.addr()))
}

/// Takes one flight-control sample into the queue (16 samples) of all runs.
///
/// SINS_GAP and the errors: as sins_push_sample().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_ensemble_push_sample(
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
/// A run that cannot make the step, for which sins_step() would answer SINS_ERROR_DIVERGED or SINS_ERROR_SINGULAR, has diverged:
/// it keeps its solution before the step, takes no further part, and is reported by sins_ensemble_get_diverged() and counted by
/// sins_ensemble_get_statistics(). The others go on, and so does the truth, even if no run is left. sins_ensemble_reposition() and
/// sins_ensemble_reset() start all runs again.
///
/// SINS_NEED_SAMPLE: no complete interval waits. SINS_ERROR_SINGULAR: the truth is within reach of a pole, in geographic axes or
/// where the alignment is a gyrocompass; the step is not made.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_ensemble_step(ensemble: *mut sins_ensemble) -> sins_status {
    with_ensemble(ensemble, |ensemble| Ok(stepped(ensemble.step()?)))
}

/// Pushes and steps count samples, faster than single calls where there are thousands of runs. Any split of a flight into calls gives the same bits as pushing and stepping sample by sample.
/// samples[0].struct_size tells how far apart the samples are; the others' may be 0.
///
/// SINS_GAP: all samples were flown, and at least one of them ended a gap. Any error of sins_ensemble_push_sample() or
/// sins_ensemble_step() stops the run at the sample that it concerns, which sins_last_error() names: the samples before it have been
/// flown, this and the rest not. A sample that could be pushed but not flown waits in the queue.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_ensemble_run(
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

fn run(ensemble: &mut Ensemble, samples: &Array<sins_flight_sample>) -> Result<sins_status, Failure> {
    // What waited in the queue before the call goes first.
    while stepped(ensemble.step()?) == SINS_OK {}
    let sample = |index| samples.read(index).and_then(sins_flight_sample::to_sample);
    let of_sample = |(index, failure): (usize, Failure)| failure.of_sample(index);
    let has_gap = ensemble.run(samples.count(), sample).map_err(of_sample)?;
    Ok(if has_gap { SINS_GAP } else { SINS_OK })
}

/// Truth jumps to the sample, and every run starts again there with its initial errors, the diverged ones too: as
/// sins_reposition().
///
/// SINS_ERROR_INVALID_ARGUMENT: as sins_push_sample().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_ensemble_reposition(
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

/// Back to before the first sample: same parameters, no failures, the same draws again from their start, no run diverged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_ensemble_reset(ensemble: *mut sins_ensemble) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        ensemble.reset();
        Ok(SINS_OK)
    })
}

/// Lets one output of every run fail, or clears its failure: as sins_set_failure(). No allocation, no system call.
///
/// SINS_ERROR_INVALID_ARGUMENT: as sins_set_failure().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_ensemble_set_failure(
    ensemble: *mut sins_ensemble,
    sensor: i32,
    axis: i32,
    failure: *const sins_failure,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        let failure = unsafe { read(failure, "failure")? };
        ensemble.set_failure(output(sensor, axis)?, failure.to_failure()?)?;
        Ok(SINS_OK)
    })
}
