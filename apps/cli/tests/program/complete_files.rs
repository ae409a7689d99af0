//! Files are complete or absent: after signals, with several runs of one name. What was flown is kept: on a full disk, when the terminal
//! is closed.

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::support::{done, folder, names, numbers, project_file, read, result, sins};

/// Waits until a temporary file exists.
fn wait_for_part(out: &Path) {
    let deadline = Instant::now() + Duration::from_secs(60);
    while !out.exists() || !names(out).iter().any(|name| name.ends_with(".part")) {
        assert!(Instant::now() < deadline, "no temporary file came");
        std::thread::sleep(Duration::from_millis(20));
    }
}

fn signal(child: &Child, name: &str) {
    // The built-in kill of the shell, because not every machine has the program kill.
    let order = format!("kill -{name} {}", child.id());
    assert!(Command::new("sh").args(["-c", &order]).status().unwrap().success());
}

#[test]
fn a_signal_leaves_whole_files_and_no_temporary_one() {
    for name in ["INT", "TERM", "HUP"] {
        let folder = folder(&format!("signal_{name}"));
        let out = folder.join("sins_out");
        let child = sins(&folder, &["fly", "simulation2", "--set", "output.every_s=1"])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        wait_for_part(&out);
        std::thread::sleep(Duration::from_millis(300));
        signal(&child, name);
        let (code, said, errors) = result(&child.wait_with_output().unwrap());
        assert_eq!(code, 130, "{name}: {errors}");
        assert!(errors.contains("interrupted") && said.contains("stopped before the end"), "{said}{errors}");
        assert_eq!(names(&out), ["simulation2.csv", "simulation2_summary.csv"]);
        let (columns, rows) = numbers(&out.join("simulation2.csv"));
        assert!(rows.iter().all(|row| row.len() == columns.len()), "every row is whole");
        assert!(read(out.join("simulation2_summary.csv")).contains("interrupted,1,"));
    }
    // A survey has no results before its end.
    let folder = folder("signal_survey");
    let out = folder.join("out");
    let child = sins(&folder, &["budget", "simulation2", "--hours", "48", "-o", "out"])
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    wait_for_part(&out);
    signal(&child, "TERM");
    assert_eq!(child.wait_with_output().unwrap().status.code(), Some(130));
    assert_eq!(names(&out), [""; 0]);
}

/// A program that was killed leaves its temporary files. The next output into the folder removes them, and none that is being written.
#[test]
#[cfg(unix)]
fn the_temporary_files_of_a_killed_program_are_removed() {
    let folder = folder("killed");
    let out = folder.join("sins_out");
    let long = ["fly", "simulation2", "-q", "--set", "output.every_s=1", "--name", "long"];
    let mut killed = sins(&folder, &long).spawn().unwrap();
    wait_for_part(&out);
    signal(&killed, "KILL");
    killed.wait().unwrap();
    let parts = || names(&out).into_iter().filter(|name| name.ends_with(".part")).collect::<Vec<_>>();
    let left = parts();
    assert!(!left.is_empty());
    std::fs::write(out.join("another.part"), "of another program").unwrap();
    std::fs::write(out.join(".sins-notes.part"), "of a user").unwrap();
    let mut living = sins(&folder, &[&long[..5], &["--name", "living"]].concat()).spawn().unwrap();
    let own = [".sins-living.csv.part", ".sins-living_summary.csv.part"];
    let expected = [&own[..], &[".sins-notes.part", "another.part"]].concat();
    let deadline = Instant::now() + Duration::from_secs(60);
    while parts() != expected {
        assert!(Instant::now() < deadline, "{:?}", parts());
        std::thread::sleep(Duration::from_millis(20));
    }
    done(&folder, &["fly", "rest", "-q", "--set", "flight.hours=0.01"]);
    assert_eq!(parts(), expected, "files that are being written");
    signal(&living, "KILL");
    living.wait().unwrap();
    done(&folder, &["fly", "rest", "-q", "--set", "flight.hours=0.01"]);
    assert_eq!(parts(), expected[2..]);
}

