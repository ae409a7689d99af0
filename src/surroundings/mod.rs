//! The parameters beside those of gyros and accelerometers, from their tables.

mod table;

pub use table::{ALTIMETER, GRAVITY, INITIAL, MOUNTING, START};

use nalgebra::Vector3;

use crate::checks::check_value;
use crate::earth::Ellipsoid;
use crate::error::Error;
use crate::math::Euler;
use crate::parameter::{Field, Parameter, Row};
use crate::sensors::{Alignment, GravityDisturbanceParameters, PARAMETERS, Sensor};
use crate::simulator::ErrorParameters;
use crate::snapshot::stored;

// The structs with their checks and numbers, which build.rs writes from the tables.
include!(concat!(env!("OUT_DIR"), "/surroundings.rs"));

/// Every row of an error.
pub(crate) fn rows() -> impl Iterator<Item = &'static Row> {
    [ALTIMETER.as_slice(), &INITIAL, &MOUNTING, &GRAVITY].into_iter().flatten()
}

impl ErrorParameters {
    /// The numbers of the parameter with the field `path` of the interface; of another field none. Matrices are column by column.
    pub(crate) fn numbers_of(&mut self, path: &str) -> impl Iterator<Item = &mut f64> {
        let Self { gyro, accel, altimeter, initial, mounting, gravity } = self;
        let row = |sensor| row_of(sensor, path).unwrap_or(PARAMETERS.len());
        let of_gyro = gyro.numbers_mut().into_iter().skip(row(Sensor::Gyro)).take(1);
        let of_accel = accel.numbers_mut().into_iter().skip(row(Sensor::Accelerometer)).take(1);
        let numbers = altimeter.numbers_mut().into_iter().chain(initial.numbers_mut());
        let numbers = numbers.chain(mounting.numbers_mut()).chain(gravity.numbers_mut());
        of_gyro.chain(of_accel).flatten().chain(of_path(rows(), numbers, path))
    }
}

/// The row of the sensor parameter with the field `path` of the interface.
fn row_of(sensor: Sensor, path: &str) -> Option<usize> {
    PARAMETERS.iter().position(|row| row.of(sensor).is_some_and(|field| field.path == path))
}

/// The field `path` of the interface, and that of its correlation time or distance.
pub(crate) fn with_time(path: &str) -> impl Iterator<Item = &'static str> {
    let of_triad = move |sensor| {
        let name = row_of(sensor, path).map(|row| PARAMETERS[row].name);
        let belongs =
            move |row: &&Parameter| name.is_some_and(|name| row.name == name || row.is_time_of(name));
        PARAMETERS.iter().filter(belongs).filter_map(move |row| row.of(sensor))
    };
    let belongs = move |field: &Field| field.path == path || field.range.needed_by() == Some(path);
    let fields = rows().map(|row| row.field).filter(belongs);
    let triads = [Sensor::Gyro, Sensor::Accelerometer].into_iter().flat_map(of_triad);
    fields.chain(triads).map(|field| field.path)
}

/// Of the numbers of all rows those of the row with the field `path` of the interface; of another field none.
pub(crate) fn of_path<'r, 'n>(
    rows: impl IntoIterator<Item = &'r Row>,
    numbers: impl IntoIterator<Item = &'n mut f64>,
    path: &str,
) -> impl Iterator<Item = &'n mut f64> {
    let found = places(rows.into_iter()).find(|(row, _)| row.field.path == path);
    let (start, count) = found.map_or((0, 0), |(row, start)| (start, row.shape.count()));
    numbers.into_iter().skip(start).take(count)
}

/// The rows, each with the place of its first number.
fn places<'r>(rows: impl Iterator<Item = &'r Row>) -> impl Iterator<Item = (&'r Row, usize)> {
    rows.scan(0, |end, row| {
        *end += row.shape.count();
        Some((row, *end - row.shape.count()))
    })
}

/// Copies the numbers of a struct.
pub(crate) fn copy<const N: usize>(from: [f64; N], to: [&mut f64; N]) {
    to.into_iter().zip(from).for_each(|(to, from)| *to = from);
}

/// Checks the numbers of all rows of a table.
pub(crate) fn check(rows: &[Row], numbers: &[f64]) -> Result<(), Error> {
    for (row, start) in places(rows.iter()) {
        for index in 0..row.shape.count() {
            let checked = check_value(&row.field, numbers[start + index], |sigma| {
                let of = places(rows.iter()).find(|(row, _)| row.field.path == sigma);
                (sigma, of.map_or(0.0, |(_, place)| numbers[place + index]))
            });
            checked.map_err(|error| if row.shape.count() == 1 { error } else { error.at(index) })?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_number_beyond_its_range_is_rejected_with_field_and_element() {
        for (row, value) in rows().flat_map(|row| [-1e300, 1e300, f64::NAN].map(|value| (row, value))) {
            for index in 0..row.shape.count() {
                let mut errors = ErrorParameters::default();
                *errors.numbers_of(row.field.path).nth(index).unwrap() = value;
                let error = errors.validate().unwrap_err();
                let element = (row.shape.count() > 1).then_some(index);
                assert_eq!((error.field, error.index), (row.field.path, element), "{value}");
            }
        }
    }
}
