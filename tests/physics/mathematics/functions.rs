//! Sine and cosine, wrapped angles, quantiles.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use sins::math::{chi_square_quantile, normal_quantile, sin_cos_each, wrap_angle};

/// Number of degrees of freedom above which the quantile of χ² is an approximation.
const MANY: f64 = 300.0;

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

#[test]
fn normal_quantiles_are_those_of_the_tables() {
    for (probability, z) in
        [(0.5, 0.0), (0.975, 1.959_963_984_540), (0.025, -1.959_963_984_540), (0.999, 3.090_232_306_168)]
    {
        assert!((normal_quantile(probability) - z).abs() < 1e-11, "{probability}");
    }
}

/// Abramowitz and Stegun, table 26.8.
#[test]
fn quantiles_are_those_of_the_tables() {
    for (probability, degrees, value) in [
        (0.005, 1.0, 3.927_042_22e-5),
        (0.025, 1.0, 9.820_691_17e-4),
        (0.975, 1.0, 5.023_886_19),
        (0.025, 3.0, 0.215_795_283),
        (0.025, 10.0, 3.246_972_78),
        (0.975, 10.0, 20.483_177_4),
        (0.975, 100.0, 129.561_197),
    ] {
        let found = chi_square_quantile(probability, degrees);
        assert!((found / value - 1.0).abs() < 1e-8, "{probability} {degrees}: {found}");
    }
}

/// With two degrees of freedom χ² has an exponential distribution.
#[test]
fn two_degrees_are_in_closed_form() {
    for probability in [1e-9, 1e-4, 0.3, 0.7, 0.9999] {
        let found = chi_square_quantile(probability, 2.0);
        assert!((found / (-2.0 * (-probability).ln_1p()) - 1.0).abs() < 1e-9, "{probability}");
    }
}

#[test]
fn both_methods_meet() {
    for probability in [0.001, 0.025, 0.5, 0.975, 0.999] {
        let (exact, cube) =
            (chi_square_quantile(probability, MANY), chi_square_quantile(probability, MANY * (1.0 + 1e-12)));
        assert!((cube / exact - 1.0).abs() < 2e-4, "{probability}: {cube} {exact}");
    }
}
