//! Formats of flight logs that are known by the names of their columns.

/// A format.
pub struct Known {
    /// Its name.
    pub name: &'static str,
    /// Columns by which it is recognized: all of them are there.
    pub columns: &'static [&'static str],
    /// Its keys of `[log]`. A key whose column the table does not have is left out.
    pub keys: &'static str,
    /// What it lacks, or what only its user knows; empty: nothing.
    pub doubt: &'static str,
}

/// The formats. Of two that fit, the first is taken.
pub const KNOWN: [Known; 13] = [
    Known {
        name: "Garmin G1000",
        columns: &["Lcl Time", "AltMSL", "GndSpd", "TRK", "VSpd"],
        keys: r#"time = "Lcl Time"
time_format = "hms"
latitude = "Latitude"
longitude = "Longitude"
height = { col = "AltGPS", unit = "ft" }
height = { col = "AltMSL", unit = "ft" }
speed = { col = "GndSpd", unit = "kt" }
track = "TRK"
track_is = "magnetic"
climb = { col = "VSpd", unit = "ft/min" }
roll = "Roll"
pitch = "Pitch"
heading = "HDG"
variation = "MagVar"
smooth = "auto""#,
        doubt: "heading and track are taken as magnetic; without a column MagVar set variation; AltMSL is above the sea: set geoid",
    },
    Known {
        name: "Garmin G5",
        columns: &["GPS Altitude (WGS84 ft)", "GPS Velocity E (m/s)"],
        keys: r#"time = "UTC Time (hh:mm:ss)"
time_format = "hms"
latitude = "Latitude (WGS84 deg)"
longitude = "Longitude (WGS84 deg)"
height = { col = "GPS Altitude (WGS84 ft)", unit = "ft" }
east = "GPS Velocity E (m/s)"
north = "GPS Velocity N (m/s)"
up = "GPS Velocity U (m/s)"
roll = "Roll (deg)"
pitch = "Pitch (deg)"
heading = "Magnetic Heading (deg)"
variation = "Magnetic Variation (deg)"
smooth = "auto""#,
        doubt: "",
    },
    Known {
        name: "Garmin G3X",
        columns: &["GPS Altitude (ft)", "GPS Velocity E (m/sec)"],
        keys: r#"time = "UTC Time (hh:mm:ss)"
time_format = "hms"
latitude = "Latitude (deg)"
longitude = "Longitude (deg)"
height = { col = "GPS Altitude (ft)", unit = "ft" }
east = "GPS Velocity E (m/sec)"
north = "GPS Velocity N (m/sec)"
up = "GPS Velocity U (m/sec)"
roll = "Roll (deg)"
pitch = "Pitch (deg)"
heading = "Magnetic Heading (deg)"
smooth = "auto""#,
        doubt: "the heading is magnetic: set variation",
    },
    Known {
        name: "X-Plane Data.txt",
        columns: &["_real,_time", "__lat,__deg", "hding,_true"],
        keys: r#"time = "_real,_time"
latitude = "__lat,__deg"
longitude = "__lon,__deg"
height = { col = "__alt,ftmsl", unit = "ft" }
roll = "_roll,__deg"
pitch = "pitch,__deg"
heading = "hding,_true"
smooth = "auto""#,
        doubt: "positions are 32-bit floats; vX, vY, vZ are those of local axes, which are east, up, south at their origin only, and are not read",
    },
    Known {
        name: "FlightGear",
        columns: &["/position/latitude-deg", "/position/altitude-ft"],
        keys: r#"time = { col = "Time", unit = "ms" }
latitude = "/position/latitude-deg"
longitude = "/position/longitude-deg"
height = { col = "/position/altitude-ft", unit = "ft" }
east = { col = "/velocities/speed-east-fps", unit = "ft/s" }
north = { col = "/velocities/speed-north-fps", unit = "ft/s" }
up = { col = "/velocities/speed-down-fps", unit = "ft/s", sign = -1 }
roll = "/orientation/roll-deg"
pitch = "/orientation/pitch-deg"
heading = "/orientation/heading-deg""#,
        doubt: "the height is above the sea: set geoid",
    },
    Known {
        name: "SimConnect",
        columns: &["PLANE LATITUDE", "PLANE ALTITUDE", "PLANE BANK DEGREES"],
        keys: r#"time = "Time"
latitude = "PLANE LATITUDE"
longitude = "PLANE LONGITUDE"
height = { col = "PLANE ALTITUDE", unit = "ft" }
east = { col = "VELOCITY WORLD X", unit = "ft/s" }
north = { col = "VELOCITY WORLD Z", unit = "ft/s" }
up = { col = "VELOCITY WORLD Y", unit = "ft/s" }
roll = { col = "PLANE BANK DEGREES", unit = "rad", sign = -1 }
pitch = { col = "PLANE PITCH DEGREES", unit = "rad", sign = -1 }
heading = { col = "PLANE HEADING DEGREES TRUE", unit = "rad" }"#,
        doubt: "angles of the attitude are taken as radians, the position as degrees, as their default units are",
    },
    Known {
        name: "Sky Dolly",
        columns: &["Timestamp", "UTC", "Speed", "Bank", "Pitch", "Heading", "Altitude"],
        keys: r#"time = { col = "Timestamp", unit = "ms" }
latitude = "Latitude"
longitude = "Longitude"
height = { col = "Altitude", unit = "ft" }
roll = { col = "Bank", sign = -1 }
pitch = { col = "Pitch", sign = -1 }
heading = "Heading"
smooth = "auto""#,
        doubt: "Timestamp is taken as ms, Altitude as ft, Bank and Pitch with the signs of SimConnect: left and nose down are positive",
    },
    Known {
        name: "ArduPilot (POS)",
        columns: &["TimeUS", "Lat", "Lng", "Alt", "RelHomeAlt"],
        keys: r#"time = { col = "TimeUS", unit = "us" }
latitude = "Lat"
longitude = "Lng"
height = "Alt"
smooth = "auto"
attitude = "coordinated""#,
        doubt: "the file of this message has no attitude, so that of a coordinated flight is taken; a multicopter has another",
    },
    Known {
        name: "AirData",
        columns: &["time(millisecond)", "xSpeed(mph)", "compass_heading(degrees)"],
        keys: r#"time = { col = "time(millisecond)", unit = "ms" }
latitude = "latitude"
longitude = "longitude"
height = { col = "altitude_above_seaLevel(feet)", unit = "ft" }
north = { col = "xSpeed(mph)", unit = "mph" }
east = { col = "ySpeed(mph)", unit = "mph" }
up = { col = "zSpeed(mph)", unit = "mph", sign = -1 }
roll = "roll(degrees)"
pitch = "pitch(degrees)"
heading = "compass_heading(degrees)"
smooth = "auto""#,
        doubt: "zSpeed is taken as positive down",
    },
    Known {
        name: "OpenSky states",
        columns: &["icao24", "lat", "lon", "geoaltitude", "vertrate"],
        keys: r#"time = "lastposupdate"
latitude = "lat"
longitude = "lon"
height = "geoaltitude"
speed = "velocity"
track = "heading"
climb = "vertrate"
smooth = "auto"
attitude = "coordinated""#,
        doubt: "one aircraft a file: select the rows of one icao24",
    },
    Known {
        name: "traffic",
        columns: &["timestamp", "icao24", "groundspeed", "vertical_rate"],
        keys: r#"time = "timestamp"
time_format = "iso"
latitude = "latitude"
longitude = "longitude"
height = { col = "geoaltitude", unit = "ft" }
height = { col = "altitude", unit = "ft" }
speed = { col = "groundspeed", unit = "kt" }
track = "track"
climb = { col = "vertical_rate", unit = "ft/min" }
smooth = "auto"
attitude = "coordinated""#,
        doubt: "one aircraft a file: select the rows of one icao24",
    },
    Known {
        name: "NCAR research aircraft",
        columns: &["Time", "LATC", "LONC", "GGALT", "THDG"],
        keys: r#"time = "Time"
latitude = "LATC"
longitude = "LONC"
height = "GGALT"
east = "GGVEW"
north = "GGVNS"
up = "GGVSPD"
roll = "ROLL"
pitch = "PITCH"
heading = "THDG"
missing = -32767
smooth = "auto""#,
        doubt: "the height is above the sea: set geoid",
    },
    Known {
        name: "JSBSim",
        columns: &["Latitude Geodetic (deg)", "Altitude ASL (ft)", "V_{North} (ft/s)"],
        keys: r#"time = "Time"
latitude = "Latitude Geodetic (deg)"
longitude = "Longitude (deg)"
height = { col = "Altitude ASL (ft)", unit = "ft" }
east = { col = "V_{East} (ft/s)", unit = "ft/s" }
north = { col = "V_{North} (ft/s)", unit = "ft/s" }
up = { col = "V_{Down} (ft/s)", unit = "ft/s", sign = -1 }
roll = "Phi (deg)"
pitch = "Theta (deg)"
heading = "Psi (deg)""#,
        doubt: "the height is above the sea: set geoid if it matters",
    },
];
