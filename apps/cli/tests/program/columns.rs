//! Logs with columns of their own, read by `[log]` of a scene or of `--columns`.

use std::fmt::Write;
use std::path::Path;

use crate::draws::Draws;
use crate::judged::{circle, write};
use crate::support::{done, folder, project_file, read, rejected, run};

const MAPPING: &str = "[log]\nheader = 2\ntime = \"t\"\ntime_format = \"hms\"\nlatitude = \"Lat\"\nlongitude = \"Lon\"\n\
    height = { col = \"Alt\", unit = \"ft\" }\nroll = \"Roll\"\npitch = \"Pitch\"\nheading = \"Hdg\"\n\
    east = { col = \"VE\", unit = \"kt\" }\nnorth = { col = \"VN\", unit = \"kt\" }\nup = { col = \"VD\", unit = \"kt\", sign = -1 }\n";

/// The circle in other units, over midnight.
fn save(path: &Path) {
    let mut text = "made up\nt,Lat,Lon,Alt,Roll,Pitch,Hdg,VN,VE,VD\n".to_owned();
    for [t, latitude, longitude, height, roll, pitch, heading, east, north] in circle(10, 60) {
        let (clock, knots) = ((t + 86370.0) % 86400.0, 3600.0 / 1852.0);
        let (hours, minutes, seconds) = ((clock / 3600.0) as u32, (clock / 60.0) as u32 % 60, clock % 60.0);
        let (feet, east, north) = (height / 0.3048, knots * east, knots * north);
        writeln!(
            text,
            "{hours:02}:{minutes:02}:{seconds:04.1},{latitude},{longitude},{feet},{roll},{pitch},{heading},{north},{east},0"
        )
        .unwrap();
    }
    std::fs::write(path, text).unwrap();
}

/// The path of a noisy log with an outlier and repeated rows is smoothed behind every door, by the scene or by `--set`.
#[test]
fn a_scene_smooths_its_log_through_every_door() {
    let folder = folder("smoothed");
    let mut rows = circle(10, 60);
    let mut draws = Draws::new(1);
    for row in &mut rows {
        row[1] += draws.within(-1e-5, 1e-5);
    }
    rows[300][1] += 0.01;
    write(&folder.join("noisy.csv"), &rows, false);
    std::fs::write(folder.join("scene.toml"), "[flight]\nfile = \"noisy.csv\"\n[log]\nsmooth = \"auto\"\n")
        .unwrap();
    assert!(rejected(&folder, &["fly", "noisy.csv"]).contains("unusable"));
    let smooth = ["--set", "log.smooth=auto", "noisy.csv"];
    for door in [
        &["scene", "check"][..],
        &["fly", "-q"],
        &["ensemble", "-q", "--runs", "2", "--preset", "navigation"],
        &["recommend", "--position", "1000"],
        &["budget", "--preset", "navigation"],
        &["curve"],
    ] {
        for log in [&["scene.toml"][..], &smooth] {
            let (code, _, errors) = run(&folder, &[door, &["--strict"], log].concat());
            assert!(
                code == 0 && errors.contains("note: position: motion above"),
                "{door:?} {log:?}: {errors}"
            );
            assert!(errors.contains("; 1 outlier; "), "{door:?}: {errors}");
        }
    }
    assert_eq!(read(folder.join("sins_out/noisy.csv")), read(folder.join("sins_out/scene.csv")));
    let rejected = rejected(&folder, &["fly", "scene.toml", "--set", "log.smooth_rate_hz=1e-3"]);
    assert!(rejected.contains("log.smooth_rate_hz = 0.001"), "{rejected}");
}

