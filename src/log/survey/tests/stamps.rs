//! Times that look like others: clocks without colons, stopwatches, and times that contradict a speed.

use super::conventions::{Row, assert_asks, doubts_of, errors, flight, look, table};

fn place(row: &Row) -> String {
    format!("{:.9},{:.9},{:.3}", row[1], row[2], row[3])
}

/// hhmmss.ss of a time that begins at this second of a day.
fn face(second: f64) -> String {
    let minutes = (second / 60.0) as u32;
    format!("{:02}{:02}{:05.2}", minutes / 60, minutes % 60, second % 60.0)
}

#[test]
fn hours_minutes_and_seconds_without_colons_are_no_seconds() {
    let rows = flight(47.3, 8.4);
    // Over the ends of a minute, of an hour, and with the first zero lost.
    for (name, begin) in [("utc", 33294.0), ("time", 33294.0), ("Time", 35990.0), ("time (s)", 43190.0)] {
        for end in ["", ",velocity east (m/s),velocity north (m/s),velocity up (m/s)"] {
            let velocity = if end.is_empty() { "" } else { ",20,30,0" };
            let text = table(&format!("{name},lat,lon,alt{end}"), &rows, |_, row| {
                let cell = face(begin + row[0]);
                format!("{},{}{velocity}", cell.strip_prefix('0').unwrap_or(&cell), place(row))
            });
            let (found, samples) = look(&text);
            let (distance, late) =
                errors(&samples.unwrap_or_else(|error| panic!("{error:?} {found:?}")), &rows);
            assert!(distance < 0.01 && late < 1e-6, "{name}: {distance} m, {late} s: {found:?}");
            assert!(doubts_of(&found, "hhmmss"), "{found:?}");
        }
    }
    // Within a minute a name may say it; otherwise nothing does.
    let text = |name: &str, begin: f64| {
        table(&format!("{name},lat,lon,alt"), &rows[..200], |_, row| {
            format!("{},{}", face(begin + row[0]), place(row))
        })
    };
    let (found, samples) = look(&text("UTC time", 33240.0));
    assert!(errors(&samples.unwrap(), &rows[..200]).1 < 1e-6 && found.text.contains("hms"), "{found:?}");
    let found = assert_asks(
        &text("time", 33240.0),
        "time = \"time\"\ntime_format = \"hms\"  # begins at 091400.00, 5 Hz",
    );
    assert!(
        found.questions[0].answers.iter().any(|answer| answer.starts_with("time = \"time\"  # 5 Hz")),
        "{found:?}"
    );
    // Seconds of a week and a day have other digits.
    for begin in [345_600.0, 86_380.0, 0.0] {
        let text = table("time,lat,lon,alt", &rows, |_, row| format!("{:.2},{}", begin + row[0], place(row)));
        let (found, samples) = look(&text);
        assert!(
            errors(&samples.unwrap(), &rows).1 < 1e-6 && !found.text.contains("hms"),
            "{begin}: {found:?}"
        );
    }
}

/// Dates and times of the clock that are one number, and milliseconds without a point.
#[test]
fn clocks_that_are_one_number_are_read() {
    let rows = flight(47.3, 8.4);
    let milliseconds =
        |second: f64| format!("{:09.0}", (face(second).parse::<f64>().unwrap() * 1000.0).round());
    for (name, cell) in [
        ("timestamp", &(|t: f64| format!("20260314{}", face(33_294.0 + t))) as &dyn Fn(f64) -> String),
        ("time", &|t| format!("260314{}", face(33_294.0 + t))),
        ("utc", &|t| format!("20260314T{}Z", face(33_294.0 + t))),
        ("time", &|t| milliseconds(33_294.0 + t)),
        ("time", &|t| milliseconds(43_190.0 + t)),
        ("time", &|t| milliseconds(33_294.0 + t).trim_start_matches('0').to_owned()),
    ] {
        let text =
            table(&format!("{name},lat,lon,alt"), &rows, |_, row| format!("{},{}", cell(row[0]), place(row)));
        let (found, samples) = look(&text);
        let (distance, late) = errors(&samples.unwrap_or_else(|error| panic!("{error:?} {found:?}")), &rows);
        assert!(distance < 0.01 && late < 1e-6, "{}: {distance} m, {late} s: {found:?}", cell(0.0));
    }
    // Counters in nanoseconds and milliseconds have other digits.
    for (size, begin) in [(1e9, 2.1e13), (1e3, 1.2003e8), (1e6, 3.1e11)] {
        let text =
            table("time,lat,lon,alt", &rows, |_, row| format!("{:.0},{}", begin + size * row[0], place(row)));
        let (found, samples) = look(&text);
        assert!(errors(&samples.unwrap(), &rows).1 < 1e-6, "{size}: {found:?}");
    }
}

