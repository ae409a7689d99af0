//! `sins_record`: one line of the output of `sins_run`.

use super::failure::sins_status;
use super::memory::{Output, interface_struct};
use super::simulator::{sins_sim, with_simulator};
use super::solution::{sins_errors, sins_navigation, written_or_need};
use crate::simulator::Moment;

/// A solution within a sins_record; never grows. Fields as in sins_navigation.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_record_solution {
    /// Geodetic latitude [rad].
    pub latitude_rad: f64,
    /// Longitude, east positive [rad].
    pub longitude_rad: f64,
    /// Height above the ellipsoid [m].
    pub height_m: f64,
    /// Velocity against the Earth, east-north-up [m/s].
    pub velocity_enu_m_s: [f64; 3],
    /// Roll, right wing down positive [rad].
    pub roll_rad: f64,
    /// Pitch, nose up positive [rad].
    pub pitch_rad: f64,
    /// Heading, clockwise from true north [rad].
    pub heading_rad: f64,
    /// Attitude quaternion, scalar first: rotates from sensor axes to east-north-up.
    pub quaternion_nb: [f64; 4],
    /// Flags of enum sins_navigation_flags, or'ed.
    pub flags: i32,
    /// 0
    pub reserved: u32,
}

/// Errors within a sins_record; never grows. Fields as in sins_errors.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_record_errors {
    /// Displacement from truth along true east and north, and error of height [m].
    pub position_enu_m: [f64; 3],
    /// Error of latitude [rad].
    pub latitude_rad: f64,
    /// Error of longitude [rad].
    pub longitude_rad: f64,
    /// Error of height [m].
    pub height_m: f64,
    /// Error of velocity, east-north-up [m/s].
    pub velocity_enu_m_s: [f64; 3],
    /// Misalignment phi, east-north-up [rad].
    pub misalignment_enu_rad: [f64; 3],
    /// Error of roll [rad].
    pub roll_rad: f64,
    /// Error of pitch [rad].
    pub pitch_rad: f64,
    /// Error of heading [rad].
    pub heading_rad: f64,
    /// Flags of enum sins_errors_flags, or'ed.
    pub flags: i32,
    /// 0
    pub reserved: u32,
}

/// Truth, navigation and both errors at one instant.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_record {
    /// sizeof(sins_record); in an array it is enough to set it in the first element and 0 in the others.
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// Time [s].
    pub time_s: f64,
    /// The truth, as sins_get_truth() gives it.
    pub truth: sins_record_solution,
    /// The navigated solution, as sins_get_navigation() gives it.
    pub navigation: sins_record_solution,
    /// Error data 2, as sins_get_errors() gives it with SINS_ERRORS_NAVIGATION.
    pub navigation_errors: sins_record_errors,
    /// Error data 1, as sins_get_errors() gives it with SINS_ERRORS_MODEL; flagged SINS_ERRORS_NOT_COMPUTED while the model
    /// is off.
    pub model_errors: sins_record_errors,
}

interface_struct!(sins_record, "record", 496);

impl From<sins_navigation> for sins_record_solution {
    fn from(n: sins_navigation) -> Self {
        Self {
            latitude_rad: n.latitude_rad,
            longitude_rad: n.longitude_rad,
            height_m: n.height_m,
            velocity_enu_m_s: n.velocity_enu_m_s,
            roll_rad: n.roll_rad,
            pitch_rad: n.pitch_rad,
            heading_rad: n.heading_rad,
            quaternion_nb: n.quaternion_nb,
            flags: n.flags,
            reserved: 0,
        }
    }
}

impl From<sins_errors> for sins_record_errors {
    fn from(e: sins_errors) -> Self {
        Self {
            position_enu_m: e.position_enu_m,
            latitude_rad: e.latitude_rad,
            longitude_rad: e.longitude_rad,
            height_m: e.height_m,
            velocity_enu_m_s: e.velocity_enu_m_s,
            misalignment_enu_rad: e.misalignment_enu_rad,
            roll_rad: e.roll_rad,
            pitch_rad: e.pitch_rad,
            heading_rad: e.heading_rad,
            flags: e.flags,
            reserved: 0,
        }
    }
}

impl sins_record {
    /// Is the record of `moment`, but for its struct_size.
    #[inline(always)]
    pub(super) fn be_of(&mut self, moment: Moment<'_>) {
        self.reserved = 0;
        self.time_s = moment.time_s();
        self.truth = sins_navigation::from_solution(&moment.truth()).into();
        self.navigation = sins_navigation::from_solution(&moment.navigation()).into();
        self.navigation_errors = sins_errors::of_navigation(moment).into();
        self.model_errors = sins_errors::of_model(moment).into();
    }
}

/// Reads truth, navigation and both errors of this moment in one call; before the first step, those at the first sample.
///
/// SINS_NEED_SAMPLE: no sample yet.
/// SINS_ERROR_BAD_STATE: navigating on increments, without a truth.
/// SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_get_record(sim: *mut sins_sim, record: *mut sins_record) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(record, "record")? };
        Ok(written_or_need(simulator.see(|moment| output.fill(|record| record.be_of(moment)))?))
    })
}
