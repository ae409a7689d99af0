//! Fowler, Noll and Vo's hash of 64 bits, FNV-1a.

/// The hash of the bytes so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fnv(u64);

impl Fnv {
    /// The hash of no byte.
    pub const NONE: Self = Self(0xcbf2_9ce4_8422_2325);

    pub fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    pub fn of(bytes: &[u8]) -> u64 {
        let mut hash = Self::NONE;
        hash.add(bytes);
        hash.0
    }

    pub fn value(self) -> u64 {
        self.0
    }
}
