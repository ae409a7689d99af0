//! Handles of the host: calls on them, and new ones.

use super::registry::Registry;
use super::{enter, remember};
use crate::abi::failure::{CallError, sins_status};
use crate::abi::memory::put;

/// Runs `body` on the object of a handle, as the inside of an exported function. A failure is kept for this thread.
pub(in crate::abi) fn with_object<T, H, const KIND: usize>(
    table: &Registry<T, KIND>,
    handle: *const H,
    body: impl FnOnce(&mut T) -> Result<sins_status, CallError>,
) -> sins_status {
    enter(|| table.with(handle.addr(), |object| body(object).inspect_err(|&failure| remember(failure))))
}

/// Makes an object and gives the host its handle, at `place`, the argument `name`, which is looked at first.
///
/// # Safety
/// `place` is null or writable.
pub(in crate::abi) unsafe fn hand_out<T, H, const KIND: usize>(
    table: &Registry<T, KIND>,
    place: *mut *mut H,
    name: &'static str,
    make: impl FnOnce() -> Result<T, CallError>,
) -> Result<sins_status, CallError> {
    if place.is_null() {
        return Err(CallError::null(name));
    }
    let key = table.insert(make()?)?;
    // SAFETY: as this function.
    unsafe { put(place, core::ptr::without_provenance_mut(key), name) }
}
