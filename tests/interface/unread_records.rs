//! What flight records say of the motion beside the columns that are read, against what flies.

use sins::judge::{Kind, Level};
use sins::log::FlightLog;
use sins::scene::Scene;

use crate::support::DEG;

/// A row of a climbing turn: time [s], latitude, longitude [deg], height [m], speed over ground [m/s], track [deg], climb [m/s].
type Row = [f64; 7];

/// 40 m/s over ground for 300 s at 1 Hz, with nearly a whole turn, up and down.
fn flight() -> Vec<Row> {
    let (mut latitude, mut longitude, mut height) = (47.0f64, 8.0f64, 1500.0f64);
    let mut rows = Vec::new();
    for k in 0..3000 {
        let t = 0.1 * f64::from(k);
        let (track, climb) = (0.3 + 0.02 * t, 5.0 * (t / 20.0).sin());
        if k % 10 == 0 {
            rows.push([t, latitude, longitude, height, 40.0, track / DEG % 360.0, climb]);
        }
        let track = track + 0.001;
        latitude += 4.0 * track.cos() / 6.371e6 / DEG;
        longitude += 4.0 * track.sin() / 6.371e6 / DEG / (latitude * DEG).cos();
        height += 0.1 * climb;
    }
    rows
}

fn clock(t: f64, mark: &str) -> String {
    let t = t as u32 + 36_000;
    [t / 3600, t / 60 % 60, t % 60].map(|part| format!("{part:02}")).join(mark)
}

/// A track with elements in each point.
fn gpx(elements: impl Fn(&Row) -> String) -> String {
    let point = |row: &Row| {
        let [t, latitude, longitude, height, ..] = row;
        let (time, elements) = (clock(*t, ":"), elements(row));
        format!(
            "<trkpt lat=\"{latitude:.8}\" lon=\"{longitude:.8}\"><ele>{height:.1}</ele><time>2026-07-25T{time}Z</time>{elements}</trkpt>\n"
        )
    };
    let points: String = flight().iter().map(point).collect();
    format!("<gpx version=\"1.1\" xmlns:gpxtpx=\"x\"><trk><trkseg>\n{points}</trkseg></trk></gpx>\n")
}

/// The element of a receiver's extension.
fn extension(elements: &str) -> String {
    format!("<extensions><gpxtpx:TrackPointExtension>{elements}</gpxtpx:TrackPointExtension></extensions>")
}

/// B records with further digits of the angles, and an extension of these columns and this name behind them.
fn igc(name: &str, width: usize, text: impl Fn(&Row) -> String) -> String {
    let angle = |degrees: f64, width: usize| {
        let minutes = (degrees * 6e6).round() as u64;
        let (whole, more) = (minutes / 100, minutes % 100);
        (format!("{:0width$}{:05}", whole / 60_000, whole % 60_000), format!("{more:02}"))
    };
    let fix = |row: &Row| {
        let [t, latitude, longitude, height, ..] = row;
        let ((north, lad), (east, lod)) = (angle(*latitude, 2), angle(*longitude, 3));
        let height = height.round();
        format!("B{}{north}N{east}EA{height:05}{height:05}{lad}{lod}{}\r\n", clock(*t, ""), text(row))
    };
    let fixes: String = flight().iter().map(fix).collect();
    format!("AXXX001\r\nHFDTE250726\r\nI033637LAD3839LOD40{:02}{name}\r\n{fixes}", 39 + width)
}

/// A record of X-Plane with these lines of datarefs.
fn fdr(datarefs: &str, values: impl Fn(&Row) -> String) -> String {
    let row = |row: &Row| {
        let [t, latitude, longitude, height, _, track, _] = row;
        let (time, feet, values) = (clock(*t, ":"), height / 0.3048, values(row));
        format!("{time}, {longitude:.8}, {latitude:.8}, {feet:.2}, {track:.2}, 2, 5, {values}\n")
    };
    let rows: String = flight().iter().map(row).collect();
    format!("A\n4\nCOMM, a flight\n{datarefs}{rows}")
}

