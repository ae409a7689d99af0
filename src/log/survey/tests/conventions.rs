//! One flight in the conventions of many loggers: it is read where it was flown, or asked about.

use super::super::super::{FlightLog, LogError};
use super::super::motion::{READINGS, Reading};
use super::super::*;
use crate::scene::Scene;
use crate::truth::FlightSample;

/// Time \[s\], latitude and longitude \[deg\], height \[m\], speed \[m/s\], course \[deg\].
pub type Row = [f64; 6];

/// A minute at 5 Hz and 40 m/s, with a turn.
pub fn flight(latitude: f64, longitude: f64) -> Vec<Row> {
    let (mut latitude, mut longitude, speed, step) = (latitude, longitude, 40.0, 0.2);
    let mut rows = Vec::new();
    for index in 0..300 {
        let time = f64::from(index) * step;
        let course = 20.0 + 3.0 * (time - 20.0).clamp(0.0, 20.0);
        rows.push([time, latitude, longitude, 500.0 + 0.5 * time, speed, course]);
        let (sine, cosine) = course.to_radians().sin_cos();
        let angle = (speed * step / 6.371e6_f64).to_degrees();
        latitude += angle * cosine;
        longitude += angle * sine / latitude.to_radians().cos();
    }
    rows
}

/// The survey of a table, and the samples that its `[log]` reads.
pub fn look(table: &str) -> (Survey, Result<Vec<FlightSample>, LogError>) {
    let found = survey(table.as_bytes()).unwrap_or_else(|| panic!("{table}"));
    let text = format!("[flight]\nfile = \"a.csv\"\n[log]\n{}", found.text);
    let scene = Scene::parse(text.as_bytes()).unwrap_or_else(|faults| panic!("{faults:?}\n{text}"));
    let log = FlightLog::parse_with(table.as_bytes(), &scene.log);
    (found, log.map(|log| log.samples().to_vec()))
}

/// Largest distance of the samples from the flight [m], and the difference of their durations [s].
pub fn errors(samples: &[FlightSample], rows: &[Row]) -> (f64, f64) {
    assert_eq!(samples.len(), rows.len());
    let distance = |(sample, row): (&FlightSample, &Row)| {
        let north = sample.place.latitude_rad - row[1].to_radians();
        let east = (sample.place.longitude_rad - row[2].to_radians()) * row[1].to_radians().cos();
        (6.371e6 * north.hypot(east)).hypot(sample.place.height_m - row[3])
    };
    let largest = samples.iter().zip(rows).map(distance).fold(0.0, f64::max);
    let duration = samples[samples.len() - 1].time_s - samples[0].time_s;
    (largest, (duration - (rows[rows.len() - 1][0] - rows[0][0])).abs())
}

/// The survey asks, and what it writes flies nothing.
pub fn assert_asks(table: &str, words: &str) -> Survey {
    let (found, samples) = look(table);
    let asked = |question: &Question| {
        question.sentence.contains(words) || question.answers.iter().any(|answer| answer.contains(words))
    };
    assert!(found.questions.iter().any(asked), "{words}: {found:?}");
    assert!(samples.is_err(), "{found:?}");
    found
}

/// The table that `row` prints.
pub fn table(names: &str, rows: &[Row], row: impl Fn(usize, &Row) -> String) -> String {
    let rows = rows.iter().enumerate().map(|(index, values)| row(index, values) + "\n");
    format!("{names}\n{}", rows.collect::<String>())
}

fn clock_text(time: f64) -> String {
    format!("2026-05-03 09:{:02}:{:06.3}", 14 + (time / 60.0) as u32, time % 60.0)
}

