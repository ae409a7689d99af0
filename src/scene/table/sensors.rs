//! The errors of gyros and accelerometers: `[gyro]`, `[accelerometer]`.

use super::super::key::{Key, Section, Shape, Target, matrix, one, vector};
use super::{numbers, unit};
use crate::sensors::{Grade, TriadParameters};
use crate::units::{ARCSEC, DEG, DEG_PER_HOUR, DEG_PER_SQRT_HOUR, MICRO_G, PPM, STANDARD_GRAVITY};

const G: Section = Section::Gyro;
const A: Section = Section::Accelerometer;

/// The words of a preset, and the grade of each; the first is none.
const GRADES: [(&str, Option<Grade>); 7] = [
    ("ideal", None),
    ("strategic", Some(Grade::Strategic)),
    ("navigation", Some(Grade::Navigation)),
    ("tactical", Some(Grade::Tactical)),
    ("industrial", Some(Grade::Industrial)),
    ("consumer", Some(Grade::Consumer)),
    ("paper2", Some(Grade::PaperSimulation2)),
];

/// Errors of gyros and accelerometers of a preset.
fn of_grade(index: usize) -> (TriadParameters, TriadParameters) {
    GRADES[index].1.map(Grade::parameters).unwrap_or_default()
}

/// A preset; a scene that is written states the errors themselves.
const fn preset(
    section: Section,
    field: &'static str,
    set: fn(&mut super::super::draft::Draft, usize),
) -> Key {
    let words = &[GRADES[0].0, GRADES[1].0, GRADES[2].0, GRADES[3].0, GRADES[4].0, GRADES[5].0, GRADES[6].0];
    let target = Target::Choice { field, words, get: |_| 0, set };
    Key { section, name: "preset", doc: "errors to begin with", target }
}

