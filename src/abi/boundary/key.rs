//! Keys of handles. A key is a number made of kind, slot and generation; no key is ever used again.

use core::sync::atomic::{AtomicUsize, Ordering};
#[cfg(not(target_family = "wasm"))]
use std::time::{SystemTime, UNIX_EPOCH};

#[cfg(target_family = "wasm")]
use super::wasm::time_mark;
use crate::base::math::SPLIT_MIX_STEP;

/// Largest number of handles of a kind that exist at the same time.
pub(in crate::abi) const SLOTS: usize = 4096;
const SLOT_BITS: u32 = SLOTS.trailing_zeros();
pub(in crate::abi) const KIND_BITS: u32 = 4;
/// Generations of a slot; one that has used them all is never used again, so that no key returns.
pub(in crate::abi) const LAST_GENERATION: usize = usize::MAX >> (SLOT_BITS + KIND_BITS);
/// Less than every first generation, so small made-up numbers are never keys.
const LOWEST_GENERATION: usize = 0x2a5;

pub(in crate::abi) fn key_of(generation: usize, slot: usize, kind: usize) -> usize {
    ((generation << SLOT_BITS | slot) << KIND_BITS) | kind
}

#[inline]
pub(in crate::abi) fn kind_of(key: usize) -> usize {
    key & ((1 << KIND_BITS) - 1)
}

#[inline]
pub(in crate::abi) fn slot_of(key: usize) -> usize {
    (key >> KIND_BITS) % SLOTS
}

/// The first generation of the keys of a table; 0 until it is drawn. This is an atomic and not a lock, because a fork may
/// happen while another thread draws.
pub(in crate::abi) struct FirstGeneration(AtomicUsize);

impl FirstGeneration {
    pub const fn new() -> Self {
        Self(AtomicUsize::new(0))
    }

    pub fn get(&self) -> usize {
        match self.0.load(Ordering::Relaxed) {
            0 => {
                let drawn = self.draw();
                let first = self.0.compare_exchange(0, drawn, Ordering::Relaxed, Ordering::Relaxed);
                first.err().unwrap_or(drawn)
            }
            first => first,
        }
    }

    /// Draws a first generation from the lower half of all generations, by the table's address and the time. Another table
    /// (of a second copy of the library, or after an unload and a load) almost surely gets another one, so its keys are
    /// invalid here.
    #[cold]
    fn draw(&self) -> usize {
        const BITS: u32 = LAST_GENERATION.count_ones() - 1;
        let mark = time_mark() ^ (core::ptr::from_ref(self).addr() as u64).rotate_left(32);
        // Multiplicative hashing: the golden ratio of 2^64, the highest bits.
        let mixed = mark.wrapping_mul(SPLIT_MIX_STEP) >> (u64::BITS - BITS);
        LOWEST_GENERATION + mixed as usize
    }
}

#[cfg(not(target_family = "wasm"))]
fn time_mark() -> u64 {
    SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default().as_nanos() as u64
}

/// For the model checker Kani (`cargo kani`). Untried: compiled, but never run by Kani.
#[cfg(kani)]
mod proofs {
    use super::*;

    /// A key gives back what it is made of, so no two are equal.
    #[kani::proof]
    fn a_key_gives_back_its_kind_slot_and_generation() {
        let [generation, slot, kind]: [usize; 3] = kani::any();
        kani::assume(generation <= LAST_GENERATION && slot < SLOTS && kind < 1 << KIND_BITS);
        let key = key_of(generation, slot, kind);
        assert!(kind_of(key) == kind && slot_of(key) == slot);
        assert!(key >> (SLOT_BITS + KIND_BITS) == generation);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every kind and slot, with the first and the last generations: a key gives back what it is made of, so no two are equal.
    #[test]
    fn a_key_gives_back_its_kind_slot_and_generation() {
        for generation in [0, 1, LOWEST_GENERATION, LAST_GENERATION / 2, LAST_GENERATION - 1, LAST_GENERATION]
        {
            for slot in 0..SLOTS {
                for kind in 0..1 << KIND_BITS {
                    let key = key_of(generation, slot, kind);
                    assert_eq!((kind_of(key), slot_of(key)), (kind, slot), "{generation}");
                    assert_eq!(key >> (SLOT_BITS + KIND_BITS), generation);
                }
            }
        }
    }
}
