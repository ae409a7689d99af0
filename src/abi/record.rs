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
    /// [rad]
    pub latitude_rad: f64,
    /// [rad]
    pub longitude_rad: f64,
    /// [m]
    pub height_m: f64,
    /// [m/s]
    pub velocity_enu_m_s: [f64; 3],
    /// [rad]
    pub roll_rad: f64,
    /// [rad]
    pub pitch_rad: f64,
    /// [rad]
    pub heading_rad: f64,
    /// Scalar first.
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
    /// [m]
    pub position_enu_m: [f64; 3],
    /// [rad]
    pub latitude_rad: f64,
    /// [rad]
    pub longitude_rad: f64,
    /// [m]
    pub height_m: f64,
    /// [m/s]
    pub velocity_enu_m_s: [f64; 3],
    /// [rad]
    pub misalignment_enu_rad: [f64; 3],
    /// [rad]
    pub roll_rad: f64,
    /// [rad]
    pub pitch_rad: f64,
    /// [rad]
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
    /// As sins_get_truth().
    pub truth: sins_record_solution,
    /// As sins_get_navigation().
    pub navigation: sins_record_solution,
    /// As sins_get_errors() with SINS_ERRORS_NAVIGATION: error data 2.
    pub navigation_errors: sins_record_errors,
    /// As sins_get_errors() with SINS_ERRORS_MODEL: error data 1; flagged SINS_ERRORS_NOT_COMPUTED while the model is off.
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

/// Reads truth, navigation and both errors of this moment at once; before the first step, of the first sample.
///
/// SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_BAD_STATE: navigating on increments, there is no truth.
/// SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_get_record(sim: *mut sins_sim, record: *mut sins_record) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(record, "record")? };
        Ok(written_or_need(simulator.see(|moment| output.fill(|record| record.be_of(moment)))?))
    })
}
