//! The error ellipse and its circles.

use std::f64::consts::PI;

use sins::errors::covariance::ErrorEllipse;

#[test]
fn circle_and_line_are_their_closed_forms() {
    for size in [1e-3, 1.0, 4e4] {
        let of = |minor| ErrorEllipse { major_m: size, minor_m: size * minor, azimuth_rad: 0.0 };
        for (radius, expected) in [
            (of(1.0).cep50_m(), (2.0 * 2.0f64.ln()).sqrt()),
            (of(1.0).radial_95_m(), (2.0 * 20.0f64.ln()).sqrt()),
            // Quantiles of the normal distribution.
            (of(0.0).cep50_m(), 0.674_489_750_196_081_7),
            (of(0.0).radial_95_m(), 1.959_963_984_540_054),
        ] {
            assert!((radius / size - expected).abs() < 1e-9, "{radius} of {expected}");
        }
    }
    assert_eq!(ErrorEllipse::new(0.0, 0.0, 0.0).cep50_m(), 0.0);
}

/// The density of an ellipse, summed over rings of its own plane: another integral than the one that is used.
#[test]
fn an_ellipse_between_holds_what_it_says() {
    let (major, minor) = (3.0, 0.8);
    let ellipse = ErrorEllipse { major_m: major, minor_m: minor, azimuth_rad: 0.0 };
    for (radius, wanted) in [(ellipse.cep50_m(), 0.5), (ellipse.radial_95_m(), 0.95)] {
        let (rings, angles) = (400, 400);
        let mut inside = 0.0;
        for ring in 0..rings {
            let r = (f64::from(ring) + 0.5) * radius / f64::from(rings);
            for angle in 0..angles {
                let t = f64::from(angle) * 2.0 * PI / f64::from(angles);
                let (x, y) = (r * t.cos() / major, r * t.sin() / minor);
                inside += (-0.5 * (x * x + y * y)).exp() * r;
            }
        }
        inside *= radius / f64::from(rings) / f64::from(angles) / (major * minor);
        // The rings' midpoint rule: (R/400)²/24 of the second derivative.
        assert!((inside - wanted).abs() < 1e-5, "{inside} of {wanted}");
    }
}

#[test]
fn the_azimuth_is_that_of_the_major_axis() {
    for degrees in [0.0f64, 10.0, 45.0, 90.0, 120.0, 179.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let (major2, minor2) = (25.0, 4.0);
        // The major axis points sin east and cos north.
        let east = major2 * sin * sin + minor2 * cos * cos;
        let north = major2 * cos * cos + minor2 * sin * sin;
        let ellipse = ErrorEllipse::new(east, north, (major2 - minor2) * sin * cos);
        assert!((ellipse.major_m - 5.0).abs() < 1e-14 && (ellipse.minor_m - 2.0).abs() < 1e-14);
        assert!((ellipse.azimuth_rad - degrees.to_radians()).abs() < 1e-14);
    }
}
