//! Increments of many runs side by side.

use nalgebra::Vector3;

use super::Increment;

/// Number of runs of a batch: two vectors of the widest instruction set. The data of a batch for a step fit into the first-level
/// cache.
pub(crate) const RUNS: usize = 16;

/// One number of each run of a batch.
pub(crate) type Row = [f64; RUNS];

/// An increment of the runs of a batch: three components of angle, three of velocity.
pub(crate) type IncrementRows = [Row; 6];

/// Stores vectors in a lane, each in three of the rows.
#[inline(always)]
pub(crate) fn put_vectors<const N: usize>(rows: &mut [Row], lane: usize, vectors: [&Vector3<f64>; N]) {
    for k in 0..N {
        for i in 0..3 {
            rows[3 * k + i][lane] = vectors[k][i];
        }
    }
}

/// The vectors that [`put_vectors`] stored in a lane.
#[inline(always)]
pub(crate) fn vectors_of<const N: usize>(rows: &[Row], lane: usize) -> [Vector3<f64>; N] {
    core::array::from_fn(|k| Vector3::from_fn(|i, _| rows[3 * k + i][lane]))
}

/// Stores the increment of a run in a lane.
#[inline(always)]
pub(crate) fn put_increment(rows: &mut IncrementRows, lane: usize, increment: &Increment) {
    put_vectors(rows, lane, [&increment.angle, &increment.velocity]);
}

/// The increment of the run at `lane`.
#[inline(always)]
pub(crate) fn increment_of(rows: &IncrementRows, lane: usize) -> Increment {
    let [angle, velocity] = vectors_of(rows, lane);
    Increment { angle, velocity }
}
