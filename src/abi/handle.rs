//! Handles of the host: calls on them, and new ones.

use super::boundary::{enter, remember};
use super::failure::{Failure, sins_status};
use super::memory::put;
use super::registry::Registry;

/// Runs `body` on the object of a handle, as the inside of an exported function. A failure is kept for this thread.
pub(super) fn with_object<T, H>(
    table: &Registry<T>,
    handle: *const H,
    body: impl FnOnce(&mut T) -> Result<sins_status, Failure>,
) -> sins_status {
    enter(|| table.with(handle.addr(), |object| body(object).inspect_err(|&failure| remember(failure))))
}

/// Gives the host a handle of `object`, at `place`, the argument `name`.
///
/// # Safety
/// `place` is not null and writable.
pub(super) unsafe fn hand_out<T, H>(
    table: &Registry<T>,
    object: T,
    place: *mut *mut H,
    name: &'static str,
) -> Result<(), Failure> {
    let key = table.insert(object)?;
    // SAFETY: as this function.
    unsafe { put(place, core::ptr::without_provenance_mut(key), name) }
}
