//! A table, as it is cut into cells.

use super::Separator;
use super::guess::{guess, unit};
use super::known::known;

/// Lines in which the names are looked for, and rows whose values are looked at.
const LINES: usize = 20;
const ROWS: usize = 5000;

/// Fewest columns with a name that says its quantity, and fewest cells of a line of units.
const FEWEST: usize = 3;

/// The first rows of a table.
pub struct Grid<'t> {
    pub separator: Separator,
    /// The line of the names, from 1.
    pub header: usize,
    pub names: Vec<&'t str>,
    /// The lines of units, above or below the names.
    pub units: Vec<Vec<&'t str>>,
    /// Rows behind the names that are none.
    pub skip: usize,
    pub rows: Vec<Vec<&'t str>>,
}

impl<'t> Grid<'t> {
    /// `None`: no line at the beginning has names of quantities.
    pub fn of(table: &'t str) -> Option<Self> {
        let lines: Vec<&str> = table.trim_start_matches('\u{feff}').lines().take(LINES + ROWS).collect();
        let mut best: Option<(usize, Separator, usize)> = None;
        for separator in [Separator::Comma, Separator::Semicolon, Separator::Tab, Separator::Bar] {
            for (place, line) in lines.iter().enumerate().take(LINES) {
                let cells = cells(line, separator);
                let count = if known(&cells).is_some() { usize::MAX } else { quantities(&cells) };
                if count >= FEWEST && best.is_none_or(|(most, ..)| count > most) {
                    best = Some((count, separator, place));
                }
            }
        }
        let (_, separator, place) = best?;
        let names = cells(lines[place], separator);
        let is_units = |row: &Vec<&str>| {
            let count = row.iter().filter(|cell| unit(cell).is_some()).count();
            row.len().abs_diff(names.len()) <= 1 && count >= FEWEST
        };
        let mut behind = lines[place + 1..].iter().map(|line| cells(line, separator)).peekable();
        let mut skip = 0;
        // Units, or a second line of names.
        let mut units: Vec<Vec<&str>> = Vec::new();
        while let Some(row) = behind.next_if(|row| is_units(row) || quantities(row) >= FEWEST) {
            // The reader passes comments.
            skip += usize::from(!row[0].starts_with('#'));
            units.push(row);
        }
        units.extend(lines[..place].iter().map(|line| cells(line, separator)).filter(is_units));
        Some(Self { separator, header: place + 1, names, units, skip, rows: behind.collect() })
    }

    /// A cell with a decimal point: between semicolons decimals may follow a comma.
    pub fn point(&self, cell: &str) -> String {
        if self.separator == Separator::Semicolon { cell.replace(',', ".") } else { cell.to_owned() }
    }

    /// The numbers of a column.
    pub fn numbers(&self, place: usize) -> Vec<f64> {
        let number = |row: &Vec<&str>| {
            self.point(row.get(place)?).parse().ok().filter(|value: &f64| value.is_finite())
        };
        self.rows.iter().filter_map(number).collect()
    }

    /// What the lines of units say of a column.
    pub fn stated(&self, place: usize) -> impl Iterator<Item = &'static str> {
        self.units.iter().filter_map(move |row| unit(row.get(place)?)).filter(|unit| !unit.is_empty())
    }
}

/// Number of quantities that the cells of a line name.
fn quantities(cells: &[&str]) -> usize {
    let mut found: Vec<usize> =
        cells.iter().filter_map(|name| guess(name)).map(|guess| guess.quantity).collect();
    found.sort_unstable();
    found.dedup();
    found.len()
}

/// The cells of a line. A separator within quotes separates none.
fn cells(line: &str, separator: Separator) -> Vec<&str> {
    let separator = char::from(separator.byte());
    let mut is_quoted = false;
    let is_end = |letter: char| {
        is_quoted ^= letter == '"';
        letter == separator && !is_quoted
    };
    line.split(is_end).map(|cell| cell.trim().trim_matches('"').trim()).collect()
}
