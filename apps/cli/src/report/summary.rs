//! The summary of a run, with whatever rows the file has.

use std::io::Read;
use std::path::Path;

use csv::ReaderBuilder;

use crate::drawing::events::Events;
use sins::scene::listed;
use sins::unit::State;

use crate::failure::Failure;
use crate::table::number;
use crate::units;

/// One row of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    pub key: String,
    pub value: String,
    pub unit: String,
    pub label: String,
}

/// All rows, in the order of the file.
#[derive(Debug, Default)]
pub struct Summary {
    pub rows: Vec<Row>,
}

impl Summary {
    /// Reads all of `input`; `path` is for the errors.
    pub fn read(path: &Path, input: impl Read) -> Result<Self, Failure> {
        let mut reader = ReaderBuilder::new().flexible(true).from_reader(input);
        let header = reader.headers().map_err(|error| Failure::of_file(path, &error))?;
        if header != ["key", "value", "unit", "label"].as_slice() {
            let found = listed(header.iter());
            let what = format!("expected the header \"key,value,unit,label\"; the header has {found}");
            return Err(Failure::of_line(path, 1, &what));
        }
        let mut rows = Vec::new();
        for row in reader.records() {
            let row = row.map_err(|error| Failure::of_file(path, &error))?;
            let line = row.position().map_or(0, csv::Position::line);
            let field = |place| row.get(place).unwrap_or_default().trim().to_owned();
            if row.len() != 4 {
                let what = format!("expected 4 columns, found {}", row.len());
                return Err(Failure::of_line(path, line, &what));
            }
            let row = Row { key: field(0), value: field(1), unit: field(2), label: field(3) };
            if !row.unit.is_empty() && number(&row.value).is_none() {
                let what = format!("{}: expected a finite number, found \"{}\"", row.key, row.value);
                return Err(Failure::of_line(path, line, &what));
            }
            rows.push(row);
        }
        Ok(Self { rows })
    }

    /// The text of the row `key`.
    pub fn value(&self, key: &str) -> Option<&str> {
        self.row(key).map(|row| row.value.as_str())
    }

    /// The number in the row `key`.
    pub fn number(&self, key: &str) -> Option<f64> {
        self.value(key)?.parse().ok().filter(|value: &f64| value.is_finite())
    }

    /// Failures of the sensors, updates by fixes, and the ends of the alignments of the unit.
    pub fn events(&self) -> Events {
        let spans = |what: &str, from: &str, to: &str| {
            let time = |number: u32, end: &str| self.number(&format!("{what}_{number}_{end}_s"));
            (1..).map_while(|number| Some((time(number, from)?, time(number, to)))).collect()
        };
        let aligns = |state: State| matches!(state, State::FineAlignment | State::Realignment);
        let states = self.states();
        let alignments_s = states.windows(2).filter(|pair| aligns(pair[0].1) && !aligns(pair[1].1));
        Events {
            failures: spans("failure", "from", "until"),
            updates: spans("update", "at", "every"),
            alignments_s: alignments_s
                .filter(|pair| matches!(pair[1].1, State::Ready | State::Navigation))
                .map(|pair| pair[1].0)
                .collect(),
        }
    }

    /// States of the unit, each with its begin [s].
    pub fn states(&self) -> Vec<(f64, State)> {
        let from_s = |number: u32| self.number(&format!("unit_{number}_from_s"));
        let state = |number: u32| State::of_word(self.value(&format!("unit_{number}_state"))?);
        (1..).map_while(|number| Some((from_s(number)?, state(number)?))).collect()
    }

    /// What was found in the flight data, in sentences.
    pub fn findings(&self) -> impl Iterator<Item = &str> {
        (1..).map_while(|number| self.value(&format!("finding_{number}_text")))
    }

    /// The row `key`.
    pub fn row(&self, key: &str) -> Option<&Row> {
        self.rows.iter().find(|row| row.key == key)
    }
}

#[cfg(test)]
impl Row {
    /// A row for tests, without a label.
    pub fn made(key: &str, value: &str, unit: &str) -> Self {
        Self { key: key.into(), value: value.into(), unit: unit.into(), label: String::new() }
    }
}

impl Row {
    /// Whether it is an error of the run: a length, a speed, an angle or a rate of radial error.
    pub fn is_error(&self) -> bool {
        units::family(&self.unit).is_some() || self.unit == units::NMI_PER_HOUR.name
    }

    /// The label, or the key if there is no label.
    pub fn title(&self) -> &str {
        if self.label.is_empty() { &self.key } else { &self.label }
    }

    /// The value with its unit: four digits; a unit of length, speed or angle is chosen by size.
    pub fn text(&self) -> String {
        let with_unit = |value: String, unit: &str| format!("{value} {unit}").trim_end().to_owned();
        match self.value.parse::<f64>() {
            Ok(value) if self.unit == "s" && value >= 120.0 => {
                format!("{} s ({})", (value * 1e3).round() / 1e3, units::time_text(value))
            }
            Ok(value) if value.is_finite() && !self.is_whole() => match units::family(&self.unit) {
                Some(family) => units::with_unit(value, family),
                None => with_unit(units::significant(value), &self.unit),
            },
            _ => with_unit(self.value.clone(), &self.unit),
        }
    }

    fn is_whole(&self) -> bool {
        self.value.parse::<i128>().is_ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Summary, String> {
        Summary::read(Path::new("s.csv"), text.as_bytes()).map_err(|failure| failure.to_string())
    }

    #[test]
    fn whatever_rows_are_there_are_kept() {
        let summary =
            read("key,value,unit,label\nseed,18446744073709551615,,seed\nr,0.61234567,nmi/h,\"a, b\"\n")
                .unwrap();
        assert_eq!(summary.value("seed"), Some("18446744073709551615"));
        assert_eq!(summary.rows[0].text(), "18446744073709551615");
        assert_eq!(summary.rows[1].text(), "0.6123 nmi/h");
        assert_eq!(summary.rows[1].title(), "a, b");
        assert!(summary.rows[1].is_error() && !summary.rows[0].is_error());
    }

    #[test]
    fn si_units_become_readable() {
        let row = |value: &str, unit: &str| Row::made("k", value, unit).text();
        assert_eq!(row("-1.9066e-9", "m"), "-1.907×10⁻⁹ m");
        assert_eq!(row("12345.678", "m"), "12.35 km");
        assert_eq!(row("0.0", "m"), "0 m");
        assert_eq!(row("3122.4500000000003", "s"), "3122.45 s (52 min)");
    }

    #[test]
    fn a_wrong_header_or_row_is_reported() {
        let header = "key,value,unit,label\n";
        assert!(
            read(&format!("{header}r,nan,m,\n"))
                .unwrap_err()
                .contains("s.csv:2: r: expected a finite number")
        );
        assert!(
            read(&format!("{header}r,1e308,m,\n")).is_err() && read(&format!("{header}name,nan,,\n")).is_ok()
        );
        assert!(read("key,value\n").unwrap_err().contains(":1: "));
        assert_eq!(read("key,value,unit,label\na,b\n").unwrap_err(), "s.csv:2: expected 4 columns, found 2");
    }
}
