//! The program flies as a C host does through the interface: the records of the four scenes, of both logs and of both simulations are
//! those of the C harness, to the bit.

#[path = "support/program.rs"]
mod program;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use program::{done, folder, numbers, project_file};

/// A C program with the library that was built with this test: it lies beside the test's own program.
fn link(name: &str, sources: &[PathBuf]) -> PathBuf {
    let folder = folder(&format!("build_{name}"));
    let library = std::env::current_exe().unwrap().with_file_name("libsins.so");
    for name in ["libsins.so", "libsins.so.1"] {
        std::fs::copy(&library, folder.join(name)).unwrap();
    }
    let program = folder.join(name);
    let status = Command::new(std::env::var_os("CC").unwrap_or_else(|| "cc".into()))
        .args(["-std=c99", "-O1", "-o"])
        .arg(&program)
        .arg("-I")
        .arg(project_file("include"))
        .args(sources)
        .arg("-L")
        .arg(&folder)
        .args(["-lsins", "-lm", "-lpthread"])
        .arg(format!("-Wl,-rpath,{}", folder.display()))
        .status();
    assert!(status.unwrap().success());
    program
}

fn harness() -> &'static Path {
    static HARNESS: OnceLock<PathBuf> = OnceLock::new();
    HARNESS.get_or_init(|| {
        let files = std::fs::read_dir(project_file("c_examples/harness")).unwrap();
        let files = files.map(|entry| entry.unwrap().path());
        let mut sources: Vec<PathBuf> =
            files.filter(|path| path.extension().is_some_and(|ending| ending == "c")).collect();
        sources.push(project_file("c_examples/sins_harness.c"));
        link("sins_harness", &sources)
    })
}

/// Both write the same records.
fn assert_same(name: &str, of_harness: &[&str], of_program: &[&str]) {
    let folder = folder(name);
    let status = Command::new(harness())
        .args(of_harness)
        .args(["--quiet", "--out", "harness", "--name", "run"])
        .current_dir(&folder)
        .status();
    assert!(status.unwrap().success(), "{of_harness:?}");
    let own = ["--quiet", "--out", "program", "--name", "run"];
    done(&folder, &[&["fly"], of_program, &own].concat());

    let (old_names, expected) = numbers(&folder.join("harness/run.csv"));
    let (names, found) = numbers(&folder.join("program/run.csv"));
    let renamed = |name: &String| {
        let name = name.replace("error2_", "navigation_error_").replace("error1_", "model_error_");
        name.strip_prefix("nav_").map_or(name.clone(), |end| format!("navigation_{end}"))
    };
    assert_eq!(names, old_names.iter().map(renamed).collect::<Vec<_>>());
    assert!(expected.len() > 100 && found.len() == expected.len(), "{name}: {} rows", expected.len());
    for (row, own_row) in expected.iter().zip(&found) {
        for ((column, expected), found) in names.iter().zip(row).zip(own_row) {
            assert_eq!(expected.to_bits(), found.to_bits(), "{name}, {column} at {} s", row[0]);
        }
    }
    println!("{name}: {} records, the same to the bit", expected.len());
}

#[test]
fn the_scenes_are_the_same() {
    for scene in ["drone", "fighter", "trainer"] {
        let file = project_file(&format!("c_examples/scenes/{scene}.toml"));
        let file = file.to_str().unwrap();
        assert_same(scene, &[file], &[file]);
    }
}

#[test]
fn the_logs_are_the_same() {
    for log in ["airliner_cruise", "fighter_aerobatics"] {
        let file = project_file(&format!("c_examples/flights/{log}.csv"));
        let file = file.to_str().unwrap();
        assert_same(log, &["flight", file], &[file]);
        // Every third record of sensors whose errors are means in between.
        let name = format!("{log}_sensors");
        let harness = ["flight", file, "--preset", "tactical", "--every", "0.3"];
        let program = ["--log", file, "--preset", "tactical", "--set", "output.every_s=0.3"];
        assert_same(&name, &harness, &program);
    }
}

/// The paper's simulations last 48 h, and so does the patrol that is built in; for a shorter one the eights end where the flight does,
/// as the harness makes them.
#[test]
fn the_simulations_are_the_same() {
    let is_long = cfg!(feature = "long-tests");
    let hours = if is_long { 48.0 } else { 0.5 };
    let (text, set) = (hours.to_string(), format!("flight.hours={hours}"));
    let eights = folder("eights").join("patrol.toml");
    let scene = done(eights.parent().unwrap(), &["scene", "write", "patrol"]);
    let long = "duration_s = 172800 ";
    assert!(scene.contains(long), "{scene}");
    std::fs::write(&eights, scene.replace(long, &format!("duration_s = {} ", hours * 3600.0))).unwrap();
    let eights = eights.to_str().unwrap();
    for (simulation, preset) in [("simulation1", "ideal"), ("simulation2", "paper2")] {
        let end = ["--hours", &text, "--every", "2"];
        let own_end = ["--set", &set, "--set", "output.every_s=2"];
        let harness = [&[simulation], &end[..]].concat();
        let options = ["--set", "options.vertical=follow", "--set", "options.error_model=rk4", "--preset", preset];
        let program = match is_long {
            true => [&[simulation], &own_end[..]].concat(),
            false => [&[eights], &options[..], &own_end[..]].concat(),
        };
        assert_same(&format!("{simulation}_patrol"), &harness, &program);
        let harness = [&[simulation, "--motion", "rest"], &end[..]].concat();
        let program = [&[simulation, "--set", "flight.builtin=rest"], &own_end[..]].concat();
        assert_same(&format!("{simulation}_rest"), &harness, &program);
    }
    if is_long {
        let patrol = project_file("c_examples/scenes/patrol.toml");
        let patrol = patrol.to_str().unwrap();
        assert_same("patrol", &[patrol], &[patrol]);
    }
}

/// Features that other crates of the program switch on in common dependencies change no bit of the library: its digests in this build
/// are those that C hosts have.
#[test]
fn the_library_has_its_digests() {
    let program = link("digests", &[project_file("tests/c/digests.c")]);
    let output = Command::new(program).output().unwrap();
    let words = String::from_utf8_lossy(&output.stdout);
    println!("{words}");
    assert!(output.status.success(), "{words}{}", String::from_utf8_lossy(&output.stderr));
}

/// What a program of C gets of the library, this one gets: the measured increments, too.
#[test]
fn the_increments_are_the_same() {
    let folder = folder("increments");
    let scene = project_file("c_examples/scenes/fighter.toml");
    let scene = scene.to_str().unwrap();
    let status = Command::new(harness())
        .args([scene, "--quiet", "--out", "harness", "--imu", "imu.csv"])
        .current_dir(&folder)
        .status();
    assert!(status.unwrap().success());
    done(&folder, &["fly", scene, "--quiet", "--out", "program", "--imu", "imu.csv"]);
    let (expected, found) = (numbers(&folder.join("imu.csv")), numbers(&folder.join("program/imu.csv")));
    assert!(expected == found && expected.1.len() == 30_000);
}
