//! Quantiles of the normal and the chi-square distribution.

use core::f64::consts::{PI, SQRT_2};

use libm::{erfc, lgamma as ln_gamma};
use sins::math::{exp, ln, wilson_hilferty};

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_quantiles_are_those_of_the_tables() {
        for (probability, z) in
            [(0.5, 0.0), (0.975, 1.959_963_984_540), (0.025, -1.959_963_984_540), (0.999, 3.090_232_306_168)]
        {
            assert!((normal_quantile(probability) - z).abs() < 1e-11, "{probability}");
        }
    }

    /// Abramowitz and Stegun, table 26.8.
    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (probability, degrees, value) in [
            (0.005, 1.0, 3.927_042_22e-5),
            (0.025, 1.0, 9.820_691_17e-4),
            (0.975, 1.0, 5.023_886_19),
            (0.025, 3.0, 0.215_795_283),
            (0.025, 10.0, 3.246_972_78),
            (0.975, 10.0, 20.483_177_4),
            (0.975, 100.0, 129.561_197),
        ] {
            let found = chi_square_quantile(probability, degrees);
            assert!((found / value - 1.0).abs() < 1e-8, "{probability} {degrees}: {found}");
        }
    }

    /// With two degrees of freedom χ² has an exponential distribution.
    #[test]
    fn two_degrees_are_in_closed_form() {
        for probability in [1e-9, 1e-4, 0.3, 0.7, 0.9999] {
            let found = chi_square_quantile(probability, 2.0);
            assert!((found / (-2.0 * (-probability).ln_1p()) - 1.0).abs() < 1e-9, "{probability}");
        }
    }

    #[test]
    fn both_methods_meet() {
        for probability in [0.001, 0.025, 0.5, 0.975, 0.999] {
            let (exact, cube) = (
                chi_square_quantile(probability, MANY),
                chi_square_quantile(probability, MANY * (1.0 + 1e-12)),
            );
            assert!((cube / exact - 1.0).abs() < 2e-4, "{probability}: {cube} {exact}");
        }
    }
}
