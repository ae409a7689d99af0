//! Handles: checked keys into a table, never addresses.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::failure::{Failure, SINS_ERROR_BAD_HANDLE, SINS_ERROR_INTERNAL, SINS_OK, sins_status};

/// Handles of a kind that can live at once.
const SLOTS: usize = 4096;
const SLOT_BITS: u32 = SLOTS.trailing_zeros();
const KIND_BITS: u32 = 2;
/// Generations of a slot; one that has used them all is never used again, so that no key returns.
const LAST_GENERATION: usize = usize::MAX >> (SLOT_BITS + KIND_BITS);
/// A first generation that small made-up numbers do not hit.
const FIRST_GENERATION: usize = 0x2a5;

/// The living objects of one kind. A key is made of kind, slot and generation; each slot has its own lock, so calls on one
/// handle are serialised and different handles never wait for each other.
pub(super) struct Registry<T> {
    kind: usize,
    slots: [Mutex<Slot<T>>; SLOTS],
    /// Where the search for a free slot begins.
    next: AtomicUsize,
}

struct Slot<T> {
    /// Keys given out of this slot so far.
    used: usize,
    /// A slice of one, which unlike a `Box` can be allocated without aborting.
    content: Option<Box<[Content<T>]>>,
}

struct Content<T> {
    value: T,
    last_failure: Option<Failure>,
    /// A defect was caught while the value was in use.
    broken: bool,
}

impl<T> Registry<T> {
    /// An empty table for objects of `kind` (1 to 3).
    pub const fn new(kind: usize) -> Self {
        Self {
            kind,
            slots: [const { Mutex::new(Slot { used: 0, content: None }) }; SLOTS],
            next: AtomicUsize::new(0),
        }
    }

    /// Puts `value` in and gives its key.
    pub fn insert(&self, value: T) -> Result<usize, Failure> {
        let mut memory = Vec::new();
        memory.try_reserve_exact(1).map_err(|_| Failure::out_of_memory())?;
        memory.push(Content { value, last_failure: None, broken: false });
        let content = memory.into_boxed_slice();

        let start = self.next.fetch_add(1, Ordering::Relaxed);
        for offset in 0..SLOTS {
            let index = (start + offset) % SLOTS;
            // A slot that is locked is in use.
            let mut slot = match self.slots[index].try_lock() {
                Ok(slot) => slot,
                Err(std::sync::TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
                Err(std::sync::TryLockError::WouldBlock) => continue,
            };
            let generation = FIRST_GENERATION + slot.used;
            if slot.content.is_none() && generation <= LAST_GENERATION {
                slot.content = Some(content);
                return Ok(((generation << SLOT_BITS | index) << KIND_BITS) | self.kind);
            }
        }
        Err(Failure::out_of_memory())
    }

    /// Runs `body` on the object of `key`, or gives `SINS_ERROR_BAD_HANDLE`; remembers a failure.
    #[inline]
    pub fn with(&self, key: usize, body: impl FnOnce(&mut T) -> Result<sins_status, Failure>) -> sins_status {
        let Some(mut slot) = self.find(key) else { return SINS_ERROR_BAD_HANDLE };
        let Some([content]) = slot.content.as_deref_mut() else { return SINS_ERROR_BAD_HANDLE };
        if content.broken {
            return SINS_ERROR_INTERNAL;
        }
        match catch_unwind(AssertUnwindSafe(|| body(&mut content.value))) {
            Ok(Ok(status)) => status,
            Ok(Err(failure)) => {
                content.last_failure = Some(failure);
                failure.status
            }
            Err(_) => {
                content.broken = true;
                content.last_failure = Some(Failure::internal());
                SINS_ERROR_INTERNAL
            }
        }
    }

    /// The last failure of the object of `key`.
    pub fn last_failure(&self, key: usize) -> Result<Option<Failure>, sins_status> {
        let slot = self.find(key).ok_or(SINS_ERROR_BAD_HANDLE)?;
        match slot.content.as_deref() {
            Some([content]) => Ok(content.last_failure),
            _ => Err(SINS_ERROR_BAD_HANDLE),
        }
    }

    /// Destroys the object of `key`.
    pub fn remove(&self, key: usize) -> sins_status {
        let content = match self.find(key) {
            Some(mut slot) => {
                slot.used += 1;
                slot.content.take()
            }
            None => return SINS_ERROR_BAD_HANDLE,
        };
        drop(content);
        SINS_OK
    }

    /// The locked slot of `key`, if that lives.
    #[inline]
    fn find(&self, key: usize) -> Option<MutexGuard<'_, Slot<T>>> {
        if key & ((1 << KIND_BITS) - 1) != self.kind {
            return None;
        }
        let index = (key >> KIND_BITS) % SLOTS;
        let generation = key >> (KIND_BITS + SLOT_BITS);
        // Panics are caught inside the lock; it is never poisoned.
        let slot = self.slots[index].lock().unwrap_or_else(PoisonError::into_inner);
        (slot.content.is_some() && FIRST_GENERATION + slot.used == generation).then_some(slot)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    static NUMBERS: Registry<u32> = Registry::new(1);

    fn read(key: usize) -> Result<u32, sins_status> {
        let mut number = 0;
        match NUMBERS.with(key, |&mut value| {
            number = value;
            Ok(SINS_OK)
        }) {
            SINS_OK => Ok(number),
            status => Err(status),
        }
    }

    #[test]
    fn stale_forged_and_foreign_keys_find_nothing() {
        let key = NUMBERS.insert(5).unwrap();
        assert_eq!(read(key), Ok(5));
        assert_eq!(read(key ^ 3), Err(SINS_ERROR_BAD_HANDLE), "another kind");
        for forged in [0, 1, 5, usize::MAX, key + 4, key << 1] {
            assert_eq!(read(forged), Err(SINS_ERROR_BAD_HANDLE), "{forged:#x}");
        }
        assert_eq!(NUMBERS.remove(key), SINS_OK);
        assert_eq!(NUMBERS.remove(key), SINS_ERROR_BAD_HANDLE);
        // The same slot again, at the end of a round through all of them: the old key stays dead.
        let keys: Vec<usize> = (0..SLOTS).map(|_| NUMBERS.insert(6).unwrap()).collect();
        assert_eq!(read(key), Err(SINS_ERROR_BAD_HANDLE));
        assert_eq!(NUMBERS.insert(7).unwrap_err(), Failure::out_of_memory());
        for key in keys {
            assert_eq!(NUMBERS.remove(key), SINS_OK);
        }
    }

    static BROKEN: Registry<u32> = Registry::new(2);

    #[test]
    fn a_defect_breaks_its_own_handle_alone() {
        let (bad, good) = (BROKEN.insert(1).unwrap(), BROKEN.insert(2).unwrap());
        let hook = std::panic::take_hook();
        std::panic::set_hook(Box::new(|_| {}));
        assert_eq!(BROKEN.with(bad, |_| panic!("a defect")), SINS_ERROR_INTERNAL);
        std::panic::set_hook(hook);
        assert_eq!(BROKEN.with(bad, |_| Ok(SINS_OK)), SINS_ERROR_INTERNAL);
        assert_eq!(BROKEN.with(good, |_| Ok(SINS_OK)), SINS_OK);
        assert_eq!(BROKEN.last_failure(bad), Ok(Some(Failure::internal())));
        assert_eq!(BROKEN.remove(bad), SINS_OK);
        assert_eq!(BROKEN.remove(good), SINS_OK);
    }
}
