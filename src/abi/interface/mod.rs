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

/// In the order in which a reader of the header wants them.
const SOURCES: [&str; 43] = [
    "version",
    "failure",
    "options",
    "simulator",
    "last_error",
    "gyro",
    "accel",
    "altimeter",
    "sensor_failure",
    "initial",
    "mounting",
    "gravity",
    "sample",
    "run",
    "solution",
    "imu",
    "errors",
    "accuracy",
    "truth_summary",
    "covariance",
    "record",
    "navigator",
    "snapshot",
    "ensemble",
    "ensemble_read",
    "../statistics/layout",
    "statistics",
    "ensemble_snapshot",
    "preset",
    "manoeuvre",
    "flight",
    "scene",
    "scene_prepare",
    "fault_report",
    "scene_settings",
    "scene_flight",
    "scene_failure",
    "scene_key",
    "scene_value",
    "log",
    "recommend",
    "budget",
    "budget_answer",
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
    let sources = SOURCES.iter().map(|name| read(&format!("{name}.rs")));
    let sources: Vec<String> = sources.chain([sensor_params.to_owned()]).collect();
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