pub const GYRO: &[Key] = &[
    preset(G, "gyro.preset", |d, grade| d.scene.gyro = of_grade(grade).0),
    numbers(
        G,
        ("bias_deg_h", unit("deg/h", DEG_PER_HOUR), "constant bias"),
        Shape::Axes,
        "gyro.bias_rad_s",
        |d| vector(&mut d.scene.gyro.bias),
    ),
    numbers(
        G,
        ("bias_sigma_deg_h", unit("deg/h", DEG_PER_HOUR), "standard deviation of the turn-on bias"),
        Shape::Axes,
        "gyro.bias_sigma_rad_s",
        |d| vector(&mut d.scene.gyro.bias_sigma),
    ),
    numbers(
        G,
        ("markov_sigma_deg_h", unit("deg/h", DEG_PER_HOUR), "standard deviation of the Gauss-Markov bias"),
        Shape::Axes,
        "gyro.markov_sigma_rad_s",
        |d| vector(&mut d.scene.gyro.markov_sigma),
    ),
    numbers(
        G,
        ("markov_time_s", unit("s", 1.0), "its correlation time"),
        Shape::Axes,
        "gyro.markov_time_s",
        |d| vector(&mut d.scene.gyro.markov_time_s),
    ),
    numbers(
        G,
        (
            "random_walk_deg_sqrt_h",
            unit("deg/sqrt(h)", DEG_PER_SQRT_HOUR),
            "white noise: angle or velocity random walk",
        ),
        Shape::Axes,
        "gyro.random_walk_rad_sqrt_s",
        |d| vector(&mut d.scene.gyro.random_walk),
    ),
    numbers(
        G,
        (
            "rate_random_walk_deg_h_sqrt_h",
            unit("deg/h/sqrt(h)", DEG_PER_HOUR / 60.0),
            "random walk of rate or acceleration",
        ),
        Shape::Axes,
        "gyro.rate_random_walk_rad_s_sqrt_s",
        |d| vector(&mut d.scene.gyro.rate_random_walk),
    ),
    numbers(
        G,
        ("rate_ramp_deg_h2", unit("deg/h/h", DEG_PER_HOUR / 3600.0), "ramp"),
        Shape::Axes,
        "gyro.rate_ramp_rad_s2",
        |d| vector(&mut d.scene.gyro.ramp),
    ),
    numbers(
        G,
        ("flicker_deg_h", unit("deg/h", DEG_PER_HOUR), "flicker noise, bias instability B"),
        Shape::Axes,
        "gyro.flicker_rad_s",
        |d| vector(&mut d.scene.gyro.flicker),
    ),
    numbers(
        G,
        ("quantization_arcsec", unit("arcsec", ARCSEC), "pulse of the increments"),
        Shape::Axes,
        "gyro.quantization_rad",
        |d| vector(&mut d.scene.gyro.quantization),
    ),
    numbers(
        G,
        ("scale_factor_ppm", unit("ppm", PPM), "scale factor error"),
        Shape::Axes,
        "gyro.scale_factor",
        |d| vector(&mut d.scene.gyro.scale_factor),
    ),
    numbers(
        G,
        (
            "scale_factor_sigma_ppm",
            unit("ppm", PPM),
            "standard deviation of the scale factor error, drawn at turn-on",
        ),
        Shape::Axes,
        "gyro.scale_factor_sigma",
        |d| vector(&mut d.scene.gyro.scale_factor_sigma),
    ),
    numbers(
        G,
        (
            "scale_factor_asymmetry_ppm",
            unit("ppm", PPM),
            "scale factor error of positive less that of negative signals",
        ),
        Shape::Axes,
        "gyro.scale_factor_asymmetry",
        |d| vector(&mut d.scene.gyro.scale_factor_asymmetry),
    ),
    numbers(
        G,
        (
            "scale_factor_nonlinearity_ppm_per_deg_s",
            unit("ppm/(deg/s)", PPM / DEG),
            "scale factor error that grows with the signal",
        ),
        Shape::Axes,
        "gyro.scale_factor_nonlinearity_s_rad",
        |d| vector(&mut d.scene.gyro.scale_factor_nonlinearity),
    ),
    numbers(
        G,
        (
            "misalignment_arcsec",
            unit("arcsec", ARCSEC),
            "misalignment: row = sensor, column = axis it should not sense",
        ),
        Shape::OffDiagonal,
        "gyro.misalignment_rad",
        |d| matrix(&mut d.scene.gyro.misalignment),
    ),
    numbers(
        G,
        (
            "misalignment_sigma_arcsec",
            unit("arcsec", ARCSEC),
            "standard deviation of the misalignment, drawn at turn-on",
        ),
        Shape::OffDiagonal,
        "gyro.misalignment_sigma_rad",
        |d| matrix(&mut d.scene.gyro.misalignment_sigma),
    ),
    numbers(
        G,
        (
            "g_sensitivity_deg_h_per_g",
            unit("deg/h/g", DEG_PER_HOUR / STANDARD_GRAVITY),
            "g-sensitivity: row = gyro, column = axis of the specific force",
        ),
        Shape::Diagonal,
        "gyro.g_sensitivity_rad_s_per_m_s2",
        |d| matrix(&mut d.scene.gyro.g_sensitivity),
    ),
    numbers(
        G,
        ("range_deg_s", unit("deg/s", DEG), "range, where the output saturates"),
        Shape::Axes,
        "gyro.range_rad_s",
        |d| vector(&mut d.scene.gyro.range),
    ),
    numbers(
        G,
        ("bandwidth_hz", unit("Hz", 1.0), "bandwidth, -3 dB"),
        Shape::Axes,
        "gyro.bandwidth_hz",
        |d| vector(&mut d.scene.gyro.bandwidth_hz),
    ),
    numbers(
        G,
        ("dead_zone_deg_h", unit("deg/h", DEG_PER_HOUR), "half the dead zone"),
        Shape::Axes,
        "gyro.dead_zone_rad_s",
        |d| vector(&mut d.scene.gyro.dead_zone),
    ),
    numbers(
        G,
        ("reference_temperature_c", unit("deg C", 1.0), "temperature at which the next four are 0"),
        Shape::Number,
        "gyro.reference_temperature_c",
        |d| one(&mut d.scene.gyro.reference_temperature_c),
    ),
    numbers(
        G,
        ("bias_temperature_deg_h_per_k", unit("deg/h/K", DEG_PER_HOUR), "bias per kelvin"),
        Shape::Axes,
        "gyro.bias_temperature_rad_s_per_k",
        |d| vector(&mut d.scene.gyro.bias_temperature),
    ),
    numbers(
        G,
        ("bias_temperature2_deg_h_per_k2", unit("deg/h/K2", DEG_PER_HOUR), "bias per kelvin squared"),
        Shape::Axes,
        "gyro.bias_temperature2_rad_s_per_k2",
        |d| vector(&mut d.scene.gyro.bias_temperature2),
    ),
    numbers(
        G,
        ("scale_factor_temperature_ppm_per_k", unit("ppm/K", PPM), "scale factor error per kelvin"),
        Shape::Axes,
        "gyro.scale_factor_temperature_per_k",
        |d| vector(&mut d.scene.gyro.scale_factor_temperature),
    ),
    numbers(
        G,
        (
            "scale_factor_temperature2_ppm_per_k2",
            unit("ppm/K2", PPM),
            "scale factor error per kelvin squared",
        ),
        Shape::Axes,
        "gyro.scale_factor_temperature2_per_k2",
        |d| vector(&mut d.scene.gyro.scale_factor_temperature2),
    ),
];