/// Minutes, hours, and days, as of a spreadsheet: with a unit, by the speed, or asked about.
#[test]
fn minutes_hours_and_days_are_no_seconds() {
    let rows = flight(47.3, 8.4);
    for (unit, size, begin) in [("min", 60.0, 3.0), ("h", 3600.0, 9.5), ("d", 86400.0, 46_354.4)] {
        let text = |names: &str, end: &str| {
            table(names, &rows, |_, row| format!("{:.9},{}{end}", begin + row[0] / size, place(row)))
        };
        let found =
            assert_asks(&text("time,lat,lon,alt", ""), &format!("unit = \"{unit}\" }}  # 5 Hz, 40.0 m/s"));
        assert!(found.questions[0].sentence.contains("no usual unit"), "{found:?}");
        for (names, end) in [
            (format!("time [{unit}],lat,lon,alt"), ""),
            ("time,lat,lon,alt,speed (m/s)".to_owned(), ",40"),
            (format!("time,lat,lon,alt,roll,speed\n{unit},deg,deg,m,deg,m/s"), ",0,40"),
        ] {
            let (found, samples) = look(&text(&names, end));
            let (distance, late) =
                errors(&samples.unwrap_or_else(|error| panic!("{error:?} {found:?}")), &rows);
            assert!(distance < 0.01 && late < 1e-3, "{names}: {distance} m, {late} s: {found:?}");
        }
    }
}

/// A buoy drifts at 0.2 m/s in seconds, not at 200 m/s in milliseconds; where both may be, it is asked.
#[test]
fn slow_vehicles_are_no_fast_ones_in_milliseconds() {
    let slow: Vec<Row> = flight(47.3, 8.4)
        .iter()
        .map(|row| [row[0] * 200.0, row[1], row[2], row[3], row[4] / 200.0, row[5]])
        .collect();
    let text =
        |size: f64| table("time,lat,lon,alt", &slow, |_, row| format!("{:.3},{}", row[0] * size, place(row)));
    assert_asks(&text(1.0), "time = { col = \"time\", unit = \"ms\" }  # 25 Hz, 200.0 m/s");
    let often: Vec<Row> =
        slow.iter().map(|row| [row[0] / 40.0, row[1], row[2], row[3], row[4], row[5]]).collect();
    let near =
        |row: &Row| format!("{:.9},{:.9},0", 47.3 + (row[1] - 47.3) / 40.0, 8.4 + (row[2] - 8.4) / 40.0);
    let text = table("time,lat,lon,alt", &often, |_, row| format!("{:.0},{}", row[0], near(row)));
    let (found, samples) = look(&text);
    let samples = samples.unwrap_or_else(|error| panic!("{error:?} {found:?}"));
    assert_eq!(samples[samples.len() - 1].time_s, 299.0, "{found:?}");
}

