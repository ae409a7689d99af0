//! The frequency at which motion and noise are equal, from the spectrum of the samples.
//!
//! Whittle's likelihood of the periodogram of the third differences, with the model S(f) = |2 sin π f T|⁶ (a f⁻ᵖ + n₀ + n₁/f): motion with
//! a steep spectrum, white noise and flicker. The third differences flatten the motion, so that it does not leak into the noise. The noise
//! of receivers is mostly flicker: cross-validation, which takes all noise for white, would believe it.

use core::f64::consts::PI;

use super::simplex::minimum;
use crate::base::error::Error;
use crate::base::math::{exp, ln, sin_cos};
use crate::base::memory::room;

/// Groups of frequencies, spaced by their logarithms.
const GROUPS: usize = 80;

/// Largest cut-off, in rates of the samples.
const LARGEST: f64 = 0.45;

/// Starts of the search: logarithm of a, p, logarithms of n₀ and n₁, each in units of the highest frequency and its power.
const STARTS: [[f64; 4]; 4] =
    [[-8.0, 6.0, 0.0, -2.0], [-4.0, 4.0, 0.0, -2.0], [-16.0, 6.0, -1.0, 0.0], [-12.0, 9.0, -1.0, -1.0]];

/// Bounds of the exponent p.
const EXPONENTS: (f64, f64) = (2.5, 14.0);

/// What a spectrum says about samples.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spectrum {
    /// Frequency at which motion and noise are equal [Hz].
    pub cutoff_hz: f64,
    /// White noise of a component, in the unit of the samples.
    pub white: f64,
}

/// A group of frequencies: mean frequency, mean |2 sin π f T|⁶, mean power, number of independent powers.
#[derive(Debug, Clone, Copy, Default)]
struct Group {
    hz: f64,
    gain: f64,
    power: f64,
    count: f64,
}

/// The spectrum of even samples, `period_s` [s] apart. There are at least 16.
pub(super) fn spectrum<const N: usize>(values: &[[f64; N]], period_s: f64) -> Result<Spectrum, Error> {
    let groups = groups(values, period_s)?;
    let [.., last] = groups.as_slice() else {
        return Ok(Spectrum { cutoff_hz: LARGEST / period_s, white: 0.0 });
    };
    let highest_hz = last.hz;
    let tail = &groups[groups.len().saturating_sub(12)..];
    let top = tail.iter().map(|group| group.power / group.gain).sum::<f64>() / tail.len() as f64
        + f64::MIN_POSITIVE;
    let parts = |x: &[f64; 4], hz: f64| {
        let ratio = hz / highest_hz;
        (exp(x[0] - x[1] * ln(ratio)) * top, (exp(x[2]) + exp(x[3]) / ratio) * top)
    };
    let cost = |x: &[f64; 4]| {
        let mut sum = 0.0;
        for group in &groups {
            let (motion, noise) = parts(x, group.hz);
            let model = group.gain * (motion + noise) + 1e-300;
            sum += group.count * (ln(model) + group.power / model);
        }
        let beyond = (EXPONENTS.0 - x[1]).max(x[1] - EXPONENTS.1).max(0.0);
        sum + 1e3 * beyond * beyond
    };
    let best = STARTS
        .map(|start| minimum(&cost, start))
        .into_iter()
        .reduce(|best, next| if next.1 < best.1 { next } else { best })
        .map_or(STARTS[0], |best| best.0);
    let below = groups.iter().rev().find(|group| {
        let (motion, noise) = parts(&best, group.hz);
        motion > noise
    });
    let cutoff_hz = below.map_or(groups[0].hz, |group| group.hz).min(LARGEST / period_s);
    Ok(Spectrum { cutoff_hz, white: (exp(best[2]) * top).sqrt() })
}

