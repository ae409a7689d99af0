//! `sins_unit_status`, `sins_unit_navigation`: what a unit reports and shows.

use super::choice::{Choice, check_reserved, choices, flag};
use super::failure::{CallError, sins_status};
use super::memory::{Output, interface_struct};
use super::simulator::{look_at, sins_sim};
use super::unit::{sins_unit, with_unit};
use crate::base::error::{Error, Rule, check_range, check_ranges};
use crate::base::math::Euler;
use crate::base::snapshot::CLOCK_S;
use crate::earth::Geodetic;
use crate::unit::{Mode, Reasons, State, Status, UnitNavigation, Validity};

include!(concat!(env!("OUT_DIR"), "/sins_unit_state.rs"));

/// Flags of a sins_unit_status: annunciators, and what else is on.
pub type sins_unit_annunciators = u32;

/// ALIGN is lit.
pub const SINS_UNIT_ALIGN_LIT: sins_unit_annunciators = 1;
/// ALIGN flashes: something must be done, see the reasons.
pub const SINS_UNIT_ALIGN_FLASHES: sins_unit_annunciators = 2;
/// NAV RDY.
pub const SINS_UNIT_NAV_READY: sins_unit_annunciators = 4;
/// FAULT.
pub const SINS_UNIT_FAULT: sins_unit_annunciators = 8;
/// ON BATT.
pub const SINS_UNIT_ON_BATTERY: sins_unit_annunciators = 16;
/// The test after power-up, or that of the panel, is on.
pub const SINS_UNIT_IN_TEST: sins_unit_annunciators = 32;
/// The field found_latitude_rad of the status holds a value.
pub const SINS_UNIT_HAS_FOUND_LATITUDE: sins_unit_annunciators = 64;
/// The fields stored_... of the status hold values.
pub const SINS_UNIT_HAS_STORED: sins_unit_annunciators = 128;

/// Reasons why a unit is not ready, or has failed.
pub type sins_unit_reasons = u32;

/// No position was entered, or the aircraft has left the place where it was; in flight: no fix came for a minute.
pub const SINS_UNIT_REASON_NO_POSITION: sins_unit_reasons = 1;
/// The entered position is too far from the stored one. Enter it again, or another one.
pub const SINS_UNIT_REASON_POSITION_DISAGREES: sins_unit_reasons = 2;
/// The gyros find another latitude than the entered one. Enter the position again.
pub const SINS_UNIT_REASON_LATITUDE_DISAGREES: sins_unit_reasons = 4;
/// The unit moves. The alignment starts anew at rest.
pub const SINS_UNIT_REASON_MOTION: sins_unit_reasons = 8;
/// The latitude is beyond max_latitude_rad.
pub const SINS_UNIT_REASON_LATITUDE_TOO_HIGH: sins_unit_reasons = 16;
/// A gyro or an accelerometer had no signal for fault_s.
pub const SINS_UNIT_REASON_NO_SIGNAL: sins_unit_reasons = 32;
/// The battery is empty.
pub const SINS_UNIT_REASON_BATTERY_EMPTY: sins_unit_reasons = 64;
/// In flight: in_flight_alignment_s is over, and the heading is not accurate enough yet. Turns or changes of speed show it.
pub const SINS_UNIT_REASON_TURNS_NEEDED: sins_unit_reasons = 128;
/// The time of a gyrocompass is over, and the standard deviation of its heading is above heading_limit_rad: the sensors are too poor
/// to find north here. The alignment goes on. In SINS_UNIT_STATE_NAVIGATION: the simulator has started with
/// SINS_NAVIGATION_NORTH_UNKNOWN, and no unit has aligned it. Only rates, forces, roll and pitch are valid.
pub const SINS_UNIT_REASON_NORTH_UNKNOWN: sins_unit_reasons = 256;

/// Outputs of a unit that are valid.
pub type sins_unit_validity = u32;

/// Angular rates and specific forces.
pub const SINS_UNIT_VALID_RATES: sins_unit_validity = 1;
/// Roll and pitch.
pub const SINS_UNIT_VALID_ATTITUDE: sins_unit_validity = 2;
/// Heading.
pub const SINS_UNIT_VALID_HEADING: sins_unit_validity = 4;
/// Latitude and longitude.
pub const SINS_UNIT_VALID_POSITION: sins_unit_validity = 8;
/// Velocity and height.
pub const SINS_UNIT_VALID_VELOCITY: sins_unit_validity = 16;