/// A line of units states one that is not understood: the column is not read in the usual one.
#[test]
fn stated_units_that_are_not_understood_are_asked_about() {
    let rows = flight(47.3, 8.4);
    let cells = |_: usize, row: &Row| format!("{:.1},{},1,2,30,40,{:.1}", row[0], place(row), row[5]);
    let of =
        |line: &str| table(&format!("time,lat,lon,alt,roll,pitch,yaw,speed,course\n{line}"), &rows, cells);
    for (line, words) in [
        ("0.1 s,deg,deg,m,deg,deg,deg,m/s,deg", "time is in 0.1 s, which is not understood"),
        ("s,deg,deg W,m,deg,deg,deg,m/s,deg", "longitude = { col = \"lon\", sign = -1 }"),
        ("s,°S,°,m,deg,deg,deg,m/s,deg", "latitude = { col = \"lat\", sign = -1 }"),
        ("s,deg,deg,FL,deg,deg,deg,m/s,deg", "height = { col = \"alt\", scale = 30.48 }"),
        ("s,deg,deg,ft x 100,deg,deg,deg,m/s,deg", "alt is in ft x 100"),
        ("s,deg,deg,ft AGL,deg,deg,deg,m/s,deg", "alt is in ft AGL"),
        ("s,deg,deg,m,deg left,deg,deg,m/s,deg", "roll is in deg left"),
        ("s,deg,deg,m,0.01deg,deg,deg,m/s,deg", "attitude = \"coordinated\""),
    ] {
        let found = assert_asks(&of(line), words);
        assert!(!words.starts_with("alt is") || !doubts_of(&found, "nothing states its unit"), "{found:?}");
    }
    for line in [
        "s,deg,deg,m,deg,deg,deg,m/s,deg",
        "s,°,°,m (MSL),°,°,° true,m/s,deg",
        "sec,,,meters,degrees,degrees,,,",
    ] {
        let (found, samples) = look(&of(line));
        assert!(samples.is_ok() && found.questions.is_empty(), "{line}: {found:?}");
    }
}

/// A temperature T is no time where another column is.
#[test]
fn a_temperature_is_no_time() {
    let rows = flight(47.3, 8.4);
    for name in ["T", "T (°C)", "t [degC]"] {
        let text = table(&format!("{name},Timestamp,lat,lon,alt"), &rows, |index, row| {
            format!("{:.2},{:.1},{}", 12.0 + 0.01 * index as f64, row[0], place(row))
        });
        let (found, samples) = look(&text);
        assert!(errors(&samples.unwrap(), &rows).1 < 1e-6, "{name}: {found:?}");
    }
}

#[test]
fn a_stopwatch_is_told_from_hours_and_minutes_by_the_speed_or_asked_about() {
    let rows = flight(47.3, 8.4);
    let shown = |time: f64| format!("{:02}:{:02}", (time / 60.0) as u32, (time % 60.0).round() as u32);
    // A row each second, and a row each minute.
    let seconds: Vec<Row> = rows.iter().copied().step_by(5).collect();
    let minutes: Vec<Row> =
        rows.iter().map(|row| [row[0] * 300.0, row[1], row[2], row[3], row[4] / 300.0, row[5]]).collect();
    for (rows, size, format) in [(&seconds, 1.0, "mmss"), (&minutes, 60.0, "hms")] {
        let text =
            table("elapsed,lat,lon,alt", rows, |_, row| format!("{},{}", shown(row[0] / size), place(row)));
        for answer in ["\"mmss\"  # begins at 00:00, 1 Hz", "\"hms\"  # begins at 00:00, 0.01667 Hz"] {
            assert_asks(&text, answer);
        }
        let text = table("elapsed,lat,lon,alt,speed (m/s)", rows, |_, row| {
            format!("{},{},{:.4}", shown(row[0] / size), place(row), row[4])
        });
        let (found, samples) = look(&text);
        assert!(found.text.contains(&format!("time_format = \"{format}\"")), "{found:?}");
        assert!(errors(&samples.unwrap(), rows).1 < 1e-6, "{found:?}");
    }
    // Seconds with decimals, and hours before the minutes, are sure.
    for cell in [
        (|time| format!("{:02}:{:04.1}", 7 + (time / 60.0) as u32, time % 60.0)) as fn(f64) -> String,
        |time| format!("1:{:02}:{:04.1}", (time / 60.0) as u32, time % 60.0),
    ] {
        let text = table("elapsed,lat,lon,alt", &rows, |_, row| format!("{},{}", cell(row[0]), place(row)));
        let (found, samples) = look(&text);
        assert!(errors(&samples.unwrap(), &rows).1 < 1e-6, "{found:?}");
    }
}

#[test]
fn dates_that_contradict_the_speed_are_asked_about() {
    let rows: Vec<Row> = flight(47.3, 8.4).into_iter().step_by(10).collect();
    for (step, is_asked) in [(2, false), (120, true)] {
        let text = table("Date,lat,lon,alt,speed (m/s)", &rows, |index, row| {
            let second = index * step;
            let time = format!("{:02}:{:02}:{:02} UTC", 9 + second / 3600, second / 60 % 60, second % 60);
            format!("2026-05-03 {time},{},{}", place(row), row[4])
        });
        if is_asked {
            assert_asks(&text, "has no unit with which the positions have the speed");
        } else {
            assert!(errors(&look(&text).1.unwrap(), &rows).1 < 1e-6);
        }
    }
    // Stamps of whole seconds at 5 Hz are no contradiction.
    let rows = flight(47.3, 8.4);
    let text = table("Date,lat,lon,alt,speed (m/s)", &rows, |_, row| {
        format!("2026-05-03 09:00:{:02},{},{}", row[0] as u32, place(row), row[4])
    });
    assert!(look(&text).0.questions.is_empty());
}

