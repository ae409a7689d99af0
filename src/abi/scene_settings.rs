//! What a scene sets of the simulator: the same structs as those of the simulator's own functions.

use super::altimeter::sins_altimeter_params;
use super::failure::{SINS_OK, sins_status};
use super::gravity::sins_gravity_params;
use super::initial::sins_initial_errors;
use super::memory::{Output, read};
use super::mounting::sins_mounting;
use super::options::sins_options;
use super::parameters::Parameters;
use super::scene::{sins_scene, with_scene};
use super::sensor_params::{sins_accel_params, sins_gyro_params};
use crate::error::Error;
use crate::mounting::MountingParameters;
use crate::scene::Scene;
use crate::sensors::{AltimeterParameters, GravityDisturbanceParameters, InitialErrorParameters, Sensor};
use crate::simulator::Options;

/// # Safety
/// As the exported functions: `place` is null or points to a struct that may be written.
unsafe fn get<P: Parameters>(
    scene: *const sins_scene,
    place: *mut P,
    name: &'static str,
    of: fn(&Scene) -> &P::Own,
) -> sins_status {
    with_scene(scene, |scene| {
        // SAFETY: as this function.
        unsafe { Output::new(place, name)? }.write(&P::from_parameters(of(scene)));
        Ok(SINS_OK)
    })
}

/// # Safety
/// As the exported functions: `place` is null or points to a struct.
unsafe fn set<P: Parameters>(
    scene: *mut sins_scene,
    place: *const P,
    name: &'static str,
    validate: fn(&P::Own) -> Result<(), Error>,
    of: fn(&mut Scene) -> &mut P::Own,
) -> sins_status {
    with_scene(scene, |scene| {
        // SAFETY: as this function.
        let parameters = unsafe { read(place, name)? }.to_parameters()?;
        validate(&parameters)?;
        *of(scene) = parameters;
        Ok(SINS_OK)
    })
}

/// Reads the options of the scene.
///
/// SINS_ERROR_BAD_STATE: as sins_scene_parse(), as for all functions that read or set a part of a scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_get_options(
    scene: *const sins_scene,
    options: *mut sins_options,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(scene, options, "options", |scene| &scene.options) }
}

/// Sets the options of the scene. As with every part, an error leaves the scene unchanged. Parts can be set in any order:
/// whether they go together is checked when the scene is written, and when its simulator is created.
///
/// SINS_ERROR_INVALID_ARGUMENT: as sins_create().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_set_options(
    scene: *mut sins_scene,
    options: *const sins_options,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(scene, options, "options", Options::validate, |s| &mut s.options) }
}

/// Reads the gyro errors of the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_get_gyro(
    scene: *const sins_scene,
    params: *mut sins_gyro_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(scene, params, "params", |scene| &scene.errors.gyro) }
}

/// Sets the gyro errors of the scene.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_set_gyro(
    scene: *mut sins_scene,
    params: *const sins_gyro_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(scene, params, "params", |p| p.validate(Sensor::Gyro), |s| &mut s.errors.gyro) }
}

/// Reads the accelerometer errors of the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_get_accel(
    scene: *const sins_scene,
    params: *mut sins_accel_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(scene, params, "params", |scene| &scene.errors.accel) }
}

/// Sets the accelerometer errors of the scene.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_set_accel(
    scene: *mut sins_scene,
    params: *const sins_accel_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(scene, params, "params", |p| p.validate(Sensor::Accelerometer), |s| &mut s.errors.accel) }
}

/// Reads the errors of the scene's altimeter.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_get_altimeter(
    scene: *const sins_scene,
    params: *mut sins_altimeter_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(scene, params, "params", |scene| &scene.errors.altimeter) }
}

/// Sets the errors of the scene's altimeter.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_set_altimeter(
    scene: *mut sins_scene,
    params: *const sins_altimeter_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(scene, params, "params", AltimeterParameters::validate, |s| &mut s.errors.altimeter) }
}

/// Reads the errors with which the navigation of the scene starts.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_get_initial_errors(
    scene: *const sins_scene,
    errors: *mut sins_initial_errors,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(scene, errors, "errors", |scene| &scene.errors.initial) }
}

/// Sets the errors with which the navigation of the scene starts.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_set_initial_errors(
    scene: *mut sins_scene,
    errors: *const sins_initial_errors,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(scene, errors, "errors", InitialErrorParameters::validate, |s| &mut s.errors.initial) }
}

/// Reads the mounting of the scene's sensor block.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_get_mounting(
    scene: *const sins_scene,
    mounting: *mut sins_mounting,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(scene, mounting, "mounting", |scene| &scene.errors.mounting) }
}

/// Sets the mounting of the scene's sensor block.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_set_mounting(
    scene: *mut sins_scene,
    mounting: *const sins_mounting,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(scene, mounting, "mounting", MountingParameters::validate, |s| &mut s.errors.mounting) }
}

/// Reads the gravity disturbance of the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_get_gravity_disturbance(
    scene: *const sins_scene,
    params: *mut sins_gravity_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(scene, params, "params", |scene| &scene.errors.gravity) }
}

/// Sets the gravity disturbance of the scene.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_set_gravity_disturbance(
    scene: *mut sins_scene,
    params: *const sins_gravity_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(scene, params, "params", GravityDisturbanceParameters::validate, |s| &mut s.errors.gravity) }
}
