//! Columns that are not read are compared with what flies.

use sins::judge::{Kind, Level};
use sins::log::FlightLog;
use sins::scene::Scene;

use crate::support::DEG;

/// A row of a climbing turn: time [s], latitude, longitude [deg], height, east, north, up [m, m/s], heading [deg].
type Row = [f64; 8];

/// 60 m/s over ground for 200 s at 5 Hz, with more than a half turn, up and down.
fn flight(speed: f64) -> Vec<Row> {
    let (mut latitude, mut longitude, mut height) = (47.0f64, 8.0f64, 1500.0f64);
    let rows = (0..1000).map(|k| {
        let t = 0.2 * f64::from(k);
        let heading = 0.3 + 0.02 * t;
        let velocity = [speed * heading.sin(), speed * heading.cos(), 6.0 * (t / 20.0).sin()];
        let row = [t, latitude, longitude, height, velocity[0], velocity[1], velocity[2], heading / DEG];
        latitude += 0.2 * velocity[1] / 6.371e6 / DEG;
        longitude += 0.2 * velocity[0] / 6.371e6 / DEG / (latitude * DEG).cos();
        height += 0.2 * velocity[2];
        row
    });
    rows.collect()
}

/// The flight with more columns, read by a `[log]` that does not name them.
fn read(names: &str, rows: &[Row], keys: &str, more: impl Fn(&Row) -> String) -> FlightLog {
    let text = format!(
        "[flight]\nfile = \"a.csv\"\n[log]\ntime = \"T\"\nlatitude = \"La\"\nlongitude = \"Lo\"\nheight = \"Z\"\nroll = 0\npitch = 0\nheading = \"Psi\"\n{keys}"
    );
    let scene = Scene::parse(text.as_bytes()).unwrap_or_else(|faults| panic!("{faults:?}"));
    let row = |row: &Row| {
        let [t, latitude, longitude, height, .., heading] = row;
        format!("{t:.1},{latitude:.9},{longitude:.9},{height:.3},{heading:.3},{}\n", more(row))
    };
    let table = format!("T,La,Lo,Z,Psi,{names}\n") + &rows.iter().map(row).collect::<String>();
    scene.read_log(table.as_bytes()).unwrap()
}

fn notes(log: &FlightLog) -> Vec<String> {
    log.notes().iter().map(|note| note.sentence.clone()).collect()
}

fn is_contradicted(log: &FlightLog) -> bool {
    let mut of_rows = log.of_rows().iter();
    of_rows.any(|(found, line)| {
        (found.kind, found.level, *line) == (Kind::UnreadContradicts, Level::Doubtful, 1)
    })
}

const KT: f64 = 1852.0 / 3600.0;
const FT_MIN: f64 = 0.3048 / 60.0;

/// Each in its unit, as instruments write it: whole numbers, a magnetic course, another kind of height.
#[test]
fn columns_that_agree_are_said_and_nothing_is_doubtful() {
    for keys in ["", "smooth = \"auto\"\n"] {
        let names = "GndSpd (kt),Speed,TRK,VSpd (ft/min),climb,AltMSL (ft),Elapsed (ms),UTC,mag_hdg,velocityX(mps),velocityZ";
        let log = read(names, &flight(60.0), keys, |row| {
            let [t, _, _, height, east, north, up, heading] = row;
            let speed = east.hypot(*north);
            format!(
                "{:.0},{:.1},{:.0},{:.0},{:.0},{:.0},{:.0},12:{:02.0}:{:04.1},{:.0},{north:.1},{:.1}",
                speed / KT,
                3.6 * speed,
                heading + 9.0,
                up / FT_MIN,
                up / FT_MIN,
                (height + 60.0) / 0.3048,
                1e3 * t + 5e4,
                (t / 60.0).floor(),
                t % 60.0,
                heading + 5.0,
                -up
            )
        });
        assert!(!is_contradicted(&log), "{:?}", notes(&log));
        let said =
            notes(&log).into_iter().find(|note| note.starts_with("not read, and in agreement")).unwrap();
        for words in [
            "GndSpd (kt) (speed in kt)",
            "Speed (speed in km/h)",
            "TRK (course)",
            "VSpd (ft/min) (up in ft/min)",
            "climb (up in ft/min)",
            "AltMSL (ft) (height in ft)",
            "Elapsed (ms) (time)",
            "UTC (time)",
            "and 3 more",
        ] {
            assert!(said.contains(words), "{words}: {said}");
        }
        let log = read("velocityX(mps),velocityY(mps),zSpeed,mag_hdg", &flight(60.0), keys, |row| {
            let [.., east, north, up, heading] = row;
            format!("{north:.1},{east:.1},{:.1},{heading:.0}", -up)
        });
        let said = notes(&log).concat();
        for words in [
            "velocityX(mps) (north in m/s)",
            "velocityY(mps) (east in m/s)",
            "zSpeed (-up in m/s)",
            "mag_hdg (",
        ] {
            assert!(said.contains(words), "{words}: {said}");
        }
    }
}

