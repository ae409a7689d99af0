//! The harness, built for a test of scenes, and run.
#![allow(dead_code)] // each test uses a part of it

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use crate::c_side::{c_compiler, harness_sources, library_folder, link};

/// Reading beyond a buffer, or arithmetic without a meaning, ends the program.
pub const SANITIZED: [&str; 4] = ["-std=c99", "-O1", "-fsanitize=address,undefined", "-fno-sanitize-recover"];

/// A program of the harness's files and one more, built once.
pub fn build(folder: &Path, main: &str, flags: &[&str], program: &str) -> PathBuf {
    let mut sources = harness_sources();
    sources[0] = main.to_owned();
    let sources: Vec<&str> = sources.iter().map(String::as_str).collect();
    link(c_compiler(), flags, &sources, folder, program)
}

pub fn harness() -> &'static Path {
    static HARNESS: OnceLock<PathBuf> = OnceLock::new();
    HARNESS.get_or_init(|| {
        let folder = library_folder(env!("CARGO_CRATE_NAME"));
        build(&folder, "c_examples/sins_harness.c", &["-std=c99", "-O1"], "sins_harness")
    })
}

/// A folder of a test's own, empty.
pub fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(env!("CARGO_CRATE_NAME")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Runs the harness in a folder. Exit code and standard error.
pub fn run(folder: &Path, arguments: &[&str]) -> (i32, String) {
    let output = Command::new(harness()).args(arguments).current_dir(folder).output().unwrap();
    (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
}
