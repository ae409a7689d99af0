//! What the name of a column says: quantity, unit and sign.

use super::quantity::{Dimension, LATITUDE, LONGITUDE, QUANTITIES, unit_of};
use super::words::{unit_and_words, words};

/// What a column has, by its name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Guess {
    /// Quantity, by its place in the table.
    pub quantity: usize,
    /// Unit; empty: the name states none.
    pub unit: &'static str,
    /// -1: the column has the opposite sign.
    pub sign: f64,
    /// Place of the name among those of the quantity: of two columns the first is the better one.
    pub rank: usize,
}

/// Names of quantities, without units, blanks and marks. A name that begins with "-" has the opposite sign.
const NAMES: &[(&str, &[&str])] = &[
    (
        "time",
        &[
            "time",
            "timestamp",
            "utctime",
            "utc",
            "gpstime",
            "simtime",
            "elapsedtime",
            "elapsed",
            "realtime",
            "lcltime",
            "localtime",
            "datetime",
            "date",
            "sow",
            "gpssow",
            "tow",
            "gpstow",
            "isotime",
            "sessiontime",
            "timefromstart",
            "timesincestart",
            "relativetime",
            "flighttime",
            "missiontime",
            "zeit",
            "uhrzeit",
            "t",
        ],
    ),
    ("latitude", &["latitudegeodetic", "latitude", "lat", "latd", "latdd", "breite", "breitengrad"]),
    (
        "longitude",
        &[
            "longitude",
            "lon",
            "long",
            "lng",
            "lond",
            "londd",
            "longd",
            "länge",
            "laenge",
            "längengrad",
            "laengengrad",
        ],
    ),
    (
        "height",
        &[
            "altellipsoid",
            "heightellipsoid",
            "altgps",
            "gpsalt",
            "altitudegps",
            "height",
            "altitude",
            "alt",
            "altmsl",
            "altitudemsl",
            "heightmsl",
            "altitudeasl",
            "altamsl",
            "altitudeamsl",
            "elevation",
            "ele",
            "hgt",
            "geoaltitude",
            "altgeom",
            "enhancedaltitude",
            "altitudeabovesealevel",
            "ggalt",
            "h",
            "höhe",
            "hoehe",
            "baroaltitude",
            "altbaro",
            "palt",
            "pressurealtitude",
        ],
    ),
    (
        "roll",
        &[
            "roll",
            "rollwinkel",
            "phi",
            "bank",
            "rolldeg",
            "rollangle",
            "bankangle",
            "roulis",
            "querneigung",
            "querlage",
        ],
    ),
    ("pitch", &["pitch", "nickwinkel", "theta", "pitchangle", "längsneigung", "laengsneigung", "tangage"]),
    (
        "heading",
        &[
            "heading",
            "psi",
            "yaw",
            "hdg",
            "thdg",
            "headingtrue",
            "trueheading",
            "compassheading",
            "magneticheading",
            "headingmagnetic",
            "headingmag",
            "azimuth",
            "rumbo",
            "cap",
            "steuerkurs",
        ],
    ),
    (
        "east",
        &[
            "velocityeast",
            "eastvelocity",
            "veast",
            "vele",
            "veleast",
            "ve",
            "velocitye",
            "speedeast",
            "eastspeed",
        ],
    ),
    (
        "north",
        &[
            "velocitynorth",
            "northvelocity",
            "vnorth",
            "veln",
            "velnorth",
            "vn",
            "velocityn",
            "speednorth",
            "northspeed",
        ],
    ),
    (
        "up",
        &[
            "velocityup",
            "upvelocity",
            "vup",
            "velu",
            "velup",
            "vu",
            "velocityu",
            "speedup",
            "-velocitydown",
            "-downvelocity",
            "-vdown",
            "-veld",
            "-veldown",
            "-vd",
            "-velocityd",
            "-speeddown",
        ],
    ),
    (
        "speed",
        &[
            "speed",
            "groundspeed",
            "gs",
            "gndspd",
            "gspeed",
            "spd",
            "enhancedspeed",
            "sog",
            "speedoverground",
            "geschwindigkeit",
        ],
    ),
    (
        "track",
        &[
            "track",
            "course",
            "trk",
            "cog",
            "groundtrack",
            "trackangle",
            "kurs",
            "bearing",
            "courseoverground",
            "truetrack",
            "tracktrue",
        ],
    ),
    (
        "climb",
        &["climb", "vspd", "verticalspeed", "verticalrate", "vertrate", "climbrate", "vs", "rateofclimb"],
    ),
    ("variation", &["variation", "magvar", "magneticvariation", "declination"]),
    ("q0", &["q0", "qw", "quatw", "quaternionw", "orientationw"]),
    ("q1", &["q1", "qx", "quatx", "quaternionx", "orientationx"]),
    ("q2", &["q2", "qy", "quaty", "quaterniony", "orientationy"]),
    ("q3", &["q3", "qz", "quatz", "quaternionz", "orientationz"]),
    ("temperature", &["temperature", "temp", "oat", "imutemp"]),
];

/// Names of columns with the letter of a hemisphere, without blanks and marks, and the words behind them that do not change them.
const HEMISPHERES: [(usize, &[&str]); 2] = [
    (LATITUDE, &["ns", "latns", "latitudens", "northsouth", "latside", "latitudeside"]),
    (LONGITUDE, &["ew", "lonew", "longew", "longitudeew", "eastwest", "lonside", "longitudeside"]),
];
const AFTER: [&str; 3] = ["indicator", "hemisphere", "ind"];

