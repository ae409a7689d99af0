//! `sins_scene`: scenes read, written and flown.

mod failure;
mod fault;
mod flight;
mod key;
mod log;
mod log_file;
mod play;
mod play_saved;
mod prepare;
mod samples;
mod settings;
mod text;
mod unit;
mod value;

pub use failure::*;
pub use fault::sins_fault;
pub use flight::*;
pub use key::*;
pub use log::*;
pub use log_file::*;
pub use play::*;
pub use play_saved::*;
pub use prepare::*;
pub use samples::*;
pub use settings::*;
pub use text::*;
pub use unit::*;
pub use value::*;

use core::ffi::c_char;

use crate::abi::boundary::handle::{hand_out, with_object};
use crate::abi::boundary::tables::{FLIGHTS, SCENES, SIMULATORS, SceneText};
use crate::abi::boundary::{enter, enter_without_simulator};
use crate::abi::failure::{CallError, SINS_OK, SINS_SCENE_HAS_FAULTS, sins_status};
use crate::abi::flight::sins_flight;
use crate::abi::memory::{Output, element};
use crate::abi::simulator::sins_sim;
use crate::abi::text::{bad_text, bytes_of, put_text, text_of};
use crate::base::error::{Error, check_integer};
use crate::base::memory::{of_bytes, probe};
use crate::scene::{BUILTIN_SCENES, Fault, MAX_TEXT, Scene, builtin, keys_text};

/// A scene. A handle is a checked key, as that of sins_sim, and never taken for one.
#[repr(C)]
pub struct sins_scene {
    _opaque: [u8; 0],
}

/// What a copy of a scene and its text take at the most, and with each item of a list more [bytes].
const ROOM: usize = 1 << 16;
const ROOM_OF_ITEM: usize = 1 << 12;
/// What the parser makes of a byte of a scene's own text at the most [bytes].
const ROOM_OF_BYTE: usize = 160;
/// What it makes of a byte of a host's text, each of which may be a fault with its sentence, and of a short text [bytes].
const ROOM_OF_HOSTS_BYTE: usize = 1 << 10;
const ROOM_OF_FAULTS: usize = 1 << 17;

/// Checks that there is memory for the parser to read `size` bytes of a host's text, beside `own` bytes.
fn probe_text(own: usize, size: usize) -> Result<(), Error> {
    probe(own + ROOM_OF_FAULTS + ROOM_OF_HOSTS_BYTE * size.min(MAX_TEXT))
}

fn of_scene(scene: Scene) -> SceneText {
    SceneText { scene: Some(Box::new(scene)), faults: Vec::new(), files: Vec::new() }
}

/// Runs `body` on the scene of a handle, as the inside of an exported function; it may copy the scene and write it.
pub(in crate::abi) fn with_scene(
    scene: *const sins_scene,
    body: impl FnOnce(&mut Scene) -> Result<sins_status, CallError>,
) -> sins_status {
    with_sound_scene(scene, |scene| {
        probe(ROOM + ROOM_OF_ITEM * scene.items())?;
        body(scene)
    })
}

/// Runs `body` on the scene of a handle without an allocation.
pub(in crate::abi) fn with_sound_scene(
    scene: *const sins_scene,
    body: impl FnOnce(&mut Scene) -> Result<sins_status, CallError>,
) -> sins_status {
    with_object(&SCENES, scene, |content| match &mut content.scene {
        Some(scene) => body(scene),
        None => Err(text_has_faults().into()),
    })
}

fn text_has_faults() -> Error {
    Error::bad_state("the text of the scene has faults: sins_scene_get_fault()")
}

/// Why a change of a scene is rejected.
pub(in crate::abi) enum Rejected {
    /// A bad argument.
    Call(CallError),
    /// Faults of the scene that it would be.
    Faults(Vec<Fault>),
}

impl From<CallError> for Rejected {
    fn from(failure: CallError) -> Self {
        Self::Call(failure)
    }
}

impl From<Vec<Fault>> for Rejected {
    fn from(faults: Vec<Fault>) -> Self {
        Self::Faults(faults)
    }
}

/// The faults of a text, unless it could not be read for lack of memory.
fn of_text(faults: Vec<Fault>) -> Result<Vec<Fault>, CallError> {
    match faults.iter().any(|fault| fault.about.lacks_memory) {
        true => Err(of_bytes(ROOM).into()),
        false => Ok(faults),
    }
}

