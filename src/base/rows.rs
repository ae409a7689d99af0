//! The numbers of a struct that a table of rows describes: found by the field, copied, checked.

use crate::base::checks::check_numbers;
use crate::base::error::Error;
use crate::base::parameter::Row;

/// Of the numbers of all rows those of the row with the field `path` of the interface; of another field none.
pub fn of_path<'r, 'n>(
    rows: impl IntoIterator<Item = &'r Row>,
    numbers: impl IntoIterator<Item = &'n mut f64>,
    path: &str,
) -> impl Iterator<Item = &'n mut f64> {
    let found = places(rows.into_iter()).find(|(row, _)| row.field.path == path);
    let (start, count) = found.map_or((0, 0), |(row, start)| (start, row.shape.count()));
    numbers.into_iter().skip(start).take(count)
}

/// The rows, each with the place of its first number.
pub fn places<'r>(rows: impl Iterator<Item = &'r Row>) -> impl Iterator<Item = (&'r Row, usize)> {
    rows.scan(0, |end, row| {
        *end += row.shape.count();
        Some((row, *end - row.shape.count()))
    })
}

/// Copies the numbers of a struct.
pub fn copy<const N: usize>(from: [f64; N], to: [&mut f64; N]) {
    to.into_iter().zip(from).for_each(|(to, from)| *to = from);
}

/// Checks the numbers of all rows of a table.
pub fn check(rows: &[Row], numbers: &[f64]) -> Result<(), Error> {
    let numbers_of = |(row, start): (&Row, usize)| &numbers[start..start + row.shape.count()];
    for (row, start) in places(rows.iter()) {
        check_numbers(&row.field, row.shape, numbers_of((row, start)), |sigma| {
            let of = places(rows.iter()).find(|(row, _)| row.field.path == sigma);
            (sigma, of.map_or(&[], numbers_of))
        })?;
    }
    Ok(())
}
