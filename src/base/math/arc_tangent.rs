//! Arc tangent of several points at once, with the same bits as in the `libm` crate (FreeBSD msun, e_atan2.c and s_atan.c).

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use core::ops::{Add, Div, Mul, Sub};

use super::pair::Pair;

/// π less its value as a double.
const PI_REST: f64 = 1.224_646_799_147_353_2e-16;

/// Largest ratio that is computed here. For larger ratios and NaN the library is called, which has special rules for them.
const MAX_RATIO: f64 = (1_u64 << 60) as f64;

/// atan t = atan s + atan r, r = (c t - d)/(c + d t), s = d/c.
#[derive(Clone, Copy)]
struct Reduction {
    c: f64,
    d: f64,
    /// atan s as a double, and the rest that the double lacks.
    high: f64,
    rest: f64,
}

/// Reductions with s = 0, 1/2, 1, 3/2, ∞.
const REDUCTIONS: [Reduction; 5] = [
    Reduction { c: 1.0, d: 0.0, high: 0.0, rest: 0.0 },
    Reduction { c: 2.0, d: 1.0, high: 4.636_476_090_008_061e-1, rest: 2.269_877_745_296_168_7e-17 },
    Reduction { c: 1.0, d: 1.0, high: FRAC_PI_4, rest: 3.061_616_997_868_383e-17 },
    Reduction { c: 1.0, d: 1.5, high: 9.827_937_232_473_29e-1, rest: 1.390_331_103_123_099_8e-17 },
    Reduction { c: 0.0, d: 1.0, high: FRAC_PI_2, rest: 6.123_233_995_736_766e-17 },
];

/// Reduction for each nearest integer to 8 t. The reductions begin at t = 0, 7/16, 11/16, 19/16, 39/16. At these bounds (except for
/// 0) 8 t is halfway between two integers, and the even integer, to which it is rounded, is the upper one.
static BY_EIGHTHS: [Reduction; 32] = {
    let mut by_eighths = [REDUCTIONS[4]; 32];
    let mut eighths = 0;
    while eighths < LAST_BEGINS {
        let index = (eighths >= 4) as usize + (eighths >= 6) as usize + (eighths >= 10) as usize;
        by_eighths[eighths] = REDUCTIONS[index];
        eighths += 1;
    }
    by_eighths
};
const LAST_BEGINS: usize = 20;

/// Adding it leaves the nearest integer in the last bits.
const ROUND: f64 = 6_755_399_441_055_744.0; // 1.5 · 2^52

/// (r - atan r)/r as a polynomial in r², in two parts: odd and even powers of r².
const ODD: [f64; 6] = [
    3.333_333_333_333_293e-1,
    1.428_571_427_250_346_6e-1,
    9.090_887_133_436_507e-2,
    6.661_073_137_387_531e-2,
    4.976_877_994_615_932e-2,
    1.628_582_011_536_578_2e-2,
];
const EVEN: [f64; 5] = [
    -1.999_999_999_987_648_3e-1,
    -1.111_111_040_546_235_6e-1,
    -7.691_876_205_044_83e-2,
    -5.833_570_133_790_573_5e-2,
    -3.653_157_274_421_691_6e-2,
];

/// One number, or two at once.
trait OneOrTwo: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> {
    fn of(x: f64) -> Self;

    /// c, d, high and rest of the reductions for these ratios.
    fn reductions(self) -> [Self; 4];
}

impl OneOrTwo for f64 {
    #[inline(always)]
    fn of(x: f64) -> Self {
        x
    }

    #[inline(always)]
    fn reductions(self) -> [Self; 4] {
        let last = LAST_BEGINS as f64 / 8.0;
        let eighths = (8.0 * if self < last { self } else { last } + ROUND).to_bits();
        let Reduction { c, d, high, rest } = BY_EIGHTHS[eighths as usize % BY_EIGHTHS.len()];
        [c, d, high, rest]
    }
}

impl OneOrTwo for Pair {
    #[inline(always)]
    fn of(x: f64) -> Self {
        Self::both(x)
    }

    #[inline(always)]
    fn reductions(self) -> [Self; 4] {
        let eighths = self.min(Self::both(LAST_BEGINS as f64 / 8.0)) * 8.0 + Self::both(ROUND);
        let of = |eighths: f64| &BY_EIGHTHS[eighths.to_bits() as usize % BY_EIGHTHS.len()];
        let (one, other) = (of(eighths.first()), of(eighths.second()));
        let (one_begin, other_begin) = (Self::new(one.c, one.d), Self::new(other.c, other.d));
        let (one_end, other_end) = (Self::new(one.high, one.rest), Self::new(other.high, other.rest));
        [
            one_begin.firsts(other_begin),
            one_begin.seconds(other_begin),
            one_end.firsts(other_end),
            one_end.seconds(other_end),
        ]
    }
}

