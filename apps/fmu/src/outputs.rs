//! The outputs, which are read from the simulator after a step.

use sins::errors::correction::Compensation;
use sins::record::{COLUMNS, Record};
use sins::scene::Play;
use sins::{Error, ErrorSource};

use crate::values::{Value, Values};
use crate::variable::{Role, Variable};
use crate::{corrections, panel, parts};

/// A number: name, unit, usual size, meaning.
pub type Number = (&'static str, &'static str, f64, &'static str);

const SOLUTION: [Number; 10] = [
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
];

/// Errors: all are outputs of the navigation and of the error equations, the first nine also of the covariance; these a master can
/// correct.
pub const ERRORS: [Number; 12] = [
    ("position_east_m", "m", 100.0, "displacement east"),
    ("position_north_m", "m", 100.0, "displacement north"),
    ("position_up_m", "m", 100.0, "height"),
    ("velocity_east_m_s", "m/s", 0.1, "velocity east"),
    ("velocity_north_m_s", "m/s", 0.1, "velocity north"),
    ("velocity_up_m_s", "m/s", 0.1, "velocity up"),
    ("misalignment_east_rad", "rad", 1e-4, "misalignment about east"),
    ("misalignment_north_rad", "rad", 1e-4, "misalignment about north"),
    ("misalignment_up_rad", "rad", 1e-4, "misalignment about up"),
    ("roll_rad", "rad", 1e-4, "roll"),
    ("pitch_rad", "rad", 1e-4, "pitch"),
    ("heading_rad", "rad", 1e-4, "heading"),
];

const IMU: [Number; 13] = [
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
];

const COUNT: usize = SOLUTION.len()
    + 2 * ERRORS.len()
    + IMU.len()
    + 9
    + corrections::COMPENSATIONS
    + panel::COUNT
    + parts::REALS;

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
    let errors = |name: &'static str, of: &'static str, count: usize| {
        let number = move |&(end, unit, nominal, doc): &Number| {
            (format!("{name}.{end}"), unit, nominal, format!("{of}: {doc}"))
        };
        ERRORS[..count].iter().map(number)
    };
    let own = |&(name, unit, nominal, doc): &Number| (name.to_owned(), unit, nominal, doc.to_owned());
    let numbers = SOLUTION.iter().map(own).chain(errors("errors", "navigation less truth", 12));
    let numbers =
        numbers.chain(errors("model_errors", "by the error equations", 12)).chain(IMU.iter().map(own));
    let numbers = numbers.chain(errors("sigma", "standard deviation by the covariance", 9));
    let numbers = numbers.chain(corrections::compensations()).chain(panel::numbers()).chain(parts::numbers());
    let numbers = numbers.map(|(name, unit, nominal, doc)| {
        let variable = Variable::new(name, Role::Output, Value::Real(0.0), doc).in_unit(unit, 1.0);
        Variable { nominal, ..variable }
    });
    let flags = FLAGS.iter().map(|&(name, doc)| (name.to_owned(), doc.to_owned())).chain(panel::flags());
    let flags = flags.map(|(name, doc)| Variable::new(name, Role::Output, Value::Boolean(false), doc));
    numbers.chain(flags).chain(parts::counts()).chain([panel::state()])
}

/// Writes the outputs to their places, the last reals, booleans and integers of the table. An error changes nothing.
pub fn read(play: &mut Play, behind_gap: bool, into: &mut Values) -> Result<(), Error> {
    let simulator = play.simulator_mut();
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
    let simulator = play.simulator();
    let imu = simulator.imu().unwrap_or_default();
    let report = panel::report(play.unit(), simulator)?;
    let ([updates, parts_per_update], increments) = parts::read(simulator);

    let from = into.reals.len() - COUNT;
    let numbers = &mut into.reals[from..];
    let from = into.booleans.len() - FLAGS.len() - panel::FLAGS;
    let (flags, of_box) = into.booleans[from..].split_at_mut(FLAGS.len());
    let mut places = numbers.iter_mut();
    let mut put = |values: &[f64]| {
        values.iter().for_each(|value| places.next().into_iter().for_each(|to| *to = *value))
    };
    let values = Record::of(&truth, &navigation, [errors, model]).values();
    let mut put_columns = |first: &str, count: usize| {
        let columns = COLUMNS.into_iter().zip(values).skip_while(|(column, _)| *column != first);
        columns.take(count).for_each(|(_, value)| put(&[value]));
    };
    put_columns("time_s", 1);
    put_columns("navigation_latitude_rad", SOLUTION.len() - 1);
    put_columns("navigation_error_position_east_m", ERRORS.len());
    put_columns("model_error_position_east_m", ERRORS.len());
    put(&[imu.interval_s]);
    put(imu.measured.angle.as_slice());
    put(imu.measured.velocity.as_slice());
    let per_s = if imu.interval_s > 0.0 { 1.0 / imu.interval_s } else { 0.0 };
    put((imu.measured.angle * per_s).as_slice());
    put((imu.measured.velocity * per_s).as_slice());
    put(&covariance.map_or([0.0; 9], |(_, covariance, _)| covariance.sigma()));
    let Compensation { gyro_bias, gyro_scale_factor, accel_bias, accel_scale_factor } =
        simulator.compensation();
    [gyro_bias, gyro_scale_factor, accel_bias, accel_scale_factor]
        .iter()
        .for_each(|three| put(three.as_slice()));
    put(&report.numbers);
    put(&increments);

    of_box.copy_from_slice(&report.flags);
    let integers = into.integers.iter_mut().rev();
    integers.zip([report.state, parts_per_update, updates]).for_each(|(to, value)| *to = value);
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
