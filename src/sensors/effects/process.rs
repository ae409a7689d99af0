//! The random processes of effects, for the covariance of the errors.

use super::super::parameters::TriadParameters;
use super::super::stream::STREAM_NUMBERS;

/// The evolution of a process.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    /// Drawn once a run.
    Constant,
    /// Gauss-Markov of this correlation time [s].
    Markov(f64),
    /// Gauss-Markov of this correlation distance over ground [m].
    MarkovOverGround(f64),
    /// Random walk from 0 at the start of the run.
    Walk,
}

/// The processes of an effect that add to the signal of an axis.
#[derive(Clone, Copy)]
pub(crate) struct Processes {
    /// How many.
    pub count: usize,
    /// Whether they are of [`Kind::Walk`].
    pub are_walks: bool,
    /// Evolution and standard deviation of a process of an axis; of a walk its density [u/√s].
    pub of: fn(&TriadParameters, axis: usize, process: usize) -> (Kind, f64),
}

impl Processes {
    /// None.
    pub const NONE: Self = Self { count: 0, are_walks: false, of: |_, _, _| (Kind::Constant, 0.0) };

    /// Puts them into `all`, at the number of the effect's first stream.
    pub(super) const fn put(self, streams: &[u64], all: &mut [Self; STREAM_NUMBERS]) {
        if self.count != 0 {
            all[streams[0] as usize] = self;
        }
    }
}
