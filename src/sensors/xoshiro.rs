//! The generator behind the random streams.

use core::convert::Infallible;

use rand::rand_core::utils::{fill_bytes_via_next_word, read_words};
use rand::{SeedableRng, TryRng};

use crate::base::error::Rule;
use crate::base::math::{SPLIT_MIX_STEP, mix};
use crate::base::snapshot::{ANY, stored};

/// xoshiro256++ 1.0 (Blackman and Vigna 2019), a generator of `rand`. It gives the same numbers on every machine and in every release.
///
/// It is not that of `rand_xoshiro`, which shows its state only as text by `serde`: snapshots keep the state, and ensembles compute with
/// the states of 16 runs in rows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Xoshiro256PlusPlus {
    /// Not all zero: the generator never leaves that state.
    state: [u64; 4],
}

stored!(Xoshiro256PlusPlus { state: ANY } then |generator, from| match generator.state {
    [0, 0, 0, 0] => Err(from.refused(0.0, Rule::Sentence("is a state that the generator never has"))),
    _ => Ok(()),
});

impl Xoshiro256PlusPlus {
    /// A generator with the state `state`, which [`Self::words`] gave.
    #[inline(always)]
    pub(super) fn of_words(state: [u64; 4]) -> Self {
        Self { state }
    }

    /// The state.
    #[inline(always)]
    pub(super) fn words(&self) -> [u64; 4] {
        self.state
    }

    /// A generator whose next word is `word`: rotl(a + d, 23) + a with a = 0.
    #[cfg(test)]
    pub(super) fn about_to_give(word: u64, others: &mut Self) -> Self {
        use rand::Rng;
        Self { state: [0, others.next_u64(), others.next_u64(), word.rotate_right(23)] }
    }
}

impl TryRng for Xoshiro256PlusPlus {
    type Error = Infallible;

    /// The upper half of a word, whose bits are of better quality than those of the lower half.
    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        self.try_next_u64().map(|word| (word >> 32) as u32)
    }

    #[inline(always)]
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        let [a, b, c, d] = &mut self.state;
        let number = a.wrapping_add(*d).rotate_left(23).wrapping_add(*a);
        let shifted = *b << 17;
        *c ^= *a;
        *d ^= *b;
        *b ^= *c;
        *a ^= *d;
        *c ^= shifted;
        *d = d.rotate_left(45);
        Ok(number)
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        fill_bytes_via_next_word(bytes, || self.try_next_u64())
    }
}

impl SeedableRng for Xoshiro256PlusPlus {
    type Seed = [u8; 32];

    /// The state of these bytes; 32 zeros, which the generator never has, as the seed 0 of one word.
    fn from_seed(seed: [u8; 32]) -> Self {
        match read_words(&seed) {
            [0, 0, 0, 0] => Self::seed_from_u64(0),
            state => Self { state },
        }
    }

    /// The state that the authors recommend for a seed of one word: four numbers of SplitMix64.
    fn seed_from_u64(seed: u64) -> Self {
        Self { state: [0, 1, 2, 3].map(|k: u64| mix(seed.wrapping_add(k.wrapping_mul(SPLIT_MIX_STEP)))) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::Rng;

    #[test]
    fn it_is_the_generator_of_the_reference() {
        for seed in [0, 1, 20_140_601, u64::MAX] {
            let bytes = [seed.to_le_bytes(); 4].as_flattened().try_into().unwrap();
            let pairs = [
                (
                    Xoshiro256PlusPlus::seed_from_u64(seed),
                    rand_xoshiro::Xoshiro256PlusPlus::seed_from_u64(seed),
                ),
                (Xoshiro256PlusPlus::from_seed(bytes), rand_xoshiro::Xoshiro256PlusPlus::from_seed(bytes)),
            ];
            for (mut ours, mut reference) in pairs {
                for _ in 0..1000 {
                    assert_eq!(ours.next_u64(), reference.next_u64());
                    assert_eq!(ours.next_u32(), reference.next_u32());
                }
                let (mut own_bytes, mut their_bytes) = ([0; 13], [0; 13]);
                ours.fill_bytes(&mut own_bytes);
                reference.fill_bytes(&mut their_bytes);
                assert_eq!(own_bytes, their_bytes);
            }
        }
    }
}