/// The note of what is not read, and whether it contradicts.
fn said(text: &str) -> (String, bool) {
    let scene = Scene::parse(b"[flight]\nfile = \"a\"\n").unwrap();
    let log: FlightLog = scene.read_log(text.as_bytes()).unwrap();
    let mut found = log.of_rows().iter().map(|(found, _)| found);
    let found = found.find(|found| found.kind == Kind::UnreadContradicts);
    let is_doubtful = found.is_some_and(|found| {
        // It is of the whole record.
        assert_eq!(log.line_of(found), None);
        found.level == Level::Doubtful
    });
    let of_unread = log.notes().iter().filter(|note| note.sentence.contains("not read"));
    (of_unread.map(|note| note.sentence.clone() + "\n").collect(), is_doubtful)
}

#[test]
fn what_a_record_has_beside_and_flies_is_said() {
    let cases = [
        (
            gpx(|row| format!("<speed>{:.2}</speed><course>{:.1}</course>", row[4], row[5])),
            "speed (speed in m/s), course (course)",
        ),
        (
            gpx(|row| {
                extension(&format!(
                    "<gpxtpx:hr>120</gpxtpx:hr><gpxtpx:speed>{:.1}</gpxtpx:speed><gpxtpx:course>{:.0}</gpxtpx:course><v:vspeed/><ele>{:.0}</ele>",
                    row[4] * 3.6,
                    row[5],
                    row[3] / 0.3048
                ))
            }),
            "speed (speed in km/h), course (course), ele (height in ft)",
        ),
        (igc("GSP", 3, |row| format!("{:03.0}", row[4] * 3.6)), "GSP (speed in km/h)"),
        (igc("TRT", 3, |row| format!("{:03.0}", row[5].floor())), "TRT (course)"),
        (
            fdr(
                "DREF, sim/flightmodel/position/groundspeed\t1.0\t// comment: over ground, m/s\nDREF, sim/weather/wind_speed_kt 1\nDREF,sim/flightmodel/position/vh_ind_fpm, 1\n",
                |row| format!("{:.2}, 12, {:.0}", row[4], row[6] / 0.3048 * 60.0),
            ),
            "groundspeed (speed in m/s), vh_ind_fpm (up in ft/min)",
        ),
        (fdr("DREF, sim/flightmodel/position/hpath 1.0\n", |row| format!("{:.1}", row[5])), "hpath (course)"),
    ];
    for (text, words) in cases {
        let (notes, is_doubtful) = said(&text);
        assert!(!is_doubtful && notes.starts_with("not read, and in agreement"), "{words}: {notes}");
        assert!(notes.contains(words), "{words}: {notes}");
    }
}

#[test]
fn what_contradicts_a_record_is_doubtful() {
    let cases = [
        // Its clock runs too fast.
        (gpx(|row| format!("<speed>{:.2}</speed>", 1.5 * row[4])), "speed is not read, and contradicts"),
        (
            gpx(|row| extension(&format!("<course>{:.0}</course>", (row[5] + 120.0) % 360.0))),
            "the track is 12",
        ),
        (
            gpx(|row| format!("<climb>{:.2}</climb>", -row[6])),
            "the velocity up that flies has the opposite sign",
        ),
        (igc("GSP", 3, |row| format!("{:03.0}", row[4] * 1.944)), "(is it in kt?)"),
        (
            igc("TRT", 3, |row| format!("{:03.0}", (row[5] + 180.0) % 360.0)),
            "TRT is not read, and contradicts what flies: the track is",
        ),
        (
            fdr("DREF, sim/flightmodel/position/groundspeed 1.0\n", |row| format!("{:.1}", 3.0 * row[4])),
            "groundspeed is not read, and contradicts",
        ),
        (
            fdr("DREF, a/b 1.0\nDREF, sim/flightmodel/position/vh_ind 1.0\n", |row| {
                format!("7, {:.2}", row[6] / 0.3048 * 60.0)
            }),
            "(is it in ft/min?)",
        ),
    ];
    for (text, words) in cases {
        let (notes, is_doubtful) = said(&text);
        assert!(is_doubtful && notes.contains(words), "{words}: {notes}");
    }
}

