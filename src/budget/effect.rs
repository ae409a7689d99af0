//! The effects of a budget: one line each.

use crate::joined::{joined, total};
use crate::sensors::{PARAMETERS, Sensor};
use crate::simulator::ErrorParameters;

/// An effect that can be set and left out alone.
#[derive(Debug, Clone, Copy)]
pub struct Effect {
    /// Name of the effect.
    pub name: &'static str,
    /// The field of the interface that sets it; 0 there leaves it out.
    pub field: &'static str,
    /// Whether it is drawn anew each run.
    pub is_random: bool,
    place: Place,
}

/// Where an effect is set.
#[derive(Debug, Clone, Copy)]
enum Place {
    /// A row of the table of sensor parameters, with these sensors.
    Parameter(Sensor, usize),
    /// Whether it is set, and a function that copies it with everything that belongs to it.
    At { is_set: fn(&ErrorParameters) -> bool, copy: fn(&ErrorParameters, &mut ErrorParameters) },
}

const DETERMINISTIC: bool = false;
const RANDOM: bool = true;

/// Name, field, kind: where it is set, then what else belongs to it.
macro_rules! effects {
    ($($name:literal, $field:literal, $kind:ident: $($path:ident).+ $(, $($too:ident).+)*;)*) => {
        &[$(Effect {
            name: $name,
            field: $field,
            is_random: $kind,
            place: Place::At {
                is_set: |from| from.$($path).+ != ErrorParameters::default().$($path).+,
                copy: |from, to| {
                    to.$($path).+ = from.$($path).+;
                    $(to.$($too).+ = from.$($too).+;)*
                },
            },
        }),*]
    };
}

/// All of them: of gravity, of the sensors as their table has them, of the altimeter, of the start and of the mounting.
pub static EFFECTS: &[Effect] = &joined::<Effect, { total(PARTS) }>(PARTS);

const PARTS: &[&[Effect]] = &[GRAVITY, GYRO, ACCEL, OTHERS];

const GRAVITY: &[Effect] = effects! {
    "deflection north", "gravity.deflection_north_rad", DETERMINISTIC: gravity.deflection_north.mean;
    "random deflection north", "gravity.deflection_north_sigma_rad", RANDOM: gravity.deflection_north.sigma, gravity.deflection_north.distance_m;
    "deflection east", "gravity.deflection_east_rad", DETERMINISTIC: gravity.deflection_east.mean;
    "random deflection east", "gravity.deflection_east_sigma_rad", RANDOM: gravity.deflection_east.sigma, gravity.deflection_east.distance_m;
    "gravity anomaly", "gravity.anomaly_m_s2", DETERMINISTIC: gravity.anomaly.mean;
    "random gravity anomaly", "gravity.anomaly_sigma_m_s2", RANDOM: gravity.anomaly.sigma, gravity.anomaly.distance_m;
};

const GYRO: &[Effect] = &of_sensor::<{ count(Sensor::Gyro) }>(Sensor::Gyro);
const ACCEL: &[Effect] = &of_sensor::<{ count(Sensor::Accelerometer) }>(Sensor::Accelerometer);

const OTHERS: &[Effect] = effects! {
    "altimeter lag", "altimeter.lag_s", DETERMINISTIC: altimeter.lag_s;
    "altimeter scale factor", "altimeter.scale_factor", DETERMINISTIC: altimeter.scale_factor;
    "altimeter bias", "altimeter.bias_m", DETERMINISTIC: altimeter.bias_m;
    "altimeter Gauss-Markov", "altimeter.markov_sigma_m", RANDOM: altimeter.markov_sigma_m, altimeter.markov_time_s;
    "altimeter noise", "altimeter.noise_m", RANDOM: altimeter.noise_m;
    "initial position", "initial.position_enu_m", DETERMINISTIC: initial.position_n;
    "initial velocity", "initial.velocity_enu_m_s", DETERMINISTIC: initial.velocity_n;
    "initial misalignment", "initial.misalignment_enu_rad", DETERMINISTIC: initial.misalignment_n;
    "drawn initial position", "initial.position_sigma_enu_m", RANDOM: initial.position_sigma_n;
    "drawn initial velocity", "initial.velocity_sigma_enu_m_s", RANDOM: initial.velocity_sigma_n;
    "drawn initial misalignment", "initial.misalignment_sigma_enu_rad", RANDOM: initial.misalignment_sigma_n;
    "lever arm error", "mounting.lever_arm_error_m", DETERMINISTIC: mounting.lever_arm_error_m;
    "boresight error", "mounting.boresight_error_rad", DETERMINISTIC: mounting.boresight_error;
};

/// The name of the effect of a row of the table, with the field that sets it.
const fn named(row: usize, sensor: Sensor) -> Option<(&'static str, &'static str)> {
    match PARAMETERS[row].of(sensor) {
        Some(field) if !field.effect.is_empty() => Some((field.effect, field.path)),
        _ => None,
    }
}

/// Number of effects of a triad.
const fn count(sensor: Sensor) -> usize {
    let (mut row, mut count) = (0, 0);
    while row < PARAMETERS.len() {
        if named(row, sensor).is_some() {
            count += 1;
        }
        row += 1;
    }
    count
}

/// The effects of a triad.
const fn of_sensor<const N: usize>(sensor: Sensor) -> [Effect; N] {
    let mut effects = [GRAVITY[0]; N];
    let (mut row, mut count) = (0, 0);
    while row < PARAMETERS.len() {
        if let Some((name, field)) = named(row, sensor) {
            let is_random = PARAMETERS[row].is_random;
            effects[count] = Effect { name, field, is_random, place: Place::Parameter(sensor, row) };
            count += 1;
        }
        row += 1;
    }
    effects
}

