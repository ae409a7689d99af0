//! Sine and cosine, of several angles at once.

use core::f64::consts::FRAC_2_PI;

/// π/2 as the sum of three parts: 33 bits, 33 bits, the rest. The product of each of the first two parts with a number of quarter
/// turns below 2^20 is exact.
const HALF_PI: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];

/// Adding and then subtracting it leaves the nearest integer. After the addition this integer is in the last bits.
const ROUND: f64 = 6_755_399_441_055_744.0; // 1.5 · 2^52

/// Nearest integer to `x`, ties to even, for |x| up to 2^51. Not `f64::round_ties_even`, which calls the platform's `rint`: the
/// `rint` of mingw rounds with the x87 unit, in the mode that the host has set.
#[inline]
pub fn nearest_integer(x: f64) -> f64 {
    (x + ROUND) - ROUND
}

/// Size of an angle above which the reduction is no longer exact [rad].
const MAX_ANGLE: f64 = 1e5;

/// (sin r - r)/r³ and (cos r - 1 + r²/2)/r⁴ as polynomials in r² for |r| ≤ π/4, to 2^-58 (FreeBSD msun, k_sin.c, k_cos.c).
const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Sines and cosines of `angles` [rad], to an ulp. There is no branch on each angle, so that the compiler computes two at a
/// time: five angles take as long as one and a half single calls.
#[inline(never)]
pub fn sin_cos_each<const N: usize>(angles: &[f64; N]) -> ([f64; N], [f64; N]) {
    sin_cos_each_inlined(angles)
}

/// `sin_cos_each` without a call, for code that is compiled for each instruction set.
#[inline(always)]
pub fn sin_cos_each_inlined<const N: usize>(angles: &[f64; N]) -> ([f64; N], [f64; N]) {
    let mut sizes = [0.0; 2];
    for i in 0..N {
        sizes[i % 2] += angles[i].abs();
    }
    // Most often the sum of the sizes shows that all angles are in range: one comparison.
    let are_in_range = sizes[0] + sizes[1] < MAX_ANGLE || angles.iter().all(|angle| angle.abs() < MAX_ANGLE);
    if !are_in_range {
        return sin_cos_of_large(angles);
    }
    let mut quarter = [0u64; N];
    let (mut rest, mut tail) = ([0.0; N], [0.0; N]);
    for i in 0..N {
        let rounded = angles[i] * FRAC_2_PI + ROUND;
        quarter[i] = rounded.to_bits();
        let turns = rounded - ROUND;
        let first = angles[i] - turns * HALF_PI[0];
        let second = turns * HALF_PI[1];
        let high = first - second;
        let low = ((first - high) - second) - turns * HALF_PI[2];
        rest[i] = high + low;
        tail[i] = (high - rest[i]) + low;
    }
    let (mut sines, mut cosines) = ([0.0; N], [0.0; N]);
    for i in 0..N {
        let (sine, cosine) = (sine_of_rest(rest[i], tail[i]), cosine_of_rest(rest[i], tail[i]));
        // Odd quarters exchange sine and cosine. The sine changes sign in the quarters 2 and 3, the cosine in 1 and 2.
        let odd = 0u64.wrapping_sub(quarter[i] & 1);
        let exchange = (sine.to_bits() ^ cosine.to_bits()) & odd;
        sines[i] = f64::from_bits(sine.to_bits() ^ exchange ^ ((quarter[i] & 2) << 62));
        cosines[i] = f64::from_bits(cosine.to_bits() ^ exchange ^ ((quarter[i].wrapping_add(1) & 2) << 62));
    }
    (sines, cosines)
}

#[cold]
fn sin_cos_of_large<const N: usize>(angles: &[f64; N]) -> ([f64; N], [f64; N]) {
    (angles.map(libm::sin), angles.map(libm::cos))
}

/// sin(r + t), |r| ≤ π/4, t below an ulp of r.
#[inline(always)]
fn sine_of_rest(r: f64, t: f64) -> f64 {
    let [s1, s2, s3, s4, s5, s6] = SINE;
    let z = r * r;
    let cube = z * r;
    let higher = s2 + z * (s3 + z * (s4 + z * (s5 + z * s6)));
    r - ((z * (0.5 * t - cube * higher) - t) - cube * s1)
}

/// cos(r + t)
#[inline(always)]
fn cosine_of_rest(r: f64, t: f64) -> f64 {
    let [c1, c2, c3, c4, c5, c6] = COSINE;
    let z = r * r;
    let higher = z * (c1 + z * (c2 + z * (c3 + z * (c4 + z * (c5 + z * c6)))));
    // 1 - z/2, and the part that its rounding drops.
    let half = 0.5 * z;
    let high = 1.0 - half;
    high + (((1.0 - high) - half) + (z * higher - r * t))
}