/// Words before a quantity that do not change it.
const BEFORE: [&str; 19] = [
    "gps",
    "gnss",
    "ins",
    "nav",
    "pos",
    "position",
    "positions",
    "velocities",
    "orientation",
    "attitude",
    "angle",
    "plane",
    "imu",
    "ahrs",
    "truth",
    "ref",
    "aircraft",
    "field",
    "pose",
];

/// What the column of a name has, if the name says it.
pub fn guess(name: &str) -> Option<Guess> {
    let (unit, mut words) = unit_and_words(name);
    loop {
        let stem = words.concat();
        let is_one = |known: &&str| known.strip_prefix('-').unwrap_or(known) == stem;
        let found = NAMES.iter().find_map(|(key, names)| {
            let rank = names.iter().position(is_one)?;
            Some((*key, names[rank], rank))
        });
        if let Some((key, name, rank)) = found {
            let quantity = QUANTITIES.iter().position(|quantity| quantity.key == key)?;
            let dimension = QUANTITIES[quantity].dimension;
            // vel_e_ms is one in m/s.
            let unit = if unit == "ms" && dimension == Dimension::Speed { "m/s" } else { unit };
            // A heading (M) is magnetic, a LatM has minutes.
            let is_place = [LATITUDE, LONGITUDE].contains(&quantity);
            let is_magnetic = dimension == Dimension::Angle && unit == "m" && !is_place;
            let is_of_it = unit_of(dimension, unit).is_some();
            if !is_of_it && !is_magnetic && dimension != Dimension::Temperature {
                return None;
            }
            let unit = if is_of_it { unit } else { "" };
            let sign = if name.starts_with('-') { -1.0 } else { 1.0 };
            return Some(Guess { quantity, unit, sign, rank });
        }
        let is_before = words.len() > 1 && BEFORE.contains(&words[0].as_str());
        if !is_before {
            return None;
        }
        words.remove(0);
    }
}

/// The quantity whose hemisphere the column of this name has; `None`: the name says no such thing.
pub fn hemisphere_of(name: &str) -> Option<usize> {
    let stem = words(name).concat();
    let stem = AFTER.iter().find_map(|end| stem.strip_suffix(end)).unwrap_or(&stem);
    HEMISPHERES.iter().find(|(_, names)| names.contains(&stem)).map(|(quantity, _)| *quantity)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_quantity_unit_and_sign() {
        for (name, key, unit, sign) in [
            ("vel_e", "east", "", 1.0),
            ("VE", "east", "", 1.0),
            ("GPS Velocity N (m/sec)", "north", "m/s", 1.0),
            ("/velocities/speed-down-fps", "up", "ft/s", -1.0),
            ("vel_d_ms", "up", "m/s", -1.0),
            ("TimeUS", "time", "us", 1.0),
            ("GndSpd", "speed", "", 1.0),
            ("AltGPS", "height", "", 1.0),
            ("altitude_above_seaLevel(feet)", "height", "ft", 1.0),
            ("Latitude (WGS84 deg)", "latitude", "deg", 1.0),
            (" compass_heading(degrees)", "heading", "deg", 1.0),
            ("PLANE LATITUDE", "latitude", "", 1.0),
            ("vertical_rate", "climb", "", 1.0),
            ("lat_rad", "latitude", "rad", 1.0),
            ("ref_pos_lat (deg)", "latitude", "deg", 1.0),
            ("ref_Yaw (deg)", "heading", "deg", 1.0),
            ("TimeFromStart (s)", "time", "s", 1.0),
            ("PosLat (rad)", "latitude", "rad", 1.0),
            ("AngleRoll (rad)", "roll", "rad", 1.0),
            ("GNSSVelNorth[cm/s]", "north", "cm/s", 1.0),
            ("VelDown_mms", "up", "mm/s", -1.0),
            ("INSAlt_mm", "height", "mm", 1.0),
            ("Alt[ft]", "height", "ft", 1.0),
            ("field.pose.pose.orientation.w", "q0", "", 1.0),
            ("Orientation X", "q1", "", 1.0),
            ("Altitude (ft MSL)", "height", "ft", 1.0),
            ("alt_ft_msl", "height", "ft", 1.0),
            ("GPS Altitude [ft, AMSL]", "height", "ft", 1.0),
            ("Altitude (MSL)", "height", "", 1.0),
            ("Heading (M)", "heading", "", 1.0),
            ("Temp (deg)", "temperature", "", 1.0),
        ] {
            let found = guess(name).unwrap();
            assert_eq!((QUANTITIES[found.quantity].key, found.unit, found.sign), (key, unit, sign), "{name}");
        }
        for name in [
            "",
            "wind",
            "deg",
            "gps",
            "throttle",
            "E1 RPM",
            "wind_speed",
            "true_airspeed",
            "Latitude Error",
            "m/s",
            // A unit that is none of the quantity is that of another one.
            "heading_ft",
            "Roll (deg/s)",
            "Lat (g)",
            "lat sec",
            "LatM",
            "lon_m",
            // No height above the ellipsoid or the sea.
            "Altitude (ft AGL)",
            "Speed (kt IAS)",
        ] {
            assert_eq!(guess(name), None, "{name}");
        }
    }

    #[test]
    fn every_name_has_its_quantity() {
        for (key, names) in NAMES {
            for name in *names {
                let found = guess(name.trim_start_matches('-')).unwrap();
                assert_eq!(QUANTITIES[found.quantity].key, *key, "{name}");
            }
        }
    }
}