#[test]
fn a_time_is_found_or_asked_about_and_a_row_is_never_a_second() {
    let rows = flight(47.3, 8.4);
    let place = |row: &Row| format!("{:.9},{:.9},{:.3}", row[1], row[2], row[3]);
    for (names, cells) in [
        ("Time", (|_, row| format!("{:.1} sec", row[0])) as fn(usize, &Row) -> String),
        ("Time", |_, row| format!("{:.1} s", row[0])),
        ("", |_, row| clock_text(row[0])),
        ("ISO time", |_, row| clock_text(row[0])),
        ("Relative Time", |_, row| format!("{:.2}", row[0] + 7.0)),
        ("TimeFromStart (s)", |_, row| format!("{:.2}", row[0] + 7.0)),
        ("Date & Time,Session Time", |_, row| format!("{},{:.2}", clock_text(row[0].floor()), row[0])),
        ("Session Time,Date & Time", |_, row| format!("{:.2},{}", row[0], clock_text(row[0].floor()))),
    ] {
        let names = format!("{names},lat,lon,alt");
        let text = table(&names, &rows, |index, row| format!("{},{}", cells(index, row), place(row)));
        let (found, samples) = look(&text);
        let (distance, late) = errors(&samples.unwrap(), &rows);
        assert!(distance < 0.01 && late < 1e-6, "{names}: {distance} m, {late} s: {found:?}");
    }
    // Times in a column of another name are candidates with what they would mean.
    for (factor, answer) in [
        (1.0, "time = \"Moment\"  # 5 Hz, 40.0 m/s"),
        (1e3, "time = { col = \"Moment\", unit = \"ms\" }  # 5 Hz, 40.0 m/s"),
        (1e4, "time = { col = \"Moment\", scale = 1e-4 }  # 5 Hz, 40.0 m/s"),
        (1e9, "time = { col = \"Moment\", unit = \"ns\" }  # 5 Hz, 40.0 m/s"),
    ] {
        let text = table("Moment,n,lat,lon,alt", &rows, |index, row| {
            format!("{:.3},{index},{}", row[0] * factor, place(row))
        });
        let found = assert_asks(&text, answer);
        assert!(!found.text.contains("rate_hz"), "{found:?}");
    }
    let text = table("Moment,lat,lon,alt", &rows, |_, row| format!("{},{}", clock_text(row[0]), place(row)));
    assert_asks(&text, "time = \"Moment\"\ntime_format = \"iso\"");
    // Without a column of times the rate is asked for: the speed says it.
    let text = table("lat,lon,alt,speed (m/s)", &rows, |_, row| format!("{},{}", place(row), row[4]));
    assert_asks(&text, "time_format = \"row\"\nrate_hz = 5.0");
    assert_asks(&table("lat,lon,alt", &rows, |_, row| place(row)), "rate_hz = RATE");
    // Ticks that are none of the units contradict the speed.
    let text = table("t,lat,lon,alt,speed (m/s)", &rows, |_, row| {
        format!("{:.0},{},{}", row[0] * 100.0, place(row), row[4])
    });
    assert_asks(&text, "has no unit with which the positions have the speed");
    let text = table("t,lat,lon,alt,speed (m/s)", &rows, |_, row| {
        format!("{:.0},{},{}", row[0] * 1e4, place(row), row[4])
    });
    assert!(errors(&look(&text).1.unwrap(), &rows).1 < 1e-6);
}

/// Degrees as a logger writes them.
pub fn written(reading: usize, degrees: f64) -> String {
    let minutes = (degrees.abs() % 1.0) * 60.0;
    match reading {
        0 => format!("{degrees:.8}"),
        1 => format!("{:.6}", degrees.signum() * (degrees.abs().floor() * 100.0 + minutes)),
        2 => format!("{:.6}", degrees * 60.0),
        3 => format!("{:.4}", degrees * 3600.0),
        4 => format!("{:.3}", degrees * 1e5),
        5 => format!("{:.2}", degrees * 1e6),
        6 => format!("{:.0}", degrees * 1e7),
        7 => format!("{:.0}", degrees / 180.0 * 2_147_483_648.0),
        _ => format!("{:.10}", degrees.to_radians()),
    }
}