#[test]
fn a_log_with_columns_of_its_own_flies_through_every_door() {
    let folder = folder("columns");
    save(&folder.join("foreign.csv"));
    std::fs::write(folder.join("columns.toml"), MAPPING).unwrap();
    std::fs::write(folder.join("scene.toml"), format!("[flight]\nfile = \"foreign.csv\"\n{MAPPING}"))
        .unwrap();
    write(&folder.join("own.csv"), &circle(10, 60), true);
    done(&folder, &["fly", "-q", "own.csv", "--preset", "navigation"]);
    done(&folder, &["fly", "-q", "foreign.csv", "--columns", "columns.toml", "--preset", "navigation"]);
    done(&folder, &["fly", "-q", "scene.toml", "--preset", "navigation"]);
    let records = |name: &str| read(folder.join(format!("sins_out/{name}.csv")));
    assert_eq!(records("foreign"), records("scene"));
    let end = |name: &str| -> Vec<f64> {
        let text = records(name);
        text.lines().last().unwrap().split(',').skip(1).map(|field| field.parse().unwrap_or(0.0)).collect()
    };
    assert!(end("foreign").len() > 10);
    for (foreign, own) in end("foreign").iter().zip(end("own")) {
        // The numbers differ by the rounding of feet, knots and the time of day.
        assert!((foreign - own).abs() < 1e-5 * (1.0 + own.abs()), "{foreign}, not {own}");
    }
    for door in [
        &["scene", "check"][..],
        &["ensemble", "-q", "--runs", "2", "--preset", "navigation"],
        &["recommend", "--position", "1000"],
        &["budget", "--preset", "navigation"],
        &["curve"],
    ] {
        for log in [&["scene.toml"][..], &["foreign.csv", "--columns", "columns.toml"]] {
            let (code, _, errors) = run(&folder, &[door, &["--strict"], log].concat());
            assert!(code == 0 && !errors.contains("note"), "{door:?} {log:?}: {errors}");
        }
    }
    let said = done(&folder, &["log", "foreign.csv", "--columns", "columns.toml"]);
    assert_eq!(said, "foreign.csv: 601 rows over 60 s, 10 Hz, with velocities\nnothing is doubtful\n");
    // A scene that is written has the columns too.
    std::fs::write(folder.join("plain.toml"), "[flight]\nfile = \"foreign.csv\"\n").unwrap();
    done(&folder, &["scene", "write", "plain.toml", "--columns", "columns.toml", "-o", "both.toml"]);
    done(&folder, &["scene", "check", "--strict", "both.toml"]);
    // A single value in addition: with the wrong unit the judge knows it.
    let (code, _, errors) = run(
        &folder,
        &[
            "fly",
            "-q",
            "foreign.csv",
            "--columns",
            "columns.toml",
            "--set",
            "log.east=VE",
            "--set",
            "log.north=VN",
            "--set",
            "log.up=VD",
        ],
    );
    assert!(code == 2 && errors.contains("velocity is 1.94 times the displacement (knots?)"), "{errors}");
    let errors =
        rejected(&folder, &["fly", "foreign.csv", "--columns", "columns.toml", "--set", "log.pitch=Pich"]);
    assert!(errors.contains("foreign.csv:2: log.pitch: no column Pich; "), "{errors}");
    assert!(errors.contains("did you mean Pitch?"), "{errors}");
    std::fs::write(folder.join("bad.toml"), "[log]\nhight = \"Alt\"\n").unwrap();
    let errors = rejected(&folder, &["fly", "foreign.csv", "--columns", "bad.toml"]);
    assert!(errors.contains("bad.toml:2:1: no such key: hight; did you mean height?"), "{errors}");
}

