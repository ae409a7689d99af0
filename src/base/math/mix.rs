//! Mixing of 64-bit words.

/// Step of SplitMix64: 2^64 over the golden ratio.
pub const SPLIT_MIX_STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// Step and finalizer of SplitMix64 (Steele, Lea and Flood 2014): one to one, and every bit of the input affects every bit of
/// the output.
#[inline]
pub fn mix(x: u64) -> u64 {
    let mut z = x.wrapping_add(SPLIT_MIX_STEP);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
