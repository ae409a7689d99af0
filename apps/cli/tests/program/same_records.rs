//! The program and a C host, which uses the interface, give the same records to the bit for the same scenes. The host reads the
//! scene that `sins scene write` writes.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use sins::record::{COLUMNS, SIGMA_COLUMNS};

use crate::support::{done, folder, numbers, project_file, read, run};

/// Builds a C or C++ program with the library that was built with this test; the library is beside the test's own program.
pub fn link(name: &str, source: &str) -> PathBuf {
    let folder = folder(&format!("build_{name}"));
    let library = std::env::current_exe().unwrap().with_file_name("libsins.so");
    std::fs::copy(&library, folder.join("libsins.so")).unwrap();
    let program = folder.join(name);
    let (variable, compiler, standard) =
        if source.ends_with(".cpp") { ("CXX", "c++", "-std=c++11") } else { ("CC", "cc", "-std=c99") };
    let status = Command::new(std::env::var_os(variable).unwrap_or_else(|| compiler.into()))
        .args([standard, "-O1", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-o"])
        .arg(&program)
        .arg("-I")
        .arg(project_file("include"))
        .arg(project_file(source))
        .arg("-L")
        .arg(&folder)
        .args(["-lsins", "-lm", "-lpthread"])
        .arg(format!("-Wl,--disable-new-dtags,-rpath,{}", folder.display()))
        .status();
    assert!(status.unwrap().success());
    program
}

fn host() -> &'static Path {
    static HOST: OnceLock<PathBuf> = OnceLock::new();
    HOST.get_or_init(|| link("fly_scene", "apps/cli/tests/program/fly_scene.c"))
}

/// Number of columns that the host writes; they stand first.
const OF_HOST: usize = 51;

/// Asserts that the records of the program and of the host, one each `every_s` [s], are the same. Returns their number.
fn assert_same(name: &str, scene: &str, log: Option<&str>, settings: &[&str], every_s: f64) -> usize {
    let folder = folder(name);
    let every = format!("output.every_s={every_s}");
    let settings = [settings, &["--set", &every]].concat();
    done(&folder, &[&["fly", scene, "--quiet", "--name", "run"], &settings[..]].concat());
    std::fs::write(
        folder.join("scene.toml"),
        done(&folder, &[&["scene", "write", scene], &settings[..]].concat()),
    )
    .unwrap();
    let summary = read(folder.join("sins_out/run_summary.csv"));
    let figure = |key: &str| -> f64 {
        let begin = format!("{key},");
        let line = summary.lines().find_map(|line| line.strip_prefix(&begin)).unwrap();
        line.split(',').next().unwrap().parse().unwrap()
    };
    let samples = figure("steps") + 1.0;
    let every = (every_s * figure("rate_hz")).round();
    let output = Command::new(host())
        .args(["scene.toml", &samples.to_string(), &every.to_string()])
        .args(log)
        .current_dir(&folder)
        .output()
        .unwrap();
    assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    let expected = String::from_utf8(output.stdout).unwrap();
    let (columns, found) = numbers(&folder.join("sins_out/run.csv"));
    assert!(found.len() > 100 && expected.lines().count() == found.len(), "{name}: {} rows", found.len());
    for (line, row) in expected.lines().zip(&found) {
        let expected: Vec<f64> = line.split(',').map(|field| field.parse().unwrap()).collect();
        assert_eq!((expected.len(), row.len()), (OF_HOST, COLUMNS.len()));
        for ((column, expected), found) in columns.iter().zip(&expected).zip(row) {
            assert_eq!(expected.to_bits(), found.to_bits(), "{name}, {column} at {} s", row[0]);
        }
    }
    found.len()
}

#[test]
fn the_scenes_are_the_same() {
    let mut records = Vec::new();
    for (scene, log, every_s) in
        [("drone", None, 0.25), ("fighter", Some("fighter_aerobatics"), 0.5), ("trainer", None, 2.0)]
    {
        let file = project_file(&format!("c_examples/scenes/{scene}.toml"));
        let log = log.map(|log| project_file(&format!("c_examples/flights/{log}.csv")));
        let log = log.as_ref().and_then(|log| log.to_str());
        records.push(assert_same(scene, file.to_str().unwrap(), log, &[], every_s));
    }
    let patrol = project_file("c_examples/scenes/patrol.toml");
    let half_an_hour = ["--set", "flight.hours=0.5"];
    records.push(assert_same("patrol", patrol.to_str().unwrap(), None, &half_an_hour, 10.0));
    let (flights, records) = (records.len(), records.iter().sum::<usize>());
    println!("figure: to the bit: {flights} flights of scenes, {records} records");
}

#[test]
fn the_logs_are_the_same() {
    let mut records = Vec::new();
    for (log, preset) in [("airliner_cruise", "ideal"), ("fighter_aerobatics", "tactical")] {
        let file = project_file(&format!("c_examples/flights/{log}.csv"));
        let folder = folder(&format!("scene_{log}"));
        let scene = folder.join("scene.toml");
        let text = format!("[flight]\nfile = '{}'\n[options]\nerror_model = 'rk4'\n", file.display());
        std::fs::write(&scene, text).unwrap();
        let settings = ["--preset", preset];
        records.push(assert_same(log, scene.to_str().unwrap(), file.to_str(), &settings, 0.3));
    }
    let (flights, records) = (records.len(), records.iter().sum::<usize>());
    println!("figure: {flights} of logs, {records} records");
}

#[test]
fn the_built_in_scenes_are_the_same() {
    let hours = if cfg!(feature = "long-tests") { 48.0 } else { 0.5 };
    let hours = format!("flight.hours={hours}");
    let settings = ["--set", &hours];
    let mut records = Vec::new();
    for scene in ["simulation1", "simulation2"] {
        records.push(assert_same(scene, scene, None, &settings, 10.0));
        let at_rest = [&settings[..], &["--set", "flight.builtin=rest"]].concat();
        records.push(assert_same(&format!("{scene}_rest"), scene, None, &at_rest, 10.0));
    }
    for scene in ["over_the_pole", "aerobatics"] {
        let settings = ["--set", "options.error_model=rk4", "--preset", "navigation"];
        records.push(assert_same(scene, scene, None, &settings, 1.0));
    }
    let (flights, records) = (records.len(), records.iter().sum::<usize>());
    println!("figure: {flights} built-in, {records} records");
}

/// The example of a host ends each scene with the errors of the last record: navigation minus truth, and the errors of the error
/// model.
#[test]
fn the_example_host_ends_with_the_same_errors() {
    let host = link("harness", "c_examples/harness.c");
    let mut flights = 0;
    // The settings let each flight end at the time of a record, because the program writes no other times; or they lower the sample
    // rate.
    for (scene, settings) in [
        ("drone", &["flight.hours=0.045"][..]),
        ("fighter", &[]),
        ("patrol", &["flight.rate_hz=1", "flight.hours=2"]),
        ("trainer", &["flight.hours=0.85", "output.every_s=10"]),
    ] {
        let folder = folder(&format!("example_{scene}"));
        let file = project_file(&format!("c_examples/scenes/{scene}.toml"));
        let settings: Vec<&str> = settings.iter().flat_map(|setting| ["--set", setting]).collect();
        let file = file.to_str().unwrap();
        done(&folder, &[&["fly", file, "-q", "--name", "run"], &settings[..]].concat());
        let text = done(&folder, &[&["scene", "write", file], &settings[..]].concat());
        let logs = project_file("c_examples/flights");
        std::fs::write(folder.join("scene.toml"), text.replace("../flights", logs.to_str().unwrap()))
            .unwrap();
        let output = Command::new(&host).arg("scene.toml").current_dir(&folder).output().unwrap();
        assert!(output.status.success(), "{scene}: {}", String::from_utf8_lossy(&output.stderr));

        let printed = String::from_utf8(output.stdout).unwrap();
        let kinds = ["position m ", "velocity m/s ", "misalignment rad "];
        let rows = printed.lines().filter(|line| kinds.iter().any(|kind| line.starts_with(kind)));
        let found: Vec<[f64; 2]> = rows
            .map(|line| {
                let mut fields = line.split_whitespace().rev().map(|field| field.parse().unwrap());
                let model = fields.next().unwrap();
                [fields.next().unwrap(), model]
            })
            .collect();
        let (columns, records) = numbers(&folder.join("sins_out/run.csv"));
        let last = records.last().unwrap();
        let first = |name: &str| columns.iter().position(|column| column == name).unwrap();
        let [of_navigation, of_model] =
            ["navigation_error_position_east_m", "model_error_position_east_m"].map(first);
        let expected: Vec<[f64; 2]> = (0..9).map(|k| [last[of_navigation + k], last[of_model + k]]).collect();
        assert_eq!(found, expected, "{scene}");
        assert!(found[0][0] != 0.0, "{scene}");
        flights += 1;
    }
    println!("figure: the ends of {flights} by the example of a host");
}

/// Features that other crates of the program enable in common dependencies change no bit of the library: this build has the same
/// digests as C hosts.
#[test]
fn the_library_has_its_digests() {
    let output = Command::new(link("digests", "tests/c/digests.c")).output().unwrap();
    let words = String::from_utf8_lossy(&output.stdout);
    println!("{words}");
    assert!(output.status.success(), "{words}{}", String::from_utf8_lossy(&output.stderr));
}

/// The page about the files of a flight has each column that a flight with everything writes.
#[test]
fn every_column_has_its_place_in_the_docs() {
    let folder = folder("documented");
    let scene = project_file("c_examples/scenes/day.toml").display().to_string();
    let order = ["fly", &scene, "-q", "--hours", "0.01", "--imu", "imu.csv", "--bus", "bus.csv"];
    done(&folder, &[&order[..], &["--name", "f", "--set", "options.covariance=on"]].concat());
    let page = read(project_file("docs/records.md"));
    let mut count = 0;
    for file in ["f.csv", "f_unit.csv", "imu.csv", "bus.csv"] {
        for column in read(folder.join("sins_out").join(file)).lines().next().unwrap().split(',') {
            assert!(page.contains(&format!("`{column}`")), "{file}: {column}");
            count += 1;
        }
    }
    assert_eq!(count, COLUMNS.len() + SIGMA_COLUMNS.len() + 5 + 10 + 6);
    let smoothed = project_file("c_examples/scenes/cockpit.toml").display().to_string();
    assert_eq!(run(&folder, &["fly", &smoothed, "-q", "--hours", "0.01", "--name", "c"]).0, 0);
    let rows = read(folder.join("sins_out/c_rows.csv"));
    let mut lines = rows.lines();
    assert!(lines.next().unwrap().split(',').all(|column| page.contains(&format!("`{column}`"))));
    // 36 s of 5 Hz, and no row behind the last record.
    let times: Vec<f64> = lines.map(|line| line.split(',').next().unwrap().parse().unwrap()).collect();
    let [first, last] = [times[0], times[times.len() - 1]];
    assert!((170..190).contains(&times.len()) && (35.0..=36.01).contains(&(last - first)), "{first} {last}");
    let summary = read(folder.join("sins_out/f_summary.csv"));
    assert!(page.contains(&format!("`{}`", summary.lines().next().unwrap())));
}
