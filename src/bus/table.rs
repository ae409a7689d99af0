//! The labels of an inertial reference unit: each is listed here once.
//!
//! Labels, bits and resolutions are those of a Honeywell HG2001GD as an open decoder reads them (NCAR/nidas, `IRS_HW_HG2001GD.cc`). Set
//! latitude and longitude are as in the installation manual of the CMA-5024 (1.8, 1.9); set heading has the digits of the wind direction,
//! for want of a source. Intervals of 310 to 314, 324, 325 and 361 are within those of the Aspire 400 manual (tables 5-5, 5-6); the others
//! are this library's.

use super::source::{Group, Source};
use super::word::Format;

/// A label.
#[derive(Debug, Clone, Copy)]
pub struct Label {
    /// Its number, written in octal.
    pub number: u8,
    /// What it is.
    pub name: &'static str,
    /// Unit of the value; empty: a pure number, or bits.
    pub unit: &'static str,
    /// Value of the lowest bit or digit.
    pub resolution: f64,
    /// How the number stands in the word.
    pub format: Format,
    /// Time from one word to the next [ms]; 0: an input, which the unit does not send.
    pub interval_ms: u32,
    /// What makes it valid.
    pub(super) group: Group,
    /// The value, in the unit.
    pub(super) of: fn(&Source) -> f64,
}

const fn signed(lowest: u32, bits: u32) -> Format {
    Format::Binary { lowest, bits, is_signed: true, wraps: false }
}

const fn angle(lowest: u32, bits: u32) -> Format {
    Format::Binary { lowest, bits, is_signed: true, wraps: true }
}

const fn unsigned(lowest: u32, bits: u32) -> Format {
    Format::Binary { lowest, bits, is_signed: false, wraps: false }
}

const DEGREES_AND_MINUTES: Format =
    Format::Decimal(&[(28, 1, 60_000), (24, 4, 6000), (20, 4, 600), (16, 4, 100), (12, 4, 10), (8, 4, 1)]);
const SPEED: Format = Format::Decimal(&[(26, 3, 1000), (22, 4, 100), (18, 4, 10), (14, 4, 1)]);
const TENTHS: Format = Format::Decimal(&[(26, 2, 1000), (22, 4, 100), (18, 4, 10), (14, 4, 1)]);
const WHOLE: Format = Format::Decimal(&[(26, 2, 100), (22, 4, 10), (18, 4, 1)]);

const PLACE: f64 = 180.0 / (1 << 20) as f64;
const ANGLE: f64 = 180.0 / (1 << 18) as f64;
const RATE: f64 = 1.0 / 2048.0;
const FORCE: f64 = 1.0 / 65_536.0;

const fn label(
    number: u8,
    (name, unit): (&'static str, &'static str),
    (format, resolution): (Format, f64),
    interval_ms: u32,
    group: Group,
    of: fn(&Source) -> f64,
) -> Label {
    Label { number, name, unit, resolution, format, interval_ms, group, of }
}

