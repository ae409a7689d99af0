//! Flight records by `sins_log_parse`, for every host: each gives the bits of a table that has its numbers.

use std::fmt::Write;
use std::ptr::null_mut;

use sins::abi::*;
use sins::log::{FlightLog, LogError};
use sins::scene::Scene;

use crate::support::init;

/// Number of fixes, one a second: a circle that climbs.
const FIXES: u32 = 90;

/// A fix: seconds, latitude and longitude [1/60000 deg], height [m].
fn fix(k: u32) -> (u32, u32, u32, u32) {
    let phase = 0.07 * f64::from(k);
    let of = |middle: f64, part: f64| (middle + 300.0 * part).round() as u32;
    (43_200 + k, of(48.1 * 60_000.0, phase.sin()), of(11.3 * 60_000.0, phase.cos()), 900 + k)
}

fn clock(seconds: u32, mark: &str) -> String {
    [seconds / 3600, seconds / 60 % 60, seconds % 60].map(|part| format!("{part:02}")).join(mark)
}

fn igc() -> String {
    (0..FIXES).map(fix).fold("AXXX001\r\nHFDTE250726\r\n".to_owned(), |mut text, fix| {
        let (time, latitude, longitude, height) = fix;
        let angle = |of: u32, width: usize| format!("{:0width$}{:05}", of / 60_000, of % 60_000);
        write!(text, "B{}{}N{}EA", clock(time, ""), angle(latitude, 2), angle(longitude, 3)).unwrap();
        write!(text, "{:05}{height:05}\r\n", height - 60).unwrap();
        text
    })
}

/// All on one line.
fn gpx() -> String {
    let points = (0..FIXES).map(fix).fold(String::new(), |mut text, (time, latitude, longitude, height)| {
        let [latitude, longitude] = [latitude, longitude].map(|angle| f64::from(angle) / 60_000.0);
        let time = clock(time, ":");
        write!(text, "<trkpt lat=\"{latitude}\" lon=\"{longitude}\"><ele>{height}</ele>").unwrap();
        write!(text, "<time>2026-07-25T{time}Z</time></trkpt>").unwrap();
        text
    });
    format!("<?xml version=\"1.0\"?><gpx version=\"1.1\"><trk><trkseg>{points}</trkseg></trk></gpx>")
}

fn fdr() -> String {
    (0..FIXES).map(fix).fold("A\n4\nCOMM, a flight\n".to_owned(), |mut text, fix| {
        let (time, latitude, longitude, height) = fix;
        let [latitude, longitude] = [latitude, longitude].map(|angle| f64::from(angle) / 60_000.0);
        let feet = f64::from(height) * 3.25;
        writeln!(text, "{}, {longitude}, {latitude}, {feet}, 90, 2, -1.5", clock(time, ":")).unwrap();
        text
    })
}

/// The numbers of a record as a table of the library's own columns. Heights of an FDR are in feet.
fn table(is_fdr: bool) -> String {
    let angles = if is_fdr { ",roll_deg,pitch_deg,heading_deg" } else { "" };
    let header = format!("time_s,latitude_deg,longitude_deg,height_m{angles}\n");
    (0..FIXES).map(fix).fold(header, |mut text, (time, latitude, longitude, height)| {
        let [latitude, longitude] = [latitude, longitude].map(|angle| f64::from(angle) / 60_000.0);
        let height = if is_fdr { f64::from(height) * 3.25 * 0.3048 } else { f64::from(height) };
        writeln!(text, "{time},{latitude},{longitude},{height}{}", if is_fdr { ",-1.5,2,90" } else { "" })
            .unwrap();
        text
    })
}

/// The samples of a text, read with these lines of a scene, or line and sentence of its fault.
fn parsed(text: &str, lines: &str) -> Result<Vec<String>, (u64, String)> {
    let scene_text = format!("[flight]\nfile = \"a\"\n{lines}");
    let (mut scene, mut log, mut fault) = (null_mut(), null_mut(), init::<sins_fault>());
    // SAFETY: texts with their sizes, places for handles, structs of the interface, living handles.
    unsafe {
        assert_eq!(sins_scene_parse(scene_text.as_ptr().cast(), scene_text.len(), &mut scene), SINS_OK);
        let status = sins_log_parse(text.as_ptr().cast(), text.len(), scene, &mut log, &mut fault);
        assert_eq!(sins_scene_destroy(scene), SINS_OK);
        if status != SINS_OK {
            assert_eq!(status, SINS_ERROR_INVALID_ARGUMENT);
            return Err((fault.line, crate::support::text(&fault.sentence)));
        }
        let mut info = init::<sins_log_info>();
        assert_eq!(sins_log_get_info(log, &mut info), SINS_OK);
        let sample = |index| {
            let mut sample = init::<sins_flight_sample>();
            assert_eq!(sins_log_get_sample(log, index, &mut sample, null_mut()), SINS_OK);
            // Its numbers as text give their bits.
            format!("{sample:?}")
        };
        let samples = (0..info.samples as usize).map(sample).collect();
        assert_eq!(sins_log_destroy(log), SINS_OK);
        Ok(samples)
    }
}

