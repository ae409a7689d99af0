//! The generator behind the random streams.

use crate::error::Rule;
use crate::math::{SPLIT_MIX_STEP, mix};
use crate::snapshot::{ANY, stored};

/// xoshiro256++ 1.0 (Blackman and Vigna 2019). It gives the same numbers on every machine and in every release. A snapshot can keep
/// its state, which `rand_xoshiro` does not expose.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Xoshiro256PlusPlus {
    /// Not all zero: the generator never leaves that state.
    state: [u64; 4],
}

stored!(Xoshiro256PlusPlus { state: ANY } then |generator, from| match generator.state {
    [0, 0, 0, 0] => Err(from.refused(0.0, Rule::Sentence("is a state that the generator never has"))),
    _ => Ok(()),
});

impl Xoshiro256PlusPlus {
    /// The state that the authors recommend for a seed of one word: four numbers of SplitMix64.
    pub fn seeded(seed: u64) -> Self {
        Self { state: [0, 1, 2, 3].map(|k: u64| mix(seed.wrapping_add(k.wrapping_mul(SPLIT_MIX_STEP)))) }
    }

    /// A generator with the state `state`, which [`Self::words`] gave.
    #[inline(always)]
    pub fn of_words(state: [u64; 4]) -> Self {
        Self { state }
    }

    /// The state.
    #[inline(always)]
    pub fn words(&self) -> [u64; 4] {
        self.state
    }

    /// A generator whose next word is `word`: rotl(a + d, 23) + a with a = 0.
    #[cfg(test)]
    pub fn about_to_give(word: u64, others: &mut Self) -> Self {
        Self { state: [0, others.next_u64(), others.next_u64(), word.rotate_right(23)] }
    }

    /// The next word. Its upper bits are of better quality than its lower bits.
    #[inline(always)]
    pub fn next_u64(&mut self) -> u64 {
        let [a, b, c, d] = &mut self.state;
        let number = a.wrapping_add(*d).rotate_left(23).wrapping_add(*a);
        let shifted = *b << 17;
        *c ^= *a;
        *d ^= *b;
        *b ^= *c;
        *a ^= *d;
        *c ^= shifted;
        *d = d.rotate_left(45);
        number
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_xoshiro::rand_core::{Rng, SeedableRng};

    #[test]
    fn it_is_the_generator_of_the_reference() {
        for seed in [0, 1, 20_140_601, u64::MAX] {
            let mut ours = Xoshiro256PlusPlus::seeded(seed);
            let mut reference = rand_xoshiro::Xoshiro256PlusPlus::seed_from_u64(seed);
            for _ in 0..1000 {
                assert_eq!(ours.next_u64(), reference.next_u64());
            }
        }
    }
}
