//! The table of the start of a flight: each parameter is listed here once.
//!
//! `build.rs` makes from it the struct of the interface with the header, that of the crate, and the numbers of both. Checks, keys of
//! scene files and rows of an error budget read it.

use crate::base::parameter::Range::Within;
use crate::base::parameter::Shape::Number;
use crate::base::parameter::{GIVEN, Row, choice, own_field as field, row};
use crate::base::units::DEG;

const PI: f64 = core::f64::consts::PI;

/// Start of a flight, in the order of the struct of the interface.
#[rustfmt::skip]
pub const START: [Row; 8] = [
    row("latitude_rad", Number, GIVEN, "geodetic latitude of the start",
        field(("start.latitude_rad", "rad"), Within(-0.5 * PI, 0.5 * PI), ("latitude_deg", "deg", DEG), ""), ""),
    row("longitude_rad", Number, GIVEN, "longitude of the start, east positive",
        field(("start.longitude_rad", "rad"), Within(-100.0, 100.0), ("longitude_deg", "deg", DEG), ""), ""),
    row("height_m", Number, GIVEN, "height of the start above the ellipsoid",
        field(("start.height_m", "m"), Within(-20e3, 2000e3), ("height_m", "m", 1.0), ""), ""),
    row("speed_m_s", Number, GIVEN, "speed at the start against the Earth",
        field(("start.speed_m_s", "m/s"), Within(0.0, 10e3), ("speed_m_s", "m/s", 1.0), ""), ""),
    row("heading_rad", Number, GIVEN, "course and heading at the start",
        field(("start.heading_rad", "rad"), Within(-100.0, 100.0), ("heading_deg", "deg", DEG), ""), ""),
    row("roll_rad", Number, GIVEN, "roll of the body relative to the axes of the path, throughout the flight",
        field(("start.roll_rad", "rad"), Within(-PI, PI), ("roll_deg", "deg", DEG), ""), ""),
    row("pitch_rad", Number, GIVEN, "pitch of the body relative to the axes of the path, throughout the flight",
        field(("start.pitch_rad", "rad"), Within(-0.5 * PI, 0.5 * PI), ("pitch_deg", "deg", DEG), ""),
        "It is the angle of attack, or the tilt at rest."),
    choice("ellipsoid", ("Ellipsoid", "sins_earth"), ("start.earth", "ellipsoid"),
        "It is that of the options of the simulator that will fly it."),
];
