//! Corrections by the master: errors that it estimated, as inputs, and the compensation in force, as outputs.

use nalgebra::Vector3;
use sins::Error;
use sins::earth::state::StateErrors;
use sins::errors::correction::{Compensation, Correction};

use crate::inputs;
use crate::outputs::{ERRORS, Number};
use crate::values::{Value, Values};
use crate::variable::{Role, Variable};

/// Errors of the solution: the first ones of the table of outputs.
const OF_SOLUTION: usize = 9;

/// Errors of the sensors.
#[rustfmt::skip]
const OF_SENSORS: [Number; 12] = [
    ("gyro_bias_rad_s[1]", "rad/s", 1e-6, "bias of the gyro, sensor axis x"),
    ("gyro_bias_rad_s[2]", "rad/s", 1e-6, "bias of the gyro, sensor axis y"),
    ("gyro_bias_rad_s[3]", "rad/s", 1e-6, "bias of the gyro, sensor axis z"),
    ("gyro_scale_factor[1]", "", 1e-4, "scale factor error of the gyro, sensor axis x"),
    ("gyro_scale_factor[2]", "", 1e-4, "scale factor error of the gyro, sensor axis y"),
    ("gyro_scale_factor[3]", "", 1e-4, "scale factor error of the gyro, sensor axis z"),
    ("accelerometer_bias_m_s2[1]", "m/s2", 1e-3, "bias of the accelerometer, sensor axis x"),
    ("accelerometer_bias_m_s2[2]", "m/s2", 1e-3, "bias of the accelerometer, sensor axis y"),
    ("accelerometer_bias_m_s2[3]", "m/s2", 1e-3, "bias of the accelerometer, sensor axis z"),
    ("accelerometer_scale_factor[1]", "", 1e-4, "scale factor error of the accelerometer, sensor axis x"),
    ("accelerometer_scale_factor[2]", "", 1e-4, "scale factor error of the accelerometer, sensor axis y"),
    ("accelerometer_scale_factor[3]", "", 1e-4, "scale factor error of the accelerometer, sensor axis z"),
];

/// Number of compensations, and of inputs that are reals.
pub const COMPENSATIONS: usize = OF_SENSORS.len();
pub const REALS: usize = OF_SOLUTION + COMPENSATIONS;

/// The inputs as variables: the reals behind those of the truth, and the first integer.
pub fn inputs() -> impl Iterator<Item = Variable> {
    let of = |&(name, unit, nominal, doc): &Number| {
        let (name, doc) = (format!("correction.{name}"), format!("error to remove: {doc}"));
        let variable = Variable::new(name, Role::Input, Value::Real(0.0), doc);
        Variable { nominal, ..variable.in_unit(unit, 1.0) }
    };
    let doc = "number of corrections; a step at which it has changed first removes the errors correction.*";
    let count = Variable::new("correction.count", Role::Input, Value::Integer(0), doc);
    ERRORS[..OF_SOLUTION].iter().chain(&OF_SENSORS).map(of).chain([count])
}

/// The compensation in force: name, unit, usual size, meaning of each output.
pub fn compensations() -> impl Iterator<Item = (String, &'static str, f64, String)> {
    OF_SENSORS.iter().map(|&(name, unit, nominal, doc)| {
        (format!("compensation.{name}"), unit, nominal, format!("compensation in force: {doc}"))
    })
}

/// The number of corrections that the master has counted.
pub fn count(values: &Values) -> i32 {
    values.integers.first().copied().unwrap_or_default()
}

/// The variable that an error about a correction is about.
pub fn name_of(error: &Error) -> Option<String> {
    let place =
        |fields: &[&str]| Some(fields.iter().position(|field| *field == error.field)? * 3 + error.index?);
    let of_solution = place(&[
        "correction.position_enu_m",
        "correction.velocity_enu_m_s",
        "correction.misalignment_enu_rad",
    ]);
    let of_sensors = || {
        place(&[
            "compensation.gyro_bias_rad_s",
            "compensation.gyro_scale_factor",
            "compensation.accel_bias_m_s2",
            "compensation.accel_scale_factor",
        ])
    };
    match of_solution {
        Some(place) => ERRORS.get(place).map(|(name, ..)| format!("correction.{name}")),
        None => OF_SENSORS.get(of_sensors()?).map(|(name, ..)| format!("compensation.{name}")),
    }
}

/// The correction that the inputs state.
pub fn correction(values: &Values) -> Correction {
    let mut of_axes = values.reals[inputs::COUNT..].chunks_exact(3).map(Vector3::from_column_slice);
    let mut next = || of_axes.next().unwrap_or_default();
    Correction {
        errors: StateErrors { position_n: next(), velocity_n: next(), misalignment_n: next() },
        sensors: Compensation {
            gyro_bias: next(),
            gyro_scale_factor: next(),
            accel_bias: next(),
            accel_scale_factor: next(),
        },
    }
}
