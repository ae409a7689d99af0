//! Tables with other columns, units, signs, axes and times, read by `[log]`.

use sins::abi::*;
use sins::log::{FlightLog, LogError};
use sins::scene::Scene;
use sins::truth::FlightSample;

use crate::support::DEG;

/// The same three samples of a turning climb as a log of the library's own.
fn own() -> Vec<FlightSample> {
    let text = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg,\
                velocity_east_m_s,velocity_north_m_s,velocity_up_m_s,temperature_c\n\
                86399.5,47,8,609.6,10,5,30,50,86.60254037844386,3,20\n\
                86400,47.0004,8.0003,611.1,10,5,31,51.50380749100542,85.71673007021123,3,20\n\
                86400.5,47.0008,8.0006,612.6,10,5,32,52.99192642332049,84.8048096156426,3,20\n";
    FlightLog::parse(text.as_bytes()).unwrap().samples().to_vec()
}

fn scene(mapping: &str) -> Scene {
    let scene = format!("[flight]\nfile = \"a.csv\"\n[log]\n{mapping}\n");
    Scene::parse(scene.as_bytes()).unwrap_or_else(|faults| panic!("{mapping}: {faults:?}"))
}

fn read(mapping: &str, table: &str) -> FlightLog {
    match FlightLog::parse_with(table.as_bytes(), &scene(mapping).log) {
        Ok(log) => log,
        Err(error) => panic!("{mapping}\n{table}\n{error:?}"),
    }
}

fn fault(mapping: &str, table: &str) -> (usize, usize, String) {
    match FlightLog::parse_with(table.as_bytes(), &scene(mapping).log) {
        Err(LogError::Fault(fault)) => (fault.line, fault.column, fault.sentence),
        other => panic!("{other:?}"),
    }
}

/// The samples are those of [`own`] to a few roundings of their numbers.
fn assert_same(found: &[FlightSample], first_s: f64) {
    let expected = own();
    assert_eq!(found.len(), expected.len());
    let near = |found: f64, expected: f64, what: &str| {
        assert!(
            (found - expected).abs() <= 1e-14 * (1.0 + expected.abs()),
            "{what}: {found}, not {expected}"
        );
    };
    for (found, expected) in found.iter().zip(&expected) {
        near(found.time_s, expected.time_s - 86399.5 + first_s, "time");
        near(found.place.latitude_rad, expected.place.latitude_rad, "latitude");
        near(found.place.longitude_rad, expected.place.longitude_rad, "longitude");
        near(found.place.height_m, expected.place.height_m, "height");
        near(found.euler.roll, expected.euler.roll, "roll");
        near(found.euler.pitch, expected.euler.pitch, "pitch");
        near(found.euler.heading, expected.euler.heading, "heading");
        let (v, expected_v) = (found.v_n.unwrap(), expected.v_n.unwrap());
        for axis in 0..3 {
            // Sums of products of numbers of 86 m/s.
            assert!((v[axis] - expected_v[axis]).abs() < 8.0 * f64::EPSILON * 100.0, "{v} {expected_v}");
        }
        assert_eq!(found.temperature_c, expected.temperature_c);
    }
}

/// Feet, knots, a magnetic heading and track, another day, a constant temperature, a height above the sea, missing values.
#[test]
fn a_log_of_a_cockpit() {
    let mapping = "header = 3\ntime = \"Lcl Time\"\ntime_format = \"hms\"\nlatitude = \"Lat\"\nlongitude = \"Lon\"\n\
        height = { col = \"Alt\", unit = \"ft\" }\ngeoid = -15.24\nspeed = { col = \"GndSpd\", unit = \"kt\" }\ntrack = \"TRK\"\n\
        track_is = \"magnetic\"\nclimb = { col = \"VSpd\", unit = \"ft/min\" }\nroll = \"Roll\"\npitch = \"Pitch\"\nheading = \"HDG\"\n\
        variation = { value = -2 }\ntemperature = 20\nmissing = -999";
    let speed_kt = 100.0 * 3600.0 / 1852.0;
    let climb = 3.0 * 60.0 / 0.3048;
    let table = format!(
        "#airframe_info\n#hh:mm:ss, degrees\n  Lcl Time, Lat, Lon, Alt, GndSpd, TRK, VSpd, Roll, Pitch, HDG\n\
         23:59:58,,,,,,,,,\n23:59:59,47,8,2050,1,-999,1,1,1,1\n\
         23:59:59.5, 47, 8, 2050, {speed_kt}, 32, {climb}, 10, 5, 32\n\
         00:00:00, 47.0004, 8.0003, {}, {speed_kt}, 33, {climb}, 10, 5, 33\n\
         00:00:00.5, 47.0008, 8.0006, {}, {speed_kt}, 34, {climb}, 10, 5, 34\n",
        (611.1 + 15.24) / 0.3048,
        (612.6 + 15.24) / 0.3048
    );
    let log = read(mapping, &table);
    assert_same(log.samples(), 86399.5);
    let note = &log.notes()[0];
    let words = "2 rows are left out, the first here: a value is missing";
    assert_eq!((note.line, note.sentence.as_str(), log.notes().len()), (4, words, 1));
    // The first comment of another program is no title.
    assert_eq!((log.line(0), log.title.as_str()), (Some(6), ""));
}

