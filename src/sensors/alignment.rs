//! Levelling and gyrocompassing at rest.

use core::f64::consts::PI;

use nalgebra::{Quaternion, Vector3};

use crate::math::{atan2, rotate, rotation_quaternion};

/// Share of gravity below which a sensed force shows no vertical: what rounding leaves where the accelerometers show 0.
const NO_FORCE: f64 = 1e-9;
/// Share of the Earth rate's north part that a gyro error reaches where the gyros show 0, less what rounding takes off it.
const NO_NORTH: f64 = 1.0 - 1e-9;

/// What an INS at rest should sense, and the error with which it does, true east-north-up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sensed {
    /// Without errors.
    pub ideal_n: Vector3<f64>,
    /// Measured less ideal.
    pub error_n: Vector3<f64>,
}

/// What an alignment finds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aligned {
    /// R of the computed attitude C~ = R C.
    pub rotation: Quaternion<f64>,
    /// The heading may be anything: the horizontal error of the levelled rates is not smaller than the Earth rate's north part,
    /// or the accelerometers show no force to level by.
    pub north_unknown: bool,
}

/// Levels by the specific force [m/s²], whose ideal is the reaction r to the gravity that the INS computes, and finds north by the
/// angular rate [rad/s], whose ideal is the Earth's:
///
/// ```text
/// C~ = H T C    T the smallest rotation that turns the sensed force along r: no horizontal force is left
///               H the rotation about r that turns the levelled rate T ω north: by atan2 of its east and north parts
/// ```
/// To first order the misalignment is the steady state of the error equations, 0 = f×φ + nabla and 0 = -(W×φ + eps) east.
pub fn level_and_gyrocompass(force: &Sensed, rate: &Sensed) -> Aligned {
    let up = force.ideal_n / force.ideal_n.norm_squared().sqrt();
    let sensed_force_n = force.ideal_n + force.error_n;
    let level = rotation_quaternion(&smallest_rotation(&force.error_n.cross(&up), sensed_force_n.dot(&up)));
    let east = Vector3::x();
    let north = up.cross(&east);
    let levelled_n = rotate(&level, &(rate.ideal_n + rate.error_n));
    let (to_east, to_north) = (levelled_n.dot(&east), levelled_n.dot(&north));
    let true_north = rate.ideal_n.dot(&north);
    let rate_error2 = to_east * to_east + (to_north - true_north) * (to_north - true_north);
    let smallest_force = NO_FORCE * NO_FORCE * force.ideal_n.norm_squared();
    Aligned {
        rotation: rotation_quaternion(&(up * atan2(to_east, to_north))) * level,
        north_unknown: rate_error2 >= NO_NORTH * NO_NORTH * true_north * true_north
            || sensed_force_n.norm_squared() <= smallest_force,
    }
}

/// Rotation vector from one direction to another, of which `cross` and `dot` are the products; about east where they are
/// opposite.
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
