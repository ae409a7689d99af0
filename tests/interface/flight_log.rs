//! Flight logs: the values that are read, and the faults of a text.

use nalgebra::Vector3;
use sins::log::{FlightLog, LogError};
use sins::scene::Scene;

const HEADER: &str = "time_s, latitude_deg,longitude_rad,height_m,roll_rad,pitch_rad,heading_deg";

fn read(text: &str) -> FlightLog {
    FlightLog::parse(text.as_bytes()).unwrap()
}

/// Line, column and sentence of the fault of a text.
fn fault(text: &[u8]) -> (usize, usize, String) {
    match FlightLog::parse(text) {
        Err(LogError::Fault(fault)) => (fault.line, fault.column, fault.sentence),
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_logs_of_the_examples_are_read() {
    let log = read(include_str!("../../c_examples/flights/fighter_aerobatics.csv"));
    assert_eq!((log.samples().len(), log.line(0), log.line(30_000)), (30_001, Some(4), Some(30_004)));
    assert_eq!(log.duration_s(), 300.0);
    assert!(log.title.starts_with("Fighter in aerobatics"));
    assert_eq!(log.samples()[1].time_s, 0.01);
    assert_eq!(log.samples()[1].v_n, Some(Vector3::new(263.712269080, -0.000306596, -0.018290609)));
}

#[test]
fn degrees_comments_columns_of_others_and_line_ends() {
    let text = format!(
        "\u{feff}# a flight\r\n{HEADER},wind\r\n0,45,0.1,100,0,0,90,7\r\n\r\n# later\r\n1, 45,0.2,100,0,0,90,x\r\n"
    );
    let log = read(&text);
    assert_eq!((log.samples().len(), log.line(1), log.title.as_str()), (2, Some(6), "a flight"));
    assert_eq!(log.samples()[0].place.latitude_rad, 45.0 * (std::f64::consts::PI / 180.0));
    assert_eq!((log.samples()[1].place.longitude_rad, log.samples()[1].v_n), (0.2, None));
}

/// Columns that look like a quantity which the log lacks; not those of a quantity that it has, nor of others.
#[test]
fn columns_that_are_not_read_are_noted() {
    let noted = |header: &str, row: &str| -> Vec<(usize, usize, String)> {
        let log = read(&format!("# a\n{header}\n0,45,0,0,0,0,0,{row}\n1,45,0,0,0,0,0,{row}\n"));
        log.notes().iter().map(|note| (note.line, note.column, note.sentence.clone())).collect()
    };
    let header = format!("{HEADER},vel_e,VN (kt),velocity_down,wind,Lat,OAT");
    let expected = [
        (2, 8, "vel_e is not read; is it velocity_east_m_s?"),
        (2, 9, "VN (kt) is not read; is it velocity_north_m_s, in kt?"),
        (2, 10, "velocity_down is not read; is it velocity_up_m_s, with the opposite sign?"),
        (2, 13, "OAT is not read; is it temperature_c?"),
    ];
    assert_eq!(
        noted(&header, "1,2,3,4,5,6"),
        expected.map(|(line, column, text)| (line, column, text.to_owned()))
    );
    let velocities = "velocity_east_m_s,velocity_north_m_s,velocity_up_m_s";
    assert_eq!(noted(&format!("{HEADER},{velocities},vel_e"), "1,2,3,4"), []);
    let (.., sentence) = fault(b"Time,Lat,Lng,Alt,Roll,Pitch,Yaw\n");
    assert!(
        sentence
            .contains("latitude_rad or latitude_deg (found Lat), longitude_rad or longitude_deg (found Lng)"),
        "{sentence}"
    );
}

#[test]
fn triples_come_whole_and_a_temperature_alone() {
    let text = format!(
        "{HEADER},velocity_east_m_s,velocity_north_m_s,velocity_up_m_s,temperature_c\n\
         0,45,0,0,0,0,0,1,2,3,20\n1,45,0,0,0,0,0,1,2,3,21\n"
    );
    let samples = read(&text).samples().to_vec();
    assert_eq!(samples[0].v_n, Some(Vector3::new(1.0, 2.0, 3.0)));
    assert_eq!((samples[1].temperature_c, samples[1].f_b), (Some(21.0), None));
    let (line, _, sentence) = fault(text.replace("velocity_up_m_s", "velocity_u_m_s").as_bytes());
    assert_eq!(
        (line, sentence.as_str()),
        (
            1,
            "missing columns: velocity_up_m_s (found velocity_u_m_s); the header has time_s, latitude_deg, longitude_rad, \
             height_m, roll_rad, pitch_rad, heading_deg, velocity_east_m_s, velocity_north_m_s, velocity_u_m_s, temperature_c"
        )
    );
}

#[test]
fn a_fault_has_its_line_its_column_and_a_sentence() {
    let is = |text: &str, line: usize, column: usize, words: &str| {
        let found = fault(text.as_bytes());
        assert!(
            (found.0, found.1) == (line, column) && found.2.contains(words),
            "{found:?}, expected {words}"
        );
    };
    is("", 1, 1, "no header");
    is("# nothing\n", 1, 1, "no header");
    is("time_s\n", 1, 1, "missing columns: latitude_rad or latitude_deg");
    is(&format!("{HEADER},time_s\n"), 1, 8, "an earlier column");
    is(&format!("{HEADER},latitude_rad\n"), 1, 8, "an earlier column");
    let row = "0,45,0,0,0,0,0\n";
    is(&format!("{HEADER}\n{row}"), 3, 1, "1 samples");
    is(&format!("{HEADER}\n{row}{row}"), 3, 1, "not later");
    is(&format!("{HEADER}\n{row}1,45,0,0,0,0\n"), 3, 7, "the line ends before heading_deg");
    for number in ["north", "", "nan", "inf", "1e999", "0x10", "1_000"] {
        is(&format!("{HEADER}\n{row}1,{number},0,0,0,0,0\n"), 3, 2, "expected a finite number");
    }
    // A decimal comma cuts a value in two, and each half is a valid number.
    is(&format!("{HEADER}\n0,45,0,5,0,0,0,1,0\n"), 2, 8, "9 fields, and the header names 7 columns");
    is(&format!("{HEADER}\n{row}1,45,0,0,0,0,0,\n"), 3, 8, "8 fields");
    let (line, _, sentence) = fault(format!("{HEADER}\n{row}1,4\x005,0,0,0,0,0\n").as_bytes());
    assert_eq!((line, sentence.as_str()), (3, "a zero byte: not a text"));
    // Rows that share a line could not be distinguished by the line number.
    for ends in ["\r", "\r\r\n", "\n1,45,0,0,0,\"\r\",0\n"] {
        let (line, column, sentence) = fault(format!("{HEADER}\r\n{}{ends}", row.trim_end()).as_bytes());
        assert_eq!((line, column), (if ends.starts_with('\n') { 3 } else { 2 }, 1), "{ends:?}");
        assert!(sentence.starts_with("a carriage return without a line feed"), "{ends:?}: {sentence}");
    }
    let mut bytes = format!("{HEADER}\n{row}1,45,0,0,0,0,").into_bytes();
    bytes.push(0xff);
    assert_eq!(fault(&bytes).2, "heading_deg: expected a finite number, found \"\u{ff}\"");
}

/// Each byte of a small log is replaced in turn with each of 30 others. Each text has an answer.
#[test]
fn altered_texts_have_an_answer() {
    let text = format!("# t\n{HEADER}\n0,45,0.1,100,0,0,90\n1,45,0.2,100,0,0,90\n");
    let mut read = 0;
    for at in 0..text.len() {
        for byte in b"\0\n\r\t \"',#;-+.0159eEnaxX_\\\xff\xc3\x80".iter() {
            let mut bytes = text.clone().into_bytes();
            bytes[at] = *byte;
            read += usize::from(FlightLog::parse(&bytes).is_ok());
        }
    }
    assert!(read > 100, "{read}");
}

/// The last line of a log is a comment with no line end: the log is that without it.
#[test]
fn a_comment_may_end_a_log_without_a_newline() {
    let rows = format!("{HEADER}\n0,45,0.1,100,0,0,90\n1,45,0.2,100,0,0,90\n");
    for end in ["#", "# end of the flight", "#,,,,,,,,,"] {
        assert_eq!(read(&format!("{rows}{end}")), read(&rows), "{end}");
    }
}

#[test]
fn a_log_has_a_longest_duration() {
    let log =
        |first: &str, last: &str| format!("{HEADER}\n{first},45,0.1,100,0,0,90\n{last},45,0.2,100,0,0,90\n");
    let (line, column, sentence) = fault(log("-5e9", "6e9").as_bytes());
    assert_eq!((line, column), (3, 1));
    assert_eq!(sentence, "time_s = 6e9: must be at most 1e10 s after the first sample, -5e9");
    assert_eq!(read(&log("5", "1e10")).samples().len(), 2);
}

/// A value out of its range is reported with its column and its limits, in the unit of the column.
#[test]
fn values_of_a_log_have_ranges() {
    let in_radians = "time_s,latitude_rad,longitude_rad,height_m,roll_rad,pitch_rad,heading_rad,\
        velocity_east_m_s,velocity_north_m_s,velocity_up_m_s,temperature_c";
    let good = ["1", "0.7", "0.1", "100", "0", "0", "1", "0", "0", "0", "20"];
    for (place, value, words) in [
        (0, "1e308", "time_s = 1e308: must be from -1e10 to 1e10"),
        (
            1,
            "47.5",
            "latitude_rad = 47.5: must be from -1.5707963277948966 to 1.5707963277948966; is it in degrees?",
        ),
        (2, "-101", "longitude_rad = -101: must be from -100 to 100; is it in degrees?"),
        (3, "5e9", "height_m = 5e9: must be from -20000 to 2000000"),
        (
            6,
            "1e5",
            "heading_rad = 100000: must be from -10000 to 10000; a number that stands for a missing value is left out by log.missing",
        ),
        (9, "3e4", "velocity_up_m_s = 30000: must be from -20000 to 20000"),
        (10, "3000", "temperature_c = 3000: must be from -273.15 to 1000"),
    ] {
        let mut row = good;
        row[place] = value;
        let text = format!("{in_radians}\n{}\n{}\n", good.join(",").replacen('1', "0", 1), row.join(","));
        assert_eq!(fault(text.as_bytes()), (3, place + 1, words.to_owned()));
    }
    let text = format!("{HEADER}\n0,45,0.1,100,0,0,90\n1,90.01,0.2,100,0,0,90\n");
    assert_eq!(fault(text.as_bytes()), (3, 2, "latitude_deg = 90.01: must be from -90 to 90".to_owned()));
}

#[test]
fn a_flight_has_one_temperature() {
    let log = |more: [&str; 3]| {
        let [name, first, second] = more;
        let angles = "latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg";
        let text = format!("time_s,{angles}{name}\n0,48,11,500,0,0,0{first}\n1,48,11,500,0,0,0{second}\n");
        FlightLog::parse(text.as_bytes()).unwrap()
    };
    let scene = |more: &str| Scene::parse(format!("[flight]\nfile = \"a.csv\"\n{more}").as_bytes()).unwrap();
    let (own, without) = (log([",temperature_c", ",20", ",21"]), log(["", "", ""]));
    let set = scene("temperature_c = 15\n");
    assert!(scene("").samples(Some(&own)).is_ok() && set.samples(Some(&without)).is_ok());
    let error = set.samples(Some(&own)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "flight.temperature_c = 15: must not be set for a log with the temperature of its own"
    );
}