#[test]
fn a_column_that_contradicts_what_flies_is_doubtful() {
    type Of = fn(&Row) -> f64;
    let speed: Of = |row| row[4].hypot(row[5]);
    let cases: [(&str, Of, &str); 12] = [
        ("GndSpd (kt)", speed, "the speed that flies is 1.94 times that of it (is it in m/s?)"),
        ("groundspeed", |row| 0.4 * row[4].hypot(row[5]), "the speed that flies is 2.50 times that of it"),
        ("course", |row| 360.0 - row[7], "turns the other way (has the longitude lost its sign?)"),
        ("TRK", |row| row[7] + 90.0, "the track is 90 deg off its course"),
        ("VSpd (ft/min)", |row| row[6], "the velocity up that flies is 197 times that of it (is it in m/s?)"),
        ("climb", |row| -row[6], "the velocity up that flies has the opposite sign"),
        ("vel_e", |row| -row[4], "the velocity east that flies has the opposite sign"),
        ("vel_n (m/s)", |row| row[5] / KT, "(is it in kt?)"),
        (
            "Altitude (m)",
            |row| row[3] / 0.3048,
            "the change of the height that flies is 0.3048 times that of it (is it in ft?)",
        ),
        ("elapsed (s)", |row| 2.0 * row[0], "it runs 2.00 times as fast as the time that flies"),
        ("elapsed_ms", |row| 500.0 * row[0], "it runs 0.5000 times as fast"),
        ("heading", |row| 90.0 - row[7], "the heading that flies is"),
    ];
    for (name, of, words) in cases {
        for keys in ["", "smooth = \"auto\"\n"] {
            let log = read(name, &flight(60.0), keys, |row| format!("{:.3}", of(row)));
            assert!(is_contradicted(&log), "{name}: {:?}", notes(&log));
            let note = log
                .notes()
                .iter()
                .find(|note| note.sentence.starts_with(name) && note.sentence.contains("contradicts"))
                .unwrap();
            assert!(note.sentence.contains(words) && (note.line, note.column) == (1, 6), "{name}: {note:?}");
        }
    }
    // Heights without a unit that flies in feet.
    let feet: Vec<Row> = flight(60.0)
        .iter()
        .map(|row| [&row[..3], &[row[3] / 0.3048], &row[4..]].concat().try_into().unwrap())
        .collect();
    let log = read("AltGPS (m)", &feet, "", |row| format!("{:.1}", row[3] * 0.3048));
    assert!(
        is_contradicted(&log) && notes(&log).concat().contains("(is what flies in ft?)"),
        "{:?}",
        notes(&log)
    );
}

