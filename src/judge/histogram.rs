//! Medians of a stream of sizes, in memory of fixed size.

/// Bins: four to an octave, from 2⁻³⁴ to 2³⁰. The width of a bin is 12 to 25 % of its values.
const BINS: usize = 256;

/// The bits of the exponent and the first two of the mantissa of 2⁻³⁴, which is the lower end of the first bin.
const FIRST: u64 = (1023 - 34) << 2;

/// Sizes, counted by their logarithms. 0 and sizes below 2⁻³⁴ count as 0.
#[derive(Debug, Clone)]
pub(super) struct Histogram {
    counts: [u32; BINS],
    zeros: u64,
    total: u64,
    median: f64,
    /// Total at which the median is computed again.
    renew_at: u64,
}

impl Histogram {
    pub const fn new() -> Self {
        Self { counts: [0; BINS], zeros: 0, total: 0, median: 0.0, renew_at: 1 }
    }

    /// Counts a `size`, which is not negative.
    pub fn add(&mut self, size: f64) {
        match bin(size) {
            Some(bin) => self.counts[bin] = self.counts[bin].saturating_add(1),
            None => self.zeros += 1,
        }
        self.total += 1;
        if self.total >= self.renew_at {
            self.median = self.quantile(0.5);
            self.renew_at = self.total + self.total / 8 + 1;
        }
    }

    /// Number of sizes.
    pub fn total(&self) -> u64 {
        self.total
    }

    /// Median when the number of sizes was last an eighth larger than the time before: for use while sizes are added.
    pub fn recent_median(&self) -> f64 {
        self.median
    }

    /// Median now.
    pub fn median(&self) -> f64 {
        self.quantile(0.5)
    }

    /// The size below which a `share` of the sizes lies, linear within its bin; 0 without sizes.
    fn quantile(&self, share: f64) -> f64 {
        let mut left = share * self.total as f64 - self.zeros as f64;
        if left < 0.0 {
            return 0.0;
        }
        for (bin, &count) in self.counts.iter().enumerate() {
            let count = f64::from(count);
            if left < count {
                let (low, high) = (lower_end(bin), lower_end(bin + 1));
                return low + (high - low) * ((left + 0.5) / count).min(1.0);
            }
            left -= count;
        }
        0.0
    }

    /// Number of sizes in the bins wholly above `limit`.
    pub fn count_above(&self, limit: f64) -> u64 {
        let first = bin(limit).map_or(0, |bin| bin + 1);
        self.counts[first..].iter().map(|&count| u64::from(count)).sum()
    }
}

/// The bin of a size; `None`: it counts as 0.
fn bin(size: f64) -> Option<usize> {
    let first_bits = size.to_bits() >> 50;
    first_bits.checked_sub(FIRST).map(|bin| (bin as usize).min(BINS - 1))
}

fn lower_end(bin: usize) -> f64 {
    f64::from_bits((bin as u64 + FIRST) << 50)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_right_within_a_bin() {
        let mut sizes = Histogram::new();
        for k in 1..=1000 {
            sizes.add(f64::from(k) * 1e-3);
        }
        assert!((sizes.median() / 0.5 - 1.0).abs() < 0.02, "{}", sizes.median());
        assert!((sizes.recent_median() / 0.5 - 1.0).abs() < 0.2);
        assert_eq!(sizes.count_above(0.5), 376); // the bin of 0.5 ends below 0.625
        (0..2000).for_each(|_| sizes.add(0.0));
        assert_eq!((sizes.median(), sizes.total()), (0.0, 3000));
    }

    #[test]
    fn sizes_beyond_the_ends_are_counted() {
        let mut sizes = Histogram::new();
        for size in [0.0, f64::MIN_POSITIVE, 1e-11, 1e300] {
            sizes.add(size);
        }
        assert_eq!(sizes.count_above(1.0), 1);
    }
}
