//! Snapshots of a scene in flight.

use core::ffi::c_void;

use super::play::{sins_play, with_play};
use crate::abi::failure::{SINS_OK, sins_status};
use crate::abi::text::{bytes_of, put_saved};

/// A buffer of this size holds every snapshot of a scene in flight that this release saves.
pub const SINS_PLAY_SNAPSHOT_MAX_SIZE: usize = 27648;

/// Saves the whole: the simulator, the unit, and the place in the plan. written (may be NULL) gets the size. The same state gives the same
/// bytes, on every platform. No allocation, no system call.
///
/// SINS_ERROR_BUFFER_TOO_SMALL: see SINS_PLAY_SNAPSHOT_MAX_SIZE; buffer and written are unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_play_snapshot_save(
    play: *mut sins_play,
    buffer: *mut c_void,
    capacity: usize,
    written: *mut usize,
) -> sins_status {
    with_play(play, |itinerary, simulator, unit| {
        let save = |bytes: &mut [u8]| itinerary.save_snapshot(&simulator[0], unit.as_deref(), bytes);
        // SAFETY: the host's promise.
        unsafe { put_saved::<SINS_PLAY_SNAPSHOT_MAX_SIZE>(save, buffer.cast(), capacity, written) }
    })
}

/// Continues from a snapshot, to the same bits. play was made of the same scene, and of the same log if the flight is one; it may have
/// flown elsewhere. Handles that it lends stay valid. Not for a real-time frame: it allocates.
///
/// SINS_ERROR_SNAPSHOT: the bytes are not a snapshot of a scene in flight, or are cut off, altered, of a newer release, or of a scene with
/// other options or another run; nothing has changed.
/// SINS_ERROR_OUT_OF_MEMORY: no memory for a second simulator.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_play_snapshot_load(
    play: *mut sins_play,
    snapshot: *const c_void,
    size: usize,
) -> sins_status {
    with_play(play, |itinerary, simulator, unit| {
        // SAFETY: the host's promise.
        let snapshot = unsafe { bytes_of(snapshot.cast(), size, "snapshot")? };
        let (loaded, loaded_unit) = itinerary.load_snapshot(unit.is_some(), snapshot)?;
        *simulator = loaded;
        if let (Some(unit), Some(loaded)) = (unit, loaded_unit) {
            *unit = loaded;
        }
        Ok(SINS_OK)
    })
}
