//! What a scene plans over time, made ready for a simulator or an ensemble.

use super::{sins_scene, with_sound_scene};
use crate::abi::boundary::tables::ENSEMBLES;
use crate::abi::ensemble::sins_ensemble;
use crate::abi::failure::{CallError, SINS_ERROR_BAD_HANDLE, SINS_OK, sins_status};
use crate::abi::memory::{Output, read};
use crate::abi::sample::sins_flight_sample;
use crate::abi::simulator::{on_simulator, sins_sim};
use crate::scene::FliesScene;

/// Prepares the next interval: call this function before each push, and call sins_step() before you call it again. The
/// sample gets the temperature of the scene, if the scene has one. The call sets and clears the failures of the scene on sim.
/// A failure begins at the first interval that starts at or after from_s, and ends at the first interval that starts at or
/// after until_s. If the scene plans no failure of an output, the call does not touch the failure of that output.
///
/// The call also makes the updates ([[update]]) that are due at the last sample: the first one at or after the planned time. It
/// corrects the solution as sins_correct() does; then the solution has the error of the fix. That error is a normal random number. It
/// depends only on seed and run, on the kind and on the planned time, and no other random number changes. So a simulator goes on from a
/// snapshot with the same updates. An update in a jump of the truth, or at the last sample of the flight, is not made; of
/// several updates of one kind that are due, the last one counts. A height that follows the truth is not corrected.
///
/// flight_start_s is the time stamp of the flight's first sample. No allocation, no system call.
///
/// SINS_ERROR_BAD_HANDLE: scene or sim is not a valid handle.
/// SINS_ERROR_INVALID_ARGUMENT: a sample out of its ranges, or flight_start_s not from -2e10 to 2e10; or, if an update is due, as
/// sins_correct().
/// SINS_ERROR_DIVERGED, SINS_ERROR_SINGULAR: if an update is due, as sins_correct().
/// SINS_ERROR_BAD_STATE: as sins_scene_parse(). After any error sim has not changed.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_prepare(
    scene: *const sins_scene,
    sim: *mut sins_sim,
    flight_start_s: f64,
    sample: *mut sins_flight_sample,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe {
        prepare(scene, flight_start_s, sample, "sim", |make_ready| {
            on_simulator(sim, |simulator| make_ready(simulator))
        })
    }
}

/// Prepares the next interval of all runs of an ensemble, as sins_scene_prepare() does for a simulator. At an update each run has a
/// fix of its own; a run that cannot be corrected diverges. No allocation, no system call.
///
/// SINS_ERROR_BAD_HANDLE: scene or ensemble is not a valid handle. SINS_ERROR_INVALID_ARGUMENT: a sample out of its ranges, or
/// flight_start_s not from -2e10 to 2e10. SINS_ERROR_BAD_STATE: as sins_scene_parse().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_prepare_ensemble(
    scene: *const sins_scene,
    ensemble: *mut sins_ensemble,
    flight_start_s: f64,
    sample: *mut sins_flight_sample,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe {
        prepare(scene, flight_start_s, sample, "ensemble", |make_ready| {
            ENSEMBLES.with(ensemble.addr(), |ensemble| make_ready(ensemble))
        })
    }
}

/// Makes ready what `on_handle` finds behind the handle of the argument `name`, and the sample.
///
/// # Safety
/// As the exported functions.
unsafe fn prepare(
    scene: *const sins_scene,
    flight_start_s: f64,
    sample: *mut sins_flight_sample,
    name: &'static str,
    on_handle: impl FnOnce(&mut dyn FnMut(&mut dyn FliesScene) -> Result<sins_status, CallError>) -> sins_status,
) -> sins_status {
    with_sound_scene(scene, |scene| {
        // SAFETY: the host's promise.
        let mut prepared = unsafe { read(sample.cast_const(), "sample")? }.to_sample()?;
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(sample, "sample")? };
        let mut result = Ok(SINS_OK);
        let status = on_handle(&mut |flown| {
            result = scene.prepare(flown, flight_start_s, &mut prepared).map(|()| SINS_OK);
            Ok(result?)
        });
        if status == SINS_OK {
            output.write(&sins_flight_sample::from(&prepared));
        }
        match result {
            Err(error) => Err(error.into()),
            Ok(_) if status == SINS_ERROR_BAD_HANDLE => Err(CallError::bad_handle(name)),
            Ok(_) => Ok(status),
        }
    })
}
