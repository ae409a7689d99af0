//! State of a thread.

use core::cell::Cell;

use crate::abi::failure::CallError;
use crate::abi::sentence::Sentence;

/// State of a thread. It has no destructor, so that the library can be unloaded. Calls on a simulator do not use it, because its first
/// use in a thread may allocate.
pub(in crate::abi) struct Here {
    /// Whether this thread is inside a call that has no handle.
    pub inside: Cell<bool>,
    /// The last failure on this thread that no simulator keeps.
    pub last_failure: Cell<Option<CallError>>,
    /// Its sentence, if the failure's data do not say all; else empty.
    pub last_sentence: Cell<Sentence>,
}

thread_local! {
    pub(in crate::abi) static HERE: Here = const {
        Here {
            inside: Cell::new(false),
            last_failure: Cell::new(None),
            last_sentence: Cell::new(Sentence::EMPTY),
        }
    };
}

/// Uses these variables once, so that they take their memory and TLS indexes now.
#[cfg(windows)]
pub(in crate::abi) fn touch_thread_locals() {
    HERE.with(|_| ());
}
