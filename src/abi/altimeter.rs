//! `sins_altimeter_params`.

use super::failure::sins_status;
use super::parameters::{get, params, set};
use super::simulator::sins_sim;
use crate::sensors::AltimeterParameters;
use crate::simulator::Simulator;
use crate::surroundings::copy;

include!(concat!(env!("OUT_DIR"), "/altimeter_params.rs"));

params!(sins_altimeter_params, "altimeter", 56, AltimeterParameters, copy);

/// Sets the errors of the barometric altimeter, whose height damps the vertical channel (SINS_VERTICAL_DAMPED), from the next
/// interval on.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_set_altimeter(
    sim: *mut sins_sim,
    params: *const sins_altimeter_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(sim, params, "params", Simulator::set_altimeter) }
}

/// Reads the errors of the altimeter that are set. May be called at any moment. After sins_snapshot_load() they are those of
/// the snapshot.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_altimeter(
    sim: *mut sins_sim,
    params: *mut sins_altimeter_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(sim, params, "params", Simulator::altimeter) }
}