impl Place {
    fn is_set(&self, from: &ErrorParameters) -> bool {
        match *self {
            Self::Parameter(sensor, row) => {
                from.triad(sensor).numbers()[row].iter().any(|number| *number != 0.0)
            }
            Self::At { is_set, .. } => is_set(from),
        }
    }

    fn copy(&self, from: &ErrorParameters, to: &mut ErrorParameters) {
        match *self {
            Self::Parameter(sensor, row) => {
                let numbers =
                    from.triad(sensor).numbers().into_iter().zip(to.triad_mut(sensor).numbers_mut());
                for ((from, to), parameter) in numbers.zip(PARAMETERS) {
                    if parameter.name == PARAMETERS[row].name || parameter.is_time_of(PARAMETERS[row].name) {
                        to.copy_from_slice(from);
                    }
                }
            }
            Self::At { copy, .. } => copy(from, to),
        }
    }
}

impl Effect {
    /// Those that `parameters` set, in order.
    pub fn set_in(parameters: &ErrorParameters) -> impl Iterator<Item = &'static Self> {
        EFFECTS.iter().filter(|effect| effect.place.is_set(parameters))
    }

    /// `parameters` with nothing but this effect.
    pub(super) fn alone(&self, parameters: &ErrorParameters) -> ErrorParameters {
        let mut alone = parameters.ideal();
        self.place.copy(parameters, &mut alone);
        alone
    }

    /// `parameters` with nothing but what is drawn.
    pub(super) fn random_of(parameters: &ErrorParameters) -> ErrorParameters {
        let mut random = parameters.ideal();
        Self::set_in(parameters)
            .filter(|effect| effect.is_random)
            .for_each(|effect| effect.place.copy(parameters, &mut random));
        random
    }

    /// Takes this effect out of `parameters`.
    pub(super) fn leave_out(&self, parameters: &mut ErrorParameters) {
        self.place.copy(&ErrorParameters::default(), parameters);
    }
}

impl PartialEq for Effect {
    fn eq(&self, other: &Self) -> bool {
        self.field == other.field
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::math::Euler;
    use crate::mounting::MountingParameters;
    use crate::sensors::{
        Alignment, AltimeterParameters, GravityDisturbanceParameters, GravityField, InitialErrorParameters,
        TriadParameters,
    };

    /// Every field: one of the sensors is in their table; another one does not compile until it stands here, and fails until it has
    /// its line.
    fn everything() -> ErrorParameters {
        let ones = Vector3::repeat(1.0);
        let angles = Euler { roll: 1.0, pitch: 1.0, heading: 1.0 };
        let field = GravityField { mean: 1.0, sigma: 1.0, distance_m: 1.0 };
        let triad = |sensor| {
            let mut triad = TriadParameters::default();
            let rows = triad.numbers_mut().into_iter().zip(PARAMETERS);
            rows.filter(|(_, row)| row.of(sensor).is_some()).for_each(|(numbers, _)| numbers.fill(1.0));
            triad
        };
        ErrorParameters {
            gyro: triad(Sensor::Gyro),
            accel: triad(Sensor::Accelerometer),
            altimeter: AltimeterParameters {
                bias_m: 1.0,
                markov_sigma_m: 1.0,
                markov_time_s: 1.0,
                noise_m: 1.0,
                scale_factor: 1.0,
                lag_s: 1.0,
            },
            initial: InitialErrorParameters {
                position_n: ones,
                velocity_n: ones,
                misalignment_n: ones,
                position_sigma_n: ones,
                velocity_sigma_n: ones,
                misalignment_sigma_n: ones,
                alignment: Alignment::LevelAndGyrocompass,
                alignment_s: 1.0,
            },
            mounting: MountingParameters {
                lever_arm_m: ones,
                boresight: angles,
                lever_arm_error_m: ones,
                boresight_error: angles,
            },
            gravity: GravityDisturbanceParameters {
                deflection_north: field,
                deflection_east: field,
                anomaly: field,
            },
        }
    }

    #[test]
    fn every_field_belongs_to_one_effect() {
        let all = everything();
        assert_eq!(Effect::set_in(&all).count(), EFFECTS.len());
        assert_eq!(Effect::set_in(&all.ideal()).count(), 0);
        let (mut together, mut left) = (all.ideal(), all);
        for effect in EFFECTS {
            let set: Vec<&Effect> = Effect::set_in(&effect.alone(&all)).collect();
            assert_eq!(set, [effect]);
            effect.place.copy(&all, &mut together);
            effect.leave_out(&mut left);
        }
        assert_eq!(together, all);
        assert_eq!(left, all.ideal());
    }

    #[test]
    fn names_and_fields_are_distinct_and_fit_the_interface() {
        for (index, effect) in EFFECTS.iter().enumerate() {
            // char effect[32], field[48] with a terminator.
            assert!(effect.name.len() < 32 && effect.field.len() < 48, "{}", effect.name);
            for other in &EFFECTS[..index] {
                assert!(effect.name != other.name && effect.field != other.field, "{}", effect.name);
            }
        }
    }

    /// A correlation time or distance without a standard deviation is no effect, nor is a mounting that is believed.
    #[test]
    fn what_is_off_is_no_effect() {
        let mut parameters = ErrorParameters::default();
        parameters.gyro.markov_time_s.x = 100.0;
        parameters.accel.bias.y = -0.0;
        parameters.gravity.anomaly.distance_m = 1e4;
        parameters.mounting.lever_arm_m.x = 5.0;
        parameters.mounting.boresight.heading = 1.0;
        assert_eq!(Effect::set_in(&parameters).count(), 0);
    }
}
