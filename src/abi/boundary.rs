//! What stands between the host and the library: no panic leaves, nothing is printed, the host's floating-point state is
//! left as it was.

use core::cell::Cell;
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::sync::{Once, OnceLock};

use super::failure::{Failure, SINS_ERROR_INTERNAL, sins_status};
use super::fpu::FloatState;

thread_local! {
    /// Whether this thread is inside the library. No destructor, so that the library can be unloaded.
    static INSIDE: Cell<bool> = const { Cell::new(false) };
    /// The last failure on this thread that no simulator remembers.
    static LAST_FAILURE: Cell<Option<Failure>> = const { Cell::new(None) };
}

/// Runs `body` as the inside of an exported function.
#[inline(always)]
pub(super) fn enter(body: impl FnOnce() -> sins_status) -> sins_status {
    let state = FloatState::enter();
    let status = guarded(body);
    state.leave();
    status
}

/// Not inlined, so that no floating-point instruction of `body` moves across the change of the control state.
#[inline(never)]
fn guarded(body: impl FnOnce() -> sins_status) -> sins_status {
    INSIDE.set(true);
    let status = catch_unwind(AssertUnwindSafe(body)).unwrap_or(SINS_ERROR_INTERNAL);
    INSIDE.set(false);
    status
}

/// Runs the inside of a function that has no simulator to remember its failure: it is kept for this thread.
pub(super) fn enter_without_simulator(body: impl FnOnce() -> Result<sins_status, Failure>) -> sins_status {
    silence_panics();
    enter(|| {
        body().unwrap_or_else(|failure| {
            remember(failure);
            failure.status
        })
    })
}

/// Keeps a failure for this thread.
pub(super) fn remember(failure: Failure) {
    LAST_FAILURE.set(Some(failure));
}

/// The last failure on this thread that no simulator remembers.
pub(super) fn last_failure() -> Option<Failure> {
    LAST_FAILURE.get()
}

/// Keeps the panic hook from printing while a thread is inside the library; elsewhere the hook before it goes on. In the
/// shared library that is the library's own copy, and nobody else's.
fn silence_panics() {
    static ONCE: Once = Once::new();
    type Hook = Box<dyn Fn(&PanicHookInfo<'_>) + Sync + Send>;
    static PREVIOUS: OnceLock<Hook> = OnceLock::new();
    ONCE.call_once(|| {
        let _ = PREVIOUS.set(take_hook());
        set_hook(Box::new(|info| {
            if !INSIDE.get()
                && let Some(previous) = PREVIOUS.get()
            {
                previous(info);
            }
        }));
    });
}
