//! `sins identify` from a record to a scene that flies.

use std::path::Path;

use crate::support::{done, folder, read, run};

/// Flies five minutes of aerobatics with known sensors, and writes their increments.
fn record(folder: &Path, flight: &str, more: &[&str]) {
    let settings = [
        "gyro.bias_deg_h=[20, -30, 40]",
        "gyro.scale_factor_ppm=[400, -300, 200]",
        "gyro.random_walk_deg_sqrt_h=0.1",
        "accelerometer.bias_micro_g=[1500, -1000, 500]",
        "accelerometer.random_walk_micro_g_sqrt_hz=60",
        "options.subsamples=1",
        "flight.rate_hz=50",
        "flight.hours=0.08",
    ];
    let set = settings.iter().chain(more).flat_map(|setting| ["--set", *setting]);
    let arguments: Vec<&str> =
        ["fly", flight, "--quiet", "--imu", "imu.csv", "--force", "-o", "."].into_iter().chain(set).collect();
    done(folder, &arguments);
}

/// The values of a key of the scene.
fn values(scene: &str, section: &str, key: &str) -> Vec<f64> {
    let part =
        scene.split(&format!("\n[{section}]\n")).nth(1).unwrap_or_else(|| panic!("[{section}]: {scene}"));
    let part = part.split("\n[").next().unwrap();
    let line = part
        .lines()
        .find_map(|line| line.strip_prefix(&format!("{key} = [")))
        .unwrap_or_else(|| panic!("{key}: {part}"));
    line.trim_end_matches(']').split(", ").map(|number| number.parse().unwrap()).collect()
}

/// A lever arm, a g-sensitivity and an asymmetry come back if they are asked for, and stand in the scene; otherwise the arm is refused.
#[test]
fn what_is_asked_for_beside_stands_in_the_scene() {
    let folder = folder("also");
    let own = [
        "mounting.lever_arm_m=[0.3, -0.2, 0.1]",
        "gyro.g_sensitivity_deg_h_per_g=[0, 30, 0, 0, 0, 0, 0, 0, -40]",
        "accelerometer.scale_factor_asymmetry_ppm=[0, 0, 900]",
    ];
    record(&folder, "aerobatics", &own);
    let refused = run(&folder, &identify(&[])).2;
    assert!(
        refused.contains("record.lever_arm_m = 0.3") && refused.contains("--also lever-arm finds it"),
        "{refused}"
    );
    let also = ["--also", "lever-arm,g-sensitivity,asymmetry"];
    let table =
        done(&folder, &identify(&[&also[..], &["--prior", "tactical", "--page", "also.html"]].concat()));
    assert!(
        table.contains("  g-sensitivity xy ")
            && table.contains("  lever arm x ")
            && table.contains("  asymmetry z "),
        "{table}"
    );
    let scene = read(folder.join("imu_sensor.toml"));
    let near = |section: &str, key: &str, truth: &[f64], within: f64| {
        let found = values(&scene, section, key);
        let off = found.iter().zip(truth).map(|(found, truth)| (found - truth).abs()).fold(0.0, f64::max);
        assert!(found.len() == truth.len() && off < within, "{key}: {found:?}");
    };
    near("mounting", "lever_arm_m", &[0.3, -0.2, 0.1], 0.01);
    near("gyro", "g_sensitivity_deg_h_per_g", &[0.0, 30.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -40.0], 6.0);
    near("accelerometer", "scale_factor_asymmetry_ppm", &[0.0, 0.0, 900.0], 300.0);
    let json = done(&folder, &identify(&[&also[..], &["--json", "-o", "b.toml"]].concat()));
    assert!(json.contains("\"lever arm y\": {\"value\": -0.2") && json.contains("\"asymmetry x\""), "{json}");
    done(&folder, &["fly", "imu_sensor.toml", "--quiet", "--set", "flight.hours=0.02", "-o", "again"]);
    for (more, named) in [
        (&["--also", "nonlinearity"][..], "lever-arm, g-sensitivity, asymmetry, temperature"),
        (
            &["--also", "temperature"],
            "temperature_c is a column of the log of the path, also by `temperature` of its [log], or a key of [flight]",
        ),
        (&["--also", "lever-arm", "--check"], "--also lever-arm: --check flies from the point of the path"),
        (&["--also", "lever-arm", "--set", "mounting.lever_arm_m=[1,0,0]"], "expected one of both"),
    ] {
        let said = run(&folder, &identify(more)).2;
        assert!(said.contains(named), "{said}");
    }
}

