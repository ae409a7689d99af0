//! The texts of a scene.

use core::ffi::c_char;

use super::{NO_BUILTIN, sins_scene, with_scene};
use crate::abi::failure::{CallError, SINS_OK, sins_status};
use crate::abi::text::{bad_text, put_text, utf8_of};
use crate::base::error::{Error, Rule, check_integer};
use crate::scene::{self, FlightSource, MAX_TEXT_VALUE, Scene};

/// The texts of a scene: sins_scene_get_text(), sins_scene_set_text().
pub type sins_scene_text = i32;

/// Title: the scene in a few words.
pub const SINS_SCENE_TEXT_TITLE: sins_scene_text = 0;
/// Path of the flight log, relative to the scene's own folder. Setting it makes the flight a log.
pub const SINS_SCENE_TEXT_LOG: sins_scene_text = 1;
/// Name of the built-in scene whose flight is flown. Setting it selects that flight.
pub const SINS_SCENE_TEXT_BUILTIN: sins_scene_text = 2;
/// Folder of the output files of a program.
pub const SINS_SCENE_TEXT_FOLDER: sins_scene_text = 3;
/// Base name of the output files.
pub const SINS_SCENE_TEXT_NAME: sins_scene_text = 4;
/// Name of the file for the measured increments.
pub const SINS_SCENE_TEXT_IMU: sins_scene_text = 5;

fn no_such_text(which: i32) -> CallError {
    Error::invalid("which", which, Rule::OneOf("sins_scene_text", 0, 5)).into()
}

/// The text `which` of a scene.
fn text(scene: &Scene, which: i32) -> Result<&str, CallError> {
    Ok(match which {
        SINS_SCENE_TEXT_TITLE => &scene.title,
        SINS_SCENE_TEXT_LOG => match &scene.flight {
            FlightSource::Log(name) => name,
            _ => "",
        },
        SINS_SCENE_TEXT_BUILTIN => match &scene.flight {
            FlightSource::Builtin(name) => name,
            _ => "",
        },
        SINS_SCENE_TEXT_FOLDER => &scene.output.folder,
        SINS_SCENE_TEXT_NAME => &scene.output.name,
        SINS_SCENE_TEXT_IMU => &scene.output.imu,
        _ => return Err(no_such_text(which)),
    })
}

/// Reads a text of the scene; which is of enum sins_scene_text. An empty text means that it is not set. buffer, capacity
/// and needed as in sins_scene_write().
///
/// SINS_ERROR_INVALID_ARGUMENT: no such text.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_get_text(
    scene: *const sins_scene,
    which: i32,
    buffer: *mut c_char,
    capacity: usize,
    needed: *mut usize,
) -> sins_status {
    with_scene(scene, |scene| {
        let text = text(scene, which)?;
        // SAFETY: the host's promise.
        unsafe { put_text(text.as_bytes(), buffer, capacity, needed) }
    })
}

/// Sets a text of the scene; which is of enum sins_scene_text. The text is UTF-8, terminated, at most 4096 bytes. An empty
/// text clears it, except SINS_SCENE_TEXT_LOG and SINS_SCENE_TEXT_BUILTIN, which cannot be empty.
///
/// SINS_ERROR_INVALID_ARGUMENT: no such text, not UTF-8, too long, a control character, or no such built-in scene.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_set_text(
    scene: *mut sins_scene,
    which: i32,
    text: *const c_char,
) -> sins_status {
    with_scene(scene, |scene| {
        // SAFETY: the host's promise.
        let text = unsafe { utf8_of(text, "text")? };
        let refused = |rule| bad_text("text", rule);
        check_integer("bytes of text", text.len(), 0, MAX_TEXT_VALUE as u64)?;
        if text.chars().any(char::is_control) {
            return Err(refused("must not have control characters").into());
        }
        let flight = |source: FlightSource| {
            if text.is_empty() {
                Err(refused("must not be empty: it selects the scene's flight"))
            } else {
                Ok(source)
            }
        };
        match which {
            SINS_SCENE_TEXT_TITLE => scene.title = text.to_owned(),
            SINS_SCENE_TEXT_LOG => {
                scene.flight = flight(FlightSource::Log(text.to_owned()))?;
                scene.rate_hz = Scene::default().rate_hz;
            }
            SINS_SCENE_TEXT_BUILTIN => {
                if crate::scene::builtin(text).is_none() {
                    return Err(refused(NO_BUILTIN).into());
                }
                scene.flight = flight(FlightSource::Builtin(text.to_owned()))?;
            }
            SINS_SCENE_TEXT_FOLDER => scene.output.folder = text.to_owned(),
            SINS_SCENE_TEXT_NAME => {
                let output = scene::Output { name: text.to_owned(), ..scene.output.clone() };
                output.validate().map_err(|error| Error { field: "text", ..error })?;
                scene.output = output;
            }
            SINS_SCENE_TEXT_IMU => scene.output.imu = text.to_owned(),
            _ => return Err(no_such_text(which)),
        }
        Ok(SINS_OK)
    })
}
