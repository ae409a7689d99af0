//! A table, as it is cut into cells.

use csv::StringRecord;

use super::guess::guess;
use super::known::known;
use super::lines::{cells, names_of, unmarked, with_row_names};
use super::rows::{is_missing, number};
use super::words::unit;
use super::{MAX_COLUMNS, MAX_LINE, Separator};

/// Lines in which the names are looked for, and rows whose values are looked at.
const LINES: usize = 20;
const ROWS: usize = 5000;

/// Fewest columns with a name that says its quantity, and fewest cells of a line of units.
const FEWEST: usize = 3;

/// The first rows of a table.
pub struct Grid {
    pub separator: Separator,
    /// The line of the names, from 1.
    pub header: usize,
    pub names: StringRecord,
    /// The mark of comments: another one if the names stand behind the usual one.
    pub comment: char,
    /// The lines of units, above or below the names.
    pub units: Vec<StringRecord>,
    /// Rows behind the names that are none.
    pub skip: usize,
    pub rows: Vec<StringRecord>,
}

impl Grid {
    /// `None`: no line at the beginning has names of quantities. A table ends at a line that no log has.
    pub fn of(table: &str) -> Option<Self> {
        let lines = table.lines().take_while(|line| line.len() <= MAX_LINE);
        let lines: Vec<&str> = lines.take(LINES + ROWS).collect();
        let mut best: Option<(usize, Separator, usize)> = None;
        for separator in
            [Separator::Comma, Separator::Semicolon, Separator::Tab, Separator::Bar, Separator::Blanks]
        {
            // Names of several words have blanks too.
            if separator == Separator::Blanks && best.is_some() {
                break;
            }
            for (place, line) in lines.iter().enumerate().take(LINES) {
                let names = names_of(&cells(line, separator), separator);
                if names.len() > MAX_COLUMNS {
                    continue;
                }
                let count = if known(&names).is_some() { usize::MAX } else { quantities(&names) };
                if count >= FEWEST && best.is_none_or(|(most, ..)| count > most) {
                    best = Some((count, separator, place));
                }
            }
        }
        let (_, separator, place) = best?;
        let row = |line: &&str| cells(line, separator);
        let names = names_of(&row(&lines[place]), separator);
        let first = lines[place + 1..].iter().find(|line| !line.trim().is_empty());
        let names = with_row_names(names, first.unwrap_or(&""), separator);
        let comment = if lines[place].starts_with('#') { '!' } else { '#' };
        let is_units = |row: &StringRecord| {
            let count = row.iter().filter(|cell| unit(cell).is_some()).count();
            row.len().abs_diff(names.len()) <= 1 && count >= FEWEST
        };
        let mut behind = lines[place + 1..].iter().filter(|line| !line.is_empty()).map(row).peekable();
        let mut skip = 0;
        // Units, or a second line of names.
        let mut units = Vec::new();
        let is_comment = |row: &StringRecord| row.get(0).is_some_and(|cell| cell.starts_with(comment));
        let are_names = |row: &StringRecord| is_units(row) || quantities(row) >= FEWEST;
        while let Some(row) = behind.next_if(|row| are_names(row) || is_comment(row)) {
            // The reader passes comments.
            skip += usize::from(!is_comment(&row));
            if are_names(&row) {
                units.push(unmarked(&row, separator));
            }
        }
        units.extend(lines[..place].iter().map(row).filter(is_units));
        Some(Self {
            separator,
            header: place + 1,
            names,
            comment,
            units,
            skip,
            rows: behind.filter(|row| !is_comment(row)).collect(),
        })
    }

    /// The cells of a column that have a value.
    pub fn cells(&self, place: usize) -> impl Iterator<Item = &str> {
        self.rows.iter().filter_map(move |row| row.get(place)).filter(|cell| !is_missing(cell, None))
    }

    /// The numbers of a column.
    pub fn numbers(&self, place: usize) -> Vec<f64> {
        self.cells(place).filter_map(|cell| number(cell, self.separator)).collect()
    }

    /// What the lines of units say of a column.
    pub fn stated(&self, place: usize) -> impl Iterator<Item = &'static str> {
        self.units.iter().filter_map(move |row| unit(row.get(place)?)).filter(|unit| !unit.is_empty())
    }
}

/// Number of quantities that the cells of a line name.
fn quantities(cells: &StringRecord) -> usize {
    let mut found: Vec<usize> = cells.iter().filter_map(guess).map(|guess| guess.quantity).collect();
    found.sort_unstable();
    found.dedup();
    found.len()
}