/// The change of a bias with the temperature of the flight comes back, and its scene flies with this temperature.
#[test]
fn a_change_with_temperature_stands_in_the_scene() {
    let folder = folder("temperature");
    let warm = ["flight.temperature_c=20", "flight.temperature_change_c_h=250"];
    let own = ["gyro.bias_temperature_deg_h_per_k=[0, 12, 0]", "gyro.reference_temperature_c=25"];
    record(&folder, "aerobatics", &[warm, own].concat());
    let more = ["--also", "temperature", "--set", warm[0], "--set", warm[1]];
    let table = done(&folder, &identify(&more));
    assert!(table.contains("  bias/temperature y "), "{table}");
    let scene = read(folder.join("imu_sensor.toml"));
    assert!(scene.contains("temperature_c = 20\ntemperature_change_c_h = 250\n"), "{scene}");
    let change = values(&scene, "gyro", "bias_temperature_deg_h_per_k");
    assert!((change[1] - 12.0).abs() < 2.0, "{change:?}");
    let reference = scene.lines().find_map(|line| line.strip_prefix("reference_temperature_c = ")).unwrap();
    assert!((reference.parse::<f64>().unwrap() - 30.0).abs() < 0.2, "{reference}");
    done(&folder, &["fly", "imu_sensor.toml", "--quiet", "--set", "flight.hours=0.02", "-o", "again"]);
    let json = done(&folder, &identify(&[&more[..], &["--json", "-o", "b.toml"]].concat()));
    assert!(json.contains("\"bias/temperature y\": {\"value\": 0.00005"), "{json}");

    // A log that has the temperature: the scene does not have it too.
    let records = read(folder.join("aerobatics.csv"));
    let mut lines = records.lines().map(|line| line.split(',').take(10).collect::<Vec<_>>().join(","));
    let names = lines.next().unwrap().replace("truth_", "");
    let rows = lines.map(|line| {
        let time_s: f64 = line.split(',').next().unwrap().parse().unwrap();
        format!("{line},{}\n", 20.0 + time_s * 250.0 / 3600.0)
    });
    let log = format!("{names},temperature_c\n{}", rows.collect::<String>());
    std::fs::write(folder.join("warm.csv"), log).unwrap();
    done(&folder, &["identify", "warm.csv", "--imu", "imu.csv", "--also", "temperature", "-o", "c.toml"]);
    let scene = read(folder.join("c.toml"));
    assert!(scene.contains("file = \"warm.csv\"") && !scene.contains("\ntemperature_c"), "{scene}");
    done(&folder, &["fly", "c.toml", "--quiet", "-o", "again"]);
}

const TRUTH: [&str; 5] = ["aerobatics", "--set", "flight.hours=0.08", "--set", "flight.rate_hz=50"];

fn identify<'a>(more: &[&'a str]) -> Vec<&'a str> {
    ["identify"].into_iter().chain(TRUTH).chain(["--imu", "imu.csv"]).chain(more.iter().copied()).collect()
}

