//! Rows as a CSV file, and numbers in it.

use csv::Writer;

use crate::failure::{Failure, Kind};

/// Every table in Markdown begins with this mark, by which the program recognizes its own tables.
pub const TABLE_MARK: &str = "<!-- written by sins -->";

/// `rows`, the header first, quoted where they need it.
pub fn text<R: AsRef<[String]>>(rows: &[R]) -> Result<String, Failure> {
    let failure = |error: &dyn std::fmt::Display| {
        Failure::of_kind(Kind::Failed, format!("the table could not be written: {error}"))
    };
    let mut writer = Writer::from_writer(Vec::new());
    for row in rows {
        writer.write_record(row.as_ref()).map_err(|error| failure(&error))?;
    }
    let bytes = writer.into_inner().map_err(|error| failure(&error))?;
    String::from_utf8(bytes).map_err(|error| failure(&error))
}

/// The shortest text that reads back to the bit.
pub fn number(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || (1e-5..1e15).contains(&size) { value.to_string() } else { format!("{value:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_read_back() {
        for (value, text) in
            [(0.0, "0"), (-0.1, "-0.1"), (3.0, "3"), (1.25e-300, "1.25e-300"), (1e22, "1e22")]
        {
            assert_eq!(number(value), text);
            assert_eq!(text.parse::<f64>().unwrap().to_bits(), value.to_bits());
        }
    }
}
