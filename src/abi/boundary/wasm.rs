//! What WebAssembly has in the place of an operating system (wasm32-unknown-unknown): one thread, no signals, no forks, no clock, and
//! one floating-point environment. The module imports nothing, so it also has no source of randomness. A panic cannot be caught: it
//! traps, and the host must make a new instance.

use core::ptr::null_mut;
use std::alloc::{Layout, alloc_zeroed, dealloc};

/// The floating-point environment of WebAssembly is fixed: round to nearest, denormals kept, no exceptions.
pub(in crate::abi) struct FloatState;

impl FloatState {
    pub const UNKNOWN: Self = Self;

    #[inline(always)]
    pub fn enter(&mut self) {}

    #[inline(always)]
    pub fn leave(&self) {}
}

/// The name of the only thread, even and not 0.
#[inline(always)]
pub fn this_thread() -> usize {
    2
}

/// Whether a thread was terminated: the only thread runs.
pub fn has_ended(_thread: usize) -> bool {
    false
}

/// There is nothing to prepare.
pub fn prepare() -> bool {
    true
}

/// In the place of the time: without a clock, the first keys of two instances are the same. `sins.mjs` compares the instance.
pub fn time_mark() -> u64 {
    0
}

/// Alignment of the memory of hosts: that of the largest number of the interface.
const ALIGNMENT: usize = 8;

/// Gives a host memory within the module, all zero; null: there is no more. Structs, arrays and texts of a host must lie there,
/// because the library reads no other memory. Not in the header: hosts outside of WebAssembly have memory of their own.
#[unsafe(no_mangle)]
pub extern "C" fn sins_wasm_allocate(size: usize) -> *mut u8 {
    match Layout::from_size_align(size, ALIGNMENT) {
        // SAFETY: the size is not 0.
        Ok(layout) if size > 0 => unsafe { alloc_zeroed(layout) },
        _ => null_mut(),
    }
}

/// Takes the memory back.
///
/// # Safety
/// `memory` came from [`sins_wasm_allocate`] with the same size, and is not used any more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_wasm_free(memory: *mut u8, size: usize) {
    if let Ok(layout) = Layout::from_size_align(size, ALIGNMENT) {
        // SAFETY: the host's promise.
        unsafe { dealloc(memory, layout) }
    }
}
