//! Freeze and replay.

use core::ffi::c_void;

use super::failure::{Failure, SINS_OK, sins_status};
use super::memory::{bytes_of, put, put_bytes};
use super::simulator::{sins_sim, with_simulator};

/// A buffer of this size holds every snapshot that this release saves. For a library newer than this header ask
/// sins_snapshot_size().
pub const SINS_SNAPSHOT_MAX_SIZE: usize = 20480;

/// The size that a snapshot has now, while each sample is flown as it comes: 1.3 to 2.1 KiB without sensor errors, up to 4.5 KiB
/// with every error of gyros, accelerometers and altimeter, up to 5.25 KiB with mounting, gravity, temperature and failures
/// besides; up to 154 bytes more for each sample that waits. It changes with what is set and with the samples that wait.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_snapshot_size(sim: *mut sins_sim, size: *mut usize) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        unsafe { put(size, simulator.snapshot_size(), "size")? };
        Ok(SINS_OK)
    })
}

/// Saves the whole simulator, at any moment: options, parameters, samples that wait, the state of every block, each random
/// stream where it is. written (may be NULL) gets the size. The bytes mean the same on every platform and hold no address:
/// keep them in a file, send them to another machine. The same state gives the same bytes. No allocation, no system call.
///
/// Not saved: handles, and the sentence of sins_last_error(). After SINS_ERROR_DIVERGED or SINS_ERROR_SINGULAR it is the last
/// good solution that is saved, after SINS_ERROR_INTERNAL nothing: load an earlier snapshot into a fresh handle.
///
/// SINS_ERROR_BUFFER_TOO_SMALL: see sins_snapshot_size(); buffer and written are as they were.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_snapshot_save(
    sim: *mut sins_sim,
    buffer: *mut c_void,
    capacity: usize,
    written: *mut usize,
) -> sins_status {
    with_simulator(sim, |simulator| {
        if buffer.is_null() {
            return Err(Failure::null("buffer"));
        }
        let mut bytes = [0; SINS_SNAPSHOT_MAX_SIZE];
        let length = simulator.save_snapshot(&mut bytes)?;
        // SAFETY: the host's promise.
        unsafe { put_bytes(&bytes[..length], buffer.cast(), capacity)? };
        if !written.is_null() {
            // SAFETY: the host's promise.
            unsafe { put(written, length, "written")? };
        }
        Ok(SINS_OK)
    })
}

/// Makes the simulator the one that was saved, whatever it was before: its options too, as sins_get_options() tells, so that a
/// fresh handle of sins_create(NULL, ...) will do. From there the run goes on to the same bits as the saved one did. size is
/// what sins_snapshot_save() wrote. Not for a real-time frame: it allocates.
///
/// SINS_ERROR_SNAPSHOT: the bytes are no snapshot, cut off, altered, or of a newer release; nothing has changed, and
/// sins_last_error() tells which it is. Later releases read the snapshots of earlier ones; the run goes on to the same bits
/// where CHANGELOG does not say that the algorithms changed. SINS_ERROR_OUT_OF_MEMORY: no memory for a second simulator.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_snapshot_load(
    sim: *mut sins_sim,
    snapshot: *const c_void,
    size: usize,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let snapshot = unsafe { bytes_of(snapshot.cast(), size, "snapshot")? };
        simulator.load_snapshot(snapshot)?;
        Ok(SINS_OK)
    })
}