/// Changes the scene of a handle by `body`, which reads `size` bytes of the host's `argument` beside the scene's text. Keeps the
/// faults of a rejected change.
pub(in crate::abi) fn change_scene(
    scene: *mut sins_scene,
    argument: &'static str,
    size: usize,
    body: impl FnOnce(&mut Scene) -> Result<(), Rejected>,
) -> sins_status {
    with_object(&SCENES, scene, |SceneText { scene, faults, .. }| {
        let Some(scene) = scene else { return Err(text_has_faults().into()) };
        let items = ROOM_OF_ITEM * scene.items();
        probe_text(ROOM + items + ROOM_OF_BYTE * (ROOM + items).min(MAX_TEXT), size)?;
        faults.clear();
        match body(scene) {
            Ok(()) => Ok(SINS_OK),
            Err(Rejected::Call(failure)) => Err(failure),
            Err(Rejected::Faults(found)) => {
                *faults = of_text(found)?;
                Err(bad_text(argument, "the scene was not changed; sins_scene_get_fault() gives the reasons")
                    .into())
            }
        }
    })
}

/// Creates the default scene: the recommended simulator with ideal sensors, at rest for an hour at latitude 0, longitude 0,
/// height 0, sampled at 100 Hz.
///
/// On an error *scene is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason, as for every function of
/// scenes. SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 scenes exist. Functions of scenes allocate: only sins_scene_prepare()
/// and sins_scene_prepare_ensemble() are for a real-time frame. The other functions of scenes first check that enough memory
/// is free for the call. If another thread takes this memory during the call, the process ends. sins_log_parse() does the
/// same, except that running out of memory for the samples is always SINS_ERROR_OUT_OF_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_create(scene: *mut *mut sins_scene) -> sins_status {
    enter_without_simulator(|| {
        let make = || probe(ROOM).map(|()| of_scene(Scene::default())).map_err(CallError::from);
        // SAFETY: the host's promise.
        unsafe { hand_out(&SCENES, scene, "scene", make) }
    })
}

/// Creates a scene from its text: TOML in UTF-8, at most 1 MiB. The library does not keep the bytes.
/// sins_scene_write_keys() and sins_scene_get_key() list the keys.
///
/// SINS_SCENE_HAS_FAULTS: the text is not a valid scene; sins_scene_get_fault() gives every fault and its place. The handle
/// is made for that only: all other functions except sins_scene_destroy() return SINS_ERROR_BAD_STATE.
/// SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
///
/// ```c
/// const char text[] = "[flight]\nbuiltin = \"patrol\"\n[gyro]\nbias_deg_h = 0.01\n";
/// sins_scene *scene = NULL;
/// sins_sim *of_scene = NULL;
/// if (sins_scene_parse(text, sizeof text - 1, &scene) == SINS_OK)
///     sins_scene_create_simulator(scene, &of_scene);
/// sins_get_gyro(of_scene, &gyro);
/// printf("%.2f deg/h\n", gyro.bias_rad_s[0] / SINS_DEG_PER_HOUR);  // 0.01 deg/h
/// sins_destroy(of_scene);
/// sins_scene_destroy(scene);
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_parse(
    text: *const c_char,
    size: usize,
    scene: *mut *mut sins_scene,
) -> sins_status {
    enter_without_simulator(|| {
        let mut status = SINS_OK;
        // SAFETY: the host's promise.
        unsafe {
            hand_out(&SCENES, scene, "scene", || {
                let text = bytes_of(text.cast(), size, "text")?;
                probe_text(ROOM, text.len())?;
                Ok(match Scene::parse(text) {
                    Ok(scene) => of_scene(scene),
                    Err(faults) => {
                        let faults = of_text(faults)?;
                        status = SINS_SCENE_HAS_FAULTS;
                        SceneText { scene: None, faults, files: Vec::new() }
                    }
                })
            })?
        };
        Ok(status)
    })
}

/// Reads fault `index` of the scene's text, from 0 in the order of the text; fault->count is the number of faults. After
/// sins_scene_set_values() and sins_scene_set_items() the faults are those of that call; none if it succeeded.
///
/// SINS_ERROR_INVALID_ARGUMENT: there is no such fault.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_get_fault(
    scene: *const sins_scene,
    index: usize,
    fault: *mut sins_fault,
) -> sins_status {
    with_object(&SCENES, scene, |content| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(fault, "fault")? };
        let faults = &content.faults;
        let found = element(faults, index, "must be less than the number of faults of the scene:")?;
        Ok(output.write(&sins_fault::new(found, faults.len())))
    })
}

/// What is wrong with a name that no built-in scene has.
const NO_BUILTIN: &str = "must be the name of a built-in scene; sins_scene_builtin_name() gives the names";

