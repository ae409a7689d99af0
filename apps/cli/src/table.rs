//! A CSV file of numbers with a header, by column.

use std::io::Read;
use std::path::{Path, PathBuf};

use csv::{ReaderBuilder, StringRecord};
use sins::log::{Clock, MAX_COLUMNS};
use sins::scene::listed;

use crate::failure::Failure;
use crate::lines::{Lines, Numbers};

/// Largest magnitude of a number. Larger numbers would overflow in the computation of a page; no measured or simulated value is
/// near.
const LARGEST: f64 = 1e30;

/// Smallest magnitude of a number. Smaller numbers are read as zero, because their squares and quotients would be no numbers.
const SMALLEST: f64 = 1e-60;

/// The number of a text, if a page can show it.
pub fn number(text: &str) -> Option<f64> {
    let value = text.trim().parse::<f64>().ok().filter(|value| value.abs() <= LARGEST)?;
    Some(if value.abs() < SMALLEST { 0.0 } else { value })
}

/// The columns of a file.
pub struct Table {
    path: PathBuf,
    columns: Vec<(String, Vec<f64>)>,
    rows: usize,
    /// Numbers of the rows of the file that were left out, from 1.
    left_out: Vec<usize>,
    lines: Numbers,
}

/// The columns of a header that are wanted: their names, and the one that has times, with its reader.
#[derive(Default)]
pub struct Chosen {
    pub names: Vec<String>,
    pub clock: Option<(String, Clock)>,
    /// Rows in which a value is missing are left out, unless they are most: each row has its own time.
    pub may_have_holes: bool,
    /// Largest number of rows; `None`: any.
    pub most: Option<usize>,
}

/// Whether a field has no value.
fn is_missing(text: &str) -> bool {
    let text = text.trim();
    text.is_empty() || text.eq_ignore_ascii_case("nan")
}

impl Table {
    /// Reads all of `input`; `path` is for the errors.
    pub fn read(path: &Path, input: impl Read) -> Result<Self, Failure> {
        Self::read_some(path, input, |names| Ok(Chosen { names: names.to_vec(), ..Chosen::default() }))
    }

