//! The C side, built and run: layout, call patterns, and the program that flies the main job.

#[path = "support/c_side.rs"]
mod c_side;

use std::process::{Child, Command};

use c_side::{
    C_AND_CPP, STRICT, c_compiler, cpp_compiler, harness_sources, library_folder, link, prints_alike,
    project_file, run_test_program, succeed,
};
use sins::abi::{sins_accel_params, sins_gyro_params};
use sins::sensors::{PARAMETERS, Sensor};

/// Size and offsets of the structs of sensor parameters, for `layout.c`: numbers one behind the other, from the eighth byte on.
fn sensor_layout() -> String {
    let of = |name: &str, sensor: Sensor, size: usize| {
        let stated = name.replacen("sins_", "sins_sizeof_", 1).to_uppercase();
        let (mut offset, mut text) = (8, format!("SIZE({name}, {stated}, {size});\n"));
        for (parameter, field) in PARAMETERS.iter().filter_map(|row| Some((row, row.of(sensor)?))) {
            text += &format!("AT({name}, {}, {offset});\n", field.name());
            offset += 8 * parameter.shape.count();
        }
        assert_eq!(offset, size, "{name}");
        text
    };
    of("sins_gyro_params", Sensor::Gyro, size_of::<sins_gyro_params>())
        + &of("sins_accel_params", Sensor::Accelerometer, size_of::<sins_accel_params>())
}

#[test]
fn structs_are_laid_out_alike_under_every_packing_and_language() {
    let folder = library_folder("layout");
    std::fs::write(folder.join("sensor_layout.h"), sensor_layout()).unwrap();
    for packing in ["-DNO_PACKING", "-fpack-struct=4", "-fpack-struct=1"] {
        for (mut compiler, standard) in
            [(c_compiler(), &["-std=c99"][..]), (cpp_compiler(), &["-x", "c++", "-std=c++11"][..])]
        {
            compiler.args(standard).arg(packing).args(STRICT).arg("-fsyntax-only").arg("-I").arg(&folder);
            compiler.arg("-I").arg(project_file("include")).arg(project_file("tests/c/layout.c"));
            succeed(&mut compiler);
        }
    }
}

#[test]
fn the_header_alone_is_c90_and_cpp98() {
    let header = project_file("include/sins.h");
    succeed(c_compiler().args(["-x", "c", "-std=c90", "-fsyntax-only"]).args(STRICT).arg(&header));
    succeed(cpp_compiler().args(["-x", "c++", "-std=c++98", "-fsyntax-only"]).args(STRICT).arg(&header));
}

#[test]
fn any_call_pattern_gives_the_same_bits() {
    run_test_program("run");
}

#[test]
fn a_snapshot_goes_on_to_the_same_bits_in_any_handle() {
    run_test_program("snapshot");
}

#[test]
fn a_recommendation_is_flown_and_a_refused_one_writes_nothing() {
    run_test_program("recommend");
}

#[test]
fn a_budget_has_its_rows_and_a_refused_one_writes_nothing() {
    run_test_program("budget");
}

