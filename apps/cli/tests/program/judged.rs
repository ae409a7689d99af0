//! Logs with faults: refused or warned of through every door, with the reason.

use std::fmt::Write;
use std::path::Path;

use crate::support::{done, folder, read, rejected, run};

const COLUMNS: &str = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg";

/// A row of a level circle of 80 m/s, 3 °/s: time, latitude, longitude [deg], height, roll, pitch, heading [deg], velocity east, north.
pub type Row = [f64; 9];

/// The circle at a rate, over a time.
pub fn circle(rate_hz: u32, seconds: u32) -> Vec<Row> {
    let (speed, turn) = (80.0, 3_f64.to_radians());
    let row = |k: u32| {
        let t = f64::from(k) / f64::from(rate_hz);
        let (sine, cosine) = (turn * t).sin_cos();
        let (east, north) = (speed / turn * (1.0 - cosine), speed / turn * sine);
        let latitude = 47.0 + (north / 6_370_800.0).to_degrees();
        let longitude = 8.0 + (east / (6_390_000.0 * 47_f64.to_radians().cos())).to_degrees();
        [
            t,
            latitude,
            longitude,
            1500.0,
            23.1,
            2.0,
            (turn * t).to_degrees() % 360.0,
            speed * sine,
            speed * cosine,
        ]
    };
    (0..=rate_hz * seconds).map(row).collect()
}

pub fn write(path: &Path, rows: &[Row], has_velocity: bool) {
    let mut text = COLUMNS.to_owned();
    text += if has_velocity { ",velocity_east_m_s,velocity_north_m_s,velocity_up_m_s\n" } else { "\n" };
    for [t, latitude, longitude, height, roll, pitch, heading, east, north] in rows {
        write!(text, "{t},{latitude},{longitude},{height},{roll},{pitch},{heading}").unwrap();
        let velocity = if has_velocity { format!(",{east},{north},0\n") } else { "\n".to_owned() };
        text += &velocity;
    }
    std::fs::write(path, text).unwrap();
}

/// Each fault of a log, its words, and whether it is unusable.
pub fn faulty(folder: &Path) -> [(&'static str, &'static str, bool); 8] {
    let save = |name: &str, has_velocity: bool, rate_hz: u32, damage: &dyn Fn(usize, &mut Row)| {
        let mut rows = circle(rate_hz, 150);
        rows.iter_mut().enumerate().for_each(|(k, row)| damage(k, row));
        write(&folder.join(format!("{name}.csv")), &rows, has_velocity);
    };
    save("float32", false, 50, &|_, row| {
        row[1] = f64::from(row[1] as f32);
        row[2] = f64::from(row[2] as f32);
    });
    save("knots", true, 10, &|_, row| {
        row[7] /= 0.514_444;
        row[8] /= 0.514_444;
    });
    save("exchanged", true, 10, &|_, row| row.swap(7, 8));
    save("zeros", false, 1, &|k, row| row[3] = if k < 5 { 0.0 } else { row[3] });
    save("spike", false, 1, &|k, row| row[1] += if k == 30 { 800.0 / 111_200.0 } else { 0.0 });
    let fixes = circle(50, 150);
    save("held", false, 50, &|k, row| row[1..3].copy_from_slice(&fixes[k / 10 * 10][1..3]));
    save("reversed", true, 2, &|k, row| {
        if k == 40 || k == 80 {
            row[7] = -row[7];
            row[8] = -row[8];
        }
    });
    // From 357° to 3° by way of 180°, as a tool interpolates between rows of 1 Hz.
    save("wrapped", true, 10, &|k, row| {
        let (second, part) = (k / 10, (k % 10) as f64 / 10.0);
        let heading = |second: usize| (3 * second + 1) as f64 % 360.0;
        row[6] = heading(second) + part * (heading(second + 1) - heading(second));
    });
    [
        ("float32", "(32-bit floats?); this makes", true),
        ("knots", "1.94 times the displacement (knots?)", true),
        ("exchanged", "velocity east and north are exchanged", true),
        ("zeros", "the first 5 rows hold a value from before the first fix", true),
        ("spike", "beside the path of its neighbours at 30 s", true),
        ("held", "repeat the position of the row before", true),
        ("reversed", "velocity contradicts the positions by up to", false),
        ("wrapped", "interpolated through its wrap?", false),
    ]
}

#[test]
fn a_good_log_is_silent() {
    let folder = folder("good");
    write(&folder.join("with.csv"), &circle(10, 60), true);
    write(&folder.join("without.csv"), &circle(50, 60), false);
    for log in ["with.csv", "without.csv"] {
        done(&folder, &["scene", "check", log, "--strict"]);
        done(&folder, &["fly", log, "--strict", "-q"]);
    }
    assert!(!read(folder.join("sins_out/with_summary.csv")).contains("finding"));
}

