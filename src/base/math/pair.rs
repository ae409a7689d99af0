//! Two numbers, and two vectors, that go through the same formula at once. The compiler computes both with one instruction where
//! the processor has such instructions (SSE2, NEON). The bits are everywhere the same as with the plain formula.

use core::ops::{Add, AddAssign, BitAnd, BitXor, Div, Mul, Sub};

use nalgebra::{Matrix3, Vector3};

/// Two numbers side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair(pub [f64; 2]);

impl Pair {
    /// Two zeros.
    pub const ZERO: Self = Self([0.0; 2]);

    /// Twice the number `x`.
    #[inline(always)]
    pub fn both(x: f64) -> Self {
        Self([x; 2])
    }

    /// The numbers `first` and `second`.
    #[inline(always)]
    pub fn new(first: f64, second: f64) -> Self {
        Self([first, second])
    }

    /// The first number.
    #[inline(always)]
    pub fn first(self) -> f64 {
        self.0[0]
    }

    /// The second number.
    #[inline(always)]
    pub fn second(self) -> f64 {
        self.0[1]
    }

    /// The first number of this and of `other`.
    #[inline(always)]
    pub fn firsts(self, other: Self) -> Self {
        Self([self.0[0], other.0[0]])
    }

    /// The second number of this and of `other`.
    #[inline(always)]
    pub fn seconds(self, other: Self) -> Self {
        Self([self.0[1], other.0[1]])
    }

    /// The sum of the two numbers, in both places.
    #[inline(always)]
    pub fn sums(self) -> Self {
        self + Self([self.0[1], self.0[0]])
    }

    /// The absolute value of each number.
    #[inline(always)]
    pub fn abs(self) -> Self {
        Self([self.0[0].abs(), self.0[1].abs()])
    }

    /// The smaller number in each place; the number of `limit` if one of them is NaN.
    #[inline(always)]
    pub fn min(self, limit: Self) -> Self {
        let of = |x: f64, limit: f64| if x < limit { x } else { limit };
        Self([of(self.0[0], limit.0[0]), of(self.0[1], limit.0[1])])
    }

    /// All bits set in each place where this is less than `other`, otherwise no bit.
    #[inline(always)]
    pub fn less(self, other: Self) -> Self {
        let of = |x: f64, y: f64| f64::from_bits(u64::from(x < y).wrapping_neg());
        Self([of(self.0[0], other.0[0]), of(self.0[1], other.0[1])])
    }

    /// Whether both numbers are at most `limit`; false if one is NaN.
    #[inline(always)]
    pub fn at_most(self, limit: f64) -> bool {
        self.0[0] <= limit && self.0[1] <= limit
    }

    /// The larger of the two numbers.
    #[inline(always)]
    pub fn max(self) -> f64 {
        if self.0[0] > self.0[1] { self.0[0] } else { self.0[1] }
    }

    /// The square root of each number.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self([self.0[0].sqrt(), self.0[1].sqrt()])
    }

    /// The sum of the two numbers.
    #[inline(always)]
    pub fn sum(self) -> f64 {
        self.0[0] + self.0[1]
    }
}

#[inline(always)]
fn both_bits(x: f64, y: f64) -> f64 {
    f64::from_bits(x.to_bits() & y.to_bits())
}

#[inline(always)]
fn other_bits(x: f64, y: f64) -> f64 {
    f64::from_bits(x.to_bits() ^ y.to_bits())
}

macro_rules! operators {
    ($($trait:ident $method:ident of $type:ident: |$one:ident, $other:ident| $value:expr;)*) => {$(
        impl $trait for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(self, $other: Self) -> Self {
                let $one = self;
                $value
            }
        }
    )*};
}

operators! {
    Add add of Pair: |a, b| Self([a.0[0] + b.0[0], a.0[1] + b.0[1]]);
    Sub sub of Pair: |a, b| Self([a.0[0] - b.0[0], a.0[1] - b.0[1]]);
    Mul mul of Pair: |a, b| Self([a.0[0] * b.0[0], a.0[1] * b.0[1]]);
    Div div of Pair: |a, b| Self([a.0[0] / b.0[0], a.0[1] / b.0[1]]);
    // Of the bits.
    BitAnd bitand of Pair: |a, b| Self([both_bits(a.0[0], b.0[0]), both_bits(a.0[1], b.0[1])]);
    BitXor bitxor of Pair: |a, b| Self([other_bits(a.0[0], b.0[0]), other_bits(a.0[1], b.0[1])]);
    Add add of VectorPair: |a, b| Self { x: a.x + b.x, y: a.y + b.y, z: a.z + b.z };
    Sub sub of VectorPair: |a, b| Self { x: a.x - b.x, y: a.y - b.y, z: a.z - b.z };
}

impl Mul<f64> for Pair {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        Self([self.0[0] * factor, self.0[1] * factor])
    }
}

/// Two vectors side by side, component by component.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VectorPair {
    /// The x components of the two vectors.
    pub x: Pair,
    /// The y components of the two vectors.
    pub y: Pair,
    /// The z components of the two vectors.
    pub z: Pair,
}

impl VectorPair {
    /// Two zero vectors.
    pub const ZERO: Self = Self { x: Pair::ZERO, y: Pair::ZERO, z: Pair::ZERO };

    /// The vectors `first` and `second`.
    #[inline(always)]
    pub fn new(first: &Vector3<f64>, second: &Vector3<f64>) -> Self {
        let pair = |i: usize| Pair([first[i], second[i]]);
        Self { x: pair(0), y: pair(1), z: pair(2) }
    }

    /// Twice the vector `v`.
    #[inline(always)]
    pub fn both(v: &Vector3<f64>) -> Self {
        Self::new(v, v)
    }

    /// The first vector.
    #[inline(always)]
    pub fn first(&self) -> Vector3<f64> {
        Vector3::new(self.x.0[0], self.y.0[0], self.z.0[0])
    }

    /// The second vector.
    #[inline(always)]
    pub fn second(&self) -> Vector3<f64> {
        Vector3::new(self.x.0[1], self.y.0[1], self.z.0[1])
    }

    /// The sum of the two vectors.
    #[inline(always)]
    pub fn sum(&self) -> Vector3<f64> {
        Vector3::new(self.x.sum(), self.y.sum(), self.z.sum())
    }

    /// The matrix times each vector.
    #[inline(always)]
    pub fn of_matrix(matrix: &Matrix3<f64>, pair: &Self) -> Self {
        let row = |i: usize| {
            pair.x * Pair::both(matrix[(i, 0)])
                + pair.y * Pair::both(matrix[(i, 1)])
                + pair.z * Pair::both(matrix[(i, 2)])
        };
        Self { x: row(0), y: row(1), z: row(2) }
    }

    /// The first vector times the first factor, and the second vector times the second factor.
    #[inline(always)]
    pub fn times(&self, factors: Pair) -> Self {
        Self { x: self.x * factors, y: self.y * factors, z: self.z * factors }
    }

    /// The cross product of the first vectors, and of the second vectors.
    #[inline(always)]
    pub fn cross(&self, other: &Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    /// The scalar product of the first vectors, and of the second vectors.
    #[inline(always)]
    pub fn dot(&self, other: &Self) -> Pair {
        self.x * other.x + self.y * other.y + self.z * other.z
    }
}

impl AddAssign for VectorPair {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
