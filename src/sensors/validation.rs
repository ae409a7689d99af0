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

#[cfg(test)]
mod tests {
    use nalgebra::Matrix3;

    use super::*;

    fn sentence(set: impl FnOnce(&mut TriadParameters), sensor: Sensor) -> String {
        let mut parameters = TriadParameters::default();
        set(&mut parameters);
        parameters.validate(sensor).unwrap_err().to_string()
    }

    #[test]
    fn a_term_of_the_other_kind_of_sensor_is_refused() {
        let mut arm = TriadParameters::default();
        arm.lever_arm_m[(1, 2)] = -0.5;
        assert!(arm.validate(Sensor::Accelerometer).is_ok());
        assert_eq!(
            arm.validate(Sensor::Gyro).unwrap_err().to_string(),
            "lever_arm_m[5] = -0.5: must be 0: it is a parameter of the other kind of sensor"
        );
        let unbalance = TriadParameters { g_sensitivity: Matrix3::identity(), ..Default::default() };
        assert!(
            unbalance.validate(Sensor::Gyro).is_ok() && unbalance.validate(Sensor::Accelerometer).is_err()
        );
    }

    #[test]
    fn the_sentence_says_that_0_is_none_and_which_sigma_needs_a_time() {
        assert_eq!(
            sentence(|p| p.range.y = -1.0, Sensor::Accelerometer),
            "accel.range_m_s2[1] = -1: must be 0 for none, or from 1e-9 to 1000000"
        );
        assert_eq!(
            sentence(|p| p.markov_sigma.z = 1e-3, Sensor::Gyro),
            "gyro.markov_time_s[2] = 0: must be from 1e-9 to 1e15 where gyro.markov_sigma_rad_s is not 0"
        );
        assert_eq!(
            sentence(|p| p.markov_time_s.x = -3.0, Sensor::Gyro),
            "gyro.markov_time_s[0] = -3: must be from 0 to 1e15"
        );
        assert_eq!(
            sentence(|p| p.misalignment_sigma[(1, 1)] = 1e-3, Sensor::Accelerometer),
            "accel.misalignment_sigma_rad[4] = 0.001: must be 0 on the diagonal; use scale_factor_sigma"
        );
    }
}
