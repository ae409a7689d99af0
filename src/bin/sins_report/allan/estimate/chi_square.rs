//! Quantiles of the normal and the chi-square distribution.

use std::f64::consts::SQRT_2;

/// Above so many degrees of freedom the cube of Wilson and Hilferty (1931) stands alone: its error is below 1e-5 of the
/// quantile there, from 0.1 % to 99.9 %.
const MANY: f64 = 300.0;

/// z with Φ(z) = `probability`.
pub fn normal_quantile(probability: f64) -> f64 {
    let below = |z: f64| 0.5 * libm::erfc(-z / SQRT_2) < probability;
    bisected(-38.0, 38.0, below)
}

/// χ² with so many `degrees` of freedom, any positive number, that stays below it with `probability`; to 1e-9 of itself.
pub fn chi_square_quantile(probability: f64, degrees: f64) -> f64 {
    let spread = 2.0 / (9.0 * degrees);
    let cube = degrees * (1.0 - spread + normal_quantile(probability) * spread.sqrt()).max(0.0).powi(3);
    if degrees > MANY {
        return cube;
    }
    let below = |x: f64| lower_gamma(0.5 * degrees, 0.5 * x) < probability;
    let (mut low, mut high) = (0.9 * cube, 1.1 * cube + 1e-300);
    while low > 0.0 && !below(low) {
        low *= 0.5;
    }
    while below(high) {
        high *= 2.0;
    }
    bisected(low, high, below)
}

/// Where `below` turns false between `low` and `high`.
pub fn bisected(mut low: f64, mut high: f64, below: impl Fn(f64) -> bool) -> f64 {
    while high - low > 1e-10 * low.abs().max(high.abs()) {
        let middle = 0.5 * (low + high);
        if below(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Incomplete gamma function P(a, x): its series for small x, Lentz's continued fraction of 1 - P for large (Abramowitz and
/// Stegun 6.5.29, 6.5.31).
fn lower_gamma(a: f64, x: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    let factor = (a * x.ln() - x - libm::lgamma(a)).exp();
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
            assert!((normal_quantile(probability) - z).abs() < 1e-8, "{probability}");
        }
    }

    /// Abramowitz and Stegun, table 26.8.
    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (probability, degrees, value) in [
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

    /// Two degrees of freedom are an exponential distribution.
    #[test]
    fn two_degrees_are_in_closed_form() {
        for probability in [1e-4, 0.3, 0.7, 0.9999] {
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
            assert!((cube / exact - 1.0).abs() < 1e-5, "{probability}: {cube} {exact}");
        }
    }
}
