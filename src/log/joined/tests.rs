use super::*;
use crate::scene::Scene;

const KEYS: &str =
    "time = { col = \"TimeUS\", unit = \"us\" }\nlatitude = \"Lat\"\nlongitude = \"Lng\"\nheight = \"Alt\"\n";
const ATTITUDE_KEYS: &str = "roll = { col = \"Roll\", file = \"ATT.csv\" }\npitch = { col = \"Pitch\", file = \"ATT.csv\" }\n\
    heading = { col = \"Yaw\", file = \"ATT.csv\" }\n";

/// Positions at these times [s].
fn positions(times: impl IntoIterator<Item = f64>) -> String {
    let row = |t: f64| format!("{},48,11,300\n", t * 1e6);
    format!("TimeUS,Lat,Lng,Alt\n{}", times.into_iter().map(row).collect::<String>())
}

/// The log of files, the first of which is POS.csv, joined by lines of `[log]`, and its notes; or why not.
fn joined(files: &[(&str, String)], keys: &str) -> Result<(FlightLog, String), String> {
    let scene = Scene::parse(format!("[flight]\nfile = \"POS.csv\"\n[log]\n{keys}").as_bytes()).unwrap();
    let mut names = Vec::new();
    let read = |name: &str| {
        names.push(name.to_owned());
        let file = files.iter().find(|(known, _)| *known == name);
        file.map(|(_, text)| text.as_bytes().to_vec()).ok_or(format!("{name}: is not here"))
    };
    let log = FlightLog::parse_files(files[0].1.as_bytes(), &scene.log, read).map_err(|error| {
        let (name, error) = match error {
            FilesError::Unread(sentence) => return sentence,
            FilesError::Of(name, error) => (if name.is_empty() { "POS.csv".to_owned() } else { name }, error),
        };
        let LogError::Fault(Fault { line, sentence, .. }) = *error else { panic!("{error:?}") };
        if line > 0 { format!("{name}:{line}: {sentence}") } else { format!("{name}: {sentence}") }
    })?;
    assert_eq!(names, [files[1].0]);
    let notes: Vec<&str> = log.notes().iter().map(|note| note.sentence.as_str()).collect();
    let notes = notes.join("; ");
    Ok((log, notes))
}

fn degrees(sample: &FlightSample) -> [f64; 3] {
    [sample.euler.roll, sample.euler.pitch, sample.euler.heading].map(f64::to_degrees)
}

/// Rounding of angles [deg].
const NEAR_DEG: f64 = 1e-9;

/// Returns the largest error [deg].
fn assert_near(found: [f64; 3], expected: [f64; 3]) -> f64 {
    let mut largest_deg = 0.0_f64;
    for (found, expected) in found.into_iter().zip(expected) {
        let error = (found - expected + 180.0).rem_euclid(360.0) - 180.0;
        assert!(error.abs() < NEAR_DEG, "{found}, not {expected}");
        largest_deg = largest_deg.max(error.abs());
    }
    largest_deg
}

#[test]
fn angles_are_interpolated_on_the_circle() {
    let attitude = "TimeUS,Roll,Pitch,Yaw\n0,0,2,350\n200000,10,4,10\n400000,-170,4,350\n600000,170,4,350\n";
    let files = [("POS.csv", positions([0.0, 0.05, 0.1, 0.2, 0.3, 0.5])), ("ATT.csv", attitude.to_owned())];
    let (log, note) = joined(&files, &format!("{KEYS}{ATTITUDE_KEYS}")).unwrap();
    assert_eq!(note, "ATT.csv is interpolated onto the rows of the log");
    let expected = [[0.0, 2.0, 350.0], [2.5, 2.5, 355.0], [5.0, 3.0, 0.0], [10.0, 4.0, 10.0]];
    let mut largest_deg = assert_near(degrees(&log.samples()[5]), [180.0, 4.0, 350.0]);
    for (sample, expected) in log.samples().iter().zip(expected) {
        largest_deg = largest_deg.max(assert_near(degrees(sample), expected));
    }
    assert_eq!((log.line(0), log.line(5)), (Some(2), Some(7)));
    println!("figure: interpolated to {largest_deg:.1e} deg (limit {NEAR_DEG:e} deg), nothing held");
}