#[test]
fn a_record_becomes_a_scene_that_flies() {
    let folder = folder("identified");
    record(&folder, "aerobatics", &[]);
    let table = done(&folder, &identify(&["--prior", "tactical"]));
    assert!(table.contains("axes: those of the path") && table.contains("95 % intervals"), "{table}");
    let scene = read(folder.join("imu_sensor.toml"));
    for (section, key, truth) in [
        ("gyro", "bias_deg_h", [20.0, -30.0, 40.0]),
        ("gyro", "scale_factor_ppm", [400.0, -300.0, 200.0]),
        ("accelerometer", "bias_micro_g", [1500.0, -1000.0, 500.0]),
    ] {
        let (found, sigma) = (values(&scene, section, key), {
            let unit = ["_deg_h", "_ppm", "_micro_g"].into_iter().find(|unit| key.ends_with(unit)).unwrap();
            values(&scene, section, &format!("{}_sigma{unit}", key.strip_suffix(unit).unwrap()))
        });
        for axis in 0..3 {
            let off = (found[axis] - truth[axis]).abs();
            assert!(off < 4.0 * sigma[axis], "{section} {key} {axis}: {found:?} {sigma:?}");
        }
    }
    let walk = values(&scene, "gyro", "random_walk_deg_sqrt_h");
    assert!(walk.iter().all(|walk| (walk / 0.1 - 1.0).abs() < 0.2), "{walk:?}");
    done(&folder, &["fly", "imu_sensor.toml", "--quiet", "--set", "flight.hours=0.02", "-o", "again"]);

    // The same as JSON, and as a table with tabs and other names.
    let json = done(&folder, &identify(&["--prior", "tactical", "--json", "-o", "b.toml"]));
    assert!(json.contains("\"bias x\": {\"value\": ") && json.trim_end().ends_with('}'), "{json}");
    assert_eq!(json.matches('{').count(), json.matches('}').count());
    let rows = read(folder.join("imu.csv"));
    let tabs: String = rows.lines().filter(|line| !line.starts_with("time_s")).fold(
        "#timestamp [ms]\ta\tb\tc\tdelta x [rad]\tdelta y [rad]\tdelta z [rad]\tdelta vx [m/s]\tdelta vy [m/s]\tdelta vz [m/s]\n".to_owned(),
        |text, line| {
            let (time, rest) = line.split_once(',').unwrap();
            let time_ms = time.parse::<f64>().unwrap() * 1e3;
            text + &format!("{time_ms}\t{}\n", rest.replace(',', "\t"))
        },
    );
    std::fs::write(folder.join("tabs.csv"), tabs).unwrap();
    let arguments = identify(&["--prior", "tactical", "-o", "tabs.toml"]);
    let arguments: Vec<&str> =
        arguments.iter().map(|word| if *word == "imu.csv" { "tabs.csv" } else { word }).collect();
    done(&folder, &arguments);
    let of_tabs = read(folder.join("tabs.toml"));
    let biases = |scene: &str| values(scene, "gyro", "bias_deg_h");
    for (one, other) in biases(&of_tabs).iter().zip(biases(&scene)) {
        assert!((one - other).abs() < 1e-3, "{one} {other}");
    }
}

/// Axes exchanged and turned, and a clock that is behind: the scene has the attitude of the block.
#[test]
fn axes_and_clock_are_said_in_words() {
    let folder = folder("turned");
    record(&folder, "aerobatics", &["mounting.boresight_deg=[180, 0, 90.5]"]);
    let shifted: String = read(folder.join("imu.csv"))
        .lines()
        .map(|line| {
            match line.split_once(',').and_then(|(time, rest)| Some((time.parse::<f64>().ok()?, rest))) {
                Some((time, rest)) => format!("{},{rest}\n", time - 0.0331),
                None => format!("{line}\n"),
            }
        })
        .collect();
    std::fs::write(folder.join("imu.csv"), shifted).unwrap();
    let table = done(&folder, &identify(&["--prior", "tactical"]));
    assert!(table.contains("z of the record is z of the path, reversed"), "{table}");
    assert!(table.contains("clock: 33.1"), "{table}");
    let scene = read(folder.join("imu_sensor.toml"));
    let angles = values(&scene, "mounting", "boresight_deg");
    let off = |found: f64, truth: f64| ((found - truth + 540.0) % 360.0 - 180.0).abs();
    assert!(
        off(angles[0], 180.0) < 0.02 && angles[1].abs() < 0.02 && off(angles[2], 90.5) < 0.02,
        "{angles:?}"
    );
}

