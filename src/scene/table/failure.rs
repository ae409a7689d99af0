//! Failures of sensors: `[[failure]]`.

use super::super::key::{Key, Place, Section, Target, one};
use super::{PURE, number, si, unit, word};
use crate::base::parameter::Shape;
use crate::base::units::{DEG_PER_HOUR, DEG_PER_SQRT_HOUR, MICRO_G};
use crate::scene::schedule::TIMES_S;
use crate::sensors::{Failure, FailureFields};

const F: Section = Section::Failure;
const N: Shape = Shape::Number;

/// The keys of one quantity for a gyro, an accelerometer and the altimeter.
pub const BY_SENSOR: [[&str; 3]; 2] = [
    ["size_deg_h", "size_micro_g", "size_m"],
    ["density_deg_sqrt_h", "density_micro_g_sqrt_hz", "density_m_sqrt_hz"],
];

/// The sensors that can fail, in the order of [`BY_SENSOR`].
const SENSORS: &[&str] = &["gyro", "accelerometer", "altimeter"];

/// Sizes that a failure of a sensor can have.
const fn sizes(sensor: usize) -> (f64, f64) {
    (-Failure::GREATEST[sensor], Failure::GREATEST[sensor])
}

pub const FAILURE: &[Key] = &[
    word!(F, "sensor", "sensor that fails", "failure.sensor", SENSORS, failure.sensor),
    word!(
        F,
        "axis",
        "axis that fails, of a gyro or an accelerometer",
        "failure.axis",
        &["x", "y", "z"],
        failure.axis
    ),
    word!(
        F,
        "kind",
        "kind of the failure; none: the failure is off",
        "failure.kind",
        FailureFields::WORDS,
        failure.fields.kind
    ),
    number!(F, N, "from_s", si("s"), "start of the failure, from the start of the flight",
        "failure.from_s" in TIMES_S => one(failure.from_s)),
    number!(F, N, "until_s", si("s"), "end of the failure, from the start of the flight; default: the end of the flight",
        "failure.until_s" in TIMES_S => one(failure.until_s)),
    number!(F, N, "size_deg_h", unit("deg/h", DEG_PER_HOUR, "rad/s"), "size of a bias step or of spikes, of a gyro",
        "failure.size_rad_s" in sizes(0) => one(failure.fields.size)),
    number!(F, N, "size_micro_g", unit("micro-g", MICRO_G, "m/s2"), "size of a bias step or of spikes, of an accelerometer",
        "failure.size_m_s2" in sizes(1) => one(failure.fields.size)),
    number!(F, N, "size_m", si("m"), "size of a bias step or of spikes, of the altimeter", "failure.size_m" in sizes(2) => one(failure.fields.size)),
    number!(F, N, "density_deg_sqrt_h", unit("deg/sqrt(h)", DEG_PER_SQRT_HOUR, "rad/sqrt(s)"), "density of the noise, of a gyro",
        "failure.density_rad_sqrt_s" in (0.0, Failure::GREATEST[0]) => one(failure.fields.density)),
    number!(F, N, "density_micro_g_sqrt_hz", unit("micro-g/sqrt(Hz)", MICRO_G, "(m/s)/sqrt(s)"),
        "density of the noise, of an accelerometer",
        "failure.density_m_s_sqrt_s" in (0.0, Failure::GREATEST[1]) => one(failure.fields.density)),
    number!(F, N, "density_m_sqrt_hz", si("m/sqrt(Hz)"), "density of the noise, of the altimeter",
        "failure.density_m_sqrt_hz" in (0.0, Failure::GREATEST[2]) => one(failure.fields.density)),
    number!(F, N, "interval_s", si("s"), "spikes, drop-outs: time from the start of one to the start of the next",
        "failure.interval_s" in Failure::INTERVALS_S => one(failure.fields.interval_s)),
    number!(F, N, "duration_s", si("s"), "spikes: length of one spike", "failure.duration_s" in Failure::DURATIONS_S => one(failure.fields.duration_s)),
    number!(F, N, "probability", PURE, "drop-outs without interval_s: probability that a sample interval is lost",
        "failure.probability" in Failure::PROBABILITIES => one(failure.fields.probability)),
];
