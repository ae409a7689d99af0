//! Units of data sheets, and SI units.

use sins::allan::Term;
use sins::units::{ARCSEC, DEG_PER_HOUR, DEG_PER_SQRT_HOUR};

use super::quantity::Sensor;
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
