//! The rows of a log: values, samples.

use core::f64::consts::TAU;

use csv::StringRecord;
use nalgebra::{Quaternion, Vector3};

use super::clock::Clock;
use super::column::SIXTIETHS;
use super::columns::{COUNT, Column, Columns, has, has_quaternion};
use super::hemisphere::{sides, signed};
use super::marks::DecimalMarks;
use super::quantity::{
    FORCE, FORWARD, GEOID, HEADING, LATITUDE, Q0, RATE, ROLL, SPEED, TEMPERATURE, TRACK, VARIATION, VELOCITY,
    name, quantity_of,
};
use super::{LogError, LogMapping, Separator, fault};
use crate::base::error::{Error, check_range};
use crate::base::math::{Euler, attitude_from_euler, euler_from_attitude, rotate, sin_cos};
use crate::base::text::{Fault, excerpt};
use crate::base::units::DEG;
use crate::earth::Geodetic;
use crate::truth::FlightSample;

/// What the rows have in common.
pub struct Table<'m> {
    pub columns: Columns,
    pub mapping: &'m LogMapping,
    /// Whether the log is read by a mapping: cells may then be missing.
    pub is_mapped: bool,
    pub clock: Clock,
    pub marks: DecimalMarks,
}

/// The cells of a row.
#[derive(Clone, Copy)]
pub enum Cells<'r> {
    Texts(&'r StringRecord),
    /// In the units that the names of the columns state.
    Numbers(&'r [f64]),
}

impl Table<'_> {
    /// The sample of a row, with each value in its range; `None`: a value is missing. Where a path is fitted to a log with an attitude, a
    /// row without a fix repeats that of `last`, the row before, so that its attitude counts.
    pub fn sample(
        &mut self,
        cells: &Cells<'_>,
        line: u64,
        last: Option<&FlightSample>,
    ) -> Result<Option<FlightSample>, LogError> {
        let before = last.map(|last| last.euler);
        let last = last.filter(|_| self.mapping.smooths() && !self.mapping.is_coordinated);
        let mut has_fix = true;
        let mut values = [0.0; COUNT];
        // A row without times has the next one, whatever is missing.
        let mut is_whole = true;
        if self.columns[0].is_none() {
            values[0] = self.clock.next("").unwrap_or_default();
        }
        for (quantity, column) in self.columns.iter().enumerate() {
            let Some(column) = column else { continue };
            let Some(place) = column.place else {
                values[quantity] = column.offset;
                continue;
            };
            let is_time = quantity == 0;
            let number = match cells {
                Cells::Numbers(numbers) => {
                    let number = numbers.get(place).copied();
                    number.filter(|number| self.mapping.missing != Some(*number))
                }
                Cells::Texts(row) => {
                    let (mapping, clock) = (self.mapping, is_time.then_some(&mut self.clock));
                    let has_marks = mapping.separator != Separator::Comma
                        && column.part == 0
                        && clock.as_ref().is_none_or(|clock| clock.is_number());
                    let number =
                        number_of(row, line, (quantity, column, place), mapping, self.is_mapped, clock)?;
                    if let Some(text) = row.get(place).filter(|_| has_marks && number.is_some()) {
                        self.marks.see(quantity, text, line, place);
                    }
                    number
                }
            };
            let Some(number) = number else {
                match is_of_fix(quantity) && last.is_some() {
                    true => has_fix = false,
                    false => is_whole = false,
                }
                continue;
            };
            let factor = if is_time && !self.clock.is_number() { 1.0 } else { column.factor };
            values[quantity] = number * factor;
            // Without an offset a value keeps its bits, also -0.
            if column.offset != 0.0 {
                values[quantity] += column.offset;
            }
        }
        // So an attitude is written before there is one.
        let is_null = has_quaternion(&self.columns) && values[Q0..Q0 + 4].iter().all(|part| *part == 0.0);
        if !is_whole || is_null {
            return Ok(None);
        }
        let mut sample = self.of_values(&values);
        if let Some(last) = last.filter(|_| !has_fix) {
            (sample.place, sample.v_n) = (last.place, last.v_n);
        }
        let is_on_earth = || check_range("sample.longitude_rad", sample.place.longitude_rad, -TAU, TAU);
        let checked = sample.validate().and_then(|()| if self.is_mapped { is_on_earth() } else { Ok(()) });
        let checked = checked.and_then(|()| check_angles(&sample.euler, before.as_ref()));
        checked.map_err(|error| match (out_of_range(&error, line, &self.columns), cells) {
            // A record has no columns.
            (LogError::Fault(found), Cells::Numbers(_)) => LogError::Fault(Fault { column: 1, ..found }),
            (found, _) => found,
        })?;
        Ok(Some(sample))
    }

    fn of_values(&self, values: &[f64; COUNT]) -> FlightSample {
        let columns = &self.columns;
        let three = |first: usize| Vector3::new(values[first], values[first + 1], values[first + 2]);
        let triple = |first: usize| columns[first].as_ref().map(|_| three(first));
        let &[time_s, latitude_rad, longitude_rad, mut height_m, roll, pitch, mut heading, ..] = values;
        let variation_rad = values[VARIATION];
        if columns[GEOID].is_some() {
            height_m += values[GEOID];
        }
        let euler = if has_quaternion(columns) {
            // Forward-right-down to north-east-down is right-forward-up to east-north-up with x and y exchanged, and z reversed.
            let [w, x, y, z] = [0, 1, 2, 3].map(|index| values[Q0 + index]);
            euler_from_attitude(&Quaternion::new(w, y, x, -z).normalize())
        } else {
            if columns[VARIATION].is_some() {
                heading += variation_rad;
            }
            Euler { roll, pitch, heading }
        };
        let v_n = if has(columns, SPEED..FORWARD) {
            let magnetic_rad = if self.mapping.is_track_magnetic { variation_rad } else { 0.0 };
            let (sine, cosine) = sin_cos(values[TRACK] + magnetic_rad);
            let speed = values[SPEED];
            Some(Vector3::new(speed * sine, speed * cosine, values[SPEED + 2]))
        } else if has(columns, FORWARD..Q0) {
            let [forward, right, down] = three(FORWARD).into();
            Some(rotate(&attitude_from_euler(&euler), &Vector3::new(right, forward, -down)))
        } else {
            triple(VELOCITY)
        };
        FlightSample {
            time_s,
            place: Geodetic { latitude_rad, longitude_rad, height_m },
            v_n,
            euler,
            omega_ib_b: triple(RATE),
            f_b: triple(FORCE),
            temperature_c: columns[TEMPERATURE].as_ref().map(|_| values[TEMPERATURE]),
        }
    }
}