/// A speed through the air, one number all the way, a column without numbers, a vehicle at rest.
#[test]
fn what_need_not_agree_is_no_contradiction() {
    for (name, of, words) in [
        (
            "Speed (kt)",
            (|row: &Row| (0.8 * row[4].hypot(row[5]) / KT).to_string()) as fn(&Row) -> String,
            "other than what flies: Speed (kt)",
        ),
        ("wind_speed", |row: &Row| (5.0 + row[0].sin()).to_string(), "other than what flies: wind_speed"),
        ("height", |row: &Row| (row[3] - 1200.0).to_string(), "other than what flies: height"),
        ("GndSpd", |_: &Row| "0".to_owned(), ""),
        ("GndSpd", |_: &Row| "no fix".to_owned(), ""),
        // Of another kind: through the air, above the ground, of an antenna, magnetic, counted, and one cell that is no value.
        (
            "Speed (m/s)",
            |row: &Row| (0.4 * row[4].hypot(row[5])).to_string(),
            "other than what flies: Speed (m/s)",
        ),
        ("speed", |row: &Row| (0.48 * row[4].hypot(row[5])).to_string(), "other than what flies: speed"),
        (
            "elevation",
            |row: &Row| (300.0 + 200.0 * (row[0] / 7.0).sin()).to_string(),
            "other than what flies: elevation",
        ),
        ("alt", |row: &Row| (0.7 * row[3]).to_string(), "other than what flies: alt"),
        ("course", |row: &Row| (row[7] + 40.0).to_string(), "other than what flies: course"),
        ("heading", |row: &Row| (row[7] - 40.0).to_string(), "other than what flies: heading"),
        ("time", |row: &Row| (7.0 * row[0]).to_string(), "other than what flies: time"),
        ("timestamp", |row: &Row| (1e7 * row[0]).to_string(), "timestamp (time)"),
        ("heading", |row: &Row| (row[7] + 1440.0).to_string(), "heading (heading)"),
        ("track", |row: &Row| (row[7] * DEG + 12.566370614).to_string(), "track (course)"),
        (
            "altitude (m)",
            |row: &Row| if row[0] == 9.0 { "-32768".to_owned() } else { row[3].to_string() },
            "altitude (m)",
        ),
        ("throttle", |row: &Row| row[4].to_string(), ""),
        ("Yaw (deg/s)", |row: &Row| row[7].to_string(), ""),
        (
            "relative_alt",
            |row: &Row| row[4].hypot(row[5]).to_string() + if row[0] > 9.0 { "1" } else { "0" },
            "other than what flies: relative_alt",
        ),
        ("h", |row: &Row| (50.0 + row[0].sin()).to_string(), ""),
        ("Time", |row: &Row| format!("12:0{:.0}", (row[0] / 60.0).floor()), ""),
    ] {
        let log = read(name, &flight(60.0), "", of);
        assert!(!is_contradicted(&log), "{name}: {:?}", notes(&log));
        assert!(notes(&log).concat().contains(words), "{name}: {:?}", notes(&log));
        assert_eq!(notes(&log).is_empty(), words.is_empty(), "{name}: {:?}", notes(&log));
    }
    // Northward, where degrees are no more than radians are.
    let north: Vec<Row> = (0..600)
        .map(|k| {
            [
                f64::from(k),
                47.0 + 5e-4 * f64::from(k),
                8.0,
                900.0,
                0.0,
                55.6,
                0.0,
                2.5 + (0.1 * f64::from(k)).sin(),
            ]
        })
        .collect();
    for name in ["course", "track (deg)", "heading"] {
        let log = read(name, &north, "", |row| format!("{:.1}", row[7]));
        assert!(!is_contradicted(&log), "{name}: {:?}", notes(&log));
    }
    // A walker in whole km/h, which are near to ft/s too.
    let log = read("speed", &flight(1.4), "", |_| "5".to_owned());
    assert!(!notes(&log).concat().contains("ft/s"), "{:?}", notes(&log));
    let log = read("GndSpd,TRK", &flight(0.0), "", |row| {
        format!("{:.1},{:.0}", row[0].sin().abs(), 40.0 * row[0] % 360.0)
    });
    assert!(!is_contradicted(&log), "{:?}", notes(&log));
}

/// A course or a heading that turns the other way tells that the path is mirrored, at any direction of the flight.
#[test]
fn a_mirrored_path_is_told_by_a_column_that_is_not_read() {
    let rows = flight(60.0);
    for name in ["bearing", "Course over ground", "heading"] {
        for turned in [0.0, 50.0, 100.0, 200.0] {
            let log = |mirror: fn(f64) -> f64| {
                let text = "[flight]\nfile = \"a.csv\"\n[log]\ntime = \"T\"\nlatitude = \"La\"\nlongitude = \"Lo\"\nheight = \"Z\"\nattitude = \"coordinated\"\n";
                let scene = Scene::parse(text.as_bytes()).unwrap();
                let row = |row: &Row| {
                    let [t, latitude, longitude, height, .., heading] = row;
                    let (sine, cosine) = (turned * DEG).sin_cos();
                    let [north, east] = [latitude - 47.0, (longitude - 8.0) * (47.0 * DEG).cos()];
                    let [north, east] = [cosine * north - sine * east, sine * north + cosine * east];
                    let place = [47.0 + north, 8.0 + east / (47.0 * DEG).cos()];
                    let course = mirror((heading + turned).rem_euclid(360.0)).rem_euclid(360.0);
                    format!("{t:.1},{:.9},{:.9},{height:.3},{course:.1}\n", place[0], place[1])
                };
                let table = format!("T,La,Lo,Z,{name}\n") + &rows.iter().map(row).collect::<String>();
                scene.read_log(table.as_bytes()).unwrap()
            };
            for mirror in [|course: f64| -course, |course: f64| 180.0 - course, |course: f64| 90.0 - course] {
                let log = log(mirror);
                assert!(is_contradicted(&log), "{name} {turned}: {:?}", notes(&log));
            }
            assert!(
                !is_contradicted(&log(|course| course)) && !is_contradicted(&log(|course| course + 12.0))
            );
        }
    }
}
