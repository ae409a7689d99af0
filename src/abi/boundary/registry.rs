//! Handles: checked keys into a table, never addresses.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};

use super::key::{FirstGeneration, KIND_BITS, LAST_GENERATION, SLOTS, key_of, kind_of, slot_of};
use super::lock::{Guard, Lock};
use crate::abi::failure::{
    CallError, SINS_ERROR_BAD_HANDLE, SINS_ERROR_BAD_STATE, SINS_ERROR_INTERNAL, SINS_OK, sins_status,
};
use crate::base::memory::{only, room};

/// In place of the key of a slot: the slot is free. No key has this kind.
const FREE: usize = 0;
/// In place of the key of a slot: the slot is empty but reserved, because a handle is being made or destroyed, or the
/// generations are used up.
const CLAIMED: usize = usize::MAX;

/// The living objects of one kind. Each slot has its own lock, so calls on one handle are serialised and different handles
/// never wait for each other. A nested call of one thread on one handle, and a call on a handle that an abandoned call
/// holds, are `SINS_ERROR_BAD_STATE`.
///
/// The kind (from 1, see `tables`) is no field: an empty table is all zeros, so its 128 KiB are not in the file of the library.
pub(in crate::abi) struct Registry<T, const KIND: usize> {
    slots: [Slot<T>; SLOTS],
    /// Slot at which the search for a free one begins.
    next: AtomicUsize,
    first_generation: FirstGeneration,
}

struct Slot<T> {
    /// The valid key, compared before the lock is taken: a call with an old key never waits for the present object of the
    /// slot.
    key: AtomicUsize,
    place: Lock<Place<T>>,
}

struct Place<T> {
    /// Number of keys of this slot that were given out and destroyed.
    used: usize,
    /// Made by [`only`], as memory for it can be missing.
    content: Option<Box<[Content<T>; 1]>>,
}

struct Content<T> {
    value: T,
    last_failure: Option<CallError>,
    /// A defect was caught while the value was in use.
    broken: bool,
}

impl<T> Slot<T> {
    const fn empty() -> Self {
        Self { key: AtomicUsize::new(FREE), place: Lock::new(Place { used: 0, content: None }) }
    }

    /// The place of `key`, locked, if the key is valid.
    #[inline]
    fn find(&self, key: usize) -> Result<Guard<'_, Place<T>>, sins_status> {
        if self.key.load(Ordering::Acquire) != key {
            return Err(SINS_ERROR_BAD_HANDLE);
        }
        let place = self.place.lock().ok_or(SINS_ERROR_BAD_STATE)?;
        // The object may have been destroyed while this call waited for the lock.
        if self.key.load(Ordering::Relaxed) != key {
            return Err(SINS_ERROR_BAD_HANDLE);
        }
        Ok(place)
    }
}

impl<T, const KIND: usize> Registry<T, KIND> {
    /// An empty table.
    pub const fn new() -> Self {
        const { assert!(KIND > 0 && KIND >> KIND_BITS == 0, "a kind is a number of these bits") };
        Self {
            slots: [const { Slot::empty() }; SLOTS],
            next: AtomicUsize::new(0),
            first_generation: FirstGeneration::new(),
        }
    }

    /// Puts `value` in and gives its key.
    pub fn insert(&self, value: T) -> Result<usize, CallError> {
        let mut memory = room(1)?;
        memory.push(Content { value, last_failure: None, broken: false });
        let content = only(memory)?;
        let first_generation = self.first_generation.get();

        let start = self.next.fetch_add(1, Ordering::Relaxed);
        for offset in 0..SLOTS {
            let index = start.wrapping_add(offset) % SLOTS;
            let slot = &self.slots[index];
            if slot.key.compare_exchange(FREE, CLAIMED, Ordering::Acquire, Ordering::Relaxed).is_err() {
                continue;
            }
            let Some(mut place) = slot.place.lock() else {
                slot.key.store(FREE, Ordering::Release);
                continue;
            };
            let generation = first_generation + place.used;
            if generation < LAST_GENERATION {
                let key = key_of(generation, index, KIND);
                place.content = Some(content);
                slot.key.store(key, Ordering::Release);
                return Ok(key);
            }
        }
        Err(CallError::no_handle())
    }

