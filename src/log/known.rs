//! Formats of flight logs that are known by the names of their columns.

use csv::StringRecord;

use super::column::{ColumnFrom, LogColumn};
use crate::base::text::{number_text, text_in_quotes};
use recorders::RECORDERS;

/// A key of `[log]` and its value.
pub struct Key {
    pub name: &'static str,
    pub value: Value,
}

/// The value of a key.
pub enum Value {
    /// The quantity stands in the column of this name.
    Column { name: &'static str, unit: &'static str, scale: f64, part: usize },
    /// A word.
    Word(&'static str),
    /// A number.
    Number(f64),
}

const fn column(key: &'static str, name: &'static str) -> Key {
    Key { name: key, value: Value::Column { name, unit: "", scale: 1.0, part: 0 } }
}

const fn word(name: &'static str, word: &'static str) -> Key {
    Key { name, value: Value::Word(word) }
}

const fn number(name: &'static str, number: f64) -> Key {
    Key { name, value: Value::Number(number) }
}

impl Key {
    const fn unit(self, of: &'static str) -> Self {
        match self.value {
            Value::Column { name, scale, part, .. } => {
                Self { name: self.name, value: Value::Column { name, unit: of, scale, part } }
            }
            _ => self,
        }
    }

    /// With the opposite sign.
    const fn reversed(self) -> Self {
        match self.value {
            Value::Column { name, unit, part, .. } => {
                Self { name: self.name, value: Value::Column { name, unit, scale: -1.0, part } }
            }
            _ => self,
        }
    }

    /// The part of a cell of several values, from 1.
    const fn part(self, of: usize) -> Self {
        match self.value {
            Value::Column { name, unit, scale, .. } => {
                Self { name: self.name, value: Value::Column { name, unit, scale, part: of } }
            }
            _ => self,
        }
    }
}

impl Value {
    /// In TOML.
    pub fn text(&self) -> String {
        match *self {
            Self::Column { name, unit, scale, part } => {
                let from = ColumnFrom::Name(name.to_owned());
                LogColumn { from, unit, scale, part, ..LogColumn::default() }.text()
            }
            Self::Word(word) => text_in_quotes(word),
            Self::Number(number) => number_text(number),
        }
    }
}

/// A format.
pub struct Known {
    /// Its name.
    pub name: &'static str,
    /// Columns by which it is recognized: all of them are there.
    pub columns: &'static [&'static str],
    /// Its keys of `[log]`. A key whose column the table does not have is left out.
    pub keys: &'static [Key],
    /// What it lacks, or what only its user knows; empty: nothing.
    pub doubt: &'static str,
}

/// The known format whose columns are all there.
pub fn known(names: &StringRecord) -> Option<&'static Known> {
    KNOWN
        .iter()
        .chain(&RECORDERS)
        .find(|known| known.columns.iter().all(|column| names.iter().any(|name| name == *column)))
}

