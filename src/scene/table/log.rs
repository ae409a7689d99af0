//! The table of a flight log: `[log]`.

use super::super::key::{Key, Place, Section, Target, one};
use super::{choice, count, number, si, text, unit};
use crate::base::parameter::Shape;
use crate::base::units::DEG;
use crate::log::{QUANTITIES, Separator, TimeFormat};
use crate::scene::limits::ANY;

const L: Section = Section::Log;
const N: Shape = Shape::Number;
const NORTH: [(&str, bool); 2] = [("true", false), ("magnetic", true)];

/// The meaning of each quantity, in the order of the table of quantities.
const MEANINGS: [&str; QUANTITIES.len()] = [
    "time",
    "geodetic latitude [deg]",
    "longitude, east positive [deg]",
    "height above the ellipsoid, or, with geoid, above the sea [m]",
    "roll, right wing down positive [deg]",
    "pitch, nose up positive [deg]",
    "heading, clockwise from true north, or, with variation, from magnetic north [deg]",
    "velocity east against the Earth [m/s]",
    "velocity north [m/s]",
    "velocity up; of one that is positive down, sign = -1 [m/s]",
    "angular rate about the sensor axis x [rad/s]",
    "angular rate about the sensor axis y [rad/s]",
    "angular rate about the sensor axis z [rad/s]",
    "specific force along the sensor axis x [m/s2]",
    "specific force along the sensor axis y [m/s2]",
    "specific force along the sensor axis z [m/s2]",
    "temperature of the sensors [deg C]",
    "speed over ground; with track and climb, in place of east, north, up [m/s]",
    "direction of the velocity, clockwise from north [deg]",
    "rate of climb [m/s]",
    "velocity forward along the body; with right and down, in place of east, north, up [m/s]",
    "velocity to the right of the body [m/s]",
    "velocity towards the belly of the body [m/s]",
    "quaternion from body axes forward-right-down to north-east-down: its scalar",
    "quaternion: its forward part",
    "quaternion: its right part",
    "quaternion: its down part",
    "magnetic variation, east positive; it is added to the heading [deg]",
    "height of the geoid above the ellipsoid; it is added to the height [m]",
];

pub const FORMAT: &[Key] = &[
    count!(L, "header", "the first line that can be that of the names, from 1; 0: columns have numbers only", "log.header" => scene.log.header),
    count!(L, "skip", "number of rows behind the names that are left out", "log.skip" => scene.log.skip),
    choice!(L, "separator", "what separates fields", "log.separator" => scene.log.separator, Separator::WORDS),
    text(L, "comment", "#", "mark with which a comment begins", |d| &mut d.scene.log.comment),
    text(
        L,
        "only_column",
        "icao24",
        "column that tells the vehicles of a table apart; with only, the rows of one are read",
        |d| &mut d.scene.log.only_column,
    ),
    text(L, "only", "3c6444", "cell of only_column in the rows that are read", |d| &mut d.scene.log.only),
    number!(L, N, "missing", si(""), "number that stands for a missing value; a row with one is left out",
        "log.missing" in (-ANY, ANY) => one(log_missing)),
    choice!(L, "time_format", "how times are written: a number, hh:mm:ss, mm:ss, ISO 8601, day or month before the year (dmy, mdy), or not at all", "log.time_format" => scene.log.time_format, TimeFormat::WORDS),
    number!(L, N, "rate_hz", si("Hz"), "rate of rows without times",
        "log.rate_hz" in (1e-3, 2e4) => one(log_rate_hz)),
    choice!(L, "track_is", "north of the track; the variation is added to a magnetic one",
        "log.track_is" => scene.log.is_track_magnetic, NORTH),
];

pub const REPAIR: &[Key] = &[
    choice!(L, "smooth", "smooths the path: noise, coarse steps, repeats, outliers; velocities follow from it", "log.smooth" => scene.log.smooth,
        [("off", false), ("auto", true)]),
    number!(L, N, "smooth_rate_hz", si("Hz"), "rate of the samples of a smoothed path",
        "log.smooth_rate_hz" in (1e-3, 2e4) => one(scene.log.smooth_rate_hz)),
    number!(L, N, "position_sigma_m", si("m"), "white noise of a component of the position; default: found from the rows",
        "log.position_sigma_m" in (1e-9, 1e4) => one(log_position_sigma_m)),
    number!(L, N, "attitude_sigma_deg", unit("deg", DEG, "rad"), "white noise of an angle; default: found from the rows",
        "log.attitude_sigma_rad" in (1e-9, 1e4) => one(log_attitude_sigma_rad)),
    choice!(L, "attitude", "attitude of the log, or that of a coordinated flight along the smoothed path, without wind",
        "log.attitude" => scene.log.is_coordinated, [("log", false), ("coordinated", true)]),
    number!(L, N, "attack_deg", unit("deg", DEG, "rad"), "angle of attack of a coordinated flight",
        "log.attack_rad" in (-0.8, 0.8) => one(scene.log.attack_rad)),
];

pub const COLUMNS: &[Key] = &{
    let mut keys = [Key::new(L, "", "", Target::Column(0)); QUANTITIES.len()];
    let mut index = 0;
    while index < keys.len() {
        keys[index] = Key::new(L, QUANTITIES[index].key, MEANINGS[index], Target::Column(index));
        index += 1;
    }
    keys
};
