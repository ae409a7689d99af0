//! Checks of the parameters that a host sets for a triad, against the table.

use super::parameters::{Sensor, TriadParameters};
use super::table::PARAMETERS;
use crate::base::checks::check_numbers;
use crate::base::error::{Error, Rule};
use crate::base::parameter::Parameter;

impl TriadParameters {
    /// Checks every field.
    pub fn validate(&self, sensor: Sensor) -> Result<(), Error> {
        let numbers = self.numbers();
        for (parameter, own) in PARAMETERS.iter().zip(numbers) {
            match parameter.of(sensor) {
                Some(field) => check_numbers(&field, parameter.shape, own, |name| self.named(name, sensor))?,
                None => check_foreign(parameter, own)?,
            }
        }
        Ok(())
    }

    /// The field of the parameter `name`, and its numbers.
    fn named(&self, name: &str, sensor: Sensor) -> (&'static str, &[f64]) {
        let mut rows = PARAMETERS.iter().zip(self.numbers());
        rows.find_map(|(row, numbers)| Some((row.of(sensor).filter(|_| row.name == name)?.path, numbers)))
            .unwrap_or_default()
    }
}

/// Checks that each number is 0, for a parameter that these sensors do not have.
fn check_foreign(parameter: &Parameter, numbers: &[f64]) -> Result<(), Error> {
    for index in 0..numbers.len() {
        let value = numbers[parameter.shape.place(index)];
        if value != 0.0 {
            let rule = Rule::Zero(": it is a parameter of the other kind of sensor");
            return Err(Error::invalid(parameter.name, value, rule).at(index));
        }
    }
    Ok(())
}