/// The number of a quantity in a row of texts, whose column is at `place`; `None`: the value is missing. Times have the clock.
pub fn number_of(
    row: &StringRecord,
    line: u64,
    (quantity, column, place): (usize, &Column, usize),
    mapping: &LogMapping,
    is_mapped: bool,
    clock: Option<&mut Clock>,
) -> Result<Option<f64>, LogError> {
    let name = &column.name;
    let Some(text) = row.get(place) else {
        return Err(fault(line, place + 1, format!("the line ends before {name}")));
    };
    let Some(text) = part_of(text, column.part) else {
        let sentence = format!("{name}: expected {} parts, found \"{}\"", column.part, excerpt(text));
        return Err(fault(line, place + 1, sentence));
    };
    let letter = column.hemisphere.map(|place| (place, row.get(place).unwrap_or_default()));
    let has_no_letter = letter.is_some_and(|(_, letter)| is_missing(letter, None));
    if is_mapped && (is_missing(text, mapping.missing) || has_no_letter) {
        return Ok(None);
    }
    let separator = mapping.separator;
    let (number, what) = match (clock, sides(quantity)) {
        (Some(clock), _) => (clock.next(&separator.with_point(text)), clock.expected()),
        (None, Some(sides)) => {
            let signed = signed((place, text), letter, sides, separator)
                .map_err(|(place, sentence)| fault(line, place + 1, format!("{name}: {sentence}")))?;
            (signed, "a finite number")
        }
        (None, None) => (number(text, separator), "a finite number"),
    };
    if number.is_none() {
        let hint = if text.contains(',') { COMMA_HINT } else { "" };
        let sentence = format!("{name}: expected {what}, found \"{}\"{hint}", excerpt(text));
        return Err(fault(line, place + 1, sentence));
    }
    if column.sixtieths[0].is_some() {
        return number.map_or(Ok(None), |degrees| with_sixtieths(degrees, row, line, column, mapping));
    }
    if !column.is_ddmm {
        return Ok(number);
    }
    let degrees = number.and_then(of_degrees_and_minutes);
    let refused = || format!("{name}: expected degrees and minutes, as 4718.25, found \"{}\"", excerpt(text));
    degrees.ok_or_else(|| fault(line, place + 1, refused())).map(Some)
}

