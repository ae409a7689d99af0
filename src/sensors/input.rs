//! Input of the errors that depend on the signal.

use nalgebra::Vector3;

/// The input of a triad over an increment. For constant signals it is the input over 1 s.
#[derive(Debug, Clone, Copy)]
pub(super) struct Input {
    /// Increment of the signal after size effect and bandwidth [u s].
    pub signal: Vector3<f64>,
    /// Increment of the true specific force at the block's own point [m/s].
    pub force: Vector3<f64>,
    /// Length of the increment [s].
    pub dt: f64,
}