/// When a terminal is closed, the system and the shell send a signal each.
#[test]
fn two_signals_of_a_closed_terminal_are_one() {
    let folder = folder("hung_up");
    let out = folder.join("sins_out");
    let child = sins(&folder, &["fly", "simulation2", "-q"]).stderr(Stdio::piped()).spawn().unwrap();
    wait_for_part(&out);
    std::thread::sleep(Duration::from_millis(300));
    signal(&child, "HUP");
    signal(&child, "HUP");
    assert_eq!(child.wait_with_output().unwrap().status.code(), Some(130));
    assert!(read(out.join("simulation2_summary.csv")).contains("interrupted,1,"));
    assert_eq!(names(&out), ["simulation2.csv", "simulation2_summary.csv"]);
}

/// Of several runs of one name at the same time, one flies: the files of all were those of different runs otherwise.
#[test]
fn two_runs_of_one_name_do_not_mix() {
    let folder = folder("two_runs");
    let order = |seed: &str| {
        let seed = format!("options.seed={seed}");
        let scene = ["fly", "simulation2", "-q", "--set", "flight.hours=0.1", "--set", "output.every_s=0.1"];
        let mut run = sins(&folder, &[&scene[..], &["--set", &seed]].concat());
        run.stderr(Stdio::piped()).spawn().unwrap()
    };
    let runs = ["1", "2", "3"].map(order).map(|run| result(&run.wait_with_output().unwrap()));
    assert!(runs.iter().any(|(code, ..)| *code == 0), "{runs:?}");
    for (code, _, errors) in &runs {
        let is_refused = *code == 2 && errors.contains("another run of sins is writing it");
        assert!(*code == 0 || is_refused, "{code}: {errors}");
    }
    assert_eq!(names(&folder.join("sins_out")), ["simulation2.csv", "simulation2_summary.csv"]);
    let (columns, rows) = numbers(&folder.join("sins_out/simulation2.csv"));
    assert!(rows.len() == 3601 && rows.iter().all(|row| row.len() == columns.len()));
    // The same holds for the other commands.
    for (order, name) in [
        (&["ensemble", "rest", "--preset", "navigation", "--runs", "8", "-q"][..], "rest_ensemble.csv"),
        (&["report", "sins_out/simulation2.csv"], "report.html"),
        (&["allan", "imu.csv", "--rate", "1", "-o", "sins_out/a.svg"], "a.svg"),
        (&["budget", "rest", "-o", "sins_out"], "budget.html"),
        (&["curve", "rest", "--quick", "-o", "sins_out"], "curve.csv"),
        (&["scene", "write", "rest", "-o", "sins_out/rest.toml"], "rest.toml"),
    ] {
        let part = folder.join(format!("sins_out/.sins-{name}.part"));
        let other = std::fs::File::create(&part).unwrap();
        other.lock().unwrap();
        let (code, _, errors) = result(&sins(&folder, order).output().unwrap());
        assert!(code == 2 && errors.contains("another run of sins is writing it"), "{order:?}: {errors}");
        std::fs::remove_file(&part).unwrap();
    }
}

/// Rows from the start to the last whole one that the disk took.
fn whole_rows(path: &Path) -> usize {
    let (columns, rows) = numbers(path);
    assert!(rows.iter().all(|row| row.len() == columns.len()) && read(path).ends_with('\n'));
    rows.len()
}

/// The rows of a smoothed log take no other file with them.
#[test]
fn a_full_disk_keeps_the_records_beside_the_rows_of_a_log() {
    let folder = folder("full_rows");
    let scene = project_file("c_examples/scenes/cockpit.toml");
    let program = env!("CARGO_BIN_EXE_sins");
    let script = format!(
        "ulimit -f 128; exec '{program}' fly '{}' --name c --set output.every_s=100",
        scene.display()
    );
    let (code, _, errors) =
        result(&Command::new("sh").args(["-c", &script]).current_dir(&folder).output().unwrap());
    assert!(code == 1 && errors.contains("c_rows.csv: cannot be written"), "{errors}");
    assert!(whole_rows(&folder.join("sins_out/c_rows.csv")) > 100);
    // A record each 100 s of 394 s, with the first and the last.
    assert_eq!(whole_rows(&folder.join("sins_out/c.csv")), 5);
    assert!(folder.join("sins_out/c_summary.csv").exists());
}

