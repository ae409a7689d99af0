//! Flight records in IGC and GPX: read, said what was assumed, and flown.

use std::fmt::Write;
use std::path::Path;
use std::process::Stdio;

use crate::support::{done, folder, number, read, rejected, result, rows, run, sins};

/// The commands that fly a log, each without the log.
const DOORS: [&[&str]; 6] = [
    &["scene", "check"],
    &["fly", "-q", "--preset", "navigation"],
    &["ensemble", "-q", "--runs", "2", "--preset", "navigation"],
    &["recommend", "--position", "1000"],
    &["budget", "--preset", "navigation"],
    &["curve"],
];

/// A point of a path: time of day [s], latitude, longitude [deg], height [m].
type Point = [f64; 4];

/// A circle of 25 m/s and 24 s, which drifts at 5 m/s to the east and climbs at 1.7 m/s: a glider in a thermal, over midnight.
fn thermal(rate_hz: u32, seconds: u32) -> Vec<Point> {
    let (speed, turn) = (25.0, std::f64::consts::TAU / 24.0);
    let point = |k: u32| {
        let t = f64::from(k) / f64::from(rate_hz);
        let (sine, cosine) = (turn * t).sin_cos();
        let (east, north) = (speed / turn * (1.0 - cosine) + 5.0 * t, speed / turn * sine);
        let latitude = -33.5 + (north / 6_354_900.0).to_degrees();
        let longitude = -70.6 + (east / (6_384_600.0 * 33.5_f64.to_radians().cos())).to_degrees();
        [86_280.0 + t, latitude, longitude, 1000.0 + 1.7 * t]
    };
    (0..=rate_hz * seconds).map(point).collect()
}

/// A B record; a height of 0 stands for none.
fn fix([time, latitude, longitude, _]: Point, validity: char, pressure: i32, gnss: i32) -> String {
    let seconds = time as u32 % 86_400;
    let angle = |angle: f64, width: usize, [positive, negative]: [char; 2]| {
        let thousandths = (angle.abs() * 60_000.0).round() as u32;
        let side = if angle < 0.0 { negative } else { positive };
        format!("{:0width$}{:05}{side}", thousandths / 60_000, thousandths % 60_000)
    };
    format!(
        "B{:02}{:02}{:02}{}{}{validity}{pressure:05}{gnss:05}",
        seconds / 3600,
        seconds / 60 % 60,
        seconds % 60,
        angle(latitude, 2, ['N', 'S']),
        angle(longitude, 3, ['E', 'W'])
    )
}

/// The path as an IGC record, with the pressure altitude 60 m below.
fn igc(points: &[Point]) -> String {
    let mut text = "AXXX001\r\nHFDTE250726\r\nI013638FXA\r\n".to_owned();
    for point in points {
        let height = point[3].round() as i32;
        write!(text, "{}012\r\n", fix(*point, 'A', height - 60, height)).unwrap();
    }
    text
}

/// The path as a GPX track, with the elements of each point on lines of their own.
fn gpx(points: &[Point]) -> String {
    let points: String = points
        .iter()
        .map(|[time, latitude, longitude, height]| {
            let (day, seconds) = (25 + *time as u32 / 86_400, *time as u32 % 86_400);
            let (hours, minutes, seconds) = (seconds / 3600, seconds / 60 % 60, seconds % 60);
            format!(
                "<trkpt lat=\"{latitude:.7}\" lon=\"{longitude:.7}\">\n<ele>{height:.1}</ele>\n\
                <time>2026-07-{day}T{hours:02}:{minutes:02}:{seconds:02}Z</time>\n\
                <extensions><ele>9</ele><time>none</time></extensions></trkpt>\n"
            )
        })
        .collect();
    format!(
        "<?xml version=\"1.0\"?>\n<gpx version=\"1.1\"><trk><name>A &amp; B</name><trkseg>\n{points}</trkseg></trk></gpx>\n"
    )
}

