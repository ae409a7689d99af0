//! Two numbers in one register of the processor: one instruction computes with both. The bits are those of the plain operations.
//!
//! A [`Pair`](super::Pair) is two plain numbers, which ensembles join with those of other runs. The compiler joins them into
//! registers by itself, but in a long formula it joins numbers of different pairs and has to separate them again: with pairs the
//! formulas of the reads take 15 to 25 % more instructions.

use core::ops::{Add, BitAnd, BitXor, Div, Mul, Sub};

use crate::register;

/// Two numbers.
#[derive(Debug, Clone, Copy)]
pub struct Two(register::Register);

macro_rules! operators {
    ($($trait:ident $method:ident,)*) => {$(
        impl $trait for Two {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(register::$method(self.0, other.0))
            }
        }
    )*};
}

// `&` and `^` work on the bits.
operators!(Add add, Sub sub, Mul mul, Div div, BitAnd bitand, BitXor bitxor,);

impl Mul<f64> for Two {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        self * Self::both(factor)
    }
}

impl Two {
    /// `first` and `second`.
    #[inline(always)]
    pub fn new(first: f64, second: f64) -> Self {
        Self(register::new(first, second))
    }

    /// Twice `x`.
    #[inline(always)]
    pub fn both(x: f64) -> Self {
        Self::new(x, x)
    }

    /// The first of the two.
    #[inline(always)]
    pub fn first(self) -> f64 {
        register::first(self.0)
    }

    /// The second of the two.
    #[inline(always)]
    pub fn second(self) -> f64 {
        register::second(self.0)
    }

    /// The first of each.
    #[inline(always)]
    pub fn firsts(self, other: Self) -> Self {
        Self(register::firsts(self.0, other.0))
    }

    /// The second of each.
    #[inline(always)]
    pub fn seconds(self, other: Self) -> Self {
        Self(register::seconds(self.0, other.0))
    }

    /// The first plus the second.
    #[inline(always)]
    pub fn sum(self) -> f64 {
        self.first() + self.second()
    }

    /// Their sum, twice.
    #[inline(always)]
    pub fn sums(self) -> Self {
        self + Self(register::exchanged(self.0))
    }

    /// The square roots.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self(register::sqrt(self.0))
    }

    /// The sizes.
    #[inline(always)]
    pub fn abs(self) -> Self {
        Self(register::and_not(Self::both(-0.0).0, self.0))
    }

    /// The smaller of each; `limit`, if one is no number.
    #[inline(always)]
    pub fn min(self, limit: Self) -> Self {
        Self(register::min(self.0, limit.0))
    }

    /// All bits set where this is less than `other`, else none.
    #[inline(always)]
    pub fn less(self, other: Self) -> Self {
        Self(register::less(self.0, other.0))
    }

    /// Whether both are at most `limit`; false if one is no number.
    #[inline(always)]
    pub fn at_most(self, limit: f64) -> bool {
        register::at_most(self.0, Self::both(limit).0)
    }
}