#[test]
fn a_position_in_any_unit_is_found_by_speed_and_course_and_otherwise_asked_about() {
    for (latitude, longitude) in [(47.3, 8.4), (-33.9, 151.2), (61.2, -149.9)] {
        let rows = flight(latitude, longitude);
        for (reading, Reading { words, .. }) in READINGS.iter().enumerate() {
            let place = |row: &Row| [row[1], row[2]].map(|degrees| written(reading, degrees)).join(",");
            for (names, factor) in [("speed (m/s),course", 1.0), ("spd,course", 3600.0 / 1852.0)] {
                let text = table(&format!("t,lat,lon,alt,{names}"), &rows, |_, row| {
                    format!("{:.1},{},{:.3},{:.2},{:.1}", row[0], place(row), row[3], row[4] * factor, row[5])
                });
                let (found, samples) = look(&text);
                assert!(found.questions.is_empty(), "{words}: {found:?}");
                let (distance, late) = errors(&samples.unwrap(), &rows);
                assert!(distance < 0.2 && late < 1e-6, "{words}: {distance} m, {late} s: {found:?}");
                assert_eq!(
                    found.doubts.iter().any(|doubt| doubt.contains("no other reading")),
                    (1..8).contains(&reading)
                );
            }
            let text =
                table("t,lat,lon,alt", &rows, |_, row| format!("{:.1},{},{:.3}", row[0], place(row), row[3]));
            match reading {
                0 => assert!(errors(&look(&text).1.unwrap(), &rows).0 < 0.2, "{words}"),
                8 => drop(assert_asks(
                    &text,
                    &format!("radians: from {latitude:.4}, {longitude:.4} deg, 40.0 m/s"),
                )),
                _ => {
                    let found = assert_asks(
                        &text,
                        &format!("{words}: from {latitude:.4}, {longitude:.4} deg, 40.0 m/s"),
                    );
                    assert!(!found.text.contains("latitude = "), "{found:?}");
                }
            }
        }
        // Exchanged columns are found by the course.
        let text = table("t,lon,lat,alt,speed (m/s),course", &rows, |_, row| {
            format!("{:.1},{:.8},{:.8},{:.3},{:.2},{:.1}", row[0], row[1], row[2], row[3], row[4], row[5])
        });
        let (found, samples) = look(&text);
        let (distance, _) = errors(&samples.unwrap(), &rows);
        assert!(distance < 0.01 && doubts_of(&found, "exchanged"), "{distance} m: {found:?}");
    }
    // A speed through the air contradicts no position, and a row that is nowhere is a fault at its line.
    let rows = flight(47.3, 8.4);
    let text = table("t,lat,lon,alt,speed (m/s),course", &rows, |_, row| {
        format!("{:.1},{:.8},{:.8},{:.3},{:.2},{:.1}", row[0], row[1], row[2], row[3], row[4] * 0.8, row[5])
    });
    let (found, samples) = look(&text);
    assert!(
        errors(&samples.unwrap(), &rows).0 < 0.01 && doubts_of(&found, "1.250 times the speed"),
        "{found:?}"
    );
    let (found, samples) = look(&text.replace("\n20.0,47.", "\n20.0,147."));
    assert!(found.questions.is_empty(), "{found:?}");
    let Err(LogError::Fault(fault)) = samples else { panic!("{found:?}") };
    assert!(fault.line == 102 && fault.sentence.contains("must be from -90 to 90"), "{fault:?}");
    // Milliseconds and velocities that state no unit.
    let text = table("t,lat,lon,alt,speed,course", &rows, |_, row| {
        format!("{:.0},{:.8},{:.8},{:.3},{:.2},{:.1}", row[0] * 1e3, row[1], row[2], row[3], row[4], row[5])
    });
    assert!(errors(&look(&text).1.unwrap(), &rows).1 < 1e-6);
    // Metres of a map are no angles.
    let text = table("t,lat,lon,alt", &flight(47.3, 8.4), |_, row| {
        format!("{:.1},{:.2},{:.2},{:.3}", row[0], row[1] * 111_195.0, 500_000.0 + row[2] * 75_000.0, row[3])
    });
    assert_asks(&text, "lat and lon are no degrees");
}

