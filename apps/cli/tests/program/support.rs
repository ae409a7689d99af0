//! Runs the program in a separate folder for each test.

use std::collections::HashMap;
use std::panic::Location;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A file of the project.
pub fn project_file(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

/// An empty folder for one test. Its name must differ from the names of other folders of the same file.
#[track_caller]
pub fn folder(name: &str) -> PathBuf {
    let file = Path::new(Location::caller().file()).with_extension("");
    let folder =
        Path::new(env!("CARGO_TARGET_TMPDIR")).join("program").join(file.file_name().unwrap()).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Command that runs the program in `folder`. `SINS_PROGRAM` can name another program (tests/windows_program.sh).
pub fn sins(folder: &Path, arguments: &[&str]) -> Command {
    let program = std::env::var_os("SINS_PROGRAM").unwrap_or_else(|| env!("CARGO_BIN_EXE_sins").into());
    let mut command = Command::new(program);
    command.args(arguments).current_dir(folder).stdin(Stdio::null());
    command
}

/// Exit code, standard output and standard error.
pub fn run(folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    result(&sins(folder, arguments).output().unwrap())
}

pub fn result(output: &Output) -> (i32, String, String) {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    // wine itself writes to the standard error of a program that ends while the machine is busy.
    let is_own = |line: &&str| !(cfg!(windows) && line.starts_with("wine client error:"));
    let text = |bytes: &[u8]| text(bytes).split_inclusive('\n').filter(is_own).collect();
    (output.status.code().unwrap_or(-1), text(&output.stdout), text(&output.stderr))
}

/// Runs the program, which has to succeed, and returns its output.
pub fn done(folder: &Path, arguments: &[&str]) -> String {
    let (code, said, errors) = run(folder, arguments);
    assert_eq!((code, errors.as_str()), (0, ""), "{arguments:?}");
    said
}

/// Runs the program, which has to reject its arguments, and returns its message.
pub fn rejected(folder: &Path, arguments: &[&str]) -> String {
    let (code, said, errors) = run(folder, arguments);
    assert_eq!((code, said.as_str()), (2, ""), "{arguments:?}: {errors}");
    errors
}

pub fn read(path: impl AsRef<Path>) -> String {
    let path = path.as_ref();
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Sorted names of all entries of a folder.
pub fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// A row of a table by the names of its columns.
pub type Row = HashMap<String, String>;

/// The rows of a table.
pub fn rows(path: &Path) -> Vec<Row> {
    let mut reader = csv::Reader::from_path(path).unwrap();
    reader.deserialize().map(Result::unwrap).collect()
}

/// A number in a row.
pub fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column}: {row:?}"))
}

/// Names and rows of a file of numbers.
pub fn numbers(path: &Path) -> (Vec<String>, Vec<Vec<f64>>) {
    let text = read(path);
    let mut lines = text.lines();
    let names = lines.next().unwrap().split(',').map(str::to_owned).collect();
    let row = |line: &str| line.split(',').map(|field| field.parse().unwrap()).collect();
    (names, lines.map(row).collect())
}

/// The columns of a flight log.
pub const HEADER: &str = "time_s,latitude_rad,longitude_rad,height_m,roll_rad,pitch_rad,heading_rad";

/// A flight log of ten seconds at rest.
pub fn log() -> String {
    let rows: String = (0..=10).map(|t| format!("{t},0.7,2.0,50,0,0,1\n")).collect();
    format!("{HEADER}\n{rows}")
}

/// A folder with the log of `log` in logs/mylog.csv.
#[track_caller]
pub fn with_log(name: &str) -> PathBuf {
    let folder = folder(name);
    std::fs::create_dir(folder.join("logs")).unwrap();
    std::fs::write(folder.join("logs/mylog.csv"), log()).unwrap();
    folder
}
