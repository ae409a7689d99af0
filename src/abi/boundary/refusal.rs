//! The last handle of each thread that was rejected: there is no object that could keep this failure.
//!
//! Nothing here is a thread-local variable of Rust, because its first use in a thread may allocate. Each step is atomic, because a
//! signal handler may run in the middle of another step.

use core::sync::atomic::{AtomicUsize, Ordering};

use super::thread::this_thread;
use crate::abi::failure::{Failure, sins_status};

/// Number of threads whose rejected handles are kept. If there are more, the newest replaces another.
const THREADS: usize = 1024;
const FREE: usize = 0;
const NONE: usize = 0;

/// What the handles of each kind are in sentences; the kinds are those of [`super::tables`].
const NAMES: [&str; 8] = ["", "sim", "flight", "scene", "log", "ensemble", "", ""];

struct Place {
    /// The name of its thread, or `FREE`. No thread is named 0.
    thread: AtomicUsize,
    /// `NONE`, or kind and status; only its thread writes it.
    refused: AtomicUsize,
}

static PLACES: [Place; THREADS] =
    [const { Place { thread: AtomicUsize::new(FREE), refused: AtomicUsize::new(NONE) } }; THREADS];

/// The place of this thread. If it has none: with `taken` it gets one, else `None`.
fn place(taken: bool) -> Option<&'static Place> {
    let me = this_thread();
    // Names are addresses or multiples of 8: the low bits say nothing.
    let home = (me >> 3) ^ (me >> 12);
    for offset in 0..THREADS {
        let place = &PLACES[home.wrapping_add(offset) % THREADS];
        let owner = place.thread.load(Ordering::Relaxed);
        if owner == me {
            return Some(place);
        }
        if owner == FREE {
            if !taken {
                return None;
            }
            match place.thread.compare_exchange(FREE, me, Ordering::Relaxed, Ordering::Relaxed) {
                Err(other) if other != me => {}
                // This thread, or its signal handler just before.
                _ => return Some(place),
            }
        }
    }
    let home = &PLACES[home % THREADS];
    taken.then(|| {
        home.thread.store(me, Ordering::Relaxed);
        home
    })
}

/// Keeps, for this thread, that a handle of `kind` was rejected with `status`, which is negative.
#[cold]
pub(in crate::abi) fn refuse(kind: usize, status: sins_status) {
    if let Some(place) = place(true) {
        place.refused.store(kind << 8 | status.unsigned_abs() as usize, Ordering::Relaxed);
    }
}

/// Forgets the rejected handle of this thread, because a later failure follows.
pub(in crate::abi) fn forget() {
    if let Some(place) = place(false) {
        place.refused.store(NONE, Ordering::Relaxed);
    }
}

/// The rejected handle, if it was the last failure on this thread that no simulator keeps.
pub(in crate::abi) fn last() -> Option<Failure> {
    match place(false)?.refused.load(Ordering::Relaxed) {
        NONE => None,
        refused => {
            let status = -((refused & 0xff) as sins_status);
            Some(Failure::of_handle(status, NAMES[(refused >> 8) % NAMES.len()]))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::abi::{SINS_ERROR_BAD_HANDLE, SINS_ERROR_BAD_STATE};

    #[test]
    fn each_thread_has_its_own_until_it_forgets() {
        let threads: Vec<_> = (0..16)
            .map(|k| {
                std::thread::spawn(move || {
                    let status = if k % 2 == 0 { SINS_ERROR_BAD_HANDLE } else { SINS_ERROR_BAD_STATE };
                    forget();
                    assert_eq!(last(), None);
                    for (kind, name) in NAMES.iter().enumerate().skip(1).take(5) {
                        refuse(kind, status);
                        std::thread::yield_now();
                        assert_eq!(last(), Some(Failure::of_handle(status, name)));
                    }
                    forget();
                    assert_eq!(last(), None);
                })
            })
            .collect();
        for thread in threads {
            thread.join().unwrap();
        }
    }
}