/// Names without numbers, numbers that are none of the motion or have a factor, speeds that rare rows and noise explain, headings.
#[test]
fn what_need_not_agree_is_no_contradiction() {
    let nothing = [
        gpx(|_| String::new()),
        gpx(|row| {
            format!("<geoidheight>47</geoidheight><hdop>{:.1}</hdop><magvar>{}</magvar>", row[6], row[0])
        }),
        gpx(|row| extension(&format!("<time>{}</time><speed>fast</speed><course></course>", row[6]))),
        gpx(|row| extension(&format!("<speed>{}</speed>", format!("{:.0}", row[0]).repeat(300)))),
        gpx(|row| extension(&(0..200).map(|k| format!("<a{k}>{}</a{k}>", row[0])).collect::<String>())),
        igc("GSP", 3, |_| "---".to_owned()),
        igc("GSP", 4, |row| format!("{:04.0}", row[4])),
        igc("GSP", 5, |row| format!("{:05.0}", row[4] * 360.0)),
        igc("TRM", 3, |row| format!("{:03.0}", (row[5] + 180.0) % 360.0)),
        fdr("DREF, sim/flightmodel/position/groundspeed 1.944\n", |row| format!("{:.1}", row[4])),
        fdr("DREF, sim/flightmodel/position/groundspeed\n", |row| format!("{:.1}", 3.0 * row[4])),
        fdr("DREF, sim/flightmodel/position/groundspeed 1.0\n", |_| "none".to_owned()),
    ];
    for text in nothing {
        assert_eq!(said(&text), (String::new(), false), "{}", &text[text.len() - 400..]);
    }
    // Without a value, and a dataref in each way of writing.
    let agree = [
        gpx(|row| format!("<speed>{:.2}</speed>", if row[0] % 3.0 == 0.0 { -1.0 } else { row[4] })),
        gpx(|row| format!("<course>{:.1}</course>", if row[0] % 3.0 == 0.0 { -1.0 } else { row[5] })),
        fdr("DREF sim/a 1.0\ndref\tsim/b 1.0\nDREF, sim/flightmodel/position/groundspeed 1.0\n", |row| {
            format!("900, 900, {:.2}", row[4])
        }),
    ];
    for text in agree {
        let (notes, is_doubtful) = said(&text);
        assert!(!is_doubtful && notes.contains("in agreement"), "{notes}");
    }
    // Rare rows cut turns short.
    let is_kept = |(k, line): &(usize, &str)| !line.starts_with("<trkpt") || k % 5 == 0;
    let dense = gpx(|row| format!("<speed>{:.2}</speed>", 1.5 * row[4]));
    let rare: Vec<&str> = dense.lines().enumerate().filter(is_kept).map(|(_, line)| line).collect();
    let (notes, is_doubtful) = said(&rare.join("\n"));
    assert!(!is_doubtful && notes == "not read, and other than what flies: speed\n", "{notes}");
    let other = [
        gpx(|row| format!("<speed>{:.1}</speed>", row[4] * (1.2 + 0.01 * row[0].sin()))),
        gpx(|row| extension(&format!("<heading>{:.0}</heading>", (row[5] + 180.0) % 360.0))),
        igc("GSP", 3, |row| format!("{:03.0}", row[4] * 3.6 * 0.85)),
        igc("TRT", 3, |row| format!("{:03.0}", (row[5] + 25.0) % 360.0)),
    ];
    for text in other {
        let (notes, is_doubtful) = said(&text);
        assert!(!is_doubtful && notes.starts_with("not read, and other than what flies"), "{notes}");
    }
}
