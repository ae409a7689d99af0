//! A record: truth, navigation, both error data and the errors of the sensors at one instant; a line of a file of records.

use nalgebra::Vector3;

use super::{ErrorSource, Simulator, Solution};
use crate::base::error::Error;
use crate::earth::state::Navigation;
use crate::errors::NavigationErrors;

/// One line of a file of records.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Record {
    /// Time [s].
    pub time_s: f64,
    /// The truth.
    pub truth: Navigation,
    /// The navigated solution.
    pub navigation: Navigation,
    /// Error data 2: navigation minus truth.
    pub navigation_error: NavigationErrors,
    /// Flags of error data 2: [`NEAR_POLE`], or [`NOT_COMPUTED`].
    pub navigation_flags: u32,
    /// Error data 1: the error differential equations.
    pub model_error: NavigationErrors,
    /// Flags of error data 1: [`NEAR_POLE`] and [`OUTSIDE_VALIDITY`], or'ed, or [`NOT_COMPUTED`].
    pub model_flags: u32,
    /// Error of the gyros, measured less ideal, mean since the previous record [rad/s].
    pub gyro_error: Vector3<f64>,
    /// Error of the accelerometers, measured less ideal, mean since the previous record [m/s²].
    pub accel_error: Vector3<f64>,
    /// Standard deviations in the order of [`SIGMA_COLUMNS`], if the covariance is on.
    pub sigma: Option<[f64; SIGMA_COLUMNS.len()]>,
}

/// The truth is near a pole.
pub const NEAR_POLE: u32 = 1;
/// The error model is outside its validity.
pub const OUTSIDE_VALIDITY: u32 = 2;
/// Not computed, all zero.
pub const NOT_COMPUTED: u32 = 4;

/// Names the columns, and says which number of a record is in each.
macro_rules! columns {
    ($($column:literal => $($place:ident).+),* $(,)?) => {
        /// Columns of a file of records.
        pub const COLUMNS: [&str; COUNT] = [$($column),*];
        const COUNT: usize = [$($column),*].len();

        impl Record {
            /// Values of the record in the order of [`COLUMNS`].
            pub fn values(&self) -> [f64; COUNT] {
                [$(self.$($place).+.into()),*]
            }

            /// The record of `values` in the order of [`COLUMNS`].
            pub fn of_values(values: &[f64; COUNT]) -> Self {
                let (mut record, mut values) = (Self::default(), values.iter());
                $(record.$($place).+.take(values.next());)*
                record
            }
        }
    };
}

columns! {
    "time_s" => time_s,
    "truth_latitude_rad" => truth.place.latitude_rad,
    "truth_longitude_rad" => truth.place.longitude_rad,
    "truth_height_m" => truth.place.height_m,
    "truth_velocity_east_m_s" => truth.v_n.x,
    "truth_velocity_north_m_s" => truth.v_n.y,
    "truth_velocity_up_m_s" => truth.v_n.z,
    "truth_roll_rad" => truth.euler.roll,
    "truth_pitch_rad" => truth.euler.pitch,
    "truth_heading_rad" => truth.euler.heading,
    "navigation_latitude_rad" => navigation.place.latitude_rad,
    "navigation_longitude_rad" => navigation.place.longitude_rad,
    "navigation_height_m" => navigation.place.height_m,
    "navigation_velocity_east_m_s" => navigation.v_n.x,
    "navigation_velocity_north_m_s" => navigation.v_n.y,
    "navigation_velocity_up_m_s" => navigation.v_n.z,
    "navigation_roll_rad" => navigation.euler.roll,
    "navigation_pitch_rad" => navigation.euler.pitch,
    "navigation_heading_rad" => navigation.euler.heading,
    "navigation_error_position_east_m" => navigation_error.position_n.x,
    "navigation_error_position_north_m" => navigation_error.position_n.y,
    "navigation_error_position_up_m" => navigation_error.position_n.z,
    "navigation_error_velocity_east_m_s" => navigation_error.velocity_n.x,
    "navigation_error_velocity_north_m_s" => navigation_error.velocity_n.y,
    "navigation_error_velocity_up_m_s" => navigation_error.velocity_n.z,
    "navigation_error_misalignment_east_rad" => navigation_error.misalignment_n.x,
    "navigation_error_misalignment_north_rad" => navigation_error.misalignment_n.y,
    "navigation_error_misalignment_up_rad" => navigation_error.misalignment_n.z,
    "navigation_error_roll_rad" => navigation_error.roll_rad,
    "navigation_error_pitch_rad" => navigation_error.pitch_rad,
    "navigation_error_heading_rad" => navigation_error.heading_rad,
    "navigation_error_flags" => navigation_flags,
    "model_error_position_east_m" => model_error.position_n.x,
    "model_error_position_north_m" => model_error.position_n.y,
    "model_error_position_up_m" => model_error.position_n.z,
    "model_error_velocity_east_m_s" => model_error.velocity_n.x,
    "model_error_velocity_north_m_s" => model_error.velocity_n.y,
    "model_error_velocity_up_m_s" => model_error.velocity_n.z,
    "model_error_misalignment_east_rad" => model_error.misalignment_n.x,
    "model_error_misalignment_north_rad" => model_error.misalignment_n.y,
    "model_error_misalignment_up_rad" => model_error.misalignment_n.z,
    "model_error_roll_rad" => model_error.roll_rad,
    "model_error_pitch_rad" => model_error.pitch_rad,
    "model_error_heading_rad" => model_error.heading_rad,
    "model_error_flags" => model_flags,
    "gyro_error_x_rad_s" => gyro_error.x,
    "gyro_error_y_rad_s" => gyro_error.y,
    "gyro_error_z_rad_s" => gyro_error.z,
    "accel_error_x_m_s2" => accel_error.x,
    "accel_error_y_m_s2" => accel_error.y,
    "accel_error_z_m_s2" => accel_error.z,
}

