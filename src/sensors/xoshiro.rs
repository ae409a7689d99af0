//! The generator behind the random streams.

use core::convert::Infallible;

use rand::TryRng;

use crate::error::Rule;
use crate::math::{SPLIT_MIX_STEP, mix};
use crate::snapshot::{ANY, stored};

/// xoshiro256++ 1.0 (Blackman and Vigna 2019): the same numbers on every machine and in every release, and a state that a
/// snapshot can keep, which `rand_xoshiro` does not show.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Xoshiro256PlusPlus {
    /// Not all zero: from there the generator never moves.
    state: [u64; 4],
}

stored!(Xoshiro256PlusPlus { state: ANY } then |generator, from| match generator.state {
    [0, 0, 0, 0] => Err(from.refused(0.0, Rule::Words("is a state that the generator never has"))),
    _ => Ok(()),
});

impl Xoshiro256PlusPlus {
    /// The state that the authors recommend for a seed of one word: four numbers of SplitMix64.
    pub fn seeded(seed: u64) -> Self {
        Self { state: [0, 1, 2, 3].map(|k: u64| mix(seed.wrapping_add(k.wrapping_mul(SPLIT_MIX_STEP)))) }
    }

    #[inline]
    fn next(&mut self) -> u64 {
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

impl TryRng for Xoshiro256PlusPlus {
    type Error = Infallible;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        // The upper bits are the better ones.
        Ok((self.next() >> 32) as u32)
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        Ok(self.next())
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        for chunk in bytes.chunks_mut(8) {
            let number = self.next().to_le_bytes();
            chunk.copy_from_slice(&number[..chunk.len()]);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{Rng, SeedableRng};

    #[test]
    fn it_is_the_generator_of_the_reference() {
        for seed in [0, 1, 20_140_601, u64::MAX] {
            let mut ours = Xoshiro256PlusPlus::seeded(seed);
            let mut reference = rand_xoshiro::Xoshiro256PlusPlus::seed_from_u64(seed);
            for _ in 0..1000 {
                assert_eq!(ours.next_u64(), reference.next_u64());
                assert_eq!(ours.next_u32(), reference.next_u32());
            }
            let (mut some, mut same) = ([0; 13], [0; 13]);
            ours.fill_bytes(&mut some);
            reference.fill_bytes(&mut same);
            assert_eq!(some, same);
        }
    }
}
