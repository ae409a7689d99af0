//! `sins_gravity_params`.

use super::failure::sins_status;
use super::parameters::{get, params, set};
use super::simulator::sins_sim;
use crate::sensors::GravityDisturbanceParameters;
use crate::simulator::Simulator;
use crate::surroundings::copy;

include!(concat!(env!("OUT_DIR"), "/gravity_params.rs"));

params!(sins_gravity_params, "gravity", 80, GravityDisturbanceParameters, copy);

/// Sets the gravity disturbance, true gravity less normal gravity. Allowed before the first step, and after a reset or a
/// reposition until the next step. A reset brings the same field back; after a reposition the field continues from its
/// current values. The disturbance does not affect a navigator on increments, because the host's increments already contain
/// its effect.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
/// SINS_ERROR_BAD_STATE: steps have been made.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_set_gravity_disturbance(
    sim: *mut sins_sim,
    params: *const sins_gravity_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(sim, params, "params", Simulator::set_gravity_disturbance) }
}

/// Reads the parameters of the gravity disturbance that are set. May be called at any moment. After sins_snapshot_load() they
/// are those of the snapshot.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_gravity_disturbance(
    sim: *mut sins_sim,
    params: *mut sins_gravity_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(sim, params, "params", Simulator::gravity_disturbance) }
}
