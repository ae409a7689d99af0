//! Decimal points and commas in one table.

use super::columns::{COUNT, Columns};
use super::{LogError, fault};
use crate::base::text::excerpt;

/// What the numbers of a column have.
#[derive(Debug, Clone, PartialEq)]
enum Marks {
    None,
    /// Each mark may stand between thousands: the mark, line, place and text of the first.
    Open(char, u64, usize, String),
    Decimals,
}

/// The marks in the numbers of a table in which decimals may follow a comma or a point.
#[derive(Debug)]
pub struct DecimalMarks {
    of_columns: [Marks; COUNT],
    has_points: bool,
    has_commas: bool,
}

impl DecimalMarks {
    pub fn new() -> Self {
        Self { of_columns: [const { Marks::None }; COUNT], has_points: false, has_commas: false }
    }

    /// Takes a number of a quantity.
    pub fn see(&mut self, quantity: usize, text: &str, line: u64, place: usize) {
        let mut marks = text.chars().filter(|letter| matches!(letter, '.' | ','));
        let (Some(mark), None) = (marks.next(), marks.next()) else { return };
        let own = &mut self.of_columns[quantity];
        if !is_between_thousands(text, mark) {
            *own = Marks::Decimals;
            *if mark == ',' { &mut self.has_commas } else { &mut self.has_points } = true;
        } else if *own == Marks::None {
            *own = Marks::Open(mark, line, place, excerpt(text));
        }
    }

    /// Refuses a column whose marks all may stand between thousands, where other columns have the other mark before decimals.
    pub fn check(&self, columns: &Columns) -> Result<(), LogError> {
        for (marks, column) in self.of_columns.iter().zip(columns) {
            let (Marks::Open(mark, line, place, text), Some(column)) = (marks, column) else { continue };
            let (is_other, other) =
                if *mark == ',' { (self.has_points, "points") } else { (self.has_commas, "commas") };
            if is_other {
                let sentence = format!(
                    "{}: does the mark in {text} stand between thousands? Other columns have decimal {other}: leave marks between thousands out",
                    column.name
                );
                return Err(fault(*line, place + 1, sentence));
            }
        }
        Ok(())
    }
}

/// Whether a number is as 38,000: one to three digits that begin with no zero, and three behind the mark.
fn is_between_thousands(text: &str, mark: char) -> bool {
    let Some((before, behind)) = text.trim_start_matches(['+', '-']).split_once(mark) else { return false };
    let are_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    (1..=3).contains(&before.len())
        && behind.len() == 3
        && !before.starts_with('0')
        && are_digits(before)
        && are_digits(behind)
}

#[cfg(test)]
mod tests {
    use super::super::{FlightLog, LogError};
    use crate::scene::Scene;

    #[test]
    fn marks_between_thousands_are_refused_and_decimals_read() {
        let read = |separator: &str, rows: [&str; 2]| {
            let text = format!(
                "[flight]\nfile = \"a.csv\"\n[log]\nseparator = \"{separator}\"\ntime = \"t\"\nlatitude = \"lat\"\nlongitude = 8\nheight = \"alt\"\nroll = 0\npitch = 0\nheading = 0\n"
            );
            let scene = Scene::parse(text.as_bytes()).unwrap();
            let rows: String = rows.iter().map(|row| row.to_string() + "\n").collect();
            let table = format!("t lat alt\n{rows}");
            let table = table.replace(' ', if separator == "tab" { "\t" } else { ";" });
            FlightLog::parse_with(table.as_bytes(), &scene.log)
        };
        for (separator, rows, column, words) in [
            ("tab", ["0 47.5 38,000", "1 47.50001 38,003"], 3, "alt: does the mark in 38,000 stand between"),
            (
                "semicolon",
                ["0 47,5 900", "1 47,50001 11.800"],
                3,
                "alt: does the mark in 11.800 stand between",
            ),
            ("semicolon", ["1.000 47,5 9", "2.000 47,50001 9"], 1, "t: does the mark in 1.000 stand between"),
        ] {
            let Err(LogError::Fault(fault)) = read(separator, rows) else { panic!("{words}") };
            assert!(fault.column == column && fault.sentence.starts_with(words), "{fault:?}");
        }
        // One mark for all; a column of decimals beside another mark; zeros before the mark.
        for (rows, height_m) in [
            (["0 47,5 380,125", "1 47,50001 380,126"], 380.125),
            (["0 47.5 380.125", "1 47.50001 380.126"], 380.125),
            (["0 47.50001 380,125", "1 47.50002 380,5"], 380.125),
            (["0 47.50001 0,125", "1 47.50002 -0,250"], 0.125),
        ] {
            let log = read("semicolon", rows).unwrap();
            assert_eq!(log.samples()[0].place.height_m, height_m, "{rows:?}");
        }
    }
}
