//! Quantiles of the normal and the chi-square distribution.

use core::f64::consts::{PI, SQRT_2};

use super::transcendental::{erfc, exp, ln, ln_gamma};

/// Number of degrees of freedom above which the approximation of Wilson and Hilferty is used alone. There its error is below 2e-4
/// of the quantile, from 0.1 % to 99.9 %.
const MANY: f64 = 300.0;

/// z with Φ(z) = `probability`, for a probability between 0 and 1.
pub fn normal_quantile(probability: f64) -> f64 {
    // Abramowitz and Stegun 26.2.23, accurate to 4.5e-4, then Newton's steps.
    let tail = probability.min(1.0 - probability);
    let t = (-2.0 * ln(tail)).sqrt();
    let start = t
        - (2.515_517 + t * (0.802_853 + t * 0.010_328))
            / (1.0 + t * (1.432_788 + t * (0.189_269 + t * 0.001_308)));
    let z = (0..3).fold(start, |z, _| {
        let excess = 0.5 * erfc(z / SQRT_2) - tail;
        z + excess * (2.0 * PI).sqrt() * exp(0.5 * z * z)
    });
    if probability < 0.5 { -z } else { z }
}

/// χ²/ν at the normal quantile `z`, for ν = `degrees` of freedom: (1 - 2/(9ν) + z √(2/(9ν)))³ (Wilson and Hilferty 1931).
pub fn wilson_hilferty(z: f64, degrees: f64) -> f64 {
    let spread = 2.0 / (9.0 * degrees);
    let root = 1.0 - spread + z * spread.sqrt();
    root * root * root
}

/// Value below which χ² is with the given `probability`, for ν = `degrees` of freedom, any positive number. Its relative error is
/// 1e-9 up to 300 degrees.
pub fn chi_square_quantile(probability: f64, degrees: f64) -> f64 {
    let approximate = degrees * wilson_hilferty(normal_quantile(probability), degrees);
    if degrees > MANY {
        return approximate;
    }
    // ln P is a concave function of ln x, so that Newton's steps reach the root from any start.
    let a = 0.5 * degrees;
    let mut logarithm = ln((0.5 * approximate).max(1e-3 * a));
    for _ in 0..100 {
        let x = exp(logarithm);
        let p = lower_gamma(a, x);
        let density = exp(a * logarithm - x - ln_gamma(a));
        let step = p / density * ln(p / probability);
        logarithm -= step;
        if step.abs() < 1e-10 {
            break;
        }
    }
    2.0 * exp(logarithm)
}

/// Incomplete gamma function P(a, x): by its series for small x, by Lentz's continued fraction of 1 - P for large x (Abramowitz and
/// Stegun 6.5.29, 6.5.31).
fn lower_gamma(a: f64, x: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    let factor = exp(a * ln(x) - x - ln_gamma(a));
    if x < a + 1.0 {
        let (mut term, mut sum, mut n) = (1.0 / a, 1.0 / a, a);
        while term > 1e-16 * sum {
            n += 1.0;
            term *= x / n;
            sum += term;
        }
        return factor * sum;
    }
    let mut b = x + 1.0 - a;
    let (mut c, mut d) = (1e300, 1.0 / b);
    let mut fraction = d;
    for k in 1..1000 {
        let k = f64::from(k);
        let numerator = -k * (k - a);
        b += 2.0;
        d = 1.0 / (numerator * d + b);
        c = b + numerator / c;
        fraction *= c * d;
        if (c * d - 1.0).abs() < 1e-15 {
            break;
        }
    }
    1.0 - factor * fraction
}
