//! Inputs of the program: faulty files are rejected with the line, pipes are read, nothing in a file steers the terminal.

use std::path::Path;
#[cfg(unix)]
use std::{
    io::Write,
    process::{Command, Stdio},
};

#[cfg(unix)]
use crate::support::sins;
use crate::support::{HEADER, done, folder, log, project_file, read, rejected, run, with_log};

#[test]
fn a_log_without_its_name_and_rows_of_more_fields_than_columns_are_no_flight() {
    let folder = folder("decimal_commas");
    std::fs::write(folder.join("commas.csv"), log().replace(",0.7,", ",0,7,")).unwrap();
    std::fs::write(folder.join("log.txt"), format!("# a title\n{}", log())).unwrap();
    let errors = rejected(&folder, &["fly", "log.txt"]);
    assert_eq!(errors, "log.txt: is a flight log: the name of its file must end in .csv\n");
    done(&folder, &["fly", "--log", "log.txt"]);
    for (mark, marks) in [(";", "semicolons"), ("\t", "tabs")] {
        std::fs::write(folder.join("marks.csv"), log().replace(',', mark)).unwrap();
        std::fs::write(folder.join("marks.txt"), log().replace(',', mark)).unwrap();
        let errors = rejected(&folder, &["fly", "marks.csv"]);
        assert!(errors.contains(&format!(
            "columns separated by {marks}: expected commas between fields, and decimal points, or separator = "
        )));
        assert!(errors.contains("`sins log marks.csv --map"), "{errors}");
        assert!(rejected(&folder, &["fly", "marks.txt"]).starts_with("marks.txt: is a flight log"));
    }
    let errors = rejected(&folder, &["fly", "commas.csv"]);
    assert!(errors.starts_with("commas.csv:2: 8 fields"), "{errors}");
    assert!(!folder.join("sins_out/commas.csv").exists());
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
    for order in [
        &["fly", "--log", "/dev/zero"][..],
        &["allan", "/dev/zero", "-o", "a.svg"],
        &["curve", "--instructions", "/dev/zero"],
    ] {
        assert!(rejected(&folder, order).contains("/dev/zero: is a device"), "{order:?}");
    }
    // A pipe is no run, because it has no summary beside it. The program does not wait for the pipe.
    assert!(rejected(&folder, &["report", "pipe.csv"]).contains("pipe_summary.csv"));
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
        (&["fly", "title.toml"], 2),
        (&["scene", "check", "title.toml"], 2),
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
        "bad.toml:4:1: no such key: bais_deg_h; did you mean bias_deg_h?",
        "bad.toml:5:14: gyro.bias_deg_h = \"x\"",
        "bad.toml:7:1: options.subsamples = 9",
        "lost.toml:3: nowhere.csv: cannot be read",
    ]) {
        assert!(line.starts_with(begin), "{line}");
    }
    assert_eq!(lines.len(), 4, "{errors}");
    // A bad sample is reported with the line of the log.
    let spoiled = log().replace("\n5,0.7,", "\n5,0.8,");
    std::fs::write(folder.join("jump.csv"), spoiled).unwrap();
    let errors = rejected(&folder, &["fly", "jump.csv"]);
    assert!(errors.contains("jump.csv:7: unusable: sample position: speed"), "{errors}");
    assert!(project_file("README.md").exists());
}

/// A sample that cannot be flown is reported by the names of its log and of its scene, in degrees.
#[test]
fn a_bad_sample_is_reported_in_the_words_of_the_log() {
    let folder = folder("sample");
    let flight = |rows: [&str; 3]| {
        let header = "time_s,latitude_deg,longitude_deg,height_m,velocity_east_m_s,velocity_north_m_s,velocity_up_m_s,\
            roll_deg,pitch_deg,heading_deg";
        let rows = rows.map(|row| format!("{row},0,0,0\n")).concat();
        std::fs::write(folder.join("log.csv"), format!("{header}\n{rows}")).unwrap();
    };
    for (last, expected) in [
        ("2,95,116,50,0,0,0", "log.csv:4: latitude_deg = 95: must be from -90 to 90\n"),
        ("2,39,116,50,0,1e6,0", "log.csv:4: velocity_north_m_s = 1000000: must be from -20000 to 20000\n"),
        (
            "9,39,116,50,0,0,0",
            "log.csv:4: unusable: time_s = 9: the gap after the last accepted sample must be at most options.max_gap_s = 2.5\nthe log is refused\n",
        ),
    ] {
        flight(["0,39,116,50,0,0,0", "1,39,116,50,0,0,0", last]);
        for command in [&["fly"][..], &["budget"], &["ensemble"], &["curve"], &["scene", "check"]] {
            let errors = rejected(&folder, &[command, &["log.csv"]].concat());
            assert!(errors.ends_with(expected), "{command:?}: {errors}");
        }
    }
    let warm = "gyro.bias_temperature_deg_h_per_k=1";
    let expected = "flight.temperature_c: is needed while temperature coefficients are set\n";
    assert!(rejected(&folder, &["fly", "simulation1", "--set", warm]).ends_with(expected));
    // The check of a scene reports what would stop the flight before its first record.
    for (set, expected) in [
        (warm, expected),
        ("output.every_s=0.001", "every_s = 0.001: must be at least the sample interval, 0.01\n"),
        (
            "output.folder=/tmp",
            "output.folder = \"/tmp\": expected a name below the folder of the outputs (--out), without ..\n",
        ),
    ] {
        let errors = rejected(&folder, &["scene", "check", "patrol", "--set", set]);
        assert!(errors.ends_with(expected), "{errors}");
    }
}

