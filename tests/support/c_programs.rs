//! Building and running C and C++ programs against the shared library of this build.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use super::project_file;

/// Warnings are errors, in both languages.
pub const STRICT: [&str; 4] = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"];

/// The shared library that was built with this test, in the folder of the test's own program.
pub fn shared_library() -> PathBuf {
    let program = std::env::current_exe().unwrap();
    let library = program.with_file_name("libsins.so");
    assert!(library.exists(), "{} is missing", library.display());
    library
}

/// A folder for one test, with a copy of the library.
pub fn library_folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::copy(shared_library(), folder.join("libsins.so")).unwrap();
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
    // An RPATH takes precedence over LD_LIBRARY_PATH. Cargo puts target/debug there, which may have an old library of
    // `cargo build`.
    compiler.arg(format!("-Wl,--disable-new-dtags,-rpath,{}", folder.display()));
    succeed(&mut compiler);
    path
}

/// The standards for which C sources compile without warnings.
pub const C_AND_CPP: [&str; 3] = ["c99", "c++11", "c++17"];

/// The compiler for a standard, and the language for its option -x.
pub fn compiler_of(standard: &str) -> (Command, &'static str) {
    match standard.starts_with("c++") {
        true => (cpp_compiler(), "c++"),
        false => (c_compiler(), "c"),
    }
}

/// A program built to a standard of C or C++.
pub fn built_to(standard: &str, sources: &[&str], folder: &Path, program: &str) -> PathBuf {
    let (compiler, language) = compiler_of(standard);
    let standard = format!("-std={standard}");
    link(compiler, &["-x", language, &standard], sources, folder, program)
}

/// The output of a program, which must be the same for each standard.
pub fn prints_alike(name: &str, sources: &[&str], standards: &[&str], arguments: &[&str]) -> String {
    let folder = library_folder(name);
    let mut texts = standards.iter().map(|standard| {
        let program = built_to(standard, sources, &folder, &format!("{name}_{standard}"));
        let output = succeed(Command::new(program).args(arguments).current_dir(&folder));
        String::from_utf8(output.stdout).unwrap()
    });
    let first = texts.next().unwrap();
    texts.zip(&standards[1..]).for_each(|(text, standard)| assert_eq!(text, first, "{name} as {standard}"));
    first
}

/// Builds and runs `tests/c/NAME.c`.
pub fn run_test_program(name: &str) {
    let folder = library_folder(name);
    let output = succeed(&mut test_program(name, &folder));
    print!("{}", String::from_utf8_lossy(&output.stdout));
}

/// `tests/c/NAME.c`, built in `folder`.
pub fn test_program(name: &str, folder: &Path) -> Command {
    let source = format!("tests/c/{name}.c");
    Command::new(link(c_compiler(), &["-std=c99", "-O1"], &[&source], folder, name))
}
