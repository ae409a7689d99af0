//! Records of an IMU whose columns `[imu]` describes, for `sins identify` and `sins allan`.

use std::io::Write;
use std::path::Path;
use std::process::Stdio;

use crate::support::{done, folder, read, rejected, result, run, sins};

const TRUTH: [&str; 5] = ["aerobatics", "--set", "flight.hours=0.03", "--set", "flight.rate_hz=50"];
const NAMES: [&str; 7] = ["t", "wx", "wy", "wz", "ax", "ay", "az"];

/// The rows of a record of known sensors: time [s], angles [rad], velocities [m/s], as texts.
fn rows(folder: &Path) -> Vec<Vec<String>> {
    rows_of(folder, &TRUTH)
}

fn rows_of(folder: &Path, truth: &[&str]) -> Vec<Vec<String>> {
    let fly =
        ["--quiet", "--preset", "industrial", "--imu", "imu.csv", "-o", ".", "--set", "options.subsamples=1"];
    done(folder, &[&["fly"], truth, &fly[..]].concat());
    let text = read(folder.join("imu.csv"));
    let header: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let place = |name: &str| {
        header.iter().position(|own| *own == name).unwrap_or_else(|| panic!("{name}: {header:?}"))
    };
    let places = [
        "time_s",
        "angle_increment_x_rad",
        "angle_increment_y_rad",
        "angle_increment_z_rad",
        "velocity_increment_x_m_s",
        "velocity_increment_y_m_s",
        "velocity_increment_z_m_s",
    ]
    .map(place);
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        places.iter().map(|place| cells[*place].to_owned()).collect()
    };
    text.lines().skip(1).map(row).collect()
}

fn table(header: &str, separator: &str, rows: &[Vec<String>]) -> String {
    let rows: String = rows.iter().map(|row| row.join(separator) + "\n").collect();
    format!("{header}\n{rows}")
}

/// What was found by the record `file` with these options: the sensors of the scene, and its `[imu]`.
fn found(folder: &Path, file: &str, more: &[&str]) -> (String, String) {
    let orders = [&["identify"], &TRUTH[..], &["--imu", file, "-o", "s.toml", "--force"], more].concat();
    done(folder, &orders);
    let scene = read(folder.join("s.toml"));
    let (sensors, imu) = scene.split_once("\n# How the record was read").unwrap_or_else(|| panic!("{scene}"));
    let (_, sensors) = sensors.split_once("\n[flight]").unwrap();
    (sensors.to_owned(), imu.split_once('\n').unwrap().1.to_owned())
}

fn write(folder: &Path, name: &str, text: impl AsRef<[u8]>) {
    std::fs::write(folder.join(name), text).unwrap();
}

