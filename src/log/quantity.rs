//! The quantities of a log, and the units of its columns.

use crate::base::error::Error;
use crate::base::units::{ARCSEC, DEG, DEG_PER_HOUR, MICRO_G, NMI_PER_HOUR, STANDARD_GRAVITY};

/// What a quantity measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    Time,
    Angle,
    Length,
    Speed,
    AngularRate,
    Acceleration,
    Temperature,
    Number,
    /// What a gyro of a record of an IMU gives: a rate, or an angle over an interval.
    Gyro,
    /// What an accelerometer gives: a force, or a velocity over an interval.
    Accelerometer,
}

/// A quantity of a log.
#[derive(Debug, Clone, Copy)]
pub struct Quantity {
    /// Its key in `[log]`.
    pub key: &'static str,
    /// Name of its column in a log of the library's own. An angle may be in degrees: the name then ends in `_deg`. Empty: only `[log]`
    /// gives the quantity.
    pub name: &'static str,
    /// Field of a sample, and index in it.
    pub field: &'static str,
    pub index: Option<usize>,
    pub dimension: Dimension,
}

const fn quantity(
    key: &'static str,
    name: &'static str,
    field: &'static str,
    index: Option<usize>,
    dimension: Dimension,
) -> Quantity {
    Quantity { key, name, field, index, dimension }
}

use Dimension::{
    Acceleration, Accelerometer, Angle, AngularRate, Gyro, Length, Number, Speed, Temperature, Time,
};

/// The quantities. Those that a sample has come first.
pub const QUANTITIES: [Quantity; 29] = [
    quantity("time", "time_s", "sample.time_s", None, Time),
    quantity("latitude", "latitude_rad", "sample.latitude_rad", None, Angle),
    quantity("longitude", "longitude_rad", "sample.longitude_rad", None, Angle),
    quantity("height", "height_m", "sample.height_m", None, Length),
    quantity("roll", "roll_rad", "sample.roll_rad", None, Angle),
    quantity("pitch", "pitch_rad", "sample.pitch_rad", None, Angle),
    quantity("heading", "heading_rad", "sample.heading_rad", None, Angle),
    quantity("east", "velocity_east_m_s", "sample.velocity_enu_m_s", Some(0), Speed),
    quantity("north", "velocity_north_m_s", "sample.velocity_enu_m_s", Some(1), Speed),
    quantity("up", "velocity_up_m_s", "sample.velocity_enu_m_s", Some(2), Speed),
    quantity("rate_x", "rate_x_rad_s", "sample.angular_rate_rad_s", Some(0), AngularRate),
    quantity("rate_y", "rate_y_rad_s", "sample.angular_rate_rad_s", Some(1), AngularRate),
    quantity("rate_z", "rate_z_rad_s", "sample.angular_rate_rad_s", Some(2), AngularRate),
    quantity("force_x", "force_x_m_s2", "sample.specific_force_m_s2", Some(0), Acceleration),
    quantity("force_y", "force_y_m_s2", "sample.specific_force_m_s2", Some(1), Acceleration),
    quantity("force_z", "force_z_m_s2", "sample.specific_force_m_s2", Some(2), Acceleration),
    quantity("temperature", "temperature_c", "sample.temperature_c", None, Temperature),
    quantity("speed", "", "", None, Speed),
    quantity("track", "", "", None, Angle),
    quantity("climb", "", "", None, Speed),
    quantity("forward", "", "", None, Speed),
    quantity("right", "", "", None, Speed),
    quantity("down", "", "", None, Speed),
    quantity("q0", "", "", None, Number),
    quantity("q1", "", "", None, Number),
    quantity("q2", "", "", None, Number),
    quantity("q3", "", "", None, Number),
    quantity("variation", "", "", None, Angle),
    quantity("geoid", "", "", None, Length),
];

/// The quantities of `[imu]`, the columns of a record of an IMU. They are no quantities of a sample.
pub const IMU_QUANTITIES: [Quantity; 7] = [
    quantity("time", "", "", None, Time),
    quantity("gyro_x", "", "", None, Gyro),
    quantity("gyro_y", "", "", None, Gyro),
    quantity("gyro_z", "", "", None, Gyro),
    quantity("accelerometer_x", "", "", None, Accelerometer),
    quantity("accelerometer_y", "", "", None, Accelerometer),
    quantity("accelerometer_z", "", "", None, Accelerometer),
];

/// Number of quantities of a sample.
pub const OF_SAMPLE: usize = 17;

/// The places of quantities that the readers of rows name.
pub const TIME: usize = 0;
pub const LATITUDE: usize = 1;
pub const LONGITUDE: usize = 2;
pub const HEIGHT: usize = 3;
pub const ROLL: usize = 4;
pub const HEADING: usize = 6;
pub const VELOCITY: usize = 7;
pub const RATE: usize = 10;
pub const FORCE: usize = 13;
pub const TEMPERATURE: usize = 16;
pub const SPEED: usize = 17;
pub const TRACK: usize = 18;
pub const FORWARD: usize = 20;
pub const Q0: usize = 23;
pub const VARIATION: usize = 27;
pub const GEOID: usize = 28;