/// Noise of 1 mm at rest is a speed of metres per second in milliseconds.
#[test]
fn noise_at_rest_is_no_speed() {
    let mut seed = 1_u32;
    let mut noise = |sigma: f64| {
        let mut part = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed) / 4_294_967_296.0 - 0.5
        };
        sigma * (part() + part() + part() + part())
    };
    for (rate, unit) in [(5.0, 1.0), (1.0, 1.0), (100.0, 1.0), (5.0, 1e3)] {
        for velocity in [false, true] {
            let names = if velocity { ",ve (m/s),vn (m/s),vu (m/s)" } else { "" };
            let mut text = format!("time,lat,lon,alt (m){names}\n");
            for index in 0..1500 {
                let time = f64::from(index) / rate * unit;
                text += &format!("{time},{:.10},{:.10},500", 47.0 + noise(2e-8), 8.0 + noise(2e-8));
                text += &if velocity {
                    format!(",{:.4},{:.4},0\n", noise(0.02), noise(0.02))
                } else {
                    "\n".into()
                };
            }
            let (found, samples) = look(&text);
            let samples = samples.unwrap_or_else(|error| panic!("{error:?} {found:?}"));
            let duration = samples[samples.len() - 1].time_s - samples[0].time_s;
            assert!((duration - 1499.0 / rate).abs() < 1e-6, "{rate} Hz: {duration} s: {found:?}");
        }
    }
}

#[test]
fn an_answer_about_the_time_of_slow_rows_smooths_them() {
    let rows = flight(47.3, 8.4);
    for (step, is_slow) in [(0.2, true), (0.02, false)] {
        let text = table("Moment,lat,lon,alt,roll (deg),pitch (deg),yaw (deg)", &rows, |index, row| {
            format!("{:.2},{},0,0,{}", index as f64 * step, place(row), row[5])
        });
        let found = assert_asks(&text, "time = \"Moment\"");
        let answer = found.questions[0].answers.iter().find(|answer| answer.starts_with("time = \"Moment\""));
        assert_eq!(answer.unwrap().ends_with("\nsmooth = \"auto\""), is_slow, "{found:?}");
        assert!(!found.text.contains("smooth"), "{found:?}");
    }
}

/// Counts of tenths of seconds and of tenths of microseconds are asked about: in s, ms, us and ns they are of no clock. Seconds since the
/// year 0 and 1970, and since a start, are of one.
#[test]
fn counts_of_no_clock_are_asked_about() {
    let rows = flight(47.3, 8.4);
    let of = |begin: f64, count: f64| {
        table("timestamp,lat,lon,alt (m)", &rows[..200], |_, row| {
            format!("{:.0},{}", begin + count * row[0].round(), place(row))
        })
    };
    // Rows of one second.
    let rows_1hz = |text: String| {
        let lines: Vec<&str> = text.lines().collect();
        lines
            .iter()
            .take(1)
            .chain(lines.iter().skip(1).step_by(5))
            .map(|line| format!("{line}\n"))
            .collect::<String>()
    };
    for (begin, count, answer) in [(1.77e10, 10.0, "scale = 0.1"), (1.34178e17, 1e7, "scale = 1e-7")] {
        assert_asks(&rows_1hz(of(begin, count)), answer);
    }
    for (begin, count) in [(0.0, 1.0), (1.77e9, 1.0), (1.77e12, 1e3), (1.77e15, 1e6), (6.39e10, 1.0)] {
        let (found, samples) = look(&rows_1hz(of(begin, count)));
        assert!(found.questions.is_empty(), "{begin}: {found:?}");
        let samples = samples.unwrap();
        assert!((samples[samples.len() - 1].time_s - samples[0].time_s - 39.0).abs() < 1e-6, "{begin}");
    }
}
