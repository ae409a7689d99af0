//! Quantiles of the chi-square distribution.

/// χ²/ν at the normal quantile `z`, for ν = `degrees` of freedom: (1 - 2/(9ν) + z √(2/(9ν)))³ (Wilson and Hilferty 1931).
pub fn wilson_hilferty(z: f64, degrees: f64) -> f64 {
    let spread = 2.0 / (9.0 * degrees);
    let root = 1.0 - spread + z * spread.sqrt();
    root * root * root
}
