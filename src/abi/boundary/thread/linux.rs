//! Linux: a cancellation is deferred while a thread is in a call, and threads wait in the kernel's own queue, which the code that a signal
//! interrupted cannot hold.

use core::ffi::c_int;
use core::ptr::{from_ref, null, null_mut};
use core::sync::atomic::AtomicUsize;

use libc::{FUTEX_PRIVATE_FLAG, FUTEX_WAIT, FUTEX_WAKE, SYS_futex, syscall};

pub use super::unix::{has_ended, this_thread};

// The crate libc does not declare it.
unsafe extern "C-unwind" {
    fn pthread_setcanceltype(kind: c_int, before: *mut c_int) -> c_int;
}
const DEFERRED: c_int = 0;

/// Defers a cancellation of the calling thread while it is in a call. A thread that is cancelled at any instruction would be unwound
/// through Rust's frames, which ends the process. The library has no cancellation points, so a deferred cancellation waits until the
/// call returns. It then unwinds the exported function, which has nothing to drop and is "C-unwind".
pub struct Cancellation(c_int);

impl Cancellation {
    #[inline(always)]
    pub fn defer() -> Self {
        let mut before = DEFERRED;
        // SAFETY: a place for the kind, which the C library writes.
        unsafe { pthread_setcanceltype(DEFERRED, &raw mut before) };
        Self(before)
    }

    /// A cancellation that came in between takes effect here if the thread can be cancelled at any instruction.
    #[inline(always)]
    pub fn restore(self) {
        // SAFETY: the kind that the C library gave.
        unsafe { pthread_setcanceltype(self.0, null_mut()) };
    }
}

const WAIT_PRIVATE: i32 = FUTEX_WAIT | FUTEX_PRIVATE_FLAG;
const WAKE_PRIVATE: i32 = FUTEX_WAKE | FUTEX_PRIVATE_FLAG;

/// The half that the kernel compares, which holds `WAITED_FOR`. Two threads that are named alike in it do no harm: who
/// waits for the one is woken by the other as well.
fn half(word: &AtomicUsize) -> *const u32 {
    const _: () = assert!(cfg!(target_endian = "little"));
    from_ref(word).cast()
}

/// The threads that wait for a word.
pub struct Waiters;

impl Waiters {
    pub const fn new() -> Self {
        Self
    }

    /// Returns true when the word may have changed.
    pub fn wait_while(&self, word: &AtomicUsize, value: usize) -> bool {
        // SAFETY: the word lives; no timeout is stated.
        unsafe { syscall(SYS_futex, half(word), WAIT_PRIVATE, value as u32, null::<u8>()) };
        true
    }

    /// Wakes one of them.
    pub fn wake(&self, word: &AtomicUsize) {
        // SAFETY: nothing but the address of the word is used.
        unsafe { syscall(SYS_futex, half(word), WAKE_PRIVATE, 1_u32) };
    }
}
