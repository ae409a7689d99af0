//! Compensated sums, derivatives from uneven samples, quadrature.

use nalgebra::Vector1;
use sins::math::{
    Compensated, GAUSS_2, GAUSS_3, GAUSS_4, GAUSS_5, end_derivative_weights, two_product, two_sum,
};

#[test]
fn two_sum_and_two_product_lose_nothing() {
    let (s, e) = two_sum(1.0, 1e-20);
    assert_eq!((s, e), (1.0, 1e-20));
    // (1 + 2^-30)(1 - 2^-30) = 1 - 2^-60; a double keeps only the 1.
    let h = 2f64.powi(-30);
    let (p, e) = two_product(1.0 + h, 1.0 - h);
    assert_eq!((p, e), (1.0, -h * h));
}

#[test]
fn a_million_small_increments_arrive() {
    let mut sum = Compensated::new(Vector1::new(6.4e6));
    let increment = 1e-11; // a fiftieth of half an ulp of the sum: a plain sum would never move
    for _ in 0..1_000_000 {
        sum.add(&Vector1::new(increment));
    }
    let moved = sum.minus(&Vector1::new(6.4e6))[0];
    assert!((moved - 1e-5).abs() < 1e-19 + 4.0 * f64::EPSILON * 1e-5 * 1e3, "{moved:e}");
}

#[test]
fn even_spacing_gives_the_textbook_backward_formula() {
    let w = end_derivative_weights(&[-1.0, -2.0, -3.0]);
    for (w, expected) in w.iter().zip([-3.0, 1.5, -1.0 / 3.0]) {
        assert!((w - expected).abs() < 8.0 * f64::EPSILON, "{w} {expected}");
    }
}

#[test]
fn exact_for_polynomials_up_to_the_number_of_points() {
    let offsets = [-0.031, -0.0205, 0.0098];
    let w = end_derivative_weights(&offsets);
    for power in 1..4 {
        let derivative: f64 = offsets.iter().zip(w).map(|(x, w)| w * x.powi(power)).sum();
        let expected = if power == 1 { 1.0 } else { 0.0 };
        let scale: f64 = offsets.iter().zip(w).map(|(x, w)| (w * x.powi(power)).abs()).sum();
        assert!((derivative - expected).abs() < 8.0 * f64::EPSILON * (1.0 + scale));
    }
}

/// ∫ u^k du = 1/(k + 1). Nodes and weights are rounded, and the power k of a node multiplies its rounding error by k.
#[test]
fn each_rule_is_exact_to_its_degree_and_no_further() {
    for rule in [&GAUSS_2[..], &GAUSS_3, &GAUSS_4, &GAUSS_5] {
        let degree = 2 * rule.len() as i32;
        for power in 0..=degree {
            let integral: f64 = rule.iter().map(|(node, weight)| weight * node.powi(power)).sum();
            let error = (integral - 1.0 / f64::from(power + 1)).abs();
            let rounding = f64::from(power + 4) * f64::EPSILON;
            assert_eq!(error <= rounding, power < degree, "{} nodes, u^{power}: {error:e}", rule.len());
        }
    }
}
