//! Formats of flight logs without names, known by the number of their columns and the ranges of their values.

use super::Separator;
use super::lines::cells;
use super::rows::number;
use super::survey::Survey;

/// Rows that are looked at, and the fewest of them.
const ROWS: usize = 1000;
const FEWEST: usize = 3;

/// A format: its columns stand between blanks.
struct Nameless {
    name: &'static str,
    /// The column of the time, from 0, which increases from row to row.
    time: usize,
    /// Least and greatest value of each column.
    ranges: &'static [(f64, f64)],
    /// Its keys of `[log]`.
    keys: &'static str,
    doubt: &'static str,
}

const SPEEDS: (f64, f64) = (-1000.0, 1000.0);
const HEIGHTS: (f64, f64) = (-1000.0, 1e5);

const NAMELESS: [Nameless; 2] = [
    Nameless {
        name: "KF-GINS",
        time: 1,
        ranges: &[
            (0.0, 1e4),
            (0.0, 604_800.0),
            (-90.0, 90.0),
            (-180.0, 360.0),
            HEIGHTS,
            SPEEDS,
            SPEEDS,
            SPEEDS,
            (-180.0, 180.0),
            (-90.0, 90.0),
            (-180.0, 360.0),
        ],
        keys: "separator = \"blanks\"
header = 0
time = { col = 2 }
latitude = { col = 3 }
longitude = { col = 4 }
height = { col = 5 }
north = { col = 6 }
east = { col = 7 }
up = { col = 8, sign = -1 }
roll = { col = 9 }
pitch = { col = 10 }
heading = { col = 11 }
",
        doubt: "a table without names is taken as KF-GINS writes it: week, second, latitude, longitude, height, north, east, down, roll, pitch, yaw",
    },
    Nameless {
        name: "PSINS",
        time: 9,
        ranges: &[
            (-1.6, 1.6),
            (-3.2, 3.2),
            (-6.4, 6.4),
            SPEEDS,
            SPEEDS,
            SPEEDS,
            (-1.6, 1.6),
            (-3.2, 6.4),
            HEIGHTS,
            (0.0, 1e9),
        ],
        keys: "separator = \"blanks\"
header = 0
time = { col = 10 }
latitude = { col = 7, unit = \"rad\" }
longitude = { col = 8, unit = \"rad\" }
height = { col = 9 }
east = { col = 4 }
north = { col = 5 }
up = { col = 6 }
pitch = { col = 1, unit = \"rad\" }
roll = { col = 2, unit = \"rad\" }
heading = { col = 3, unit = \"rad\", sign = -1 }
",
        doubt: "a table without names is taken as avp of PSINS: pitch, roll, yaw to the left, east, north, up, latitude, longitude, height, time, angles in radians",
    },
];

impl Nameless {
    fn fits(&self, rows: &[Vec<f64>]) -> bool {
        let is_within = |row: &Vec<f64>| {
            row.len() == self.ranges.len()
                && row
                    .iter()
                    .zip(self.ranges)
                    .all(|(value, (least, greatest))| (*least..=*greatest).contains(value))
        };
        rows.len() >= FEWEST
            && rows.iter().all(is_within)
            && rows.windows(2).all(|pair| pair[0][self.time] < pair[1][self.time])
    }
}

/// The `[log]` of a table of numbers alone, if it is of a known format.
pub fn nameless(table: &str) -> Option<Survey> {
    let numbers = |line: &str| -> Vec<f64> {
        let row = cells(line, Separator::Blanks);
        row.iter().map(|cell| number(cell, Separator::Blanks).unwrap_or(f64::NAN)).collect()
    };
    let rows: Vec<Vec<f64>> =
        table.lines().filter(|line| !line.trim().is_empty()).take(ROWS).map(numbers).collect();
    let found = NAMELESS.iter().find(|format| format.fits(&rows))?;
    Some(Survey {
        format: Some(found.name),
        text: found.keys.to_owned(),
        doubts: vec![found.doubt.to_owned()],
        questions: Vec::new(),
    })
}

/// The `[log]` of a solution of RTKLIB: its names stand in a comment, and its times in two fields under one name.
pub fn rtklib(table: &str) -> Option<Survey> {
    const DEGREES: [&str; 3] = ["latitude(deg)", "longitude(deg)", "height(m)"];
    let mut lines = table.lines().take(ROWS);
    let names = lines.find(|line| line.starts_with('%') && DEGREES.iter().all(|name| line.contains(name)))?;
    let names: Vec<&str> = names.trim_start_matches('%').split_whitespace().collect();
    let [_, latitude, longitude, height, ..] = names[..] else { return None };
    if [latitude, longitude, height] != DEGREES {
        return None;
    }
    let row = lines.find(|line| !line.trim().is_empty() && !line.starts_with('%'))?;
    let has_two_fields = row.split_whitespace().count() == names.len() + 1;
    if !has_two_fields {
        return None;
    }
    // A date and a time of the day, or a week and its second.
    let format = if row.split_whitespace().next()?.contains('/') { "time_format = \"hms\"\n" } else { "" };
    let mut text = format!(
        "separator = \"blanks\"\ncomment = \"%\"\nheader = 0\ntime = {{ col = 2 }}\n{format}latitude = {{ col = 3 }}\nlongitude = {{ col = 4 }}\nheight = {{ col = 5 }}\n"
    );
    let velocity =
        ["vn(m/s)", "ve(m/s)", "vu(m/s)"].map(|name| names.iter().position(|other| *other == name));
    if let [Some(north), Some(east), Some(up)] = velocity {
        let keys = [("north", north), ("east", east), ("up", up)];
        text.extend(keys.map(|(key, place)| format!("{key} = {{ col = {} }}\n", place + 2)));
    }
    text += "smooth = \"auto\"\nattitude = \"coordinated\"\n";
    let doubt = "it has no attitude, so that of a coordinated flight is taken".to_owned();
    Some(Survey { format: Some("RTKLIB solution"), text, doubts: vec![doubt], questions: Vec::new() })
}

#[cfg(test)]
mod tests {
    use super::super::survey::tests::read;

    /// Three rows each at 48° north and 11° east, at 300 m, with 50 m/s to the north, climbing, banked to the right, a little to the east.
    const SAMPLES: [(&str, &str); 2] = [
        (
            "KF-GINS",
            "    2017 456300.000   48.000000000   11.0000000000    300.000   50.0    0.0   -1.0    5.0    2.0    3.0\n\
                 2017 456300.100   48.000045000   11.0000000000    300.100   50.0    0.0   -1.0    5.0    2.0    3.0\n\
                 2017 456300.200   48.000090000   11.0000000000    300.200   50.0    0.0   -1.0    5.0    2.0    3.0\n",
        ),
        (
            "PSINS",
            "3.4906585e-02 8.7266463e-02 -5.2359878e-02 0.0 50.0 1.0 8.37758041e-01 1.91986218e-01 300.0 0.0\n\
             3.4906585e-02 8.7266463e-02 -5.2359878e-02 0.0 50.0 1.0 8.37758826e-01 1.91986218e-01 300.1 0.1\n\
             3.4906585e-02 8.7266463e-02 -5.2359878e-02 0.0 50.0 1.0 8.37759612e-01 1.91986218e-01 300.2 0.2\n",
        ),
    ];

    #[test]
    fn a_known_table_without_names_is_recognized_and_read() {
        for (name, table) in SAMPLES {
            let (survey, log) = read(table);
            assert_eq!(survey.format, Some(name), "{survey:?}");
            assert_eq!(log.samples().len(), 3, "{name}");
            let sample = log.samples()[0];
            let [latitude, longitude] =
                [sample.place.latitude_rad, sample.place.longitude_rad].map(f64::to_degrees);
            assert!((latitude - 48.0).abs() < 1e-6 && (longitude - 11.0).abs() < 1e-6, "{name}: {sample:?}");
            assert_eq!(
                (sample.place.height_m, sample.v_n.unwrap().into()),
                (300.0, [0.0, 50.0, 1.0]),
                "{name}"
            );
            let angles = [sample.euler.roll, sample.euler.pitch, sample.euler.heading].map(f64::to_degrees);
            for (angle, expected) in angles.into_iter().zip([5.0, 2.0, 3.0]) {
                assert!((angle - expected).abs() < 1e-5, "{name}: {angles:?}");
            }
        }
    }

    /// Another number of columns, a latitude beyond the pole, and times that stand still.
    #[test]
    fn other_numbers_are_of_no_known_format() {
        let (_, table) = SAMPLES[0];
        for (from, to) in [("48.000045", "98.000045"), ("456300.100", "456300.000"), ("5.0    2.0", "2.0")] {
            assert!(super::nameless(&table.replacen(from, to, 1)).is_none(), "{to}");
        }
    }

    #[test]
    fn a_solution_of_rtklib_has_its_names_in_a_comment() {
        let names = "% program   : made up\n%  GPST  latitude(deg) longitude(deg)  height(m)   Q  ns";
        for (more, times, cells) in [
            ("", ["2024/05/01 23:59:59.800", "2024/05/02 00:00:00.000"], ""),
            ("  vn(m/s) ve(m/s) vu(m/s)", ["2312 345599.800", "2312 345600.000"], " 50 0 1"),
        ] {
            let [first, second] = times;
            let table = format!(
                "{names}{more}\n{first}  48.0 11.0 300.0 1 12{cells}\n{second}  48.00009 11.0 300.2 1 12{cells}\n"
            );
            let (found, log) = read(&table);
            assert_eq!(found.format, Some("RTKLIB solution"));
            let sample = log.samples()[1];
            assert!((log.duration_s() - 0.2).abs() < 1e-6, "{found:?}");
            assert!((sample.place.latitude_rad.to_degrees() - 48.00009).abs() < 1e-9, "{sample:?}");
            assert_eq!(sample.place.height_m, 300.2);
            assert_eq!(sample.v_n.map(Into::into), (!cells.is_empty()).then_some([0.0, 50.0, 1.0]));
        }
    }
}
