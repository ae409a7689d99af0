//! What stands beside the gyros and accelerometers: `[altimeter]`, `[start]`, `[mounting]`, `[gravity]`.

use super::super::key::{Key, Section, Shape, Target, angles, one, vector};
use super::{choice, numbers, si, unit};
use crate::sensors::Alignment;
use crate::units::{ARCMIN, ARCSEC, DEG, MILLIGAL, PPM};

const A: Section = Section::Altimeter;
const S: Section = Section::Start;
const M: Section = Section::Mounting;
const G: Section = Section::Gravity;
const N: Shape = Shape::Number;

pub const ALTIMETER: &[Key] = &[
    numbers(A, ("bias_m", si("m"), "constant bias"), N, "altimeter.bias_m", |d| {
        one(&mut d.scene.errors.altimeter.bias_m)
    }),
    numbers(
        A,
        ("noise_m", si("m"), "standard deviation of the independent error of each sample"),
        N,
        "altimeter.noise_m",
        |d| one(&mut d.scene.errors.altimeter.noise_m),
    ),
    numbers(
        A,
        ("markov_sigma_m", si("m"), "standard deviation of the Gauss-Markov error"),
        N,
        "altimeter.markov_sigma_m",
        |d| one(&mut d.scene.errors.altimeter.markov_sigma_m),
    ),
    numbers(
        A,
        ("markov_time_s", si("s"), "correlation time of the Gauss-Markov error"),
        N,
        "altimeter.markov_time_s",
        |d| one(&mut d.scene.errors.altimeter.markov_time_s),
    ),
    numbers(
        A,
        ("scale_factor_ppm", unit("ppm", PPM, ""), "scale factor error of the height"),
        N,
        "altimeter.scale_factor",
        |d| one(&mut d.scene.errors.altimeter.scale_factor),
    ),
    numbers(
        A,
        ("lag_s", si("s"), "time constant of the lag of the static pressure"),
        N,
        "altimeter.lag_s",
        |d| one(&mut d.scene.errors.altimeter.lag_s),
    ),
];

pub const START: &[Key] = &[
    numbers(
        S,
        ("position_m", si("m"), "position east, north, up"),
        Shape::Vector,
        "initial.position_enu_m",
        |d| vector(&mut d.scene.errors.initial.position_n),
    ),
    numbers(
        S,
        ("velocity_m_s", si("m/s"), "velocity east, north, up"),
        Shape::Vector,
        "initial.velocity_enu_m_s",
        |d| vector(&mut d.scene.errors.initial.velocity_n),
    ),
    numbers(
        S,
        ("misalignment_arcmin", unit("arcmin", ARCMIN, "rad"), "misalignment about east, north, up"),
        Shape::Vector,
        "initial.misalignment_enu_rad",
        |d| vector(&mut d.scene.errors.initial.misalignment_n),
    ),
    numbers(
        S,
        ("position_sigma_m", si("m"), "standard deviation of the position"),
        Shape::Axes,
        "initial.position_sigma_enu_m",
        |d| vector(&mut d.scene.errors.initial.position_sigma_n),
    ),
    numbers(
        S,
        ("velocity_sigma_m_s", si("m/s"), "standard deviation of the velocity"),
        Shape::Axes,
        "initial.velocity_sigma_enu_m_s",
        |d| vector(&mut d.scene.errors.initial.velocity_sigma_n),
    ),
    numbers(
        S,
        (
            "misalignment_sigma_arcmin",
            unit("arcmin", ARCMIN, "rad"),
            "standard deviation of the misalignment",
        ),
        Shape::Axes,
        "initial.misalignment_sigma_enu_rad",
        |d| vector(&mut d.scene.errors.initial.misalignment_sigma_n),
    ),
    choice!(S, "alignment", "alignment: given attitude, or levelling and gyrocompassing", "initial.alignment", scene.errors.initial.alignment, [
        "given" => Alignment::Given,
        "gyrocompass" => Alignment::LevelAndGyrocompass,
    ]),
];