/// One record in six forms, each with its `[imu]`, has the same sensors to the last digit; so has the `[imu]` that each of them writes.
#[test]
fn a_record_with_other_names_and_units_is_described() {
    let folder = folder("described");
    let rows = rows(&folder);
    let (sensors, imu) = found(&folder, "imu.csv", &[]);
    assert!(sensors.contains("\n[gyro]\n") && imu.contains("gyro_x = { col = "), "{sensors}{imu}");
    let keys = |parts: [&str; 7]| -> String {
        let keys =
            ["time", "gyro_x", "gyro_y", "gyro_z", "accelerometer_x", "accelerometer_y", "accelerometer_z"];
        keys.iter().zip(parts).map(|(key, part)| format!("{key} = {{ {part} }}\n")).collect()
    };
    let named = |unit: [&str; 2]| {
        keys([0, 1, 2, 3, 4, 5, 6].map(|place| {
            let unit = if place == 0 { "" } else { unit[(place - 1) / 3] };
            let unit = if unit.is_empty() { String::new() } else { format!(", unit = \"{unit}\"") };
            &*Box::leak(format!("col = \"{}\"{unit}", NAMES[place]).into_boxed_str())
        }))
    };
    let plain = named(["rad", "m/s"]);
    // The other sign of a number is exact.
    let negated = |text: &str| text.strip_prefix('-').map_or_else(|| format!("-{text}"), str::to_owned);
    let mut turned = rows.clone();
    turned.iter_mut().for_each(|row| row[6] = negated(&row[6]));
    let mut moved: Vec<Vec<String>> = rows.clone();
    moved.iter_mut().for_each(|row| row.reverse());
    let mut holes = rows.clone();
    for at in [100, 101, 700] {
        let mut hole = holes[at].clone();
        hole[3] = "-9999".to_owned();
        hole[0] = format!("{}", hole[0].parse::<f64>().unwrap() - 0.01);
        holes.insert(at, hole);
    }
    let commas: Vec<Vec<String>> =
        rows.iter().map(|row| row.iter().map(|cell| cell.replace('.', ",")).collect()).collect();
    let forms = [
        (table("t,wx,wy,wz,ax,ay,az", ",", &rows), plain.clone()),
        (
            table("recorder 7\n\nt;wx;wy;wz;ax;ay;az\n%s;%;%;%;%;%;%", ";", &commas),
            format!("separator = \"semicolon\"\nheader = 3\nskip = 1\n{plain}"),
        ),
        (
            table("# a\nt|wx|wy|wz|ax|ay|az", "|", &turned),
            format!(
                "separator = \"bar\"\n{}",
                plain.replace("\"az\", unit = \"m/s\"", "\"az\", unit = \"m/s\", sign = -1")
            ),
        ),
        (table("% nobody reads this", "   ", &moved), {
            let parts = [7, 6, 5, 4, 3, 2, 1].map(|place| {
                let unit = ["m/s", "rad", ""][usize::from(place > 3) + usize::from(place > 6)];
                let unit = if unit.is_empty() { String::new() } else { format!(", unit = \"{unit}\"") };
                &*Box::leak(format!("col = {place}{unit}").into_boxed_str())
            });
            format!("separator = \"blanks\"\ncomment = \"%\"\nheader = 0\n{}", keys(parts))
        }),
        (table("t,wx,wy,wz,ax,ay,az", ",", &holes), format!("missing = -9999\n{plain}")),
    ];
    for (place, (text, imu)) in forms.iter().enumerate() {
        write(&folder, "foreign.csv", text);
        write(&folder, "map.toml", format!("[imu]\n{imu}"));
        let (own, written) = found(&folder, "foreign.csv", &["--imu-map", "map.toml"]);
        assert_eq!(own, sensors, "{place}");
        // What is written reads back: in a file, and in the scene of the path.
        write(&folder, "map.toml", &written);
        assert_eq!(
            found(&folder, "foreign.csv", &["--imu-map", "map.toml"]),
            (sensors.clone(), written.clone()),
            "{place}"
        );
        done(&folder, &["scene", "check", "s.toml"]);
    }
    write(
        &folder,
        "truth.toml",
        format!("[flight]\nbuiltin = \"aerobatics\"\nhours = 0.03\nrate_hz = 50\n[imu]\n{plain}"),
    );
    write(&folder, "foreign.csv", &forms[0].0);
    let of_truth = ["identify", "truth.toml", "--imu", "foreign.csv", "-o", "t.toml"];
    done(&folder, &of_truth);
    assert!(read(folder.join("t.toml")).contains(&sensors[sensors.find("[gyro]").unwrap()..]));
    // It is said whose description a record does not fit.
    let errors = rejected(&folder, &["identify", "truth.toml", "--imu", "imu.csv"]);
    assert!(
        errors.contains("imu.time: no column t") && errors.contains("the [imu] of truth.toml was used"),
        "{errors}"
    );
    let two = ["identify", "truth.toml", "--imu", "foreign.csv", "--set", "imu.gyro_z="];
    let errors = rejected(&folder, &two);
    assert!(errors.contains("found 2 and 3") && errors.contains("the [imu] of truth.toml"), "{errors}");
    for none in ["none.csv", "."] {
        let errors = rejected(&folder, &["identify", "truth.toml", "--imu", none]);
        assert!(!errors.contains("the [imu] of"), "{errors}");
    }
}