/// The groups of the periodogram of the third differences.
fn groups<const N: usize>(values: &[[f64; N]], period_s: f64) -> Result<Vec<Group>, Error> {
    let count = values.len().saturating_sub(3);
    let size = count.next_power_of_two().max(16);
    let mut powers: Vec<f64> = room(size / 2 + 1)?;
    powers.resize(size / 2 + 1, 0.0);
    let mut wave: Vec<[f64; 2]> = room(size)?;
    for k in 0..N {
        wave.clear();
        for (place, four) in values.windows(4).enumerate() {
            let third = four[3][k] - 3.0 * four[2][k] + 3.0 * four[1][k] - four[0][k];
            let window = 0.5 - 0.5 * sin_cos(2.0 * PI * (place + 1) as f64 / (count + 1) as f64).1;
            wave.push([third * window, 0.0]);
        }
        wave.resize(size, [0.0; 2]);
        transform(&mut wave);
        for (power, [re, im]) in powers.iter_mut().zip(&wave) {
            *power += (re * re + im * im) / (count as f64 * 0.375) / N as f64;
        }
    }
    // Powers of a padded record are not independent. The lowest two are the window's.
    let independent = count as f64 / size as f64 * N as f64;
    let first = (2 * size).div_ceil(count.max(1));
    let mut groups: Vec<Group> = room(GROUPS)?;
    let (mut group, mut last) = (Group::default(), first);
    let places = powers.len().saturating_sub(first).max(1) as f64;
    let ends = (1..=GROUPS).map(|k| exp(ln(places) * k as f64 / GROUPS as f64).round() as usize + first);
    for end in ends {
        for (place, power) in powers.iter().enumerate().take(end).skip(last) {
            let hz = place as f64 / (size as f64 * period_s);
            let sine = 2.0 * sin_cos(PI * hz * period_s).0;
            let gain = sine * sine * sine * sine * sine * sine;
            group.hz += hz;
            group.gain += gain;
            group.power += power;
            group.count += 1.0;
        }
        last = last.max(end);
        if group.count > 0.0 {
            let n = group.count;
            let mean = |sum: f64| sum / n;
            groups.push(Group {
                hz: mean(group.hz),
                gain: mean(group.gain),
                power: mean(group.power),
                count: n * independent,
            });
            group = Group::default();
        }
    }
    Ok(groups)
}

/// The discrete Fourier transform of 2ⁿ complex numbers, in place (Cooley and Tukey 1965). The crates for it choose their instructions at
/// run time, and so their bits.
fn transform(wave: &mut [[f64; 2]]) {
    let size = wave.len();
    let shift = usize::BITS - size.trailing_zeros();
    for k in 0..size {
        let mirrored = k.reverse_bits() >> shift;
        if k < mirrored {
            wave.swap(k, mirrored);
        }
    }
    let mut length = 2;
    while length <= size {
        let half = length / 2;
        for k in 0..half {
            let (sine, cosine) = sin_cos(-2.0 * PI * k as f64 / length as f64);
            for start in (k..size).step_by(length) {
                let ([a, b], [c, d]) = (wave[start], wave[start + half]);
                let [re, im] = [c * cosine - d * sine, c * sine + d * cosine];
                wave[start] = [a + re, b + im];
                wave[start + half] = [a - re, b - im];
            }
        }
        length *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_transform_is_that_of_the_definition() {
        let values: Vec<[f64; 2]> = (0..16).map(|k| [f64::from(k * k % 7), f64::from(k * 5 % 11)]).collect();
        let mut wave = values.clone();
        transform(&mut wave);
        for (k, found) in wave.iter().enumerate() {
            let mut sum = [0.0; 2];
            for (n, [a, b]) in values.iter().enumerate() {
                let (sine, cosine) = sin_cos(-2.0 * PI * (k * n % 16) as f64 / 16.0);
                sum = [sum[0] + a * cosine - b * sine, sum[1] + a * sine + b * cosine];
            }
            assert!((found[0] - sum[0]).abs() < 1e-12 && (found[1] - sum[1]).abs() < 1e-12, "{k}");
        }
    }
}
