//! Freeze and replay.

use core::ffi::c_void;

use super::failure::{SINS_OK, sins_status};
use super::memory::put;
use super::simulator::{sins_sim, with_simulator};
use super::text::{bytes_of, put_saved};

/// A buffer of this size holds every snapshot of a simulator that this release saves. For a library newer than this header
/// ask sins_snapshot_size(); for an ensemble ask sins_ensemble_snapshot_size().
pub const SINS_SNAPSHOT_MAX_SIZE: usize = 24576;

/// Reads the size that a snapshot has now. It changes with what is set and with the number of waiting samples. These sizes
/// are without waiting samples. Without sensor errors it is 1.3 to 2.1 KiB, by the options. With every error of gyros,
/// accelerometers and altimeter it is up to 4.5 KiB. With mounting, gravity, temperature and failures too it is up to 5.25
/// KiB. Each waiting sample adds up to 154 bytes, and sins_options.covariance up to 9.2 KiB.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_snapshot_size(sim: *mut sins_sim, size: *mut usize) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        unsafe { put(size, simulator.snapshot_size(), "size") }
    })
}

/// Saves the whole simulator, at any moment: options, parameters, waiting samples, the state of every stage, and the position
/// of each random stream. written (may be NULL) gets the size. The bytes mean the same on every platform and hold no address,
/// so they can be kept in a file or sent to another machine. The same state gives the same bytes. No allocation, no system
/// call.
///
/// Not saved: handles, and the sentence of sins_last_error(). After SINS_ERROR_DIVERGED or SINS_ERROR_SINGULAR the last
/// good solution is saved. After SINS_ERROR_INTERNAL nothing can be saved: load an earlier snapshot into a fresh handle.
///
/// SINS_ERROR_BUFFER_TOO_SMALL: see sins_snapshot_size(); buffer and written are unchanged.
///
/// ```c
/// static unsigned char frozen[SINS_SNAPSHOT_MAX_SIZE];
/// size_t size = 0;
/// sins_snapshot_save(sim, frozen, sizeof frozen, &size);
/// sins_reset(sim);
/// sins_snapshot_load(sim, frozen, size);
/// sins_get_navigation(sim, &navigation);
/// printf("back at %.0f s\n", navigation.time_s);  // back at 3601 s
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_snapshot_save(
    sim: *mut sins_sim,
    buffer: *mut c_void,
    capacity: usize,
    written: *mut usize,
) -> sins_status {
    with_simulator(sim, |simulator| {
        let save = |bytes: &mut [u8]| simulator.save_snapshot(bytes);
        // SAFETY: the host's promise.
        unsafe { put_saved::<SINS_SNAPSHOT_MAX_SIZE>(save, buffer.cast(), capacity, written) }
    })
}

/// Replaces the simulator by the saved one, including its options (see sins_get_options()). So a fresh handle of
/// sins_create(NULL, ...) is enough. The run continues to the same bits as the saved one. size is the size that
/// sins_snapshot_save() wrote. Not for a real-time frame: it allocates.
///
/// SINS_ERROR_SNAPSHOT: the bytes are not a snapshot, or are cut off, altered, or of a newer release; nothing has changed,
/// and sins_last_error() says which it is. Later releases read the snapshots of earlier ones; the run continues to the same
/// bits unless CHANGELOG says that the algorithms changed.
/// SINS_ERROR_OUT_OF_MEMORY: no memory for a second simulator.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_snapshot_load(
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
