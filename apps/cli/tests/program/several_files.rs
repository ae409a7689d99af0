//! Logs of autopilots, one message or topic a file: found, joined and flown.

use std::fmt::Write;
use std::path::Path;

use crate::judged::circle;
use crate::support::{done, folder, read, rejected, run};

/// The circle as the tool of ArduPilot writes it: positions at 5 Hz, the attitude at 25 Hz with other stamps.
fn ardupilot(folder: &Path) {
    let mut pos = "TimeUS,Lat,Lng,Alt,RelHomeAlt\n".to_owned();
    let mut att = "TimeUS,DesRoll,Roll,DesPitch,Pitch,DesYaw,Yaw\n".to_owned();
    let mut xkf = "TimeUS,C,Roll,Pitch,Yaw,VN,VE,VD\n".to_owned();
    for [t, latitude, longitude, height, ..] in circle(5, 140) {
        writeln!(pos, "{:.0},{latitude:.9},{longitude:.9},{height},0", 7e6 + t * 1e6).unwrap();
    }
    for [t, _, _, _, roll, pitch, heading, east, north] in circle(25, 140) {
        let stamp = 6.987e6 + t * 1e6;
        // The heading between the stamps of the circle: it turns by 3 degrees in a second.
        writeln!(att, "{stamp:.0},0,{roll},0,{pitch},0,{:.4}", (heading - 0.039).rem_euclid(360.0)).unwrap();
        writeln!(xkf, "{:.0},0,0,0,0,{north},{east},0", 7e6 + t * 1e6).unwrap();
        writeln!(xkf, "{:.0},1,0,0,0,{},{east},0", 7e6 + t * 1e6, north + 5.0).unwrap();
    }
    for (name, text) in [("POS", pos), ("ATT", att), ("XKF1", xkf)] {
        std::fs::write(folder.join(format!("{name}.csv")), text).unwrap();
    }
}

#[test]
fn files_of_ardupilot_are_found_and_fly_through_every_door() {
    let folder = folder("ardupilot");
    ardupilot(&folder);
    let said = done(&folder, &["log", "POS.csv", "--map", "map.toml"]);
    let joined = [
        "XKF1.csv: 3501 rows are left out: at the time of the row before",
        "ATT.csv is interpolated onto the rows of the log; left out: 1 outside of its times",
        "XKF1.csv is interpolated onto the rows of the log",
    ]
    .map(|what| format!("POS.csv: note: {what}\n"))
    .concat();
    assert!(said.contains(&joined) && !said.contains("coordinated"), "{said}");
    assert!(said.contains("POS.csv: 700 rows over 2.3 min, 5 Hz, with velocities\n"), "{said}");
    let map = read(folder.join("map.toml"));
    for key in [
        "roll = { col = \"Roll\", file = \"ATT.csv\" }",
        "heading = { col = \"Yaw\", file = \"ATT.csv\" }",
        "up = { col = \"VD\", sign = -1, file = \"XKF1.csv\" }",
    ] {
        assert!(map.contains(key), "{map}");
    }
    std::fs::create_dir(folder.join("scenes")).unwrap();
    let scene = format!("[flight]\nfile = \"../POS.csv\"\n{}", &map[map.find("[log]").unwrap()..]);
    std::fs::write(folder.join("scenes/scene.toml"), scene).unwrap();
    let mut commands = 0;
    for door in [
        &["scene", "check"][..],
        &["fly", "-q", "--preset", "navigation"],
        &["ensemble", "-q", "--runs", "2", "--preset", "navigation"],
        &["recommend", "--position", "1000"],
        &["budget", "--preset", "navigation"],
        &["curve"],
    ] {
        for log in [&["POS.csv", "--columns", "map.toml"][..], &["scenes/scene.toml"]] {
            let (code, _, errors) = run(&folder, &[door, &["--strict"], log].concat());
            assert!(code == 0 && errors.contains("ATT.csv is interpolated"), "{door:?} {log:?}: {errors}");
        }
        commands += 1;
    }
    // The attitude is that of the file, also where the heading passes north.
    let smooth = ["log", "POS.csv", "--columns", "map.toml", "--smooth", "-o", "truth.csv"];
    let (code, _, errors) = run(&folder, &smooth);
    assert_eq!(code, 0, "{errors}");
    for row in read(folder.join("truth.csv")).lines().skip(2) {
        let row: Vec<f64> = row.split(',').map(|field| field.parse().unwrap()).collect();
        let (t, roll, pitch, heading) = (row[0] - 7.0, row[7], row[8], row[9]);
        let turn = (heading - 3.0 * t + 180.0).rem_euclid(360.0) - 180.0;
        assert!((roll - 23.1).abs() < 1e-3 && (pitch - 2.0).abs() < 1e-3 && turn.abs() < 0.01, "{row:?}");
    }
    // An output never replaces a file that is read.
    let onto = ["log", "POS.csv", "--columns", "map.toml", "--smooth", "-o", "ATT.csv", "--force"];
    assert!(rejected(&folder, &onto).contains("ATT.csv"));
    std::fs::remove_file(folder.join("ATT.csv")).unwrap();
    assert!(
        rejected(&folder, &["fly", "POS.csv", "--columns", "map.toml"]).contains("ATT.csv: cannot be read")
    );
    std::fs::remove_file(folder.join("XKF1.csv")).unwrap();
    let said = done(&folder, &["log", "POS.csv", "--map", "alone.toml"]);
    assert!(
        said.contains("so that of a coordinated flight is taken") && !said.contains("interpolated"),
        "{said}"
    );
    println!("figure: through {commands} commands");
}

