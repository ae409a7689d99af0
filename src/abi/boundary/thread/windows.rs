//! Windows: an event of the kernel for each word. A queue of the process would have a lock of its own, and `TerminateThread` can end the
//! thread that holds it: then all threads would wait for ever.

use core::ffi::c_void;
use core::ptr::{null, null_mut};
use core::sync::atomic::{AtomicPtr, AtomicUsize, Ordering, fence};

use windows_sys::Win32::Foundation::{
    CloseHandle, ERROR_INVALID_PARAMETER, FALSE, GetLastError, WAIT_OBJECT_0,
};
use windows_sys::Win32::System::Threading::{
    CreateEventW, GetCurrentThreadId, OpenThread, SetEvent, Sleep, THREAD_SYNCHRONIZE, WaitForSingleObject,
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
