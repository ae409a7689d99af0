//! Failures of sensors: `[[failure]]`.

use super::super::draft::FAILURE_KINDS;
use super::super::key::{Key, Section, Shape, Target, one};
use super::{PURE, first_words, numbers, si, unit, within};
use crate::units::{DEG_PER_HOUR, DEG_PER_SQRT_HOUR, MICRO_G};

const F: Section = Section::Failure;
const N: Shape = Shape::Number;

/// The keys of one quantity for a gyro, an accelerometer and the altimeter.
pub const BY_SENSOR: [[&str; 3]; 2] = [
    ["size_deg_h", "size_micro_g", "size_m"],
    ["density_deg_sqrt_h", "density_micro_g_sqrt_hz", "density_m_sqrt_hz"],
];

/// The sensors that can fail, in the order of [`BY_SENSOR`].
pub const SENSORS: &[&str] = &["gyro", "accelerometer", "altimeter"];

const KIND_WORDS: &[&str] = &first_words(FAILURE_KINDS);

const fn choice(
    name: &'static str,
    doc: &'static str,
    field: &'static str,
    words: &'static [&'static str],
    get: fn(&super::super::draft::Draft) -> usize,
    set: fn(&mut super::super::draft::Draft, usize),
) -> Key {
    Key { section: F, name, doc, target: Target::Choice { field, words, get, set } }
}

pub const FAILURE: &[Key] = &[
    choice(
        "sensor",
        "sensor that fails",
        "failure.sensor",
        SENSORS,
        |d| d.failure.sensor,
        |d, sensor| d.failure.sensor = sensor,
    ),
    choice(
        "axis",
        "axis that fails, of a gyro or an accelerometer",
        "failure.axis",
        &["x", "y", "z"],
        |d| d.failure.axis,
        |d, axis| d.failure.axis = axis,
    ),
    choice(
        "kind",
        "kind of the failure; none: the failure is off",
        "failure.kind",
        KIND_WORDS,
        |d| d.failure.kind,
        |d, kind| d.failure.kind = kind,
    ),
    within(
        F,
        ("from_s", si("s"), "start of the failure, from the start of the flight"),
        (0.0, 1e9),
        "failure.from_s",
        |d| one(&mut d.failure.from_s),
    ),
    within(
        F,
        (
            "until_s",
            si("s"),
            "end of the failure, from the start of the flight; default: the end of the flight",
        ),
        (0.0, 1e9),
        "failure.until_s",
        |d| one(&mut d.failure.until_s),
    ),
    numbers(
        F,
        ("size_deg_h", unit("deg/h", DEG_PER_HOUR, "rad/s"), "size of a bias step or of spikes, of a gyro"),
        N,
        "failure.size_rad_s",
        |d| one(&mut d.failure.size),
    ),
    numbers(
        F,
        (
            "size_micro_g",
            unit("micro-g", MICRO_G, "m/s2"),
            "size of a bias step or of spikes, of an accelerometer",
        ),
        N,
        "failure.size_m_s2",
        |d| one(&mut d.failure.size),
    ),
    numbers(
        F,
        ("size_m", si("m"), "size of a bias step or of spikes, of the altimeter"),
        N,
        "failure.size_m",
        |d| one(&mut d.failure.size),
    ),
    numbers(
        F,
        (
            "density_deg_sqrt_h",
            unit("deg/sqrt(h)", DEG_PER_SQRT_HOUR, "rad/sqrt(s)"),
            "density of the noise, of a gyro",
        ),
        N,
        "failure.density_rad_sqrt_s",
        |d| one(&mut d.failure.density),
    ),
    numbers(
        F,
        (
            "density_micro_g_sqrt_hz",
            unit("micro-g/sqrt(Hz)", MICRO_G, "(m/s)/sqrt(s)"),
            "density of the noise, of an accelerometer",
        ),
        N,
        "failure.density_m_s_sqrt_s",
        |d| one(&mut d.failure.density),
    ),
    numbers(
        F,
        ("density_m_sqrt_hz", si("m/sqrt(Hz)"), "density of the noise, of the altimeter"),
        N,
        "failure.density_m_sqrt_hz",
        |d| one(&mut d.failure.density),
    ),
    numbers(
        F,
        ("interval_s", si("s"), "spikes, drop-outs: time from the start of one to the start of the next"),
        N,
        "failure.interval_s",
        |d| one(&mut d.failure.interval_s),
    ),
    numbers(F, ("duration_s", si("s"), "spikes: length of one spike"), N, "failure.duration_s", |d| {
        one(&mut d.failure.duration_s)
    }),
    numbers(
        F,
        ("probability", PURE, "drop-outs without interval_s: probability that a sample interval is lost"),
        N,
        "failure.probability",
        |d| one(&mut d.failure.probability),
    ),
];