/// What makes a record unfit is named with its remedy, and nothing is written.
#[test]
fn unfit_records_are_named() {
    let folder = folder("unfit");
    record(&folder, "aerobatics", &[]);
    let rows = read(folder.join("imu.csv"));
    let in_degrees = rows.replace("_rad", "_rad_").replace("angle_increment_x_rad_", "angle_increment_x_rad");
    assert_ne!(in_degrees, rows);
    std::fs::write(folder.join("bad.csv"), in_degrees).unwrap();
    let refused = |file: &str, more: &[&str], words: &str| {
        let arguments = identify(more);
        let arguments: Vec<&str> =
            arguments.iter().map(|word| if *word == "imu.csv" { file } else { word }).collect();
        let (code, _, errors) = run(&folder, &arguments);
        assert!(code == 2 && errors.contains(words), "{code} {errors}");
    };
    refused("bad.csv", &[], "expected three columns of gyros and three of accelerometers, found 1 and 3");
    let scaled = |factor: f64| -> String {
        rows.lines()
            .map(|line| {
                let fields: Vec<String> = line
                    .split(',')
                    .enumerate()
                    .map(|(place, field)| match field.parse::<f64>() {
                        Ok(value) if (4..7).contains(&place) => (value * factor).to_string(),
                        _ => field.to_owned(),
                    })
                    .collect();
                fields.join(",") + "\n"
            })
            .collect()
    };
    std::fs::write(folder.join("degrees.csv"), scaled(180.0 / std::f64::consts::PI)).unwrap();
    refused("degrees.csv", &[], "are the rates in deg/s, read as rad/s?");
    std::fs::write(folder.join("mdps.csv"), scaled(1e3 * 180.0 / std::f64::consts::PI)).unwrap();
    refused("mdps.csv", &[], "are the rates in mdps, read as rad/s?");
    std::fs::write(folder.join("rates.csv"), scaled(0.02)).unwrap();
    refused("rates.csv", &[], "are these increments, read as rates?");
    std::fs::write(folder.join("mirrored.csv"), scaled(-1.0)).unwrap();
    refused("mirrored.csv", &[], "left-handed axes");
    // A clock that is set, with its line; a wild row, with its time; a record of the wrong rate, with that as which it is read.
    let changed = |lines: std::ops::Range<usize>, change: &dyn Fn(&mut Vec<String>)| -> String {
        let rows = rows.lines().zip(1..).map(|(text, line)| {
            let mut fields: Vec<String> = text.split(',').map(str::to_owned).collect();
            if lines.contains(&line) {
                change(&mut fields);
            }
            fields.join(",") + "\n"
        });
        rows.collect()
    };
    let time = |of: fn(f64) -> f64| {
        move |fields: &mut Vec<String>| fields[0] = of(fields[0].parse().unwrap()).to_string()
    };
    std::fs::write(folder.join("set.csv"), changed(200..usize::MAX, &time(|time| time + 1.7e9))).unwrap();
    refused("set.csv", &[], "set.csv:200: column time_s: a stamp of 1700000");
    std::fs::write(folder.join("wild.csv"), changed(500..501, &|fields| fields[4] = "3e6".into())).unwrap();
    refused("wild.csv", &[], "record.angle.x at 9.98 s = 150000000: must be from -1000000 to 1000000");
    std::fs::write(folder.join("fast.csv"), changed(2..usize::MAX, &time(|time| time * 1e-3))).unwrap();
    refused("fast.csv", &[], "at least 50; it is read as 0.3 s of rows at 50000 Hz");
    refused(
        "imu.csv",
        &["--imu-columns", "time_s=s,time_s=s"],
        "--imu-columns: \"time_s\" stands there twice",
    );
    record(&folder, "commuter", &[]);
    refused("imu.csv", &[], "is it of the same flight?");
    refused("imu.csv", &["--prior", "best"], "--prior best: expected");
    refused("none.csv", &[], "none.csv");
    assert!(!folder.join("imu_sensor.toml").exists() && !folder.join("degrees_sensor.toml").exists());
}

/// A scene names the log of the path only if it reads the log as the path was read.
/// Columns in the order y, z, x, rows of zeros where the record dropped out, and two units in one table.
#[test]
fn tables_of_other_orders_with_zeros_and_of_two_units_are_read_right() {
    let folder = folder("identify_tables");
    record(&folder, "aerobatics", &[]);
    let table = read(folder.join("imu.csv"));
    let mut rows = table.lines().filter(|line| !line.starts_with('#')).map(|line| line.split(',').collect());
    let names: Vec<&str> = rows.next().unwrap();
    let rows: Vec<Vec<&str>> = rows.collect();
    let first = names.iter().position(|name| name.starts_with("angle_increment_x")).unwrap();
    let order = [1, 2, 0, 4, 5, 3].map(|place| first + place);
    let of = |row: &[&str]| order.map(|place| row[place]).join(",");
    let found = |name: &str, text: String, more: &[&str]| {
        std::fs::write(folder.join(name), text).unwrap();
        let arguments = identify(&[&["--prior", "tactical", "-o", "s.toml"], more].concat());
        let arguments: Vec<&str> =
            arguments.iter().map(|word| if *word == "imu.csv" { name } else { word }).collect();
        let (code, said, errors) = run(&folder, &arguments);
        (code, said + &errors)
    };
    let near = |scene: &str| {
        let biases = values(scene, "gyro", "bias_deg_h");
        assert!(
            biases.iter().zip([20.0, -30.0, 40.0]).all(|(found, bias)| (found - bias).abs() < 5.0),
            "{biases:?}"
        );
    };
    let zeros = [4000..4100, 9000..9001];
    let cells =
        rows.iter().enumerate().map(|(at, row)| match zeros.iter().any(|zeros| zeros.contains(&at)) {
            true => format!("{},0,0,0,0,0,0\n", row[0]),
            false => format!("{},{}\n", row[0], of(row)),
        });
    let text = format!("time_s,{}\n", of(&names)) + &cells.collect::<String>();
    let (code, said) = found("zeros.csv", text, &["--force"]);
    assert!(
        code == 0 && said.contains("101 of 14400 rows, in which all sensors are 0, are left out"),
        "{said}"
    );
    near(&read(folder.join("s.toml")));

    let two = rows.iter().map(|row| {
        let one = of(row);
        format!("{},0,{one}\n{}1,1,{}\n", row[0], row[0], one.replace(',', "9,"))
    });
    let text = format!("time_s,I,{}\n", of(&names)) + &two.collect::<String>();
    let (code, said) = found("two.csv", text, &["--force"]);
    assert!(code == 2 && said.contains("only_column = \"I\" and only = \"0\""), "{said}");
    let written = read(folder.join("s.toml"));
    let map = format!("[imu]{}", written.split("\n[imu]").nth(1).unwrap());
    std::fs::write(folder.join("map.toml"), format!("{map}only_column = \"I\"\nonly = \"0\"\n")).unwrap();
    let (code, said) = found("two.csv", read(folder.join("two.csv")), &["--force", "--imu-map", "map.toml"]);
    assert_eq!(code, 0, "{said}");
    let again = read(folder.join("s.toml"));
    near(&again);
    assert!(again.contains("only_column = \"I\"") && again.contains("only = \"0\""), "{again}");
}

