//! Outputs of the program destroy nothing: no input, no file of another program, nothing outside the program's folder.

#[cfg(unix)]
use std::process::Command;

use crate::support::{done, log, names, read, rejected, result, sins, with_log};

#[test]
fn a_flight_does_not_destroy_its_log() {
    let folder = with_log("own_log");
    let scene = "[flight]\nfile = \"logs/mylog.csv\"\n[output]\n";
    std::fs::write(folder.join("here.toml"), format!("{scene}folder = \".\"\n")).unwrap();
    std::fs::write(folder.join("same.toml"), format!("{scene}folder = \"logs\"\nname = \"mylog\"\n"))
        .unwrap();
    std::fs::hard_link(folder.join("logs/mylog.csv"), folder.join("logs/hard.csv")).unwrap();
    for (arguments, words) in [
        (&["fly", "logs/mylog.csv", "--out", "logs"][..], "is the input"),
        (&["fly", "logs/mylog.csv", "--out", "logs/../logs", "--force"], "is the input"),
        (&["fly", "logs/hard.csv", "--out", "logs", "--name", "mylog", "--force"], "is the input"),
        (&["fly", "--log", "logs/mylog.csv", "--out", "logs", "--name", "mylog"], "is the input"),
        (&["fly", "logs/mylog.csv", "--out", "logs", "--name", "x", "--imu", "mylog.csv"], "is the input"),
        (&["fly", "here.toml"], "output.folder"),
        (&["fly", "same.toml", "--force"], "is the input"),
        (&["fly", "here.toml", "--out", "logs", "--name", "mylog"], "is the input"),
        (&["allan", "logs/mylog.csv", "-o", "a.svg", "--csv", "logs/mylog.csv"], "is the input"),
        (&["scene", "write", "here.toml", "-o", "here.toml", "--force"], "is the input"),
    ] {
        let errors = rejected(&folder, arguments);
        assert!(errors.contains(words), "{arguments:?}: {errors}");
        assert_eq!(read(folder.join("logs/mylog.csv")), log(), "{arguments:?}");
        assert_eq!(names(&folder.join("logs")), ["hard.csv", "mylog.csv"], "{arguments:?}");
    }
}

#[test]
fn a_log_that_is_redirected_is_still_the_file() {
    let folder = with_log("redirected");
    let input = std::fs::File::open(folder.join("logs/mylog.csv")).unwrap();
    let output = sins(&folder, &["fly", "-", "--out", "logs", "--name", "mylog", "--force"])
        .stdin(input)
        .output()
        .unwrap();
    let (code, _, errors) = result(&output);
    assert!(code == 2 && errors.contains("is the input"), "{errors}");
    assert_eq!(read(folder.join("logs/mylog.csv")), log());
}

#[test]
fn a_report_does_not_destroy_its_run() {
    let folder = with_log("own_run");
    done(&folder, &["fly", "logs/mylog.csv", "--quiet", "--name", "run"]);
    let before = ["sins_out/run.csv", "sins_out/run_summary.csv"].map(|name| read(folder.join(name)));
    for arguments in [
        &["report", "sins_out/run.csv", "-o", "sins_out/run.csv", "--force"][..],
        &["report", "sins_out/run.csv", "-o", "sins_out/run_summary.csv"],
        &["report", "sins_out/run.csv", "--picture", "./sins_out/run.csv"],
        &["report", "sins_out/run.csv", "-o", "a.html", "--picture", "a.html"],
    ] {
        let errors = rejected(&folder, arguments);
        assert!(errors.contains("is the input") || errors.contains("two outputs"), "{errors}");
        assert_eq!(["sins_out/run.csv", "sins_out/run_summary.csv"].map(|n| read(folder.join(n))), before);
    }
    done(&folder, &["report", "sins_out/run.csv"]);
    done(&folder, &["report", "sins_out/run.csv"]);
    assert!(read(folder.join("sins_out/report.html")).starts_with("<!DOCTYPE html>"));
}

