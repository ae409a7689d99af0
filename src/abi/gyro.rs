//! Setting and reading the errors of the gyros.

use super::failure::sins_status;
use super::sensor_params::sins_gyro_params;
use super::settings::{get, set};
use super::simulator::sins_sim;
use crate::simulator::Simulator;

/// Sets the gyro errors: before the first sample or in flight, from the next interval on. The random numbers of other
/// effects do not change. Random processes that were active continue.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
/// SINS_ERROR_BAD_STATE: temperature coefficients while samples without a temperature wait, or while navigating on
/// increments.
///
/// ```c
/// gyro.bias_rad_s[2] = 0.02 * SINS_DEG_PER_HOUR;
/// gyro.random_walk_rad_sqrt_s[0] = 0.005 * SINS_DEG_PER_SQRT_HOUR;
/// gyro.scale_factor[0] = 100.0 * SINS_PPM;
/// printf("%s\n", sins_status_string(sins_set_gyro(sim, &gyro)));  // SINS_OK
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_set_gyro(
    sim: *mut sins_sim,
    params: *const sins_gyro_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(sim, params, "params", Simulator::set_gyro) }
}

/// Reads the gyro errors that are set. May be called at any moment. After sins_snapshot_load() they are those of the
/// snapshot.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_gyro(
    sim: *mut sins_sim,
    params: *mut sins_gyro_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(sim, params, "params", Simulator::gyro) }
}
