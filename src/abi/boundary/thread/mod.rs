//! The name of the calling thread, and waiting until a word changes, without anything that is thread-local in Rust: signal
//! handlers may come here, and on Windows thread-local storage can run out. Each system has its file.

/// The bit that is 0 in the name of every thread.
pub(in crate::abi) const WAITED_FOR: usize = 1;

#[cfg(target_os = "linux")]
mod linux;
#[cfg(not(any(target_os = "linux", windows)))]
mod other;
#[cfg(unix)]
mod unix;
#[cfg(windows)]
mod windows;

#[cfg(target_os = "linux")]
pub(in crate::abi) use linux::{Cancellation, Waiters, has_ended, this_thread};
#[cfg(not(any(target_os = "linux", windows)))]
pub(in crate::abi) use other::{Waiters, has_ended, this_thread};
#[cfg(windows)]
pub(in crate::abi) use windows::{Waiters, has_ended, this_thread};

/// The other systems do not cancel a thread at any instruction.
#[cfg(not(target_os = "linux"))]
pub(in crate::abi) struct Cancellation;

#[cfg(not(target_os = "linux"))]
impl Cancellation {
    #[inline(always)]
    pub fn defer() -> Self {
        Self
    }

    #[inline(always)]
    pub fn restore(self) {}
}