/// The rows of the smoothed path: time [s], latitude, longitude [deg], height [m].
fn smoothed(folder: &Path, file: &str, more: &[&str]) -> (String, Vec<Point>) {
    let (code, said, errors) =
        run(folder, &[&["log", file, "--smooth", "-o", "truth.csv", "--force"], more].concat());
    assert!(code == 0 && said.starts_with("\nwritten\n  truth.csv "), "{said}{errors}");
    let text = read(folder.join("truth.csv"));
    let row = |line: &str| {
        let values: Vec<f64> = line.split(',').map(|field| field.parse().unwrap()).collect();
        [values[0], values[1], values[2], values[3]]
    };
    (errors, text.lines().skip(2).map(row).collect())
}

/// The largest horizontal and vertical distance from the thermal [m], without the 20 s at each end, where a path is stiffer.
fn off_thermal(path: &[Point]) -> [f64; 2] {
    let truth = thermal(50, 240);
    let mut largest = [0.0_f64; 2];
    for point in path {
        let at = ((point[0] - truth[0][0]) * 50.0).round() as usize;
        if !(1000..11_000).contains(&at) {
            continue;
        }
        let north = (point[1] - truth[at][1]) * 110_900.0;
        let east = (point[2] - truth[at][2]) * 111_400.0 * 33.5_f64.to_radians().cos();
        largest = [largest[0].max(north.hypot(east)), largest[1].max((point[3] - truth[at][3]).abs())];
    }
    largest
}

/// The point of a path at a time [s].
fn at(path: &[Point], time_s: f64) -> Point {
    *path.iter().min_by(|a, b| (a[0] - time_s).abs().total_cmp(&(b[0] - time_s).abs())).unwrap()
}

/// Whether a path at 50 Hz begins at `start_s` [s] or, as it needs rows on both sides, up to 3 s later, and lasts until `end_s`.
fn is_whole(path: &[Point], start_s: f64, end_s: f64) -> bool {
    let (first_s, last_s) = (path[0][0], path[path.len() - 1][0]);
    let count = ((end_s - first_s) * 50.0).round() as usize + 1;
    (start_s..=start_s + 3.0).contains(&first_s) && last_s == end_s && path.len() == count
}

/// A glider in a thermal: its smoothed path stays within the resolution of IGC, 0.001 minutes or 1.86 m and a metre of height.
#[test]
fn a_thermal_stays_within_the_resolution() {
    let folder = folder("thermal");
    let points = thermal(1, 240);
    let (limits_m, mut largest_m) = ([1.86, 1.0], [0.0_f64; 2]);
    for (file, text) in [("flight.igc", igc(&points)), ("flight.gpx", gpx(&points))] {
        std::fs::write(folder.join(file), text).unwrap();
        let (errors, path) = smoothed(&folder, file, &[]);
        let [horizontal, vertical] = off_thermal(&path);
        println!("{file}: {horizontal:.3} m, {vertical:.3} m\n{errors}");
        let is_near = horizontal < limits_m[0] && vertical < limits_m[1];
        let is_whole = is_whole(&path, points[0][0], points[240][0]);
        assert!(is_whole && is_near, "{file}: {horizontal} {vertical}");
        largest_m = [largest_m[0].max(horizontal), largest_m[1].max(vertical)];
        for door in DOORS {
            let (code, _, errors) = run(&folder, &[door, &["--strict", file]].concat());
            assert!(code == 0 && errors.contains("241 "), "{door:?} {file}: {errors}");
            assert!(errors.contains("attitude: assumed, that of a coordinated flight"), "{door:?}: {errors}");
        }
        // 25 m/s at 15 deg/s and 5 m/s of drift: atan(v omega / g), from 28 to 39 degrees to the right.
        let middle = &rows(&folder.join("sins_out/flight.csv"))[600..700];
        for row in middle {
            let roll_deg = number(row, "truth_roll_rad").to_degrees();
            assert!((25.0..43.0).contains(&roll_deg), "{file}: {roll_deg}");
        }
    }
    // By a scene, from standard input, and by a name without an ending.
    std::fs::write(folder.join("scene.toml"), "[flight]\nfile = \"flight.igc\"\n").unwrap();
    std::fs::copy(folder.join("flight.igc"), folder.join("record")).unwrap();
    let flown = |order: &[&str]| assert_eq!(run(&folder, order).0, 0, "{order:?}");
    flown(&["fly", "-q", "flight.igc"]);
    flown(&["fly", "-q", "scene.toml"]);
    flown(&["fly", "-q", "record"]);
    flown(&["fly", "-q", "--log", "record", "--name", "named"]);
    let input = std::fs::File::open(folder.join("record")).unwrap();
    let output = sins(&folder, &["fly", "-q", "-"]).stdin(Stdio::from(input)).output().unwrap();
    assert_eq!(result(&output).0, 0);
    let records = |name: &str| read(folder.join(format!("sins_out/{name}.csv")));
    for name in ["scene", "record", "named", "log"] {
        assert!(records(name) == records("flight"), "{name}");
    }
    let ([horizontal, vertical], [limit_m, limit_of_height_m]) = (largest_m, limits_m);
    println!(
        "figure: {horizontal:.2} m (limit {limit_m} m), heights {vertical:.2} m (limit {limit_of_height_m} m), \
        through {} commands; what was assumed is said",
        DOORS.len()
    );
}