pub fn doubts_of(found: &Survey, words: &str) -> bool {
    found.doubts.iter().any(|doubt| doubt.contains(words))
}

/// NMEA writes the hemisphere into a column of its own.
#[test]
fn degrees_and_minutes_have_letters_of_hemispheres() {
    let rows = flight(-33.9, -70.6);
    let text = table("UTC,Lat,N/S,Lon,E/W,Alt(m),Spd(knots),Course", &rows, |_, row| {
        let [latitude, longitude] = [row[1], row[2]].map(|degrees| written(1, -degrees));
        let knots = row[4] * 3600.0 / 1852.0;
        format!("{:.1},{latitude},S,{longitude},W,{:.3},{knots:.2},{:.1}", row[0], row[3], row[5])
    });
    let (found, samples) = look(&text);
    assert!(
        found.text.contains("latitude = { col = \"Lat\", unit = \"ddmm\", hemisphere = \"N/S\" }"),
        "{found:?}"
    );
    assert!(errors(&samples.unwrap(), &rows).0 < 0.01);
}

#[test]
fn positions_that_are_none_on_the_earth_are_refused_at_their_cell() {
    let read = |keys: &str, cells: &str| {
        let text = format!(
            "[flight]\nfile = \"a.csv\"\n[log]\ntime = \"t\"\nheight = 0\nroll = 0\npitch = 0\nheading = 0\n{keys}"
        );
        let scene = Scene::parse(text.as_bytes()).unwrap();
        assert_eq!(Scene::parse(scene.write().as_bytes()).unwrap().log, scene.log);
        let table = format!("t,a,b\n0,{cells}\n1,{cells}\n");
        FlightLog::parse_with(table.as_bytes(), &scene.log)
    };
    let minutes = "latitude = { col = \"a\", unit = \"ddmm\" }\nlongitude = { col = \"b\", unit = \"ddmm\" }";
    let place = read(minutes, "4718.3,-1206.6").unwrap().samples()[0].place;
    let degrees = [place.latitude_rad, place.longitude_rad].map(f64::to_degrees);
    assert!((degrees[0] - 47.305).abs() < 1e-12 && (degrees[1] + 12.11).abs() < 1e-12, "{degrees:?}");
    for (keys, cells, column, words) in [
        (minutes, "4760,11", 2, "a: expected degrees and minutes, as 4718.25, found \"4760\""),
        ("latitude = \"a\"\nlongitude = \"b\"", "47,824", 3, "b = 824: must be from -360 to 360"),
    ] {
        let Err(LogError::Fault(fault)) = read(keys, cells) else { panic!("{words}") };
        assert!((fault.line, fault.column) == (2, column) && fault.sentence.starts_with(words), "{fault:?}");
    }
    let text = "[flight]\nfile = \"a.csv\"\n[log]\nroll = { col = \"a\", unit = \"ddmm\" }\n";
    let faults = Scene::parse(text.as_bytes()).unwrap_err();
    assert!(
        faults[0].sentence.contains("log.roll.unit: expected deg, rad, arcmin, arcsec, semicircle"),
        "{faults:?}"
    );
}