/// The `[imu]` of what was guessed by names, by columns of the command line, by a rate and with a sign reads the same record again, and its
/// scene flies.
#[test]
fn what_was_guessed_reads_back() {
    let folder = folder("guessed");
    let rows = rows(&folder);
    let scaled = |unit: f64, rows: &[Vec<String>], first: usize| -> Vec<Vec<String>> {
        let cell = |(place, text): (usize, &String)| match place {
            0 => text.clone(),
            _ if (place - 1) / 3 == first => format!("{}", text.parse::<f64>().unwrap() * unit),
            _ => text.clone(),
        };
        rows.iter().map(|row| row.iter().enumerate().map(cell).collect()).collect()
    };
    let degrees = scaled(50.0 * 180.0 / std::f64::consts::PI, &rows, 0);
    let millis = |rows: &[Vec<String>]| -> Vec<Vec<String>> {
        let mut rows = rows.to_vec();
        rows.iter_mut().for_each(|row| row[0] = format!("{:.0}", row[0].parse::<f64>().unwrap() * 1e3));
        rows
    };
    let own = "time_s,delta_x_rad,delta_y_rad,delta_z_rad,delta_x_m_s,delta_y_m_s,delta_z_m_s";
    let plain = ["t=s", "wx=deg/s", "wy=deg/s", "wz=deg/s", "ax=m/s", "ay=m/s", "az=m/s"].join(",");
    for (text, more) in [
        (table(own, ",", &rows), vec![]),
        (
            table(
                "#timestamp [ms]\tx [deg/s]\ty [deg/s]\tz [deg/s]\tdelta x [m/s]\tdelta y [m/s]\tdelta z [m/s]",
                "\t",
                &millis(&degrees),
            ),
            vec![],
        ),
        (
            table(
                "time (ms);x (deg/s);y (deg/s);z (deg/s);delta x (m/s);delta y (m/s);delta z (m/s)",
                ";",
                &millis(&degrees),
            ),
            vec![],
        ),
        (table("t,wx,wy,wz,ax,ay,az", ",", &degrees), vec!["--imu-columns", &plain]),
        (table("t,wx,wy,wz,ax,ay,az", ",", &degrees), vec!["--imu-columns", &plain, "--rate", "50"]),
        (table(own, ",", &scaled(-1.0, &rows, 1)), vec!["--reversed"]),
    ] {
        write(&folder, "foreign.csv", &text);
        let (sensors, imu) = found(&folder, "foreign.csv", &more);
        std::fs::rename(folder.join("s.toml"), folder.join("map.toml")).unwrap();
        assert_eq!(
            found(&folder, "foreign.csv", &["--imu-map", "map.toml"]),
            (sensors, imu),
            "{more:?} {text:.90}"
        );
        done(&folder, &["fly", "s.toml", "--quiet", "--force", "--set", "flight.hours=0.01", "-o", "flown"]);
    }
}