/// The formats. Of two that fit, the first is taken.
const KNOWN: [Known; 16] = [
    Known {
        name: "Garmin G1000",
        columns: &["Lcl Time", "AltMSL", "GndSpd", "TRK", "VSpd"],
        keys: &[
            column("time", "Lcl Time"),
            word("time_format", "hms"),
            column("latitude", "Latitude"),
            column("longitude", "Longitude"),
            column("height", "AltGPS").unit("ft"),
            column("height", "AltMSL").unit("ft"),
            column("speed", "GndSpd").unit("kt"),
            column("track", "TRK"),
            word("track_is", "magnetic"),
            column("climb", "VSpd").unit("ft/min"),
            column("roll", "Roll"),
            column("pitch", "Pitch"),
            column("heading", "HDG"),
            column("variation", "MagVar"),
            word("smooth", "auto"),
        ],
        doubt: "heading and track are taken as magnetic; without a column MagVar set variation; AltMSL is above the sea: set geoid",
    },
    Known {
        name: "Garmin G5",
        columns: &["GPS Altitude (WGS84 ft)", "GPS Velocity E (m/s)"],
        keys: &[
            column("time", "UTC Time (hh:mm:ss)"),
            word("time_format", "hms"),
            column("latitude", "Latitude (WGS84 deg)"),
            column("longitude", "Longitude (WGS84 deg)"),
            column("height", "GPS Altitude (WGS84 ft)").unit("ft"),
            column("east", "GPS Velocity E (m/s)"),
            column("north", "GPS Velocity N (m/s)"),
            column("up", "GPS Velocity U (m/s)"),
            column("roll", "Roll (deg)"),
            column("pitch", "Pitch (deg)"),
            column("heading", "Magnetic Heading (deg)"),
            column("variation", "Magnetic Variation (deg)"),
            word("smooth", "auto"),
        ],
        doubt: "",
    },
    Known {
        name: "Garmin G3X",
        columns: &["GPS Altitude (ft)", "GPS Velocity E (m/sec)"],
        keys: &[
            column("time", "UTC Time (hh:mm:ss)"),
            word("time_format", "hms"),
            column("latitude", "Latitude (deg)"),
            column("longitude", "Longitude (deg)"),
            column("height", "GPS Altitude (ft)").unit("ft"),
            column("east", "GPS Velocity E (m/sec)"),
            column("north", "GPS Velocity N (m/sec)"),
            column("up", "GPS Velocity U (m/sec)"),
            column("roll", "Roll (deg)"),
            column("pitch", "Pitch (deg)"),
            column("heading", "Magnetic Heading (deg)"),
            word("smooth", "auto"),
        ],
        doubt: "the heading is magnetic: set variation",
    },
    Known {
        name: "X-Plane Data.txt",
        columns: &["_real,_time", "__lat,__deg", "hding,_true"],
        keys: &[
            column("time", "_real,_time"),
            column("latitude", "__lat,__deg"),
            column("longitude", "__lon,__deg"),
            column("height", "__alt,ftmsl").unit("ft"),
            column("roll", "_roll,__deg"),
            column("pitch", "pitch,__deg"),
            column("heading", "hding,_true"),
            word("smooth", "auto"),
        ],
        doubt: "positions are 32-bit floats; vX, vY, vZ are those of local axes, which are east, up, south at their origin only, and are not read",
    },
    Known {
        name: "FlightGear",
        columns: &["/position/latitude-deg", "/position/altitude-ft"],
        keys: &[
            column("time", "Time").unit("ms"),
            column("latitude", "/position/latitude-deg"),
            column("longitude", "/position/longitude-deg"),
            column("height", "/position/altitude-ft").unit("ft"),
            column("east", "/velocities/speed-east-fps").unit("ft/s"),
            column("north", "/velocities/speed-north-fps").unit("ft/s"),
            column("up", "/velocities/speed-down-fps").unit("ft/s").reversed(),
            column("roll", "/orientation/roll-deg"),
            column("pitch", "/orientation/pitch-deg"),
            column("heading", "/orientation/heading-deg"),
        ],
        doubt: "the height is above the sea: set geoid",
    },
    Known {
        name: "SimConnect",
        columns: &["PLANE LATITUDE", "PLANE ALTITUDE", "PLANE BANK DEGREES"],
        keys: &[
            column("time", "Time"),
            column("latitude", "PLANE LATITUDE"),
            column("longitude", "PLANE LONGITUDE"),
            column("height", "PLANE ALTITUDE").unit("ft"),
            column("east", "VELOCITY WORLD X").unit("ft/s"),
            column("north", "VELOCITY WORLD Z").unit("ft/s"),
            column("up", "VELOCITY WORLD Y").unit("ft/s"),
            column("roll", "PLANE BANK DEGREES").unit("rad").reversed(),
            column("pitch", "PLANE PITCH DEGREES").unit("rad").reversed(),
            column("heading", "PLANE HEADING DEGREES TRUE").unit("rad"),
        ],
        doubt: "angles of the attitude are taken as radians, the position as degrees, as their default units are",
    },
    Known {
        name: "Sky Dolly",
        columns: &["Timestamp", "UTC", "Speed", "Bank", "Pitch", "Heading", "Altitude"],
        keys: &[
            column("time", "Timestamp").unit("ms"),
            column("latitude", "Latitude"),
            column("longitude", "Longitude"),
            column("height", "Altitude").unit("ft"),
            column("roll", "Bank").reversed(),
            column("pitch", "Pitch").reversed(),
            column("heading", "Heading"),
            word("smooth", "auto"),
        ],
        doubt: "Timestamp is taken as ms, Altitude as ft, Bank and Pitch with the signs of SimConnect: left and nose down are positive",
    },
    Known {
        name: "ArduPilot (POS)",
        columns: &["TimeUS", "Lat", "Lng", "Alt", "RelHomeAlt"],
        keys: &[
            column("time", "TimeUS").unit("us"),
            column("latitude", "Lat"),
            column("longitude", "Lng"),
            column("height", "Alt"),
            word("smooth", "auto"),
            word("attitude", "coordinated"),
        ],
        doubt: "the file of this message has no attitude, so that of a coordinated flight is taken; a multicopter has another",
    },
    Known {
        name: "PX4 (vehicle_global_position)",
        columns: &["timestamp", "lat", "lon", "alt", "eph", "epv"],
        keys: &[
            column("time", "timestamp").unit("us"),
            column("latitude", "lat"),
            column("longitude", "lon"),
            column("height", "alt_ellipsoid"),
            column("height", "alt"),
            word("smooth", "auto"),
            word("attitude", "coordinated"),
        ],
        doubt: "the file of this topic has no attitude, so that of a coordinated flight is taken; a multicopter has another",
    },
    Known {
        name: "AirData",
        columns: &["time(millisecond)", "xSpeed(mph)", "compass_heading(degrees)"],
        keys: &[
            column("time", "time(millisecond)").unit("ms"),
            column("latitude", "latitude"),
            column("longitude", "longitude"),
            column("height", "altitude_above_seaLevel(feet)").unit("ft"),
            column("north", "xSpeed(mph)").unit("mph"),
            column("east", "ySpeed(mph)").unit("mph"),
            column("up", "zSpeed(mph)").unit("mph").reversed(),
            column("roll", "roll(degrees)"),
            column("pitch", "pitch(degrees)"),
            column("heading", "compass_heading(degrees)"),
            word("smooth", "auto"),
        ],
        doubt: "zSpeed is taken as positive down",
    },
    Known {
        name: "OpenSky states",
        columns: &["icao24", "lat", "lon", "geoaltitude", "vertrate"],
        keys: &[
            column("time", "lastposupdate"),
            column("latitude", "lat"),
            column("longitude", "lon"),
            column("height", "geoaltitude"),
            column("speed", "velocity"),
            column("track", "heading"),
            column("climb", "vertrate"),
            word("smooth", "auto"),
            word("attitude", "coordinated"),
        ],
        doubt: "one aircraft a file: select the rows of one icao24",
    },
    Known {
        name: "traffic",
        columns: &["timestamp", "icao24", "groundspeed", "vertical_rate"],
        keys: &[
            column("time", "timestamp"),
            word("time_format", "iso"),
            column("latitude", "latitude"),
            column("longitude", "longitude"),
            column("height", "geoaltitude").unit("ft"),
            column("height", "altitude").unit("ft"),
            column("speed", "groundspeed").unit("kt"),
            column("track", "track"),
            column("climb", "vertical_rate").unit("ft/min"),
            word("smooth", "auto"),
            word("attitude", "coordinated"),
        ],
        doubt: "one aircraft a file: select the rows of one icao24",
    },
    Known {
        name: "Flightradar24",
        columns: &["Timestamp", "UTC", "Callsign", "Position", "Altitude", "Speed", "Direction"],
        keys: &[
            column("time", "Timestamp"),
            column("latitude", "Position").part(1),
            column("longitude", "Position").part(2),
            column("height", "Altitude").unit("ft"),
            word("smooth", "auto"),
            word("attitude", "coordinated"),
        ],
        doubt: "Altitude is a pressure altitude; Speed and Direction are not read, since without a climb rate they are no whole velocity",
    },
    Known {
        name: "Columbus GNSS logger",
        columns: &["INDEX", "TAG", "TIME", "LATITUDE N/S", "LONGITUDE E/W", "HEIGHT"],
        keys: &[
            column("time", "TIME"),
            word("time_format", "hms"),
            column("latitude", "LATITUDE N/S"),
            column("longitude", "LONGITUDE E/W"),
            column("height", "HEIGHT"),
            word("smooth", "auto"),
            word("attitude", "coordinated"),
        ],
        doubt: "the height is above the sea: set geoid; it has no attitude, so that of a coordinated flight is taken",
    },
    Known {
        name: "NCAR research aircraft",
        columns: &["Time", "LATC", "LONC", "GGALT", "THDG"],
        keys: &[
            column("time", "Time"),
            column("latitude", "LATC"),
            column("longitude", "LONC"),
            column("height", "GGALT"),
            column("east", "GGVEW"),
            column("north", "GGVNS"),
            column("up", "GGVSPD"),
            column("roll", "ROLL"),
            column("pitch", "PITCH"),
            column("heading", "THDG"),
            number("missing", -32767.0),
            word("smooth", "auto"),
        ],
        doubt: "the height is above the sea: set geoid",
    },
    Known {
        name: "JSBSim",
        columns: &["Latitude Geodetic (deg)", "Altitude ASL (ft)", "V_{North} (ft/s)"],
        keys: &[
            column("time", "Time"),
            column("latitude", "Latitude Geodetic (deg)"),
            column("longitude", "Longitude (deg)"),
            column("height", "Altitude ASL (ft)").unit("ft"),
            column("east", "V_{East} (ft/s)").unit("ft/s"),
            column("north", "V_{North} (ft/s)").unit("ft/s"),
            column("up", "V_{Down} (ft/s)").unit("ft/s").reversed(),
            column("roll", "Phi (deg)"),
            column("pitch", "Theta (deg)"),
            column("heading", "Psi (deg)"),
        ],
        doubt: "the height is above the sea: set geoid if it matters",
    },
];

mod recorders;
#[cfg(test)]
mod tests;
