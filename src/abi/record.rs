//! `sins_record`: one line of the output of `sins_run`.

use super::answer::fill_or_need;
use super::errors::sins_record_errors;
use super::failure::sins_status;
use super::memory::{Output, interface_struct};
use super::simulator::{sins_sim, with_simulator};
use super::solution::sins_record_solution;
use crate::simulator::{Moment, View};

/// Truth, navigation and both errors at one instant.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_record {
    /// sizeof(sins_record); in an array only that of the first element must be set.
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

pub(super) struct RecordView;

impl View for RecordView {
    type Struct = sins_record;
    const OF_TRUTH: bool = true;
    const OF_NAVIGATION: bool = true;

    #[inline(always)]
    fn fill(record: &mut sins_record, moment: Moment<'_>) {
        record.reserved = 0;
        record.time_s = moment.time_s();
        record.truth = sins_record_solution::of(&moment.truth());
        record.navigation = sins_record_solution::of(&moment.navigation());
        record.navigation_errors = sins_record_errors::of_navigation(moment);
        record.model_errors = sins_record_errors::of_model(moment);
    }
}

/// Reads truth, navigation and both errors of this moment in one call; before the first step, those at the first sample.
///
/// SINS_NEED_SAMPLE: no sample yet.
/// SINS_ERROR_BAD_STATE: navigating on increments, without a truth.
/// SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_record(sim: *mut sins_sim, record: *mut sins_record) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(record, "record")? };
        fill_or_need::<RecordView>(simulator, &output)
    })
}
