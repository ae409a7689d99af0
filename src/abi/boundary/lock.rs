//! A lock that knows the thread that holds it. If that thread takes the lock again, also in a signal handler, it gets
//! an error, and does not wait for itself for ever. The word of the lock is the name of the owner, so both change at the same moment:
//! between a mutex of a library and an owner word beside it, a signal handler would wait for its own thread for ever.

use core::cell::UnsafeCell;
use core::ops::{Deref, DerefMut};
use core::sync::atomic::{AtomicUsize, Ordering};

use super::thread::{WAITED_FOR, Waiters, has_ended, this_thread};

const FREE: usize = 0;
/// Stands for an owner that will never release the lock. No thread has this name.
const LOST: usize = usize::MAX & !WAITED_FOR;

/// A value that one thread at a time may use.
pub(in crate::abi) struct Lock<T> {
    /// `FREE`, `LOST`, or the name of the thread that holds the lock, with `WAITED_FOR` if another thread waits.
    owner: AtomicUsize,
    waiters: Waiters,
    value: UnsafeCell<T>,
}

// SAFETY: a guard is the only way to the value, and one lives at a time.
unsafe impl<T: Send> Sync for Lock<T> {}

/// Access to the value, until it is dropped.
pub(in crate::abi) struct Guard<'a, T> {
    lock: &'a Lock<T>,
}

impl<T> Lock<T> {
    pub const fn new(value: T) -> Self {
        Self { owner: AtomicUsize::new(FREE), waiters: Waiters::new(), value: UnsafeCell::new(value) }
    }

    /// Waits for other threads; `None` if the lock is this thread's own, or lost.
    #[inline]
    pub fn lock(&self) -> Option<Guard<'_, T>> {
        let me = this_thread();
        let free = self.owner.compare_exchange(FREE, me, Ordering::Acquire, Ordering::Relaxed);
        (free.is_ok() || self.wait(me)).then(|| Guard { lock: self })
    }

    /// Takes the lock when it is released. Returns false if it will never be released.
    #[cold]
    fn wait(&self, me: usize) -> bool {
        let replace =
            |old, new| self.owner.compare_exchange(old, new, Ordering::Acquire, Ordering::Relaxed).is_ok();
        let mut waited_in_vain = false;
        loop {
            let word = self.owner.load(Ordering::Relaxed);
            let owner = word & !WAITED_FOR;
            if word == FREE {
                // Further threads may wait: they are woken in their turn.
                if replace(FREE, me | WAITED_FOR) {
                    return true;
                }
            } else if owner == me || owner == LOST {
                return false;
            } else if waited_in_vain && has_ended(owner) {
                replace(word, LOST);
            } else if word == owner | WAITED_FOR || replace(word, owner | WAITED_FOR) {
                waited_in_vain = !self.waiters.wait_while(&self.owner, owner | WAITED_FOR);
            }
        }
    }

    /// Whether this thread holds the lock.
    pub fn is_mine(&self) -> bool {
        self.owner.load(Ordering::Relaxed) & !WAITED_FOR == this_thread()
    }

    /// Marks the lock as lost if another thread holds it. Called in the only thread of a forked process.
    #[cfg(unix)]
    pub fn lose_if_not_mine(&self) {
        if self.owner.load(Ordering::Relaxed) != FREE && !self.is_mine() {
            self.owner.store(LOST, Ordering::Relaxed);
        }
    }
}

impl<T> Deref for Guard<'_, T> {
    type Target = T;

    fn deref(&self) -> &T {
        // SAFETY: the lock is held.
        unsafe { &*self.lock.value.get() }
    }
}

impl<T> DerefMut for Guard<'_, T> {
    fn deref_mut(&mut self) -> &mut T {
        // SAFETY: the lock is held.
        unsafe { &mut *self.lock.value.get() }
    }
}

impl<T> Drop for Guard<'_, T> {
    #[inline]
    fn drop(&mut self) {
        if self.lock.owner.swap(FREE, Ordering::Release) & WAITED_FOR != 0 {
            self.lock.waiters.wake(&self.lock.owner);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_owner_is_answered_and_others_wait() {
        static LOCK: Lock<u64> = Lock::new(0);
        const ROUNDS: u64 = 20_000;
        let threads: Vec<_> = (0..4)
            .map(|_| {
                std::thread::spawn(|| {
                    for _ in 0..ROUNDS {
                        let mut value = LOCK.lock().unwrap();
                        assert!(LOCK.is_mine() && LOCK.lock().is_none() && LOCK.is_mine());
                        let before = *value;
                        std::hint::spin_loop();
                        *value = before + 1;
                    }
                })
            })
            .collect();
        for thread in threads {
            thread.join().unwrap();
        }
        assert!(!LOCK.is_mine());
        assert_eq!(*LOCK.lock().unwrap(), 4 * ROUNDS);
    }

    #[cfg(unix)]
    #[test]
    fn what_another_thread_held_in_the_parent_is_lost() {
        static LOCK: Lock<()> = Lock::new(());
        let mine = LOCK.lock().unwrap();
        LOCK.lose_if_not_mine();
        assert!(LOCK.is_mine());
        std::thread::spawn(|| LOCK.lose_if_not_mine()).join().unwrap();
        assert!(!LOCK.is_mine() && LOCK.lock().is_none());
        core::mem::forget(mine);
    }
}