/// The arc tangent of a ratio from 0 to [`MAX_RATIO`].
#[inline(always)]
fn of_ratio<T: OneOrTwo>(t: T) -> T {
    let [c, d, high, rest] = t.reductions();
    let r = (c * t - d) / (c + d * t);
    let z = r * r;
    let w = z * z;
    let (mut odd, mut even) = (T::of(ODD[5]), T::of(EVEN[4]));
    for k in (0..5).rev() {
        odd = T::of(ODD[k]) + w * odd;
    }
    for k in (0..4).rev() {
        even = T::of(EVEN[k]) + w * even;
    }
    high - ((r * (z * odd + w * even) - rest) - r)
}

/// Angles of two points (`x`, `y`) [rad], -π to π.
#[inline(always)]
pub fn atan2_of_two(y: Pair, x: Pair) -> Pair {
    let t = (y / x).abs();
    if !t.at_most(MAX_RATIO) {
        return Pair::new(of_special(y.first(), x.first()), of_special(y.second(), x.second()));
    }
    // For a negative x the angle is π - (atan t - rest of π). For other x, atan t - 0 + 0 keeps the bits of atan t.
    let (behind, sign) = (x.less(Pair::both(0.0)), Pair::both(-0.0));
    let less_rest = of_ratio(t) - (Pair::both(PI_REST) & behind);
    let turned = (less_rest ^ (x & sign)) + (Pair::both(PI) & behind);
    turned.abs() ^ (y & sign)
}

/// Angle of a point (`x`, `y`) whose coordinates are not negative [rad], 0 to π/2.
#[inline(always)]
pub fn atan2_of_positive(y: f64, x: f64) -> f64 {
    let t = y / x;
    // The comparison is also false for NaN.
    if t <= MAX_RATIO { of_ratio(t) } else { of_special(y, x) }
}

#[cold]
#[inline(never)]
fn of_special(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math::{SPLIT_MIX_STEP, mix};

    /// Compares with the library's result bit for bit. A NaN may have any bits.
    fn check_one(found: f64, y: f64, x: f64) {
        let expected = libm::atan2(y, x);
        let same = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
        assert!(same, "atan2({y:e}, {x:e}): {found:e} {expected:e}");
    }

    fn check_two(y: [f64; 2], x: [f64; 2]) {
        let found = atan2_of_two(Pair::new(y[0], y[1]), Pair::new(x[0], x[1]));
        check_one(found.first(), y[0], x[0]);
        check_one(found.second(), y[1], x[1]);
    }

    fn check(y: f64, x: f64) {
        check_two([y, y], [x, -x]);
        check_two([0.3, -y], [-0.7, x]);
        check_one(atan2_of_positive(y.abs(), x.abs()), y.abs(), x.abs());
    }

    #[test]
    fn the_bits_of_the_library_everywhere() {
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_add(SPLIT_MIX_STEP);
            mix(state)
        };
        for _ in 0..1_000_000 {
            // Any bits; ratios near 1; ratios of all sizes that are not special.
            check(f64::from_bits(random()), f64::from_bits(random()));
            let [y, x] = [random(), random()].map(|bits| bits.cast_signed() as f64);
            check(y, x);
            check(y * f64::from_bits((random() % 134 + 956) << 52), x);
        }
    }

    #[test]
    fn the_bits_of_the_library_at_the_bounds_and_at_special_numbers() {
        let bounds = [7.0 / 16.0, 11.0 / 16.0, 19.0 / 16.0, 39.0 / 16.0, 2.5, MAX_RATIO, 1.0, 2f64.powi(-27)];
        for bound in bounds {
            for ulps in 0..8 {
                check(f64::from_bits(bound.to_bits() + ulps), 1.0);
                check(f64::from_bits(bound.to_bits() - ulps), 1.0);
                check(3.0 * f64::from_bits(bound.to_bits() - ulps), 3.0);
            }
        }
        let special = [0.0, 5e-324, 2.2e-308, 1e-300, 1.0, 3.0, 1e300, f64::MAX, f64::INFINITY, f64::NAN];
        for y in special {
            for x in special {
                check(y, x);
            }
        }
    }

    #[test]
    fn points_of_one_call_do_not_meet() {
        check_two([0.1, f64::INFINITY], [-2.0, 1.0]);
        check_two([-3.0, 0.1], [0.0, -2.0]);
    }
}