/// A column that is not read is named by every door, and refused by none.
#[test]
fn every_door_names_a_column_that_looks_like_a_quantity() {
    let folder = folder("unread");
    write(&folder.join("good.csv"), &circle(10, 60), true);
    let text = read(folder.join("good.csv"))
        .replace("velocity_east_m_s,velocity_north_m_s,velocity_up_m_s", "ve,vn,vu");
    std::fs::write(folder.join("unread.csv"), text).unwrap();
    for door in [
        &["scene", "check"][..],
        &["fly", "-q"],
        &["ensemble", "-q", "--runs", "2"],
        &["recommend", "--position", "1000"],
        &["budget"],
        &["curve"],
    ] {
        let (code, _, errors) = run(&folder, &[door, &["--strict", "unread.csv"]].concat());
        assert_eq!(code, 0, "{door:?}: {errors}");
        assert!(
            errors.contains("unread.csv:1: note: ve is not read; is it velocity_east_m_s?\n"),
            "{door:?}: {errors}"
        );
    }
    let said = done(&folder, &["log", "unread.csv"]);
    let agreement = "not read, and in agreement with what flies: ve (east in m/s), vn (north in m/s)";
    for words in ["note: vu is not read; is it velocity_up_m_s?\n", agreement, "\nnothing is doubtful\n"] {
        assert!(said.contains(words), "{words}: {said}");
    }
}

#[test]
fn every_door_refuses_what_is_unusable_and_warns_of_what_is_doubtful() {
    let folder = folder("doors");
    let doors = [
        &["scene", "check"][..],
        &["fly", "-q"],
        &["ensemble", "-q", "--runs", "2"],
        &["recommend"],
        &["budget"],
        &["curve"],
    ];
    for (log, words, is_unusable) in faulty(&folder) {
        let file = format!("{log}.csv");
        // What no simulator takes is not flown by it.
        let believed = ["fly", "-q", "--believe", "-o", "believed", &file];
        let is_remedy = is_unusable && run(&folder, &believed).0 == 0;
        for door in doors {
            // Doubtful logs fly: the quick doors show it.
            let mut order = [door, &[file.as_str()]].concat();
            if !is_unusable {
                order.push("--strict");
            }
            let (code, said, errors) = run(&folder, &order);
            assert_eq!((code, said.as_str()), (1 + i32::from(is_unusable), ""), "{door:?} {log}: {errors}");
            let place = errors.lines().find(|line| line.contains(words));
            assert!(
                place.is_some_and(|line| line.starts_with(&file) && line.contains("Remedy: ")),
                "{door:?} {log}: {errors}"
            );
            assert_eq!(
                errors.lines().last().is_some_and(|line| line.contains("--believe")),
                is_remedy,
                "{errors}"
            );
        }
    }
    assert!(!folder.join("sins_out").exists(), "nothing is written");
}

/// A row 334 m off, whose velocities are right, so that the judge has a note of it: what a simulator refuses is unusable to `sins log` too.
#[test]
fn a_row_that_a_simulator_refuses_is_unusable() {
    let folder = folder("refused");
    let mut rows = circle(10, 60);
    rows[200][1] += 0.003;
    write(&folder.join("off.csv"), &rows, true);
    let words = "displacement that the velocity does not explain [m] = 33";
    for door in [&["scene", "check"][..], &["fly", "-q"]] {
        let errors = rejected(&folder, &[door, &["off.csv"]].concat());
        assert!(errors.contains("off.csv:202: ") && errors.contains(words), "{door:?}: {errors}");
    }
    let (code, said, errors) = run(&folder, &["log", "off.csv"]);
    assert_eq!((code, errors.as_str()), (2, "off.csv: a flight of this log is refused\n"));
    assert!(said.contains("off.csv:202: unusable: ") && said.contains(words), "{said}");
    assert!(!said.contains("nothing is doubtful"), "{said}");
    for door in [&["log"][..], &["scene", "check"], &["fly", "-q"]] {
        let (code, said, _) = run(&folder, &[door, &["--json", "off.csv"]].concat());
        assert!(code == 2 && said.contains(words), "{door:?}: {said}");
        assert!(said.starts_with("{\"file\":\"off.csv\",\"level\":\"unusable\","), "{door:?}: {said}");
    }
}

