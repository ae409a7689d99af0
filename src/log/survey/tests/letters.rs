//! Positions with letters and parts beside them.

use super::super::super::{FlightLog, LogError};
use super::conventions::{Row, assert_asks, doubts_of, errors, flight, look, table};
use crate::scene::Scene;

/// The flight in the south-west without signs, with the cells of more columns before and behind.
fn text(names: &str, row: impl Fn(usize, [String; 2]) -> String) -> (String, Vec<Row>) {
    let rows = flight(-33.9, -70.6);
    let text = table(&format!("t,{names},alt (m)"), &rows, |index, values| {
        let place = [values[1], values[2]].map(|degrees| format!("{:.9}", -degrees));
        format!("{:.1},{},{:.3}", values[0], row(index, place), values[3])
    });
    (text, rows)
}

#[test]
fn letters_are_read_where_they_stand_and_one_that_is_none_is_refused() {
    for names in ["lat,lon,lat_dir,lon_dir", "lat,lon,GPSLatitudeRef,GPSLongitudeRef", "lat,lon,N/S,E/W"] {
        let (text, rows) = text(names, |_, [latitude, longitude]| format!("{latitude},{longitude},S,W"));
        let (found, samples) = look(&text);
        assert!(errors(&samples.unwrap(), &rows).0 < 0.01, "{names}: {found:?}");
    }
    let (text, _) = text("lat,N/S,lon,E/W", |index, [latitude, longitude]| {
        format!("{latitude},{},{longitude},W", if index == 77 { "?" } else { "S" })
    });
    let (found, samples) = look(&text);
    assert!(found.questions.is_empty(), "{found:?}");
    let Err(LogError::Fault(fault)) = samples else { panic!("{found:?}") };
    assert!(fault.line == 79 && fault.sentence.contains("expected N or S, found \"?\""), "{fault:?}");
}

#[test]
fn letters_that_are_not_read_are_asked_about() {
    for (names, letters, words) in [
        ("lat,lon,note,d1,d2", "x,S,W", "latitude = { col = \"lat\", hemisphere = \"d1\" }"),
        ("lat,lon,note,d1,d2", "x,S,W", "longitude = { col = \"lon\", hemisphere = \"d2\" }"),
        (
            "lat,lon,note,where",
            "x,SW",
            "latitude = { col = \"lat\", sign = -1 }\nlongitude = { col = \"lon\", sign = -1 }  # SW",
        ),
    ] {
        let row = |_, [latitude, longitude]: [String; 2]| format!("{latitude},{longitude},{letters}");
        assert_asks(&text(names, row).0, words);
    }
    // Letters that change nothing, and those of a wind.
    for (names, letters) in [
        ("lat,lon,note,d1,d2", "x,N,E"),
        ("lat,lon,note,where", "x,NE"),
        ("lat,lon,note,wind", "x,S"),
        ("lat,lon,note,wind dir", "x,SW"),
    ] {
        let row = |_, [latitude, longitude]: [String; 2]| format!("{latitude},{longitude},{letters}");
        assert!(look(&text(names, row).0).0.questions.is_empty(), "{names}");
    }
}

#[test]
fn signs_that_agree_with_their_letters_count_once() {
    let row = |_, [latitude, longitude]: [String; 2]| format!("-{latitude},S,-{longitude},W");
    let (text, rows) = text("lat,N/S,lon,E/W", row);
    let (found, samples) = look(&text);
    assert!(errors(&samples.unwrap(), &rows).0 < 0.01 && doubts_of(&found, "has its sign"), "{found:?}");
    // One that disagrees is refused.
    let (found, samples) = look(&text.replacen(",S,", ",N,", 1));
    assert!(found.text.contains("hemisphere = \"N/S\"") && samples.is_err(), "{found:?}");
}

#[test]
fn degrees_minutes_and_seconds_apart_are_read_where_a_vehicle_moves() {
    for [latitude, longitude] in [[47.3, 8.4], [-33.9, -70.6], [0.001, -0.002]] {
        let rows = flight(latitude, longitude);
        for (names, count, letters) in [
            ("lat deg,lat min,lon deg,lon min", 2, false),
            ("lat,minutes,lon,min", 2, false),
            ("Lat (deg),LatMin,Lon (deg),LonMin", 2, false),
            ("lat_deg,lat_min,lat_sec,lon_deg,lon_min,lon_sec", 3, false),
            ("LatD,LatM,LatS,LonD,LonM,LonS", 3, false),
            ("lat_dd,lat_mm,lat_ss,lon_dd,lon_mm,lon_ss", 3, false),
            ("LatD,LatM,LatS,NS,LonD,LonM,LonS,EW", 3, true),
            ("lat_deg,lat_min,lat_sec,N/S,lon_deg,lon_min,lon_sec,E/W", 3, true),
        ] {
            let apart = |degrees: f64, sides: [&str; 2]| {
                let (size, is_negative) = (degrees.abs(), degrees < 0.0);
                let minutes = size.fract() * 60.0;
                let sign = if is_negative && !letters { "-" } else { "" };
                let first = format!("{sign}{}", size.trunc());
                let parts = match count {
                    2 => format!("{first},{minutes:.8}"),
                    _ => format!("{first},{},{:.6}", minutes.trunc(), minutes.fract() * 60.0),
                };
                let letter = sides[usize::from(is_negative)];
                if letters { format!("{parts},{letter}") } else { parts }
            };
            let text = table(&format!("t,{names},alt (m)"), &rows, |_, row| {
                let [latitude, longitude] = [apart(row[1], ["N", "S"]), apart(row[2], ["E", "W"])];
                format!("{:.1},{latitude},{longitude},{:.3}", row[0], row[3])
            });
            let (found, samples) = look(&text);
            assert!(errors(&samples.unwrap(), &rows).0 < 0.05, "{names}: {found:?}");
            assert!(doubts_of(&found, "is taken as the minutes of the latitude"), "{found:?}");
        }
    }
}