/// Columns after [`COLUMNS`] if the covariance is on: standard deviations of the errors.
pub const SIGMA_COLUMNS: [&str; 9] = [
    "sigma_position_east_m",
    "sigma_position_north_m",
    "sigma_position_up_m",
    "sigma_velocity_east_m_s",
    "sigma_velocity_north_m_s",
    "sigma_velocity_up_m_s",
    "sigma_misalignment_east_rad",
    "sigma_misalignment_north_rad",
    "sigma_misalignment_up_rad",
];

/// The columns of a file.
pub(crate) fn columns(has_sigmas: bool) -> impl Iterator<Item = &'static str> {
    let sigmas = if has_sigmas { &SIGMA_COLUMNS[..] } else { &[] };
    COLUMNS.iter().chain(sigmas).copied()
}

/// The first line of a file, without the line end.
pub fn head(has_sigmas: bool) -> String {
    columns(has_sigmas).collect::<Vec<_>>().join(",")
}

/// A number of a record.
trait Take {
    fn take(&mut self, value: Option<&f64>);
}

impl Take for f64 {
    fn take(&mut self, value: Option<&f64>) {
        value.into_iter().for_each(|value| *self = *value);
    }
}

impl Take for u32 {
    fn take(&mut self, value: Option<&f64>) {
        value.into_iter().for_each(|value| *self = *value as u32);
    }
}

impl Record {
    /// Record of the simulator's current state, without the errors of the sensors; `None` before the first sample.
    pub fn now(simulator: &mut Simulator) -> Result<Option<Self>, Error> {
        let options = *simulator.options();
        let covariance = if options.covariance { simulator.covariance()? } else { None };
        let (Some(truth), Some(navigation)) = (simulator.truth()?, simulator.navigation()?) else {
            return Ok(None);
        };
        let errors = simulator.errors(ErrorSource::Navigation)?;
        let model = if options.error_model { simulator.errors(ErrorSource::Model)? } else { None };
        let errors = [errors, model].map(|errors| errors.map(|(_, errors)| errors));
        let sigma = covariance.map(|(_, covariance, _)| covariance.sigma());
        Ok(Some(Self { sigma, ..Self::of(&truth, &navigation, errors) }))
    }

    /// Record of a moment, without the errors of the sensors and without standard deviations. `errors` are navigation minus truth
    /// and those of the model.
    pub fn of(truth: &Solution, navigation: &Solution, errors: [Option<NavigationErrors>; 2]) -> Self {
        let [(navigation_error, navigation_flags), (model_error, model_flags)] =
            errors.map(|errors| flagged(errors, truth.near_pole));
        Self {
            time_s: truth.time_s,
            truth: truth.navigation,
            navigation: navigation.navigation,
            navigation_error,
            navigation_flags,
            model_error,
            model_flags,
            ..Self::default()
        }
    }
}

/// Errors and their flags, of enum sins_errors_flags; errors that nobody computes are 0.
fn flagged(errors: Option<NavigationErrors>, is_near_pole: bool) -> (NavigationErrors, u32) {
    let Some(errors) = errors else { return (NavigationErrors::default(), NOT_COMPUTED) };
    let flag = |is_set: bool, flag: u32| if is_set { flag } else { 0 };
    (errors, flag(is_near_pole, NEAR_POLE) | flag(errors.outside_validity, OUTSIDE_VALIDITY))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_reads_back_from_its_values() {
        let values: [f64; COUNT] = core::array::from_fn(|column| column as f64);
        assert_eq!(Record::of_values(&values).values(), values);
    }
}
