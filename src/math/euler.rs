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

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, Vector3};

    use super::*;
    use crate::math::{rotate, rotate_inverse, rotated_z, rotation_matrix, sin_cos};

    #[test]
    fn euler_angles_are_the_sequence_heading_pitch_roll() {
        let euler = Euler { roll: 0.3, pitch: -0.6, heading: 5.0 };
        let (sr, cr) = sin_cos(euler.roll);
        let (sp, cp) = sin_cos(euler.pitch);
        let (sh, ch) = sin_cos(euler.heading);
        let c = Matrix3::new(ch, sh, 0.0, -sh, ch, 0.0, 0.0, 0.0, 1.0)
            * Matrix3::new(1.0, 0.0, 0.0, 0.0, cp, -sp, 0.0, sp, cp)
            * Matrix3::new(cr, 0.0, sr, 0.0, 1.0, 0.0, -sr, 0.0, cr);
        let q = attitude_from_euler(&euler);
        for v in [Vector3::x(), Vector3::y(), Vector3::z()] {
            assert!((rotate(&q, &v) - c * v).norm() < 8.0 * f64::EPSILON);
            assert!((rotation_matrix(&q) * v - c * v).norm() < 8.0 * f64::EPSILON);
            assert!((rotated_z(&q) - c * Vector3::z()).norm() < 8.0 * f64::EPSILON);
            assert!((rotate_inverse(&q, &v) - c.transpose() * v).norm() < 8.0 * f64::EPSILON);
        }
    }

    #[test]
    fn euler_angles_come_back_even_beside_the_gimbal_lock() {
        for pitch in [-FRAC_PI_2, -FRAC_PI_2 + 1e-12, -1.0, 0.0, 1.5, FRAC_PI_2 - 1e-9, FRAC_PI_2] {
            for roll in [-3.1, -1.0, 0.0, 2.0] {
                for heading in [0.0, 1.0, 3.2, 6.2] {
                    let q = attitude_from_euler(&Euler { roll, pitch, heading });
                    let back = euler_from_attitude(&q);
                    let again = attitude_from_euler(&back);
                    assert!((again - q).norm().min((again + q).norm()) < 4.0 * f64::EPSILON);
                    assert!((back.pitch - pitch).abs() < 4.0 * f64::EPSILON);
                    assert!((0.0..=TAU).contains(&back.heading) && back.roll.abs() <= PI);
                }
            }
        }
    }
}
