//! Gauss-Legendre quadrature on 0..1: nodes in rising order, each with its weight. A rule of n nodes integrates polynomials of
//! degree 2n - 1 exactly.

/// Rule of two nodes.
pub const GAUSS_2: [(f64, f64); 2] = [(0.211_324_865_405_187_1, 0.5), (0.788_675_134_594_812_9, 0.5)];

/// Rule of three nodes.
pub const GAUSS_3: [(f64, f64); 3] = [
    (0.112_701_665_379_258_31, 0.277_777_777_777_777_8),
    (0.5, 0.444_444_444_444_444_4),
    (0.887_298_334_620_741_7, 0.277_777_777_777_777_8),
];

/// Rule of four nodes.
pub const GAUSS_4: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

/// Rule of five nodes.
pub const GAUSS_5: [(f64, f64); 5] = [
    (0.046_910_077_030_668_004, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_23),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_23),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// Rule of eight nodes.
pub const GAUSS_8: [(f64, f64); 8] = [
    (0.019_855_071_751_231_884, 0.050_614_268_145_188_13),
    (0.101_666_761_293_186_64, 0.111_190_517_226_687_24),
    (0.237_233_795_041_835_5, 0.156_853_322_938_943_63),
    (0.408_282_678_752_175_1, 0.181_341_891_689_181),
    (0.591_717_321_247_825, 0.181_341_891_689_181),
    (0.762_766_204_958_164_5, 0.156_853_322_938_943_63),
    (0.898_333_238_706_813_4, 0.111_190_517_226_687_24),
    (0.980_144_928_248_768_1, 0.050_614_268_145_188_13),
];

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ u^k du = 1/(k + 1). Nodes and weights are rounded, and the power k of a node multiplies its rounding error by k.
    #[test]
    fn each_rule_is_exact_to_its_degree_and_no_further() {
        for rule in [&GAUSS_2[..], &GAUSS_3, &GAUSS_4, &GAUSS_5, &GAUSS_8] {
            let degree = 2 * rule.len() as i32;
            for power in 0..=degree {
                let integral: f64 = rule.iter().map(|(node, weight)| weight * node.powi(power)).sum();
                let error = (integral - 1.0 / f64::from(power + 1)).abs();
                let rounding = f64::from(power + 4) * f64::EPSILON;
                assert_eq!(error <= rounding, power < degree, "{} nodes, u^{power}: {error:e}", rule.len());
            }
        }
    }
}
