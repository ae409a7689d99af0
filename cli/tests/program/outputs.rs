//! Hostile files and orders: nothing of the user's is lost, nothing half is left, nothing wrong is taken for data.

#[path = "support/program.rs"]
mod program;

#[cfg(unix)]
use std::{
    io::Write,
    path::Path,
    process::{Child, Command, Stdio},
    time::{Duration, Instant},
};

use program::{done, folder, names, numbers, project_file, read, refused, run, sins, told};

const HEADER: &str = "time_s,latitude_rad,longitude_rad,height_m,roll_rad,pitch_rad,heading_rad";

/// Ten seconds at rest.
fn log() -> String {
    let rows: String = (0..=10).map(|t| format!("{t},0.7,2.0,50,0,0,1\n")).collect();
    format!("{HEADER}\n{rows}")
}

/// A folder with such a log in logs/mylog.csv.
fn with_log(name: &str) -> std::path::PathBuf {
    let folder = folder(name);
    std::fs::create_dir(folder.join("logs")).unwrap();
    std::fs::write(folder.join("logs/mylog.csv"), log()).unwrap();
    folder
}

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
        let errors = refused(&folder, arguments);
        assert!(errors.contains(words), "{arguments:?}: {errors}");
        assert_eq!(read(folder.join("logs/mylog.csv")), log(), "{arguments:?}");
        assert_eq!(names(&folder.join("logs")), ["hard.csv", "mylog.csv"], "{arguments:?}");
    }
    // Redirected, it is still the file.
    let input = std::fs::File::open(folder.join("logs/mylog.csv")).unwrap();
    let output = sins(&folder, &["fly", "-", "--out", "logs", "--name", "mylog", "--force"])
        .stdin(input)
        .output()
        .unwrap();
    let (code, _, errors) = told(&output);
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
        let errors = refused(&folder, arguments);
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
        let errors = refused(&folder, order);
        assert!(errors.contains(name) && errors.contains("--force"), "{errors}");
        assert_eq!(read(folder.join("sins_out").join(name)), "somebody's own");
        done(&folder, &[order, &["--force"]].concat());
        // Its own it replaces.
        done(&folder, order);
    }
}

#[test]
fn rows_of_more_fields_than_columns_are_no_flight() {
    let folder = folder("decimal_commas");
    std::fs::write(folder.join("commas.csv"), log().replace(",0.7,", ",0,7,")).unwrap();
    let errors = refused(&folder, &["fly", "commas.csv"]);
    assert!(errors.starts_with("commas.csv:2: 8 fields"), "{errors}");
    assert!(!folder.join("sins_out/commas.csv").exists());
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
    let order = |imu: &str| refused(&folder, &["fly", "logs/mylog.csv", "-q", "-o", "out", "--imu", imu]);
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

#[test]
#[cfg(unix)]
fn pipes_and_standard_input_are_logs_and_devices_are_not() {
    let folder = with_log("pipes");
    let mut child = sins(&folder, &["fly", "-", "-q"]).stdin(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(log().as_bytes()).unwrap();
    assert!(child.wait().unwrap().success());
    assert!(Command::new("mkfifo").arg(folder.join("pipe.csv")).status().unwrap().success());
    let child = sins(&folder, &["fly", "pipe.csv", "-q"]).spawn().unwrap();
    std::fs::write(folder.join("pipe.csv"), log()).unwrap();
    assert!(child.wait_with_output().unwrap().status.success());
    done(&folder, &["fly", "logs/mylog.csv", "-q"]);
    let of = |name: &str| read(folder.join("sins_out").join(name));
    assert!(of("log.csv") == of("mylog.csv") && of("pipe.csv") == of("mylog.csv"));
    for order in [&["fly", "--log", "/dev/zero"][..], &["allan", "/dev/zero", "-o", "a.svg"]] {
        assert!(refused(&folder, order).contains("/dev/zero: is a device"), "{order:?}");
    }
    // A pipe is no run: its summary cannot lie beside it. It is not waited for.
    assert!(refused(&folder, &["report", "pipe.csv"]).contains("pipe_summary.csv"));
}

/// Whoever wrote the scene: it names no place outside.
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
        let errors = refused(&folder, &["fly", "scene.toml", "--force"]);
        assert!(errors.contains(words), "{key} = {value}: {errors}");
        assert_eq!(names(&folder), ["logs", "scene.toml"], "{key} = {value}");
    }
}

/// On Windows case does not matter, some names are devices, and a colon leads to another stream of a file.
#[test]
#[cfg(windows)]
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
        let errors = refused(&folder, arguments);
        assert!(errors.contains(words), "{arguments:?}: {errors}");
        assert_eq!(read(folder.join("logs/mylog.csv")), log(), "{arguments:?}");
    }
}