#[test]
fn topics_of_px4_are_found() {
    let folder = folder("px4");
    let mut position = "timestamp,timestamp_sample,lat,lon,alt,alt_ellipsoid,eph,epv\n".to_owned();
    let mut attitude = "timestamp,q[0],q[1],q[2],q[3]\n".to_owned();
    let mut local = "timestamp,vx,vy,vz\n".to_owned();
    for [t, latitude, longitude, height, _, _, heading, east, north] in circle(10, 60) {
        let (stamp, (sine, cosine)) = (t * 1e6, (heading.to_radians() / 2.0).sin_cos());
        writeln!(position, "{stamp:.0},0,{latitude:.9},{longitude:.9},{},{height},1,1", height - 45.0)
            .unwrap();
        writeln!(attitude, "{stamp:.0},{cosine},0,0,{sine}").unwrap();
        writeln!(local, "{stamp:.0},{north},{east},0").unwrap();
    }
    for (topic, text) in [
        ("vehicle_global_position", position),
        ("vehicle_attitude", attitude),
        ("vehicle_local_position", local),
    ] {
        std::fs::write(folder.join(format!("12_00_00_{topic}_0.csv")), text).unwrap();
    }
    let log = "12_00_00_vehicle_global_position_0.csv";
    let said = done(&folder, &["log", log, "--map", "map.toml"]);
    assert!(said.contains("the columns are of the format PX4 (vehicle_global_position)"), "{said}");
    assert!(said.contains("601 rows over 60 s, 10 Hz, with velocities"), "{said}");
    assert!(!said.contains("doubtful: ") && !said.contains("unusable"), "{said}");
    let map = read(folder.join("map.toml"));
    assert!(map.contains("q3 = { col = \"q[3]\", file = \"12_00_00_vehicle_attitude_0.csv\" }"), "{map}");
    assert!(
        map.contains("north = { col = \"vx\", file = \"12_00_00_vehicle_local_position_0.csv\" }"),
        "{map}"
    );
    let (code, _, errors) =
        run(&folder, &["log", log, "--columns", "map.toml", "--smooth", "-o", "truth.csv"]);
    assert_eq!(code, 0, "{errors}");
    let truth = read(folder.join("truth.csv"));
    let row: Vec<f64> =
        truth.lines().nth(1002).unwrap().split(',').map(|field| field.parse().unwrap()).collect();
    assert!((row[3] - 1500.0).abs() < 1e-3 && (row[9] - 3.0 * row[0]).abs() < 0.01, "{row:?}");
}

