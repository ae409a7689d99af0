//! `sins_mounting`.

use super::failure::sins_status;
use super::parameters::{get, params, set};
use super::simulator::sins_sim;
use crate::mounting::MountingParameters;
use crate::simulator::Simulator;
use crate::surroundings::copy;

include!(concat!(env!("OUT_DIR"), "/mounting_params.rs"));

params!(sins_mounting, "mounting", 104, MountingParameters, copy);

/// Sets the mounting of the sensor block. Allowed before the first step, and after a reset or a reposition until the next
/// step. A reset and a reposition keep the mounting. The mounting does not affect a navigator on increments: its solution is
/// that of the block.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
/// SINS_ERROR_BAD_STATE: steps have been made.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_set_mounting(
    sim: *mut sins_sim,
    mounting: *const sins_mounting,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(sim, mounting, "mounting", Simulator::set_mounting) }
}

/// Reads the mounting of the sensor block that is set. May be called at any moment. After sins_snapshot_load() it is that of
/// the snapshot.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_mounting(
    sim: *mut sins_sim,
    mounting: *mut sins_mounting,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(sim, mounting, "mounting", Simulator::mounting) }
}