/// Radians, ft/s, down, columns by number, blanks between, a quaternion of forward-right-down axes, dates.
#[test]
fn numbers_without_names() {
    let mapping = "header = 0\nseparator = \"blanks\"\ntime = { col = 1 }\ntime_format = \"iso\"\nlatitude = { col = 2, unit = \"rad\" }\n\
        longitude = { col = 3, unit = \"rad\" }\nheight = { col = 4, add = 100 }\nq0 = { col = 5 }\nq1 = { col = 6 }\nq2 = { col = 7 }\n\
        q3 = { col = 8 }\nnorth = { col = 9, unit = \"ft/s\" }\neast = { col = 10, unit = \"ft/s\" }\n\
        up = { col = 11, unit = \"ft/s\", sign = -1 }\ntemperature = { col = 12, scale = 0.5, add = 10 }";
    let times = ["2024-02-28T22:59:59.5Z", "2024-02-28T23:00:00Z", "2024-02-29T00:00:00.5+01:00"];
    let rows: Vec<String> = own()
        .iter()
        .zip(times)
        .map(|(sample, time)| {
            // Heading about down, then pitch about right, then roll about forward.
            let turns = [(sample.euler.heading, 2), (sample.euler.pitch, 1), (sample.euler.roll, 0)];
            let q = turns.iter().fold(nalgebra::UnitQuaternion::identity(), |q, (angle, axis)| {
                let axis = nalgebra::Unit::new_unchecked(nalgebra::Vector3::ith(*axis, 1.0));
                q * nalgebra::UnitQuaternion::from_axis_angle(&axis, *angle)
            });
            let (v, place) = (sample.v_n.unwrap() / 0.3048, sample.place);
            let numbers = [
                place.latitude_rad,
                place.longitude_rad,
                place.height_m - 100.0,
                q.w,
                q.i,
                q.j,
                q.k,
                v.y,
                v.x,
                -v.z,
                20.0,
            ];
            let numbers = numbers.map(|number| format!("{number:>24}"));
            format!("  {time}\t{}\n", numbers.join("  "))
        })
        .collect();
    assert_same(read(mapping, &rows.concat()).samples(), 82799.5);
}

/// Comments behind blanks, also where the first row of a table without names would stand.
#[test]
fn comments_behind_blanks_are_no_rows() {
    let mapping = "header = 0\ntime = { col = 1 }\nlatitude = { col = 2 }\nlongitude = { col = 3 }\nheight = { col = 4 }\n\
        roll = 0\npitch = 0\nheading = 0";
    let rows = ["0,48,11,300\n", "1,48,11,300\n"];
    let bare = read(mapping, &rows.concat());
    for place in 0..=2 {
        let mut lines = rows.to_vec();
        lines.insert(place, " \t# at rest, engine off\n");
        assert_eq!(read(mapping, &lines.concat()).samples(), bare.samples(), "{place}");
    }
}