/// A second file is beside the log: a scene of somebody else shows no line of another folder, and waits for no pipe.
#[test]
fn no_file_outside_the_folder_of_the_log_is_read() {
    let folder = folder("outside");
    std::fs::create_dir_all(folder.join("logs/below")).unwrap();
    ardupilot(&folder.join("logs"));
    let secret = "TOP,SECRET\n1,2\n";
    for place in ["secret.csv", "logs/below/secret.csv", "logs/below/ATT.csv"] {
        std::fs::write(folder.join(place), secret).unwrap();
    }
    let said = done(&folder, &["log", "logs/POS.csv", "--map", "map.toml"]);
    assert!(said.contains("ATT.csv is interpolated"), "{said}");
    let map = read(folder.join("map.toml"));
    let absolute = folder.join("secret.csv").display().to_string();
    let fly = |file: &str| {
        let quoted = format!("file = '{file}'");
        std::fs::write(folder.join("other.toml"), map.replace("file = \"ATT.csv\"", &quoted)).unwrap();
        let keys: String = map[map.find("[log]").unwrap()..].replace("file = \"ATT.csv\"", &quoted);
        let scene = format!("[flight]\nfile = \"logs/POS.csv\"\n{keys}");
        std::fs::write(folder.join("scene.toml"), scene).unwrap();
        [&["fly", "logs/POS.csv", "--columns", "other.toml"][..], &["fly", "scene.toml"]].map(|arguments| {
            let errors = rejected(&folder, arguments);
            assert!(!errors.contains("SECRET"), "{file}: {errors}");
            errors
        })
    };
    for file in [
        absolute.as_str(),
        "../secret.csv",
        "below/secret.csv",
        "..",
        "./ATT.csv",
        r"..\secret.csv",
        r"below\secret.csv",
        r"\\host\share\secret.csv",
        r"C:\secret.csv",
        "C:secret.csv",
        "ATT.csv:stream",
        "/dev/stdin",
    ] {
        for errors in fly(file) {
            let expected =
                "log.roll.file: expected the name of a file beside the log, without a folder or a colon";
            assert!(errors.contains(expected), "{file}: {errors}");
        }
    }
    for errors in fly("below") {
        assert!(errors.contains("below: is no plain file: expected one beside the log"), "{errors}");
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::symlink;
        let logs = folder.join("logs");
        for (to, from) in
            [("../secret.csv", "up.csv"), ("below/ATT.csv", "down.csv"), ("/dev/zero", "zero.csv")]
        {
            symlink(to, logs.join(from)).unwrap();
            for errors in fly(from) {
                let expected =
                    format!("logs/{from}: is a link to another folder: expected a file beside the log");
                assert!(errors.contains(&expected), "{errors}");
            }
        }
        assert!(std::process::Command::new("mkfifo").arg(logs.join("pipe.csv")).status().unwrap().success());
        for errors in fly("pipe.csv") {
            assert!(errors.contains("logs/pipe.csv: is no plain file"), "{errors}");
        }
        // Links to the log and to the file beside it, and a link between two names, are those of one folder.
        std::fs::create_dir(folder.join("links")).unwrap();
        symlink("ATT.csv", logs.join("same.csv")).unwrap();
        for name in ["POS.csv", "ATT.csv", "XKF1.csv", "same.csv"] {
            symlink(logs.join(name), folder.join("links").join(name)).unwrap();
        }
        std::fs::write(folder.join("same.toml"), map.replace("ATT.csv", "same.csv")).unwrap();
        for arguments in [["links/POS.csv", "map.toml"], ["logs/POS.csv", "same.toml"]] {
            let [log, columns] = arguments;
            let (code, _, errors) = run(&folder, &["scene", "check", log, "--columns", columns]);
            assert!(code == 0 && errors.contains("is interpolated"), "{errors}");
        }
    }
}
