//! The unit of a scene, with what its crew does.

use super::{sins_scene, with_sound_scene};
use crate::abi::boundary::handle::hand_out;
use crate::abi::boundary::tables::UNITS;
use crate::abi::failure::{CallError, SINS_OK, sins_status};
use crate::abi::simulator::{sins_sim, work_with};
use crate::abi::unit::sins_unit;
use crate::base::error::Error;

/// Creates the unit of the scene ([unit]). Not for a real-time frame: it allocates.
///
/// SINS_ERROR_BAD_STATE: the scene has no unit; or as sins_scene_parse(). SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 units exist.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_create_unit(
    scene: *const sins_scene,
    unit: *mut *mut sins_unit,
) -> sins_status {
    with_sound_scene(scene, |scene| {
        let make = || {
            let unit = scene.unit()?;
            Ok(unit.ok_or_else(|| Error::bad_state("the scene has no unit: set unit.start"))?)
        };
        // SAFETY: the host's promise.
        unsafe { hand_out(&UNITS, unit, "unit", make) }
    })
}

/// Does what the scene plans at the panel ([[panel]]) in the last interval of sim, and updates the unit, as sins_unit_update() does: in its
/// place after each step. flight_start_s is the time stamp of the flight's first sample. An action acts in the interval in which
/// its time is, the start of the interval included. No allocation, no system call.
///
/// SINS_ERROR_INVALID_ARGUMENT: flight_start_s not from -2e10 to 2e10.
/// SINS_ERROR_BAD_HANDLE: scene, unit or sim is not a valid handle.
/// SINS_ERROR_BAD_STATE: an entry at the wrong moment; sins_last_error(NULL, ...) says which; the unit was updated. As sins_unit_update();
/// as sins_scene_parse().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_update_unit(
    scene: *const sins_scene,
    unit: *mut sins_unit,
    sim: *mut sins_sim,
    flight_start_s: f64,
) -> sins_status {
    with_sound_scene(scene, |scene| {
        let mut result = Ok(SINS_OK);
        let status = UNITS.with(unit.addr(), |unit| {
            result = work_with(sim, "sim", |simulator| scene.update_unit(unit, simulator, flight_start_s))
                .and_then(|updated| Ok(updated.map(|()| SINS_OK)?));
            Ok(SINS_OK)
        });
        if status == SINS_OK { result } else { Err(CallError::of_handle(status, "unit")) }
    })
}