/// What is wrong in an `[imu]` or with its record is named with key, value and limit, and nothing is written.
#[test]
fn what_is_wrong_in_a_description_is_named() {
    let folder = folder("wrong");
    let mut lines = String::from("t,wx,wy,wz,ax,ay,az,f_m_s2\n");
    for row in 0..60 {
        lines += &format!("{},0,0,0,0,0,9.8,0\n", 0.02 * f64::from(row));
    }
    write(&folder, "imu.csv", &lines);
    let good = "time = \"t\"\ngyro_x = { col = \"wx\", unit = \"deg/s\" }\ngyro_y = { col = \"wy\", unit = \"deg/s\" }\n\
        gyro_z = { col = \"wz\", unit = \"deg/s\" }\naccelerometer_x = { col = \"ax\", unit = \"m/s2\" }\n\
        accelerometer_y = { col = \"ay\", unit = \"m/s2\" }\naccelerometer_z = { col = \"az\", unit = \"m/s2\" }\n";
    let gyro = "gyro_x = { col = \"wx\", unit = \"deg/s\" }";
    let other = |to: &str| good.replace(gyro, to);
    let cases = [
        (other("gyro_x = { col = \"wX\", unit = \"deg/s\" }"), "imu.gyro_x: no column wX"),
        (other("gyro_x = { col = 9, unit = \"deg/s\" }"), "imu.gyro_x: no column 9: the row has 8"),
        (
            other("gyro_x = { col = \"wx\", unit = \"m/s2\" }"),
            "imu.gyro_x.unit: expected rad/s, deg/s, mdeg/s, deg/h",
        ),
        (
            other("gyro_x = \"wx\""),
            "imu.gyro_x.unit: the name of the column wx says no unit: expected one of rad/s",
        ),
        (
            other("gyro_x = \"f_m_s2\""),
            "imu.gyro_x.unit: the name of the column f_m_s2 says m/s2: expected one of rad/s",
        ),
        (other("gyro_x = 3"), "imu.gyro_x = 3: expected a column"),
        (other("gyro_x = { value = 0.1, unit = \"deg/s\" }"), "imu.gyro_x: expected a column"),
        (other("gyro_x = { col = \"wx\", sign = 2 }"), "imu.gyro_x.sign: expected 1 or -1"),
        (other("gyro_x = { col = \"wx\", hemisphere = \"t\" }"), "imu.gyro_x.hemisphere"),
        (
            other("gyro_x = { col = \"wx\", unit = \"deg/s\", file = \"../a\" }"),
            "imu.gyro_x.file: expected the name of a file",
        ),
        (other("gyro_w = \"wx\""), "gyro_w"),
        (other(""), "expected three columns of gyros and three of accelerometers, found 2 and 3"),
        (good.replace(" }", ", file = \"b.csv\" }"), "at least one must be in the record itself"),
        ("time = \"t\"\n".to_owned(), "imu: expected the column of a gyro or an accelerometer"),
        (
            other("gyro_x = { col = \"wy\", unit = \"deg/s\" }"),
            "imu.gyro_x and imu.gyro_y: both read the column wy: expected another",
        ),
        (
            other("gyro_x = { col = 6, unit = \"deg/s\" }"),
            "imu.gyro_x and imu.accelerometer_y: both read the column ay",
        ),
        (
            other("gyro_x = { col = \"t\", unit = \"deg/s\" }"),
            "imu.time and imu.gyro_x: both read the column t",
        ),
        (good.replace("time = \"t\"\n", ""), "imu.time: expected the column of the times"),
        (
            good.replace("\"t\"", "{ col = \"t\", unit = \"week\" }"),
            "imu.time.unit: expected s, ms, us, ns, min, h, d",
        ),
        (
            good.replace("\"t\"", "{ col = \"t\", file = \"a\" }"),
            "imu.time.file: each file has its own times",
        ),
        (format!("rate_hz = 50\n{good}"), "imu.rate_hz = 50: only for rows without times"),
        (format!("time_format = \"row\"\n{good}"), "imu.rate_hz: expected the rate of rows without times"),
        (
            format!("time_format = \"row\"\nrate_hz = 2e6\n{good}"),
            "imu.rate_hz = 2000000: must be from 0.001 to 1000000",
        ),
        (format!("comment = \"//\"\n{good}"), "imu.comment"),
        ("seed = 1\n".to_owned(), "seed"),
        (String::new(), "expected a section [imu] with the columns of the record"),
    ];
    for (imu, words) in cases {
        let section =
            if imu.is_empty() { "[options]\nseed = 1\n".to_owned() } else { format!("[imu]\n{imu}") };
        write(&folder, "map.toml", section);
        let order = [&["identify"], &TRUTH[..], &["--imu", "imu.csv", "--imu-map", "map.toml"]].concat();
        let errors = rejected(&folder, &order);
        assert!(errors.contains(words), "{imu}\n{words}\n{errors}");
        if !words.contains("three columns") {
            let errors = rejected(&folder, &["allan", "imu.csv", "--imu-map", "map.toml"]);
            assert!(errors.contains(words), "{imu}\n{words}\n{errors}");
        }
    }
    write(&folder, "map.toml", format!("[imu]\n{good}"));
    for (from, to, words) in [
        ("0.2,0,0,0", "0.2,0,none of it,0", "imu.csv:12: wy: expected a finite number, found \"none of it\""),
        ("0.2,0,0,0", "0.1,0,0,0", "imu.csv:12: column t: expected a stamp of 0.18"),
        ("\n0.4,0,0,0", "\n0.4,0,\"0,0", "imu.csv:22: a row goes on in the next line"),
    ] {
        write(&folder, "imu.csv", lines.replacen(from, to, 1));
        let order = [&["identify"], &TRUTH[..], &["--imu", "imu.csv", "--imu-map", "map.toml"]].concat();
        let errors = rejected(&folder, &order);
        assert!(errors.contains(words), "{words}\n{errors}");
    }
    assert!(!folder.join("imu_sensor.toml").exists() && !folder.join("imu_allan.html").exists());
}