/// What a unit reports of itself.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_unit_status {
    /// sizeof(sins_unit_status)
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// What it is doing, of enum sins_unit_state.
    pub state: i32,
    /// Position of the mode selector, of enum sins_unit_mode.
    pub mode: i32,
    /// Annunciators of enum sins_unit_annunciators, or'ed.
    pub annunciators: u32,
    /// Reasons of enum sins_unit_reasons, or'ed.
    pub reasons: u32,
    /// Valid outputs of enum sins_unit_validity, or'ed.
    pub validity: u32,
    /// Whole minutes to the end of the alignment, rounded up; 0: none is in progress.
    pub minutes_to_go: i32,
    /// Time to the end of the alignment, the realignment or the erection [s]; 0: none is in progress, or it waits, see the reasons.
    pub to_go_s: f64,
    /// Time in navigation since the last alignment [s].
    pub in_navigation_s: f64,
    /// With SINS_UNIT_HAS_FOUND_LATITUDE: magnitude of the latitude that the gyros found in the last alignment [rad].
    pub found_latitude_rad: f64,
    /// With SINS_UNIT_HAS_STORED: stored latitude [rad].
    pub stored_latitude_rad: f64,
    /// With SINS_UNIT_HAS_STORED: stored longitude [rad].
    pub stored_longitude_rad: f64,
    /// With SINS_UNIT_HAS_STORED: stored true heading [rad].
    pub stored_heading_rad: f64,
}

interface_struct!(sins_unit_status, "status", 80);

/// What a unit shows. An output that is not valid is 0; none is ever NaN.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_unit_navigation {
    /// sizeof(sins_unit_navigation)
    pub struct_size: u32,
    /// Valid outputs of enum sins_unit_validity, or'ed.
    pub validity: u32,
    /// Time of the last update [s].
    pub time_s: f64,
    /// Geodetic latitude, -pi/2 to pi/2 [rad].
    pub latitude_rad: f64,
    /// Longitude, east positive, -pi to pi [rad].
    pub longitude_rad: f64,
    /// Height above the ellipsoid [m].
    pub height_m: f64,
    /// Velocity against the Earth, east-north-up [m/s].
    pub velocity_enu_m_s: [f64; 3],
    /// Roll, right wing down positive, -pi to pi [rad].
    pub roll_rad: f64,
    /// Pitch, nose up positive, -pi/2 to pi/2 [rad].
    pub pitch_rad: f64,
    /// Heading, clockwise from true north, 0 to 2 pi [rad]. In ATT from the north of the heading that was entered.
    pub heading_rad: f64,
    /// Measured angular rate against inertial space, body axes [rad/s]: the mean over the last interval.
    pub angular_rate_rad_s: [f64; 3],
    /// Measured specific force, body axes [m/s2]: the mean over the last interval.
    pub specific_force_m_s2: [f64; 3],
}

interface_struct!(sins_unit_navigation, "navigation", 136);

impl From<&Status> for sins_unit_status {
    fn from(status: &Status) -> Self {
        let stored = status.stored.unwrap_or_default();
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            state: status.state.code(),
            mode: status.selector.code(),
            annunciators: flag(status.align, SINS_UNIT_ALIGN_LIT)
                | flag(status.align_flashes, SINS_UNIT_ALIGN_FLASHES)
                | flag(status.navigation_ready, SINS_UNIT_NAV_READY)
                | flag(status.fault, SINS_UNIT_FAULT)
                | flag(status.on_battery, SINS_UNIT_ON_BATTERY)
                | flag(status.in_test, SINS_UNIT_IN_TEST)
                | flag(status.found_latitude_rad.is_some(), SINS_UNIT_HAS_FOUND_LATITUDE)
                | flag(status.stored.is_some(), SINS_UNIT_HAS_STORED),
            reasons: status.reasons.bits(),
            validity: status.validity.bits(),
            minutes_to_go: (status.to_go_s / 60.0).ceil() as i32,
            to_go_s: status.to_go_s,
            in_navigation_s: status.in_navigation_s,
            found_latitude_rad: status.found_latitude_rad.unwrap_or(0.0),
            stored_latitude_rad: stored.latitude_rad,
            stored_longitude_rad: stored.longitude_rad,
            stored_heading_rad: stored.heading_rad,
        }
    }
}

impl From<&UnitNavigation> for sins_unit_navigation {
    fn from(shown: &UnitNavigation) -> Self {
        Self {
            struct_size: size_of::<Self>() as u32,
            validity: shown.validity.bits(),
            time_s: shown.time_s,
            latitude_rad: shown.place.latitude_rad,
            longitude_rad: shown.place.longitude_rad,
            height_m: shown.place.height_m,
            velocity_enu_m_s: shown.v_n.into(),
            roll_rad: shown.euler.roll,
            pitch_rad: shown.euler.pitch,
            heading_rad: shown.euler.heading,
            angular_rate_rad_s: shown.rate_b.into(),
            specific_force_m_s2: shown.force_b.into(),
        }
    }
}

