//! The outputs: what is read of the simulator behind a step.

use nalgebra::Vector3;
use sins::errors::NavigationErrors;
use sins::state::Navigation;
use sins::{Error, ErrorSource, Simulator};

use crate::values::{Value, Values};
use crate::variables::{Role, Variable};

/// A number: name, unit, usual size, meaning.
type Number = (&'static str, &'static str, f64, &'static str);

const NUMBERS: [Number; 56] = [
    ("time_of_solution_s", "s", 1.0, "time of the truth that all outputs belong to"),
    ("navigation.latitude_rad", "rad", 1.0, "navigated latitude"),
    ("navigation.longitude_rad", "rad", 1.0, "navigated longitude"),
    ("navigation.height_m", "m", 1e4, "navigated height above the ellipsoid"),
    ("navigation.velocity_east_m_s", "m/s", 100.0, "navigated velocity, east"),
    ("navigation.velocity_north_m_s", "m/s", 100.0, "navigated velocity, north"),
    ("navigation.velocity_up_m_s", "m/s", 10.0, "navigated velocity, up"),
    ("navigation.roll_rad", "rad", 1.0, "navigated roll"),
    ("navigation.pitch_rad", "rad", 1.0, "navigated pitch"),
    ("navigation.heading_rad", "rad", 1.0, "navigated heading"),
    ("errors.position_east_m", "m", 100.0, "navigation less truth: displacement east"),
    ("errors.position_north_m", "m", 100.0, "navigation less truth: displacement north"),
    ("errors.position_up_m", "m", 100.0, "navigation less truth: height"),
    ("errors.velocity_east_m_s", "m/s", 0.1, "navigation less truth: velocity east"),
    ("errors.velocity_north_m_s", "m/s", 0.1, "navigation less truth: velocity north"),
    ("errors.velocity_up_m_s", "m/s", 0.1, "navigation less truth: velocity up"),
    ("errors.misalignment_east_rad", "rad", 1e-4, "navigation less truth: misalignment about east"),
    ("errors.misalignment_north_rad", "rad", 1e-4, "navigation less truth: misalignment about north"),
    ("errors.misalignment_up_rad", "rad", 1e-4, "navigation less truth: misalignment about up"),
    ("errors.roll_rad", "rad", 1e-4, "navigation less truth: roll"),
    ("errors.pitch_rad", "rad", 1e-4, "navigation less truth: pitch"),
    ("errors.heading_rad", "rad", 1e-4, "navigation less truth: heading"),
    ("model_errors.position_east_m", "m", 100.0, "by the error equations: displacement east"),
    ("model_errors.position_north_m", "m", 100.0, "by the error equations: displacement north"),
    ("model_errors.position_up_m", "m", 100.0, "by the error equations: height"),
    ("model_errors.velocity_east_m_s", "m/s", 0.1, "by the error equations: velocity east"),
    ("model_errors.velocity_north_m_s", "m/s", 0.1, "by the error equations: velocity north"),
    ("model_errors.velocity_up_m_s", "m/s", 0.1, "by the error equations: velocity up"),
    ("model_errors.misalignment_east_rad", "rad", 1e-4, "by the error equations: misalignment about east"),
    ("model_errors.misalignment_north_rad", "rad", 1e-4, "by the error equations: misalignment about north"),
    ("model_errors.misalignment_up_rad", "rad", 1e-4, "by the error equations: misalignment about up"),
    ("model_errors.roll_rad", "rad", 1e-4, "by the error equations: roll"),
    ("model_errors.pitch_rad", "rad", 1e-4, "by the error equations: pitch"),
    ("model_errors.heading_rad", "rad", 1e-4, "by the error equations: heading"),
    ("imu.interval_s", "s", 0.01, "length of the interval that ends at the time of the solution"),
    ("imu.delta_angle_rad[1]", "rad", 0.01, "measured increment of the angle in it, sensor axis x"),
    ("imu.delta_angle_rad[2]", "rad", 0.01, "measured increment of the angle in it, sensor axis y"),
    ("imu.delta_angle_rad[3]", "rad", 0.01, "measured increment of the angle in it, sensor axis z"),
    ("imu.delta_velocity_m_s[1]", "m/s", 0.1, "measured increment of the velocity in it, sensor axis x"),
    ("imu.delta_velocity_m_s[2]", "m/s", 0.1, "measured increment of the velocity in it, sensor axis y"),
    ("imu.delta_velocity_m_s[3]", "m/s", 0.1, "measured increment of the velocity in it, sensor axis z"),
    ("imu.mean_rate_rad_s[1]", "rad/s", 1.0, "measured angular rate, mean of the interval, sensor axis x"),
    ("imu.mean_rate_rad_s[2]", "rad/s", 1.0, "measured angular rate, mean of the interval, sensor axis y"),
    ("imu.mean_rate_rad_s[3]", "rad/s", 1.0, "measured angular rate, mean of the interval, sensor axis z"),
    ("imu.mean_force_m_s2[1]", "m/s2", 10.0, "measured specific force, mean of the interval, sensor axis x"),
    ("imu.mean_force_m_s2[2]", "m/s2", 10.0, "measured specific force, mean of the interval, sensor axis y"),
    ("imu.mean_force_m_s2[3]", "m/s2", 10.0, "measured specific force, mean of the interval, sensor axis z"),
    ("sigma.position_east_m", "m", 100.0, "standard deviation by the covariance: displacement east"),
    ("sigma.position_north_m", "m", 100.0, "standard deviation by the covariance: displacement north"),
    ("sigma.position_up_m", "m", 100.0, "standard deviation by the covariance: height"),
    ("sigma.velocity_east_m_s", "m/s", 0.1, "standard deviation by the covariance: velocity east"),
    ("sigma.velocity_north_m_s", "m/s", 0.1, "standard deviation by the covariance: velocity north"),
    ("sigma.velocity_up_m_s", "m/s", 0.1, "standard deviation by the covariance: velocity up"),
    (
        "sigma.misalignment_east_rad",
        "rad",
        1e-4,
        "standard deviation by the covariance: misalignment about east",
    ),
    (
        "sigma.misalignment_north_rad",
        "rad",
        1e-4,
        "standard deviation by the covariance: misalignment about north",
    ),
    ("sigma.misalignment_up_rad", "rad", 1e-4, "standard deviation by the covariance: misalignment about up"),
];

const FLAGS: [(&str, &str); 11] = [
    ("flags.available", "there is a solution: a sample was taken"),
    ("flags.gap", "the last sample closed a gap in the truth"),
    ("flags.near_pole", "navigation near a pole: longitude and heading have no meaning"),
    ("flags.inconsistent_truth", "the displacement since the sample before contradicts the velocities"),
    ("flags.vertical_unaided", "nothing aids the vertical channel"),
    ("flags.north_unknown", "the alignment at the start could not find north"),
    ("flags.model_outside_validity", "the error equations have outgrown what they drop"),
    ("flags.gyro_saturated", "a gyro was beyond its range"),
    ("flags.accelerometer_saturated", "an accelerometer was beyond its range"),
    ("flags.gyro_invalid", "a gyro had no signal"),
    ("flags.accelerometer_invalid", "an accelerometer had no signal"),
];

/// The outputs as variables.
pub fn variables() -> impl Iterator<Item = Variable> {
    let numbers = NUMBERS.iter().map(|&(name, unit, nominal, doc)| {
        let variable = Variable::new(name, Role::Output, Value::Real(0.0), doc).in_unit(unit, 1.0);
        Variable { nominal, ..variable }
    });
    let flags =
        FLAGS.iter().map(|&(name, doc)| Variable::new(name, Role::Output, Value::Boolean(false), doc));
    numbers.chain(flags)
}

/// Puts the outputs in place: the last reals and booleans of the table. On an error nothing has changed.
pub fn read(simulator: &mut Simulator, behind_gap: bool, into: &mut Values) -> Result<(), Error> {
    let (Some(truth), Some(navigation)) = (simulator.truth()?, simulator.navigation()?) else {
        return Ok(());
    };
    let (_, errors) = simulator.errors(ErrorSource::Navigation)?.unzip();
    let model = match simulator.options().error_model {
        true => simulator.errors(ErrorSource::Model)?,
        false => None,
    };
    let (_, model) = model.unzip();
    let covariance = match simulator.options().covariance {
        true => simulator.covariance()?,
        false => None,
    };
    let imu = simulator.imu().unwrap_or_default();

    let from = into.reals.len() - NUMBERS.len();
    let numbers = &mut into.reals[from..];
    let from = into.booleans.len() - FLAGS.len();
    let flags = &mut into.booleans[from..];
    let mut places = numbers.iter_mut();
    let mut put = |values: &[f64]| {
        values.iter().for_each(|value| places.next().into_iter().for_each(|to| *to = *value))
    };
    put(&[truth.time_s]);
    let Navigation { place, v_n, euler, .. } = &navigation.navigation;
    put(&[place.latitude_rad, place.longitude_rad, place.height_m]);
    put(v_n.as_slice());
    put(&[euler.roll, euler.pitch, euler.heading]);
    for errors in [&errors, &model] {
        let zero = Vector3::zeros();
        let (position, velocity, misalignment, angles) = match errors {
            Some(NavigationErrors {
                position_n,
                velocity_n,
                misalignment_n,
                roll_rad,
                pitch_rad,
                heading_rad,
                ..
            }) => {
                (*position_n, *velocity_n, *misalignment_n, Vector3::new(*roll_rad, *pitch_rad, *heading_rad))
            }
            None => (zero, zero, zero, zero),
        };
        [position, velocity, misalignment, angles].iter().for_each(|vector| put(vector.as_slice()));
    }
    put(&[imu.interval_s]);
    put(imu.measured.angle.as_slice());
    put(imu.measured.velocity.as_slice());
    let per_s = if imu.interval_s > 0.0 { 1.0 / imu.interval_s } else { 0.0 };
    put((imu.measured.angle * per_s).as_slice());
    put((imu.measured.velocity * per_s).as_slice());
    put(&covariance.map_or([0.0; 9], |(_, covariance, _)| covariance.sigma()));

    flags.copy_from_slice(&[
        true,
        behind_gap,
        navigation.near_pole,
        truth.inconsistent,
        navigation.vertical_unaided,
        navigation.north_unknown,
        model.is_some_and(|model| model.outside_validity),
        imu.flags.gyro_saturated,
        imu.flags.accel_saturated,
        imu.flags.gyro_invalid,
        imu.flags.accel_invalid,
    ]);
    Ok(())
}
