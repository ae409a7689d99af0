//! Freeze and replay of ensembles.

use core::ffi::c_void;

use super::ensemble::{sins_ensemble, with_ensemble};
use super::failure::{Failure, SINS_OK, sins_status};
use super::memory::put;
use super::text::{bytes_of, bytes_to_fill};

/// The size that a snapshot has now: some 1.3 to 5.25 KiB a run, as that of a simulator.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_ensemble_snapshot_size(
    ensemble: *mut sins_ensemble,
    size: *mut usize,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        unsafe { put(size, ensemble.snapshot_size(), "size")? };
        Ok(SINS_OK)
    })
}

/// Saves the whole ensemble, at any moment: as sins_snapshot_save(). written (may be NULL) gets the size. The same state gives the
/// same bytes. No allocation, no system call.
///
/// SINS_ERROR_BUFFER_TOO_SMALL: see sins_ensemble_snapshot_size(); buffer and written are as they were.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_ensemble_snapshot_save(
    ensemble: *mut sins_ensemble,
    buffer: *mut c_void,
    capacity: usize,
    written: *mut usize,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        if buffer.is_null() {
            return Err(Failure::null("buffer"));
        }
        let size = ensemble.snapshot_size();
        if size > capacity {
            return Err(Failure::buffer("capacity", capacity, size));
        }
        // SAFETY: the host's promise; not null, and there is room.
        let length = ensemble.save_snapshot(unsafe { bytes_to_fill(buffer.cast(), size) })?;
        if !written.is_null() {
            // SAFETY: the host's promise.
            unsafe { put(written, length, "written")? };
        }
        Ok(SINS_OK)
    })
}

/// Replaces the ensemble by the saved one, with its runs and options. It does not matter what the ensemble was before: one of any
/// simulator with one run is enough. It continues to the same bits as the saved one. size is what sins_ensemble_snapshot_save()
/// wrote. Not for a real-time frame: it allocates.
///
/// SINS_ERROR_SNAPSHOT: the bytes are no snapshot of an ensemble, cut off, altered, or of a newer release; nothing has changed, and
/// sins_last_error(NULL, ...) reports which it is. SINS_ERROR_OUT_OF_MEMORY: no memory for a second ensemble.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_ensemble_snapshot_load(
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