impl sins_unit_status {
    /// The status, as far as words on a bus show it.
    pub(super) fn to_status(self) -> Result<Status, CallError> {
        check_reserved("status.reserved", self.reserved)?;
        check_flags("status.annunciators", self.annunciators, 2 * SINS_UNIT_HAS_STORED - 1)?;
        check_flags("status.reasons", self.reasons, 2 * SINS_UNIT_REASON_NORTH_UNKNOWN - 1)?;
        check_flags("status.validity", self.validity, 2 * SINS_UNIT_VALID_VELOCITY - 1)?;
        check_range("status.minutes_to_go", self.minutes_to_go.into(), 0.0, 1e6)?;
        check_range("status.to_go_s", self.to_go_s, 0.0, 1e7)?;
        check_range("status.in_navigation_s", self.in_navigation_s, 0.0, CLOCK_S)?;
        for (field, angle) in [
            ("status.found_latitude_rad", self.found_latitude_rad),
            ("status.stored_latitude_rad", self.stored_latitude_rad),
            ("status.stored_longitude_rad", self.stored_longitude_rad),
            ("status.stored_heading_rad", self.stored_heading_rad),
        ] {
            check_range(field, angle, -10.0, 10.0)?;
        }
        let lit = |bit| self.annunciators & bit != 0;
        Ok(Status {
            state: State::of("status.state", self.state)?,
            selector: Mode::of("status.mode", self.mode)?,
            fault: lit(SINS_UNIT_FAULT),
            on_battery: lit(SINS_UNIT_ON_BATTERY),
            in_test: lit(SINS_UNIT_IN_TEST),
            reasons: Reasons::of_bits(self.reasons),
            validity: Validity::of_bits(self.validity),
            to_go_s: self.to_go_s,
            in_navigation_s: self.in_navigation_s,
            ..Status::default()
        })
    }
}

/// Rejects flags that this release does not know.
fn check_flags(field: &'static str, flags: u32, most: u32) -> Result<(), CallError> {
    if flags > most {
        return Err(Error::invalid(field, flags, Rule::BetweenIntegers(0, most.into())).into());
    }
    Ok(())
}

impl sins_unit_navigation {
    pub(super) fn to_shown(self) -> Result<UnitNavigation, CallError> {
        check_flags("navigation.validity", self.validity, 2 * SINS_UNIT_VALID_VELOCITY - 1)?;
        for (field, number, size) in [
            ("navigation.time_s", self.time_s, CLOCK_S),
            ("navigation.latitude_rad", self.latitude_rad, 10.0),
            ("navigation.longitude_rad", self.longitude_rad, 10.0),
            ("navigation.height_m", self.height_m, 1e9),
            ("navigation.roll_rad", self.roll_rad, 10.0),
            ("navigation.pitch_rad", self.pitch_rad, 10.0),
            ("navigation.heading_rad", self.heading_rad, 10.0),
        ] {
            check_range(field, number, -size, size)?;
        }
        check_ranges("navigation.velocity_enu_m_s", &self.velocity_enu_m_s, -1e6, 1e6)?;
        check_ranges("navigation.angular_rate_rad_s", &self.angular_rate_rad_s, -1e7, 1e7)?;
        check_ranges("navigation.specific_force_m_s2", &self.specific_force_m_s2, -1e9, 1e9)?;
        let Self { latitude_rad, longitude_rad, height_m, roll_rad, pitch_rad, heading_rad, .. } = self;
        Ok(UnitNavigation {
            time_s: self.time_s,
            validity: Validity::of_bits(self.validity),
            place: Geodetic { latitude_rad, longitude_rad, height_m },
            v_n: self.velocity_enu_m_s.into(),
            euler: Euler { roll: roll_rad, pitch: pitch_rad, heading: heading_rad },
            rate_b: self.angular_rate_rad_s.into(),
            force_b: self.specific_force_m_s2.into(),
        })
    }
}

/// Reads what the unit reports. No allocation, no system call.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_get_status(
    unit: *mut sins_unit,
    status: *mut sins_unit_status,
) -> sins_status {
    with_unit(unit, |unit| {
        // SAFETY: the host's promise.
        Ok(unsafe { Output::new(status, "status")? }.write(&(&unit.status()).into()))
    })
}

/// Reads what the unit shows. sim is the simulator of the last sins_unit_update(). In navigation and realignment, and while the
/// unit is ready, its valid attitude, position and velocity are those of sins_get_navigation(). No allocation, no system call.
///
/// SINS_ERROR_BAD_HANDLE: sim is not a simulator.
/// SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: in these states, as sins_get_navigation().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_get_navigation(
    unit: *mut sins_unit,
    sim: *const sins_sim,
    navigation: *mut sins_unit_navigation,
) -> sins_status {
    with_unit(unit, |unit| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(navigation, "navigation")? };
        Ok(output.write(&(&look_at(sim, "sim", |simulator| unit.navigation(simulator))??).into()))
    })
}
