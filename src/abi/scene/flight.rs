//! The flight of a scene, and its settings for that and for the output.

use super::{sins_scene, with_scene};
use crate::abi::failure::{CallError, SINS_OK, sins_status};
use crate::abi::flight::{self, sins_flight_start};
use crate::abi::manoeuvre::sins_manoeuvre;
use crate::abi::memory::{Array, Output, interface_struct, put, put_if_wanted};
use crate::abi::parameters::Parameters;
use crate::scene::{FlightPath, FlightSource};

/// Where the flight of a scene comes from: sins_scene_setup.flight.
pub type sins_scene_flight = i32;

/// The flight is composed of manoeuvres.
pub const SINS_SCENE_FLIGHT_MANOEUVRES: sins_scene_flight = 0;
/// The flight is that of a built-in scene, named by SINS_SCENE_TEXT_BUILTIN.
pub const SINS_SCENE_FLIGHT_BUILTIN: sins_scene_flight = 1;
/// The flight is a log, named by SINS_SCENE_TEXT_LOG.
pub const SINS_SCENE_FLIGHT_LOG: sins_scene_flight = 2;

/// Settings of a scene for its flight and its output, to be read: sins_scene_set_values() sets them.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_scene_setup {
    /// sizeof(sins_scene_setup)
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// Kind of the flight, of enum sins_scene_flight.
    pub flight: i32,
    /// 1: samples get the temperature below; 0: samples get no temperature.
    pub has_temperature: i32,
    /// 1: a program shows neither progress nor summary; 0: it does.
    pub quiet: i32,
    /// 1: something is random, so that two runs of the scene differ; 0: all runs are equal.
    pub is_random: i32,
    /// Duration to fly, 0.036 to 3.6e8; 0: the whole flight, or the duration of the built-in scene [s].
    pub duration_s: f64,
    /// Duration that will be flown [s]. 0 for a log (see sins_log_info.duration_s). 0 also if duration_s is longer
    /// than the flight: sins_scene_write() rejects such a scene.
    pub flown_s: f64,
    /// Sample rate, 1e-3 to 2e4; 0 for a log, which has its own time stamps [Hz].
    pub rate_hz: f64,
    /// Temperature of the sensors at the start of the flight, -273.15 to 1000; 0 if has_temperature is 0 [deg C].
    pub temperature_c: f64,
    /// Rate of change of the temperature, -277 to 277 [deg C/s].
    pub temperature_change_c_s: f64,
    /// Spacing of the records of a program, 5e-5 to 1e7; 0: the program's choice [s].
    pub every_s: f64,
}

interface_struct!(sins_scene_setup, "setup", 72);

/// Reads the settings of a scene for its flight and its output.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_get_setup(
    scene: *const sins_scene,
    setup: *mut sins_scene_setup,
) -> sins_status {
    with_scene(scene, |scene| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(setup, "setup")? };
        Ok(output.write(&sins_scene_setup {
            struct_size: size_of::<sins_scene_setup>() as u32,
            reserved: 0,
            flight: match scene.flight {
                FlightSource::Path(_) => SINS_SCENE_FLIGHT_MANOEUVRES,
                FlightSource::Builtin(_) => SINS_SCENE_FLIGHT_BUILTIN,
                FlightSource::Log(_) => SINS_SCENE_FLIGHT_LOG,
            },
            has_temperature: i32::from(scene.temperature.is_some()),
            quiet: i32::from(scene.output.quiet),
            is_random: i32::from(scene.is_random()),
            duration_s: scene.duration_s.unwrap_or(0.0),
            flown_s: scene.flown_s().unwrap_or(0.0),
            rate_hz: if scene.is_log() { 0.0 } else { scene.rate_hz },
            temperature_c: scene.temperature.map_or(0.0, |temperature| temperature.at_start_c),
            temperature_change_c_s: scene.temperature.map_or(0.0, |temperature| temperature.change_c_s),
            every_s: scene.output.every_s.unwrap_or(0.0),
        }))
    })
}

/// Reads the flight of the scene, composed of manoeuvres or built-in: its start, its manoeuvres, their number (count), and
/// how many times all of them are flown (repeat). manoeuvres[0].struct_size is the size in bytes of each element of
/// manoeuvres. start and repeat may be NULL. To ask for count only, give NULL for manoeuvres and a capacity of 0.
///
/// SINS_ERROR_BUFFER_TOO_SMALL: capacity is less than the number of manoeuvres; only count was written.
/// SINS_ERROR_BAD_STATE: the flight is a log; or as sins_scene_parse().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_get_manoeuvres(
    scene: *const sins_scene,
    start: *mut sins_flight_start,
    manoeuvres: *mut sins_manoeuvre,
    capacity: usize,
    count: *mut usize,
    repeat: *mut usize,
) -> sins_status {
    with_scene(scene, |scene| {
        let path = scene.path()?;
        // SAFETY: the host's promise.
        unsafe {
            let start = Output::if_wanted(start, "start")?;
            let places = Array::new(manoeuvres, capacity, "manoeuvres")?;
            put(count, path.manoeuvres.len(), "count")?;
            if capacity == 0 && manoeuvres.is_null() {
                return Ok(SINS_OK);
            }
            if capacity < path.manoeuvres.len() {
                return Err(CallError::buffer("capacity", capacity, path.manoeuvres.len()));
            }
            for (index, manoeuvre) in path.manoeuvres.iter().enumerate() {
                places.write(index, &sins_manoeuvre::from_manoeuvre(manoeuvre))?;
            }
            if let Some(start) = start {
                start.write(&sins_flight_start::from_parameters(&path.start));
            }
            put_if_wanted(repeat, path.repeat);
        }
        Ok(SINS_OK)
    })
}

/// Composes the flight of the scene of an array of count manoeuvres, all flown repeat times; count * repeat is at most 4096.
/// start->earth is ignored: the ellipsoid is that of the scene's options. If the flight was a log before, the new flight is
/// sampled at 100 Hz.
///
/// SINS_ERROR_INVALID_ARGUMENT: as sins_flight_create(), except that heights along the path are not checked.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_set_manoeuvres(
    scene: *mut sins_scene,
    start: *const sins_flight_start,
    manoeuvres: *const sins_manoeuvre,
    count: usize,
    repeat: usize,
) -> sins_status {
    with_scene(scene, |scene| {
        // SAFETY: the host's promise.
        let (mut start, manoeuvres) = unsafe { flight::read_flight(start, manoeuvres, count)? };
        start.ellipsoid = scene.options.ellipsoid;
        let path = FlightPath { start, manoeuvres, repeat };
        path.check_repeat("repeat")?;
        path.length_s()?;
        scene.flight = FlightSource::Path(path);
        Ok(SINS_OK)
    })
}