/// Degrees with their minutes and seconds in other columns; `None`: one is missing.
fn with_sixtieths(
    degrees: f64,
    row: &StringRecord,
    line: u64,
    column: &Column,
    mapping: &LogMapping,
) -> Result<Option<f64>, LogError> {
    let name = &column.name;
    let mut size = degrees.abs();
    // What is divided further is whole.
    let mut above = (size, "degrees");
    for (place, (part, what)) in column.sixtieths.iter().zip([(60.0, SIXTIETHS[0]), (3600.0, SIXTIETHS[1])]) {
        let Some(place) = *place else { continue };
        let text = row.get(place).unwrap_or_default();
        if is_missing(text, mapping.missing) {
            return Ok(None);
        }
        if above.0.fract() != 0.0 {
            let sentence = format!("{name}: expected whole {} beside {what}, found {}", above.1, above.0);
            return Err(fault(line, place + 1, sentence));
        }
        // Each part may have the sign of all, and rounding writes 60 too.
        let value = number(text, mapping.separator);
        let value = value.map(|value| if degrees.is_sign_negative() { value.abs() } else { value });
        let Some(value) = value.filter(|value| (0.0..=60.0).contains(value)) else {
            let sentence = format!("{name}: expected {what} from 0 to 60, found \"{}\"", excerpt(text));
            return Err(fault(line, place + 1, sentence));
        };
        size += value / part;
        above = (value, what);
    }
    // -0 degrees are negative too.
    Ok(Some(size.copysign(degrees)))
}

/// Degrees from degrees and minutes, as 4718.25; `None`: there are 60 minutes or more.
pub fn of_degrees_and_minutes(number: f64) -> Option<f64> {
    let degrees = (number / 100.0).trunc();
    let minutes = number - 100.0 * degrees;
    (minutes.abs() < 60.0).then_some(degrees + minutes / 60.0)
}

/// Whether a quantity is one of a fix: of the position or of the velocity.
fn is_of_fix(quantity: usize) -> bool {
    (LATITUDE..ROLL).contains(&quantity)
        || (VELOCITY..VELOCITY + 3).contains(&quantity)
        || (SPEED..FORWARD).contains(&quantity)
}

/// Largest pitch, with its rounding, and largest roll and heading of the first row, which may have gone on beyond turns \[rad\].
const STEEPEST: f64 = 90.5 * DEG;
const BEGINS_AT_MOST: f64 = 10.0 * TAU;

/// Largest step of such an angle \[rad\]: a turn, as over north, with noise.
const STEPS_AT_MOST: f64 = 1.25 * TAU;

/// What stands in a cell without a value.
const NOTHING: [&str; 10] = ["", "nan", "-nan", "na", "n/a", "#n/a", "null", "none", "-", "--"];

/// What to do about a comma in a number.
const COMMA_HINT: &str =
    "; write decimals behind a point and no marks between thousands, or set log.separator";

/// Whether a cell has no value.
pub fn is_missing(text: &str, missing: Option<f64>) -> bool {
    let is_it = |missing: f64| text.parse::<f64>().is_ok_and(|number| number == missing);
    NOTHING.iter().any(|nothing| text.eq_ignore_ascii_case(nothing)) || missing.is_some_and(is_it)
}

/// Part `part` of a cell, from 1, or with 0 the whole cell; of a cell without a value the whole too. Parts stand between semicolons, blanks
/// or commas: the first of these that the cell has.
pub fn part_of(text: &str, part: usize) -> Option<&str> {
    let Some(index) = part.checked_sub(1).filter(|_| !is_missing(text, None)) else { return Some(text) };
    let part = if text.contains(';') {
        text.split(';').nth(index)
    } else if text.contains(char::is_whitespace) {
        text.split_whitespace().nth(index)
    } else {
        text.split(',').nth(index)
    };
    part.map(|part| part.trim().trim_end_matches(','))
}

