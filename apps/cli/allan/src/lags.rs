//! Sums over the distances of two second differences of a record. Each distance counts as often as the record has it.

/// Longest piece between two corners [samples] that is summed term by term.
const SUMMED: i64 = 16;

/// Gauss-Legendre quadrature on 0..1: eight nodes in rising order, each with its weight.
const GAUSS_8: [(f64, f64); 8] = [
    (0.019_855_071_751_231_884, 0.050_614_268_145_188_13),
    (0.101_666_761_293_186_64, 0.111_190_517_226_687_24),
    (0.237_233_795_041_835_5, 0.156_853_322_938_943_63),
    (0.408_282_678_752_175_1, 0.181_341_891_689_181),
    (0.591_717_321_247_825, 0.181_341_891_689_181),
    (0.762_766_204_958_164_5, 0.156_853_322_938_943_63),
    (0.898_333_238_706_813_4, 0.111_190_517_226_687_24),
    (0.980_144_928_248_768_1, 0.050_614_268_145_188_13),
];

/// Second differences with steps of `a` and of `b` samples in one record.
#[derive(Debug, Clone, Copy)]
pub struct Pair {
    /// Number of samples of the record. Its integral has one sample more.
    pub count: usize,
    pub a: usize,
    pub b: usize,
}

/// A distance in samples from the start of the first difference to the start of the second, and its weight in a sum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lag {
    pub samples: f64,
    pub weight: f64,
}

impl Pair {
    /// Number of second differences of either kind in the record.
    pub fn starts(&self) -> (usize, usize) {
        (self.count + 1 - 2 * self.a, self.count + 1 - 2 * self.b)
    }

    /// Number of pairs of differences with the distance `lag`.
    pub fn times(&self, lag: f64) -> f64 {
        let (first, second) = self.starts();
        ((first as f64).min(second as f64 - lag) - (-lag).max(0.0)).max(0.0)
    }

    /// Places and weights that give Σ times(l) f(l) over all integers l. f is a square of covariances of noise: smooth except at
    /// the distances at which two points of the differences meet, and decreasing to zero beyond the differences.
    pub fn lags(&self) -> Vec<Lag> {
        let (a, b) = (self.a as i64, self.b as i64);
        let (first, second) = (self.starts().0 as i64, self.starts().1 as i64);
        // A covariance of flicker falls with the square of the distance: the part that is left out is 2e-4 of the sum.
        let (middle, reach) = (a - b, 3 * (a + b));
        let (low, high) = ((middle - reach).max(-first), (middle + reach).min(second));
        let mut corners = vec![low, high, 0, second - first];
        corners.extend(self.meetings().map(|(lag, _)| lag));
        corners.retain(|corner| (low..=high).contains(corner));
        corners.sort_unstable();
        corners.dedup();
        let mut lags = Vec::new();
        for ends in corners.windows(2) {
            self.piece(ends[0], ends[1], &mut lags);
        }
        lags
    }

    /// Distances at which two points of the differences meet, with the product of their factors 1, -2, 1.
    pub fn meetings(&self) -> impl Iterator<Item = (i64, f64)> {
        const FACTORS: [f64; 3] = [1.0, -2.0, 1.0];
        let (a, b) = (self.a as i64, self.b as i64);
        (0..9_usize).map(move |k| (k as i64 / 3 * a - k as i64 % 3 * b, FACTORS[k / 3] * FACTORS[k % 3]))
    }

    /// Adds the places and weights from corner to corner, with half the weight at each corner: term by term, or as an integral.
    fn piece(&self, from: i64, to: i64, lags: &mut Vec<Lag>) {
        let mut push = |samples: f64, weight: f64| {
            lags.push(Lag { samples, weight: weight * self.times(samples) });
        };
        if to - from <= SUMMED {
            for lag in from..=to {
                push(lag as f64, if lag == from || lag == to { 0.5 } else { 1.0 });
            }
            return;
        }
        let length = (to - from) as f64;
        for (place, weight) in GAUSS_8 {
            push(from as f64 + length * place, length * weight);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_has_each_pair_of_starts_once() {
        let pair = Pair { count: 40, a: 3, b: 7 };
        let (first, second) = pair.starts();
        let mut counts = std::collections::HashMap::new();
        for k in 0..first as i64 {
            for l in 0..second as i64 {
                *counts.entry(l - k).or_insert(0_u32) += 1;
            }
        }
        for lag in -50..50 {
            let expected = f64::from(counts.get(&lag).copied().unwrap_or(0));
            assert_eq!(pair.times(lag as f64), expected, "{lag}");
        }
    }

    /// ∫ u^k du = 1/(k + 1). Nodes and weights are rounded, and the power k of a node multiplies its rounding error by k.
    #[test]
    fn the_rule_is_exact_to_its_degree_and_no_further() {
        let degree = 2 * GAUSS_8.len() as i32;
        for power in 0..=degree {
            let integral: f64 = GAUSS_8.iter().map(|(node, weight)| weight * node.powi(power)).sum();
            let error = (integral - 1.0 / f64::from(power + 1)).abs();
            let rounding = f64::from(power + 4) * f64::EPSILON;
            assert_eq!(error <= rounding, power < degree, "u^{power}: {error:e}");
        }
    }

    /// Compared with the sum term by term, for a squared triangular covariance, as white noise has it. The integral leaves out 1/12
    /// of the jumps of slope, less than 1 / SUMMED².
    #[test]
    fn pieces_make_the_whole_sum() {
        for (count, a, b) in [(100, 1, 1), (100, 2, 5), (2000, 30, 200), (2000, 200, 200), (1000, 111, 90)] {
            let pair = Pair { count, a, b };
            let covariance = |lag: f64| {
                pair.meetings().map(|(meeting, factor)| factor * (lag - meeting as f64).abs()).sum::<f64>()
            };
            let (first, second) = pair.starts();
            let all = -(first as i64)..=second as i64;
            let exact: f64 = all.map(|l| pair.times(l as f64) * covariance(l as f64).powi(2)).sum();
            let sum: f64 = pair.lags().iter().map(|lag| lag.weight * covariance(lag.samples).powi(2)).sum();
            assert!((sum / exact - 1.0).abs() < 1.0 / 256.0, "{count} {a} {b}: {sum} {exact}");
        }
    }
}
