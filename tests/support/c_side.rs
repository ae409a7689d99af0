//! Building and running C and C++ programs against the shared library of this build.
#![allow(dead_code)] // each test uses a part of it

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Warnings are errors, in both languages.
pub const STRICT: [&str; 4] = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"];

/// A file of the project.
pub fn project_file(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The shared library that was built with this test: it lies beside the test's own program.
pub fn shared_library() -> PathBuf {
    let program = std::env::current_exe().unwrap();
    let library = program.with_file_name("libsins.so");
    assert!(library.exists(), "{} is missing", library.display());
    library
}

/// A folder of this test's own with the library under both of its names.
pub fn library_folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).unwrap();
    for file in ["libsins.so", "libsins.so.1"] {
        std::fs::copy(shared_library(), folder.join(file)).unwrap();
    }
    folder
}

pub fn c_compiler() -> Command {
    Command::new(std::env::var_os("CC").unwrap_or_else(|| "cc".into()))
}

pub fn cpp_compiler() -> Command {
    Command::new(std::env::var_os("CXX").unwrap_or_else(|| "c++".into()))
}

/// Runs a command to its end and asserts its success.
pub fn succeed(command: &mut Command) -> Output {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(
        output.status.success(),
        "{command:?}: {}\n{}\n{}",
        output.status,
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
    output
}

/// Compiles `sources` (relative to the project) into `program` in `folder`, linked with the library there.
pub fn link(
    mut compiler: Command,
    flags: &[&str],
    sources: &[&str],
    folder: &Path,
    program: &str,
) -> PathBuf {
    let path = folder.join(program);
    compiler.args(flags).args(STRICT).arg("-I").arg(project_file("include"));
    for source in sources {
        compiler.arg(project_file(source));
    }
    compiler.arg("-o").arg(&path).arg("-L").arg(folder).args(["-lsins", "-lm", "-lpthread", "-ldl"]);
    compiler.arg(format!("-Wl,-rpath,{}", folder.display()));
    succeed(&mut compiler);
    path
}

/// Builds and runs `tests/c/NAME.c`.
pub fn run_test_program(name: &str) {
    let folder = library_folder(name);
    succeed(&mut test_program(name, &folder));
}

/// `tests/c/NAME.c`, built in `folder`.
pub fn test_program(name: &str, folder: &Path) -> Command {
    let source = format!("tests/c/{name}.c");
    Command::new(link(c_compiler(), &["-std=c99", "-O1"], &[&source], folder, name))
}
