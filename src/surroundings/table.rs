//! The tables of the parameters of the altimeter, of the mounting, of gravity, of the errors at the start and of the start of a flight:
//! each is listed here once.
//!
//! `build.rs` makes from the tables the structs of the interface with the header, those of the crate, and the numbers of both. The crate
//! itself has `GravityDisturbanceParameters`. Checks, keys of scene files and rows of an error budget read the tables.

use crate::base::parameter::Range::{DistanceOf, OffOr, TimeOf, Within};
use crate::base::parameter::Shape::{Angles, Axes, Number, Vector};
use crate::base::parameter::{CORRELATION_TIMES_S, Range, Row, choice, own_field as field, row};
use crate::base::units::{ARCMIN, ARCSEC, DEG, MILLIGAL, PPM};

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

/// Errors at the start, in the order of the struct of the interface.
#[rustfmt::skip]
pub const INITIAL: [Row; 8] = [
    row("position_n", Vector, GIVEN, "position error, east-north-up",
        field(("initial.position_enu_m", "m"), Within(-1e6, 1e6), ("position_m", "m", 1.0), "initial position"),
        "The horizontal part is laid off at the height of the solution, and sins_errors measures it at the height of the truth: with an \
            error of 100 m in height, 3 km read back 0.046 m larger."),
    row("velocity_n", Vector, GIVEN, "velocity error, east-north-up",
        field(("initial.velocity_enu_m_s", "m/s"), Within(-1e4, 1e4), ("velocity_m_s", "m/s", 1.0), "initial velocity"), ""),
    row("misalignment_n", Vector, GIVEN, "misalignment phi, a rotation vector, east-north-up",
        field(("initial.misalignment_enu_rad", "rad"), Within(-PI, PI), ("misalignment_arcmin", "arcmin", ARCMIN), "initial misalignment"),
        "Computed C = exp(-[phi x]) C0. C turns vectors from sensor axes to east-north-up. C0 is the true C. With \
            SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS or SINS_ALIGNMENT_LEVEL, C0 is the C that the alignment finds."),
    row("position_sigma_n", Axes, RANDOM, "standard deviation of the position error",
        field(("initial.position_sigma_enu_m", "m"), Within(0.0, 1e5), ("position_sigma_m", "m", 1.0), "drawn initial position"), ""),
    row("velocity_sigma_n", Axes, RANDOM, "standard deviation of the velocity error",
        field(("initial.velocity_sigma_enu_m_s", "m/s"), Within(0.0, 1e3),
            ("velocity_sigma_m_s", "m/s", 1.0), "drawn initial velocity"), ""),
    row("misalignment_sigma_n", Axes, RANDOM, "standard deviation of the misalignment",
        field(("initial.misalignment_sigma_enu_rad", "rad"), Within(0.0, 1.0),
            ("misalignment_sigma_arcmin", "arcmin", ARCMIN), "drawn initial misalignment"), ""),
    choice("alignment", ("Alignment", "sins_alignment"), ("initial.alignment", "alignment at the start"), ""),
    row("alignment_s", Number, GIVEN, "length of the alignment, at rest before the first sample; 0: without end",
        field(("initial.alignment_s", "s"), OffOr(1.0, 86_400.0), ("alignment_s", "s", 1.0), ""),
        "Tilt is found from the mean specific force, heading from the mean rate: white noise and quantization are averaged over this \
            time, and Gauss-Markov, flicker, random walk and ramp errors have their mean of this time. Dead zone and range act on the \
            mean. The temperature is that of the first sample. The flight begins with the states with which the alignment ended: ramps \
            and random walks begin at 0 when the alignment begins. An alignment without end leaves out white noise and quantization, \
            and takes the errors at the first sample for their mean. A reposition aligns again, from the present states of the sensors. \
            SINS_ALIGNMENT_GIVEN does not use it."),
];

/// Start of a flight, in the order of the struct of the interface.
#[rustfmt::skip]
pub const START: [Row; 8] = [
    row("latitude_rad", Number, GIVEN, "geodetic latitude of the start",
        field(("start.latitude_rad", "rad"), Within(-0.5 * PI, 0.5 * PI), ("latitude_deg", "deg", DEG), ""), ""),
    row("longitude_rad", Number, GIVEN, "longitude of the start, east positive",
        field(("start.longitude_rad", "rad"), Within(-100.0, 100.0), ("longitude_deg", "deg", DEG), ""), ""),
    row("height_m", Number, GIVEN, "height of the start above the ellipsoid",
        field(("start.height_m", "m"), Within(-20e3, 2000e3), ("height_m", "m", 1.0), ""), ""),
    row("speed_m_s", Number, GIVEN, "speed at the start against the Earth",
        field(("start.speed_m_s", "m/s"), Within(0.0, 10e3), ("speed_m_s", "m/s", 1.0), ""), ""),
    row("heading_rad", Number, GIVEN, "course and heading at the start",
        field(("start.heading_rad", "rad"), Within(-100.0, 100.0), ("heading_deg", "deg", DEG), ""), ""),
    row("roll_rad", Number, GIVEN, "roll of the body relative to the axes of the path, throughout the flight",
        field(("start.roll_rad", "rad"), Within(-PI, PI), ("roll_deg", "deg", DEG), ""), ""),
    row("pitch_rad", Number, GIVEN, "pitch of the body relative to the axes of the path, throughout the flight",
        field(("start.pitch_rad", "rad"), Within(-0.5 * PI, 0.5 * PI), ("pitch_deg", "deg", DEG), ""),
        "It is the angle of attack, or the tilt at rest."),
    choice("ellipsoid", ("Ellipsoid", "sins_earth"), ("start.earth", "ellipsoid"),
        "It is that of the options of the simulator that will fly it."),
];