/// Fixes without a position are left out, missing heights of GNSS follow the pressure altitude, and the keys of the user come first.
#[test]
fn an_igc_record_is_read() {
    let folder = folder("igc");
    let points = thermal(1, 240);
    let mut text = "AXXX001\r\nHFDTE250726\r\nLXXX a comment in Latin 1: \r\n".to_owned();
    for (k, point) in points.iter().enumerate() {
        let height = point[3].round() as i32;
        let (validity, gnss) =
            (if k < 5 { 'V' } else { 'A' }, if (50..60).contains(&k) { 0 } else { height });
        write!(text, "{}\r\n", fix(*point, validity, height - 60, gnss)).unwrap();
    }
    let mut bytes = text.into_bytes();
    bytes[48] = 0xe9;
    std::fs::write(folder.join("flight.igc"), &bytes).unwrap();
    let said = done(&folder, &["log", "flight.igc"]);
    assert!(said.starts_with("flight.igc: 236 rows over 3.9 min, 1 Hz, without velocities\n"), "{said}");
    let note = "flight.igc: note: IGC record, 236 fixes 1 s apart: heights of GNSS, above the ellipsoid; \
        10 of them are 0 or missing: there the change of the pressure altitude continues them; left out: 5 without a position (V)\n";
    assert!(said.contains(note) && said.ends_with("nothing is doubtful\n"), "{said}");
    // No word about an attitude that the record does not have.
    assert!(!said.contains("roll") && !said.contains("heading") && !said.contains("nose"), "{said}");
    let (_, path) = smoothed(&folder, "flight.igc", &[]);
    assert!(is_whole(&path, 86_285.0, 86_520.0), "{:?}, {}", path[0], path.len());
    let [_, vertical] = off_thermal(&path);
    assert!(vertical < 1.0, "{vertical}");

    let height = |columns: &str| {
        std::fs::write(folder.join("columns.toml"), columns).unwrap();
        smoothed(&folder, "flight.igc", &["--columns", "columns.toml"]).1[6000][3]
    };
    let own = height("[log]\n");
    assert!((height("[log]\ngeoid = 38\n") - own - 38.0).abs() < 1e-6);
    assert!((height("[log]\nheight = \"pressure_height_m\"\n") - own + 60.0).abs() < 1e-6);
    let level = "[log]\nroll = 0\npitch = 0\nheading = 90\n";
    std::fs::write(folder.join("columns.toml"), level).unwrap();
    let (code, _, errors) =
        run(&folder, &["fly", "-q", "flight.igc", "--columns", "columns.toml", "--believe"]);
    assert!(code == 0 && !errors.contains("assumed"), "{errors}");
    assert!(errors.contains("doubtful: attitude stays the same"), "{errors}");
    for row in &rows(&folder.join("sins_out/flight.csv"))[100..200] {
        assert!(number(row, "truth_roll_rad").abs() < 1e-9, "{row:?}");
    }
    // The record says what its heights are above; the text may be in UTF-16.
    let text = String::from_utf8_lossy(&bytes).replacen("LXXX", "HFALGALTGPS:GEO\r\nLXXX", 1);
    let units = text.encode_utf16().flat_map(u16::to_le_bytes);
    std::fs::write(folder.join("wide.igc"), [0xff, 0xfe].into_iter().chain(units).collect::<Vec<u8>>())
        .unwrap();
    let said = done(&folder, &["log", "wide.igc"]);
    assert!(said.contains("heights of GNSS, above the geoid, as the record says: set log.geoid"), "{said}");
    let errors = rejected(&folder, &["log", "flight.igc", "--map", "map.toml"]);
    assert_eq!(errors, "flight.igc: is a flight record, which flies without --map\n");

    // Heights of GNSS that no fix has, also as blanks.
    for gnss in ["00000", "     ", "-----"] {
        let text: String = points.iter().fold("AXXX\nHFDTE250726\n".to_owned(), |text, point| {
            text + &fix(*point, 'A', -40, 0)[..30] + gnss + "\n"
        });
        std::fs::write(folder.join("low.igc"), text).unwrap();
        let (errors, path) = smoothed(&folder, "low.igc", &[]);
        assert!((path[6000][3] + 40.0).abs() < 1e-6, "{:?}", path[6000]);
        let note = "pressure altitudes as heights, because those of GNSS are 0 or missing\n";
        assert!(errors.contains(note), "{errors}");
    }
}

