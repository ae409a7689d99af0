//! Files are complete or absent: after signals, with several runs of one name, on a full disk.

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::support::{done, folder, names, numbers, read, result, sins};

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
    let mut living = sins(&folder, &long).spawn().unwrap();
    let deadline = Instant::now() + Duration::from_secs(60);
    while parts().iter().any(|name| left.contains(name)) || parts().len() < 2 {
        assert!(Instant::now() < deadline, "{:?}", parts());
        std::thread::sleep(Duration::from_millis(20));
    }
    let own = parts();
    done(&folder, &["fly", "rest", "-q", "--set", "flight.hours=0.01"]);
    assert_eq!(parts(), own, "files that are being written");
    signal(&living, "KILL");
    living.wait().unwrap();
    done(&folder, &["fly", "rest", "-q", "--set", "flight.hours=0.01"]);
    assert_eq!(parts(), ["another.part"]);
}

#[test]
fn two_runs_of_one_name_leave_whole_files() {
    let folder = folder("two_runs");
    let order = |seed: &str| {
        let seed = format!("options.seed={seed}");
        let scene = ["fly", "simulation2", "-q", "--set", "flight.hours=0.1", "--set", "output.every_s=0.1"];
        sins(&folder, &[&scene[..], &["--set", &seed]].concat()).spawn().unwrap()
    };
    let runs = ["1", "2", "3"].map(order);
    for mut run in runs {
        assert!(run.wait().unwrap().success());
    }
    assert_eq!(names(&folder.join("sins_out")), ["simulation2.csv", "simulation2_summary.csv"]);
    let (columns, rows) = numbers(&folder.join("sins_out/simulation2.csv"));
    assert!(rows.len() == 3601 && rows.iter().all(|row| row.len() == columns.len()));
}

/// A limit on the size of files acts like a full disk.
#[test]
fn a_full_disk_leaves_the_old_file() {
    let folder = folder("full");
    let order = ["fly", "rest", "-q", "--set", "output.every_s=1"];
    done(&folder, &[&order[..], &["--set", "flight.hours=0.01"]].concat());
    let before = read(folder.join("sins_out/rest.csv"));
    let program = env!("CARGO_BIN_EXE_sins");
    // 512 KiB if a block is 1 KiB, otherwise 256 KiB.
    let script = format!("trap '' XFSZ; ulimit -f 512; exec '{program}' {}", order.join(" "));
    let output = Command::new("sh").args(["-c", &script]).current_dir(&folder).output().unwrap();
    let (code, _, errors) = result(&output);
    assert!(code == 1 && errors.contains("sins_out/rest.csv: cannot be written"), "{errors}");
    assert_eq!(read(folder.join("sins_out/rest.csv")), before);
    assert_eq!(names(&folder.join("sins_out")), ["rest.csv", "rest_summary.csv"]);
}
