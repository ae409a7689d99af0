//! The rows of a log beside the smooth path that was fitted to them, as a file.

use std::io::Write;

use sins::log::RowOfPath;
use sins::records;

use crate::failure::Failure;
use crate::output::OutputFile;
use crate::rows::ROW_COLUMNS;

/// Writes the rows up to `end_s`, and puts the file in place.
pub fn write(mut file: OutputFile, rows: &[RowOfPath], end_s: f64) -> Result<(), Failure> {
    let head = std::iter::once(ROW_COLUMNS.join(","));
    let lines = rows.iter().take_while(|row| row.time_s <= end_s).map(|row| {
        let [east, north, up] = row.residual_n.into();
        let place = &row.place;
        let values = [row.time_s, place.latitude_rad, place.longitude_rad, place.height_m, east, north, up];
        records::line(values)
    });
    let text: String = head.chain(lines).map(|line| line + "\n").collect();
    // The file remembers the first error, and keeps the lines before it.
    let _ = file.write_all(text.as_bytes());
    file.commit_lines()
}
