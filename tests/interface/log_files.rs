//! Logs whose columns stand in several files, by `sins_log_parse`: the host gives each file by its name.

use std::ffi::CString;
use std::ptr::null_mut;

use sins::abi::*;
use sins::log::FlightLog;
use sins::scene::Scene;

use crate::support::{init, text};

const POSITIONS: &str =
    "TimeUS,Lat,Lng,Alt\n0,48,11,300\n100000,48,11,300\n200000,48,11,300\n300000,48,11,300\n";
const ATTITUDES: &str = "TimeUS,Roll,Pitch,Yaw\n0,0,2,350\n200000,10,4,10\n400000,20,4,10\n";
const TEMPERATURES: &str = "TimeUS,T\n0,10\n500000,20\n";
const KEYS: &str = "time = { col = \"TimeUS\", unit = \"us\" }\nlatitude = \"Lat\"\nlongitude = \"Lng\"\nheight = \"Alt\"\n\
    roll = { col = \"Roll\", file = \"ATT.csv\" }\npitch = { col = \"Pitch\", file = \"ATT.csv\" }\n\
    heading = { col = \"Yaw\", file = \"ATT.csv\" }\n";
const TEMPERATURE_KEY: &str = "temperature = { col = \"T\", file = \"ARSP.csv\" }\n";

/// A scene that flies POS.csv with these lines of `[log]`, and its handle.
fn scene(keys: &str) -> (Scene, *mut sins_scene) {
    let scene = format!("[flight]\nfile = \"POS.csv\"\n[log]\n{keys}");
    let mut handle = null_mut();
    // SAFETY: a text with its size, a place for a handle.
    let status = unsafe { sins_scene_parse(scene.as_ptr().cast(), scene.len(), &mut handle) };
    assert_eq!(status, SINS_OK);
    (Scene::parse(scene.as_bytes()).unwrap(), handle)
}

fn give(scene: *mut sins_scene, name: &str, text: &str) -> sins_status {
    let name = CString::new(name).unwrap();
    // SAFETY: a handle, a terminated name, a text with its size.
    unsafe { sins_scene_give_log_file(scene, name.as_ptr(), text.as_ptr().cast(), text.len()) }
}

/// The names of the files beside the log.
fn names(scene: *const sins_scene) -> Vec<String> {
    let mut names = Vec::new();
    let mut name = [0; 64];
    // SAFETY: a handle, a buffer with its size.
    let next = |index, name: &mut [core::ffi::c_char; 64]| unsafe {
        sins_scene_log_file_name(scene, index, name.as_mut_ptr(), name.len(), null_mut())
    };
    while next(names.len(), &mut name) == SINS_OK {
        names.push(text(&name));
    }
    names
}

/// The samples of the positions joined with what was given, or the line and the sentence of the fault.
fn samples(scene: *mut sins_scene) -> Result<Vec<sins_flight_sample>, (u64, String)> {
    let (mut log, mut fault, mut info) = (null_mut(), init::<sins_fault>(), init::<sins_log_info>());
    // SAFETY: a text with its size, living handles, structs of the interface.
    unsafe {
        let status = sins_log_parse(POSITIONS.as_ptr().cast(), POSITIONS.len(), scene, &mut log, &mut fault);
        if status != SINS_OK {
            assert!(status == SINS_ERROR_INVALID_ARGUMENT && log.is_null());
            return Err((fault.line, text(&fault.sentence)));
        }
        assert_eq!(sins_log_get_info(log, &mut info), SINS_OK);
        let sample = |index| {
            let (mut sample, mut line) = (init::<sins_flight_sample>(), 0);
            assert_eq!(sins_log_get_sample(log, index, &mut sample, &mut line), SINS_OK);
            assert_eq!(line, index as u64 + 2);
            sample
        };
        let samples = (0..info.samples as usize).map(sample).collect();
        // The scene flies what it has read.
        let mut count = init::<sins_scene_samples>();
        assert_eq!(sins_scene_get_samples(scene, log, &mut count), SINS_OK);
        assert_eq!(sins_log_destroy(log), SINS_OK);
        Ok(samples)
    }
}