    /// Reads the columns that `choose` selects from the header. The contents of other columns do not matter.
    pub fn read_some(
        path: &Path,
        input: impl Read,
        choose: impl FnOnce(&[String]) -> Result<Chosen, Failure>,
    ) -> Result<Self, Failure> {
        // Flexible, so that a row of the wrong length is reported by a sentence of this program with the expected number.
        let mut reader = ReaderBuilder::new().flexible(true).from_reader(Lines::new(input));
        let header = reader.headers().map_err(|error| Failure::of_file(path, &error))?;
        if header.len() > MAX_COLUMNS {
            let what = format!("{} columns: a table has at most {MAX_COLUMNS}", header.len());
            return Err(Failure::of_line(path, 1, &what));
        }
        let names: Vec<String> =
            header.iter().map(|name| name.trim_start_matches('\u{feff}').trim().to_owned()).collect();
        let Chosen { names: chosen, mut clock, may_have_holes, most } = choose(&names)?;
        let is_chosen: Vec<bool> = names.iter().map(|name| chosen.contains(name)).collect();
        let timed = clock.as_ref().and_then(|(column, _)| names.iter().position(|name| name == column));
        let mut columns: Vec<(String, Vec<f64>)> = names.into_iter().map(|name| (name, Vec::new())).collect();
        let (mut rows, mut left_out) = (0, Vec::new());
        let mut first_hole = None;
        let mut row = StringRecord::new();
        while reader.read_record(&mut row).map_err(|error| Failure::of_file(path, &error))? {
            rows += 1;
            if let Some(most) = most.filter(|most| rows > *most) {
                return Err(Failure::of_file(path, &format!("more than {most} rows")));
            }
            let line = || reader.get_ref().numbers().of(rows);
            if row.len() != columns.len() {
                let what =
                    format!("expected {} columns as in the header, found {}", columns.len(), row.len());
                return Err(Failure::of_line(path, line(), &what));
            }
            if may_have_holes
                && let Some(place) = (0..row.len()).find(|&place| is_chosen[place] && is_missing(&row[place]))
            {
                first_hole.get_or_insert_with(|| {
                    let (name, text) = (&columns[place].0, &row[place]);
                    let what =
                        format!("column {} ({name}): expected a finite number, found \"{text}\"", place + 1);
                    Failure::of_line(path, line(), &what)
                });
                left_out.push(rows);
                continue;
            }
            for (place, ((name, values), text)) in columns.iter_mut().zip(&row).enumerate() {
                let is_time = timed == Some(place);
                let value = match &mut clock {
                    Some((_, clock)) if is_time => clock.next(text.trim()),
                    _ if is_chosen[place] => number(text),
                    _ => continue,
                };
                match value {
                    Some(value) => values.push(value),
                    None => {
                        let expected = match &clock {
                            Some((_, clock)) if is_time => clock.expected().to_owned(),
                            _ => format!("a finite number up to {LARGEST:e}"),
                        };
                        let what =
                            format!("column {} ({name}): expected {expected}, found \"{text}\"", place + 1);
                        return Err(Failure::of_line(path, line(), &what));
                    }
                }
            }
        }
        if let Some(hole) = first_hole.filter(|_| 2 * left_out.len() > rows) {
            return Err(hole);
        }
        rows -= left_out.len();
        let lines = reader.get_ref().numbers().clone();
        Ok(Self { path: path.to_owned(), columns, rows, left_out, lines })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of rows that were left out, and the line of the first.
    pub fn left_out(&self) -> Option<(usize, u64)> {
        self.left_out.first().map(|&first| (self.left_out.len(), self.lines.of(first)))
    }

    /// The line of a row, counted from 0, in the file.
    pub fn line(&self, row: usize) -> u64 {
        let number = |number: usize, left_out: &usize| number + usize::from(*left_out <= number);
        self.lines.of(self.left_out.iter().fold(row + 1, number))
    }

    /// Whether there is a column `name`.
    pub fn has(&self, name: &str) -> bool {
        self.columns.iter().any(|(column, _)| column == name)
    }

    /// The names of the columns, as a message can have them.
    pub fn header(&self) -> String {
        listed(self.columns.iter().map(|(name, _)| name.as_str()))
    }

    /// Takes the column `name` out of the table.
    pub fn take(&mut self, name: &str) -> Result<Vec<f64>, Failure> {
        match self.columns.iter_mut().find(|(column, _)| column == name) {
            Some((_, values)) => Ok(std::mem::take(values)),
            None => {
                let what = format!("expected a column \"{name}\" in the header, which has {}", self.header());
                Err(Failure::of_line(&self.path, 1, &what))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Table, String> {
        Table::read(Path::new("run.csv"), text.as_bytes()).map_err(|failure| failure.to_string())
    }

    #[test]
    fn columns_come_by_name() {
        let mut table = read("t,x_a,x_b,x_c\n0,1,2,3\n0.5, 1e-9 ,-2,4\n").unwrap();
        assert_eq!(table.take("t").unwrap(), [0.0, 0.5]);
        assert_eq!(table.take("x_a").unwrap(), [1.0, 1e-9]);
    }

    #[test]
    fn a_missing_column_is_named() {
        let failure = read("t,x\n0,1\n").unwrap().take("y").unwrap_err().to_string();
        assert_eq!(failure, "run.csv:1: expected a column \"y\" in the header, which has t, x");
    }

    #[test]
    fn a_bad_number_is_reported_with_line_and_column() {
        let expected = "run.csv:3: column 2 (x): expected a finite number up to 1e30, found";
        assert_eq!(read("t,x\n0,1\n1,one\n").err(), Some(format!("{expected} \"one\"")));
        assert_eq!(read("t,x\n0,1\n1,nan\n").err(), Some(format!("{expected} \"nan\"")));
        assert_eq!(read("t,x\n0,1\n1,\n").err(), Some(format!("{expected} \"\"")));
        assert_eq!(read("t,x\n0,1\n1,-1e308\n").err(), Some(format!("{expected} \"-1e308\"")));
        assert_eq!(read("t,x\n0,1\n1,5e-324\n").unwrap().take("x").unwrap(), [1.0, 0.0]);
    }

    #[test]
    fn columns_that_nobody_wants_may_hold_anything() {
        let text = "\u{feff}t,note,x\n# later\n0,take-off,1\n1,,2\n";
        let choose = |names: &[String]| {
            Ok(Chosen { names: vec![names[0].clone(), names[2].clone()], ..Chosen::default() })
        };
        let mut table = Table::read_some(Path::new("log.csv"), text.as_bytes(), choose).unwrap();
        assert_eq!((table.rows(), table.line(0), table.line(1)), (2, 3, 4));
        assert_eq!((table.take("t").unwrap(), table.take("x").unwrap()), (vec![0.0, 1.0], vec![1.0, 2.0]));
    }

    /// Rows without a value are left out and counted, and lines keep their numbers; where most rows have none, the first is named.
    #[test]
    fn rows_without_a_value_are_left_out() {
        let read = |text: &str| {
            let choose = |names: &[String]| {
                let names = vec![names[0].clone(), names[2].clone()];
                Ok(Chosen { names, may_have_holes: true, ..Chosen::default() })
            };
            Table::read_some(Path::new("log.csv"), text.as_bytes(), choose)
        };
        let mut table = read("t,note,x\n0,,\n1,,2\n2,,NaN\n3,,4\n4,,5\n").unwrap();
        assert_eq!((table.rows(), table.left_out()), (3, Some((2, 2))));
        assert_eq!([0, 1, 2].map(|row| table.line(row)), [3, 5, 6]);
        assert_eq!(
            (table.take("t").unwrap(), table.take("x").unwrap()),
            (vec![1.0, 3.0, 4.0], vec![2.0, 4.0, 5.0])
        );
        let failure = read("t,note,x\n0,,1\n1,,\n2,,\n").err().unwrap().to_string();
        assert_eq!(failure, "log.csv:3: column 3 (x): expected a finite number, found \"\"");
    }

    #[test]
    fn too_many_columns_are_reported() {
        let header = |count: usize| vec!["a"; count].join(",") + "\n";
        let expected = "run.csv:1: 1001 columns: a table has at most 1000";
        assert_eq!(read(&header(1001)).err().as_deref(), Some(expected));
        assert!(read(&header(1000)).is_ok());
    }

    #[test]
    fn a_short_row_is_reported() {
        let expected = "run.csv:2: expected 2 columns as in the header, found 1";
        assert_eq!(read("t,x\n0\n").err().as_deref(), Some(expected));
    }
}
