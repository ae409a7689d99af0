//! Ctrl-C, SIGTERM and SIGHUP, and SIGXFSZ: no temporary file stays behind.
//!
//! SIGXFSZ, of a file that reaches the limit of its size (`ulimit -f`), is blocked: the write fails, as on a full disk.
//! The first signal asks a [`graceful`] command to end with complete files. A second signal, or a signal to any other command, ends
//! the program at once. Signals within [`AT_ONCE`] are one: when a terminal is closed, the system and the shell send one each.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::{Duration, Instant};

use crate::failure::{Failure, Kind};

/// Current temporary files. Code that makes, renames or removes a file holds the lock, so that a signal finds all files.
static TEMPORARY: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

static IS_GRACEFUL: AtomicBool = AtomicBool::new(false);
/// When the command was asked to end.
static ASKED: OnceLock<Instant> = OnceLock::new();

/// Longest time from a signal to another one that means the same.
const AT_ONCE: Duration = Duration::from_secs(1);

/// Catches the signals from now on.
pub fn catch() -> Result<(), Failure> {
    let failed = |error: &dyn std::fmt::Display| {
        Failure::of_kind(Kind::Failed, format!("signals cannot be handled: {error}"))
    };
    // Threads that are made later block what this one blocks.
    #[cfg(unix)]
    {
        use nix::sys::signal::{SigSet, Signal};
        SigSet::from(Signal::SIGXFSZ).thread_block().map_err(|error| failed(&error))?;
    }
    ctrlc::set_handler(on_signal).map_err(|error| failed(&error))
}

fn on_signal() {
    let is_first = ASKED.get_or_init(Instant::now).elapsed() < AT_ONCE;
    if IS_GRACEFUL.load(Ordering::SeqCst) && is_first {
        return;
    }
    let temporary = lock();
    for path in temporary.iter() {
        let _ = std::fs::remove_file(path);
    }
    // The lock is held to the end, so no other file is made.
    std::process::exit(130);
}

/// From now on, the command ends with complete files when it is asked to end.
pub fn graceful() {
    IS_GRACEFUL.store(true, Ordering::SeqCst);
}

/// Whether the command was asked to end.
pub fn is_asked() -> bool {
    ASKED.get().is_some()
}

/// Locked list of temporary files. The lock is held while a file is made, renamed or removed.
pub struct Temporary(MutexGuard<'static, Vec<PathBuf>>);

impl Temporary {
    pub fn lock() -> Self {
        Self(lock())
    }

    pub fn add(&mut self, path: &Path) {
        self.0.push(path.to_owned());
    }

    pub fn forget(&mut self, path: &Path) {
        self.0.retain(|known| known != path);
    }
}

fn lock() -> MutexGuard<'static, Vec<PathBuf>> {
    TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner)
}
