//! Tables that are looked at, and read as the look says.

mod attitudes;
mod conventions;
mod heights;
mod letters;
mod nulls;
mod stamps;

use super::super::FlightLog;
use super::*;
use crate::scene::Scene;

/// Surveys a table, and reads it as the survey says.
pub fn read(table: &str) -> (Survey, FlightLog) {
    let survey = survey(table.as_bytes()).unwrap_or_else(|| panic!("{table}"));
    let text = format!("[flight]\nfile = \"a.csv\"\n[log]\n{}", survey.text);
    let scene = Scene::parse(text.as_bytes()).unwrap_or_else(|faults| panic!("{faults:?}\n{text}"));
    let log = FlightLog::parse_with(table.as_bytes(), &scene.log)
        .unwrap_or_else(|error| panic!("{error:?}\n{text}"));
    (survey, log)
}

fn doubts(found: &Survey, words: &str) -> bool {
    found.doubts.iter().any(|doubt| doubt.contains(words))
}

#[test]
fn separators_headers_and_lines_of_units_are_found() {
    let (found, log) = read(
        "my logger\ntime;lat;lon;alt;ve;vn;vd;roll;pitch;yaw\nms;deg;deg;ft;kt;kt;kt;deg;deg;deg\n\
         0;48.0;11.0;984.252;0;97.192;-2;5;2;10\n100;48.000045;11.0;984.6;0;97.192;-2;5;2;10\n",
    );
    assert_eq!(found.format, None);
    let begin = "separator = \"semicolon\"\nheader = 2\nskip = 1\ntime = { col = \"time\", unit = \"ms\" }\nlatitude = \"lat\"\n";
    assert!(found.text.starts_with(begin), "{found:?}");
    let sample = log.samples()[1];
    assert!((sample.time_s - 0.1).abs() < 1e-12 && (sample.place.height_m - 300.1).abs() < 0.01);
    assert!((sample.v_n.unwrap().y - 50.0).abs() < 0.01 && sample.v_n.unwrap().z > 0.0);
    for (table, words) in [
        ("# t,lat,lon,alt\n0,48,11,300\n1,48.0005,11,300\n", "comment = \"!\"\n"),
        (
            "t,lat,lon,alt\n# s,deg,deg,ft\n0,48,11,300\n1,48.0005,11,300\n",
            "height = { col = \"alt\", unit = \"ft\" }",
        ),
    ] {
        let (found, log) = read(table);
        assert!(found.text.contains(words) && log.samples().len() == 2, "{words}: {found:?}");
    }
    // Comments behind the names and between the rows.
    for unit in ["", "# made up, by hand\n"] {
        let table =
            format!("t,lat,lon,alt\n{unit}# s,deg,deg,ft\n# note\n0,48,11,300\n# 2,3\n0.5,48.0005,11,300\n");
        let (found, log) = read(&table);
        assert!(found.text.contains("time = \"t\"\n") && found.text.contains("unit = \"ft\""), "{found:?}");
        assert_eq!(log.samples().len(), 2);
    }
    // Of two columns with one name the first, by its number.
    let (found, log) = read("t,lat,lat,lon,alt\n0,48,1,11,300\n1,48.0005,1,11,300\n");
    assert!(found.text.contains("latitude = { col = 2 }\n") && doubts(&found, "column 3"), "{found:?}");
    assert!((log.samples()[0].place.latitude_rad.to_degrees() - 48.0).abs() < 1e-9);
    assert_eq!(survey(b"1,2,3\n4,5,6\n"), None);
    assert_eq!(survey(b""), None);
}

/// What no log has is not looked at: lines and columns beyond the limits of the reader.
#[test]
fn lines_and_columns_beyond_the_limits_are_not_looked_at() {
    let names = "t,lat,lon,alt";
    let rows = "0,48,11,300\n1,48.0005,11,300\n";
    let table = |more: usize| format!("{names}{}\n{rows}", ",x".repeat(more));
    assert!(survey(table(996).as_bytes()).is_some());
    for more in [997, 30_000, 1_000_000] {
        assert_eq!(survey(table(more).as_bytes()), None, "{more}");
    }
    let long = "1".repeat(70_000);
    let grid = Grid::of(&format!("{names}\n{rows}2,48.001,11,{long}\n{rows}")).map(|grid| grid.rows.len());
    assert_eq!(grid, Some(2));
    assert_eq!(survey(format!("{long}\n{names}\n{rows}").as_bytes()), None);
}

