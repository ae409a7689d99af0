//! The table of the times and limits of a unit: each is listed here once, with its default and where this comes from.
//!
//! `build.rs` makes from the table `UnitParameters` and `sins_unit_params`; the keys of a scene's section `[unit]` read it.

use crate::base::parameter::Range::{OffOr, OrDefault};
use crate::base::parameter::Shape::Number;
use crate::base::parameter::{Range, Row, own_field, row};
use crate::base::units::DEG;

const KNOT: f64 = 1852.0 / 3600.0;

const fn number(
    (place, doc): (&'static str, &'static str),
    (path, unit): (&'static str, &'static str),
    range: Range,
    key: (&'static str, &'static str, f64),
    note: &'static str,
) -> Row {
    row(place, Number, false, doc, own_field((path, unit), range, key, ""), note)
}

const fn time(
    (place, doc): (&'static str, &'static str),
    path: &'static str,
    default_s: f64,
    note: &'static str,
) -> Row {
    number((place, doc), (path, "s"), OrDefault(default_s, 1e-3, 1e6), (place, "s", 1.0), note)
}

/// Times and limits of a unit, in the order of the struct of the interface.
#[rustfmt::skip]
pub const UNIT: [Row; 24] = [
    time(("power_up_test_s", "length of the test after power-up"), "unit.power_up_test_s", 5.0, "The default is this library's."),
    time(("coarse_alignment_s", "length of the coarse alignment, after which the attitude is valid"), "unit.coarse_alignment_s", 30.0,
        "The default is that of the open A320 simulator flybywiresim/aircraft."),
    time(("alignment_s", "length of the whole alignment"), "unit.alignment_s", 0.0,
        "The default is (5 + 0.002 L^2) min at the latitude L in degrees: 5 min at the equator and 17 min at 78 degrees, as in the \
            crew manual of the 737 MAX (11.20.5); the formula is that of legoboyvdlp/A320-family."),
    time(("stored_heading_alignment_s", "length of an alignment with the stored heading"), "unit.stored_heading_alignment_s", 90.0,
        "Manuals state 1 to 2 min."),
    time(("realignment_s", "length of a fast realignment"), "unit.realignment_s", 30.0, "The default is that of flybywiresim/aircraft."),
    time(("fast_alignment_s", "length of an alignment of kind SINS_UNIT_ALIGNMENT_FAST"), "unit.fast_alignment_s", 30.0,
        "The default is this library's."),
    time(("power_down_s", "time after OFF in which the unit stores position and heading"), "unit.power_down_s", 5.0,
        "The default is that of flybywiresim/aircraft."),
    number(("quick_off_s", "longest time at OFF after which a unit that navigated realigns instead of a whole alignment"),
        ("unit.quick_off_s", "s"), OffOr(1e-3, 1e6), ("quick_off_s", "s", 1.0),
        "It is for selectors without ALIGN. It acts only within power_down_s."),
    number(("max_latitude_rad", "largest latitude at which the unit aligns at rest"), ("unit.max_latitude_rad", "rad"),
        OrDefault(82.0 * DEG, 0.01, 1.56), ("max_latitude_deg", "deg", DEG), "The default is 82 degrees, that of flybywiresim/aircraft."),
    number(("position_tolerance_rad", "largest difference of latitude, and of longitude, between the entered and the stored position"),
        ("unit.position_tolerance_rad", "rad"), OrDefault(DEG, 1e-9, 4.0), ("position_tolerance_deg", "deg", DEG),
        "A position further away is accepted when it is entered a second time. The default is 1 degree, and this library's."),
    number(("latitude_tolerance_rad", "largest difference between the entered latitude and that of the gyros"),
        ("unit.latitude_tolerance_rad", "rad"), OrDefault(0.0, 1e-9, 4.0), ("latitude_tolerance_deg", "deg", DEG),
        "The default follows from the errors of the gyros that are set, see sins_unit_update()."),
    number(("motion_threshold_m_s", "velocity of the unit beyond which an alignment stops"), ("unit.motion_threshold_m_s", "m/s"),
        OrDefault(0.15, 1e-6, 1e3), ("motion_threshold_m_s", "m/s", 1.0),
        "The default is this library's: a sway of 1 cm at 0.3 Hz has 0.02 m/s, taxiing at 1 kt 0.5 m/s."),
    number(("motion_distance_m", "distance from its place beyond which an alignment stops"), ("unit.motion_distance_m", "m"),
        OrDefault(0.2, 1e-6, 1e6), ("motion_distance_m", "m", 1.0),
        "A position that was entered is dropped there, too, at the latest at 10 m. The default is this library's: a sway of 1 cm does not \
            matter, a slow start stops the alignment."),
    time(("motion_filter_s", "time constant of the filter of this velocity"), "unit.motion_filter_s", 0.5,
        "The default is that of flybywiresim/aircraft."),
    time(("motion_inhibition_s", "time from the start of an alignment in which motion is not tested"), "unit.motion_inhibition_s", 2.0,
        "The default is that of flybywiresim/aircraft."),
    time(("still_s", "time at rest after which an alignment that was stopped starts again"), "unit.still_s", 5.0,
        "The default is this library's."),
    number(("realignment_speed_m_s", "ground speed of the navigation from which ALIGN ends it instead of realigning"),
        ("unit.realignment_speed_m_s", "m/s"), OrDefault(20.0 * KNOT, 1e-3, 1e4), ("realignment_speed_kt", "kt", KNOT),
        "The default is 20 kt, that of flybywiresim/aircraft."),
    time(("erection_s", "time of straight and level flight in which ATT levels the attitude"), "unit.erection_s", 30.0,
        "Manuals state 20 to 30 s."),
    time(("erection_time_s", "time constant with which the attitude of ATT follows the apparent vertical"), "unit.erection_time_s", 120.0,
        "The default is this library's."),
    time(("fault_s", "time without a signal of a gyro or accelerometer after which the unit fails"), "unit.fault_s", 1.0,
        "It is the sum since the alignment, or the erection of ATT, began. The default is this library's."),
    number(("battery_s", "time that the battery lasts"), ("unit.battery_s", "s"), OffOr(1e-3, 1e6), ("battery_s", "s", 1.0),
        "If 0, it lasts for ever."),
    time(("in_flight_alignment_s", "least length of an alignment of kind SINS_UNIT_ALIGNMENT_IN_FLIGHT"), "unit.in_flight_alignment_s", 180.0,
        "Military manuals state some minutes with turns; the default is this library's."),
    number(("in_flight_heading_rad", "standard deviation of the heading at which an alignment in flight may end"),
        ("unit.in_flight_heading_rad", "rad"), OrDefault(0.1 * DEG, 1e-9, 1.0), ("in_flight_heading_deg", "deg", DEG),
        "The default is 0.1 degree, and this library's."),
    number(("heading_limit_rad", "standard deviation of the heading above which a gyrocompass does not end"),
        ("unit.heading_limit_rad", "rad"), OrDefault(DEG, 1e-9, 4.0), ("heading_limit_deg", "deg", DEG),
        "Until then the heading is not valid. When the time of the alignment is over, the status has SINS_UNIT_REASON_NORTH_UNKNOWN. \
            The default is 1 degree, and this library's: gyros of navigation grade reach it at all latitudes up to 82 degrees, those \
            of tactical grade at none. 4 accepts each heading."),
];
