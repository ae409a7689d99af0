//! Other systems: one queue for all words, where no signal interrupts.

use core::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Duration;

#[cfg(target_family = "wasm")]
pub use super::super::wasm::{has_ended, this_thread};
#[cfg(unix)]
pub use super::unix::{has_ended, this_thread};

static QUEUE: Mutex<()> = Mutex::new(());
static CHANGED: Condvar = Condvar::new();
/// Time after which a waiting thread checks whether the owner still exists.
const PATIENCE: Duration = Duration::from_millis(100);

/// The threads that wait for a word.
pub struct Waiters;

impl Waiters {
    pub const fn new() -> Self {
        Self
    }

    /// Returns true when the word may have changed, false after a while.
    pub fn wait_while(&self, word: &AtomicUsize, value: usize) -> bool {
        let queue = QUEUE.lock().unwrap_or_else(PoisonError::into_inner);
        word.load(Ordering::Relaxed) != value
            || CHANGED.wait_timeout(queue, PATIENCE).is_ok_and(|(_, waited)| !waited.timed_out())
    }

    /// Wakes the threads that wait.
    pub fn wake(&self, _word: &AtomicUsize) {
        let _queue = QUEUE.lock().unwrap_or_else(PoisonError::into_inner);
        CHANGED.notify_all();
    }
}
