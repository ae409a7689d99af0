//! Bytes and text of the host.

#[cfg(feature = "scenes")]
use core::ffi::CStr;
use core::ffi::c_char;

use super::failure::{CallError, SINS_OK, sins_status};
use super::memory::put_if_wanted;
use crate::base::error::Error;
#[cfg(feature = "scenes")]
use crate::base::error::Rule;

/// Gives the host the bytes that `save` writes, at most N, and their number.
///
/// # Safety
/// `buffer` is null or has `capacity` writable bytes; `written` is null or writable.
pub(super) unsafe fn put_saved<const N: usize>(
    save: impl FnOnce(&mut [u8]) -> Result<usize, Error>,
    buffer: *mut u8,
    capacity: usize,
    written: *mut usize,
) -> Result<sins_status, CallError> {
    if buffer.is_null() {
        return Err(CallError::null("buffer"));
    }
    let mut bytes = [0; N];
    let length = save(&mut bytes)?;
    if length > capacity {
        return Err(CallError::buffer("capacity", capacity, length));
    }
    // SAFETY: not more than there is room for; a local and the host's bytes do not overlap.
    unsafe { core::ptr::copy_nonoverlapping(bytes.as_ptr(), buffer, length) };
    // SAFETY: as this function.
    unsafe { put_if_wanted(written, length) };
    Ok(SINS_OK)
}

/// Bytes of the host that the library writes.
///
/// # Safety
/// `buffer` has `size` writable bytes, which nobody else uses while the slice lives.
pub(super) unsafe fn bytes_to_fill<'a>(buffer: *mut u8, size: usize) -> &'a mut [u8] {
    // SAFETY: as this function.
    unsafe { core::slice::from_raw_parts_mut(buffer, size) }
}

/// Bytes of the host.
///
/// # Safety
/// `pointer` is null or has `size` readable bytes, which nobody writes while the slice lives.
pub(super) unsafe fn bytes_of<'a>(
    pointer: *const u8,
    size: usize,
    name: &'static str,
) -> Result<&'a [u8], CallError> {
    if pointer.is_null() {
        return Err(CallError::null(name));
    }
    // No object is larger; a wrong size, as -1 for an error, stays a wrong size.
    let size = size.min(isize::MAX as usize);
    // SAFETY: not null, and of no larger size than an object can have.
    Ok(unsafe { core::slice::from_raw_parts(pointer, size) })
}

/// The bytes of a terminated string of the host, without the terminator.
///
/// # Safety
/// `text` is null or points to a terminated string, which nobody writes while the slice lives.
#[cfg(feature = "scenes")]
pub(super) unsafe fn text_of<'a>(text: *const c_char, name: &'static str) -> Result<&'a [u8], CallError> {
    if text.is_null() {
        return Err(CallError::null(name));
    }
    // SAFETY: not null, and terminated.
    Ok(unsafe { CStr::from_ptr(text) }.to_bytes())
}

/// A terminated text of the host in UTF-8.
///
/// # Safety
/// As [`text_of`].
#[cfg(feature = "scenes")]
pub(super) unsafe fn utf8_of<'a>(text: *const c_char, name: &'static str) -> Result<&'a str, CallError> {
    // SAFETY: as this function.
    let bytes = unsafe { text_of(text, name)? };
    core::str::from_utf8(bytes).map_err(|_| bad_text(name, "must be UTF-8").into())
}

/// The error of a text; it does not repeat the text.
#[cfg(feature = "scenes")]
pub(super) fn bad_text(name: &'static str, rule: &'static str) -> Error {
    Error { value: None, ..Error::invalid(name, 0.0, Rule::Sentence(rule)) }
}

/// Text as a fixed array of a struct: terminated, and cut between two characters if it is longer.
pub(super) fn chars<const N: usize>(text: &str) -> [c_char; N] {
    let fits = |end: &usize| *end < N && text.is_char_boundary(*end);
    let length = (0..=text.len().min(N)).rev().find(fits).unwrap_or(0);
    let mut chars = [0; N];
    for (place, byte) in chars.iter_mut().zip(&text.as_bytes()[..length]) {
        *place = *byte as c_char;
    }
    chars
}

/// Length of the text that fits into `capacity` bytes (at least 1) with a terminator. It does not end within a UTF-8 sequence.
fn fitting(text: &[u8], capacity: usize) -> usize {
    if text.len() < capacity {
        return text.len();
    }
    let mut length = capacity - 1;
    while length > 0 && text[length] & 0xc0 == 0x80 {
        length -= 1;
    }
    length
}

/// Copies text with a terminating zero. Text that does not fit is cut between two characters; the terminator is always written.
///
/// # Safety
/// `buffer` is null or has `capacity` writable bytes; `needed` is null or points to a writable `usize`.
pub(super) unsafe fn put_text(
    text: &[u8],
    buffer: *mut c_char,
    capacity: usize,
    needed: *mut usize,
) -> Result<sins_status, CallError> {
    let size = text.len() + 1;
    if !needed.is_null() {
        // SAFETY: not null.
        unsafe { needed.write_unaligned(size) };
    }
    if buffer.is_null() {
        // Asked for the size alone, or nothing to answer into.
        return if capacity == 0 && !needed.is_null() { Ok(SINS_OK) } else { Err(CallError::null("buffer")) };
    }
    if capacity > 0 {
        let length = fitting(text, capacity);
        // SAFETY: `length` < `capacity`.
        unsafe {
            core::ptr::copy_nonoverlapping(text.as_ptr(), buffer.cast::<u8>(), length);
            buffer.add(length).write(0);
        }
    }
    if size <= capacity { Ok(SINS_OK) } else { Err(CallError::buffer("capacity", capacity, size)) }
}
