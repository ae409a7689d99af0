//! What is kept for a thread.

use core::cell::Cell;

use super::failure::Failure;

/// No destructor, so that the library can be unloaded. Calls on a simulator do without: the first use in a thread may
/// allocate.
pub(super) struct Here {
    /// Whether this thread is inside a call that has no handle.
    pub inside: Cell<bool>,
    /// The last failure on this thread that no simulator remembers.
    pub last_failure: Cell<Option<Failure>>,
}

thread_local! {
    pub(super) static HERE: Here =
        const { Here { inside: Cell::new(false), last_failure: Cell::new(None) } };
}

/// Takes what the first use of these variables takes.
#[cfg(windows)]
pub(super) fn touch_thread_locals() {
    HERE.with(|_| ());
}
