//! Random errors of an alignment, caused by random errors of the sensors.

use nalgebra::{Matrix3, Vector3};

use super::sources::{ErrorInput, FIELDS};
use crate::earth::Earth;
use crate::errors::column::At;
use crate::sensors::GravityDisturbance;
use crate::truth::TruthPoint;

/// Misalignment of an alignment with steady errors, east-north-up, and what the sensors sense then, sensor axes.
pub(crate) struct SteadyAlignment {
    pub by_rate: Matrix3<f64>,
    pub by_force: Matrix3<f64>,
    /// Sensor axes in east-north-up.
    pub axes: Matrix3<f64>,
    /// Angular rate [rad/s] and specific force [m/s²].
    pub rate_s: Vector3<f64>,
    pub force_s: Vector3<f64>,
}

impl SteadyAlignment {
    /// Misalignment caused by a source of 1, east-north-up [rad].
    pub(super) fn by(&self, earth: &Earth, first: &TruthPoint, input: ErrorInput) -> Vector3<f64> {
        match input {
            ErrorInput::Axis(axis) => self.of(axis < 3) * self.axes.column(axis % 3),
            ErrorInput::Element(element) => {
                let signal = if element < 9 { &self.rate_s } else { &self.force_s };
                self.of(element < 9) * self.axes.column(element % 3) * signal[element / 3 % 3]
            }
            ErrorInput::Field(field) => {
                let local = At::new(earth, first, None);
                self.by_force * -local.in_local_axes(&field_e(earth, first, field))
            }
            ErrorInput::Altimeter => Vector3::zeros(),
        }
    }

    fn of(&self, is_gyro: bool) -> &Matrix3<f64> {
        if is_gyro { &self.by_rate } else { &self.by_force }
    }
}

/// True less normal gravity for a field of 1, Earth-fixed axes [m/s²].
pub(super) fn field_e(earth: &Earth, truth: &TruthPoint, field: usize) -> Vector3<f64> {
    let mut fields = [0.0; FIELDS];
    fields[field] = 1.0;
    GravityDisturbance::of_fields(earth, truth, fields)
}