/// Each door that cannot read a stranger's table names the command that finds its columns, if they can be found.
#[test]
fn an_error_about_columns_names_the_command_that_finds_them() {
    let folder = folder("hint");
    std::fs::copy(project_file("c_examples/flights/cockpit.csv"), folder.join("my log.csv")).unwrap();
    let command = "`sins log \"my log.csv\" --map columns.toml`";
    for order in ["fly", "log", "ensemble"] {
        let errors = rejected(&folder, &[order, "my log.csv"]);
        assert!(errors.contains("missing columns") && errors.contains(command), "{order}: {errors}");
    }
    let (code, said, _) = run(&folder, &["log", "my log.csv", "--map", "columns.toml"]);
    assert!(
        code == 0 && said.ends_with("next: `sins fly \"my log.csv\" --columns columns.toml`\n"),
        "{said}"
    );
    let order = ["fly", "my log.csv", "--columns", "columns.toml", "--name", "my flight"];
    let (code, said, _) = run(&folder, &order);
    assert!(code == 0 && said.contains("`sins report \"sins_out/my flight.csv\"`"), "{said}");

    // Those of other programs begin with lines of their own, and their names say what they are.
    let table = "#airframe_info,log_version=\"1.00\"\n#yyy-mm-dd, hh:mm:ss\n  Lcl Date, Lcl Time, Latitude, Longitude, AltMSL, GndSpd, VSpd, Pitch, Roll, HDG, TRK\n\
        2024-05-01, 10:00:00, 47.1, 8.1, 1000, 100, 0, 1, 1, 90, 90\n2024-05-01, 10:00:01, 47.1, 8.1007, 1000, 100, 0, 1, 1, 90, 90\n";
    std::fs::write(folder.join("g1000.csv"), table).unwrap();
    for order in ["fly", "log"] {
        let errors = rejected(&folder, &[order, "g1000.csv"]);
        for words in [
            "is a log of a cockpit (Garmin)",
            "`sins log g1000.csv --map columns.toml` finds its columns",
            "`sins fly g1000.csv --columns columns.toml` flies it",
        ] {
            assert!(errors.contains(words), "{order}: {errors}");
        }
    }

    std::fs::write(folder.join("nothing.csv"), "a,b,c\n0,1,2\n1,2,3\n2,3,4\n").unwrap();
    let errors = rejected(&folder, &["fly", "nothing.csv"]);
    assert!(errors.contains("missing columns") && !errors.contains("--map"), "{errors}");
}

/// What a table does not say is asked, and the file that is written flies nothing until a line of it is taken for the answer.
#[test]
fn what_is_unknown_is_asked_and_the_answer_flies() {
    let folder = folder("asked");
    let rows =
        circle(10, 60).into_iter().map(|[t, latitude, longitude, height, roll, pitch, heading, ..]| {
            format!("{},{latitude},{longitude},{height},{roll},{pitch},{heading}\n", t * 1e4)
        });
    let table = "Moment,lat,lon,alt (m),roll (deg),pitch (deg),heading (deg)\n".to_owned();
    std::fs::write(folder.join("a.csv"), table + &rows.collect::<String>()).unwrap();
    let errors = rejected(&folder, &["log", "a.csv", "--map", "map.toml"]);
    let answer = "time = { col = \"Moment\", scale = 1e-4 }";
    let meaning = format!("{answer}  # 10 Hz");
    assert!(errors.contains("no column is understood as the time") && errors.contains(&meaning), "{errors}");
    assert!(errors.contains("look again: `sins log a.csv --columns map.toml`"), "{errors}");
    let map = read(folder.join("map.toml"));
    let mark = format!("#   {answer}");
    assert!(map.contains(&mark), "{map}");
    rejected(&folder, &["fly", "a.csv", "--columns", "map.toml"]);
    std::fs::write(folder.join("map.toml"), map.replace(&mark, answer)).unwrap();
    let said = done(&folder, &["log", "a.csv", "--columns", "map.toml"]);
    assert!(said.starts_with("a.csv: 601 rows over 60 s, 10 Hz"), "{said}");
    done(&folder, &["fly", "-q", "a.csv", "--columns", "map.toml"]);
}