pub const ACCELEROMETER: &[Key] = &[
    preset(A, "accel.preset", |d, grade| d.scene.accel = of_grade(grade).1),
    numbers(
        A,
        ("bias_micro_g", unit("micro-g", MICRO_G), "constant bias"),
        Shape::Axes,
        "accel.bias_m_s2",
        |d| vector(&mut d.scene.accel.bias),
    ),
    numbers(
        A,
        ("bias_sigma_micro_g", unit("micro-g", MICRO_G), "standard deviation of the turn-on bias"),
        Shape::Axes,
        "accel.bias_sigma_m_s2",
        |d| vector(&mut d.scene.accel.bias_sigma),
    ),
    numbers(
        A,
        ("markov_sigma_micro_g", unit("micro-g", MICRO_G), "standard deviation of the Gauss-Markov bias"),
        Shape::Axes,
        "accel.markov_sigma_m_s2",
        |d| vector(&mut d.scene.accel.markov_sigma),
    ),
    numbers(
        A,
        ("markov_time_s", unit("s", 1.0), "its correlation time"),
        Shape::Axes,
        "accel.markov_time_s",
        |d| vector(&mut d.scene.accel.markov_time_s),
    ),
    numbers(
        A,
        (
            "random_walk_micro_g_sqrt_hz",
            unit("micro-g/sqrt(Hz)", MICRO_G),
            "white noise: angle or velocity random walk",
        ),
        Shape::Axes,
        "accel.velocity_random_walk_m_s_sqrt_s",
        |d| vector(&mut d.scene.accel.random_walk),
    ),
    numbers(
        A,
        (
            "acceleration_random_walk_micro_g_sqrt_h",
            unit("micro-g/sqrt(h)", MICRO_G / 60.0),
            "random walk of rate or acceleration",
        ),
        Shape::Axes,
        "accel.acceleration_random_walk_m_s2_sqrt_s",
        |d| vector(&mut d.scene.accel.rate_random_walk),
    ),
    numbers(
        A,
        ("ramp_micro_g_h", unit("micro-g/h", MICRO_G / 3600.0), "ramp"),
        Shape::Axes,
        "accel.ramp_m_s3",
        |d| vector(&mut d.scene.accel.ramp),
    ),
    numbers(
        A,
        ("flicker_micro_g", unit("micro-g", MICRO_G), "flicker noise, bias instability B"),
        Shape::Axes,
        "accel.flicker_m_s2",
        |d| vector(&mut d.scene.accel.flicker),
    ),
    numbers(
        A,
        ("quantization_mm_s", unit("mm/s", 1e-3), "pulse of the increments"),
        Shape::Axes,
        "accel.quantization_m_s",
        |d| vector(&mut d.scene.accel.quantization),
    ),
    numbers(
        A,
        ("scale_factor_ppm", unit("ppm", PPM), "scale factor error"),
        Shape::Axes,
        "accel.scale_factor",
        |d| vector(&mut d.scene.accel.scale_factor),
    ),
    numbers(
        A,
        (
            "scale_factor_sigma_ppm",
            unit("ppm", PPM),
            "standard deviation of the scale factor error, drawn at turn-on",
        ),
        Shape::Axes,
        "accel.scale_factor_sigma",
        |d| vector(&mut d.scene.accel.scale_factor_sigma),
    ),
    numbers(
        A,
        (
            "scale_factor_asymmetry_ppm",
            unit("ppm", PPM),
            "scale factor error of positive less that of negative signals",
        ),
        Shape::Axes,
        "accel.scale_factor_asymmetry",
        |d| vector(&mut d.scene.accel.scale_factor_asymmetry),
    ),
    numbers(
        A,
        (
            "scale_factor_nonlinearity_ppm_per_g",
            unit("ppm/g", PPM / STANDARD_GRAVITY),
            "scale factor error that grows with the signal",
        ),
        Shape::Axes,
        "accel.scale_factor_nonlinearity_s2_m",
        |d| vector(&mut d.scene.accel.scale_factor_nonlinearity),
    ),
    numbers(
        A,
        (
            "misalignment_arcsec",
            unit("arcsec", ARCSEC),
            "misalignment: row = sensor, column = axis it should not sense",
        ),
        Shape::OffDiagonal,
        "accel.misalignment_rad",
        |d| matrix(&mut d.scene.accel.misalignment),
    ),
    numbers(
        A,
        (
            "misalignment_sigma_arcsec",
            unit("arcsec", ARCSEC),
            "standard deviation of the misalignment, drawn at turn-on",
        ),
        Shape::OffDiagonal,
        "accel.misalignment_sigma_rad",
        |d| matrix(&mut d.scene.accel.misalignment_sigma),
    ),
    numbers(
        A,
        ("range_g", unit("g", STANDARD_GRAVITY), "range, where the output saturates"),
        Shape::Axes,
        "accel.range_m_s2",
        |d| vector(&mut d.scene.accel.range),
    ),
    numbers(
        A,
        ("bandwidth_hz", unit("Hz", 1.0), "bandwidth, -3 dB"),
        Shape::Axes,
        "accel.bandwidth_hz",
        |d| vector(&mut d.scene.accel.bandwidth_hz),
    ),
    numbers(
        A,
        ("dead_zone_micro_g", unit("micro-g", MICRO_G), "half the dead zone"),
        Shape::Axes,
        "accel.dead_zone_m_s2",
        |d| vector(&mut d.scene.accel.dead_zone),
    ),
    numbers(
        A,
        ("lever_arm_mm", unit("mm", 1e-3), "place of the x, y and z sensor in the block (size effect)"),
        Shape::Matrix,
        "accel.lever_arm_m",
        |d| matrix(&mut d.scene.accel.lever_arm_m),
    ),
    numbers(
        A,
        (
            "vibration_rectification_micro_g_per_g2",
            unit("micro-g/g2", 1e-6 / STANDARD_GRAVITY),
            "vibration rectification",
        ),
        Shape::Axes,
        "accel.vibration_rectification_s2_m",
        |d| vector(&mut d.scene.accel.vibration_rectification_s2_m),
    ),
    numbers(
        A,
        ("reference_temperature_c", unit("deg C", 1.0), "temperature at which the next four are 0"),
        Shape::Number,
        "accel.reference_temperature_c",
        |d| one(&mut d.scene.accel.reference_temperature_c),
    ),
    numbers(
        A,
        ("bias_temperature_micro_g_per_k", unit("micro-g/K", MICRO_G), "bias per kelvin"),
        Shape::Axes,
        "accel.bias_temperature_m_s2_per_k",
        |d| vector(&mut d.scene.accel.bias_temperature),
    ),
    numbers(
        A,
        ("bias_temperature2_micro_g_per_k2", unit("micro-g/K2", MICRO_G), "bias per kelvin squared"),
        Shape::Axes,
        "accel.bias_temperature2_m_s2_per_k2",
        |d| vector(&mut d.scene.accel.bias_temperature2),
    ),
    numbers(
        A,
        ("scale_factor_temperature_ppm_per_k", unit("ppm/K", PPM), "scale factor error per kelvin"),
        Shape::Axes,
        "accel.scale_factor_temperature_per_k",
        |d| vector(&mut d.scene.accel.scale_factor_temperature),
    ),
    numbers(
        A,
        (
            "scale_factor_temperature2_ppm_per_k2",
            unit("ppm/K2", PPM),
            "scale factor error per kelvin squared",
        ),
        Shape::Axes,
        "accel.scale_factor_temperature2_per_k2",
        |d| vector(&mut d.scene.accel.scale_factor_temperature2),
    ),
];