/// Positions in all four quarters of the Earth, to the last digit.
#[test]
fn each_hemisphere_has_its_sign() {
    let folder = folder("hemispheres");
    for (latitude, longitude) in [(48.5, 11.25), (48.5, -123.25), (-33.5, 151.25), (-33.5, -70.25)] {
        let step = 1.0 / 60_000.0;
        let points: Vec<Point> = (0..60)
            .map(|t| [36_000.0 + f64::from(t), latitude + 20.0 * step * f64::from(t), longitude, 500.0])
            .collect();
        std::fs::write(folder.join("north.igc"), igc(&points)).unwrap();
        let (_, path) = smoothed(&folder, "north.igc", &[]);
        for k in [3, 30, 59] {
            let [_, found_latitude, found_longitude, _] = at(&path, points[k][0]);
            // Numbers of the format, on a straight line: smoothing keeps them.
            assert!((found_latitude - points[k][1]).abs() < 1e-2 * step, "{k}: {found_latitude}");
            assert!((found_longitude - longitude).abs() < 1e-2 * step, "{k}: {found_longitude}");
        }
    }
}

/// Digits of the position and of the seconds beyond those of the format, at the columns that the I record names.
#[test]
fn an_igc_record_may_have_further_digits() {
    let folder = folder("digits");
    let mut text = "AXXX\r\nHFDTE250726\r\nI043638FXA3939LOD4041LAD4242TDS\r\n".to_owned();
    for k in 0..120 {
        let point = [36_000.0 + f64::from(k / 2), 48.5, -11.5, 500.0];
        let fixed = fix(point, 'A', 440, 500).replace("4830000", &format!("4830{:03}", k * 5));
        write!(text, "{fixed}012725{}\r\n", k % 2 * 5).unwrap();
    }
    std::fs::write(folder.join("fine.igc"), text).unwrap();
    let said = done(&folder, &["log", "fine.igc"]);
    assert!(said.contains("fine.igc: 120 rows over 59.5 s, 2 Hz"), "{said}");
    let (_, path) = smoothed(&folder, "fine.igc", &[]);
    let [time, latitude, longitude, _] = at(&path, 36_030.0);
    assert_eq!(time, 36_030.0);
    assert!((latitude - 48.5 - 300.25 / 60_000.0).abs() < 1e-9, "{latitude}");
    assert!((longitude + 11.5 + 0.7 / 60_000.0).abs() < 1e-9, "{longitude}");
}