pub const MOUNTING: &[Key] = &[
    numbers(
        M,
        ("lever_arm_m", si("m"), "lever arm from the reference point to the block, body axes"),
        Shape::Vector,
        "mounting.lever_arm_m",
        |d| vector(&mut d.scene.errors.mounting.lever_arm_m),
    ),
    numbers(
        M,
        ("boresight_deg", unit("deg", DEG, "rad"), "roll, pitch, heading of the block"),
        Shape::Vector,
        "mounting.boresight_rad",
        |d| angles(&mut d.scene.errors.mounting.boresight),
    ),
    numbers(
        M,
        ("lever_arm_error_mm", unit("mm", 1e-3, "m"), "believed less true lever arm"),
        Shape::Vector,
        "mounting.lever_arm_error_m",
        |d| vector(&mut d.scene.errors.mounting.lever_arm_error_m),
    ),
    numbers(
        M,
        ("boresight_error_arcsec", unit("arcsec", ARCSEC, "rad"), "believed less true roll, pitch, heading"),
        Shape::Vector,
        "mounting.boresight_error_rad",
        |d| angles(&mut d.scene.errors.mounting.boresight_error),
    ),
];

pub const GRAVITY: &[Key] = &[
    numbers(
        G,
        ("deflection_north_arcsec", unit("arcsec", ARCSEC, "rad"), "deflection in the meridian (xi)"),
        N,
        "gravity.deflection_north_rad",
        |d| one(&mut d.scene.errors.gravity.deflection_north.mean),
    ),
    numbers(
        G,
        (
            "deflection_north_sigma_arcsec",
            unit("arcsec", ARCSEC, "rad"),
            "standard deviation of the random part of the deflection in the meridian",
        ),
        N,
        "gravity.deflection_north_sigma_rad",
        |d| one(&mut d.scene.errors.gravity.deflection_north.sigma),
    ),
    numbers(
        G,
        (
            "deflection_north_distance_km",
            unit("km", 1e3, "m"),
            "correlation distance of the random part of the deflection in the meridian",
        ),
        N,
        "gravity.deflection_north_distance_m",
        |d| one(&mut d.scene.errors.gravity.deflection_north.distance_m),
    ),
    numbers(
        G,
        ("deflection_east_arcsec", unit("arcsec", ARCSEC, "rad"), "deflection in the prime vertical (eta)"),
        N,
        "gravity.deflection_east_rad",
        |d| one(&mut d.scene.errors.gravity.deflection_east.mean),
    ),
    numbers(
        G,
        (
            "deflection_east_sigma_arcsec",
            unit("arcsec", ARCSEC, "rad"),
            "standard deviation of the random part of the deflection in the prime vertical",
        ),
        N,
        "gravity.deflection_east_sigma_rad",
        |d| one(&mut d.scene.errors.gravity.deflection_east.sigma),
    ),
    numbers(
        G,
        (
            "deflection_east_distance_km",
            unit("km", 1e3, "m"),
            "correlation distance of the random part of the deflection in the prime vertical",
        ),
        N,
        "gravity.deflection_east_distance_m",
        |d| one(&mut d.scene.errors.gravity.deflection_east.distance_m),
    ),
    numbers(
        G,
        ("anomaly_mgal", unit("mGal", MILLIGAL, "m/s2"), "anomaly, excess of gravity"),
        N,
        "gravity.anomaly_m_s2",
        |d| one(&mut d.scene.errors.gravity.anomaly.mean),
    ),
    numbers(
        G,
        (
            "anomaly_sigma_mgal",
            unit("mGal", MILLIGAL, "m/s2"),
            "standard deviation of the random part of the anomaly",
        ),
        N,
        "gravity.anomaly_sigma_m_s2",
        |d| one(&mut d.scene.errors.gravity.anomaly.sigma),
    ),
    numbers(
        G,
        (
            "anomaly_distance_km",
            unit("km", 1e3, "m"),
            "correlation distance of the random part of the anomaly",
        ),
        N,
        "gravity.anomaly_distance_m",
        |d| one(&mut d.scene.errors.gravity.anomaly.distance_m),
    ),
];
