//! Units of data sheets, and SI units.

use sins::units::{ARCSEC, DEG_PER_HOUR, DEG_PER_SQRT_HOUR};
use sins_allan::Term;

use crate::imu::Sensor;
use crate::units::{MICRO_G, Unit};

const HOUR_S: f64 = 3600.0;
const ROOT_HOUR: f64 = 60.0;

const fn unit(name: &'static str, si: f64) -> Unit {
    Unit { name, si }
}

/// Unit of a deviation.
pub fn deviation(sensor: Sensor) -> Unit {
    coefficient(sensor, Term::Flicker)
}

/// Unit of a coefficient.
pub fn coefficient(sensor: Sensor, term: Term) -> Unit {
    match (sensor, term) {
        (Sensor::Gyro, Term::Quantization) => unit("arcsec", ARCSEC),
        (Sensor::Gyro, Term::RandomWalk) => unit("°/√h", DEG_PER_SQRT_HOUR),
        (Sensor::Gyro, Term::Flicker) => unit("°/h", DEG_PER_HOUR),
        (Sensor::Gyro, Term::RateRandomWalk) => unit("°/h/√h", DEG_PER_HOUR / ROOT_HOUR),
        (Sensor::Gyro, Term::Ramp) => unit("°/h/h", DEG_PER_HOUR / HOUR_S),
        (Sensor::Accelerometer, Term::Quantization) => unit("mm/s", 1e-3),
        (Sensor::Accelerometer, Term::RandomWalk) => unit("m/s/√h", 1.0 / ROOT_HOUR),
        (Sensor::Accelerometer, Term::Flicker) => MICRO_G,
        (Sensor::Accelerometer, Term::RateRandomWalk) => unit("µg/√h", MICRO_G.si / ROOT_HOUR),
        (Sensor::Accelerometer, Term::Ramp) => unit("µg/h", MICRO_G.si / HOUR_S),
    }
}

/// Second unit of random walks in data sheets: a density.
pub fn density(sensor: Sensor) -> Unit {
    match sensor {
        Sensor::Gyro => unit("°/h/√Hz", DEG_PER_HOUR),
        Sensor::Accelerometer => unit("µg/√Hz", MICRO_G.si),
    }
}

/// SI unit of a coefficient, as in the interface of the library.
pub fn si_name(sensor: Sensor, term: Term) -> &'static str {
    match (sensor, term) {
        (Sensor::Gyro, Term::Quantization) => "rad",
        (Sensor::Gyro, Term::RandomWalk) => "rad/√s",
        (Sensor::Gyro, Term::Flicker) => "rad/s",
        (Sensor::Gyro, Term::RateRandomWalk) => "rad/s/√s",
        (Sensor::Gyro, Term::Ramp) => "rad/s²",
        (Sensor::Accelerometer, Term::Quantization) => "m/s",
        (Sensor::Accelerometer, Term::RandomWalk) => "m/s/√s",
        (Sensor::Accelerometer, Term::Flicker) => "m/s²",
        (Sensor::Accelerometer, Term::RateRandomWalk) => "m/s²/√s",
        (Sensor::Accelerometer, Term::Ramp) => "m/s³",
    }
}

/// The parameter of the library's sensors that a coefficient sets, and its size for a coefficient of 1. The error of a rounded integral is
/// uniform over a pulse.
pub fn parameter(sensor: Sensor, term: Term) -> (&'static str, f64) {
    let pulse = 12f64.sqrt();
    match (sensor, term) {
        (Sensor::Gyro, Term::Quantization) => ("gyro.quantization_rad", pulse),
        (Sensor::Gyro, Term::RandomWalk) => ("gyro.random_walk_rad_sqrt_s", 1.0),
        (Sensor::Gyro, Term::Flicker) => ("gyro.flicker_rad_s", 1.0),
        (Sensor::Gyro, Term::RateRandomWalk) => ("gyro.rate_random_walk_rad_s_sqrt_s", 1.0),
        (Sensor::Gyro, Term::Ramp) => ("gyro.rate_ramp_rad_s2", 1.0),
        (Sensor::Accelerometer, Term::Quantization) => ("accel.quantization_m_s", pulse),
        (Sensor::Accelerometer, Term::RandomWalk) => ("accel.velocity_random_walk_m_s_sqrt_s", 1.0),
        (Sensor::Accelerometer, Term::Flicker) => ("accel.flicker_m_s2", 1.0),
        (Sensor::Accelerometer, Term::RateRandomWalk) => ("accel.acceleration_random_walk_m_s2_sqrt_s", 1.0),
        (Sensor::Accelerometer, Term::Ramp) => ("accel.ramp_m_s3", 1.0),
    }
}

/// Name of a coefficient.
pub fn name(sensor: Sensor, term: Term) -> &'static str {
    match (sensor, term) {
        (_, Term::Quantization) => "quantization",
        (Sensor::Gyro, Term::RandomWalk) => "angle random walk",
        (Sensor::Accelerometer, Term::RandomWalk) => "velocity random walk",
        (_, Term::Flicker) => "bias instability",
        (Sensor::Gyro, Term::RateRandomWalk) => "rate random walk",
        (Sensor::Accelerometer, Term::RateRandomWalk) => "acceleration random walk",
        (_, Term::Ramp) => "ramp",
    }
}
