//! Rotation vectors, quaternions, attitude angles.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::{Matrix3, Quaternion, Vector3};
use sins::math::{
    AxisTurn, Euler, RotationSeries, attitude_from_euler, euler_from_attitude, inverse_right_jacobian,
    relative_rotation, right_jacobian, rotate, rotate_inverse, rotated_z, rotation_increment,
    rotation_matrix, rotation_quaternion, rotation_vector, sin_cos,
};

#[test]
fn rotation_vector_and_quaternion_are_inverse_from_nothing_to_half_a_turn() {
    let axis = Vector3::new(0.36, -0.48, 0.8);
    for angle in [0.0, 1e-300, 1e-16, 1e-9, 1e-3, 0.12, 0.499_999, 0.500_001, 1.0, 3.0, PI - 1e-3] {
        let phi = axis * angle;
        let back = rotation_vector(&rotation_quaternion(&phi));
        // cos(n/2) near π/2 and sin near 0 have an absolute error of 1e-16, which the arc tangent spreads evenly.
        assert!((back - phi).norm() <= 8.0 * f64::EPSILON * angle, "{angle}: {}", (back - phi).norm());
    }
}

#[test]
fn relative_rotation_is_exact_at_rest_and_right_elsewhere() {
    let q = attitude_from_euler(&Euler { roll: 0.3, pitch: -0.6, heading: 5.0 });
    assert_eq!(relative_rotation(&q, &q), Quaternion::identity());
    assert_eq!(relative_rotation(&q, &-q), Quaternion::identity());
    for angle in [1e-12, 1e-3, 2.0] {
        let phi = Vector3::new(0.36, -0.48, 0.8) * angle;
        let found = rotation_vector(&relative_rotation(&q, &(q * rotation_quaternion(&phi))));
        assert!((found - phi).norm() < 8.0 * f64::EPSILON, "{angle}");
    }
}

#[test]
fn series_and_closed_form_meet() {
    for edge in [0.003_6, 0.25] {
        let below = RotationSeries::new(edge - 1e-16);
        let above = RotationSeries::new(edge);
        // In the closed form of `cubic`, cancellation enlarges the rounding error by n / n³.
        assert!((below.square - above.square).abs() < 4.0 * f64::EPSILON);
        assert!((below.cubic - above.cubic).abs() < 4.0 * f64::EPSILON / edge);
    }
    let omega = Vector3::new(0.3, -1.0, 0.5);
    let axis = Vector3::new(0.6, 0.0, 0.8);
    let low = inverse_right_jacobian(&(axis * (0.2 - 1e-15)), &omega);
    let high = inverse_right_jacobian(&(axis * 0.2), &omega);
    assert!((low - high).norm() < 1e-14);
}

#[test]
fn jacobian_and_its_inverse_cancel() {
    let phi = Vector3::new(0.4, -0.7, 1.1);
    let rate = Vector3::new(-0.2, 0.9, 0.5);
    let omega = right_jacobian(&phi, &rate);
    assert!((inverse_right_jacobian(&phi, &omega) - rate).norm() < 16.0 * f64::EPSILON);
}

#[test]
fn a_turn_about_the_axis_is_the_rotation_of_that_vector() {
    let q = attitude_from_euler(&Euler { roll: 0.3, pitch: -0.6, heading: 5.0 });
    for angle in [0.0, 7.3e-7, 6.3e-3, 6.4e-3, 2.0, -3.0] {
        let expected = rotation_increment(&Vector3::new(0.0, 0.0, angle)) * q;
        let scale = 1e-300 + angle.abs();
        assert!((AxisTurn::new(angle).increment(&q) - expected).norm() < 4.0 * f64::EPSILON * scale);
    }
}

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