/// Fixes of 1 Hz that are held between them: the next command smooths the log, and the path flies.
#[test]
fn a_log_of_held_fixes_is_smoothed_by_the_command_that_is_named() {
    let folder = folder("held");
    let rows: String = (0..3000)
        .map(|k| {
            let time_s = f64::from(k) / 50.0;
            let latitude_deg = 48.0 + 60.0 * time_s.floor() / 111_200.0;
            format!("{time_s:.2},{latitude_deg:.8},11,500,0,0.03,0,60,0,0\n")
        })
        .collect();
    let names = "TimeFromStart (s),GNSSPosLat (deg),GNSSPosLon (deg),GNSSPosAlt (m),AngleRoll (rad),AnglePitch (rad),\
                 AngleHeading (rad),GNSSVelNorth (m/s),GNSSVelEast (m/s),GNSSVelDown (m/s)\n";
    std::fs::write(folder.join("held.csv"), names.to_owned() + &rows).unwrap();
    let (code, said, _) = run(&folder, &["log", "held.csv", "--map", "held.toml"]);
    let named = "sins log held.csv --columns held.toml --smooth -o TRUTH.csv";
    assert!(
        code == 2 && said.contains(&format!("next: smooth it: `{named}`; or, if a column is wrong")),
        "{said}"
    );
    let words: Vec<&str> = named.split(' ').skip(1).collect();
    for arguments in [&words[..], &["fly", "TRUTH.csv", "--quiet", "-o", "out"]] {
        let (code, _, errors) = run(&folder, arguments);
        assert_eq!(code, 0, "{arguments:?}: {errors}");
    }
    // Smoothing does not cure a roll of the other sign.
    let turn: String = (0..3000)
        .map(|k| {
            let (time_s, angle) = (f64::from(k) / 50.0, f64::from(k) / 50.0 * 0.15);
            let (north_m, east_m) = (400.0 * angle.sin(), 400.0 * (1.0 - angle.cos()));
            let (latitude_deg, longitude_deg) = (48.0 + north_m / 111_200.0, 11.0 + east_m / 74_500.0);
            let (latitude_deg, longitude_deg) =
                ((latitude_deg * 1e5).round() / 1e5, (longitude_deg * 1e5).round() / 1e5);
            format!(
                "{time_s:.2},{latitude_deg:.5},{longitude_deg:.5},500,-42.5,2,{:.2}\n",
                angle.to_degrees()
            )
        })
        .collect();
    let names = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n";
    std::fs::write(folder.join("roll.csv"), names.to_owned() + &turn).unwrap();
    let (code, said, _) = run(&folder, &["log", "roll.csv", "--map", "roll.toml"]);
    assert!(
        code == 2
            && said.contains("opposite sign")
            && said.contains("smooth the log")
            && said.contains("next: mend roll.toml"),
        "{said}"
    );
}

/// A file of `--columns` may have a flight, in whichever way TOML writes one, or none, also with a title of it.
#[test]
fn a_file_of_columns_may_have_a_flight() {
    let folder = folder("flights");
    save(&folder.join("foreign.csv"));
    for flight in [
        "",
        "[flight]\ntitle = \"x\"\n",
        "# [flight]\n",
        "[flight]\nbuiltin = \"rest\"\n",
        "[ flight ]\nbuiltin = \"rest\"\n",
        "[\"flight\"]\nbuiltin = \"rest\"\n",
        "flight.builtin = \"rest\"\n",
        "flight = { builtin = \"rest\" }\n",
        "\u{feff}[flight]\nbuiltin = \"rest\"\n",
        "[[ manoeuvre ]]\nkind = \"straight\"\nduration_s = 60\n",
    ] {
        std::fs::write(folder.join("columns.toml"), format!("{flight}{MAPPING}")).unwrap();
        let (code, said, errors) = run(&folder, &["log", "foreign.csv", "--columns", "columns.toml"]);
        assert!(code == 0 && said.ends_with("nothing is doubtful\n"), "{flight}: {errors}");
    }
    std::fs::write(folder.join("columns.toml"), format!("flight = 3\n{MAPPING}")).unwrap();
    let errors = rejected(&folder, &["log", "foreign.csv", "--columns", "columns.toml"]);
    assert!(errors.contains("columns.toml:1:") && errors.contains("expected [flight]"), "{errors}");
}
