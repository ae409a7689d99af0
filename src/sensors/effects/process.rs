//! The random processes of effects, for the covariance of the errors.

use super::super::parameters::TriadParameters;

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
pub(crate) struct Processes {
    /// How many.
    pub count: usize,
    /// Evolution and standard deviation of a process of an axis; of a walk its density [u/√s].
    pub of: fn(&TriadParameters, axis: usize, process: usize) -> (Kind, f64),
}

/// Those of all effects. The order is that of snapshots.
pub(crate) const OF_SIGNAL: [Processes; 4] = [
    super::bias::RANDOM,
    super::gauss_markov::RANDOM,
    super::rate_random_walk::RANDOM,
    super::flicker::RANDOM,
];
