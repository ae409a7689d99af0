//! Writes the interface for other languages from its Rust sources. `read` reads the sources into a `model`; each other file writes
//! one language. Only `build.rs` uses this folder.

mod ada;
mod c_functions;
mod c_header;
mod c_types;
mod fortran;
mod model;
mod python;
mod read;
pub mod sensor_structs;
mod sizes;
mod text;
mod units;

use std::fs;
use std::path::Path;

use model::Interface;

/// Subjects in the order in which a reader of the header wants them, with their sources.
const SUBJECTS: [(&str, &[&str]); 17] = [
    ("Version and statuses", &["version", "failure"]),
    ("Simulator", &["options", "simulator"]),
    ("Why a call failed", &["last_error"]),
    ("Sensor errors", &["gyro", "accel", "altimeter"]),
    ("Failures of sensors", &["sensor_failure"]),
    ("Start, mounting, gravity", &["initial", "mounting", "gravity"]),
    ("Many samples in one call", &["sample", "run"]),
    (
        "Reads",
        &["solution", "imu", "errors", "accuracy", "truth_summary", "covariance", "record", "record_line"],
    ),
    ("Navigation on increments", &["navigator"]),
    ("Snapshots", &["snapshot"]),
    (
        "Ensembles and statistics",
        &["ensemble", "ensemble_read", "../statistics/layout", "statistics", "ensemble_snapshot"],
    ),
    ("Presets of sensors", &["preset"]),
    ("Embedded flights", &["manoeuvre", "flight"]),
    (
        "Scenes",
        &[
            "scene",
            "scene_prepare",
            "fault_report",
            "scene_settings",
            "scene_flight",
            "scene_text",
            "scene_failure",
        ],
    ),
    ("Values of a scene by their paths", &["scene_key", "scene_value"]),
    ("Flight logs, and the samples of a scene", &["log", "scene_samples"]),
    ("Which options, which effects matter", &["recommend", "budget", "budget_answer"]),
];

/// A file for hosts: its path in the project, and its text.
pub type Output = (&'static str, String);

/// All files, of the sources in `abi` and of the structs in `sensor_params`; and for the crate the check of the sizes.
pub fn generate(abi: &Path, sensor_params: &str) -> (Vec<Output>, String) {
    let read = |name: &str| {
        let path = abi.join(name);
        fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    };
    let preamble = read("preamble.h");
    let of_subject = |&(subject, names): &(_, &[&str])| {
        names.iter().map(|name| (subject, read(&format!("{name}.rs")))).collect::<Vec<_>>()
    };
    let sources: Vec<_> =
        SUBJECTS.iter().flat_map(of_subject).chain([("", sensor_params.to_owned())]).collect();
    let interface = Interface::read(&preamble, &sources);
    let outputs = vec![
        ("include/sins.h", c_header::write(&interface, &preamble)),
        ("include/sins_functions.h", c_functions::write(&interface)),
        ("c_examples/fortran/sins.f90", fortran::write(&interface)),
        ("c_examples/ada/sins.ads", ada::write(&interface)),
        ("c_examples/python/sins.py", python::write(&interface)),
    ];
    (outputs, sizes::check(&interface))
}
