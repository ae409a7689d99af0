//! `sins_initial_errors`.

use super::choice::choices;
use super::failure::sins_status;
use super::parameters::params;
use super::settings::{get, set};
use super::simulator::sins_sim;
use crate::sensors::{Alignment, InitialErrorParameters};
use crate::simulator::Simulator;
use crate::surroundings::copy;

/// How the INS finds its attitude at the start.
pub type sins_alignment = i32;

/// The INS starts with the true attitude, turned by the given and the drawn misalignment.
pub const SINS_ALIGNMENT_GIVEN: sins_alignment = 0;
/// The library computes the attitude that levelling and gyrocompassing at rest would find with the sensor errors at the
/// start. It does so even if the flight starts in motion. The INS starts with this attitude, turned by the given and the
/// drawn misalignment. Levelling comes first: it finds the tilt at which the accelerometers sense the reaction to normal gravity. At
/// height this is not quite along the ellipsoid's normal: its horizontal part is 7.5 micro-g at 9 km and 45 degrees.
/// Gyrocompassing then finds the heading at which the horizontal gyro rates point north. SINS_NAVIGATION_NORTH_UNKNOWN is set
/// if the sensor errors hide north. Within 64 km of a pole the start returns SINS_ERROR_SINGULAR.
pub const SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS: sins_alignment = 1;
/// The library computes the attitude that levelling at rest would find with the sensor errors at the start, with the true heading:
/// the heading of a unit whose gyros cannot find north comes from another sensor. The INS starts with this attitude, turned by the
/// given and the drawn misalignment, whose part about up is the heading error. Any latitude.
pub const SINS_ALIGNMENT_LEVEL: sins_alignment = 2;

include!(concat!(env!("OUT_DIR"), "/initial_params.rs"));

params!(sins_initial_errors, "initial", 168, InitialErrorParameters, copy, alignment: alignment);

choices!(sins_alignment: Alignment {
    Given = SINS_ALIGNMENT_GIVEN,
    LevelAndGyrocompass = SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS,
    Level = SINS_ALIGNMENT_LEVEL,
});

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