/// Semicolons with decimal commas, milliseconds, a second line of names, body axes; what is not mapped has its own name.
#[test]
fn decimal_commas_and_velocities_of_the_body() {
    let mapping = "separator = \"semicolon\"\nskip = 1\ntime = { col = \"Time\", unit = \"ms\" }\nforward = \"u\"\nright = \"v\"\ndown = \"w\"";
    let header = "Time;latitude_deg;longitude_deg;height_m;roll_deg;pitch_deg;heading_deg;temperature_c;u;v;w\nms;deg;deg;m;deg;deg;deg;C;m/s;m/s;m/s\n";
    let rows: Vec<String> = own()
        .iter()
        .map(|sample| {
            // The rows of C = Rx(roll) Ry(pitch) Rz(heading), north-east-down to forward-right-down.
            let (v, e) = (sample.v_n.unwrap(), sample.euler);
            let [(sr, cr), (sp, cp), (sh, ch)] = [e.roll, e.pitch, e.heading].map(f64::sin_cos);
            let (n, east, d) = (v.y, v.x, -v.z);
            let along = ch * n + sh * east;
            let across = ch * east - sh * n;
            let (forward, below) = (cp * along - sp * d, sp * along + cp * d);
            let body = [forward, cr * across + sr * below, cr * below - sr * across];
            let [roll, pitch, heading] = [e.roll, e.pitch, e.heading].map(|angle| angle / DEG);
            let place = sample.place;
            let numbers = [
                sample.time_s * 1e3,
                place.latitude_rad / DEG,
                place.longitude_rad / DEG,
                place.height_m,
                roll,
                pitch,
                heading,
                20.0,
                body[0],
                body[1],
                body[2],
            ];
            numbers.map(|number| number.to_string().replace('.', ",")).join(";") + ";\n"
        })
        .collect();
    assert_same(read(mapping, &format!("{header}{}", rows.concat())).samples(), 86399.5);
}

#[test]
fn rows_without_times_have_a_rate() {
    let mapping = "time_format = \"row\"\nrate_hz = 50\nlatitude = \"a\"\nlongitude = \"b\"\nheight = 100\nroll = 0\npitch = 0\nheading = 0";
    let log = read(mapping, "a,b\n47,8\n,\n47,8\n47,8\n");
    let times: Vec<f64> = log.samples().iter().map(|sample| sample.time_s).collect();
    assert_eq!(times, [0.0, 0.04, 0.06]);
}

#[test]
fn a_fault_of_a_mapped_log_names_key_and_column() {
    let header = "T,Lat,Lon,Alt,roll_deg,pitch_deg,heading_deg,VN,VE,VD";
    let rows = "0,47,8,1,0,0,0,1,2,3\n1,47,8,1,0,0,0,1,2,3\n";
    let places = "time = \"T\"\nlatitude = \"Lat\"\nlongitude = \"Lon\"\nheight = \"Alt\"\n";
    let is = |mapping: &str, table: &str, at: (usize, usize), words: &str| {
        let (line, column, sentence) = fault(&format!("{places}{mapping}"), table);
        assert!((line, column) == at && sentence.contains(words), "{line}:{column}: {sentence}, not {words}");
    };
    let table = format!("{header}\n{rows}");
    is("temperature = \"Altt\"", &table, (1, 1), "log.temperature: no column Altt; the header has T, Lat");
    is("temperature = \"Altt\"", &table, (1, 1), "; did you mean Alt?");
    is("temperature = { col = 11 }", &table, (1, 1), "log.temperature: no column 11: the row has 10");
    is(
        "temperature = \"X\"",
        &table.replace("VN,VE", "X,X"),
        (1, 9),
        "log.temperature: an earlier column is X too",
    );
    is("east = \"VE\"", &table, (1, 1), "missing columns: velocity_north_m_s");
    is("speed = \"VE\"\ntrack = \"VN\"", &table, (1, 1), "missing columns: log.climb");
    let all = "east = \"VE\"\nnorth = \"VN\"\nup = \"VD\"\n";
    is(&format!("{all}forward = \"VE\""), &table, (1, 1), "log.forward: the velocity is given by east too");
    is("q0 = 1\nq1 = 0\nq2 = 0\nq3 = 0", &table, (1, 1), "log.q0: the attitude is given by angles too");
    is("", &table.replace("1,47", "1,x"), (3, 2), "Lat: expected a finite number, found \"x\"");
    is("", &table.replace("1,47", "1,95"), (3, 2), "Lat = 95: must be from -90 to 90");
    is("time_format = \"hms\"", &table, (2, 1), "T: expected hh:mm:ss, found \"0\"");
    is("", &table.replace("1,2,3\n1", "1,2,3,4\n1"), (2, 11), "11 fields, and the header names 10 columns");
    is("time_format = \"row\"", &table, (1, 1), "log.rate_hz: expected the rate of rows without times");
    is("header = 9", &table, (1, 1), "no header");
}