/// Files of other kinds are called what they are, wherever they are given.
#[test]
fn files_of_other_kinds_are_named() {
    let folder = with_log("foreign");
    let long = format!("{{\"a\": \"{}\"}}", "x".repeat(2 << 20));
    for (name, content, what) in [
        ("flight.kml", &b"<?xml version=\"1.0\"?>\n<kml></kml>\n"[..], "a map (KML)"),
        ("flight.ulg", b"ULog\x01\x12\x35\x01\0\0\0\0", "a log of PX4 (ULog)"),
        ("flight.xlsx", b"PK\x03\x04\x14\0\x06\0", "a compressed file (zip"),
        ("flight.nmea", b"$GPGGA,123519,4807.038,N\n", "sentences of a receiver (NMEA 0183)"),
        ("flight.json", long.as_bytes(), "a text in JSON"),
        ("flight.txt", b"t\0i\0m\0e\0", "a binary file"),
    ] {
        let table = Path::new(name).with_extension("csv");
        let table = table.to_str().unwrap();
        std::fs::write(folder.join(name), content).unwrap();
        std::fs::write(folder.join(table), content).unwrap();
        for (order, file) in [
            (&["fly", name][..], name),
            (&["fly", table], table),
            (&["scene", "check", name], name),
            (&["live", name, "--from", "udp:0", "--rate-hz", "9"], name),
            (&["report", table], table),
            (&["allan", table, "--rate", "1"], table),
            (&["curve", "rest", "--instructions", name], name),
        ] {
            let errors = rejected(&folder, order);
            let line = errors.lines().next().unwrap();
            assert!(line.starts_with(file) && line.contains(&format!("is {what}")), "{order:?}: {errors}");
        }
    }
    let errors = rejected(&folder, &["fly", "flight.kml"]);
    let advice = "a flight of your own is a log in a file .csv; docs/your_log.md says what a log has\n";
    assert!(errors.ends_with(advice), "{errors}");
    // What nobody knows is read as what its name says.
    std::fs::write(folder.join("notes.txt"), "some words\n".repeat(300)).unwrap();
    let errors = rejected(&folder, &["fly", "notes.txt"]);
    assert_eq!(errors.lines().count(), 2, "{errors}");
    assert!(
        errors.ends_with(
            "notes.txt: is read as a scene in TOML, because its name does not end in .csv; --log or --columns reads it as a log\n"
        ),
        "{errors}"
    );
}

/// A table without the needed columns is answered with those that it has.
#[test]
fn a_header_is_quoted() {
    let folder = folder("header");
    let table = "Time,Lat (deg),Lon,Alt,v1,v2,v3,v4,v5,v6,v7,v8,v9\n0,1,2,3,4,5,6,7,8,9,10,11,12\n";
    std::fs::write(folder.join("own.csv"), table).unwrap();
    std::fs::write(folder.join("own_summary.csv"), table).unwrap();
    std::fs::write(folder.join("run.csv"), table).unwrap();
    std::fs::write(folder.join("run_summary.csv"), "key,value,unit,label\n").unwrap();
    for order in [
        &["fly", "own.csv"][..],
        &["scene", "check", "own.csv"],
        &["report", "own.csv"],
        &["report", "run.csv"],
        &["allan", "own.csv"],
        &["allan", "own.csv", "--columns", "gyro_x_deg_h"],
        &["curve", "rest", "--instructions", "own.csv"],
    ] {
        let errors = rejected(&folder, order);
        assert!(
            errors.contains(" Time, Lat (deg), Lon, Alt, v1, v2, v3, v4, v5, v6, v7, v8, ...\n"),
            "{errors}"
        );
    }
}

