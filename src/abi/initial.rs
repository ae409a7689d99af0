//! `sins_initial_errors`.

use super::choice::choices;
use super::failure::sins_status;
use super::parameters::{get, params, set};
use super::simulator::sins_sim;
use crate::sensors::{Alignment, InitialErrorParameters};
use crate::simulator::Simulator;
use crate::surroundings::copy;

include!(concat!(env!("OUT_DIR"), "/sins_alignment.rs"));

include!(concat!(env!("OUT_DIR"), "/initial_params.rs"));

params!(sins_initial_errors, "initial", 168, InitialErrorParameters, copy, alignment: alignment);

/// Sets the errors with which the navigation starts. Allowed before the first step, and after a reset or a reposition until
/// the next step. After a reposition they apply to the start at its sample.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
/// SINS_ERROR_BAD_STATE: steps have been made.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_set_initial_errors(
    sim: *mut sins_sim,
    errors: *const sins_initial_errors,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(sim, errors, "errors", Simulator::set_initial_errors) }
}

/// Reads the set errors with which the navigation starts. May be called at any moment. After sins_snapshot_load() they are
/// those of the snapshot.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_initial_errors(
    sim: *mut sins_sim,
    errors: *mut sins_initial_errors,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(sim, errors, "errors", Simulator::initial_errors) }
}