#[test]
fn the_harness_flies_and_refuses() {
    let folder = library_folder("harness");
    let sources = harness_sources();
    let sources: Vec<&str> = sources.iter().map(String::as_str).collect();
    let harness = link(c_compiler(), &["-std=c99", "-O1"], &sources, &folder, "sins_harness");
    let out = folder.join("out");
    let run = |arguments: &[&str]| {
        let output = Command::new(&harness).args(arguments).arg("--out").arg(&out).output().unwrap();
        let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
        (output.status.code(), text(&output.stdout), text(&output.stderr))
    };

    // Each scene, briefly; a row at the start and one each record.
    for (arguments, name, rows) in [
        (&["simulation1", "--hours", "0.1", "--every", "10"][..], "simulation1_patrol", 37),
        (&["simulation2", "--motion", "rest", "--hours", "0.1", "--every", "10"], "simulation2_rest", 37),
        (&["embedded", "over_the_pole", "--hours", "0.05", "--every", "10"], "over_the_pole", 19),
    ] {
        let (code, summary, errors) = run(arguments);
        assert_eq!(code, Some(0), "{errors}");
        assert!(summary.contains("closure: navigation - truth"), "{summary}");
        let csv = std::fs::read_to_string(out.join(name).with_extension("csv")).unwrap();
        assert_eq!(csv.lines().count(), 1 + rows, "{name}");
        let columns = csv.lines().next().unwrap().split(',').count();
        assert!(
            csv.lines().all(|line| line.split(',').count() == columns) && columns == 51,
            "{name}: {columns}"
        );
        let figures = std::fs::read_to_string(out.join(format!("{name}_summary.csv"))).unwrap();
        assert!(figures.starts_with("key,value,unit,label\n"));
    }

    // The log of the IMU: a row each sample interval; at rest a g over the interval upwards.
    let imu = folder.join("imu.csv");
    let (code, _, errors) = run(&[
        "simulation1",
        "--motion",
        "rest",
        "--hours",
        "0.01",
        "--quiet",
        "--imu",
        imu.to_str().unwrap(),
    ]);
    assert_eq!(code, Some(0), "{errors}");
    let csv = std::fs::read_to_string(&imu).unwrap();
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!((rows.len(), rows[0][0], rows[0][6]), (1 + 3600, "time_s", "velocity_increment_z_m_s"));
    assert!(rows.iter().all(|row| row.len() == 7));
    let [time, up] = [0, 6].map(|column| rows[3600][column].parse::<f64>().unwrap());
    assert!((time - 36.0).abs() < 1e-9 && (9.78e-2..9.84e-2).contains(&up), "{time} {up}");
    let (code, _, errors) = run(&["simulation1", "--imu", folder.join("none/imu.csv").to_str().unwrap()]);
    assert!(code == Some(1) && errors.contains("imu.csv"), "{errors}");

    // A log: each line end that there is, none behind the last line; a row of the IMU each interval.
    let header = "time_s,latitude_rad,longitude_rad,height_m,velocity_east_m_s,velocity_north_m_s,velocity_up_m_s,\
        roll_rad,pitch_rad,heading_rad\n";
    let row = "0.00,0.7,0.1,100,0,0,0,0,0,0\n";
    let later = |time_s: &str| row.replacen("0.00", time_s, 1);
    let log = format!("# a title\n{header}{row}\n{}#\n{}{}", later("0.01"), later("0.02"), later("0.03"));
    for text in
        [log.clone(), log.replace('\n', "\r\n"), log.replacen('\n', "\r\n", 4), log.trim_end().to_owned()]
    {
        std::fs::write(folder.join("good.csv"), text).unwrap();
        let [log, imu] = [folder.join("good.csv"), imu.clone()];
        let (code, _, errors) = run(&["flight", log.to_str().unwrap(), "--imu", imu.to_str().unwrap()]);
        assert_eq!((code, errors.as_str()), (Some(0), ""));
        assert_eq!(std::fs::read_to_string(imu).unwrap().lines().count(), 1 + 3);
    }

    // Bad logs: file, line and column, and what was expected.
    for (log, expected) in [
        (format!("{header}{row}0.01,0.7,x1,100,0,0,0,0,0,0\n"), ":3:3: \"x1\""),
        (format!("{header}{row}0.01,0.7,0.1,100,0,0\n"), ":3:"),
        (format!("{header}{row}{row}"), ":3:"),
        (header.replace("height_m,", ""), "height_m"),
        // What would end a line before its end, or make two of one.
        (format!("{header}{}\r{row}{row}", row.trim_end()), ":2:10: \"0\" is followed by a carriage return"),
        (format!("{header}{row}0.01,0.7,0.1\r,100,0,0,0,0,0,0\n"), ":3:3: \"0.1\""),
        (format!("{header}{row}").replace('\n', "\r"), ":1:10: \"heading_rad\""),
        (format!("# comment\r{header}{row}"), ":1:1: \"# comment\""),
        (format!("{header}{row}{}\r", row.trim_end()), ":3:10: \"0\""),
        (
            format!("{header}{row}0.01,0.7\0,0.1,100,0,0,0,0,0,0\n"),
            ":3:2: \"0.7\" is followed by a zero byte",
        ),
        (format!("{header}{row}0.01,0.7,0.1,100,0,0,0,0,0,0\0"), ":3:10: \"0\""),
        (format!("{header}{row}\0"), ":3:1: \"\""),
        (format!("{header}{row}{}", "x".repeat(70_000)), ":3:1: \"xxx"),
        (String::new(), "bad.csv"),
    ] {
        let path = folder.join("bad.csv");
        std::fs::write(&path, log).unwrap();
        let (code, _, errors) = run(&["flight", path.to_str().unwrap()]);
        assert_eq!(code, Some(2), "{errors}");
        assert!(errors.contains("bad.csv") && errors.contains(expected), "{expected}: {errors}");
    }
    for arguments in
        [&["simulation3"][..], &["simulation1", "--rate", "fast"], &["simulation2", "--gyro-bias", "1,2"]]
    {
        let (code, _, errors) = run(arguments);
        assert_eq!(code, Some(2), "{arguments:?}");
        assert!(errors.contains(arguments.last().unwrap()), "{errors}");
    }
}

#[test]
fn the_harness_is_cpp_too() {
    let sources = harness_sources();
    let sources: Vec<&str> = sources.iter().map(String::as_str).collect();
    let text = prints_alike("harness_as_both", &sources, &C_AND_CPP, &["embedded", "list"]);
    assert!(text.contains("over_the_pole"), "{text}");
}

/// A program that does not outlive its test.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
fn an_interrupt_leaves_whole_files() {
    let folder = library_folder("interrupt");
    let sources = harness_sources();
    let sources: Vec<&str> = sources.iter().map(String::as_str).collect();
    let harness = link(c_compiler(), &["-std=c99", "-O1"], &sources, &folder, "sins_harness");
    let out = folder.join("out");
    let _ = std::fs::remove_dir_all(&out);
    let mut flight = Command::new(harness);
    flight.args(["simulation1", "--every", "10", "--quiet", "--out", "out"]).current_dir(&folder);
    let mut flight = Running(flight.spawn().unwrap());
    // 48 h take many seconds; a first piece of a file is there long before.
    let begun = || std::fs::read_dir(&out).ok()?.next()?.ok()?.metadata().ok().filter(|file| file.len() > 0);
    while begun().is_none() {
        assert!(flight.0.try_wait().unwrap().is_none(), "ended by itself");
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    // The shell's own kill: the program of that name is not on every machine.
    succeed(Command::new("sh").args(["-c", "kill -INT \"$0\"", &flight.0.id().to_string()]));
    assert!(!flight.0.wait().unwrap().success());
    let csv = std::fs::read_to_string(out.join("simulation1_patrol.csv")).unwrap();
    let columns = |line: &str| line.split(',').count();
    assert!(
        csv.ends_with('\n') && csv.lines().all(|line| columns(line) == columns(csv.lines().next().unwrap()))
    );
    let summary = std::fs::read_to_string(out.join("simulation1_patrol_summary.csv")).unwrap();
    assert!(summary.contains("interrupted,1,"), "{summary}");
    assert!(summary.contains(&format!("records,{},", csv.lines().count() - 1)), "{summary}");
}
