//! Sine and cosine, wrapped angles.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use sins::math::{sin_cos_each, wrap_angle};

fn ulps(found: f64, expected: f64) -> f64 {
    (found - expected).abs() / (expected.abs() * f64::EPSILON).max(f64::MIN_POSITIVE)
}

/// Compared with the library's functions, which are themselves within an ulp of the truth.
#[test]
fn within_an_ulp_from_nothing_to_the_limit() {
    let check = |angle: f64| {
        let ([sine], [cosine]) = sin_cos_each(&[angle]);
        let (expected_sine, expected_cosine) = libm::sincos(angle);
        assert!(ulps(sine, expected_sine) <= 1.0, "sin {angle:e}: {sine:e} {expected_sine:e}");
        assert!(ulps(cosine, expected_cosine) <= 1.0, "cos {angle:e}: {cosine:e} {expected_cosine:e}");
    };
    for k in 0..200_000 {
        let turns = f64::from(k - 100_000);
        check(turns * 1e-4);
        check(turns * 0.998);
        // At and near the multiples of a quarter turn, where sine or cosine consists of rounding errors only.
        let quarter = f64::from(k % 60_000 - 30_000) * FRAC_PI_2;
        check(quarter);
        check(quarter * (1.0 + 3.0 * f64::EPSILON));
    }
    for small in [0.0, -0.0, 1e-300, -1e-20, 1e-9] {
        check(small);
    }
}

#[test]
fn angles_of_one_call_do_not_meet() {
    let angles = [0.1, -3.0, 700.0, 1e6, -1.5];
    let (sines, cosines) = sin_cos_each(&angles);
    for i in 0..angles.len() {
        assert!(ulps(sines[i], libm::sin(angles[i])) <= 1.0);
        assert!(ulps(cosines[i], libm::cos(angles[i])) <= 1.0);
    }
    assert!(sin_cos_each(&[0.1, f64::NAN]).0[1].is_nan());
}

#[test]
fn an_angle_is_wrapped_by_its_exact_remainder() {
    let check = |angle: f64| {
        let expected = if angle.abs() <= PI { angle } else { libm::remainder(angle, TAU) };
        assert_eq!(wrap_angle(angle).to_bits(), expected.to_bits(), "{angle:e}");
    };
    for k in -2_000_000..2_000_000 {
        check(f64::from(k) * 7.3e-6);
    }
    for turns in 0..40_u64 {
        for ulps in -3..=3_i64 {
            let angle = f64::from_bits((0.25 * turns as f64 * TAU).to_bits().saturating_add_signed(ulps));
            check(angle);
            check(-angle);
        }
    }
}