#[test]
fn a_mark_before_a_comment_is_passed_over() {
    let folder = folder("mark");
    std::fs::write(folder.join("log.csv"), format!("\u{feff}# A rest\n{}", log())).unwrap();
    done(&folder, &["fly", "log.csv", "-q"]);
    let rows: String = (0..200).map(|k| format!("{}\n", k % 7)).collect();
    std::fs::write(folder.join("imu.csv"), format!("\u{feff}# A sensor\ngyro_x_deg_h\n{rows}")).unwrap();
    assert!(done(&folder, &["allan", "imu.csv", "-o", "a.svg", "--rate", "10"]).contains("gyro_x_deg_h"));
}

#[test]
fn a_file_does_not_steer_the_terminal() {
    let folder = folder("escapes");
    let escape = "\u{1b}]0;owned\u{7}\u{9b}2J";
    std::fs::write(folder.join("title.csv"), format!("# {escape}\n{}", log())).unwrap();
    std::fs::write(folder.join("word.csv"), log().replace("0.7", escape)).unwrap();
    let column = format!("{HEADER}x{escape}");
    std::fs::write(folder.join("column.csv"), log().replace(HEADER, &column)).unwrap();
    let title = "\\u001b]0;owned\\u0007";
    let scene = format!("[flight]\nbuiltin = \"rest\"\nhours = 0.01\ntitle = \"{title}\"\n");
    std::fs::write(folder.join("title.toml"), scene).unwrap();
    std::fs::write(folder.join("key.toml"), format!("[flight]\n\"{title}\" = 1\n")).unwrap();
    std::fs::write(folder.join("imu.csv"), format!("gyro{escape}_deg_h\nx{escape}\n")).unwrap();
    for (arguments, code) in [
        (&["fly", "title.csv"][..], 0),
        (&["fly", "word.csv"], 2),
        (&["fly", "column.csv"], 2),
        (&["fly", "title.toml"], 0),
        (&["scene", "check", "title.toml"], 0),
        (&["fly", "key.toml"], 2),
        (&["allan", "imu.csv", "-o", "a.svg", "--rate", "1"], 2),
        (&["fly", escape], 2),
        (&["report", escape], 2),
        (&[escape], 2),
    ] {
        let (found, said, errors) = run(&folder, arguments);
        assert_eq!(found, code, "{arguments:?}: {errors}");
        let is_steering = |letter: char| letter.is_control() && letter != '\n' && letter != '\t';
        assert!(!(said + &errors).contains(is_steering), "{arguments:?}");
    }
}

#[test]
fn no_number_of_a_record_becomes_none_or_infinite_on_a_page() {
    let folder = with_log("numbers");
    done(
        &folder,
        &[
            "fly",
            "logs/mylog.csv",
            "-q",
            "--name",
            "run",
            "--preset",
            "tactical",
            "--set",
            "options.error_model=rk4",
        ],
    );
    let (records, summary) = (folder.join("sins_out/run.csv"), folder.join("sins_out/run_summary.csv"));
    let good = read(&records);
    let (columns, rows) = numbers(&records);
    let with = |value: &str, column: usize, only: Option<usize>| {
        let row = |(k, row): (usize, &Vec<f64>)| {
            let field = |(c, number): (usize, &f64)| {
                let is_it = c == column && only.is_none_or(|only| only == k);
                if is_it { value.to_owned() } else { number.to_string() }
            };
            row.iter().enumerate().map(field).collect::<Vec<_>>().join(",") + "\n"
        };
        format!("{}\n{}", columns.join(","), rows.iter().enumerate().map(row).collect::<String>())
    };
    let page = folder.join("page.html");
    for value in ["1e308", "-1e308", "nan", "inf", "1e30", "-1e30", "5e-324", "1e-60", "-0.0"] {
        for (column, name) in columns.iter().enumerate().skip(1) {
            for only in [Some(3), None] {
                // All columns of one of them, and a third of the others.
                if only.is_none() && column % 3 != 0 {
                    continue;
                }
                std::fs::write(&records, with(value, column, only)).unwrap();
                let (code, _, errors) = run(&folder, &["report", "sins_out/run.csv", "-o", "page.html"]);
                let row = 2 + only.unwrap_or(0);
                let place = format!("sins_out/run.csv:{row}: column {} ({name})", column + 1);
                if code == 2 {
                    assert!(errors.starts_with(&place), "{errors}");
                } else {
                    assert_eq!(code, 0, "{value} in {name}: {errors}");
                    assert_is_finite(&read(&page), &format!("{value} in {name}"));
                }
            }
        }
    }
    std::fs::write(&records, good).unwrap();
    let figures = read(&summary);
    for line in figures.lines().filter(|line| line.split(',').nth(2).is_some_and(|unit| !unit.is_empty())) {
        let fields: Vec<&str> = line.splitn(3, ',').collect();
        for value in ["nan", "inf", "1e308"] {
            let spoiled = format!("{},{value},{}", fields[0], fields[2]);
            std::fs::write(&summary, figures.replace(line, &spoiled)).unwrap();
            let errors = refused(&folder, &["report", "sins_out/run.csv", "-o", "page.html"]);
            assert!(errors.starts_with("sins_out/run_summary.csv:"), "{errors}");
        }
    }
}

