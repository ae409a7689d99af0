//! The overlapping Allan variance of a regularly sampled rate.

use core::f64::consts::LN_2;

use sins::math::exp;

/// Averaging times in an octave.
const PER_OCTAVE: f64 = 3.0;

/// The longest averaging time is the record divided by this: beyond it fewer than about six degrees of freedom are left.
const LONGEST: usize = 9;

/// Fewest samples of a record: two octaves of averaging times fit into it.
pub const FEWEST_SAMPLES: usize = 5 * LONGEST;

/// Averaging times of a record of `count` samples, in samples: three in each octave, from one to a ninth of the record.
pub fn factors(count: usize) -> Vec<usize> {
    let mut factors: Vec<usize> = (0..)
        .map(|k| exp(LN_2 * f64::from(k) / PER_OCTAVE).round() as usize)
        .take_while(|factor| *factor <= count / LONGEST)
        .collect();
    factors.dedup();
    factors
}

/// θ: running sums of `increments`, one more than there are increments. The mean of the increments is subtracted first. This
/// changes no second difference, and small second differences keep their digits.
pub fn integral(increments: &[f64]) -> Vec<f64> {
    let mean = increments.iter().sum::<f64>() / increments.len() as f64;
    let mut sum = 0.0;
    let sums = increments.iter().map(|increment| {
        sum += increment - mean;
        sum
    });
    core::iter::once(0.0).chain(sums).collect()
}

/// σ²(τ) = ⟨(θ(t + 2τ) - 2 θ(t + τ) + θ(t))²⟩ / 2τ² over all starts t in the pieces of a record, τ = `factor` intervals (IEEE Std
/// 952-1997, C.1; overlapping: NIST SP 1065, 5.2.4); `integrals`: θ of each piece.
pub fn allan_variance(integrals: &[Vec<f64>], interval_s: f64, factor: usize) -> f64 {
    let tau_s = factor as f64 * interval_s;
    let (mut sum, mut count) = (0.0, 0);
    for integral in integrals.iter().filter(|integral| integral.len() > 2 * factor) {
        let triples = integral.iter().zip(&integral[factor..]).zip(&integral[2 * factor..]);
        sum += triples.map(|((a, b), c)| (c - 2.0 * b + a) * (c - 2.0 * b + a)).sum::<f64>();
        count += integral.len() - 2 * factor;
    }
    sum / (2.0 * tau_s * tau_s * count as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The thousand numbers of NIST SP 1065, 12.4: n(0) = 1234567890, n(k + 1) = 16807 n(k) mod (2³¹ - 1), over 2³¹ - 1; its
    /// table 31 gives the overlapping Allan deviation at 1, 10 and 100 samples.
    #[test]
    fn the_test_suite_of_sp_1065() {
        let mut n = 1_234_567_890_u64;
        let rates: Vec<f64> = (0..1000)
            .map(|_| {
                let value = n as f64 / 2_147_483_647.0;
                n = n * 16_807 % 2_147_483_647;
                value
            })
            .collect();
        let theta = [integral(&rates)];
        for (factor, expected) in [(1, 2.922_319e-1), (10, 9.159_953e-2), (100, 3.241_343e-2)] {
            let deviation = allan_variance(&theta, 1.0, factor).sqrt();
            assert!((deviation / expected - 1.0).abs() < 1e-6, "{factor}: {deviation}");
        }
    }

    /// Second differences of k³/6 with the step m are m² (k + m): the sum of their squares has a closed form.
    #[test]
    fn a_parabolic_rate_has_its_closed_form() {
        let (count, interval_s) = (100, 0.5);
        let theta = [(0..=count).map(|k| f64::from(k).powi(3) / 6.0).collect::<Vec<f64>>()];
        for m in [1, 3, 11] {
            let starts = count - 2 * m;
            let sum: f64 = (0..=starts).map(|k| f64::from(k + m).powi(2)).sum();
            let expected =
                f64::from(m).powi(2) * sum / (2.0 * interval_s * interval_s * f64::from(starts + 1));
            let variance = allan_variance(&theta, interval_s, m as usize);
            assert!((variance / expected - 1.0).abs() < 1e-9, "{m}: {variance} {expected}");
        }
    }

    #[test]
    fn averaging_times_end_at_a_ninth_of_the_record() {
        assert_eq!(factors(FEWEST_SAMPLES), [1, 2, 3, 4, 5]);
        let factors = factors(9000);
        assert_eq!((factors[0], factors[factors.len() - 1]), (1, 813));
        assert!(factors.is_sorted_by(|a, b| a < b));
    }

    #[test]
    fn a_constant_rate_leaves_nothing() {
        let theta = [integral(&[9.81; 1000])];
        assert!(allan_variance(&theta, 0.01, 100) < 1e-20);
    }
}
