//! The name of a thread where there is pthread.

/// The name of the calling thread, even and not 0: where its control block lies.
#[inline(always)]
pub fn this_thread() -> usize {
    // SAFETY: it has no conditions.
    unsafe { libc::pthread_self() as usize }
}

/// Whether a thread was terminated. This system has no call that tells it of a thread that may be gone: always false.
pub fn has_ended(_thread: usize) -> bool {
    false
}
