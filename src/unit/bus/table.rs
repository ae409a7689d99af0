//! The labels of an inertial reference unit: each is listed here once.
//!
//! Labels, bits and resolutions are those of a Honeywell HG2001GD as an open decoder reads them (NCAR/nidas, `IRS_HW_HG2001GD.cc`). Set
//! latitude and longitude are as in the installation manual of the CMA-5024 (1.8, 1.9); set heading has the digits of the wind direction,
//! for want of a source. Intervals of 310 to 314, 324, 325 and 361 are within those of the Aspire 400 manual (tables 5-5, 5-6); the others
//! are this library's.

use super::label::Label;
use super::source::{Group, Source};
use super::word::{Digit, Format};

/// Format, resolution and range of a quantity.
type Scale = (Format, f64, (f64, f64));

/// A binary number from `-span` to `span`.
const fn binary(lowest: u32, span: f64) -> Scale {
    (Format::Binary { lowest, wraps: false }, span / (1 << (28 - lowest)) as f64, (-span, span))
}

/// The same without negative values.
const fn positive(lowest: u32, span: f64) -> Scale {
    let (format, resolution, _) = binary(lowest, span);
    (format, resolution, (0.0, span))
}

/// An angle of any direction.
const fn turn(lowest: u32) -> Scale {
    let (_, resolution, range) = binary(lowest, 180.0);
    (Format::Binary { lowest, wraps: true }, resolution, range)
}

/// An angle from the horizontal or from the equator.
const fn elevation(lowest: u32) -> Scale {
    let (format, resolution, _) = binary(lowest, 180.0);
    (format, resolution, (-90.0, 90.0))
}

const fn digit(lowest: u32, bits: u32, weight: i64) -> Digit {
    let most = (1 << bits) - 1;
    Digit { lowest, bits, weight, most: if most < 9 { most } else { 9 } }
}

const fn up_to(most: i64, digit: Digit) -> Digit {
    Digit { most, ..digit }
}

const DEGREES_AND_MINUTES: Format = Format::Decimal(&[
    digit(28, 1, 60_000),
    digit(24, 4, 6000),
    digit(20, 4, 600),
    up_to(5, digit(16, 4, 100)),
    digit(12, 4, 10),
    digit(8, 4, 1),
]);
const WHOLE: Format = Format::Decimal(&[digit(26, 2, 100), digit(22, 4, 10), digit(18, 4, 1)]);
const TENTHS: Format =
    Format::Decimal(&[digit(26, 2, 1000), digit(22, 4, 100), digit(18, 4, 10), digit(14, 4, 1)]);

const LATITUDE: Scale = (DEGREES_AND_MINUTES, 1.0 / 600.0, (-90.0, 90.0));
const LONGITUDE: Scale = (DEGREES_AND_MINUTES, 1.0 / 600.0, (-180.0, 180.0));
const SPEED: Scale = (
    Format::Decimal(&[digit(26, 3, 1000), digit(22, 4, 100), digit(18, 4, 10), digit(14, 4, 1)]),
    1.0,
    (0.0, 7999.0),
);
const WIND: Scale = (WHOLE, 1.0, (0.0, 399.0));
const DIRECTION: Scale = (WHOLE, 1.0, (0.0, 360.0));
const DIRECTION_TENTHS: Scale = (TENTHS, 0.1, (0.0, 360.0));
const MINUTES_HIGH: Scale = (Format::Decimal(&[digit(22, 4, 10), digit(18, 4, 1)]), 0.1, (0.0, 9.9));
const MINUTES_LOW: Scale = (Format::Decimal(&[digit(18, 4, 10), digit(14, 4, 1)]), 0.1, (0.0, 9.9));
const BITS: Scale = (Format::Bits, 1.0, (0.0, 524_287.0));

const RATE: Scale = binary(10, 128.0);
const FORCE: Scale = binary(10, 4.0);

const fn label(
    number: u8,
    (name, unit): (&'static str, &'static str),
    (format, resolution, range): Scale,
    interval_ms: u32,
    group: Group,
    quantity: fn(&Source) -> f64,
) -> Label {
    Label { number, name, unit, resolution, range, format, interval_ms, group, quantity }
}