    /// Runs `body` on the object of `key`, or gives `SINS_ERROR_BAD_HANDLE`; remembers a failure.
    #[inline]
    pub fn with(
        &self,
        key: usize,
        body: impl FnOnce(&mut T) -> Result<sins_status, CallError>,
    ) -> sins_status {
        let mut place = match self.find(key) {
            Ok(place) => place,
            Err(status) => return status,
        };
        let Some([content]) = place.content.as_deref_mut() else {
            return SINS_ERROR_BAD_HANDLE;
        };
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
                content.last_failure = Some(CallError::internal());
                SINS_ERROR_INTERNAL
            }
        }
    }

    /// Runs `body` on the object of `key`, which it only reads, or gives a status: `SINS_ERROR_INTERNAL` for a defect of `body`, which
    /// leaves the object as it was.
    pub fn look_at<R>(&self, key: usize, body: impl FnOnce(&T) -> R) -> Result<R, sins_status> {
        let place = self.find(key)?;
        let Some([content]) = place.content.as_deref() else {
            return Err(SINS_ERROR_BAD_HANDLE);
        };
        if content.broken {
            return Err(SINS_ERROR_INTERNAL);
        }
        catch_unwind(AssertUnwindSafe(|| body(&content.value))).map_err(|_| SINS_ERROR_INTERNAL)
    }

    /// The last failure of the object of `key`.
    pub fn last_failure(&self, key: usize) -> Result<Option<CallError>, sins_status> {
        match self.find(key)?.content.as_deref() {
            Some([content]) => Ok(content.last_failure),
            _ => Err(SINS_ERROR_BAD_HANDLE),
        }
    }

    /// Whether this thread is inside a call on one of the objects.
    pub fn is_in_use_here(&self) -> bool {
        self.slots.iter().any(|slot| slot.place.is_mine())
    }

    /// In a process that was forked: other threads, and what they had in use, are not there.
    #[cfg(unix)]
    pub fn lose_what_others_use(&self) {
        self.slots.iter().for_each(|slot| slot.place.lose_if_not_mine());
    }

    /// Destroys the object of `key`.
    pub fn remove(&self, key: usize) -> sins_status {
        let Some(slot) = self.slot(key) else { return SINS_ERROR_BAD_HANDLE };
        let content = match slot.find(key) {
            Ok(mut place) => {
                slot.key.store(CLAIMED, Ordering::Relaxed);
                place.used += 1;
                place.content.take()
            }
            Err(status) => return status,
        };
        drop(content);
        slot.key.store(FREE, Ordering::Release);
        SINS_OK
    }

    /// The slot of `key`, if the key is of this kind.
    #[inline]
    fn slot(&self, key: usize) -> Option<&Slot<T>> {
        (kind_of(key) == KIND).then(|| &self.slots[slot_of(key)])
    }

    /// The place of `key`, locked, if the key is valid and of this kind.
    #[inline]
    fn find(&self, key: usize) -> Result<Guard<'_, Place<T>>, sins_status> {
        self.slot(key).ok_or(SINS_ERROR_BAD_HANDLE)?.find(key)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    static NUMBERS: Registry<u32, 1> = Registry::new();

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
        for forged in [FREE, 1, 5, CLAIMED, key + 4, key << 1] {
            assert_eq!(read(forged), Err(SINS_ERROR_BAD_HANDLE), "{forged:#x}");
            assert_eq!(NUMBERS.remove(forged), SINS_ERROR_BAD_HANDLE, "{forged:#x}");
        }
        assert_eq!(NUMBERS.remove(key), SINS_OK);
        assert_eq!(NUMBERS.remove(key), SINS_ERROR_BAD_HANDLE);
        // The same slot again, at the end of a round through all of them: the old key stays dead.
        let keys: Vec<usize> = (0..SLOTS).map(|_| NUMBERS.insert(6).unwrap()).collect();
        assert_eq!(read(key), Err(SINS_ERROR_BAD_HANDLE));
        assert_eq!(NUMBERS.insert(7).unwrap_err(), CallError::no_handle());
        for key in keys {
            assert_eq!(NUMBERS.remove(key), SINS_OK);
        }
    }

    #[test]
    fn a_dead_key_does_not_wait_for_who_lives_in_its_slot() {
        static TABLE: Registry<u32, 1> = Registry::new();
        let dead = TABLE.insert(0).unwrap();
        assert_eq!(TABLE.remove(dead), SINS_OK);
        let keys: Vec<usize> = (0..SLOTS).map(|_| TABLE.insert(1).unwrap()).collect();
        let heir = *keys
            .iter()
            .find(|&&key| core::ptr::eq(TABLE.slot(key).unwrap(), TABLE.slot(dead).unwrap()))
            .unwrap();
        assert_ne!(heir, dead);
        let status = TABLE.with(heir, |_| {
            let (told, hear) = std::sync::mpsc::channel();
            std::thread::spawn(move || {
                // A table without room does not wait either.
                let full = TABLE.insert(2).unwrap_err();
                let _ = told.send((TABLE.with(dead, |_| Ok(SINS_OK)), TABLE.remove(dead), full));
            });
            let answers = hear.recv_timeout(std::time::Duration::from_secs(60));
            assert_eq!(answers, Ok((SINS_ERROR_BAD_HANDLE, SINS_ERROR_BAD_HANDLE, CallError::no_handle())));
            Ok(SINS_OK)
        });
        assert_eq!(status, SINS_OK);
    }

    #[test]
    fn the_key_of_another_table_is_none_here() {
        static TABLES: [Registry<u32, 1>; 2] = [const { Registry::new() }; 2];
        let [first, second] = [0, 1].map(|i| TABLES[i].insert(0).unwrap());
        assert_ne!(first, second);
        assert_eq!(TABLES[0].remove(second), SINS_ERROR_BAD_HANDLE);
        assert_eq!(TABLES[1].remove(first), SINS_ERROR_BAD_HANDLE);
    }

    #[test]
    fn a_call_within_a_call_on_the_same_handle_is_answered() {
        static TABLE: Registry<u32, 1> = Registry::new();
        let [outer, inner] = [0, 1].map(|value| TABLE.insert(value).unwrap());
        let status = TABLE.with(outer, |_| {
            assert!(TABLE.is_in_use_here());
            TABLE.with(inner, |_| {
                assert_eq!(TABLE.with(outer, |_| Ok(SINS_OK)), SINS_ERROR_BAD_STATE);
                assert_eq!(TABLE.last_failure(outer), Err(SINS_ERROR_BAD_STATE));
                assert_eq!(TABLE.remove(outer), SINS_ERROR_BAD_STATE);
                Ok(SINS_OK)
            });
            Ok(SINS_OK)
        });
        assert!(!TABLE.is_in_use_here());
        assert_eq!((status, TABLE.remove(outer), TABLE.remove(inner)), (SINS_OK, SINS_OK, SINS_OK));
    }

    static BROKEN: Registry<u32, 2> = Registry::new();

    #[test]
    fn a_defect_breaks_its_own_handle_alone_and_none_that_it_reads() {
        let (bad, good) = (BROKEN.insert(1).unwrap(), BROKEN.insert(2).unwrap());
        let hook = std::panic::take_hook();
        std::panic::set_hook(Box::new(|_| {}));
        assert_eq!(BROKEN.with(bad, |_| panic!("a defect")), SINS_ERROR_INTERNAL);
        assert_eq!(BROKEN.look_at(good, |_| -> u32 { panic!("a defect") }), Err(SINS_ERROR_INTERNAL));
        assert_eq!(BROKEN.look_at(good, |number| *number), Ok(2));
        std::panic::set_hook(hook);
        assert_eq!(BROKEN.with(bad, |_| Ok(SINS_OK)), SINS_ERROR_INTERNAL);
        assert_eq!(BROKEN.with(good, |_| Ok(SINS_OK)), SINS_OK);
        assert_eq!(BROKEN.last_failure(bad), Ok(Some(CallError::internal())));
        assert_eq!(BROKEN.look_at(bad, |number| *number), Err(SINS_ERROR_INTERNAL));
        assert_eq!(BROKEN.remove(bad), SINS_OK);
        assert_eq!(BROKEN.remove(good), SINS_OK);
    }
}