/// What a text may say of a column, as it is written again; the faults of the others.
#[test]
fn columns_read_back_as_they_are_written() {
    for (text, written) in [
        ("\"GPS \\\"Alt\\\" [ft]\"", ""),
        ("\"  Alt \"", "\"Alt\""),
        ("-12.3", ""),
        ("7", ""),
        ("{ col = 4 }", ""),
        ("{ col = \"Alt\" }", "\"Alt\""),
        ("{ value = 4 }", "4"),
        ("{ value = 100, unit = \"ft\" }", ""),
        ("{ unit = \"ft\", col = \"Alt\" }", "{ col = \"Alt\", unit = \"ft\" }"),
        (
            "{ col = \"Alt\", unit = \"m\", sign = 1, scale = 1.0, add = 0 }",
            "{ col = \"Alt\", unit = \"m\" }",
        ),
        ("{ col = \"Alt\", sign = -1, add = 0.1 }", ""),
        ("{ col = \"Alt\", scale = -0.27778 }", ""),
    ] {
        let scene = scene(&format!("height = {text}"));
        let written = if written.is_empty() { text } else { written };
        assert_eq!(scene.value("log.height").unwrap(), written);
        assert_eq!(Scene::parse(scene.write().as_bytes()).unwrap(), scene, "{text}");
        let mut set = Scene::parse(b"[flight]\nfile = \"a.csv\"\n").unwrap();
        set.set(&[("log.height", written)]).unwrap();
        assert_eq!(set, scene, "{text}");
        set.set(&[("log.height", "")]).unwrap();
        assert_eq!(set.value("log.height").unwrap(), "");
    }
    let text = "header = 0\nskip = 2\nseparator = \"tab\"\ncomment = \"%\"\nmissing = -32767\ntime_format = \"row\"\nrate_hz = 12.5\n\
        track_is = \"magnetic\"\ntime = { col = 2, unit = \"us\" }\nforce_x = { col = \"NormAc\", unit = \"g\" }";
    let whole = scene(text);
    let written = whole.write();
    assert_eq!(Scene::parse(written.as_bytes()).unwrap(), whole);
    for line in text.lines() {
        assert!(written.contains(&format!("\n{line}  #")), "{line} is not in\n{written}");
    }
    for (text, words) in [
        ("height = true", "log.height: expected \"NAME\" of a column"),
        ("height = [1]", "log.height: expected \"NAME\" of a column"),
        ("height = \" \"", "log.height: expected the name of a column"),
        ("height = {}", "log.height: expected its col or its value"),
        ("height = { col = \"A\", value = 1 }", "log.height: expected either col or value"),
        ("height = { col = 0 }", "log.height.col: expected a column from 1 to 1000"),
        ("height = { col = true }", "log.height.col: expected the name or the number of a column"),
        ("height = { col = \"A\", unit = \"kt\" }", "log.height.unit: expected m, ft"),
        ("height = { col = \"A\", unit = \"\" }", "log.height.unit: expected m, ft"),
        ("height = { col = \"A\", sign = 2 }", "log.height.sign: expected 1 or -1"),
        ("height = { col = \"A\", scale = 0 }", "log.height.scale: expected a number that is not 0"),
        ("height = { col = \"A\", add = \"x\" }", "log.height.add: expected a number"),
        (
            "height = { colum = \"A\" }",
            "log.height: no such part: colum; expected col, value, unit, sign, scale, add, file, part, hemisphere, minutes, seconds; did you mean col?",
        ),
        ("hieght = \"A\"", "did you mean height?"),
        ("separator = \",\"", "expected comma, semicolon, tab, bar, blanks"),
        ("comment = \"//\"", "log.comment: must be a single mark, as #"),
        ("only = \"a\"", "log.only: comes with log.only_column"),
        ("rate_hz = 0", "log.rate_hz = 0: must be from 0.001 to 20000"),
    ] {
        let faults =
            Scene::parse(format!("[flight]\nfile = \"a.csv\"\n[log]\n{text}\n").as_bytes()).unwrap_err();
        assert!(faults[0].sentence.contains(words), "{text}: {faults:?}");
        assert_eq!(faults[0].line, 4, "{text}: {faults:?}");
    }
}