/// Segments and tracks are joined; points without a time, without `ele` or with the stamp before are left out.
#[test]
fn a_gpx_track_is_read() {
    let folder = folder("gpx");
    let points = thermal(1, 240);
    let whole = gpx(&points);
    let split = |at: usize, between: &str| {
        let (place, _) = whole.match_indices("<trkpt").nth(at).unwrap();
        format!("{}{between}{}", &whole[..place], &whole[place..])
    };
    let look = |text: &str, expected: &[&str]| {
        std::fs::write(folder.join("flight.gpx"), text).unwrap();
        let said = done(&folder, &["log", "flight.gpx"]);
        for expected in expected {
            assert!(said.contains(expected), "{expected}: {said}");
        }
    };
    let sea = "ele is taken as the height above the sea, and the geoid as 0 m unless log.geoid sets it";
    look(
        &split(100, "</trkseg><trkseg>"),
        &["flight.gpx: 241 rows over 4 min, 1 Hz", "GPX track, 241 points 1 s apart in 2 segments: ", sea],
    );
    look(&split(100, "</trkseg></trk>\n<trk><trkseg/><trkseg>"), &["241 points 1 s apart in 2 segments: "]);
    // All on a single line, with a prefix of names, and in GPX 1.0.
    let prefixed = whole.replace('\n', "").replace("<", "<g:").replace("<g:/", "</g:").replace("<g:?", "<?");
    let prefixed = prefixed
        .replace("<g:g:", "<g:")
        .replace("<g:gpx version=\"1.1\"", "<gpx xmlns:g=\"g\" version=\"1.0\"");
    look(&prefixed.replace("</g:gpx>", "</gpx>"), &["241 points 1 s apart in 1 segment: "]);
    let doubled = "<trkpt lat=\"-33.5\" lon=\"-70.6\"><ele>7</ele><time>2026-07-25T23:59:39Z</time></trkpt>\
        <trkpt lat=\"-33.5\" lon=\"-70.6\"><ele>7</ele></trkpt><trkpt lat=\"-33.5\" lon=\"-70.6\"/>\
        <trkpt lat=\"-33.5\" lon=\"-70.6\"><time>2026-07-25T23:59:39.5Z</time></trkpt>";
    look(
        &split(100, doubled),
        &[
            "flight.gpx: 241 rows",
            "left out: 2 without time, 1 without ele",
            "note: 1 time stamp: not later than the one before, first at 86379 s (these rows are left out)\n",
        ],
    );
    assert!(is_whole(&smoothed(&folder, "flight.gpx", &[]).1, 86_280.0, 86_520.0));
    // An offset from UTC, and a gap.
    let late = "</trkseg><trkseg><trkpt lat=\"-33.5\" lon=\"-70.6\"><ele>1500</ele><time>2026-07-26T02:03:00+02:00</time></trkpt>";
    look(
        &whole.replace("</trkseg>", &format!("{late}</trkseg>")),
        &["242 points 1 to 60 s apart in 2 segments"],
    );

    let flat: String =
        whole.lines().filter(|line| !line.starts_with("<ele>")).map(|line| format!("{line}\n")).collect();
    look(&flat, &["without ele; the height is 0 unless log.height sets it"]);
    for (set, height) in [("log.height=500", 500.0), ("log.geoid=38", 38.0)] {
        assert_eq!(run(&folder, &["fly", "-q", "flight.gpx", "--set", set]).0, 0);
        let row = &rows(&folder.join("sins_out/flight.csv"))[100];
        assert!((number(row, "truth_height_m") - height).abs() < 1e-6, "{row:?}");
    }
}