#[test]
fn minutes_beyond_their_range_are_refused_at_their_cell() {
    let read = |cells: &str| {
        let text = "[flight]\nfile = \"a.csv\"\n[log]\ntime = \"t\"\nlatitude = { col = \"d\", minutes = \"m\", seconds = \"s\" }\nlongitude = 8\nheight = 0\nroll = 0\npitch = 0\nheading = 0\n";
        let scene = Scene::parse(text.as_bytes()).unwrap();
        assert_eq!(Scene::parse(scene.write().as_bytes()).unwrap().log, scene.log);
        FlightLog::parse_with(format!("t,d,m,s\n0,{cells}\n1,{cells}\n2,-0,30,36\n").as_bytes(), &scene.log)
    };
    let log = read("47,18,15").unwrap();
    let degrees = [0, 2].map(|row| log.samples()[row].place.latitude_rad.to_degrees());
    assert!(
        (degrees[0] - (47.0 + 18.0 / 60.0 + 15.0 / 3600.0)).abs() < 1e-12
            && (degrees[1] + 0.51).abs() < 1e-12,
        "{degrees:?}"
    );
    assert!(read("47,,15").is_err());
    let signed = read("-47,-18,-15").unwrap();
    assert_eq!(signed.samples()[0].place.latitude_rad, -log.samples()[0].place.latitude_rad);
    for (cells, column, words) in [
        ("47,60.1,0", 3, "expected minutes"),
        ("47.3,18,1", 3, "expected whole degrees beside minutes, found 47.3"),
        ("47,18.5,1", 4, "expected whole minutes beside seconds, found 18.5"),
        ("47,-18,1", 3, "expected minutes"),
        ("47,18,-1", 4, "expected seconds"),
        ("47,x,1", 3, "found \"x\""),
    ] {
        let Err(LogError::Fault(fault)) = read(cells) else { panic!("{cells}") };
        assert!((fault.line, fault.column) == (2, column) && fault.sentence.contains(words), "{fault:?}");
    }
    for more in ["seconds = \"s\"", "minutes = \"m\", unit = \"rad\""] {
        let text = format!("[flight]\nfile = \"a.csv\"\n[log]\nlatitude = {{ col = \"d\", {more} }}\n");
        let faults = Scene::parse(text.as_bytes()).unwrap_err();
        assert!(faults[0].sentence.contains("seconds stand beside minutes"), "{faults:?}");
    }
}

#[test]
fn whole_degrees_beside_minutes_of_no_vehicle_are_asked_about() {
    let rows = flight(47.3, 8.4);
    // Minutes that jump.
    let text = table("t,lat deg,lat min,lon deg,lon min,alt (m)", &rows, |index, row| {
        format!("{:.1},47,{},8,{},{:.3}", row[0], (index * 37) % 60, (index * 23) % 60, row[3])
    });
    let found = assert_asks(&text, "are their minutes in");
    assert_eq!(found.questions.len(), 2, "{found:?}");
    // Degrees with decimals need none.
    let text = table("t,lat,min,lon,alt (m)", &rows, |_, row| {
        format!("{:.1},{:.8},3,{:.8},{:.3}", row[0], row[1], row[2], row[3])
    });
    assert!(look(&text).0.questions.is_empty());
}

#[test]
fn a_course_that_the_positions_contradict_is_asked_about() {
    for (latitude, longitude, answer) in [
        (
            -33.9,
            70.6,
            "latitude = { col = \"lat\", sign = -1 }\nlongitude = \"lon\"  # the course of the table",
        ),
        (
            -33.9,
            -70.6,
            "latitude = { col = \"lat\", sign = -1 }\nlongitude = { col = \"lon\", sign = -1 }  # the",
        ),
    ] {
        let rows = flight(latitude, longitude);
        let course = |row: &Row, more: f64| (row[5] + more) % 360.0;
        let text = |more: f64| {
            table("t,lat,lon,alt (m),speed (m/s),course", &rows[..100], |_, row| {
                let place = [row[1], row[2]].map(|degrees| format!("{:.9}", degrees.abs()));
                format!("{:.1},{},{:.3},40,{:.2}", row[0], place.join(","), row[3], course(row, more))
            })
        };
        assert_asks(&text(0.0), answer);
    }
}
