//! Two numbers in one register of the processor: one instruction computes with both. The bits are those of the plain operations.
//!
//! A [`Pair`](super::Pair) is two plain numbers, which ensembles join with the numbers of other runs. The compiler also joins plain
//! numbers into registers. But in a long formula it joins numbers of different pairs and has to separate them again: with pairs the
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
    /// The numbers `first` and `second`.
    #[inline(always)]
    pub fn new(first: f64, second: f64) -> Self {
        Self(register::new(first, second))
    }

    /// Both numbers are `x`.
    #[inline(always)]
    pub fn both(x: f64) -> Self {
        Self::new(x, x)
    }

    /// The first number.
    #[inline(always)]
    pub fn first(self) -> f64 {
        register::first(self.0)
    }

    /// The second number.
    #[inline(always)]
    pub fn second(self) -> f64 {
        register::second(self.0)
    }

    /// The first number of this and of `other`.
    #[inline(always)]
    pub fn firsts(self, other: Self) -> Self {
        Self(register::firsts(self.0, other.0))
    }

    /// The second number of this and of `other`.
    #[inline(always)]
    pub fn seconds(self, other: Self) -> Self {
        Self(register::seconds(self.0, other.0))
    }

    /// The first number plus the second.
    #[inline(always)]
    pub fn sum(self) -> f64 {
        self.first() + self.second()
    }

    /// The sum of the two numbers, in both places.
    #[inline(always)]
    pub fn sums(self) -> Self {
        self + Self(register::exchanged(self.0))
    }

    /// The square root of each number.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self(register::sqrt(self.0))
    }

    /// The absolute value of each number.
    #[inline(always)]
    pub fn abs(self) -> Self {
        Self(register::and_not(Self::both(-0.0).0, self.0))
    }

    /// The smaller number in each place; the number of `limit` if one of them is NaN.
    #[inline(always)]
    pub fn min(self, limit: Self) -> Self {
        Self(register::min(self.0, limit.0))
    }

    /// All bits set in each place where this is less than `other`, otherwise no bit.
    #[inline(always)]
    pub fn less(self, other: Self) -> Self {
        Self(register::less(self.0, other.0))
    }

    /// Whether both numbers are at most `limit`; false if one is NaN.
    #[inline(always)]
    pub fn at_most(self, limit: f64) -> bool {
        register::at_most(self.0, Self::both(limit).0)
    }
}
