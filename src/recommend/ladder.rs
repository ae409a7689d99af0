//! The algorithms, ordered by a cost that does not depend on the machine.

use crate::mechanization::{Frame, MAX_SUBSAMPLES, Scheme};
use crate::simulator::Options;

/// Numbers of updates in a sample interval that are offered.
const UPDATES: [usize; 5] = [1, 2, 4, 8, 16];

/// An algorithm of the mechanization.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rung {
    /// Which algorithm.
    pub scheme: Scheme,
    /// Sub-increments of an update.
    pub subsamples: usize,
    /// Mechanization updates in a sample interval.
    pub updates_per_sample: usize,
}

impl Rung {
    /// `options` with this algorithm.
    pub fn applied_to(&self, options: &Options) -> Options {
        let Self { scheme, subsamples, updates_per_sample } = *self;
        Options { scheme, subsamples, updates_per_sample, ..*options }
    }

    /// Instructions of a step that the algorithm has a part in, as `benches/instructions.sh` counts them on x86-64: the
    /// signal generator's for each sub-increment, the body-frame part, the navigation-frame part.
    pub fn instructions(&self, frame: Frame) -> f64 {
        let n = self.subsamples as f64;
        let body = match self.scheme {
            Scheme::Exact | Scheme::Paper => 80.0 + 100.0 * n,
            Scheme::Polynomial => 1500.0 + 300.0 * n,
        };
        let axes = match (frame, self.scheme) {
            (Frame::EarthFixed, Scheme::Paper) => 650.0,
            (Frame::EarthFixed, _) => 800.0,
            (Frame::Geographic, Scheme::Paper) => 700.0,
            (Frame::Geographic, _) => 2500.0,
        };
        self.updates_per_sample as f64 * (300.0 * n + body + axes)
    }
}

/// Every algorithm that `frame` can be navigated with, the cheapest first; of two that cost the same, the one with fewer
/// updates.
pub fn ladder(frame: Frame) -> Vec<Rung> {
    let mut rungs = Vec::new();
    for updates_per_sample in UPDATES {
        for subsamples in 1..=MAX_SUBSAMPLES {
            for scheme in [Scheme::Paper, Scheme::Exact, Scheme::Polynomial] {
                rungs.push(Rung { scheme, subsamples, updates_per_sample });
            }
        }
    }
    rungs.sort_by(|a, b| a.instructions(frame).total_cmp(&b.instructions(frame)));
    rungs
}