/// Gyros and accelerometers in two files with the same stamps are one record. Nothing is interpolated: other stamps are refused.
#[test]
fn a_second_file_has_the_same_stamps() {
    let folder = folder("files");
    let rows = rows(&folder);
    let (sensors, _) = found(&folder, "imu.csv", &[]);
    let part = |places: [usize; 4]| -> Vec<Vec<String>> {
        rows.iter().map(|row| places.iter().map(|place| row[*place].clone()).collect()).collect()
    };
    let (gyros, accels) = (part([0, 1, 2, 3]), part([0, 4, 5, 6]));
    write(&folder, "gyro.csv", table("t,x,y,z", ",", &gyros));
    let of = |sensor: &str, unit: &str, file: &str| -> String {
        let line =
            |axis: &str| format!("{sensor}_{axis} = {{ col = \"{axis}\", unit = \"{unit}\"{file} }}\n");
        ["x", "y", "z"].map(line).concat()
    };
    let second = of("accelerometer", "m/s", ", file = \"accel.csv\"");
    write(&folder, "map.toml", format!("[imu]\ntime = \"t\"\n{}{second}", of("gyro", "rad", "")));
    write(&folder, "accel.csv", table("t,x,y,z", ",", &accels));
    let (own, imu) = found(&folder, "gyro.csv", &["--imu-map", "map.toml"]);
    assert_eq!(own, sensors);
    assert!(imu.contains("file = \"accel.csv\""), "{imu}");
    let order = [&["identify"], &TRUTH[..], &["--imu", "gyro.csv", "--imu-map", "map.toml"]].concat();
    let late = |by_s: f64| -> Vec<Vec<String>> {
        let mut rows = accels.clone();
        rows.iter_mut()
            .skip(500)
            .for_each(|row| row[0] = format!("{}", row[0].parse::<f64>().unwrap() + by_s));
        rows
    };
    write(&folder, "accel.csv", table("t,x,y,z", ",", &late(0.003)));
    let errors = rejected(&folder, &order);
    assert!(errors.contains("accel.csv:502: ") && errors.contains("must be within 0.002000 s"), "{errors}");
    write(&folder, "accel.csv", table("t,x,y,z", ",", &accels[1..]));
    let errors = rejected(&folder, &order);
    assert!(
        errors.contains(&format!("accel.csv: {} rows: must be the {} rows", accels.len() - 1, accels.len())),
        "{errors}"
    );
    std::fs::remove_file(folder.join("accel.csv")).unwrap();
    assert!(rejected(&folder, &order).contains("accel.csv"));
    // The lines that are quoted are those of the file with the fault.
    let mut faulty = accels;
    faulty[3][1] = "down".to_owned();
    write(&folder, "accel.csv", table("t,x,y,z", ",", &faulty));
    let errors = rejected(&folder, &order);
    assert!(errors.starts_with("accel.csv:5: ") || errors.starts_with("./accel.csv:5: "), "{errors}");
    assert!(errors.contains("accel.csv begins:") && errors.contains(",down,"), "{errors}");
    assert!(!errors.contains("gyro.csv"), "{errors}");
    write(&folder, "accel.csv", table("t,x,y,other", ",", &faulty));
    let errors = rejected(&folder, &order);
    assert!(errors.contains("accel.csv begins:") && !errors.contains("gyro.csv begins:"), "{errors}");
    std::fs::remove_file(folder.join("accel.csv")).unwrap();
    assert!(!rejected(&folder, &order).contains(" begins:"));
}

