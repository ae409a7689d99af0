//! The options of a scene: the same struct as that of the simulator's own function.

use super::{sins_scene, with_scene};
use crate::abi::failure::sins_status;
use crate::abi::memory::Output;
use crate::abi::options::sins_options;
use crate::abi::parameters::Parameters;

/// Reads the options of the scene. sins_scene_set_values() sets them.
///
/// SINS_ERROR_BAD_STATE: as sins_scene_parse(), as for all functions that read or set a part of a scene.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_get_options(
    scene: *const sins_scene,
    options: *mut sins_options,
) -> sins_status {
    with_scene(scene, |scene| {
        // SAFETY: the host's promise.
        Ok(unsafe { Output::new(options, "options")? }.write(&sins_options::from_parameters(&scene.options)))
    })
}