/// Every label, in the order in which words of one time are sent.
#[rustfmt::skip]
pub const LABELS: [Label; 49] = [
    label(0o310, ("latitude", "deg"), (angle(8, 21), PLACE), 100, Group::Position, |s| s.shown.place.latitude_rad.to_degrees()),
    label(0o311, ("longitude", "deg"), (angle(8, 21), PLACE), 100, Group::Position, |s| s.shown.place.longitude_rad.to_degrees()),
    label(0o312, ("ground speed", "kt"), (unsigned(10, 18), 1.0 / 64.0), 40, Group::Velocity, Source::ground_speed_kt),
    label(0o313, ("track angle true", "deg"), (angle(10, 19), ANGLE), 40, Group::Velocity, Source::track_deg),
    label(0o314, ("heading true", "deg"), (angle(10, 19), ANGLE), 40, Group::Heading, Source::heading_deg),
    label(0o315, ("wind speed", "kt"), (signed(10, 19), 1.0 / 1024.0), 100, Group::Wind, Source::wind_speed_kt),
    label(0o316, ("wind direction true", "deg"), (angle(10, 19), ANGLE), 100, Group::Wind, Source::wind_direction_deg),
    label(0o317, ("track angle magnetic", "deg"), (angle(10, 19), ANGLE), 40, Group::MagneticTrack, |s| s.magnetic(s.track_deg())),
    label(0o320, ("heading magnetic", "deg"), (angle(10, 19), ANGLE), 40, Group::Magnetic, |s| s.magnetic(s.heading_deg())),
    label(0o321, ("drift angle", "deg"), (angle(10, 19), ANGLE), 40, Group::Velocity, |s| s.track_deg() - s.heading_deg()),
    label(0o322, ("flight path angle", "deg"), (angle(10, 19), ANGLE), 40, Group::Velocity, Source::flight_path_deg),
    label(0o323, ("flight path acceleration", "g"), (signed(10, 19), FORCE), 40, Group::Velocity, Source::flight_path_g),
    label(0o324, ("pitch angle", "deg"), (angle(10, 19), ANGLE), 40, Group::Attitude, |s| s.shown.euler.pitch.to_degrees()),
    label(0o325, ("roll angle", "deg"), (angle(10, 19), ANGLE), 40, Group::Attitude, |s| s.shown.euler.roll.to_degrees()),
    label(0o326, ("body pitch rate", "deg/s"), (signed(10, 19), RATE), 40, Group::Rates, |s| s.rate.y.to_degrees()),
    label(0o327, ("body roll rate", "deg/s"), (signed(10, 19), RATE), 40, Group::Rates, |s| s.rate.x.to_degrees()),
    label(0o330, ("body yaw rate", "deg/s"), (signed(10, 19), RATE), 40, Group::Rates, |s| s.rate.z.to_degrees()),
    label(0o331, ("body longitudinal acceleration", "g"), (signed(10, 19), FORCE), 40, Group::Rates, |s| s.force_g.x),
    label(0o332, ("body lateral acceleration", "g"), (signed(10, 19), FORCE), 40, Group::Rates, |s| s.force_g.y),
    label(0o333, ("body normal acceleration", "g"), (signed(10, 19), FORCE), 40, Group::Rates, |s| -s.force_g.z),
    label(0o335, ("track angle rate", "deg/s"), (signed(10, 19), 1.0 / 8192.0), 40, Group::Velocity, Source::track_rate_deg_s),
    label(0o336, ("pitch attitude rate", "deg/s"), (signed(10, 19), RATE), 40, Group::Attitude, Source::pitch_rate_deg_s),
    label(0o337, ("roll attitude rate", "deg/s"), (signed(10, 19), RATE), 40, Group::Attitude, Source::roll_rate_deg_s),
    label(0o360, ("potential vertical speed", "ft/min"), (signed(10, 19), 0.125), 40, Group::Velocity, Source::potential_ft_min),
    label(0o361, ("inertial altitude", "ft"), (signed(8, 21), 0.125), 50, Group::Velocity, Source::altitude_ft),
    label(0o362, ("along track acceleration", "g"), (signed(10, 19), FORCE), 40, Group::Velocity, |s| s.along_g(s.track_deg())),
    label(0o363, ("across track acceleration", "g"), (signed(10, 19), FORCE), 40, Group::Velocity, |s| s.along_g(s.track_deg() + 90.0)),
    label(0o364, ("vertical acceleration", "g"), (signed(10, 19), FORCE), 40, Group::Attitude, |s| s.acceleration_g.z),
    label(0o365, ("inertial vertical speed", "ft/min"), (signed(10, 19), 0.125), 40, Group::Velocity, Source::vertical_ft_min),
    label(0o366, ("velocity north", "kt"), (signed(10, 19), 1.0 / 64.0), 100, Group::Velocity, |s| Source::knots(s.shown.v_n.y)),
    label(0o367, ("velocity east", "kt"), (signed(10, 19), 1.0 / 64.0), 100, Group::Velocity, |s| Source::knots(s.shown.v_n.x)),
    label(0o370, ("normal acceleration, wide range", "g"), (signed(10, 19), 1.0 / 32_768.0), 40, Group::Rates, |s| -s.force_g.z),
    label(0o375, ("along heading acceleration", "g"), (signed(10, 19), FORCE), 40, Group::Heading, |s| s.along_g(s.heading_deg())),
    label(0o376, ("across heading acceleration", "g"), (signed(10, 19), FORCE), 40, Group::Heading, |s| s.along_g(s.heading_deg() + 90.0)),
    label(0o010, ("latitude", "deg"), (DEGREES_AND_MINUTES, 1.0 / 600.0), 500, Group::Position, |s| s.shown.place.latitude_rad.to_degrees()),
    label(0o011, ("longitude", "deg"), (DEGREES_AND_MINUTES, 1.0 / 600.0), 500, Group::Position, |s| s.shown.place.longitude_rad.to_degrees()),
    label(0o012, ("ground speed", "kt"), (SPEED, 1.0), 500, Group::Velocity, Source::ground_speed_kt),
    label(0o013, ("track angle true", "deg"), (TENTHS, 0.1), 500, Group::Velocity, |s| Source::whole_turn(s.track_deg())),
    label(0o014, ("heading magnetic", "deg"), (TENTHS, 0.1), 500, Group::Magnetic, |s| Source::whole_turn(s.magnetic(s.heading_deg()))),
    label(0o044, ("heading true", "deg"), (TENTHS, 0.1), 500, Group::Heading, |s| Source::whole_turn(s.heading_deg())),
    label(0o015, ("wind speed", "kt"), (WHOLE, 1.0), 500, Group::Wind, Source::wind_speed_kt),
    label(0o016, ("wind direction true", "deg"), (WHOLE, 1.0), 500, Group::Wind, |s| Source::whole_turn(s.wind_direction_deg())),
    label(0o007, ("time to navigation", "min"), (Format::Decimal(&[(22, 4, 10), (18, 4, 1)]), 0.1), 500, Group::Always, |s| s.status.to_go_s / 60.0),
    label(0o351, ("time to navigation", "min"), (Format::Decimal(&[(18, 4, 10), (14, 4, 1)]), 0.1), 500, Group::Always, |s| s.status.to_go_s / 60.0),
    label(0o126, ("time in navigation", "min"), (unsigned(13, 15), 1.0), 500, Group::Always, |s| s.status.in_navigation_s / 60.0),
    label(0o270, ("discretes", ""), (Format::Bits, 1.0), 500, Group::Always, Source::discretes),
    label(0o041, ("set latitude", "deg"), (DEGREES_AND_MINUTES, 1.0 / 600.0), 0, Group::Always, |_| 0.0),
    label(0o042, ("set longitude", "deg"), (DEGREES_AND_MINUTES, 1.0 / 600.0), 0, Group::Always, |_| 0.0),
    label(0o043, ("set heading", "deg"), (WHOLE, 1.0), 0, Group::Always, |_| 0.0),
];
