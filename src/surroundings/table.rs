//! The tables of the parameters of the altimeter, of the mounting and of gravity: each is listed here once.
//!
//! `build.rs` makes from the tables the structs of the interface with the header, `AltimeterParameters`, `MountingParameters`, and the
//! numbers of these and of `GravityDisturbanceParameters`. Checks, keys of scene files and rows of an error budget read the tables.

use crate::parameter::Range::{DistanceOf, TimeOf, Within};
use crate::parameter::Shape::{Angles, Number, Vector};
use crate::parameter::{CORRELATION_TIMES_S, Range, Row, own_field as field, row};
use crate::units::{ARCSEC, DEG, MILLIGAL, PPM};

const PI: f64 = core::f64::consts::PI;
const GIVEN: bool = false;
const RANDOM: bool = true;

const HEIGHT_SIZE: Range = Within(0.0, 1e5);
const ARM: Range = Within(-100.0, 100.0);

// The limits are at least ten times the largest values on Earth: 100" and 0.01 m/s² (Heiskanen and Moritz 1967).
const DEFLECTION: Range = Within(-0.01, 0.01);
const DEFLECTION_SIZE: Range = Within(0.0, 0.01);
const ANOMALY: Range = Within(-0.1, 0.1);
const ANOMALY_SIZE: Range = Within(0.0, 0.1);

const fn distance_of(sigma: &'static str) -> Range {
    DistanceOf(sigma, 1.0, 1e9)
}

/// Errors of the altimeter, in the order of the struct of the interface.
#[rustfmt::skip]
pub const ALTIMETER: [Row; 6] = [
    row("bias_m", Number, GIVEN, "constant bias",
        field(("altimeter.bias_m", "m"), Within(-1e5, 1e5), ("bias_m", "m", 1.0), "altimeter bias"), ""),
    row("markov_sigma_m", Number, RANDOM, "standard deviation of the Gauss-Markov error",
        field(("altimeter.markov_sigma_m", "m"), HEIGHT_SIZE, ("markov_sigma_m", "m", 1.0), "altimeter Gauss-Markov"),
        "The error is of first order, and stationary from the first sample on."),
    row("markov_time_s", Number, RANDOM, "correlation time of the Gauss-Markov error",
        field(("altimeter.markov_time_s", "s"), TimeOf("altimeter.markov_sigma_m", CORRELATION_TIMES_S.0, CORRELATION_TIMES_S.1),
            ("markov_time_s", "s", 1.0), ""), ""),
    row("noise_m", Number, RANDOM, "standard deviation of the independent error of each sample",
        field(("altimeter.noise_m", "m"), HEIGHT_SIZE, ("noise_m", "m", 1.0), "altimeter noise"), ""),
    row("scale_factor", Number, GIVEN, "scale factor error of the height",
        field(("altimeter.scale_factor", ""), Within(-1.0, 1.0), ("scale_factor_ppm", "ppm", PPM), "altimeter scale factor"), ""),
    row("lag_s", Number, GIVEN, "time constant of the lag of the static pressure",
        field(("altimeter.lag_s", "s"), Within(0.0, 1e6), ("lag_s", "s", 1.0), "altimeter lag"), "The lag is of first order."),
];

/// Mounting of the sensor block, in the order of the struct of the interface.
#[rustfmt::skip]
pub const MOUNTING: [Row; 4] = [
    row("lever_arm_m", Vector, GIVEN, "lever arm from the reference point to the block, body axes",
        field(("mounting.lever_arm_m", "m"), ARM, ("lever_arm_m", "m", 1.0), ""), "sins_options.axes describes the body axes."),
    // The range is that of the attitude of a flight sample.
    row("boresight", Angles, GIVEN, "roll, pitch, heading of the block",
        field(("mounting.boresight_rad", "rad"), Within(-1e4, 1e4), ("boresight_deg", "deg", DEG), ""),
        "This is the boresight: the angles of the block's axes relative to the body axes. They are defined like the attitude angles of \
            the body: positive roll right side down, positive pitch nose up, positive heading nose to the right. Whole turns do not \
            matter."),
    row("lever_arm_error_m", Vector, GIVEN, "believed less true lever arm",
        field(("mounting.lever_arm_error_m", "m"), ARM, ("lever_arm_error_mm", "mm", 1e-3), "lever arm error"), ""),
    row("boresight_error", Angles, GIVEN, "believed less true roll, pitch, heading",
        field(("mounting.boresight_error_rad", "rad"), Within(-PI, PI), ("boresight_error_arcsec", "arcsec", ARCSEC), "boresight error"),
        "If the believed heading is too large, the heading that the INS reports is too small by the same amount."),
];

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
