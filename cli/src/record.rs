//! A record: truth, navigation, both error data and the errors of the sensors at one instant. `sins fly` writes records, and
//! `sins report` reads them.

use nalgebra::Vector3;
use sins::earth::state::Navigation;
use sins::errors::NavigationErrors;
pub use sins::records::{COLUMNS, SIGMA_COLUMNS};
use sins::{Error, ErrorSource, Simulator};

/// Axes of all errors except those of the sensors, in the order of the columns.
pub const EAST_NORTH_UP: [&str; 3] = ["east", "north", "up"];

/// Flags of errors, combined by bitwise or, as in the C header: near a pole; error model outside its validity; not computed, all
/// zero.
pub const NEAR_POLE: u32 = 1;
pub const OUTSIDE_VALIDITY: u32 = 2;
pub const NOT_COMPUTED: u32 = 4;

/// One row of the file of records.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Record {
    pub time_s: f64,
    pub truth: Motion,
    pub navigation: Motion,
    /// Error data 2: navigation minus truth.
    pub navigation_error: Errors,
    /// Error data 1: the error differential equations.
    pub model_error: Errors,
    /// Error of the gyros, measured less ideal, mean since the previous record [rad/s].
    pub gyro_error: Vector3<f64>,
    /// Error of the accelerometers, measured less ideal, mean since the previous record [m/s²].
    pub accel_error: Vector3<f64>,
    /// Standard deviations in the order of [`SIGMA_COLUMNS`], if the covariance is on.
    pub sigma: Option<[f64; SIGMA_COLUMNS.len()]>,
}

/// A position, a velocity and an attitude.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Motion {
    pub latitude_rad: f64,
    pub longitude_rad: f64,
    pub height_m: f64,
    /// Velocity east, north, up [m/s].
    pub velocity: Vector3<f64>,
    /// Roll, pitch, heading [rad].
    pub attitude: Vector3<f64>,
}

/// Errors of a solution, east, north, up.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Errors {
    /// Position error [m].
    pub position: Vector3<f64>,
    /// Velocity error [m/s].
    pub velocity: Vector3<f64>,
    /// Misalignment [rad].
    pub misalignment: Vector3<f64>,
    /// Errors of roll, pitch, heading [rad].
    pub attitude: Vector3<f64>,
    pub flags: u32,
}

impl Record {
    /// Record of the simulator's current state, without the errors of the sensors; `None` before the first sample.
    pub fn now(simulator: &mut Simulator) -> Result<Option<Self>, Error> {
        let covariance = match simulator.options().covariance {
            true => simulator.covariance()?,
            false => None,
        };
        let (Some(truth), Some(navigation)) = (simulator.truth()?, simulator.navigation()?) else {
            return Ok(None);
        };
        let read = |source, is_on| match is_on {
            true => simulator.errors(source),
            false => Ok(None),
        };
        let errors = read(ErrorSource::Navigation, true)?;
        let model = read(ErrorSource::Model, simulator.options().error_model)?;
        let of = |errors: Option<(f64, NavigationErrors)>| {
            errors.map_or(Errors { flags: NOT_COMPUTED, ..Errors::default() }, |(_, errors)| {
                Errors::of(&errors, truth.near_pole)
            })
        };
        Ok(Some(Self {
            time_s: truth.time_s,
            truth: Motion::of(&truth.navigation),
            navigation: Motion::of(&navigation.navigation),
            navigation_error: of(errors),
            model_error: of(model),
            sigma: covariance.map(|(_, covariance, _)| covariance.sigma()),
            ..Self::default()
        }))
    }

    /// Values of the record in the order of [`COLUMNS`].
    pub fn values(&self) -> [f64; COLUMNS.len()] {
        let mut values = [0.0; COLUMNS.len()];
        let mut record = *self;
        let mut places = values.iter_mut();
        record.visit(&mut |value| {
            if let Some(place) = places.next() {
                *place = *value;
            }
        });
        values
    }

    /// The record of `values` in the order of [`COLUMNS`].
    pub fn of_values(values: &[f64; COLUMNS.len()]) -> Self {
        let mut record = Self::default();
        let mut values = values.iter();
        record.visit(&mut |place| {
            if let Some(value) = values.next() {
                *place = *value;
            }
        });
        record
    }

    /// Visits every number, in the order of [`COLUMNS`].
    fn visit(&mut self, number: &mut dyn FnMut(&mut f64)) {
        number(&mut self.time_s);
        for motion in [&mut self.truth, &mut self.navigation] {
            number(&mut motion.latitude_rad);
            number(&mut motion.longitude_rad);
            number(&mut motion.height_m);
            motion.velocity.iter_mut().chain(&mut motion.attitude).for_each(&mut *number);
        }
        for errors in [&mut self.navigation_error, &mut self.model_error] {
            let parts = errors.position.iter_mut().chain(&mut errors.velocity);
            parts.chain(&mut errors.misalignment).chain(&mut errors.attitude).for_each(&mut *number);
            let mut flags = f64::from(errors.flags);
            number(&mut flags);
            errors.flags = flags as u32;
        }
        self.gyro_error.iter_mut().chain(&mut self.accel_error).for_each(number);
    }
}

impl Motion {
    fn of(navigation: &Navigation) -> Self {
        let euler = &navigation.euler;
        Self {
            latitude_rad: navigation.place.latitude_rad,
            longitude_rad: navigation.place.longitude_rad,
            height_m: navigation.place.height_m,
            velocity: navigation.v_n,
            attitude: Vector3::new(euler.roll, euler.pitch, euler.heading),
        }
    }
}

impl Errors {
    fn of(errors: &NavigationErrors, is_near_pole: bool) -> Self {
        let flag = |is_set: bool, flag: u32| if is_set { flag } else { 0 };
        Self {
            position: errors.position_n,
            velocity: errors.velocity_n,
            misalignment: errors.misalignment_n,
            attitude: Vector3::new(errors.roll_rad, errors.pitch_rad, errors.heading_rad),
            flags: flag(is_near_pole, NEAR_POLE) | flag(errors.outside_validity, OUTSIDE_VALIDITY),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_column_has_its_place() {
        let values: [f64; COLUMNS.len()] = std::array::from_fn(|k| k as f64);
        let record = Record::of_values(&values);
        assert_eq!(record.values(), values);
        let at = |name: &str| COLUMNS.iter().position(|column| *column == name).unwrap() as f64;
        assert_eq!(record.truth.attitude.z, at("truth_heading_rad"));
        assert_eq!(record.navigation.velocity.y, at("navigation_velocity_north_m_s"));
        assert_eq!(record.navigation_error.misalignment.z, at("navigation_error_misalignment_up_rad"));
        assert_eq!(f64::from(record.model_error.flags), at("model_error_flags"));
        assert_eq!(record.accel_error.z, at("accel_error_z_m_s2"));
    }
}