#[test]
fn fields_between_blanks_are_found() {
    for table in [
        "t lat lon alt\n0 48 11 300\n1 48.0005 11 300\n",
        "   t \t lat lon  alt  \n  0  48 11\t300 \n\n 1 48.0005  11 300",
        "% t  lat  lon  alt\n  0 48 11 300\n  1 48.0005 11 300\n",
        "%t lat lon alt\n0,0 48,0 11 300\n1,0 48,0005 11 300\n",
        "Time [s] lat [deg]  lon [deg] alt [m]\n0 48 11 300\nTime [s] lat [deg]  lon [deg] alt [m]\n1 48.0005 11 300\n",
        "# t lat lon alt\n# [s] [deg] [deg] [m]\n0 48 11 300\n1 48.0005 11 300\n",
        "# made up\n# t lat lon alt\n# s deg deg m\n0 48 11 300\n1 48.0005 11 300\n",
    ] {
        let (found, log) = read(table);
        assert!(found.text.starts_with("separator = \"blanks\"\n"), "{found:?}");
        let sample = log.samples()[1];
        let degrees = sample.place.latitude_rad.to_degrees();
        assert!((sample.time_s, log.samples().len()) == (1.0, 2), "{table}");
        assert!((degrees - 48.0005).abs() < 1e-9 && sample.place.height_m == 300.0, "{table}: {sample:?}");
    }
    // A lone mark between commas is the name of a column.
    let (found, _) = read("%,t,lat,lon,alt\n7,0,48,11,300\n8,1,48.0005,11,300\n");
    assert!(found.text.starts_with("time = \"t\"\n"), "{found:?}");
}

#[test]
fn day_and_month_are_told_apart_by_values_above_12() {
    for (days, words, is_assumed) in [
        (["28.11.2026 13:05:09.20", "28.11.2026 13:05:10.20"], "time_format = \"dmy\"\n", false),
        (["12/11/2026 23:59:59.5", "13/11/2026 00:00:00.5"], "time_format = \"dmy\"\n", false),
        (["11/12/2026 11:59:59.5 PM", "11/13/2026 12:00:00.5 AM"], "time_format = \"mdy\"\n", false),
        (["05/06/2026 13:05:09", "05/06/2026 13:05:10"], "time_format = \"dmy\"\n", true),
        (["2026/11/28 13:05:09", "2026/11/28 13:05:10"], "time_format = \"iso\"\n", false),
    ] {
        let [first, second] = days;
        let (found, log) =
            read(&format!("Date,lat,lon,alt\n,48,11,300\n{first},48,11,300\n{second},48.0005,11,300\n"));
        assert!(found.text.contains(words), "{found:?}");
        assert_eq!((doubts(&found, "no day is above 12"), log.duration_s()), (is_assumed, 1.0), "{first}");
    }
    // A date beside a time of day is not needed.
    let (found, log) =
        read("Date;Time;lat;lon;alt\n28.11.2026;23:59:59;48;11;300\n29.11.2026;00:00:00;48,0005;11;300\n");
    assert!(
        found.text.contains("time = \"Time\"\ntime_format = \"hms\"\n") && log.duration_s() == 1.0,
        "{found:?}"
    );
}