/// A B record that is cut at any place, in the middle or at the end, is left out, and is said; a file of cut records is rejected.
#[test]
fn a_cut_record_is_left_out() {
    let folder = folder("cut");
    let whole = igc(&thermal(1, 240));
    let lines: Vec<&str> = whole.split_inclusive('\n').collect();
    let rows_of = |said: &str| {
        said.split(" rows over").next().and_then(|text| text.rsplit(' ').next()?.parse::<usize>().ok())
    };
    let rows = lines.iter().filter(|line| line.starts_with('B')).count();
    for at in [10, 100, lines.len() - 1] {
        for length in [1, 9, 20, 24, 34] {
            let mut cut = lines.clone();
            let short = format!("{}\r\n", &lines[at][..length]);
            // The last record ends with the file.
            cut[at] = if at + 1 == lines.len() { &lines[at][..length] } else { &short };
            std::fs::write(folder.join("flight.igc"), cut.concat()).unwrap();
            let said = done(&folder, &["log", "flight.igc"]);
            assert!(said.contains(&format!("left out: 1 cut before its end (line {})", at + 1)), "{said}");
            assert_eq!(rows_of(&said), Some(rows - 1), "{said}");
        }
    }
    let all: String =
        lines.iter().map(|line| line[..line.len().min(30)].trim_end().to_owned() + "\n").collect();
    std::fs::write(folder.join("all.igc"), all).unwrap();
    let errors = rejected(&folder, &["log", "all.igc"]);
    assert!(errors.contains("all.igc:4: B record: expected at least 35 characters, found 30"), "{errors}");
}