#[test]
fn a_log_that_needs_a_mapping_is_not_flown_without_it() {
    let folder = folder("mapped");
    let log = concat!(env!("CARGO_MANIFEST_DIR"), "/../../c_examples/flights/fighter_aerobatics.csv");
    std::fs::copy(log, folder.join("log.csv")).unwrap();
    let fly = [
        "fly",
        "log.csv",
        "--preset",
        "tactical",
        "--quiet",
        "--imu",
        "imu.csv",
        "-o",
        "out",
        "--set",
        "options.subsamples=1",
    ];
    done(&folder, &fly);
    let said = done(&folder, &["identify", "log.csv", "--imu", "out/imu.csv", "-o", "a.toml"]);
    assert!(said.contains("drifts on this path"), "{said}");
    assert!(read(folder.join("a.toml")).contains("[flight]\nfile = \"log.csv\"\n"));
    let foreign = read(folder.join("log.csv")).replacen("time_s", "t", 1);
    std::fs::write(folder.join("foreign.csv"), foreign).unwrap();
    let mapped = ["identify", "foreign.csv", "--imu", "out/imu.csv", "-o", "b.toml", "--set", "log.time=t"];
    let said = done(&folder, &mapped);
    assert!(said.contains("flies these sensors on another path"), "{said}");
    let scene = read(folder.join("b.toml"));
    assert!(scene.contains("needs the [log]") && !scene.contains("file ="), "{scene}");
    done(&folder, &["fly", "b.toml", "--quiet", "--set", "flight.hours=0.01", "-o", "b"]);
}

/// Consumer sensors are 100 km off after minutes: a record as it is diverges there, which is a result.
#[test]
fn flights_that_diverge_are_a_result_of_the_check() {
    let folder = folder("diverged");
    let path = ["racetrack", "--set", "flight.hours=0.8", "--set", "flight.rate_hz=5"];
    done(&folder, &[&["fly"], &path[..], &["--preset", "consumer", "--imu", "imu.csv"]].concat());
    let check = ["--imu", "sins_out/imu.csv", "--prior", "consumer", "--check", "--twins", "40"];
    let table = done(&folder, &[&["identify"], &path[..], &check[..]].concat());
    let last = table.lines().find(|line| line.starts_with("  10 min ")).unwrap();
    assert!(last.contains(" diverged ") && last.ends_with("agrees"), "{table}");
    assert!(table.contains("\nthe prediction agrees with the record\n"), "{table}");
    let json = done(&folder, &[&["identify"], &path[..], &check[..], &["--json", "--force"]].concat());
    assert!(json.contains("\"free_m\": null") && !json.contains("inf"), "{json}");
}

