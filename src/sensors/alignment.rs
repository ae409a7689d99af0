//! Levelling and gyrocompassing at rest.

use core::f64::consts::PI;

use nalgebra::{Quaternion, Vector3};

use crate::base::math::{atan2, rotate, rotation_quaternion};

/// Share of gravity below which a sensed force shows no vertical. Rounding leaves a force below it where the accelerometers show 0.
const NO_FORCE: f64 = 1e-9;
/// Size of a gyro error, as a share of the Earth rate's north part, from which north is unknown. Where the gyros show 0, this share
/// is 1 minus rounding.
const NO_NORTH: f64 = 1.0 - 1e-9;

/// What an INS at rest should sense, and the error of what it senses, in true east-north-up axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sensed {
    /// Vector that sensors without errors sense.
    pub ideal_n: Vector3<f64>,
    /// Error: measured less ideal.
    pub error_n: Vector3<f64>,
}

/// Result of an alignment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aligned {
    /// R of the computed attitude C~ = R C.
    pub rotation: Quaternion<f64>,
    /// Whether the attitude is unknown. This is so if the horizontal error of the levelled rates is not smaller than the Earth
    /// rate's north part, or if the accelerometers sense no force for levelling.
    pub north_unknown: bool,
}

/// Levels with the specific force [m/s²], whose ideal is the reaction r to the gravity that the INS computes: the smallest rotation
/// that turns the sensed force along r, which leaves the heading as it is.
pub fn level(force: &Sensed) -> Aligned {
    let up = force.ideal_n / force.ideal_n.norm_squared().sqrt();
    let sensed_n = force.ideal_n + force.error_n;
    let smallest = NO_FORCE * NO_FORCE * force.ideal_n.norm_squared();
    Aligned {
        rotation: rotation_quaternion(&smallest_rotation(&force.error_n.cross(&up), sensed_n.dot(&up))),
        north_unknown: sensed_n.norm_squared() <= smallest,
    }
}

/// Levels with the specific force [m/s²], then finds north with the angular rate [rad/s]. The ideal force is the reaction r to the
/// gravity that the INS computes. The ideal rate is the Earth rate:
///
/// ```text
/// C~ = H T C    T the smallest rotation that turns the sensed force along r: no horizontal force is left
///               H the rotation about r that turns the levelled rate T ω north: by atan2 of its east and north parts
/// ```
/// To first order the misalignment is the steady state of the error equations, 0 = f×φ + nabla and 0 = -(W×φ + eps) east.
pub fn level_and_gyrocompass(force: &Sensed, rate: &Sensed) -> Aligned {
    let Aligned { rotation: level, north_unknown: no_force } = level(force);
    let up = force.ideal_n / force.ideal_n.norm_squared().sqrt();
    let east = Vector3::x();
    let north = up.cross(&east);
    let levelled_n = rotate(&level, &(rate.ideal_n + rate.error_n));
    let (to_east, to_north) = (levelled_n.dot(&east), levelled_n.dot(&north));
    let true_north = rate.ideal_n.dot(&north);
    let rate_error2 = to_east * to_east + (to_north - true_north) * (to_north - true_north);
    Aligned {
        rotation: rotation_quaternion(&(up * atan2(to_east, to_north))) * level,
        north_unknown: rate_error2 >= NO_NORTH * NO_NORTH * true_north * true_north || no_force,
    }
}

/// Rotation vector from one direction to another, from the cross product and the dot product of the two vectors. If they are
/// opposite, the rotation is about east.
fn smallest_rotation(cross: &Vector3<f64>, dot: f64) -> Vector3<f64> {
    let sine = cross.norm_squared().sqrt();
    if sine > 0.0 {
        cross * (atan2(sine, dot) / sine)
    } else if dot < 0.0 {
        Vector3::x() * PI
    } else {
        Vector3::zeros()
    }
}
