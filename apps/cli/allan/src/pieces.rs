//! The pieces of a record between its gaps.

use std::collections::BTreeMap;

/// Lengths of pieces, in samples, one behind the other. A piece counts with its number of second differences, to which its degrees of
/// freedom are nearly proportional; differences of two pieces are taken as independent.
#[derive(Debug, Clone)]
pub struct Pieces {
    lengths: Vec<usize>,
    /// Each length, and how often it is there.
    times: BTreeMap<usize, usize>,
}

impl Pieces {
    pub fn new(lengths: &[usize]) -> Self {
        let mut times = BTreeMap::new();
        lengths.iter().for_each(|length| *times.entry(*length).or_default() += 1);
        Self { lengths: lengths.to_vec(), times }
    }

    /// Samples in all.
    pub fn count(&self) -> usize {
        self.lengths.iter().sum()
    }

    pub fn longest(&self) -> usize {
        self.times.keys().next_back().copied().unwrap_or(0)
    }

    /// The pieces of `values`.
    pub fn of<'v>(&self, values: &'v [f64]) -> impl Iterator<Item = &'v [f64]> {
        let mut rest = values;
        self.lengths.iter().map(move |length| {
            let (piece, behind) = rest.split_at(*length);
            rest = behind;
            piece
        })
    }

    /// Each length that has second differences at `a` and `b` intervals, with the weight of the covariance of the two variances of a piece
    /// in that of the whole.
    pub fn joined(&self, a: usize, b: usize) -> impl Iterator<Item = (usize, f64)> {
        let [of_a, of_b] = [a, b].map(|factor| {
            let sum: usize =
                self.times.iter().map(|(length, times)| times * differences(*length, factor)).sum();
            sum as f64
        });
        self.times.iter().filter_map(move |(length, times)| {
            let share = differences(*length, a) as f64 / of_a * (differences(*length, b) as f64 / of_b);
            (share > 0.0).then_some((*length, *times as f64 * share))
        })
    }
}

/// Second differences of a piece at `factor` intervals.
pub fn differences(length: usize, factor: usize) -> usize {
    (length + 1).saturating_sub(2 * factor)
}
