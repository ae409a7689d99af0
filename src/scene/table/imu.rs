//! The table of a record of an IMU: `[imu]`.

use super::super::key::{Key, Place, Section, Target, one};
use super::{choice, count, number, si, text};
use crate::base::parameter::Shape;
use crate::log::{IMU_QUANTITIES, Separator, TimeFormat};
use crate::scene::limits::ANY;

const I: Section = Section::Imu;
const N: Shape = Shape::Number;

/// The meaning of each quantity, in the order of the table of quantities.
const MEANINGS: [&str; IMU_QUANTITIES.len()] = [
    "time at the end of the interval of a row",
    "angular rate about x, or angle over the interval; unit: rad/s, deg/s, mdeg/s, deg/h, rad, deg, arcsec",
    "angular rate or angle about y",
    "angular rate or angle about z",
    "specific force along x, or velocity over the interval; unit: m/s2, g, mg, ug, m/s, mm/s",
    "specific force or velocity along y",
    "specific force or velocity along z; of a sensor that is negative where it is pushed, sign = -1",
];

pub const FORMAT: &[Key] = &[
    count!(I, "header", "the first line that can be that of the names, from 1; 0: columns have numbers only", "imu.header" => scene.imu.header),
    count!(I, "skip", "number of rows behind the names that are left out", "imu.skip" => scene.imu.skip),
    choice!(I, "separator", "what separates fields", "imu.separator" => scene.imu.separator, Separator::WORDS),
    text(I, "comment", "#", "mark with which a comment begins", |d| &mut d.scene.imu.comment),
    number!(I, N, "missing", si(""), "number that stands for a missing value; a row with one is left out",
        "imu.missing" in (-ANY, ANY) => one(imu_missing)),
    text(
        I,
        "only_column",
        "I",
        "column that tells the sensors of a table apart; with only, the rows of one are read",
        |d| &mut d.scene.imu.only_column,
    ),
    text(I, "only", "0", "cell of only_column in the rows that are read", |d| &mut d.scene.imu.only),
    choice!(I, "time_format", "how times are written: a number, hh:mm:ss, mm:ss, ISO 8601, day or month before the year (dmy, mdy), or not at all", "imu.time_format" => scene.imu.time_format, TimeFormat::WORDS),
    number!(I, N, "rate_hz", si("Hz"), "rate of rows without times",
        "imu.rate_hz" in (1e-3, 1e6) => one(imu_rate_hz)),
];

pub const COLUMNS: &[Key] = &{
    let mut keys = [Key::new(I, "", "", Target::Column(0)); IMU_QUANTITIES.len()];
    let mut index = 0;
    while index < keys.len() {
        keys[index] = Key::new(I, IMU_QUANTITIES[index].key, MEANINGS[index], Target::Column(index));
        index += 1;
    }
    keys
};