/// A limit on the size of files, whose signal would end the program, acts like a full disk. What was flown until then is kept, in whole
/// rows, and no temporary file is left.
#[test]
fn a_full_disk_keeps_what_was_flown() {
    let folder = folder("full");
    let program = env!("CARGO_BIN_EXE_sins");
    // 512 KiB if a block is 1 KiB, otherwise 256 KiB.
    let full = |arguments: &str| {
        let script = format!("ulimit -f 512; exec '{program}' {arguments}");
        result(&Command::new("sh").args(["-c", &script]).current_dir(&folder).output().unwrap())
    };
    for (file, more) in [
        ("rest.csv", "--set output.every_s=0.1"),
        ("imu.csv", "--imu imu.csv"),
        ("bus.csv", "--bus bus.csv"),
        ("rest_unit.csv", "--set unit.start=nav --set output.every_s=0.01"),
    ] {
        let (code, said, errors) = full(&format!("fly rest {more}"));
        assert!(code == 1 && errors.contains("cannot be written"), "{more}: {errors}");
        assert!(
            errors.contains(": cannot be written: ") && errors.contains("what was written before is kept")
        );
        assert!(said.contains("stopped before the end"), "{said}");
        let summary = read(folder.join("sins_out/rest_summary.csv"));
        let rows = whole_rows(&folder.join("sins_out/rest.csv"));
        assert!(
            summary.contains("interrupted,1,") && summary.contains(&format!("records,{rows},")),
            "{rows}"
        );
        assert!(read(folder.join("sins_out").join(file)).ends_with('\n'), "{file}");
        assert!(!names(&folder.join("sins_out")).iter().any(|name| name.ends_with(".part")), "{file}");
        std::fs::remove_dir_all(folder.join("sins_out")).unwrap();
    }
    // The table is printed although the file cannot be written.
    let script = format!("ulimit -f 1; exec '{program}' budget rest --hours 0.01 --runs 8");
    let output = Command::new("sh").args(["-c", &script]).current_dir(&folder).output().unwrap();
    let (code, said, errors) = result(&output);
    assert!(code == 1 && errors.contains("cannot be written") && said.contains("| effect"), "{said}{errors}");
    let left = names(&folder.join("sins_out/budget"));
    assert!(!left.iter().any(|name| name.ends_with(".part")), "{left:?}");
}

/// The runs of an ensemble whose results the disk does not take are in its checkpoint.
#[test]
fn a_full_disk_keeps_the_runs_of_an_ensemble() {
    let folder = folder("full_ensemble");
    let program = env!("CARGO_BIN_EXE_sins");
    let order = "ensemble simulation1 --set flight.hours=0.01 --every 36 --runs 4096 --set gyro.bias_sigma_deg_h=0.01";
    // More than the checkpoint, less than the table of the runs.
    let script = format!("ulimit -f 1000; exec '{program}' {order}");
    let output = Command::new("sh").args(["-c", &script]).current_dir(&folder).output().unwrap();
    let (code, said, errors) = result(&output);
    assert!(code == 1 && errors.contains("_ensemble_runs.csv: cannot be written"), "{errors}");
    assert!(
        errors
            .contains("4096 of 4096 runs are in sins_out/simulation1_ensemble.checkpoint: the same command")
    );
    assert!(said.contains("CEP50"), "what was computed is printed: {said}");
    let (code, said, errors) =
        result(&sins(&folder, &order.split(' ').collect::<Vec<_>>()).output().unwrap());
    assert!(
        code == 0 && errors.contains("4096 of 4096 runs are flown") && said.contains("CEP50"),
        "{errors}"
    );
    assert!(!folder.join("sins_out/simulation1_ensemble.checkpoint").exists());
}