/// The noise of a record is the same by `[imu]` as by columns of the command line, to the last digit of its tables.
#[test]
fn allan_reads_the_same_description() {
    let folder = folder("allan");
    let mut state = 7_u32;
    let mut uniform = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 24) - 0.5
    };
    let rows: String = (0..4000).map(|k| format!("{};{}\n", 10 * k, uniform())).collect();
    write(&folder, "log.csv", format!("when;w\n{rows}"));
    write(
        &folder,
        "map.toml",
        "[imu]\nseparator = \"semicolon\"\ntime = { col = \"when\", unit = \"ms\" }\n\
        gyro_x = { col = \"w\", unit = \"deg/s\" }\n",
    );
    done(
        &folder,
        &["allan", "log.csv", "--columns", "when=ms,w=deg/s", "--csv", "a.csv", "--write", "a.toml"],
    );
    done(&folder, &["allan", "log.csv", "--imu-map", "map.toml", "--csv", "b.csv", "-o", "b.html"]);
    for name in ["", "_fit"] {
        assert_eq!(read(folder.join(format!("a{name}.csv"))), read(folder.join(format!("b{name}.csv"))));
    }
    // Its scene has the [imu] too.
    done(&folder, &["allan", "log.csv", "--imu-map", "a.toml", "--csv", "c.csv", "-o", "c.html"]);
    assert_eq!(read(folder.join("a.csv")), read(folder.join("c.csv")));
}

