//! Increments of many runs side by side.

use nalgebra::Vector3;

use super::Increment;

/// Number of runs of a block: two vectors of the widest instruction set. The data of a block for a step fit into the first-level
/// cache.
pub(crate) const RUNS: usize = 16;

/// One number of each run of a block.
pub(crate) type Row = [f64; RUNS];

/// An increment of the runs of a block: three components of angle, three of velocity.
pub(crate) type IncrementRows = [Row; 6];

/// Stores the increment of a run in a lane.
#[inline(always)]
pub(crate) fn put_increment(rows: &mut IncrementRows, lane: usize, increment: &Increment) {
    for i in 0..3 {
        rows[i][lane] = increment.angle[i];
        rows[3 + i][lane] = increment.velocity[i];
    }
}

/// The increment of the run at `lane`.
#[inline(always)]
pub(crate) fn increment_of(rows: &IncrementRows, lane: usize) -> Increment {
    Increment {
        angle: Vector3::from_fn(|i, _| rows[i][lane]),
        velocity: Vector3::from_fn(|i, _| rows[3 + i][lane]),
    }
}
