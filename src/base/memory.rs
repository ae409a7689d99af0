//! Memory that may not be available: a lack of memory is an error, and does not end the process.

use crate::base::error::{Error, ErrorKind, Rule};

/// Empty vector with room for `count` elements.
pub(crate) fn room<T>(count: usize) -> Result<Vec<T>, Error> {
    let mut vector = Vec::new();
    vector.try_reserve_exact(count).map_err(|_| missing::<T>(count))?;
    Ok(vector)
}

/// `count` copies of `value`.
pub(crate) fn filled<T: Clone>(count: usize, value: T) -> Result<Box<[T]>, Error> {
    let mut vector = room(count)?;
    vector.resize(count, value);
    Ok(vector.into_boxed_slice())
}

/// Makes room for one more element, in steps that grow with the vector.
pub(crate) fn room_for_one_more<T>(vector: &mut Vec<T>) -> Result<(), Error> {
    room_for_more(vector, 1)
}

/// Makes room for `count` more elements, likewise.
pub(crate) fn room_for_more<T>(vector: &mut Vec<T>, count: usize) -> Result<(), Error> {
    vector.try_reserve(count).map_err(|_| missing::<T>(vector.len() + count))
}

/// Checks that `bytes` bytes of memory are available now. For code that cannot report a lack of memory, such as parsers of other
/// crates. Without this check a lack ends the process; with it, only if memory runs out after the check.
pub(crate) fn probe(bytes: usize) -> Result<(), Error> {
    // The memory is used, because the optimizer would otherwise remove the allocation.
    room::<u8>(bytes).map(|memory| drop(core::hint::black_box(memory)))
}

/// The only element of `memory`, which [`room`] made, as a box. `Box::new` would end the process if there is no memory.
pub(crate) fn only<T>(memory: Vec<T>) -> Result<Box<[T; 1]>, Error> {
    let count = memory.len();
    memory.into_boxed_slice().try_into().map_err(|_| missing::<T>(count))
}

/// The error of a lack of memory for `count` elements.
pub(crate) fn missing<T>(count: usize) -> Error {
    of_bytes(count.saturating_mul(size_of::<T>()))
}

/// The error of a lack of `bytes` bytes of memory.
pub(crate) fn of_bytes(bytes: usize) -> Error {
    Error::of(ErrorKind::OutOfMemory, "memory_bytes", bytes, Rule::Sentence("not enough memory"))
}
