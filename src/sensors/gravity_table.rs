//! The table of the parameters of the gravity disturbance: each is listed here once.
//!
//! `build.rs` makes from it the struct of the interface with the header, that of the crate, and the numbers of both. Checks, keys of
//! scene files and rows of an error budget read it.

use crate::base::parameter::Range::{DistanceOf, Within};
use crate::base::parameter::Shape::Number;
use crate::base::parameter::{GIVEN, RANDOM, Range, Row, own_field as field, row};
use crate::base::units::{ARCSEC, MILLIGAL};

// The limits are at least ten times the largest values on Earth: 100" and 0.01 m/s² (Heiskanen and Moritz 1967).
const DEFLECTION: Range = Within(-0.01, 0.01);
const DEFLECTION_SIZE: Range = Within(0.0, 0.01);
const ANOMALY: Range = Within(-0.1, 0.1);
const ANOMALY_SIZE: Range = Within(0.0, 0.1);

const fn distance_of(sigma: &'static str) -> Range {
    DistanceOf(sigma, 1.0, 1e9)
}

/// Gravity disturbance, in the order of the struct of the interface.
#[rustfmt::skip]
pub const GRAVITY: [Row; 9] = [
    row("deflection_north.mean", Number, GIVEN, "deflection in the meridian (xi)",
        field(("gravity.deflection_north_rad", "rad"), DEFLECTION, ("deflection_north_arcsec", "arcsec", ARCSEC), "deflection north"),
        "It is the astronomic less the geodetic latitude. If positive, the true zenith lies north of the ellipsoid's normal, and the \
            accelerometers at rest measure g times this to the north."),
    row("deflection_north.sigma", Number, RANDOM, "standard deviation of the random part of the deflection in the meridian",
        field(("gravity.deflection_north_sigma_rad", "rad"), DEFLECTION_SIZE,
            ("deflection_north_sigma_arcsec", "arcsec", ARCSEC), "random deflection north"), ""),
    row("deflection_north.distance_m", Number, RANDOM, "correlation distance of the random part of the deflection in the meridian",
        field(("gravity.deflection_north_distance_m", "m"), distance_of("gravity.deflection_north_sigma_rad"),
            ("deflection_north_distance_km", "km", 1e3), ""), ""),
    row("deflection_east.mean", Number, GIVEN, "deflection in the prime vertical (eta)",
        field(("gravity.deflection_east_rad", "rad"), DEFLECTION, ("deflection_east_arcsec", "arcsec", ARCSEC), "deflection east"),
        "It is the astronomic less the geodetic longitude, times the cosine of latitude. If positive, the true zenith lies east of the \
            ellipsoid's normal."),
    row("deflection_east.sigma", Number, RANDOM, "standard deviation of the random part of the deflection in the prime vertical",
        field(("gravity.deflection_east_sigma_rad", "rad"), DEFLECTION_SIZE,
            ("deflection_east_sigma_arcsec", "arcsec", ARCSEC), "random deflection east"), ""),
    row("deflection_east.distance_m", Number, RANDOM, "correlation distance of the random part of the deflection in the prime vertical",
        field(("gravity.deflection_east_distance_m", "m"), distance_of("gravity.deflection_east_sigma_rad"),
            ("deflection_east_distance_km", "km", 1e3), ""), ""),
    row("anomaly.mean", Number, GIVEN, "anomaly, excess of gravity",
        field(("gravity.anomaly_m_s2", "m/s2"), ANOMALY, ("anomaly_mgal", "mGal", MILLIGAL), "gravity anomaly"),
        "A milligal is 1e-5 m/s2."),
    row("anomaly.sigma", Number, RANDOM, "standard deviation of the random part of the anomaly",
        field(("gravity.anomaly_sigma_m_s2", "m/s2"), ANOMALY_SIZE, ("anomaly_sigma_mgal", "mGal", MILLIGAL), "random gravity anomaly"), ""),
    row("anomaly.distance_m", Number, RANDOM, "correlation distance of the random part of the anomaly",
        field(("gravity.anomaly_distance_m", "m"), distance_of("gravity.anomaly_sigma_m_s2"), ("anomaly_distance_km", "km", 1e3), ""), ""),
];