/// Every label, in the order in which words of one time are sent.
#[rustfmt::skip]
pub const LABELS: [Label; 49] = [
    label(0o310, ("latitude", "deg"), elevation(8), 100, Group::Position, |s| s.shown.place.latitude_rad.to_degrees()),
    label(0o311, ("longitude", "deg"), turn(8), 100, Group::Position, |s| s.shown.place.longitude_rad.to_degrees()),
    label(0o312, ("ground speed", "kt"), positive(10, 4096.0), 40, Group::Velocity, Source::ground_speed_kt),
    label(0o313, ("track angle true", "deg"), turn(10), 40, Group::Velocity, Source::track_deg),
    label(0o314, ("heading true", "deg"), turn(10), 40, Group::Heading, Source::heading_deg),
    label(0o315, ("wind speed", "kt"), positive(10, 256.0), 100, Group::Wind, Source::wind_speed_kt),
    label(0o316, ("wind direction true", "deg"), turn(10), 100, Group::Wind, Source::wind_direction_deg),
    label(0o317, ("track angle magnetic", "deg"), turn(10), 40, Group::MagneticTrack, |s| s.magnetic(s.track_deg())),
    label(0o320, ("heading magnetic", "deg"), turn(10), 40, Group::Magnetic, |s| s.magnetic(s.heading_deg())),
    label(0o321, ("drift angle", "deg"), turn(10), 40, Group::Velocity, |s| s.track_deg() - s.heading_deg()),
    label(0o322, ("flight path angle", "deg"), elevation(10), 40, Group::Velocity, Source::flight_path_deg),
    label(0o323, ("flight path acceleration", "g"), FORCE, 40, Group::Velocity, Source::flight_path_g),
    label(0o324, ("pitch angle", "deg"), elevation(10), 40, Group::Attitude, |s| s.shown.euler.pitch.to_degrees()),
    label(0o325, ("roll angle", "deg"), turn(10), 40, Group::Attitude, |s| s.shown.euler.roll.to_degrees()),
    label(0o326, ("body pitch rate", "deg/s"), RATE, 40, Group::Rates, |s| s.rate.y.to_degrees()),
    label(0o327, ("body roll rate", "deg/s"), RATE, 40, Group::Rates, |s| s.rate.x.to_degrees()),
    label(0o330, ("body yaw rate", "deg/s"), RATE, 40, Group::Rates, |s| s.rate.z.to_degrees()),
    label(0o331, ("body longitudinal acceleration", "g"), FORCE, 40, Group::Rates, |s| s.force_g.x),
    label(0o332, ("body lateral acceleration", "g"), FORCE, 40, Group::Rates, |s| s.force_g.y),
    label(0o333, ("body normal acceleration", "g"), FORCE, 40, Group::Rates, |s| -s.force_g.z),
    label(0o335, ("track angle rate", "deg/s"), binary(10, 32.0), 40, Group::Velocity, Source::track_rate_deg_s),
    label(0o336, ("pitch attitude rate", "deg/s"), RATE, 40, Group::Attitude, Source::pitch_rate_deg_s),
    label(0o337, ("roll attitude rate", "deg/s"), RATE, 40, Group::Attitude, Source::roll_rate_deg_s),
    label(0o360, ("potential vertical speed", "ft/min"), binary(10, 32_768.0), 40, Group::Velocity, Source::potential_ft_min),
    label(0o361, ("inertial altitude", "ft"), binary(8, 131_072.0), 50, Group::Velocity, Source::altitude_ft),
    label(0o362, ("along track acceleration", "g"), FORCE, 40, Group::Velocity, |s| s.along_g(s.track_deg())),
    label(0o363, ("across track acceleration", "g"), FORCE, 40, Group::Velocity, |s| s.along_g(s.track_deg() + 90.0)),
    label(0o364, ("vertical acceleration", "g"), FORCE, 40, Group::Attitude, |s| s.acceleration_g.z),
    label(0o365, ("inertial vertical speed", "ft/min"), binary(10, 32_768.0), 40, Group::Velocity, Source::vertical_ft_min),
    label(0o366, ("velocity north", "kt"), binary(10, 4096.0), 100, Group::Velocity, |s| Source::knots(s.shown.v_n.y)),
    label(0o367, ("velocity east", "kt"), binary(10, 4096.0), 100, Group::Velocity, |s| Source::knots(s.shown.v_n.x)),
    label(0o370, ("normal acceleration, wide range", "g"), binary(10, 8.0), 40, Group::Rates, |s| -s.force_g.z),
    label(0o375, ("along heading acceleration", "g"), FORCE, 40, Group::Heading, |s| s.along_g(s.heading_deg())),
    label(0o376, ("across heading acceleration", "g"), FORCE, 40, Group::Heading, |s| s.along_g(s.heading_deg() + 90.0)),
    label(0o010, ("latitude", "deg"), LATITUDE, 500, Group::Position, |s| s.shown.place.latitude_rad.to_degrees()),
    label(0o011, ("longitude", "deg"), LONGITUDE, 500, Group::Position, |s| s.shown.place.longitude_rad.to_degrees()),
    label(0o012, ("ground speed", "kt"), SPEED, 500, Group::Velocity, Source::ground_speed_kt),
    label(0o013, ("track angle true", "deg"), DIRECTION_TENTHS, 500, Group::Velocity, |s| Source::whole_turn(s.track_deg())),
    label(0o014, ("heading magnetic", "deg"), DIRECTION_TENTHS, 500, Group::Magnetic, |s| Source::whole_turn(s.magnetic(s.heading_deg()))),
    label(0o044, ("heading true", "deg"), DIRECTION_TENTHS, 500, Group::Heading, |s| Source::whole_turn(s.heading_deg())),
    label(0o015, ("wind speed", "kt"), WIND, 500, Group::Wind, Source::wind_speed_kt),
    label(0o016, ("wind direction true", "deg"), DIRECTION, 500, Group::Wind, |s| Source::whole_turn(s.wind_direction_deg())),
    label(0o007, ("time to navigation", "min"), MINUTES_HIGH, 500, Group::Always, |s| s.status.to_go_s / 60.0),
    label(0o351, ("time to navigation", "min"), MINUTES_LOW, 500, Group::Always, |s| s.status.to_go_s / 60.0),
    label(0o126, ("time in navigation", "min"), positive(13, 32_768.0), 500, Group::Always, |s| s.status.in_navigation_s / 60.0),
    label(0o270, ("discretes", ""), BITS, 500, Group::Always, Source::discretes),
    label(0o041, ("set latitude", "deg"), LATITUDE, 0, Group::Always, |_| 0.0),
    label(0o042, ("set longitude", "deg"), LONGITUDE, 0, Group::Always, |_| 0.0),
    label(0o043, ("set heading", "deg"), DIRECTION, 0, Group::Always, |_| 0.0),
];