/// Two filters report 150 µs apart, the second with another attitude: the rows of the first are read, between which the usual interval is.
#[test]
fn of_several_filters_the_first_is_read() {
    let row = |t_us: f64, roll: f64| format!("{t_us},{roll},2,350\n");
    let both = |k: u32| row(1e5 * f64::from(k), 1.0) + &row(1e5 * f64::from(k) + 150.0, 40.0);
    let attitude = format!("TimeUS,Roll,Pitch,Yaw\n{}", (0..11).map(both).collect::<String>());
    let files = [("POS.csv", positions([0.05, 0.3, 0.75])), ("ATT.csv", attitude)];
    let (log, note) = joined(&files, &format!("{KEYS}{ATTITUDE_KEYS}")).unwrap();
    let without = "without 11 rows right behind the one before: those of another filter?";
    assert_eq!(note, format!("ATT.csv is interpolated onto the rows of the log, {without}"));
    assert_eq!(log.samples().len(), 3);
    for sample in log.samples() {
        assert_near(degrees(sample), [1.0, 2.0, 350.0]);
    }
}

#[test]
fn quaternions_are_interpolated_as_rotations() {
    let keys: String =
        (0..4).map(|k| format!("q{k} = {{ col = \"q[{k}]\", file = \"ATT.csv\" }}\n")).collect();
    // A yaw of 350 and of 370 degrees: the second one has the opposite sign.
    let row = |t: f64, yaw: f64| {
        let (sine, cosine) = (yaw.to_radians() / 2.0).sin_cos();
        format!("{},{cosine},0,0,{sine}\n", t * 1e6)
    };
    let attitude = format!("TimeUS,q[0],q[1],q[2],q[3]\n{}{}", row(0.0, 350.0), row(0.2, 10.0));
    let files = [("POS.csv", positions([0.0, 0.1, 0.2])), ("ATT.csv", attitude)];
    let (log, _) = joined(&files, &format!("{KEYS}{keys}")).unwrap();
    for (sample, yaw) in log.samples().iter().zip([350.0, 0.0, 10.0]) {
        assert_near(degrees(sample), [0.0, 0.0, yaw]);
    }
}

#[test]
fn velocities_and_heights_are_interpolated_linearly() {
    let keys = "height = { col = \"Alt\", file = \"XKF.csv\" }\neast = { col = \"VE\", unit = \"kt\", file = \"XKF.csv\" }\n\
        north = { col = \"VN\", unit = \"kt\", file = \"XKF.csv\" }\nup = { col = \"VD\", unit = \"kt\", sign = -1, file = \"XKF.csv\" }\n\
        roll = 1\npitch = 2\nheading = 3\n";
    // Two filters report at each time: the first is read.
    let other = "TimeUS,C,VN,VE,VD,Alt\n0,0,36,0,-3.6,100\n0,1,99,99,99,999\n1000000,0,72,18,-3.6,200\n1000000,1,99,99,99,999\n";
    let files = [("POS.csv", positions([0.25, 0.5])), ("XKF.csv", other.to_owned())];
    let (log, note) = joined(&files, &format!("{}{keys}", KEYS.replace("height = \"Alt\"\n", ""))).unwrap();
    assert!(
        note.contains(
            "XKF.csv:3: 2 time stamps: not later than the one before, first at 0 s (these rows are left out"
        ),
        "{note}"
    );
    let [first, second] = [0, 1].map(|row| log.samples()[row]);
    assert_eq!([first.place.height_m, second.place.height_m], [125.0, 150.0]);
    let knot = 1852.0 / 3600.0;
    for (found, expected) in second.v_n.unwrap().iter().zip([9.0 * knot, 54.0 * knot, 3.6 * knot]) {
        assert!((found - expected).abs() < 1e-12, "{found}, not {expected}");
    }
    assert_near(degrees(&first), [1.0, 2.0, 3.0]);
}

