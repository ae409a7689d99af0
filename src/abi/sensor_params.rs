//! `sins_gyro_params` and `sins_accel_params`, which `build` writes from `src/sensors/table.rs`, set and read.

use core::slice::{from_mut, from_ref};

use super::failure::sins_status;
use super::parameters::{get, params, set};
use super::simulator::sins_sim;
use crate::sensors::{PARAMETERS, TriadParameters};
use crate::simulator::Simulator;

const COUNT: usize = PARAMETERS.len();

include!(concat!(env!("OUT_DIR"), "/sensor_params.rs"));

// The first release has all of it.
params!(sins_gyro_params, "gyro", size_of::<sins_gyro_params>(), TriadParameters, copy);
params!(sins_accel_params, "accel", size_of::<sins_accel_params>(), TriadParameters, copy);

/// Copies the numbers of each parameter that both sides have; matrices are row by row on one side, column by column on the other.
fn copy(from: [&[f64]; COUNT], to: [&mut [f64]; COUNT]) {
    for ((parameter, from), to) in PARAMETERS.iter().zip(from).zip(to) {
        if from.len() == to.len() {
            (0..from.len()).for_each(|index| to[parameter.shape.place(index)] = from[index]);
        }
    }
}

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
