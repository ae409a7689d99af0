//! Rows as a CSV file, and numbers in it.

use csv::Writer;
pub use sins::records::number;

/// Axes of all errors except those of the sensors, in the order of the columns.
pub const EAST_NORTH_UP: [&str; 3] = ["east", "north", "up"];

use crate::failure::{Failure, Kind};

/// Columns of the rows beside a smooth path: a row, and its position less that of the path.
pub const ROW_COLUMNS: [&str; 7] = [
    "time_s",
    "latitude_rad",
    "longitude_rad",
    "height_m",
    "residual_east_m",
    "residual_north_m",
    "residual_up_m",
];

/// Mark at the beginning of every table in Markdown, by which the program recognizes its own tables.
pub const TABLE_MARK: &str = "<!-- written by sins -->";

/// `rows` under their header as CSV text, quoted where necessary.
pub fn text<R: AsRef<[String]>>(
    header: &[&str],
    rows: impl IntoIterator<Item = R>,
) -> Result<String, Failure> {
    let failure = |error: &dyn std::fmt::Display| {
        Failure::of_kind(Kind::Failed, format!("the table could not be written: {error}"))
    };
    let mut writer = Writer::from_writer(Vec::new());
    writer.write_record(header).map_err(|error| failure(&error))?;
    for row in rows {
        writer.write_record(row.as_ref()).map_err(|error| failure(&error))?;
    }
    let bytes = writer.into_inner().map_err(|error| failure(&error))?;
    String::from_utf8(bytes).map_err(|error| failure(&error))
}