/// Creates a built-in scene by its name: "simulation1", "simulation2", "rest", "patrol", "racetrack", "aerobatics",
/// "over_the_pole", "coning", "commuter", "rock_size", "spin_accel", "gen_nav".
///
/// SINS_ERROR_INVALID_ARGUMENT: no scene has that name.
/// SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_create_builtin(
    name: *const c_char,
    scene: *mut *mut sins_scene,
) -> sins_status {
    enter_without_simulator(|| {
        let unknown = || CallError::from(bad_text("name", NO_BUILTIN));
        // SAFETY: the host's promise.
        unsafe {
            hand_out(&SCENES, scene, "scene", || {
                let name = text_of(name, "name")?;
                probe(ROOM_OF_BYTE * ROOM)?;
                core::str::from_utf8(name).ok().and_then(builtin).map(of_scene).ok_or_else(unknown)
            })
        }
    })
}

/// Reads the name of built-in scene `index`, from 0. buffer, capacity and needed as in sins_scene_write().
///
/// SINS_ERROR_INVALID_ARGUMENT: there are no more.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_builtin_name(
    index: usize,
    buffer: *mut c_char,
    capacity: usize,
    needed: *mut usize,
) -> sins_status {
    enter_without_simulator(|| {
        let (name, _) = element(BUILTIN_SCENES, index, "must be less than the number of built-in scenes:")?;
        // SAFETY: the host's promise.
        unsafe { put_text(name.as_bytes(), buffer, capacity, needed) }
    })
}

/// Writes the scene as commented TOML, which sins_scene_parse() reads back to the same scene, to the bit.
///
/// needed (may be NULL) gets the size of the whole text with its terminator; buffer NULL and capacity 0 ask for the size
/// only. SINS_ERROR_BUFFER_TOO_SMALL: the text was cut. SINS_ERROR_INVALID_ARGUMENT: settings that do not go together, or
/// so many manoeuvres, failures and updates that the text would have more than 1 MiB. SINS_ERROR_BAD_STATE: as sins_scene_parse().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_write(
    scene: *const sins_scene,
    buffer: *mut c_char,
    capacity: usize,
    needed: *mut usize,
) -> sins_status {
    with_scene(scene, |scene| {
        scene.check()?;
        let text = scene.write();
        check_integer("bytes of the scene's text", text.len(), 0, MAX_TEXT as u64)?;
        // SAFETY: the host's promise.
        unsafe { put_text(text.as_bytes(), buffer, capacity, needed) }
    })
}

/// Writes every section and key of a scene, one in a line, with its values, its unit and its meaning. buffer, capacity and
/// needed as in sins_scene_write().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_write_keys(
    buffer: *mut c_char,
    capacity: usize,
    needed: *mut usize,
) -> sins_status {
    enter_without_simulator(|| {
        probe(ROOM)?;
        // SAFETY: the host's promise.
        unsafe { put_text(keys_text().as_bytes(), buffer, capacity, needed) }
    })
}

/// Creates the simulator of the scene, ready for the first sample: options, sensor errors, initial errors, mounting, gravity
/// disturbance. sins_scene_prepare() sets the failures and makes the updates at their times. If the flight is not a log,
/// sins_options.sample_period_s of the simulator is 1 / rate_hz.
///
/// SINS_ERROR_INVALID_ARGUMENT: settings that do not go together.
/// SINS_ERROR_BAD_STATE: as sins_scene_parse().
/// SINS_ERROR_OUT_OF_MEMORY: as sins_create().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_create_simulator(
    scene: *const sins_scene,
    sim: *mut *mut sins_sim,
) -> sins_status {
    with_scene(scene, |scene| {
        let make = || scene.check().and_then(|()| scene.simulator()).map_err(CallError::from);
        // SAFETY: the host's promise.
        unsafe { hand_out(&SIMULATORS, sim, "sim", make) }
    })
}

/// Creates the flight of the scene, composed of manoeuvres or built-in, on the scene's ellipsoid. A host samples it at k / rate
/// up to sins_scene_setup.flown_s.
///
/// SINS_ERROR_BAD_STATE: the flight of the scene is a log, whose name is SINS_SCENE_TEXT_LOG; or as sins_scene_parse().
/// Else as sins_flight_create().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_create_flight(
    scene: *const sins_scene,
    flight: *mut *mut sins_flight,
) -> sins_status {
    with_scene(scene, |scene| {
        // SAFETY: the host's promise.
        unsafe { hand_out(&FLIGHTS, flight, "flight", || Ok(scene.flight()?)) }
    })
}

/// Destroys a scene. Simulators and flights that were created from it stay valid.
///
/// SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_destroy(scene: *mut sins_scene) -> sins_status {
    enter(|| SCENES.remove(scene.addr()))
}