#[test]
fn a_height_is_read_in_its_unit_or_asked_about() {
    let rows = flight(47.3, 8.4);
    let text = |name: &str, size: f64| {
        table(&format!("t,lat,lon,{name}"), &rows, |_, row| {
            format!("{:.1},{:.8},{:.8},{:.3}", row[0], row[1], row[2], row[3] / size)
        })
    };
    for (name, size) in [
        ("alt (m)", 1.0),
        ("Alt[ft]", 0.3048),
        ("alt_mm", 1e-3),
        ("PosAlt_cm", 1e-2),
        ("height (km)", 1e3),
        ("enhanced_altitude", 1.0),
        ("Altitude (ft MSL)", 0.3048),
        ("alt_ft_amsl", 0.3048),
    ] {
        let (found, samples) = look(&text(name, size));
        let (distance, _) = errors(&samples.unwrap(), &rows);
        assert!(distance < 0.6, "{name}: {distance} m: {found:?}");
    }
    assert_asks(&text("alt", 1e-3), "height = { col = \"alt\", unit = \"mm\" }  # begins at 500.0 m");
    assert_asks(&text("My altitude above all", 1.0), "height = \"My altitude above all\"");
    assert_asks(&text("x", 1.0), "height = 0  # all the way");
    // Those of a question have their units, and where they begin.
    for (name, size, answer) in [
        (
            "Altitude (ft AGL)",
            0.3048,
            "height = { col = \"Altitude (ft AGL)\", unit = \"ft\" }  # begins at 500.0 m",
        ),
        ("Alt [mm above sea]", 1e-3, "unit = \"mm\" }  # begins at 500.0 m"),
        ("Alt above sea", 0.3048, "height = { col = \"Alt above sea\", unit = \"ft\" }  # begins at 500.0 m"),
        ("Alt above sea", 1.0, "height = \"Alt above sea\"  # begins at 500.0 m"),
        ("FL", 30.48, "height = { col = \"FL\", scale = 30.48 }  # begins at 500.0 m"),
        ("alt_geom", 0.3048, "height = { col = \"alt_geom\", unit = \"ft\" }  # begins at 500.0 m"),
        ("alt_baro", 1.0, "height = { col = \"alt_baro\", unit = \"m\" }  # begins at 500.0 m"),
    ] {
        let found = assert_asks(&text(name, size), answer);
        assert!(!found.text.contains("height"), "{found:?}");
    }
}

/// A `[log]` written by hand names columns whose names state units.
#[test]
fn a_unit_in_the_name_of_a_column_counts_where_the_log_states_none() {
    let read = |height: &str, name: &str| {
        let text = format!(
            "[flight]\nfile = \"a.csv\"\n[log]\ntime = \"t_ms\"\nlatitude = \"PosLat (rad)\"\nlongitude = {{ col = 3 }}\nheight = {height}\nroll = \"Roll (rad)\"\npitch = 0\nheading = 0\n"
        );
        let scene = Scene::parse(text.as_bytes()).unwrap();
        let table = format!(
            "t_ms,PosLat (rad),Lon [rad],{name},Roll (rad)\n0,0.8,0.2,1000,0.1\n200,0.8,0.2,1000,0.1\n"
        );
        let log = FlightLog::parse_with(table.as_bytes(), &scene.log).unwrap();
        let sample = log.samples()[1];
        assert_eq!(
            [sample.time_s, sample.place.latitude_rad, sample.place.longitude_rad, sample.euler.roll],
            [0.2, 0.8, 0.2, 0.1]
        );
        let notes: Vec<String> = log.notes().iter().map(|note| note.sentence.clone()).collect();
        (
            sample.place.height_m,
            notes.iter().any(|note| note.contains("is read in") && note.starts_with(name)),
        )
    };
    assert_eq!(read("\"Alt (ft)\"", "Alt (ft)"), (304.8, true));
    assert_eq!(read("{ col = \"Alt[cm]\", sign = -1 }", "Alt[cm]"), (-10.0, true));
    assert_eq!(read("\"Alt (m)\"", "Alt (m)"), (1000.0, false));
    // What is stated counts, and a conversion by a scale is not done twice.
    assert_eq!(read("{ col = \"Alt (ft)\", unit = \"m\" }", "Alt (ft)"), (1000.0, false));
    assert_eq!(read("{ col = \"Alt (ft)\", scale = 0.5 }", "Alt (ft)"), (500.0, false));
}