#[test]
fn what_others_made_needs_force() {
    let folder = with_log("foreign");
    std::fs::create_dir(folder.join("sins_out")).unwrap();
    for name in ["mylog.csv", "mylog_summary.csv", "imu.csv", "report.html"] {
        std::fs::write(folder.join("sins_out").join(name), "somebody's own").unwrap();
        let is_page = name == "report.html";
        if is_page {
            done(&folder, &["fly", "logs/mylog.csv", "--quiet"]);
        }
        let order: &[&str] = if is_page {
            &["report", "sins_out/mylog.csv"]
        } else {
            &["fly", "logs/mylog.csv", "--imu", "imu.csv", "--quiet"]
        };
        let errors = rejected(&folder, order);
        assert!(errors.contains(name) && errors.contains("--force"), "{errors}");
        assert_eq!(read(folder.join("sins_out").join(name)), "somebody's own");
        done(&folder, &[order, &["--force"]].concat());
        // The program replaces its own file.
        done(&folder, order);
    }
}

#[test]
#[cfg(unix)]
fn nodes_and_links_stay_what_they_are() {
    let folder = with_log("nodes");
    let out = folder.join("out");
    std::fs::create_dir(&out).unwrap();
    std::fs::write(folder.join("kept"), "kept").unwrap();
    std::os::unix::fs::symlink("../kept", out.join("mylog.csv.part")).unwrap();
    std::os::unix::fs::symlink("../kept", out.join("link.csv")).unwrap();
    assert!(Command::new("mkfifo").arg(out.join("pipe.csv")).status().unwrap().success());
    let order = |imu: &str| rejected(&folder, &["fly", "logs/mylog.csv", "-q", "-o", "out", "--imu", imu]);
    for imu in ["/dev/null", "../kept", "/etc/passwd"] {
        assert!(order(imu).contains("below the folder"), "{imu}");
    }
    for imu in ["pipe.csv", "link.csv"] {
        assert!(order(imu).contains("only plain files"), "{imu}");
    }
    done(&folder, &["fly", "logs/mylog.csv", "-q", "-o", "out"]);
    assert_eq!(read(folder.join("kept")), "kept");
    assert_eq!(names(&out), ["link.csv", "mylog.csv", "mylog.csv.part", "mylog_summary.csv", "pipe.csv"]);
}

/// A scene cannot name a place outside the folder, whoever wrote the scene.
#[test]
fn a_scene_names_no_file_outside() {
    let folder = with_log("outside");
    for (key, value, words) in [
        ("folder", "/tmp", "output.folder = \"/tmp\""),
        ("folder", "..", "output.folder = \"..\""),
        ("folder", "a/../../b", "output.folder"),
        ("name", "../mylog", "without a folder"),
        ("imu", "../kept.csv", "output.imu = \"../kept.csv\""),
        ("imu", "/etc/passwd", "output.imu"),
    ] {
        let scene = format!("[flight]\nfile = \"logs/mylog.csv\"\n[output]\n{key} = \"{value}\"\n");
        std::fs::write(folder.join("scene.toml"), scene).unwrap();
        let errors = rejected(&folder, &["fly", "scene.toml", "--force"]);
        assert!(errors.contains(words), "{key} = {value}: {errors}");
        assert_eq!(names(&folder), ["logs", "scene.toml"], "{key} = {value}");
    }
}

/// On Windows case does not matter, some names are devices, and a colon selects another stream of a file.
#[test]
#[cfg_attr(not(windows), ignore = "of Windows: tests/windows_program.sh")]
fn names_that_windows_has_for_something_else() {
    let folder = with_log("windows");
    for (arguments, words) in [
        (&["fly", "logs/mylog.csv", "--out", "LOGS", "--name", "MyLog", "--force"][..], "is the input"),
        (&["fly", "logs/mylog.csv", "--imu", "MYLOG.csv"], "two outputs"),
        (&["fly", "logs/mylog.csv", "--name", "con"], "the name of a device"),
        (&["fly", "logs/mylog.csv", "--imu", "NUL.csv"], "the name of a device"),
        (&["fly", "logs/mylog.csv", "--imu", "mylog.csv:b"], "colon"),
        (&["fly", "logs/mylog.csv", "--imu", "C:x.csv"], "below the folder"),
        (&["fly", "--log", "CON"], "is a device"),
    ] {
        let errors = rejected(&folder, arguments);
        assert!(errors.contains(words), "{arguments:?}: {errors}");
        assert_eq!(read(folder.join("logs/mylog.csv")), log(), "{arguments:?}");
    }
}
