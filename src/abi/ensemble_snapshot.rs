//! Freeze and replay of ensembles.

use core::ffi::c_void;

use super::ensemble::{sins_ensemble, with_ensemble};
use super::failure::{CallError, SINS_OK, sins_status};
use super::memory::{put, put_if_wanted};
use super::text::{bytes_of, bytes_to_fill};

/// Reads the size that a snapshot has now: about 1.3 to 5.25 KiB for each run, as for a simulator.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_snapshot_size(
    ensemble: *mut sins_ensemble,
    size: *mut usize,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        unsafe { put(size, ensemble.snapshot_size(), "size") }
    })
}

/// Saves the whole ensemble, at any moment, as sins_snapshot_save() does for a simulator. written (may be NULL) gets the
/// size. The same state gives the same bytes. No allocation, no system call.
///
/// SINS_ERROR_BUFFER_TOO_SMALL: see sins_ensemble_snapshot_size(); buffer and written are unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_snapshot_save(
    ensemble: *mut sins_ensemble,
    buffer: *mut c_void,
    capacity: usize,
    written: *mut usize,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        if buffer.is_null() {
            return Err(CallError::null("buffer"));
        }
        let size = ensemble.snapshot_size();
        if size > capacity {
            return Err(CallError::buffer("capacity", capacity, size));
        }
        // SAFETY: the host's promise; not null, and there is room.
        let length = ensemble.save_snapshot(unsafe { bytes_to_fill(buffer.cast(), size) })?;
        // SAFETY: the host's promise.
        unsafe { put_if_wanted(written, length) };
        Ok(SINS_OK)
    })
}

/// Replaces the ensemble by the saved one, including its runs and options. So the handle may be any ensemble, for example of
/// one run. The loaded ensemble continues with the same bits as the saved one. size is the size that
/// sins_ensemble_snapshot_save() wrote. Not for a real-time frame: it allocates.
///
/// SINS_ERROR_SNAPSHOT: the bytes are not a snapshot of an ensemble, or are cut off, altered, or of a newer release; nothing
/// has changed, and sins_last_error(NULL, ...) reports which it is. SINS_ERROR_OUT_OF_MEMORY: no memory for a second
/// ensemble.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_snapshot_load(
    ensemble: *mut sins_ensemble,
    snapshot: *const c_void,
    size: usize,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        let snapshot = unsafe { bytes_of(snapshot.cast(), size, "snapshot")? };
        ensemble.load_snapshot(snapshot)?;
        Ok(SINS_OK)
    })
}
