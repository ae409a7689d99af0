//! What a scene sets of the simulator: the same structs as those of the simulator's own functions.

use super::altimeter::sins_altimeter_params;
use super::failure::{Failure, SINS_OK, sins_status};
use super::gravity::sins_gravity_params;
use super::initial::sins_initial_errors;
use super::memory::{Output, Struct, read};
use super::mounting::sins_mounting;
use super::options::sins_options;
use super::scene::{sins_scene, with_scene};
use super::sensor_params::{sins_accel_params, sins_gyro_params};
use crate::scene::Scene;
use crate::sensors::Sensor;

/// # Safety
/// As the exported functions: `place` is null or points to a struct that may be written.
unsafe fn get<T: Struct>(
    scene: *const sins_scene,
    place: *mut T,
    name: &'static str,
    settings: impl FnOnce(&Scene) -> T,
) -> sins_status {
    with_scene(scene, |scene| {
        // SAFETY: as this function.
        let output = unsafe { Output::new(place, name)? };
        output.write(&settings(scene));
        Ok(SINS_OK)
    })
}

/// # Safety
/// As the exported functions: `place` is null or points to a struct.
unsafe fn set<T: Struct>(
    scene: *mut sins_scene,
    place: *const T,
    name: &'static str,
    settings: impl FnOnce(&mut Scene, T) -> Result<(), Failure>,
) -> sins_status {
    with_scene(scene, |scene| {
        // SAFETY: as this function.
        settings(scene, unsafe { read(place, name)? })?;
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
    unsafe { get(scene, options, "options", |scene| sins_options::from_options(&scene.options)) }
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
    unsafe {
        set(scene, options, "options", |scene, options| {
            let options = options.to_options()?;
            options.validate()?;
            scene.options = options;
            Ok(())
        })
    }
}

/// Reads the gyro errors of the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_get_gyro(
    scene: *const sins_scene,
    params: *mut sins_gyro_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(scene, params, "params", |scene| sins_gyro_params::from_parameters(&scene.errors.gyro)) }
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
    unsafe {
        set(scene, params, "params", |scene, params| {
            let parameters = params.to_parameters()?;
            parameters.validate(Sensor::Gyro)?;
            scene.errors.gyro = parameters;
            Ok(())
        })
    }
}

/// Reads the accelerometer errors of the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_get_accel(
    scene: *const sins_scene,
    params: *mut sins_accel_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(scene, params, "params", |scene| sins_accel_params::from_parameters(&scene.errors.accel)) }
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
    unsafe {
        set(scene, params, "params", |scene, params| {
            let parameters = params.to_parameters()?;
            parameters.validate(Sensor::Accelerometer)?;
            scene.errors.accel = parameters;
            Ok(())
        })
    }
}

/// Reads the errors of the scene's altimeter.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_get_altimeter(
    scene: *const sins_scene,
    params: *mut sins_altimeter_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe {
        get(scene, params, "params", |scene| sins_altimeter_params::from_parameters(&scene.errors.altimeter))
    }
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
    unsafe {
        set(scene, params, "params", |scene, params| {
            let parameters = params.to_parameters()?;
            parameters.validate()?;
            scene.errors.altimeter = parameters;
            Ok(())
        })
    }
}

/// Reads the errors with which the navigation of the scene starts.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_get_initial_errors(
    scene: *const sins_scene,
    errors: *mut sins_initial_errors,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe {
        get(scene, errors, "errors", |scene| sins_initial_errors::from_parameters(&scene.errors.initial))
    }
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
    unsafe {
        set(scene, errors, "errors", |scene, errors| {
            let parameters = errors.to_parameters()?;
            parameters.validate()?;
            scene.errors.initial = parameters;
            Ok(())
        })
    }
}

/// Reads the mounting of the scene's sensor block.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_get_mounting(
    scene: *const sins_scene,
    mounting: *mut sins_mounting,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe {
        get(scene, mounting, "mounting", |scene| sins_mounting::from_parameters(&scene.errors.mounting))
    }
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
    unsafe {
        set(scene, mounting, "mounting", |scene, mounting| {
            let parameters = mounting.to_parameters()?;
            parameters.validate()?;
            scene.errors.mounting = parameters;
            Ok(())
        })
    }
}

/// Reads the gravity disturbance of the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_scene_get_gravity_disturbance(
    scene: *const sins_scene,
    params: *mut sins_gravity_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe {
        get(scene, params, "params", |scene| sins_gravity_params::from_parameters(&scene.errors.gravity))
    }
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
    unsafe {
        set(scene, params, "params", |scene, params| {
            let parameters = params.to_parameters()?;
            parameters.validate()?;
            scene.errors.gravity = parameters;
            Ok(())
        })
    }
}