/// Stamps in another unit than seconds are asked for; a gap in a log whose stamps are in seconds is not.
#[test]
fn the_unit_of_stamps_is_asked_for() {
    let folder = folder("stamps");
    let write = |stamp: &dyn Fn(u32) -> String| {
        let rows: String = (0..20).map(|k| format!("{},0.7,2.0,50,0,0,1\n", stamp(k))).collect();
        std::fs::write(folder.join("log.csv"), format!("{HEADER}\n{rows}")).unwrap();
        rejected(&folder, &["fly", "log.csv"])
    };
    for (stamp, words) in [
        (
            (&|k: u32| (k * 20).to_string()) as &dyn Fn(u32) -> String,
            "max_gap_s = 2.5; are the stamps in ms?\n",
        ),
        (&|k| (k * 20_000).to_string(), "max_gap_s = 2.5; are the stamps in microseconds?\n"),
        (&|k| (u64::from(k) * 20_000_000).to_string(), "max_gap_s = 2.5; are the stamps in nanoseconds?\n"),
        (
            &|k| (1_760_000_000_000 + u64::from(k) * 20).to_string(),
            "must be from -1e10 to 1e10; is it in ms?\n",
        ),
        (&|k| format!("{}", f64::from(k) + if k > 9 { 60.0 } else { 0.0 }), "max_gap_s = 2.5\n"),
    ] {
        let errors = write(stamp);
        assert!(errors.contains(words), "{errors}");
    }
}

/// A gap that the flight bridges is said, by the check of the scene, in the summary and in its file.
#[test]
fn gaps_of_a_log_are_said() {
    let folder = folder("gaps");
    let rows = ["0", "0.5", "1", "1.5", "3.5", "4"].map(|time_s| format!("{time_s},39,116,50,0,0,0\n"));
    let header = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n";
    std::fs::write(folder.join("log.csv"), format!("{header}{}", rows.concat())).unwrap();
    let gaps = "1, of 2 s, before log.csv:6, bridged\n";
    let note = "log.csv:6: note: a gap of 2 s in the time stamps, before 3.5 s. Remedy: if the vehicle manoeuvred there, fill the gaps\n";
    let (code, checked, errors) = run(&folder, &["scene", "check", "log.csv"]);
    assert!(checked.ends_with(&format!("; gaps: {gaps}")));
    assert_eq!((code, errors.as_str()), (0, note));
    let (code, printed, errors) = run(&folder, &["fly", "log.csv"]);
    assert_eq!((code, errors.as_str()), (0, note));
    assert!(printed.contains(&format!("  gaps            {gaps}")), "{printed}");
    let summary = read(folder.join("sins_out/log_summary.csv"));
    assert!(summary.contains("\ngaps,1,,") && summary.contains("\ngap_longest_s,2,s,"), "{summary}");
    // Also in the first interval.
    let rows = ["0", "2", "2.1", "2.2"].map(|time_s| format!("{time_s},39,116,50,0,0,0\n"));
    std::fs::write(folder.join("first.csv"), format!("{header}{}", rows.concat())).unwrap();
    assert!(
        done(&folder, &["scene", "check", "first.csv"])
            .ends_with("; gaps: 1, of 2 s, before first.csv:3, bridged\n")
    );
    assert!(!done(&folder, &["fly", "rest", "--set", "flight.hours=0.01"]).contains("gaps"));
}

/// A page has the curves of each run.
#[test]
fn a_page_has_a_limit_of_runs() {
    let folder = folder("many_runs");
    let names: Vec<String> = (0..101).map(|run| format!("run_{run}.csv")).collect();
    let arguments: Vec<&str> = ["report"].into_iter().chain(names.iter().map(String::as_str)).collect();
    let errors = rejected(&folder, &arguments);
    assert!(
        errors.starts_with("101 runs: a page has at most 100; `sins ensemble` flies many runs"),
        "{errors}"
    );
    // Of 100, the first that is not there is named.
    assert!(rejected(&folder, &arguments[..101]).contains("run_0_summary.csv"));
}

/// A word that is misspelt is one fault, with the word that was meant.
#[test]
fn a_misspelt_preset_is_one_fault() {
    let folder = folder("misspelt");
    for command in [&["fly"][..], &["ensemble"], &["scene", "check"], &["budget"], &["scene", "write"]] {
        for (word, meant) in [("navigatoin", "navigation"), ("tact", "tactical"), ("stratgeic", "strategic")]
        {
            let errors = rejected(&folder, &[command, &["patrol", "--preset", word]].concat());
            assert_eq!(errors.matches("expected").count(), 1, "{errors}");
            assert!(errors.contains(&format!("consumer, paper2; did you mean {meant}?")), "{errors}");
        }
        // Another fault is another sentence, and a word that is near none has none.
        let both =
            ["patrol", "--preset", "good", "--set", "gyro.preset=idael", "--set", "options.scheme=exakt"];
        let errors = rejected(&folder, &[command, &both].concat());
        assert_eq!(errors.matches("expected").count(), 3, "{errors}");
        assert_eq!(errors.matches("did you mean").count(), 2, "{errors}");
    }
}