/// The samples have the bits of those that `FlightLog::parse_files` gives.
#[test]
fn files_that_the_host_gives_are_joined() {
    let (own, handle) = scene(&format!("{KEYS}{TEMPERATURE_KEY}"));
    assert_eq!(names(handle), ["ARSP.csv", "ATT.csv"]);
    assert_eq!([give(handle, "ATT.csv", ATTITUDES), give(handle, "ARSP.csv", TEMPERATURES)], [SINS_OK; 2]);
    let read = |name: &str| Ok::<_, ()>(if name == "ATT.csv" { ATTITUDES } else { TEMPERATURES });
    let expected = FlightLog::parse_files(POSITIONS.as_bytes(), &own.log, read).unwrap();
    let found = samples(handle).unwrap();
    assert_eq!(found.len(), 4);
    for (found, expected) in found.iter().zip(expected.samples()) {
        let rolls = [found.roll_rad, expected.euler.roll].map(f64::to_bits);
        let headings = [found.heading_rad, expected.euler.heading].map(f64::to_bits);
        assert!(rolls[0] == rolls[1] && headings[0] == headings[1], "{found:?}, not {expected:?}");
        assert_eq!(Some(found.temperature_c.to_bits()), expected.temperature_c.map(f64::to_bits));
    }
    // Between the rows of the file: half the way from 0 to 10 deg.
    assert!((found[1].roll_rad - 5_f64.to_radians()).abs() < 4.0 * f64::EPSILON, "{:?}", found[1]);
    // A file that is given again replaces the one before.
    assert_eq!(give(handle, "ATT.csv", &ATTITUDES.replace("200000,10", "200000,40")), SINS_OK);
    assert!((samples(handle).unwrap()[1].roll_rad - 20_f64.to_radians()).abs() < 4.0 * f64::EPSILON);
    // SAFETY: a living handle.
    assert_eq!(unsafe { sins_scene_destroy(handle) }, SINS_OK);
}

/// What is missing, what no `[log]` names, and faults with the name of their file.
#[test]
fn missing_and_broken_files_are_named() {
    let (_, handle) = scene(KEYS);
    let missing = (0, "log: ATT.csv is not given; sins_scene_give_log_file() gives its contents".to_owned());
    assert_eq!(samples(handle).unwrap_err(), missing);
    for name in ["att.csv", "POS.csv", "", "../ATT.csv"] {
        assert_eq!(give(handle, name, ATTITUDES), SINS_ERROR_INVALID_ARGUMENT, "{name}");
    }
    assert_eq!(samples(handle).unwrap_err(), missing);
    assert_eq!(give(handle, "ATT.csv", &ATTITUDES.replace("10,4,10", "10,x,10")), SINS_OK);
    let (line, sentence) = samples(handle).unwrap_err();
    assert!(line == 0 && sentence.starts_with("ATT.csv:3: "), "{line} {sentence}");
    // A rejected file leaves the one that was given.
    assert_eq!(give(handle, "ATT.csv", ATTITUDES), SINS_OK);
    assert_eq!(give(handle, "other.csv", "x"), SINS_ERROR_INVALID_ARGUMENT);
    assert_eq!(samples(handle).unwrap().len(), 4);
    // The attitude of a coordinated flight is not read: no file is asked for.
    let (_, coordinated) = scene(&format!("{KEYS}attitude = \"coordinated\"\n"));
    assert!(names(coordinated).is_empty() && give(coordinated, "ATT.csv", ATTITUDES) < 0);
    // SAFETY: living handles.
    assert_eq!(unsafe { [sins_scene_destroy(handle), sins_scene_destroy(coordinated)] }, [SINS_OK; 2]);
}