/// A name in another encoding is found by a mapping in UTF-8.
#[test]
fn names_in_every_encoding_are_found() {
    let mapping = "time = \"t\"\nlatitude = \"Breite [°]\"\nlongitude = \"Länge [°]\"\nheight = \"Höhe [m]\"\nroll = 0\npitch = 0\nheading = 0";
    let table = "t,Breite [°],Länge [°],Höhe [m]\r\n0,48,11,300\r\n1,48,11,301\r\n";
    let units = |mark: u16| [mark].into_iter().chain(table.encode_utf16());
    // Each of these letters is one byte of Latin-1, of its own number.
    let latin: Vec<u8> = table.chars().map(|letter| u8::try_from(u32::from(letter)).unwrap()).collect();
    for bytes in [
        table.as_bytes().to_vec(),
        [b"\xef\xbb\xbf", table.as_bytes()].concat(),
        units(0xfeff).flat_map(u16::to_le_bytes).collect(),
        units(0xfeff).flat_map(u16::to_be_bytes).collect(),
        latin,
    ] {
        let log = FlightLog::parse_with(&bytes, &scene(mapping).log).unwrap();
        assert_eq!((log.samples()[1].place.height_m, log.line(1)), (301.0, Some(3)));
    }
}

/// A comma in a number that cannot be read is explained.
#[test]
fn commas_in_numbers_are_explained() {
    let places = "time = \"t\"\nlatitude = \"lat\"\nlongitude = \"lon\"\nheight = \"alt\"\nroll = 0\npitch = 0\nheading = 0\n";
    let (line, column, sentence) = fault(places, "t,lat,lon,alt\n0,48,11,\"1,300.5\"\n");
    assert_eq!((line, column), (2, 4));
    assert!(
        sentence
            .starts_with("alt: expected a finite number, found \"1,300.5\"; write decimals behind a point"),
        "{sentence}"
    );
}

/// A host that pushes a log to a judge: an attitude that is not flown, here of a heading to the north on a way to the east, is not judged.
#[test]
fn a_judge_passes_over_the_attitude_of_a_coordinated_log() {
    let rows: String = (0..3000)
        .map(|k| format!("{},47,{},500,0,0,0\n", f64::from(k) * 0.1, 8.0 + f64::from(k) * 1e-4))
        .collect();
    let table = format!("time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n{rows}");
    let kinds = |mapping: &str| -> Vec<i32> {
        let text = format!("[flight]\nfile = \"a.csv\"\n[log]\n{mapping}\n");
        let (mut scene, mut log, mut judge) =
            (std::ptr::null_mut(), std::ptr::null_mut(), std::ptr::null_mut());
        let mut found: [sins_finding; SINS_FINDINGS_MAX] = [unsafe { std::mem::zeroed() }; SINS_FINDINGS_MAX];
        found[0].struct_size = size_of::<sins_finding>() as u32;
        let mut count = 0;
        // SAFETY: each pointer is to a variable, or to a text of the length that stands behind it.
        unsafe {
            assert_eq!(sins_scene_parse(text.as_ptr().cast(), text.len(), &mut scene), SINS_OK);
            let status =
                sins_log_parse(table.as_ptr().cast(), table.len(), scene, &mut log, std::ptr::null_mut());
            assert_eq!(status, SINS_OK);
            assert_eq!(sins_judge_create(std::ptr::null(), &mut judge), SINS_OK);
            assert_eq!(sins_judge_push_log(judge, log), SINS_OK);
            let status = sins_judge_get_findings(judge, found.as_mut_ptr(), found.len(), &mut count);
            assert_eq!(status, SINS_OK);
            assert_eq!(sins_judge_destroy(judge), SINS_OK);
            assert_eq!(sins_log_destroy(log), SINS_OK);
            assert_eq!(sins_scene_destroy(scene), SINS_OK);
        }
        found[..count].iter().map(|finding| finding.kind).collect()
    };
    assert_eq!(kinds(""), [SINS_FINDING_HEADING_OFF_TRACK]);
    assert_eq!(kinds("attitude = \"coordinated\""), []);
}

const NOT_BESIDE: &str = "log.roll.file: expected the name of a file beside the log, without a folder";

