//! What the values of a record show before any fit: repeats, single values that stand out, and parts that stand still.

use crate::units::significant;

/// Rows between two values that are equal by chance alone.
const FAR: usize = 101;

/// Kurtosis of normal numbers, what more of it no record of a single noise has, and the same in standard deviations of that of a record.
/// A spike that changes the variance of n rows by a tenth has 0.005 n more.
const NORMAL: f64 = 3.0;
const MORE: f64 = 1.0;
const DEVIATIONS: f64 = 6.0;

/// A run of equal values so many times longer than the longest that chance makes.
const LONGER: f64 = 10.0;

/// How often a value is that of the row before, as a part of all rows, beyond what coarse values are by chance.
pub fn repeats(values: &[f64]) -> f64 {
    let chance = equal(values, FAR);
    (equal(values, 1) - chance) / (1.0 - chance).max(f64::EPSILON)
}

/// Part of the values that are equal to those so many rows before.
fn equal(values: &[f64], rows: usize) -> f64 {
    let pairs = values.iter().zip(values.get(rows..).unwrap_or_default());
    pairs.filter(|(one, other)| one == other).count() as f64 / values.len() as f64
}

/// What no noise of a sensor does, in a sentence; `pieces`: lengths of the parts between gaps.
pub fn fault(values: &[f64], pieces: &[usize], interval_s: f64) -> Option<String> {
    stuck(values, interval_s).or_else(|| outstanding(values, pieces))
}

/// A run of equal values that chance does not make: with the part p of equal neighbours, the longest run of n values is about
/// ln n / ln(1 / p).
fn stuck(values: &[f64], interval_s: f64) -> Option<String> {
    let part = equal(values, 1);
    let runs = values.chunk_by(|one, other| one == other).map(<[f64]>::len);
    let longest = runs.max().unwrap_or(0) as f64;
    let by_chance = (values.len() as f64).ln() / -part.max(1.0 / values.len() as f64).ln();
    (part < 1.0 && longest > LONGER * (1.0 + by_chance)).then(|| {
        format!(
            "one value stands for {} s: the sensor stood still, or its steps are too coarse",
            significant(longest * interval_s)
        )
    })
}

/// Changes from row to row, where there are any, that are not those of one normal noise.
fn outstanding(values: &[f64], pieces: &[usize]) -> Option<String> {
    let ends: Vec<usize> = pieces
        .iter()
        .scan(0, |end, length| {
            *end += length;
            Some(*end)
        })
        .collect();
    let changes = || {
        let within = values.windows(2).enumerate().filter(|(row, _)| ends.binary_search(&(row + 1)).is_err());
        within.map(|(_, two)| two[1] - two[0]).filter(|change| *change != 0.0)
    };
    let (count, sum) = changes().fold((0.0, 0.0), |(count, sum), change| (count + 1.0, sum + change));
    let (second, fourth) = changes().fold((0.0, 0.0), |(second, fourth), change| {
        let square = (change - sum / count) * (change - sum / count);
        (second + square, fourth + square * square)
    });
    let kurtosis = count * fourth / (second * second);
    let limit = NORMAL + MORE.max(DEVIATIONS * (24.0 / count).sqrt());
    (kurtosis > limit).then(|| {
        format!(
            "some changes from row to row are far larger than the others (kurtosis {}, of normal noise 3): single values stand out, or \
             the noise is not the same throughout",
            significant(kurtosis)
        )
    })
}

#[cfg(test)]
mod tests {
    use super::super::analysis::tests::made;
    use super::*;

    fn noise() -> Vec<f64> {
        made(20_000, 0.0).series.remove(0).increments
    }

    fn found(values: &[f64]) -> Option<String> {
        fault(values, &[values.len()], 0.01)
    }

    #[test]
    fn coarse_values_are_no_repeats() {
        let values: Vec<f64> = noise().iter().map(|x| (x / 1e-6).round()).collect();
        assert!(equal(&values, 1) > 0.25);
        assert!(repeats(&values).abs() < 0.02, "{}", repeats(&values));
        let twice: Vec<f64> = values.iter().flat_map(|value| [*value; 2]).collect();
        assert!((repeats(&twice) - 0.5).abs() < 0.02, "{}", repeats(&twice));
        assert_eq!((found(&values), found(&twice)), (None, None));
    }

    #[test]
    fn what_no_noise_does_is_told() {
        let noise = noise();
        for times in [1, 2, 5] {
            let repeated: Vec<f64> =
                noise.iter().flat_map(|value| std::iter::repeat_n(*value, times)).collect();
            assert_eq!(found(&repeated), None, "{times}");
        }
        let mut spike = noise.clone();
        spike[7000] = 1e-4;
        assert!(found(&spike).unwrap().contains("single values stand out"));
        let mut stuck = noise.clone();
        stuck[10_000..].fill(noise[0]);
        assert!(found(&stuck).unwrap().contains("one value stands for 100.0 s"), "{:?}", found(&stuck));
        let louder: Vec<f64> = noise
            .iter()
            .enumerate()
            .map(|(row, value)| if row < 5000 { 10.0 * value } else { *value })
            .collect();
        assert!(found(&louder).is_some());
        // A step between two pieces is none of a noise.
        let stepped: Vec<f64> = noise
            .iter()
            .enumerate()
            .map(|(row, value)| if row < 5000 { *value } else { value + 1e-4 })
            .collect();
        assert!(fault(&stepped, &[5000, 15_000], 0.01).is_none() && found(&stepped).is_some());
    }
}