/// The number in a cell.
pub fn number(text: &str, separator: Separator) -> Option<f64> {
    separator.with_point(text).parse().ok().filter(|number: &f64| number.is_finite())
}

/// A value out of its range: its column and its limits in the unit of the column.
fn out_of_range(error: &Error, line: u64, columns: &Columns) -> LogError {
    let quantity = quantity_of(error);
    let column = quantity.and_then(|index| Some((index, columns[index].as_ref()?)));
    let Some((quantity, column)) = column else {
        return fault(line, 1, error.to_string());
    };
    let own = Error { field: name(quantity), index: None, ..*error };
    let mut sentence = if column.name == name(quantity) {
        own.to_string()
    } else if column.offset == 0.0 && column.factor > 0.0 {
        own.in_unit(column.factor).sentence_about(&column.name)
    } else {
        own.sentence_about(&column.name)
    };
    if (ROLL..=HEADING).contains(&quantity) {
        sentence += "; a number that stands for a missing value is left out by log.missing";
    }
    fault(line, column.place.map_or(1, |place| place + 1), sentence)
}

/// Checks that angles are those of an attitude: roll and heading may go on beyond a turn, and no row jumps much farther.
fn check_angles(now: &Euler, before: Option<&Euler>) -> Result<(), Error> {
    check_range("sample.pitch_rad", now.pitch, -STEEPEST, STEEPEST)?;
    for (field, of) in [
        ("sample.roll_rad", (|euler| euler.roll) as fn(&Euler) -> f64),
        ("sample.heading_rad", |euler| euler.heading),
    ] {
        let most = if before.is_some() { STEPS_AT_MOST } else { BEGINS_AT_MOST };
        if (of(now) - before.map_or(0.0, of)).abs() > most {
            check_range(field, of(now), -TAU, TAU)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::{FlightLog, LogError};
    use super::*;
    use crate::scene::Scene;

    /// Numbers that stand for a missing angle, which would turn the vehicle; angles that go on beyond a turn are none.
    #[test]
    fn angles_that_are_none_are_refused_at_their_cell() {
        let read = |missing: &str, cell: &dyn Fn(usize) -> [f64; 3]| {
            let names = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n";
            let row = |k: usize| {
                let [roll, pitch, heading] = cell(k);
                format!("{k},47,8,0,{roll},{pitch},{heading}\n")
            };
            let table = names.to_owned() + &(0..40).map(row).collect::<String>();
            let scene = format!("[flight]\nfile = \"a.csv\"\n[log]\n{missing}");
            FlightLog::parse_with(table.as_bytes(), &Scene::parse(scene.as_bytes()).unwrap().log)
        };
        let turning = |k: usize| [400.0 + 90.0 * k as f64, 0.0, 720.0 - 200.0 * k as f64];
        assert!(read("", &turning).is_ok());
        assert!(read("", &|k| [0.0, 0.0, if k % 2 == 0 { -0.4 } else { 360.3 }]).is_ok());
        for (column, mark) in [(5, -9999.0), (5, 999.9), (6, -9999.0), (6, 90.6), (7, 32767.0), (7, -999.0)] {
            let cell =
                |k: usize| core::array::from_fn(|of| if k == 20 && of + 5 == column { mark } else { 3.0 });
            let Err(LogError::Fault(fault)) = read("", &cell) else { panic!("{mark} flies") };
            assert!((fault.line, fault.column) == (22, column), "{fault:?}");
            assert!(
                fault.sentence.contains("must be from") && fault.sentence.contains("log.missing"),
                "{fault:?}"
            );
            assert_eq!(read(&format!("missing = {mark}\n"), &cell).unwrap().samples().len(), 39);
        }
    }

    #[test]
    fn a_cell_has_parts() {
        for text in ["48.1,11.5,x", "48.1, 11.5, x", "48.1 11.5 x", "48.1; 11.5 ;x"] {
            let parts = [1, 2, 3, 4].map(|part| part_of(text, part));
            assert_eq!(parts, [Some("48.1"), Some("11.5"), Some("x"), None], "{text}");
            assert_eq!(part_of(text, 0), Some(text));
        }
        assert_eq!(part_of("N/A", 2), Some("N/A"));
    }

    /// An attitude between two fixes counts where a path is fitted, and not before the first fix.
    #[test]
    fn an_attitude_without_a_fix_is_read() {
        let read = |keys: &str| {
            let scene =
                Scene::parse(format!("[flight]\nfile = \"a.csv\"\n[log]\n{keys}").as_bytes()).unwrap();
            let table = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n\
                0,,,,1,0,0\n1,48,11,500,2,0,0\n2,,,,3,0,0\n3,48,,500,4,0,0\n4,48,11,501,5,0,0\n5,48,11,501,,0,0\n";
            let log = FlightLog::parse_with(table.as_bytes(), &scene.log).unwrap();
            let rolls = log.samples().iter().map(|sample| sample.euler.roll.to_degrees().round() as u32);
            (rolls.collect::<Vec<_>>(), log.samples()[1].place.height_m, log.notes()[0].sentence.clone())
        };
        let (rolls, height_m, note) = read("roll = \"roll_deg\"\nsmooth = \"auto\"\n");
        assert_eq!((rolls, height_m), (vec![2, 3, 4, 5], 500.0));
        assert_eq!(note, "2 rows are left out, the first here: a value is missing");
        let (rolls, ..) = read("roll = \"roll_deg\"\n");
        assert_eq!(rolls, [2, 5]);
    }

    #[test]
    fn a_row_whose_quaternion_is_zero_has_no_attitude() {
        let text = "[flight]\nfile = \"a.csv\"\n[log]\ntime = \"t\"\nlatitude = 48\nlongitude = 11\nheight = 0\n\
            q0 = \"a\"\nq1 = \"b\"\nq2 = \"c\"\nq3 = \"d\"\n";
        let scene = Scene::parse(text.as_bytes()).unwrap();
        let table = "t,a,b,c,d\n0,0,0,0,0\n1,0,0,0.0,-0\n2,1,0,0,0\n3,0,0,0,1\n";
        let log = FlightLog::parse_with(table.as_bytes(), &scene.log).unwrap();
        assert_eq!(log.samples().len(), 2);
        assert_eq!(log.notes()[0].sentence, "2 rows are left out, the first here: a value is missing");
    }

    #[test]
    fn a_position_in_one_cell_is_read() {
        let text = "[flight]\nfile = \"a.csv\"\n[log]\ntime = \"t\"\nlatitude = { col = \"at\", part = 1 }\n\
            longitude = { col = \"at\", part = 2 }\nheight = 0\nroll = 0\npitch = 0\nheading = 0\n";
        let scene = Scene::parse(text.as_bytes()).unwrap();
        assert_eq!(Scene::parse(scene.write().as_bytes()).unwrap().log, scene.log);
        let read = |cells: [&str; 3]| {
            let rows: String = cells.iter().zip(0..).map(|(cell, t)| format!("{t},\"{cell}\"\n")).collect();
            FlightLog::parse_with(format!("t,at\n{rows}").as_bytes(), &scene.log)
        };
        let log = read(["48.1,11.5", "", "33.5S 11.5W"]).unwrap();
        let places = [0, 1].map(|row| log.samples()[row].place);
        let degrees = places.map(|place| [place.latitude_rad, place.longitude_rad].map(f64::to_degrees));
        for (found, expected) in degrees.as_flattened().iter().zip([48.1, 11.5, -33.5, -11.5]) {
            assert!((found - expected).abs() < 1e-12, "{degrees:?}");
        }
        assert_eq!(log.notes()[0].sentence, "1 row is left out, the first here: a value is missing");
        let Err(LogError::Fault(fault)) = read(["48.1,11.5", "48.1", "48.1,11.5"]) else { panic!() };
        assert_eq!(
            (fault.line, fault.column, fault.sentence.as_str()),
            (3, 2, "at: expected 2 parts, found \"48.1\"")
        );
        for part in ["0", "101", "\"1\""] {
            let text = text.replace("part = 1", &format!("part = {part}"));
            let sentence = Scene::parse(text.as_bytes()).unwrap_err()[0].sentence.clone();
            assert!(
                sentence.contains("log.latitude.part: expected a part of a cell, from 1 to 100"),
                "{sentence}"
            );
        }
    }
}
