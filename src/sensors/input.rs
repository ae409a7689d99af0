//! What the errors that follow the signal are computed from.

use nalgebra::Vector3;

/// The input of a triad over an increment; of constant signals, over 1 s.
#[derive(Debug, Clone, Copy)]
pub(super) struct Input {
    /// The signal after size effect and bandwidth: its increment [u s].
    pub signal: Vector3<f64>,
    /// The true specific force at the block's own point: its increment [m/s].
    pub force: Vector3<f64>,
    /// Length of the increment [s].
    pub dt: f64,
}