/// A broken record is answered with its line, what was expected, and what stands there.
#[test]
fn broken_records_are_rejected() {
    let folder = folder("broken");
    let point = [36_000.0, 48.5, 11.5, 500.0];
    let good = fix(point, 'A', 440, 500);
    let record = |line: &str| format!("AXXX\r\nHFDTE250726\r\n{good}\r\n{line}\r\n");
    let track = |points: &str| {
        format!(
            "<?xml version=\"1.0\"?>\n<gpx version=\"1.1\">\n<trk><trkseg>\n{points}\n</trkseg></trk></gpx>\n"
        )
    };
    let whole = gpx(&thermal(1, 20));
    let short = "1 samples: a flight has at least two\n";
    let cases: Vec<(&str, String, &str)> = vec![
        ("igc", record(&good[..20]), ":4: B record: expected at least 35 characters, found 20\n"),
        (
            "igc",
            record(&good.replace("N01130", "X01130")),
            ":4: B record: latitude: expected DDMMmmmN or DDMMmmmS, at most 90 degrees, found \"4830000X\"\n",
        ),
        ("igc", record(&good.replace("4830000", "4860000")), "found \"4860000N\"\n"),
        (
            "igc",
            record(&good.replace("01130000E", "18000001E")),
            ":4: B record: longitude: expected DDDMMmmmE or DDDMMmmmW, at most 180 degrees, found \"18000001E\"\n",
        ),
        (
            "igc",
            record(&good.replace("B1000", "B2500")),
            ":4: B record: time: expected HHMMSS, found \"250000\"\n",
        ),
        ("igc", record(&good.replace("EA", "EX")), ":4: B record: validity: expected A or V, found \"X\"\n"),
        (
            "igc",
            record(&good.replace("A00440", "A0x440")),
            ":4: B record: pressure altitude: expected five digits [m], found \"0x440\"\n",
        ),
        (
            "igc",
            record(&good.replace("00500", "005.0")),
            ":4: B record: GNSS altitude: expected five digits [m], found \"005.0\"\n",
        ),
        (
            "igc",
            record(&good.replace("00440", "00\u{e9}40")),
            ":4: B record: pressure altitude: expected five digits [m], found \"00\u{e9}4\"\n",
        ),
        ("igc", record(""), short),
        (
            "igc",
            record("").replace("EA", "EV"),
            ": no fix: expected B records with the validity A, found 1 with V\n",
        ),
        (
            "igc",
            "AXXX\nHFDTE250726\n".to_owned(),
            ": no fix: expected B records with the validity A, found 0 with V\n",
        ),
        ("gpx", track(""), ": no track: expected trkpt with lat, lon and time, found 0 without time\n"),
        (
            "gpx",
            track("<trkpt lat='1' lon='2'/>"),
            ": no track: expected trkpt with lat, lon and time, found 1 without time\n",
        ),
        ("gpx", track("<trkpt lat='1' lon='2'><time>2026-07-25T00:00:00Z</time></trkpt>"), short),
        (
            "gpx",
            track("<trkpt lat='91' lon='2'/>"),
            ":4: trkpt: expected its lat, from -90 to 90 degrees, found \"91\"\n",
        ),
        (
            "gpx",
            track("<trkpt lat='1' lon='2,5'/>"),
            ":4: trkpt: expected its lon, from -180 to 180 degrees, found \"2,5\"\n",
        ),
        ("gpx", track("<trkpt lat='1'/>"), ":4: trkpt: expected its lon, from -180 to 180 degrees\n"),
        ("gpx", track("<trkpt lat=1 lon='2'/>"), ":4: trkpt: expected XML: "),
        (
            "gpx",
            track("<trkpt lat='1' lon='2'>\n<time>today</time></trkpt>"),
            ":4: trkpt: time: expected a date and a time, as 2024-05-01T12:30:00Z, found \"today\"\n",
        ),
        (
            "gpx",
            track("<trkpt lat='1' lon='2'><ele>high</ele><time>2026-07-25T00:00:00Z</time></trkpt>"),
            ":4: trkpt: ele: expected a finite number [m], found \"high\"\n",
        ),
        ("gpx", track("<trkpt lat='1' lon='2'>"), ":5: expected XML: "),
        ("gpx", whole[..whole.len() - 7].to_owned(), ":87: expected </gpx>, found the end of the file\n"),
        (
            "gpx",
            whole[..whole.find("</time>").unwrap()].to_owned(),
            ":5: expected </time>, found the end of the file\n",
        ),
        ("gpx", whole[..whole.find("</time>").unwrap() + 4].to_owned(), ":5: expected XML: "),
    ];
    let count = cases.len();
    for (ending, text, expected) in cases {
        let file = format!("bad.{ending}");
        std::fs::write(folder.join(&file), &text).unwrap();
        for door in [&["log"][..], &["fly"], &["scene", "check"]] {
            let errors = rejected(&folder, &[door, &[&file]].concat());
            assert!(errors.starts_with(&file) && errors.contains(expected), "{door:?} {text}: {errors}");
        }
    }
    // No log of an IMU, no run, no instructions.
    std::fs::write(folder.join("flight.igc"), record("")).unwrap();
    std::fs::write(folder.join("flight.gpx"), track("")).unwrap();
    for (file, what) in
        [("flight.igc", "a flight record of a glider (IGC)"), ("flight.gpx", "a track of a receiver (GPX)")]
    {
        for door in [
            &["report", file][..],
            &["allan", file, "--rate", "1"],
            &["curve", "rest", "--instructions", file],
        ] {
            assert!(rejected(&folder, door).starts_with(&format!("{file}: is {what}")), "{door:?}");
        }
        let errors = rejected(&folder, &["live", file, "--from", "udp:0", "--rate-hz", "9"]);
        assert_eq!(errors, format!("{file}: is a flight log: expected a scene\n"));
    }
    println!("figure: {count} rejected with line");
}