/// `parse_files` joins files; `parse_with` reads one text, and says so.
#[test]
fn a_column_of_another_file_is_written_and_not_read() {
    let scene = |keys: &str| Scene::parse(format!("[flight]\nfile = \"a.csv\"\n[log]\n{keys}\n").as_bytes());
    let of_file = scene("roll = { col = \"Roll\", file = \"ATT \\\"1\\\".csv\" }").unwrap();
    assert_eq!(of_file.log.columns[4].file, "ATT \"1\".csv");
    assert_eq!(Scene::parse(of_file.write().as_bytes()).unwrap().log, of_file.log);
    let table = "time_s,latitude_deg,longitude_deg,height_m,pitch_deg,heading_deg,Roll\n0,48,11,0,0,0,0\n1,48,11,0,0,0,0\n";
    let Err(LogError::Fault(fault)) = FlightLog::parse_with(table.as_bytes(), &of_file.log) else { panic!() };
    assert!(
        fault.sentence.starts_with("log.roll: stands in ATT \"1\".csv, and a text is one table; `sins log"),
        "{fault:?}"
    );
    for (keys, words) in [
        (
            "time = { col = \"t\", file = \"a.csv\" }",
            "log.time.file: times and positions are those of the log itself",
        ),
        ("longitude = { col = \"l\", file = \"a.csv\" }", "log.longitude.file: times and positions"),
        ("roll = { col = \"r\", file = \"\" }", "log.roll.file: expected the name of a file beside the log"),
        ("roll = { col = \"r\", file = 1 }", "log.roll.file: expected the name of a file beside the log"),
        ("roll = { col = \"r\", file = \"../a.csv\" }", NOT_BESIDE),
        ("roll = { col = \"r\", file = \"folder/a.csv\" }", NOT_BESIDE),
        ("roll = { col = \"r\", file = \"/a.csv\" }", NOT_BESIDE),
        ("roll = { col = \"r\", file = '\\\\host\\share\\a.csv' }", NOT_BESIDE),
        ("roll = { col = \"r\", file = '..\\a.csv' }", NOT_BESIDE),
        ("roll = { col = \"r\", file = \"C:a.csv\" }", NOT_BESIDE),
        ("roll = { col = \"r\", file = \"a.csv:stream\" }", NOT_BESIDE),
        ("roll = { col = \"r\", file = \"..\" }", NOT_BESIDE),
        ("roll = { col = \"r\", file = \".\" }", NOT_BESIDE),
        (
            "roll = { value = 1, file = \"a.csv\" }",
            "log.roll: a value has no file, no part and no hemisphere",
        ),
    ] {
        let faults = scene(keys).unwrap_err();
        assert!(faults[0].sentence.contains(words), "{faults:?}");
    }
}

/// An `[imu]` is written and read back to the bit, and it is the mapping of no log.
#[test]
fn a_description_of_a_record_is_written_and_read_back() {
    let keys = "header = 0\nskip = 2\nseparator = \"blanks\"\ncomment = \"%\"\nmissing = -9999.5\ntime_format = \"row\"\nrate_hz = 333.3333333333333\n\
        gyro_x = { col = 3, unit = \"mdeg/s\", sign = -1 }\ngyro_y = { col = \"a \\\"b\\\" [x]\", unit = \"arcsec\", scale = 0.061035156 }\n\
        gyro_z = \"z_rad_s\"\naccelerometer_x = { col = \"p\", unit = \"ug\", part = 2, add = -0.001 }\n\
        accelerometer_y = { col = \"q\", unit = \"m/s\", file = \"b.csv\" }\n";
    let text = format!("[flight]\nbuiltin = \"rest\"\n[imu]\n{keys}");
    let scene = Scene::parse(text.as_bytes()).unwrap_or_else(|faults| panic!("{faults:?}"));
    let again = Scene::parse(scene.write().as_bytes()).unwrap_or_else(|faults| panic!("{faults:?}"));
    assert_eq!(again.imu, scene.imu);
    let written = scene.write();
    for line in
        ["header = 0", "unit = \"mdeg/s\", sign = -1", "scale = 0.061035156", "part = 2", "file = \"b.csv\""]
    {
        assert!(written.contains(line), "{line}: {written}");
    }
    let plain = Scene::parse(b"[flight]\nbuiltin = \"rest\"\n").unwrap();
    assert!(scene.log == plain.log && scene.imu != plain.imu && !plain.write().contains("[imu]"));
}
