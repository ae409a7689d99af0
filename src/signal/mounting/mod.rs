//! Where the sensor block sits: motion from the flight sample's reference point to the block, and the solution back to the
//! reference point, with what the INS believes of the mounting.
//!
//! `_s` are the axes of the block, `_b` the axes of the vehicle. The ideal signals of the block follow from the generator's motion
//! and a rigid arm. The angular rate is turned to the block's axes. The specific force is
//! ```text
//! f_s = C_sb (f + ω'×l + ω×(ω×l) - (γ(r + C l) - γ(r)))
//! ```
//! ω is relative to inertial space, γ is gravitation. The INS navigates the block and outputs the reference point.

mod block;
mod placement;
mod table;

pub use block::{Belief, Block, MountingErrors};
pub use placement::Placement;
pub use table::MOUNTING;

use nalgebra::Vector3;

use crate::base::error::Error;
use crate::base::math::Euler;
use crate::base::rows::check;
use crate::base::snapshot::stored;
use crate::earth::state::BodyAxes;

// The parameters with their checks and numbers, which build.rs writes from the table.
include!(concat!(env!("OUT_DIR"), "/mounting.rs"));

/// Integral over `dt` [s] of the acceleration ω'×r + ω×(ω×r) at the place `arm` = r [m], as a velocity [m/s] in body axes, while ω
/// changes by `change` = d about its mean `mean` = m [rad/s]:
/// ```text
/// ∫ω'×r dt     = d×r
/// ∫ω×(ω×r) dt  = (m×(m×r) + d×(d×r)/12) dt
/// ```
/// This is exact for a rate that changes linearly; the next term is (ω'' dt²)²/720 of the arm.
#[inline]
pub(crate) fn lever_arm_velocity(
    change: &Vector3<f64>,
    mean: &Vector3<f64>,
    dt: f64,
    arm: &Vector3<f64>,
) -> Vector3<f64> {
    change.cross(arm) + (centripetal(mean, arm) + centripetal(change, arm) * (1.0 / 12.0)) * dt
}

/// ω×(ω×r)
#[inline]
pub(crate) fn centripetal(rate: &Vector3<f64>, arm: &Vector3<f64>) -> Vector3<f64> {
    rate.cross(&rate.cross(arm))
}

impl MountingParameters {
    /// The same mounting, about which the INS believes the truth.
    pub(crate) fn believed(&self) -> Self {
        Self { lever_arm_m: self.lever_arm_m, boresight: self.boresight, ..Self::default() }
    }

    /// Where the INS believes the block to be, in a vehicle with `axes`.
    pub(crate) fn believed_placement(&self, axes: BodyAxes) -> Placement {
        let Self { boresight, boresight_error: error, .. } = self;
        let believed = Euler {
            roll: boresight.roll + error.roll,
            pitch: boresight.pitch + error.pitch,
            heading: boresight.heading + error.heading,
        };
        Placement::new(self.lever_arm_m + self.lever_arm_error_m, &believed, axes)
    }

    /// Whether the INS believes the truth.
    pub fn is_believed(&self) -> bool {
        self.lever_arm_error_m == Vector3::zeros() && self.boresight_error == Euler::default()
    }
}
