//! The name of the calling thread, and waiting until a word changes, without anything that is thread-local in Rust: signal
//! handlers may come here, and on Windows thread-local storage can run out.

use core::sync::atomic::AtomicUsize;

/// The bit that is 0 in the name of every thread.
pub(in crate::abi) const WAITED_FOR: usize = 1;

#[cfg(target_family = "wasm")]
pub(in crate::abi) use super::wasm::{has_ended, this_thread};
pub(in crate::abi) use cancellation::Cancellation;
#[cfg(not(target_family = "wasm"))]
pub(in crate::abi) use system::{has_ended, this_thread};
pub(in crate::abi) use waiting::Waiters;

#[cfg(unix)]
mod system {
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
}

/// Defers a cancellation of the calling thread while it is in a call. A thread that is cancelled at any instruction would be unwound
/// through Rust's frames, which ends the process. The library has no cancellation points, so a deferred cancellation waits until the
/// call returns. It then unwinds the exported function, which has nothing to drop and is "C-unwind".
#[cfg(target_os = "linux")]
mod cancellation {
    use core::ffi::c_int;
    use core::ptr::null_mut;

    // The crate libc does not declare it.
    unsafe extern "C-unwind" {
        fn pthread_setcanceltype(kind: c_int, before: *mut c_int) -> c_int;
    }
    const DEFERRED: c_int = 0;

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
}

#[cfg(not(target_os = "linux"))]
mod cancellation {
    pub struct Cancellation;

    impl Cancellation {
        #[inline(always)]
        pub fn defer() -> Self {
            Self
        }

        #[inline(always)]
        pub fn restore(self) {}
    }
}

#[cfg(windows)]
mod system {
    use windows_sys::Win32::Foundation::{
        CloseHandle, ERROR_INVALID_PARAMETER, FALSE, GetLastError, WAIT_OBJECT_0,
    };
    use windows_sys::Win32::System::Threading::{
        GetCurrentThreadId, OpenThread, THREAD_SYNCHRONIZE, WaitForSingleObject,
    };

    /// The name of the calling thread, even and not 0: twice its number.
    #[inline(always)]
    pub fn this_thread() -> usize {
        // SAFETY: it has no conditions.
        unsafe { (GetCurrentThreadId() as usize) << 1 }
    }

    /// Whether a thread was terminated.
    pub fn has_ended(thread: usize) -> bool {
        // SAFETY: the object that is opened is closed, and not used again.
        unsafe {
            let object = OpenThread(THREAD_SYNCHRONIZE, FALSE, (thread >> 1) as u32);
            if object.is_null() {
                return GetLastError() == ERROR_INVALID_PARAMETER;
            }
            let ended = WaitForSingleObject(object, 0) == WAIT_OBJECT_0;
            CloseHandle(object);
            ended
        }
    }
}

/// The kernel's own queue: the code that a signal interrupted cannot hold it.
#[cfg(target_os = "linux")]
mod waiting {
    use super::AtomicUsize;
    use core::ptr::{from_ref, null};

    use libc::{FUTEX_PRIVATE_FLAG, FUTEX_WAIT, FUTEX_WAKE, SYS_futex, syscall};

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
}

/// An event of the kernel for each word. A queue of the process would have a lock of its own, and `TerminateThread` can end the
/// thread that holds it: then all threads would wait for ever.
#[cfg(windows)]
mod waiting {
    use super::AtomicUsize;
    use core::ffi::c_void;
    use core::ptr::{null, null_mut};
    use core::sync::atomic::{AtomicPtr, Ordering, fence};

    use windows_sys::Win32::Foundation::{CloseHandle, FALSE, WAIT_OBJECT_0};
    use windows_sys::Win32::System::Threading::{CreateEventW, SetEvent, Sleep, WaitForSingleObject};

    /// Time after which a waiting thread checks whether the owner still exists.
    const PATIENCE_MS: u32 = 100;

    /// The threads that wait for a word. The first of them makes the event, which is signalled until one thread has seen it.
    pub struct Waiters(AtomicPtr<c_void>);

    impl Waiters {
        pub const fn new() -> Self {
            Self(AtomicPtr::new(null_mut()))
        }

        /// Null: the process has no handle left.
        fn event(&self) -> *mut c_void {
            let found = self.0.load(Ordering::Acquire);
            if !found.is_null() {
                return found;
            }
            // SAFETY: neither security nor name; an object that another thread was faster to make is closed by its only owner.
            unsafe {
                let made = CreateEventW(null(), FALSE, FALSE, null());
                match self.0.compare_exchange(null_mut(), made, Ordering::AcqRel, Ordering::Acquire) {
                    Ok(_) => made,
                    Err(found) => {
                        CloseHandle(made);
                        found
                    }
                }
            }
        }

        /// Returns true when the word may have changed, false after a while. The event keeps a signal that comes before the
        /// wait.
        pub fn wait_while(&self, word: &AtomicUsize, value: usize) -> bool {
            let event = self.event();
            // Whoever changes the word behind this look at it finds the event.
            fence(Ordering::SeqCst);
            if word.load(Ordering::Relaxed) != value {
                return true;
            }
            if event.is_null() {
                // SAFETY: it has no conditions.
                unsafe { Sleep(PATIENCE_MS) };
                return false;
            }
            // SAFETY: the event lives as long as these waiters.
            unsafe { WaitForSingleObject(event, PATIENCE_MS) == WAIT_OBJECT_0 }
        }

        /// Wakes one of them.
        pub fn wake(&self, _word: &AtomicUsize) {
            fence(Ordering::SeqCst);
            let event = self.0.load(Ordering::Acquire);
            if !event.is_null() {
                // SAFETY: as above.
                unsafe { SetEvent(event) };
            }
        }
    }

    impl Drop for Waiters {
        fn drop(&mut self) {
            let event = *self.0.get_mut();
            if !event.is_null() {
                // SAFETY: nobody waits any more.
                unsafe { CloseHandle(event) };
            }
        }
    }
}

/// One queue for all words, where no signal interrupts.
#[cfg(not(any(target_os = "linux", windows)))]
mod waiting {
    use super::AtomicUsize;
    use core::sync::atomic::Ordering;
    use std::sync::{Condvar, Mutex, PoisonError};
    use std::time::Duration;

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
}
