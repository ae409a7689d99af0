//! What stands beside the gyros and accelerometers: `[altimeter]`, `[start]`, `[mounting]`, `[gravity]`.

use super::super::key::{Key, Place, Section, Shape, Target, angles, one, vector};
use super::{choice, number, si, unit};
use crate::sensors::Alignment;
use crate::units::{ARCMIN, ARCSEC, DEG, MILLIGAL, PPM};

const A: Section = Section::Altimeter;
const S: Section = Section::Start;
const M: Section = Section::Mounting;
const G: Section = Section::Gravity;
const N: Shape = Shape::Number;

pub const ALTIMETER: &[Key] = &[
    number!(A, N, "bias_m", si("m"), "constant bias", "altimeter.bias_m" => one(scene.errors.altimeter.bias_m)),
    number!(A, N, "noise_m", si("m"), "standard deviation of the independent error of each sample",
        "altimeter.noise_m" => one(scene.errors.altimeter.noise_m)),
    number!(A, N, "markov_sigma_m", si("m"), "standard deviation of the Gauss-Markov error",
        "altimeter.markov_sigma_m" => one(scene.errors.altimeter.markov_sigma_m)),
    number!(A, N, "markov_time_s", si("s"), "correlation time of the Gauss-Markov error",
        "altimeter.markov_time_s" => one(scene.errors.altimeter.markov_time_s)),
    number!(A, N, "scale_factor_ppm", unit("ppm", PPM, ""), "scale factor error of the height",
        "altimeter.scale_factor" => one(scene.errors.altimeter.scale_factor)),
    number!(A, N, "lag_s", si("s"), "time constant of the lag of the static pressure",
        "altimeter.lag_s" => one(scene.errors.altimeter.lag_s)),
];

pub const START: &[Key] = &[
    super::sensors::START,
    number!(S, Shape::Vector, "position_m", si("m"), "position east, north, up",
        "initial.position_enu_m" => vector(scene.errors.initial.position_n)),
    number!(S, Shape::Vector, "velocity_m_s", si("m/s"), "velocity east, north, up",
        "initial.velocity_enu_m_s" => vector(scene.errors.initial.velocity_n)),
    number!(S, Shape::Vector, "misalignment_arcmin", unit("arcmin", ARCMIN, "rad"), "misalignment about east, north, up",
        "initial.misalignment_enu_rad" => vector(scene.errors.initial.misalignment_n)),
    number!(S, Shape::Axes, "position_sigma_m", si("m"), "standard deviation of the position",
        "initial.position_sigma_enu_m" => vector(scene.errors.initial.position_sigma_n)),
    number!(S, Shape::Axes, "velocity_sigma_m_s", si("m/s"), "standard deviation of the velocity",
        "initial.velocity_sigma_enu_m_s" => vector(scene.errors.initial.velocity_sigma_n)),
    number!(S, Shape::Axes, "misalignment_sigma_arcmin", unit("arcmin", ARCMIN, "rad"), "standard deviation of the misalignment",
        "initial.misalignment_sigma_enu_rad" => vector(scene.errors.initial.misalignment_sigma_n)),
    choice!(S, "alignment", "alignment: given attitude, levelling and gyrocompassing, or levelling with the true heading", "initial.alignment",
        scene.errors.initial.alignment, [
        "given" => Alignment::Given,
        "gyrocompass" => Alignment::LevelAndGyrocompass,
        "level" => Alignment::Level,
    ]),
    number!(S, N, "alignment_s", si("s"), "length of the alignment, at rest before the first sample; 0: without end",
        "initial.alignment_s" => one(scene.errors.initial.alignment_s)),
];

pub const MOUNTING: &[Key] = &[
    number!(M, Shape::Vector, "lever_arm_m", si("m"), "lever arm from the reference point to the block, body axes",
        "mounting.lever_arm_m" => vector(scene.errors.mounting.lever_arm_m)),
    number!(M, Shape::Vector, "boresight_deg", unit("deg", DEG, "rad"), "roll, pitch, heading of the block",
        "mounting.boresight_rad" => angles(scene.errors.mounting.boresight)),
    number!(M, Shape::Vector, "lever_arm_error_mm", unit("mm", 1e-3, "m"), "believed less true lever arm",
        "mounting.lever_arm_error_m" => vector(scene.errors.mounting.lever_arm_error_m)),
    number!(M, Shape::Vector, "boresight_error_arcsec", unit("arcsec", ARCSEC, "rad"), "believed less true roll, pitch, heading",
        "mounting.boresight_error_rad" => angles(scene.errors.mounting.boresight_error)),
];

pub const GRAVITY: &[Key] = &[
    number!(G, N, "deflection_north_arcsec", unit("arcsec", ARCSEC, "rad"), "deflection in the meridian (xi)",
        "gravity.deflection_north_rad" => one(scene.errors.gravity.deflection_north.mean)),
    number!(G, N, "deflection_north_sigma_arcsec", unit("arcsec", ARCSEC, "rad"),
        "standard deviation of the random part of the deflection in the meridian",
        "gravity.deflection_north_sigma_rad" => one(scene.errors.gravity.deflection_north.sigma)),
    number!(G, N, "deflection_north_distance_km", unit("km", 1e3, "m"),
        "correlation distance of the random part of the deflection in the meridian",
        "gravity.deflection_north_distance_m" => one(scene.errors.gravity.deflection_north.distance_m)),
    number!(G, N, "deflection_east_arcsec", unit("arcsec", ARCSEC, "rad"), "deflection in the prime vertical (eta)",
        "gravity.deflection_east_rad" => one(scene.errors.gravity.deflection_east.mean)),
    number!(G, N, "deflection_east_sigma_arcsec", unit("arcsec", ARCSEC, "rad"),
        "standard deviation of the random part of the deflection in the prime vertical",
        "gravity.deflection_east_sigma_rad" => one(scene.errors.gravity.deflection_east.sigma)),
    number!(G, N, "deflection_east_distance_km", unit("km", 1e3, "m"),
        "correlation distance of the random part of the deflection in the prime vertical",
        "gravity.deflection_east_distance_m" => one(scene.errors.gravity.deflection_east.distance_m)),
    number!(G, N, "anomaly_mgal", unit("mGal", MILLIGAL, "m/s2"), "anomaly, excess of gravity",
        "gravity.anomaly_m_s2" => one(scene.errors.gravity.anomaly.mean)),
    number!(G, N, "anomaly_sigma_mgal", unit("mGal", MILLIGAL, "m/s2"),
        "standard deviation of the random part of the anomaly",
        "gravity.anomaly_sigma_m_s2" => one(scene.errors.gravity.anomaly.sigma)),
    number!(G, N, "anomaly_distance_km", unit("km", 1e3, "m"),
        "correlation distance of the random part of the anomaly",
        "gravity.anomaly_distance_m" => one(scene.errors.gravity.anomaly.distance_m)),
];
