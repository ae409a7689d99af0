//! Setting and reading the errors of the accelerometers.

use super::failure::sins_status;
use super::sensor_params::sins_accel_params;
use super::settings::{get, set};
use super::simulator::sins_sim;
use crate::simulator::Simulator;

/// Sets the accelerometer errors: before the first sample or in flight, from the next interval on. The random numbers of
/// other effects do not change. Random processes that were active continue.
///
/// SINS_ERROR_INVALID_ARGUMENT, SINS_ERROR_BAD_STATE: as sins_set_gyro().
///
/// ```c
/// accel.bias_m_s2[1] = 50.0 * SINS_MICRO_G;
/// printf("%s\n", sins_status_string(sins_set_accel(sim, &accel)));  // SINS_OK
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_set_accel(
    sim: *mut sins_sim,
    params: *const sins_accel_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(sim, params, "params", Simulator::set_accel) }
}

/// Reads the accelerometer errors that are set. May be called at any moment. After sins_snapshot_load() they are those of the
/// snapshot.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_accel(
    sim: *mut sins_sim,
    params: *mut sins_accel_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(sim, params, "params", Simulator::accel) }
}
