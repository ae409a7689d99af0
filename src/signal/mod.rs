//! The signal generator (the paper's inverse navigation): from truth to what perfect gyros and accelerometers sense.
//!
//! The motion follows the velocities: within an interval velocity is a cubic through the velocities and accelerations at both ends,
//! and the rotation vector of the attitude is a cubic. The derivatives come from a backward stencil on the actual time stamps.
//! Angular rate and specific force are integrated over each sub-interval to rounding. Position enters through gravity alone.
//! Latency is zero; the generator does not depend on the mechanization.
//!
//! Departure: the paper differences the samples, which is 49 °/h wrong on a rocking table.

mod derivatives;
mod generator;
mod motion;
pub mod mounting;
mod rows;

pub(crate) use derivatives::DERIVATIVES;
pub use generator::SignalGenerator;
pub use motion::{IntervalMotion, MotionNode, TurnToEarth, Turning};
pub(crate) use rows::{IncrementRows, RUNS, Row, increment_of, put_increment, put_vectors, vectors_of};

use nalgebra::Vector3;

use crate::base::snapshot::{SIGNALS, stored};

/// Largest number of sub-increments of an interval: 5 subsamples of 16 updates.
pub const MAX_INCREMENTS: usize = 80;

/// Integrals of angular rate and specific force over a short time, sensor axes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Increment {
    /// ∫ omega_ib_b dt [rad]
    pub angle: Vector3<f64>,
    /// ∫ f_b dt [m/s]
    pub velocity: Vector3<f64>,
}

stored!(Increment { angle: SIGNALS, velocity: SIGNALS });

impl Increment {
    /// No motion, no force.
    pub const ZERO: Self = Self { angle: Vector3::new(0.0, 0.0, 0.0), velocity: Vector3::new(0.0, 0.0, 0.0) };

    /// This less `other`.
    #[inline(always)]
    pub fn minus(&self, other: &Self) -> Self {
        Self { angle: self.angle - other.angle, velocity: self.velocity - other.velocity }
    }

    /// Sum of increments: the integrals over all of their time.
    #[inline]
    pub fn sum(increments: &[Self]) -> Self {
        increments.iter().fold(Self::ZERO, |sum, increment| Self {
            angle: sum.angle + increment.angle,
            velocity: sum.velocity + increment.velocity,
        })
    }
}