fn assert_is_finite(page: &str, what: &str) {
    // Words of the style sheet and of the text aside: numbers stand behind these.
    for mark in ["NaN", "\"inf", " inf ", "inf,", ",inf", "-inf", "nan,", ",nan", "\"nan"] {
        assert!(!page.contains(mark), "{what}: {mark}");
    }
    assert!(page.len() < 4_000_000, "{what}: {} bytes", page.len());
}

/// Waits until a temporary file is there.
#[cfg(unix)]
fn wait_for_part(out: &Path) {
    let deadline = Instant::now() + Duration::from_secs(60);
    while !out.exists() || !names(out).iter().any(|name| name.ends_with(".part")) {
        assert!(Instant::now() < deadline, "no temporary file came");
        std::thread::sleep(Duration::from_millis(20));
    }
}

#[cfg(unix)]
fn signal(child: &Child, name: &str) {
    // The shell's own kill: the program of that name is not on every machine.
    let order = format!("kill -{name} {}", child.id());
    assert!(Command::new("sh").args(["-c", &order]).status().unwrap().success());
}

#[test]
#[cfg(unix)]
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
        let (code, said, errors) = told(&child.wait_with_output().unwrap());
        assert_eq!(code, 130, "{name}: {errors}");
        assert!(errors.contains("interrupted") && said.contains("stopped before the end"), "{said}{errors}");
        assert_eq!(names(&out), ["simulation2.csv", "simulation2_summary.csv"]);
        let (columns, rows) = numbers(&out.join("simulation2.csv"));
        assert!(rows.iter().all(|row| row.len() == columns.len()), "every row is whole");
        assert!(read(out.join("simulation2_summary.csv")).contains("interrupted,1,"));
    }
    // A survey has nothing to show before its end.
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

#[test]
#[cfg(unix)]
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

/// A disk that is full, as a limit on the size of files has it.
#[test]
#[cfg(unix)]
fn a_full_disk_leaves_the_old_file() {
    let folder = folder("full");
    let order = ["fly", "rest", "-q", "--set", "output.every_s=1"];
    done(&folder, &[&order[..], &["--set", "flight.hours=0.01"]].concat());
    let before = read(folder.join("sins_out/rest.csv"));
    let program = env!("CARGO_BIN_EXE_sins");
    // 512 KiB where a block is a KiB, half of that where it is not.
    let script = format!("trap '' XFSZ; ulimit -f 512; exec '{program}' {}", order.join(" "));
    let output = Command::new("sh").args(["-c", &script]).current_dir(&folder).output().unwrap();
    let (code, _, errors) = told(&output);
    assert!(code == 1 && errors.contains("sins_out/rest.csv: cannot be written"), "{errors}");
    assert_eq!(read(folder.join("sins_out/rest.csv")), before);
    assert_eq!(names(&folder.join("sins_out")), ["rest.csv", "rest_summary.csv"]);
}

#[test]
fn every_fault_of_a_scene_has_its_line() {
    let folder = with_log("faults");
    let scene = "[flight]\nfile = \"nowhere.csv\"\n[gyro]\nbais_deg_h = 1\nbias_deg_h = \"x\"\n[options]\nsubsamples = 9\n";
    std::fs::write(folder.join("bad.toml"), scene).unwrap();
    std::fs::write(folder.join("lost.toml"), "# no log\n[flight]\nfile = \"nowhere.csv\"\n").unwrap();
    std::fs::write(folder.join("good.toml"), "[flight]\nfile = \"logs/mylog.csv\"\n").unwrap();
    let order = ["scene", "check", "bad.toml", "good.toml", "lost.toml", "logs/mylog.csv"];
    let (code, said, errors) = run(&folder, &order);
    assert_eq!((code, said.lines().count()), (2, 2), "{said}{errors}");
    let lines: Vec<&str> = errors.lines().collect();
    for (line, begin) in lines.iter().zip([
        "bad.toml:4:1: no such key: bais_deg_h; bias_deg_h?",
        "bad.toml:5:14: gyro.bias_deg_h = \"x\"",
        "bad.toml:7:1: options.subsamples = 9",
        "lost.toml:3: nowhere.csv: cannot be read",
    ]) {
        assert!(line.starts_with(begin), "{line}");
    }
    assert_eq!(lines.len(), 4, "{errors}");
    // A bad sample has the line of the log.
    let spoiled = log().replace("\n5,0.7,", "\n5,0.8,");
    std::fs::write(folder.join("jump.csv"), spoiled).unwrap();
    let errors = refused(&folder, &["fly", "jump.csv"]);
    assert!(errors.starts_with("jump.csv:7: "), "{errors}");
    assert!(project_file("README.md").exists());
}
