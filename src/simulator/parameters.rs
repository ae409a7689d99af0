//! All that makes an INS err, as a host sets it.

use super::{Options, Simulator, heap_simulator};
use crate::base::error::Error;
use crate::base::parameter::{Field, Parameter, Row};
use crate::base::rows::of_path;
use crate::sensors::{
    ALTIMETER, AltimeterParameters, GRAVITY, GravityDisturbanceParameters, INITIAL, InitialErrorParameters,
    PARAMETERS, Sensor, TriadParameters,
};
use crate::signal::mounting::{MOUNTING, MountingParameters};

/// Settings of the sensors, of the start, of the mounting and of gravity. The default is ideal.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ErrorParameters {
    /// Errors of the gyros.
    pub gyro: TriadParameters,
    /// Errors of the accelerometers.
    pub accel: TriadParameters,
    /// Errors of the altimeter.
    pub altimeter: AltimeterParameters,
    /// Errors at the start.
    pub initial: InitialErrorParameters,
    /// Where the sensor block sits, and where the INS believes that it sits.
    pub mounting: MountingParameters,
    /// True gravity less the normal gravity with which the INS computes.
    pub gravity: GravityDisturbanceParameters,
}

impl ErrorParameters {
    /// The settings of a simulator, at any time.
    pub fn of(simulator: &Simulator) -> Self {
        *simulator.imperfections.set()
    }

    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        self.gyro.validate(Sensor::Gyro)?;
        self.accel.validate(Sensor::Accelerometer)?;
        self.altimeter.validate()?;
        self.initial.validate()?;
        self.mounting.validate()?;
        self.gravity.validate()
    }

    /// Sets all error parameters of a simulator.
    pub fn set_to(&self, simulator: &mut Simulator) -> Result<(), Error> {
        simulator.set_gyro(&self.gyro)?;
        simulator.set_accel(&self.accel)?;
        simulator.set_altimeter(&self.altimeter)?;
        simulator.set_initial_errors(&self.initial)?;
        simulator.set_mounting(&self.mounting)?;
        simulator.set_gravity_disturbance(&self.gravity)
    }

    /// A simulator before its first sample that has these errors.
    pub(crate) fn simulator(&self, options: &Options) -> Result<Box<[Simulator; 1]>, Error> {
        let mut memory = heap_simulator(options)?;
        self.set_to(&mut memory[0])?;
        Ok(memory)
    }

    /// These parameters without errors. Kind and length of the alignment, the reference temperature and the true mounting are not
    /// effects, and stay.
    pub(crate) fn ideal(&self) -> Self {
        let mut ideal = Self::default();
        ideal.initial.alignment = self.initial.alignment;
        ideal.initial.alignment_s = self.initial.alignment_s;
        ideal.mounting = self.mounting.believed();
        ideal.gyro.reference_temperature_c = self.gyro.reference_temperature_c;
        ideal.accel.reference_temperature_c = self.accel.reference_temperature_c;
        ideal
    }

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

/// Every row of an error beside those of the triads.
pub(crate) fn rows() -> impl Iterator<Item = &'static Row> {
    [ALTIMETER.as_slice(), &INITIAL, &MOUNTING, &GRAVITY].into_iter().flatten()
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
