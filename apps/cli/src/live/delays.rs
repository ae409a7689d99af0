//! Quantiles of delays in constant memory: a histogram whose bins are a sixteenth of an octave wide.

/// Shortest delay that has a bin of its own [s].
const SHORTEST_S: f64 = 1e-7;
const PER_OCTAVE: f64 = 16.0;
/// To 10 s and more.
const BINS: usize = 27 * 16;

#[derive(Debug, Clone)]
pub struct Delays {
    bins: [u64; BINS],
    count: u64,
}

impl Default for Delays {
    fn default() -> Self {
        Self { bins: [0; BINS], count: 0 }
    }
}

impl Delays {
    pub fn add(&mut self, delay_s: f64) {
        let bin = (PER_OCTAVE * (delay_s / SHORTEST_S).log2()).clamp(0.0, BINS as f64 - 1.0);
        self.bins[bin as usize] += 1;
        self.count += 1;
    }

    pub fn count(&self) -> u64 {
        self.count
    }

    /// The upper end of the bin in which this part of the delays ends [s].
    pub fn quantile_s(&self, part: f64) -> f64 {
        let wanted = (part * self.count as f64).ceil() as u64;
        let mut sum = 0;
        let bin = self.bins.iter().position(|count| {
            sum += count;
            sum >= wanted
        });
        SHORTEST_S * (((bin.unwrap_or(BINS) + 1) as f64) / PER_OCTAVE).exp2()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_right_to_a_bin() {
        let mut delays = Delays::default();
        (1..=1000).for_each(|k| delays.add(f64::from(k) * 1e-5));
        let width = (1.0 / PER_OCTAVE).exp2();
        for (part, expected_s) in [(0.5, 5e-3), (0.999, 9.99e-3), (0.001, 1e-5)] {
            let found_s = delays.quantile_s(part);
            assert!(
                (expected_s..=expected_s * width * (1.0 + 1e-12)).contains(&found_s),
                "{part}: {found_s}"
            );
        }
        delays.add(0.0);
        delays.add(1e9);
        assert_eq!(delays.count(), 1002);
    }
}