/// Nothing is extrapolated, held, or drawn across a gap.
#[test]
fn rows_without_values_are_left_out() {
    let rows: String =
        [0.2, 0.4, 0.6, 1.2, 1.4].map(|t: f64| format!("{},{t},0,90\n", (t * 1e6).round())).concat();
    let files = [
        ("POS.csv", positions((0..=20).map(|k| f64::from(k) / 10.0))),
        ("ATT.csv", format!("TimeUS,Roll,Pitch,Yaw\n{rows}")),
    ];
    let (log, note) = joined(&files, &format!("{KEYS}{ATTITUDE_KEYS}")).unwrap();
    let times: Vec<f64> = log.samples().iter().map(|sample| (sample.time_s * 10.0).round()).collect();
    assert_eq!(times, [2.0, 3.0, 4.0, 5.0, 6.0, 12.0, 13.0, 14.0]);
    assert_eq!(log.line(5), Some(14));
    let left_out = "left out: 8 outside of its times, 5 in its gaps of more than 0.5 s";
    assert!(note.ends_with(left_out), "{note}");
    for sample in log.samples() {
        assert!((sample.euler.roll.to_degrees() - sample.time_s).abs() < 1e-9, "{sample:?}");
    }
}

/// Times of day count from the midnight before the first row of each file.
#[test]
fn files_may_begin_on_two_sides_of_midnight() {
    let keys = format!("{KEYS}{ATTITUDE_KEYS}").replace("unit = \"us\"", "unit = \"s\"");
    let keys = format!("time_format = \"iso\"\n{keys}");
    let day = "2026-05-01T";
    let next = "2026-05-02T00:00:0";
    let files = [
        ("POS.csv", format!("TimeUS,Lat,Lng,Alt\n{next}0Z,48,11,300\n{next}1Z,48,11,300\n")),
        (
            "ATT.csv",
            format!("TimeUS,Roll,Pitch,Yaw\n{day}23:59:59Z,1,0,0\n{next}0.5Z,4,0,0\n{next}2Z,4,0,0\n"),
        ),
    ];
    let (log, _) = joined(&files, &keys).unwrap();
    assert_near(degrees(&log.samples()[0]), [3.0, 0.0, 0.0]);
}

#[test]
fn what_cannot_be_joined_is_refused() {
    let pos = ("POS.csv", positions([0.0, 0.1, 0.2]));
    let att = |rows: &str| ("ATT.csv", format!("TimeUS,Roll,Pitch,Yaw\n{rows}"));
    let all = format!("{KEYS}{ATTITUDE_KEYS}");
    let good = "0,0,0,0\n300000,0,0,0\n";
    let two = all.replace("\"Yaw\", file = \"ATT.csv\"", "\"Yaw\", file = \"XKF1.csv\"");
    let body = "forward = { col = \"u\", file = \"X.csv\" }\nright = { col = \"v\", file = \"X.csv\" }\ndown = { col = \"w\", file = \"X.csv\" }\n";
    for (files, keys, expected) in [
        (vec![pos.clone()], all.clone(), "ATT.csv: is not here"),
        (
            vec![pos.clone(), att("9000000,0,0,0\n9300000,0,0,0\n")],
            all.clone(),
            "POS.csv: 0 rows have values in all files: the times are from 0 to 0.2 s, those of ATT.csv from 9 to 9.3 s",
        ),
        (
            vec![pos.clone(), att("0,0,0,0\n300000,0,x,0\n")],
            all.clone(),
            "ATT.csv:3: Pitch: expected a finite number",
        ),
        (
            vec![pos.clone(), att(good)],
            all.replace("\"Yaw\"", "\"Hdg\""),
            "ATT.csv:1: log.heading: no column Hdg; ",
        ),
        (
            vec![pos.clone(), att(good)],
            two,
            "POS.csv: log.heading: the attitude must stand in one file, not in ATT.csv and XKF1.csv",
        ),
        (
            vec![pos.clone(), att(good)],
            format!("{all}{body}"),
            "POS.csv: log: this velocity needs the attitude or the variation",
        ),
        (
            vec![pos.clone(), att(good)],
            format!("time_format = \"row\"\nrate_hz = 10\n{all}"),
            "POS.csv: rows without times cannot be joined with ATT.csv",
        ),
    ] {
        let sentence = joined(&files, &keys).unwrap_err();
        assert!(sentence.starts_with(expected), "{sentence}, not {expected}");
    }
}
