//! Instructions of a step, as `benches/instructions.sh matrix` counts them.

use std::io::Read;
use std::path::Path;

use csv::{ReaderBuilder, Trim};
use sins::scene::listed;

use super::configuration::Configuration;
use crate::failure::Failure;
use crate::given::open_table;

const HEADER: [&str; 5] = ["scheme", "subsamples", "updates_per_sample", "frame", "instructions_per_step"];

/// Instruction counts of some configurations.
#[derive(Debug, Default, PartialEq)]
pub struct Instructions {
    rows: Vec<([String; 4], f64)>,
}

impl Instructions {
    pub fn read(path: &Path) -> Result<Self, Failure> {
        Self::from_csv(path, open_table(path)?.0)
    }

    fn from_csv(path: &Path, input: impl Read) -> Result<Self, Failure> {
        let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(input);
        let header = reader.headers().map_err(|error| Failure::of_file(path, &error))?;
        if header != HEADER.as_slice() {
            let what =
                format!("expected the header {}; the header has {}", HEADER.join(","), listed(header.iter()));
            return Err(Failure::of_line(path, 1, &what));
        }
        let mut rows = Vec::new();
        for row in reader.records() {
            let row = row.map_err(|error| Failure::of_file(path, &error))?;
            let line = row.position().map_or(0, csv::Position::line);
            let count = row[4].parse().map_err(|_| {
                Failure::of_line(path, line, &format!("expected a number, found \"{}\"", &row[4]))
            })?;
            rows.push(([0, 1, 2, 3].map(|k| row[k].to_owned()), count));
        }
        Ok(Self { rows })
    }

    /// Instructions of a step of `configuration`, if they were counted.
    pub fn of(&self, configuration: &Configuration) -> Option<f64> {
        let rung = &configuration.rung;
        let (subsamples, updates) = (rung.subsamples.to_string(), rung.updates_per_sample.to_string());
        let key = [rung.scheme.word(), &subsamples, &updates, configuration.frame.word()];
        self.rows.iter().find(|(row, _)| *row == key).map(|(_, count)| *count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_found_by_configuration() {
        let read = |text: &str| Instructions::from_csv(Path::new("i.csv"), text.as_bytes());
        let text = format!("{}\npaper,2,1,geographic,5000\nexact,2,1,earth,5200\n", HEADER.join(","));
        let counts = read(&text).unwrap();
        assert_eq!(counts.of(&Configuration::PAPER), Some(5000.0));
        assert_eq!(counts.of(&Configuration::all()[0]), None);
        assert!(read(&text.replace("5200", "many")).unwrap_err().to_string().contains(":3: "));
        assert!(read("a,b\n").unwrap_err().to_string().contains("instructions_per_step"));
    }
}