/// "-" is standard input for both commands, with `[imu]` and without; not for the path and the record at once.
#[test]
fn a_record_comes_from_standard_input() {
    let folder = folder("piped");
    let rows = rows(&folder);
    let (sensors, _) = found(&folder, "imu.csv", &[]);
    let piped = |arguments: &[&str], text: &[u8]| {
        let mut child = sins(&folder, arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // A program that refuses its arguments has closed the pipe.
        let _ = child.stdin.take().unwrap().write_all(text);
        result(&child.wait_with_output().unwrap())
    };
    let imu = read(folder.join("imu.csv"));
    let order = [&["identify"], &TRUTH[..], &["--imu", "-"]].concat();
    let (code, said, errors) = piped(&order, imu.as_bytes());
    assert_eq!((code, errors.as_str()), (0, ""), "{said}");
    assert!(said.starts_with("standard input: "), "{said}");
    assert!(read(folder.join("imu_sensor.toml")).contains(&sensors));
    write(
        &folder,
        "map.toml",
        "[imu]\ntime = \"t\"\ngyro_x = { col = \"wx\", unit = \"rad\" }\ngyro_y = { col = \"wy\", unit = \"rad\" }\n\
        gyro_z = { col = \"wz\", unit = \"rad\" }\naccelerometer_x = { col = \"ax\", unit = \"m/s\" }\n\
        accelerometer_y = { col = \"ay\", unit = \"m/s\" }\naccelerometer_z = { col = \"az\", unit = \"m/s\" }\n",
    );
    let foreign = table("t,wx,wy,wz,ax,ay,az", ",", &rows);
    let (code, said, errors) =
        piped(&[&order[..], &["--imu-map", "map.toml", "--force"]].concat(), foreign.as_bytes());
    assert_eq!((code, errors.as_str()), (0, ""), "{said}");
    assert!(read(folder.join("imu_sensor.toml")).contains(&sensors));
    let long = vec![b'x'; 20 << 20];
    for (arguments, text, words) in [
        (&["identify", "-", "--imu", "-"][..], imu.as_bytes(), "TRUTH and --imu are both \"-\""),
        (&order[..], b"", "no name of a column ends with the unit"),
        (&order[..], b"nothing here\n1\n2\n", "no name of a column ends with the unit"),
        (&order[..], &long[..], "more than 16777216 bytes"),
        (&["allan", "-"][..], &long[..], "more than 16777216 bytes"),
    ] {
        let (code, said, errors) = piped(arguments, text);
        assert!(code == 2 && errors.contains(words), "{arguments:?} {words}: {code} {said} {errors}");
    }
    let still: String = (0..200).map(|k| format!("{},{}\n", 0.01 * f64::from(k), (k * 7919) % 13)).collect();
    let (code, said, errors) = piped(&["allan", "-"], format!("time_s,w_deg_h\n{still}").as_bytes());
    assert_eq!((code, errors.as_str()), (0, ""), "{said}");
    assert!(folder.join("imu_allan.html").exists());
    let (code, ..) = run(&folder, &["identify", "-", "--imu", "imu.csv"]);
    assert_eq!(code, 2);
}

/// A comment that begins behind blanks is none of the rows, whether the columns are described or found.
#[test]
fn comments_begin_behind_blanks_too() {
    let folder = folder("comments");
    let rows = rows(&folder);
    let (sensors, imu) = found(&folder, "imu.csv", &[]);
    write(&folder, "map.toml", &imu);
    let text = read(folder.join("imu.csv"));
    let lines: Vec<&str> = text.lines().collect();
    let with = |comment: &str| [&lines[..50], &[comment], &lines[50..]].concat().join("\n") + "\n";
    for comment in ["# at rest", "  # at rest, engine off", "\t# at rest"] {
        write(&folder, "said.csv", with(comment));
        for more in [&[][..], &["--imu-map", "map.toml"]] {
            assert_eq!(found(&folder, "said.csv", more), (sensors.clone(), imu.clone()), "{comment:?}");
        }
    }
    // What begins behind blanks and is no comment stays a fault, at its line.
    write(&folder, "said.csv", with("  at rest"));
    let order = [&["identify"], &TRUTH[..], &["--imu", "said.csv", "--imu-map", "map.toml"]].concat();
    assert!(rejected(&folder, &order).contains("said.csv:51: "));
    assert_eq!(rows.len() + 1, lines.len());
}

/// What `--rate` does is said with a description too; a description is no standard input, and nothing is set without effect.
#[test]
fn what_an_option_does_is_said() {
    let folder = folder("options");
    rows(&folder);
    let (_, imu) = found(&folder, "imu.csv", &[]);
    write(&folder, "map.toml", &imu);
    let of = |more: &[&'static str]| {
        [&["identify"], &TRUTH[..], &["--imu", "imu.csv", "-o", "s.toml", "--force"], more].concat()
    };
    let counted = "rows at 50.00 Hz (--rate; the time stamps are not used) along ";
    for (more, is_said) in [
        (&["--rate", "50"][..], true),
        (&["--rate", "50", "--imu-map", "map.toml"], true),
        (&["--imu-map", "map.toml"], false),
        (&[], false),
    ] {
        assert_eq!(done(&folder, &of(more)).contains(counted), is_said, "{more:?}");
    }
    // A record without stamps has none that are not used.
    let row = imu.lines().filter(|line| !line.starts_with("time = "));
    write(
        &folder,
        "row.toml",
        row.collect::<Vec<_>>().join("\n") + "\ntime_format = \"row\"\nrate_hz = 50\n",
    );
    assert!(!done(&folder, &of(&["--rate", "50", "--imu-map", "row.toml"])).contains("--rate;"));
    // Also where a file has this name.
    write(&folder, "-", &imu);
    for order in [of(&["--imu-map", "-"]), vec!["allan", "imu.csv", "--imu-map", "-"]] {
        let errors = rejected(&folder, &order);
        assert!(errors.contains("--imu-map -: expected the name of a file"), "{errors}");
    }
    let columns = "time_s=s,angle_increment_x_rad,angle_increment_y_rad,angle_increment_z_rad,velocity_increment_x_m_s,\
         velocity_increment_y_m_s,velocity_increment_z_m_s";
    done(&folder, &of(&["--imu-columns", columns]));
    let errors = rejected(&folder, &of(&["--imu-columns", columns, "--set", "imu.separator=tab"]));
    assert!(errors.contains("--set imu.separator=tab: has no effect beside --imu-columns"), "{errors}");
}

/// Forces of the other sign: what is advised is not what was given, and mends it.
#[test]
fn a_sign_is_advised_where_it_mends() {
    let folder = folder("sign");
    let truth = ["racetrack", "--set", "flight.hours=0.15", "--set", "flight.rate_hz=50"];
    let mut rows = rows_of(&folder, &truth);
    for cell in rows.iter_mut().flat_map(|row| &mut row[4..]) {
        *cell = format!("{}", -cell.parse::<f64>().unwrap());
    }
    write(&folder, "turned.csv", table(&NAMES.join(","), ",", &rows));
    let order = |file, more: &[&'static str]| {
        [&["identify"], &truth[..], &["--imu", file, "-o", "s.toml", "--force"], more].concat()
    };
    let columns = ["--imu-columns", "t=s,wx=rad,wy=rad,wz=rad,ax=m/s,ay=m/s,az=m/s"];
    let errors = rejected(&folder, &order("turned.csv", &columns));
    assert!(errors.contains("; --reversed reads") && !errors.contains("[imu]"), "{errors}");
    let errors = rejected(&folder, &order("imu.csv", &["--reversed"]));
    assert!(errors.contains("; leave out --reversed"), "{errors}");
    let keys: String = (1..7)
        .map(|place| {
            let (sensor, unit) = if place < 4 { ("gyro", "rad") } else { ("accelerometer", "m/s") };
            let axis = ["x", "y", "z"][(place - 1) % 3];
            format!("{sensor}_{axis} = {{ col = \"{}\", unit = \"{unit}\" }}\n", NAMES[place])
        })
        .collect();
    let keys = format!("[imu]\ntime = \"t\"\n{keys}");
    write(&folder, "map.toml", &keys);
    let errors = rejected(&folder, &order("turned.csv", &["--imu-map", "map.toml"]));
    assert!(errors.contains("; --reversed reads") && errors.contains("in [imu] does"), "{errors}");
    done(&folder, &order("turned.csv", &["--imu-map", "map.toml", "--reversed"]));
    write(&folder, "map.toml", keys.replace("\"m/s\"", "\"m/s\", sign = -1"));
    done(&folder, &order("turned.csv", &["--imu-map", "map.toml"]));
    let errors = rejected(&folder, &order("turned.csv", &["--imu-map", "map.toml", "--reversed"]));
    assert!(errors.contains("; leave out --reversed"), "{errors}");
}

/// `--set imu.…` counts also beside the file of `--imu-map`, and a wrong one is named.
#[test]
fn a_setting_changes_a_description() {
    let folder = folder("set");
    let (sensors, imu) = {
        let rows = rows(&folder);
        let found = found(&folder, "imu.csv", &[]);
        write(&folder, "foreign.csv", table(&NAMES.join(";"), ";", &rows));
        found
    };
    let line = |key: &str, name: &str, unit: &str| format!("{key} = {{ col = \"{name}\"{unit} }}\n");
    let keys = ["gyro_x", "gyro_y", "gyro_z", "accelerometer_x", "accelerometer_y", "accelerometer_z"];
    let named = keys.iter().zip(1..).map(|(key, place)| {
        let unit = if place < 4 { ", unit = \"rad\"" } else { ", unit = \"m/s\"" };
        line(key, NAMES[place], unit)
    });
    write(&folder, "map.toml", format!("[imu]\n{}{}", line("time", "t", ""), named.collect::<String>()));
    let map = ["--imu-map", "map.toml", "--set"];
    let (own, written) = found(&folder, "foreign.csv", &[&map[..], &["imu.separator=semicolon"]].concat());
    assert!(own == sensors && written != imu && written.contains("separator = \"semicolon\""), "{written}");
    let order = [&["identify"], &TRUTH[..], &["--imu", "foreign.csv"], &map[..]].concat();
    let errors = rejected(&folder, &[&order[..], &["imu.separator=colon"]].concat());
    assert!(errors.contains("--set imu.separator=colon: "), "{errors}");
}
