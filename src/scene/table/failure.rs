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
        "what fails",
        "failure.sensor",
        SENSORS,
        |d| d.failure.sensor,
        |d, sensor| d.failure.sensor = sensor,
    ),
    choice(
        "axis",
        "of a gyro or an accelerometer",
        "failure.axis",
        &["x", "y", "z"],
        |d| d.failure.axis,
        |d, axis| d.failure.axis = axis,
    ),
    choice(
        "kind",
        "how it fails; none is switched off",
        "failure.kind",
        KIND_WORDS,
        |d| d.failure.kind,
        |d, kind| d.failure.kind = kind,
    ),
    within(F, ("from_s", si("s"), "time since the start of the flight"), (0.0, 1e9), "failure.from_s", |d| {
        one(&mut d.failure.from_s)
    }),
    within(
        F,
        ("until_s", si("s"), "time since the start of the flight; default to its end"),
        (0.0, 1e9),
        "failure.until_s",
        |d| one(&mut d.failure.until_s),
    ),
    numbers(
        F,
        ("size_deg_h", unit("deg/h", DEG_PER_HOUR, "rad/s"), "bias step, spikes of a gyro"),
        N,
        "failure.size_rad_s",
        |d| one(&mut d.failure.size),
    ),
    numbers(
        F,
        ("size_micro_g", unit("micro-g", MICRO_G, "m/s2"), "bias step, spikes of an accelerometer"),
        N,
        "failure.size_m_s2",
        |d| one(&mut d.failure.size),
    ),
    numbers(F, ("size_m", si("m"), "bias step, spikes of the altimeter"), N, "failure.size_m", |d| {
        one(&mut d.failure.size)
    }),
    numbers(
        F,
        ("density_deg_sqrt_h", unit("deg/sqrt(h)", DEG_PER_SQRT_HOUR, "rad/sqrt(s)"), "noise of a gyro"),
        N,
        "failure.density_rad_sqrt_s",
        |d| one(&mut d.failure.density),
    ),
    numbers(
        F,
        (
            "density_micro_g_sqrt_hz",
            unit("micro-g/sqrt(Hz)", MICRO_G, "(m/s)/sqrt(s)"),
            "noise of an accelerometer",
        ),
        N,
        "failure.density_m_s_sqrt_s",
        |d| one(&mut d.failure.density),
    ),
    numbers(
        F,
        ("density_m_sqrt_hz", si("m/sqrt(Hz)"), "noise of the altimeter"),
        N,
        "failure.density_m_sqrt_hz",
        |d| one(&mut d.failure.density),
    ),
    numbers(
        F,
        ("interval_s", si("s"), "spikes, drop-outs: from one to the next"),
        N,
        "failure.interval_s",
        |d| one(&mut d.failure.interval_s),
    ),
    numbers(F, ("duration_s", si("s"), "spikes: length of one"), N, "failure.duration_s", |d| {
        one(&mut d.failure.duration_s)
    }),
    numbers(
        F,
        ("probability", PURE, "drop-outs without interval_s: that a sample interval is lost"),
        N,
        "failure.probability",
        |d| one(&mut d.failure.probability),
    ),
];
