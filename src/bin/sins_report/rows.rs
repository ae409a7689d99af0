//! Rows as a CSV file.

use csv::Writer;

use crate::failure::Failure;

/// `rows`, the header first, quoted where they need it.
pub fn text(rows: &[Vec<String>]) -> Result<String, Failure> {
    let failure =
        |error: &dyn std::fmt::Display| Failure::new(format!("the table could not be written: {error}"));
    let mut writer = Writer::from_writer(Vec::new());
    for row in rows {
        writer.write_record(row).map_err(|error| failure(&error))?;
    }
    let bytes = writer.into_inner().map_err(|error| failure(&error))?;
    String::from_utf8(bytes).map_err(|error| failure(&error))
}