/// Records and tables of the same numbers, and what a table needs to be smoothed as a record is.
#[test]
fn a_record_gives_the_bits_of_the_table_of_its_numbers() {
    let coordinated = "smooth = \"auto\"\nattitude = \"coordinated\"\n";
    for (name, record, is_fdr, of_table) in [
        ("IGC", igc(), false, coordinated),
        ("GPX", gpx(), false, coordinated),
        ("FDR", fdr(), true, "smooth = \"auto\"\n"),
    ] {
        for keys in [
            "",
            "smooth_rate_hz = 20\nposition_sigma_m = 3\n",
            "geoid = 45.5\n",
            "height = { col = 4, scale = 1.5, add = -3 }\n",
            "height = { col = \"height_m\", unit = \"ft\", sign = -1 }\n",
        ] {
            let of_record = parsed(&record, &format!("[log]\n{keys}")).unwrap();
            let of_table = parsed(&table(is_fdr), &format!("[log]\n{of_table}{keys}")).unwrap();
            let rate_hz = if keys.contains("rate") { 20 } else { 50 };
            // The path may begin up to 3 s late: it needs rows on both sides.
            let most = (rate_hz * (FIXES - 1) + 1) as usize;
            assert!((most - 3 * rate_hz as usize..=most).contains(&of_record.len()), "{name} {keys}");
            assert!(of_record == of_table, "{name} {keys}: {} and {}", of_record[9], of_table[9]);
        }
        // An attitude that [log] names replaces that of a coordinated flight.
        let [level, own] = ["roll = 1\npitch = 2\nheading = 3\n", ""]
            .map(|keys| parsed(&record, &format!("[log]\n{keys}")).unwrap());
        assert!(level != own, "{name}");
    }
}

/// The lines of samples and faults are those of the record, also of fixes that share a line.
#[test]
fn lines_are_those_of_the_record() {
    for (record, first, second) in [(igc(), 3, 4), (gpx(), 1, 1), (fdr(), 4, 5)] {
        let log = FlightLog::parse(record.as_bytes()).unwrap();
        assert!(log.is_to_be_smoothed());
        assert_eq!(log.samples().len(), FIXES as usize);
        assert_eq!([log.line(0), log.line(1)], [Some(first), Some(second)]);
        assert!(log.notes()[0].sentence.contains(&format!("{FIXES} ")), "{:?}", log.notes());
    }
    assert_eq!(
        parsed(&fdr().replacen("2925,", "x,", 1), "").unwrap_err(),
        (4, "altitude: expected a finite number, found \"x\"".to_owned())
    );
}

/// What only a table has, said where nothing would use it; and sizes that a file must not choose.
#[test]
fn what_no_record_has_is_rejected() {
    for keys in [
        "separator = \"semicolon\"",
        "header = 3",
        "skip = 1",
        "comment = \"%\"",
        "time_format = \"hms\"",
        "only_column = \"a\"\nonly = \"b\"",
        "height = { col = \"height_m\", part = 2 }",
    ] {
        for record in [igc(), gpx(), fdr()] {
            let (line, sentence) = parsed(&record, &format!("[log]\n{keys}\n")).unwrap_err();
            assert!(line == 0 && sentence.contains("a flight record is no table"), "{keys}: {sentence}");
        }
    }
    let deep = format!("<gpx>{}", "<a>".repeat(100_000));
    let long_name = format!("<gpx><{}>", "a".repeat(100_000));
    let long_prefix = format!("<gpx><{}:a>", "a".repeat(100_000));
    let long_end = format!("<gpx></{}>", "a".repeat(100_000));
    let long_text = format!("<gpx><trkpt lat=\"1\" lon=\"1\"><time>{}", "1".repeat(100_000));
    for (text, what) in [
        (deep, "expected at most 64 elements in one another"),
        (long_name, "names of at most 256 bytes"),
        (long_prefix, "names of at most 256 bytes"),
        (long_end, "expected XML: "),
        (long_text, "has at most 256 bytes"),
    ] {
        let (line, sentence) = parsed(&text, "").unwrap_err();
        assert!(line == 1 && sentence.contains(what) && sentence.len() < 400, "{sentence}");
    }
    // The path between few fixes is long by their stamps alone.
    let days = (0..24).fold("A\n4\nCOMM, days\n".to_owned(), |text, k| {
        format!("{text}{},{},48.1,2900,90,2,-1.5\n", 100_000 * k, 11.3 + 0.01 * f64::from(k))
    });
    let (_, sentence) = parsed(&days, "").unwrap_err();
    assert!(sentence.contains("must be from 1 to 1096000"), "{sentence}");
    // The column of a fault is that of a table.
    let far = fdr().replacen("2925,", "1e300,", 1);
    let Err(LogError::Fault(found)) = FlightLog::parse(far.as_bytes()) else { panic!("{far}") };
    assert_eq!((found.line, found.column), (4, 1), "{}", found.sentence);
}

/// A log that was read as one mapping says is not flown by a scene of another, also of a record.
#[test]
fn a_scene_flies_the_record_that_it_read() {
    let scene = |keys: &str| Scene::parse(format!("[flight]\nfile = \"a\"\n{keys}").as_bytes()).unwrap();
    let (plain, other) = (scene(""), scene("[log]\ngeoid = 45\n"));
    let Ok(log) = plain.read_log(igc().as_bytes()) else { panic!() };
    assert!(plain.samples(Some(&log)).is_ok() && other.samples(Some(&log)).is_err());
    // Its rows are no path, and have no attitude.
    assert!(plain.samples(Some(&FlightLog::parse(igc().as_bytes()).unwrap())).is_err());
    assert!(matches!(plain.read_log(b"<gpx></gpx>"), Err(LogError::Fault(_))));
}