/// The unit of latitudes and longitudes in degrees and minutes, as 4718.25 for 47 degrees and 18.25 minutes.
pub const DDMM: &str = "ddmm";

/// The units, and their sizes in SI. The first of a dimension is that of a key of `[log]` that states none.
const UNITS: [(&str, Dimension, f64); 48] = [
    ("s", Time, 1.0),
    ("ms", Time, 1e-3),
    ("us", Time, 1e-6),
    ("ns", Time, 1e-9),
    ("min", Time, 60.0),
    ("h", Time, 3600.0),
    ("d", Time, 86400.0),
    ("deg", Angle, DEG),
    ("rad", Angle, 1.0),
    ("arcmin", Angle, DEG / 60.0),
    ("arcsec", Angle, DEG / 3600.0),
    ("semicircle", Angle, core::f64::consts::PI / 2_147_483_648.0),
    (DDMM, Angle, DEG),
    ("m", Length, 1.0),
    ("ft", Length, 0.3048),
    ("mm", Length, 1e-3),
    ("cm", Length, 1e-2),
    ("km", Length, 1e3),
    ("m/s", Speed, 1.0),
    ("kt", Speed, NMI_PER_HOUR),
    ("ft/s", Speed, 0.3048),
    ("ft/min", Speed, 0.3048 / 60.0),
    ("mph", Speed, 0.44704),
    ("km/h", Speed, 1.0 / 3.6),
    ("cm/s", Speed, 1e-2),
    ("mm/s", Speed, 1e-3),
    ("rad/s", AngularRate, 1.0),
    ("deg/s", AngularRate, DEG),
    ("deg", AngularRate, DEG),
    ("m/s2", Acceleration, 1.0),
    ("g", Acceleration, STANDARD_GRAVITY),
    ("ft/s2", Acceleration, 0.3048),
    ("deg C", Temperature, 1.0),
    ("C", Temperature, 1.0),
    ("1", Number, 1.0),
    ("rad/s", Gyro, 1.0),
    ("deg/s", Gyro, DEG),
    ("mdeg/s", Gyro, 1e-3 * DEG),
    ("deg/h", Gyro, DEG_PER_HOUR),
    ("rad", Gyro, 1.0),
    ("deg", Gyro, DEG),
    ("arcsec", Gyro, ARCSEC),
    ("m/s2", Accelerometer, 1.0),
    ("g", Accelerometer, STANDARD_GRAVITY),
    ("mg", Accelerometer, 1e-3 * STANDARD_GRAVITY),
    ("ug", Accelerometer, MICRO_G),
    ("m/s", Accelerometer, 1.0),
    ("mm/s", Accelerometer, 1e-3),
];

/// A unit of a dimension, and its size in SI; an empty name: the one that a key has which states none. `None`: no such unit.
pub fn unit_of(dimension: Dimension, name: &str) -> Option<(&'static str, f64)> {
    let mut of_dimension = UNITS.iter().filter(|(_, its, _)| *its == dimension);
    of_dimension.find(|(unit, ..)| name.is_empty() || *unit == name).map(|(unit, _, si)| (*unit, *si))
}

/// The names of the units of a dimension.
pub fn units_of(dimension: Dimension) -> impl Iterator<Item = &'static str> {
    UNITS.iter().filter(move |(_, its, _)| *its == dimension).map(|(unit, ..)| *unit)
}

/// A unit of the outputs of a sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImuUnit {
    /// Its name in `[imu]`, as "deg/s".
    pub name: &'static str,
    /// Of a gyro, and not of an accelerometer.
    pub is_gyro: bool,
    /// Of an angle or a velocity over an interval, and not of their rate.
    pub is_increment: bool,
    /// Its size in rad/s, m/s², rad or m/s.
    pub si: f64,
}

/// The units of gyros, then those of accelerometers.
pub fn imu_units() -> impl Iterator<Item = ImuUnit> {
    [(Gyro, Angle), (Accelerometer, Speed)].into_iter().flat_map(|(sensor, of_increment)| {
        units_of(sensor).filter_map(move |name| {
            let (name, si) = unit_of(sensor, name)?;
            let is_increment = unit_of(of_increment, name).is_some();
            Some(ImuUnit { name, is_gyro: sensor == Gyro, is_increment, si })
        })
    })
}

/// The name of the column of a quantity of a sample.
pub fn name(quantity: usize) -> &'static str {
    QUANTITIES[quantity].name
}

/// The quantity that an error about a sample is about, in the order time, position, attitude, velocity, angular rate, specific force,
/// temperature.
pub fn quantity_of(error: &Error) -> Option<usize> {
    let is_it = |quantity: &Quantity| (quantity.field, quantity.index) == (error.field, error.index);
    QUANTITIES[..OF_SAMPLE].iter().position(is_it)
}

/// The name of the column that an error about a sample is about.
pub fn column_of(error: &Error) -> Option<&'static str> {
    quantity_of(error).map(name)
}

/// The name of an angle in degrees. Rates can be given only in radians.
pub fn in_degrees(quantity: &str) -> Option<String> {
    let stem = quantity.strip_suffix("_rad")?;
    Some(format!("{stem}_deg"))
}
