//! Attitude angles: roll, pitch and heading.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Quaternion;

use super::arc_tangent::{atan2_of_positive, atan2_of_two};
use super::pair::Pair;
use super::sine::sin_cos_each;
use super::transcendental::wrap_angle;

/// Attitude angles of body axes right-forward-up relative to east-north-up [rad].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Euler {
    /// Right wing down positive, -π..π.
    pub roll: f64,
    /// Nose up positive, -π/2..π/2.
    pub pitch: f64,
    /// Clockwise from true north, 0..2π.
    pub heading: f64,
}

/// `q_nb` of the aerospace sequence heading, pitch, roll: C = Rz(-heading) Rx(pitch) Ry(roll).
pub fn attitude_from_euler(euler: &Euler) -> Quaternion<f64> {
    let (sines, cosines) = sin_cos_each(&[0.5 * euler.roll, 0.5 * euler.pitch, 0.5 * euler.heading]);
    attitude_from_half_angles(&sines, &cosines)
}

/// [`attitude_from_euler`], from the sines and cosines of half of roll, pitch and heading.
#[inline]
pub fn attitude_from_half_angles(&[sr, sp, sh]: &[f64; 3], &[cr, cp, ch]: &[f64; 3]) -> Quaternion<f64> {
    Quaternion::new(
        ch * cp * cr + sh * sp * sr,
        ch * sp * cr + sh * cp * sr,
        ch * cp * sr - sh * sp * cr,
        ch * sp * sr - sh * cp * cr,
    )
}

/// Attitude angles of `q_nb`, by the sum and the difference of heading and roll. Near pitch ±90° only one of these two is
/// defined, and it keeps all its digits.
#[inline(always)]
pub fn euler_from_attitude(q: &Quaternion<f64>) -> Euler {
    // The points (w + x, -(y + z)) and (w - x, y - z).
    let along = Pair::both(q.w) + Pair::new(q.i, -q.i);
    let across = Pair::new(-q.j, q.j) - Pair::both(q.k);
    let sizes = (along * along + across * across).sqrt();
    let halves = atan2_of_two(across, along);
    let (half_difference, half_sum) = (halves.first(), halves.second());
    let from_nadir = atan2_of_positive(sizes.first(), sizes.second());
    let pitch = 2.0 * from_nadir - FRAC_PI_2;
    let heading = wrap_angle(half_sum + half_difference);
    let mut roll = half_sum - half_difference;
    if roll.abs() > PI {
        roll = wrap_angle(roll);
    }
    Euler { roll, pitch, heading: if heading < 0.0 { heading + TAU } else { heading } }
}
