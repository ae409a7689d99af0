//! Files beside a log, whose columns the `[log]` of a scene names.

use core::ffi::c_char;

use super::{ROOM, ROOM_OF_ITEM, sins_scene, text_has_faults, with_scene};
use crate::abi::boundary::handle::with_object;
use crate::abi::boundary::tables::{SCENES, SceneText};
use crate::abi::failure::{CallError, SINS_OK, sins_status};
use crate::abi::memory::element;
use crate::abi::text::{bad_text, bytes_of, put_text, utf8_of};
use crate::base::memory::{probe, room};
use crate::base::text::{Fault, excerpt};
use crate::log::{FilesError, FlightLog, LogError};
use crate::scene::Scene;

/// Reads the name of file `index` beside the log, from 0: the files that the [log] of the scene names (file = "ATT.csv"), in alphabetical
/// order. buffer, capacity and needed as in sins_scene_write().
///
/// SINS_ERROR_INVALID_ARGUMENT: there are no more.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_log_file_name(
    scene: *const sins_scene,
    index: usize,
    buffer: *mut c_char,
    capacity: usize,
    needed: *mut usize,
) -> sins_status {
    with_scene(scene, |scene| {
        if buffer.is_null() && capacity > 0 {
            return Err(CallError::null("buffer"));
        }
        let names = scene.log.files();
        let rule = "must be less than the number of files beside the log:";
        let name = element(&names, index, rule)?;
        // SAFETY: the host's promise.
        unsafe { put_text(name.as_bytes(), buffer, capacity, needed) }
    })
}

/// Gives the scene the contents of a file beside the log, before sins_log_parse() joins it with the log; name is one of
/// sins_scene_log_file_name(). The bytes are copied, and kept until the scene is destroyed, the file is given again, or a file is given
/// after the [log] has ceased to name this one. Not for a real-time frame: it allocates.
///
/// SINS_ERROR_INVALID_ARGUMENT: the [log] of the scene names no such file; what was given before is unchanged.
/// SINS_ERROR_OUT_OF_MEMORY: no memory for the bytes. SINS_ERROR_BAD_STATE: as sins_scene_parse().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_give_log_file(
    scene: *mut sins_scene,
    name: *const c_char,
    text: *const c_char,
    size: usize,
) -> sins_status {
    with_object(&SCENES, scene, |SceneText { scene, files, .. }| {
        let scene = scene.as_ref().ok_or_else(text_has_faults)?;
        // SAFETY: the host's promise.
        let (name, text) = unsafe { (utf8_of(name, "name")?, bytes_of(text.cast(), size, "text")?) };
        probe(ROOM + ROOM_OF_ITEM)?;
        let named = scene.log.files();
        if !named.contains(&name) {
            let rule =
                "the [log] of the scene names no such file; sins_scene_log_file_name() gives the names";
            return Err(bad_text("name", rule).into());
        }
        let mut copy = room(text.len())?;
        copy.extend_from_slice(text);
        files.retain(|(known, _)| known != name && named.contains(&known.as_str()));
        files.push((name.to_owned(), copy));
        Ok(SINS_OK)
    })
}

/// The log in a text, joined with those of `files` that the scene names.
pub(super) fn read_log(
    scene: &Scene,
    text: &[u8],
    files: &[(String, Vec<u8>)],
) -> Result<FlightLog, LogError> {
    let of_whole = |sentence| LogError::Fault(Fault { sentence, ..Fault::default() });
    let read = |name: &str| {
        let found = files.iter().find(|(given, _)| given == name).map(|(_, bytes)| bytes);
        let missing =
            || format!("log: {} is not given; sins_scene_give_log_file() gives its contents", excerpt(name));
        found.ok_or_else(|| of_whole(missing()))
    };
    let log = FlightLog::parse_files(text, &scene.log, read).map_err(|error| match error {
        FilesError::Unread(error) => error,
        FilesError::Of(name, error) => match *error {
            LogError::Fault(fault) if !name.is_empty() => {
                let line = if fault.line > 0 { format!(":{}", fault.line) } else { String::new() };
                of_whole(format!("{}{line}: {}", excerpt(&name), fault.sentence))
            }
            error => error,
        },
    })?;
    log.smoothed(&scene.options.earth())
}