#[test]
fn names_in_quotes_are_found_again() {
    for (names, height) in [
        (
            "t,lat,lon,\"Altitude \"\"MSL\"\", ft\"",
            r#"height = { col = "Altitude \"MSL\", ft", unit = "ft" }"#,
        ),
        (r"t,lat,lon,alt\ft", r#"height = { col = "alt\\ft", unit = "ft" }"#),
        ("t,lat,lon,\"alt\tft\"", "height = { col = 4, unit = \"ft\" }"),
        ("\"t\", \"lat\", \"lon\", \"alt_ft\"", r#"height = { col = "alt_ft", unit = "ft" }"#),
    ] {
        let (found, log) = read(&format!("{names}\n0, \"48\",11,1000\n1,48.0005,11,1000\n"));
        assert!(found.text.contains(height), "{found:?}");
        assert!((log.samples()[0].place.height_m - 304.8).abs() < 1e-9, "{names}");
    }
}

#[test]
fn cells_without_a_value_and_repeated_names_are_passed_over() {
    let names = "t,lat,lon,alt";
    for nothing in ["", "NaN", "-nan", "N/A", "NA", "null", "None", "-", "--"] {
        let (_, log) = read(&format!(
            "{names}\n{nothing},48,11,300\n0,48,11,300\n{names}\n1,48.0005,{nothing},300\n1,48.0005,11,300\n"
        ));
        assert_eq!((log.samples().len(), log.duration_s()), (2, 1.0), "{nothing}");
    }
}

/// A column of a name that another has too is read by its number, and a time of day not as a constant.
#[test]
fn of_two_columns_of_one_name_the_first_is_read() {
    for times in [["12:00:00", "12:00:01"], ["10", "11"]] {
        let [first, second] = times;
        let (found, log) =
            read(&format!("time,lat,lon,alt,time\n{first},48,11,300,7\n{second},48.0005,11,300,7\n"));
        assert_eq!((log.samples().len(), log.duration_s()), (2, 1.0), "{found:?}");
    }
}

#[test]
fn times_are_of_the_unit_that_gives_a_vehicle() {
    for (times, words) in [
        (["1700000000", "1700000005"], "time = \"t\"\n"),
        (["1714564800000", "1714564801000"], "unit = \"ms\""),
        (["0", "2500000"], "unit = \"us\""),
        (["1714564800000000000", "1714564802000000000"], "unit = \"ns\""),
        (["2024-05-01T12:00:00Z", "2024-05-01T12:00:01Z"], "time_format = \"iso\""),
        (["12:00:00", "12:00:01"], "time_format = \"hms\""),
    ] {
        let [first, second] = times;
        let (found, log) = read(&format!("t,lat,lon,alt\n{first},48,11,300\n{second},48.0005,11,300\n"));
        assert!(found.text.contains(words) && log.duration_s() >= 1.0 && log.duration_s() < 6.0, "{found:?}");
        assert!(
            found.text.contains("smooth = \"auto\"\n") && found.text.contains("attitude = \"coordinated\"\n")
        );
    }
    // At rest the steps tell.
    assert!(survey(b"t,lat,lon,alt\n0,48,11,300\n10,48,11,300\n").unwrap().text.contains("unit = \"ms\""));
    let (found, log) = read("Zeit;Breite;Länge;Höhe;Rollwinkel\n0;48,5;11;300;1\n1;48,5005;11;300;1\n");
    assert!(doubts(&found, "left out: roll") && log.samples()[1].time_s == 1.0, "{found:?}");
    let decimal_commas = "t;lat;lon;alt\n12:00:00,0;48;11;300\n12:00:00,1;48,00005;11;300\n";
    assert!((read(decimal_commas).1.duration_s() - 0.1).abs() < 1e-9);
}

#[test]
fn angles_are_radians_where_degrees_are_impossible() {
    let radians = "latitude = { col = \"lat\", unit = \"rad\" }";
    for (table, words, latitude) in [
        ("t (s),lat,lon,alt\n0,0.8377,0.19,300\n10,0.83771,0.19,300\n", radians, 47.9966),
        ("t (s);lat;lon;alt\n0;0,8377;0,19;300\n10;0,83771;0,19;300\n", radians, 47.9966),
        ("t,lat,lon,alt\n0,0.5,1,300\n1,0.50045,1,300\n", "latitude = \"lat\"", 0.5),
    ] {
        let (found, log) = read(table);
        assert!(found.text.contains(words) && doubts(&found, "radians") == (words == radians), "{found:?}");
        assert!((log.samples()[0].place.latitude_rad.to_degrees() - latitude).abs() < 1e-3, "{found:?}");
    }
    let (found, log) =
        read("t,lat,lon,alt,roll,pitch,yaw\n0,48,11,300,0.3,0.02,3.1\n1,47.9995,11,300,0.3,0.02,3.1\n");
    assert!(
        (log.samples()[0].euler.roll - 0.3).abs() < 1e-12 && doubts(&found, "taken as radians"),
        "{found:?}"
    );
}

#[test]
fn whole_numbers_of_a_position_are_scaled() {
    let (found, log) = read(
        "timestamp,lat,lon,alt,eph,epv\n0,-335000000,705000000,300,1,1\n1000000,-335000900,705000000,300,1,1\n",
    );
    assert!(doubts(&found, "lat is taken as latitude in 1e-7 deg"), "{found:?}");
    let place = log.samples()[0].place;
    assert!((place.latitude_rad.to_degrees() + 33.5).abs() < 1e-12, "{place:?}");
    assert!((place.longitude_rad.to_degrees() - 70.5).abs() < 1e-12, "{place:?}");
}

#[test]
fn letters_of_hemispheres_are_found() {
    for (names, letters) in [
        ("t,lat,N/S,lon,E/W,alt", ["N/S", "E/W"]),
        ("t,lat,dir 1,lon,dir 2,alt", ["dir 1", "dir 2"]),
        ("t,lat,NS Indicator,lon,Longitude E/W,alt", ["NS Indicator", "Longitude E/W"]),
    ] {
        let (found, log) = read(&format!("{names}\n0,33.5,S,70.5,W,300\n1,33.5,S,70.5001,W,300\n"));
        let [ns, ew] = letters;
        let keys = format!(
            "latitude = {{ col = \"lat\", hemisphere = \"{ns}\" }}\nlongitude = {{ col = \"lon\", hemisphere = \"{ew}\" }}\n"
        );
        assert!(found.text.contains(&keys), "{found:?}");
        let place = log.samples()[0].place;
        assert!((place.latitude_rad.to_degrees() + 33.5).abs() < 1e-12, "{place:?}");
        assert!((place.longitude_rad.to_degrees() + 70.5).abs() < 1e-12, "{place:?}");
        assert!(log.notes().is_empty(), "{:?}", log.notes());
    }
    // Letters of the wind are none of the position, wherever they stand.
    let (found, _) = read("t,wind,lat,lon,alt\n0,W,33.5,70.5,300\n1,S,33.5,70.5001,300\n");
    assert!(!found.text.contains("hemisphere"), "{found:?}");
    let (_, log) = read("t,lat,lon,alt\n0,33.5S,W70.5,300\n1,33.5S,W70.5001,300\n");
    assert!(log.samples()[0].place.latitude_rad < 0.0 && log.samples()[0].place.longitude_rad < 0.0);
}

#[test]
fn what_is_not_whole_is_left_out() {
    let (found, log) =
        read("Zeit;lat;lon;alt;speed;yaw\n0;48,5;11,25;300,5;50;90\n1;48,5;11,2503;300,5;50;90\n");
    assert!(
        (log.samples()[0].place.latitude_rad.to_degrees() - 48.5).abs() < 1e-9
            && (log.duration_s() - 1.0).abs() < 1e-9
    );
    assert!(!doubts(&found, "speed is taken as") && doubts(&found, "alt is taken as m"), "{found:?}");
    for words in ["left out: speed; there is no track, climb", "left out: heading; there is no roll, pitch"] {
        assert!(doubts(&found, words), "{words}: {found:?}");
    }
    let (found, log) = read(
        "t,lat,lon,alt,gs,track,climb,ve,vn,vu,roll,pitch,yaw\n0,48,11,0,50,0,1,0,50,1,0,0,0\n0.1,48.00005,11,0,50,0,1,0,50,1,0,0,0\n",
    );
    assert!(!found.text.contains("speed") && log.samples()[0].v_n.is_some(), "{found:?}");
}

/// R names the rows in a column without a name.
#[test]
fn tables_of_r_have_names_of_rows() {
    for separator in [",", " ", "\t"] {
        let names = ["time", "lat", "lon", "alt"].map(|name| format!("\"{name}\"")).join(separator);
        let row = |k: u32| {
            [
                format!("\"{k}\""),
                k.to_string(),
                format!("{}", 48.0 + f64::from(k) * 1e-3),
                "11".into(),
                "300.5".into(),
            ]
        };
        let rows = (1..20).map(|k| row(k).join(separator) + "\n");
        let (found, log) = read(&format!("{names}\n{}", rows.collect::<String>()));
        let place = log.samples()[1].place;
        assert!(
            (place.latitude_rad.to_degrees() - 48.002).abs() < 1e-9 && place.height_m == 300.5,
            "{found:?}"
        );
        assert!(found.questions.is_empty() && log.samples().len() == 19, "{found:?}");
    }
}

#[test]
fn of_several_vehicles_one_is_read() {
    let row = |k: u32, who: &str, latitude: f64| format!("{k},{who},{latitude},11,300\n");
    let mut table = "time,icao24,lat,lon,altitude\n".to_owned();
    for k in 0..10 {
        table += &row(k, "ab12", 48.0 + f64::from(k) * 1e-3);
        table += &if k < 8 { row(k, "cd34", 51.0) } else { String::new() };
    }
    let (found, log) = read(&table);
    assert!(doubts(&found, "icao24 has 2 vehicles: the rows of ab12 are read; only"), "{found:?}");
    assert_eq!(log.samples().len(), 10);
    assert!(
        log.notes().iter().any(|note| note.sentence == "8 rows of others are left out: icao24 is not ab12")
    );
    let (found, log) = read(&table.replace("cd34", "ab12"));
    assert!(!found.text.contains("only"), "{found:?}");
    // Parts of one path are no vehicles; two that fly one after the other are.
    let parts = |jump: f64| {
        let row = |k: u32| {
            let part = k / 10;
            format!("{k},{part},{},11,300\n", 48.0 + f64::from(k) * 1e-3 + jump * f64::from(part))
        };
        "time,id,lat,lon,altitude\n".to_owned() + &(0..30).map(row).collect::<String>()
    };
    let (found, whole) = read(&parts(0.0));
    assert!(doubts(&found, "id numbers 3 parts of one path") && whole.samples().len() == 30, "{found:?}");
    assert!(doubts(&read(&parts(0.5)).0, "id has 3 vehicles"));
    // Numbers of rows tell no vehicles apart.
    let numbered = (0..10).map(|k| format!("{k},{k},{},11,300\n", 48.0 + f64::from(k) * 1e-3));
    let (found, _) = read(&("time,id,lat,lon,altitude\n".to_owned() + &numbered.collect::<String>()));
    assert!(!found.text.contains("only"), "{found:?}");
    let mut judge = crate::judge::Judge::new(crate::earth::Earth::default(), 2000.0).unwrap();
    log.judge(&mut judge, log.samples().len()).unwrap();
    let late = judge.findings().find(|finding| finding.kind == crate::judge::Kind::TimeOrder).unwrap();
    assert_eq!((late.count, late.level), (8, crate::judge::Level::Doubtful), "{late}");
}

#[test]
fn heights_in_steps_of_a_transponder_are_feet() {
    let table = |step: f64| {
        let rows = (0..9)
            .map(|k| format!("{k},{},11,{}\n", 48.0 + f64::from(k) * 1e-3, 9850.0 + f64::from(k) * step));
        "t,lat,lon,alt\n".to_owned() + &rows.collect::<String>()
    };
    for (step, words) in [(25.0, "is taken as ft"), (20.0, "is taken as m"), (0.0, "is taken as m")] {
        assert!(doubts(&survey(table(step).as_bytes()).unwrap(), words), "{step}");
    }
}

#[test]
fn a_variation_is_for_magnetic_headings() {
    for (heading, is_magnetic) in
        [("True Heading", false), ("heading", false), ("Magnetic Heading", true), ("HDG", true)]
    {
        let (found, log) = read(&format!(
            "t,lat,lon,alt,roll,pitch,{heading},Declination\n0,48,11,300,1,2,90,4\n1,48,11.0007,300,1,2,90,4\n"
        ));
        let expected = if is_magnetic { 94.0 } else { 90.0 };
        assert!(
            (log.samples()[0].euler.heading.to_degrees() - expected).abs() < 1e-9,
            "{heading}: {found:?}"
        );
        assert_eq!(doubts(&found, "is not used"), !is_magnetic, "{found:?}");
    }
    let (found, _) = read("t,lat,lon,alt,roll,pitch,HDG\n0,48,11,300,1,2,90\n1,48,11.0007,300,1,2,90\n");
    assert!(doubts(&found, "may be magnetic"), "{found:?}");
}

/// Clocks that count from the year 0, in seconds or milliseconds, are shifted to times that a sample may have; an answer to the question
/// what they are is too.
#[test]
fn times_from_long_ago_are_shifted() {
    for (name, unit, is_asked) in [("time", 1.0, false), ("time", 1e3, false), ("ABSOLUTE CLOCK", 1.0, true)]
    {
        let rows: String = (0..60)
            .map(|k| (63_800_000_000.0 + 0.1 * f64::from(k), 48.0 + 5.4e-5 * f64::from(k)))
            .map(|(time_s, latitude)| format!("{:.1},{latitude:.7},11,300\n", unit * time_s))
            .collect();
        let table = format!("{name},latitude,longitude,height_m\n{rows}");
        if is_asked {
            let found = survey(table.as_bytes()).unwrap();
            let answers = &found.questions[0].answers;
            let answer =
                "time = { col = \"ABSOLUTE CLOCK\", add = -63800000000 }  # 10 Hz, 60.0 m/s over ground";
            assert!(answers.iter().any(|own| own.starts_with(answer)), "{answers:?}");
            continue;
        }
        let (found, log) = read(&table);
        let [first, .., last] = log.samples() else { panic!("{found:?}") };
        assert!(first.time_s == 0.0 && (last.time_s - 5.9).abs() < 1e-4, "{} {}", first.time_s, last.time_s);
    }
}