/// What is found in JSON: the same through every door, and no other text. The exit code follows the level.
#[test]
fn findings_are_printed_in_json() {
    let folder = folder("json");
    write(&folder.join("good.csv"), &circle(10, 60), true);
    assert_eq!(
        done(&folder, &["log", "good.csv", "--json"]),
        "{\"file\":\"good.csv\",\"level\":null,\"findings\":[]}\n"
    );
    let (code, said, errors) = run(&folder, &["log", "good.csv", "--map", "map.toml", "--json"]);
    assert_eq!((code, said.as_str()), (0, "{\"file\":\"good.csv\",\"level\":null,\"findings\":[]}\n"));
    assert!(errors.starts_with("map.toml: the columns are "), "{errors}");
    // Notes of the reader have no kind. A name in quotation marks.
    let file = if cfg!(windows) { "it's.csv" } else { "a \"b\".csv" };
    let named = read(folder.join("good.csv")).replace("velocity_up_m_s", "vu");
    std::fs::write(folder.join(file), named.replace("velocity_", "v_")).unwrap();
    let note = |column: &str, of: &str| {
        format!(
            "{{\"kind\":null,\"level\":\"note\",\"line\":1,\"sample\":null,\"time_s\":null,\"count\":null,\"figure\":null,\
             \"acceleration_m_s2\":null,\"ins_error_m\":null,\"sentence\":\"{column} is not read; is it {of}?\",\"remedy\":null}}"
        )
    };
    let said = done(&folder, &["fly", file, "--json"]);
    let start = format!("{{\"file\":\"{}\",\"level\":\"note\",\"findings\":[", file.replace('"', "\\\""));
    assert!(said.starts_with(&start) && said.ends_with("]}\n"), "{said}");
    assert!(said.contains(&note("vu", "velocity_up_m_s")), "{said}");
    let mut flown = 0;
    for (log, words, is_unusable) in faulty(&folder) {
        let file = format!("{log}.csv");
        let code = if is_unusable { 2 } else { 1 };
        let level = if is_unusable { "unusable" } else { "doubtful" };
        let doors = [&["log"][..], &["scene", "check"], &["fly"]];
        let [of_log, of_check, of_flight] = doors.map(|door| {
            let strict: &[&str] = if is_unusable { &[] } else { &["--strict"] };
            let (found, said, errors) = run(&folder, &[door, &[&file, "--json"], strict].concat());
            assert_eq!(found, code, "{door:?} {log}: {errors}");
            assert!(errors.lines().count() == 1 && errors.contains("refused"), "{door:?} {log}: {errors}");
            said
        });
        assert!(of_log == of_check && of_log == of_flight, "{of_log}{of_check}{of_flight}");
        let start = format!("{{\"file\":\"{file}\",\"level\":\"{level}\",\"findings\":[{{\"kind\":\"");
        assert!(of_log.starts_with(&start) && of_log.contains(words), "{of_log}");
        assert_eq!(of_log.lines().count(), 1, "{of_log}");
        // What is flown all the same has no other text.
        if run(&folder, &["fly", &file, "-q", "-o", "quiet", "--believe"]).0 != 0 {
            continue;
        }
        let believed: &[&str] = if is_unusable { &["--believe"] } else { &[] };
        let (found, said, errors) = run(&folder, &[&["fly", &file, "--json", "--force"], believed].concat());
        assert!(found == 0 && said == of_log && errors.is_empty(), "{log}: {said}{errors}");
        flown += 1;
    }
    assert!(flown > 4, "{flown}");
}

/// What flies all the same says so on standard error, in the summary, and in the pages above the curves.
#[test]
fn doubts_stand_in_summaries_and_pages() {
    let folder = folder("pages");
    for (log, words, is_unusable) in faulty(&folder) {
        if log == "spike" || log == "zeros" || log == "held" {
            continue;
        }
        let file = format!("{log}.csv");
        let mut order = vec!["fly", "-q", "--force", &file];
        if is_unusable {
            order.push("--believe");
        }
        let (code, _, errors) = run(&folder, &order);
        assert!(code == 0 && errors.contains(words), "{log}: {errors}");
        let summary = read(folder.join(format!("sins_out/{log}_summary.csv")));
        assert!(summary.contains("finding_1_text,") && summary.contains(words), "{log}: {summary}");
        done(&folder, &["report", &format!("sins_out/{log}.csv")]);
        let page = read(folder.join("sins_out/report.html"));
        let (above, _) = page.split_once("<figure>").unwrap();
        assert!(above.contains("<p class=\"remark\">Flight data: ") && above.contains(words), "{log}");
    }
    let (code, _, errors) = run(&folder, &["ensemble", "-q", "--runs", "2", "reversed.csv"]);
    assert!(code == 0 && errors.contains("velocity contradicts"), "{errors}");
    let page = read(folder.join("sins_out/reversed_ensemble.html"));
    assert!(page.contains("<p class=\"remark\">Flight data: "), "{page}");
    assert!(
        rejected(&folder, &["fly", "knots.csv", "--strict", "--believe"]).contains("cannot be used with")
    );
}

/// The largest acceleration of the options holds for velocities that are derived from positions too.
#[test]
fn the_limit_of_the_acceleration_is_that_of_what_is_flown() {
    let folder = folder("limit");
    write(&folder.join("circle.csv"), &circle(50, 20), false);
    done(&folder, &["fly", "-q", "circle.csv", "--set", "options.max_acceleration_m_s2=7"]);
    let errors = rejected(&folder, &["fly", "-q", "circle.csv", "--set", "options.max_acceleration_m_s2=4"]);
    assert!(errors.contains("the flight accelerates by 6.28 m/s2"), "{errors}");
    assert!(errors.contains("options.max_acceleration_m_s2 is 4"), "{errors}");
}
