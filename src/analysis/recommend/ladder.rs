//! The algorithms, ordered by a cost that does not depend on the machine.

use crate::mechanization::{Frame, MAX_SUBSAMPLES, Scheme};
use crate::simulator::Options;

/// Numbers of updates in a sample interval that are offered.
const UPDATES: [usize; 5] = [1, 2, 4, 8, 16];
const SCHEMES: [Scheme; 3] = [Scheme::Paper, Scheme::Exact, Scheme::Polynomial];
/// Algorithms that are offered.
const RUNGS: usize = UPDATES.len() * MAX_SUBSAMPLES * SCHEMES.len();

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

    /// Instructions of a step that the algorithm has a part in, within 2 % as `benches/instructions.sh matrix` counts them on
    /// x86-64: the mechanization's, and of the signal generator's those for each sub-increment. The rest of a step takes 3000.
    pub fn instructions(&self, frame: Frame) -> f64 {
        let (update, subsample) = match (frame, self.scheme) {
            (Frame::EarthFixed, Scheme::Paper) => (460.0, 470.0),
            (Frame::EarthFixed, Scheme::Exact) => (735.0, 591.0),
            (Frame::EarthFixed, Scheme::Polynomial) => (1820.0, 790.0),
            (Frame::Geographic, Scheme::Paper) => (1280.0, 470.0),
            (Frame::Geographic, Scheme::Exact) => (3330.0, 591.0),
            (Frame::Geographic, Scheme::Polynomial) => (4420.0, 790.0),
        };
        self.updates_per_sample as f64 * (update + subsample * self.subsamples as f64)
    }
}

/// Every algorithm that `frame` can be navigated with, the cheapest first; of two that cost the same, the one with fewer
/// updates.
pub fn ladder(frame: Frame) -> [Rung; RUNGS] {
    let mut rungs = core::array::from_fn(|index| Rung {
        scheme: SCHEMES[index % SCHEMES.len()],
        subsamples: 1 + index / SCHEMES.len() % MAX_SUBSAMPLES,
        updates_per_sample: UPDATES[index / (SCHEMES.len() * MAX_SUBSAMPLES)],
    });
    // Unstable, as a stable sort allocates.
    rungs.sort_unstable_by(|a, b| {
        let cost = a.instructions(frame).total_cmp(&b.instructions(frame));
        cost.then(a.updates_per_sample.cmp(&b.updates_per_sample))
    });
    rungs
}
