//! Checks of the parameters that a host sets for a triad, against the table.

use super::parameters::{Sensor, TriadParameters};
use super::table::PARAMETERS;
use crate::checks::check_value;
use crate::error::{Error, Rule};
use crate::parameter::{Field, Parameter, Shape};

impl TriadParameters {
    /// Checks every field.
    pub fn validate(&self, sensor: Sensor) -> Result<(), Error> {
        let numbers = self.numbers();
        for (parameter, own) in PARAMETERS.iter().zip(numbers) {
            match parameter.of(sensor) {
                Some(field) => self.check(sensor, parameter, &field, own)?,
                None => check_foreign(parameter, own)?,
            }
        }
        Ok(())
    }

    /// Checks the numbers of a parameter.
    fn check(
        &self,
        sensor: Sensor,
        parameter: &Parameter,
        field: &Field,
        numbers: &[f64],
    ) -> Result<(), Error> {
        for index in 0..numbers.len() {
            let value = numbers[parameter.shape.place(index)];
            let checked = match parameter.shape {
                Shape::OffDiagonal(rule) if index % 4 == 0 && value != 0.0 => {
                    Err(Error::invalid(field.path, value, Rule::Sentence(rule)))
                }
                _ => check_value(field, value, |name| {
                    let (sigma, numbers) = self.named(name, sensor);
                    (sigma, numbers[index])
                }),
            };
            checked.map_err(|error| if numbers.len() == 1 { error } else { error.at(index) })?;
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
