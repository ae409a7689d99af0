//! The boundary between host and library: no panic leaves the library, nothing is printed, and the host's floating-point state is
//! restored.

mod fpu;
pub(in crate::abi) mod handle;
mod key;
mod lock;
mod process;
mod registry;
pub(in crate::abi) mod tables;
mod thread;
mod thread_locals;
#[cfg(target_family = "wasm")]
mod wasm;

use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

use self::fpu::FloatState;
use self::process::prepare_process;
use self::tables::is_inside_a_handle;
use self::thread::Cancellation;
use self::thread_locals::HERE;
use crate::abi::failure::{CallError, SINS_ERROR_INTERNAL, SINS_OK, sins_status};
use crate::abi::sentence::Sentence;

/// Runs `body` as the inside of an exported function.
#[inline(always)]
pub(in crate::abi) fn enter(body: impl FnOnce() -> sins_status) -> sins_status {
    let cancellation = Cancellation::defer();
    let mut state = FloatState::UNKNOWN;
    state.enter();
    let status = guarded(body);
    state.leave();
    cancellation.restore();
    status
}

/// Not inlined, so that no floating-point instruction of `body` moves across the change of the control state.
#[inline(never)]
fn guarded(body: impl FnOnce() -> sins_status) -> sins_status {
    catch_unwind(AssertUnwindSafe(body)).unwrap_or(SINS_ERROR_INTERNAL)
}

/// Runs the inside of a function without a simulator. Its failure is kept for this thread.
pub(in crate::abi) fn enter_without_simulator(
    body: impl FnOnce() -> Result<sins_status, CallError>,
) -> sins_status {
    if !prepare_process() {
        return CallError::no_thread_locals().status;
    }
    let cancellation = Cancellation::defer();
    silence_panics();
    let outer = HERE.with(|here| here.inside.replace(true));
    let mut has_returned = false;
    let status = enter(|| {
        let result = body();
        has_returned = true;
        result.unwrap_or_else(|failure| {
            remember(failure);
            failure.status
        })
    });
    HERE.with(|here| here.inside.set(outer));
    if !has_returned {
        remember(CallError::internal());
    }
    cancellation.restore();
    status
}

/// Runs `body` as the inside of a C function of another shared library that contains this crate: with the default floating-point
/// control state, and afterwards with that of the host. `None`: `body` panicked; nothing is printed.
pub fn shielded<T>(body: impl FnOnce() -> T) -> Option<T> {
    if !prepare_process() {
        return None;
    }
    silence_panics();
    let outer = HERE.with(|here| here.inside.replace(true));
    let mut result = None;
    enter(|| {
        result = Some(body());
        SINS_OK
    });
    HERE.with(|here| here.inside.set(outer));
    result
}

/// Keeps a failure for this thread.
pub(in crate::abi) fn remember(failure: CallError) {
    remember_as(failure, Sentence::EMPTY);
}

/// Keeps a failure for this thread, with a sentence in place of that which is made of its data.
pub(in crate::abi) fn remember_as(failure: CallError, sentence: Sentence) {
    if prepare_process() {
        HERE.with(|here| {
            here.last_failure.set(Some(failure));
            here.last_sentence.set(sentence);
        });
    }
}

/// The last failure on this thread that no simulator keeps, with its sentence.
pub(in crate::abi) fn last_failure() -> (Option<CallError>, Sentence) {
    let (failure, sentence) = match prepare_process() {
        true => HERE.with(|here| (here.last_failure.get(), here.last_sentence.get())),
        false => (Some(CallError::no_thread_locals()), Sentence::EMPTY),
    };
    let has_no_more = sentence.as_bytes().is_empty();
    (failure, if has_no_more { Sentence::of(failure.as_ref()) } else { sentence })
}

/// Keeps the panic hook from printing while a thread is inside the library. In other threads the earlier hook runs. A shared library
/// has its own copy of the hook, which no other module uses.
fn silence_panics() {
    // Not locks to wait for: a fork may come while another thread is at it.
    static DONE: AtomicBool = AtomicBool::new(false);
    type Hook = Box<dyn Fn(&PanicHookInfo<'_>) + Sync + Send>;
    static PREVIOUS: OnceLock<Hook> = OnceLock::new();
    if DONE.load(Ordering::Relaxed) || DONE.swap(true, Ordering::Relaxed) {
        return;
    }
    let _ = PREVIOUS.set(take_hook());
    set_hook(Box::new(|info| {
        if !HERE.with(|here| here.inside.get())
            && !is_inside_a_handle()
            && let Some(previous) = PREVIOUS.get()
        {
            previous(info);
        }
    }));
}
