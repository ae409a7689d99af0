//! A flight log of the user: the columns that `sins_harness flight` takes.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use csv::{ReaderBuilder, StringRecord, Trim};
use nalgebra::Vector3;
use sins::earth::Geodetic;
use sins::math::Euler;
use sins::truth::FlightSample;

use crate::failure::Failure;

/// Quantities as the harness names them; an angle may be in degrees.
const QUANTITIES: [&str; 17] = [
    "time_s",
    "latitude_rad",
    "longitude_rad",
    "height_m",
    "roll_rad",
    "pitch_rad",
    "heading_rad",
    "velocity_east_m_s",
    "velocity_north_m_s",
    "velocity_up_m_s",
    "rate_x_rad_s",
    "rate_y_rad_s",
    "rate_z_rad_s",
    "force_x_m_s2",
    "force_y_m_s2",
    "force_z_m_s2",
    "temperature_c",
];

/// First of the triples that a log may leave out.
const VELOCITY: usize = 7;
const RATE: usize = 10;
const FORCE: usize = 13;
const TEMPERATURE: usize = 16;

/// Where a quantity stands in a row, and its unit.
#[derive(Clone, Copy)]
struct Column {
    place: usize,
    unit: f64,
}

/// The samples of the log at `path`, two at the least.
pub fn read(path: &Path) -> Result<Vec<FlightSample>, Failure> {
    let input =
        File::open(path).map_err(|error| Failure::of_file(path, &format!("cannot be read: {error}")))?;
    samples(path, input)
}

/// What the log at `path` is called: the file without its ending.
pub fn name(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

fn samples(path: &Path, input: impl Read) -> Result<Vec<FlightSample>, Failure> {
    let mut reader =
        ReaderBuilder::new().comment(Some(b'#')).flexible(true).trim(Trim::All).from_reader(input);
    let header = reader.headers().map_err(|error| Failure::of_file(path, &error))?.clone();
    let columns = QUANTITIES.map(|quantity| column(&header, quantity));
    for (k, name) in QUANTITIES.iter().enumerate() {
        // Of a triple all or none; a temperature stands alone.
        let first = VELOCITY + k.saturating_sub(VELOCITY) / 3 * 3;
        let last = (first + 3).min(QUANTITIES.len());
        if columns[k].is_none() && (k < VELOCITY || columns[first..last].iter().any(Option::is_some)) {
            return Err(Failure::of_file(path, &format!("expected a column \"{name}\" in the header")));
        }
    }
    let mut samples: Vec<FlightSample> = Vec::new();
    let mut row = StringRecord::new();
    while reader.read_record(&mut row).map_err(|error| Failure::of_file(path, &error))? {
        let line = row.position().map_or(0, csv::Position::line);
        let mut values = [0.0; QUANTITIES.len()];
        for (k, column) in columns.iter().enumerate() {
            let Some(Column { place, unit }) = column else { continue };
            let text = row.get(*place).unwrap_or_default();
            match text.parse::<f64>() {
                Ok(value) if value.is_finite() => values[k] = value * unit,
                _ => {
                    let what = format!("{}: expected a finite number, found \"{text}\"", QUANTITIES[k]);
                    return Err(Failure::of_line(path, line, &what));
                }
            }
        }
        samples.push(sample(&values, &columns));
    }
    match samples.as_slice() {
        [first, .., last] if last.time_s > first.time_s => Ok(samples),
        _ => Err(Failure::of_file(path, &"expected samples in the order of time")),
    }
}

fn column(header: &StringRecord, quantity: &str) -> Option<Column> {
    let degrees = quantity.strip_suffix("_rad").map(|stem| format!("{stem}_deg"));
    header.iter().enumerate().find_map(|(place, name)| {
        let name = name.trim_start_matches('\u{feff}');
        if name == quantity {
            return Some(Column { place, unit: 1.0 });
        }
        (Some(name) == degrees.as_deref()).then_some(Column { place, unit: std::f64::consts::PI / 180.0 })
    })
}

fn sample(values: &[f64; QUANTITIES.len()], columns: &[Option<Column>; QUANTITIES.len()]) -> FlightSample {
    let triple = |first: usize| {
        columns[first].map(|_| Vector3::new(values[first], values[first + 1], values[first + 2]))
    };
    let [time_s, latitude_rad, longitude_rad, height_m, roll, pitch, heading, ..] = *values;
    FlightSample {
        time_s,
        place: Geodetic { latitude_rad, longitude_rad, height_m },
        v_n: triple(VELOCITY),
        euler: Euler { roll, pitch, heading },
        omega_ib_b: triple(RATE),
        f_b: triple(FORCE),
        temperature_c: columns[TEMPERATURE].map(|_| values[TEMPERATURE]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "time_s, latitude_deg,longitude_rad,height_m,roll_rad,pitch_rad,heading_deg";

    fn parsed(text: &str) -> Result<Vec<FlightSample>, String> {
        samples(Path::new("log.csv"), text.as_bytes()).map_err(|failure| failure.to_string())
    }

    #[test]
    fn degrees_comments_and_columns_of_others() {
        let text =
            format!("# a flight\n{HEADER},wind\n0,45,0.1,100,0,0,90,7\n# later\n1, 45,0.2,100,0,0,90,x\n");
        let samples = parsed(&text).unwrap();
        assert_eq!(samples.len(), 2);
        assert!((samples[0].place.latitude_rad - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
        assert_eq!((samples[1].place.longitude_rad, samples[1].v_n), (0.2, None));
    }

    #[test]
    fn triples_come_whole() {
        let velocity = "velocity_east_m_s,velocity_north_m_s,velocity_up_m_s";
        let text = format!("{HEADER},{velocity}\n0,45,0,0,0,0,0,1,2,3\n1,45,0,0,0,0,0,1,2,3\n");
        assert_eq!(parsed(&text).unwrap()[0].v_n, Some(Vector3::new(1.0, 2.0, 3.0)));
        let failure = parsed(&text.replace("velocity_up_m_s", "up")).unwrap_err();
        assert!(failure.contains("velocity_up_m_s"), "{failure}");
    }

    #[test]
    fn bad_logs_are_told() {
        let failure = parsed(&format!("{HEADER}\n0,45,0,0,0,0,0\n1,north,0,0,0,0,0\n")).unwrap_err();
        assert!(failure.contains("line 3") && failure.contains("\"north\""), "{failure}");
        assert!(parsed(&HEADER.replace("height_m", "h")).unwrap_err().contains("height_m"));
        assert!(parsed(&format!("{HEADER}\n0,45,0,0,0,0,0\n")).unwrap_err().contains("order of time"));
    }
}