/// The first half of a record predicts how far the sensors drift in the other half; a row without a value is left out.
#[test]
fn the_rest_of_a_record_is_checked() {
    let folder = folder("checked");
    record(&folder, "aerobatics", &["flight.hours=0.11", "flight.rate_hz=25"]);
    let truth = ["identify", "aerobatics", "--set", "flight.hours=0.11", "--set", "flight.rate_hz=25"];
    let of = |file: &'static str, more: &[&'static str]| -> Vec<&str> {
        truth
            .into_iter()
            .chain(["--prior", "tactical", "--imu", file, "--force"])
            .chain(more.iter().copied())
            .collect()
    };
    let check = ["--check", "--twins", "40"];
    let table = done(&folder, &of("imu.csv", &check));
    assert!(
        table.contains("check: the figures above are those of the first half of the rows that the path has"),
        "{table}"
    );
    assert!(
        table.contains("\n  10 s ") && table.contains("the prediction agrees with the record"),
        "{table}"
    );
    assert!(
        read(folder.join("imu_sensor.toml"))
            .contains("found in the first half of the common rows of imu.csv")
    );

    // The same as a page: its sentence and its tables have the figures of the table for the terminal.
    let said = done(
        &folder,
        &of("imu.csv", &["--check", "--twins", "40", "--page", "page.html", "--picture", "drift.svg"]),
    );
    let picture = read(folder.join("drift.svg"));
    assert!(picture.starts_with("<svg xmlns=") && picture.contains("95 % of the twins"), "{picture}");
    assert!(
        said.ends_with("next: open page.html in a browser\n") && said.contains("\n  page.html "),
        "{said}"
    );
    let page = read(folder.join("page.html"));
    let verdict = "the prediction agrees with the record.";
    assert!(page.contains("<h1>Sensors of imu.csv</h1>") && page.contains(verdict), "{page}");
    let last = table.lines().rfind(|line| line.ends_with("agrees")).unwrap();
    let fields: Vec<&str> = last.split("  ").map(str::trim).filter(|field| !field.is_empty()).collect();
    let [real, predicted] = [fields[3], fields[4]].map(|field| field.split(' ').next().unwrap());
    let sentence = format!(
        "After {} half of the flights on this record are within {real} m, where {predicted} m were predicted: {verdict}",
        fields[0]
    );
    assert!(page.contains(&sentence), "{sentence}");
    for line in table.lines().filter(|line| line.contains('±') && line.starts_with("  ")) {
        let (name, value) = (line[2..19].trim(), line[19..].trim());
        let row = format!("<th scope=\"row\">{name}</th><td>{value}</td>");
        assert!(page.contains(&row), "{row}");
    }
    // Drifts, two of priors, two of residuals, six Allan deviations.
    assert_eq!(page.matches("<figure>").count(), 11);
    done(&folder, &of("imu.csv", &["--page", "plain.html"]));
    let page = read(folder.join("plain.html"));
    assert!(page.contains(" of the 24 errors of these sensors.") && page.matches("<figure>").count() == 10);
    let json = done(&folder, &of("imu.csv", &["--check", "--twins", "40", "--json"]));
    assert!(
        json.contains("\"check\": {\"length_s\": 197") && json.contains("\"verdict\": \"agrees\""),
        "{json}"
    );
    assert_eq!(json.matches('{').count(), json.matches('}').count());
    assert!(!done(&folder, &of("imu.csv", &[])).contains("check:"));

    let rows = read(folder.join("imu.csv"));
    let header = rows.lines().find(|line| line.starts_with("time_s")).unwrap();
    let hole = format!("{header}\n0.001{}\n", ",".repeat(header.matches(',').count()));
    std::fs::write(folder.join("hole.csv"), rows.replacen(&format!("{header}\n"), &hole, 1)).unwrap();
    let table = done(&folder, &of("hole.csv", &[]));
    assert!(table.contains("1 row without a value is left out, the first in line"), "{table}");

    for (more, words) in [
        (&["--check", "--truth-sigma", "speed=1"][..], "--truth-sigma speed=1: expected NAME=NUMBER"),
        (&["--truth-sigma", "velocity_m_s=1"], "--check"),
        (&["--check", "--twins", "3"], "40"),
        (&["--page", "page.svg"], "--page page.svg: expected a name that ends in .html"),
        (&["--page", "imu.csv"], "--page imu.csv: expected a name that ends in .html"),
        (
            &["--check", "--truth-sigma", "tilt_arcmin=1e9"],
            "--truth-sigma tilt_arcmin=1e9: must be at most 1031",
        ),
    ] {
        let (code, _, errors) = run(&folder, &of("imu.csv", more));
        assert!(code == 2 && errors.contains(words), "{more:?}: {code} {errors}");
    }
}
