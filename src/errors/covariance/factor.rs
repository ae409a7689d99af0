//! The square root of a covariance.

use crate::errors::column::Column;

/// Rows of a column.
pub const ROWS: usize = 11;

/// Smaller errors count as zero, because a number divided by them can be infinite.
const NOTHING: f64 = 1e-250;

/// Turns the columns A into the lower triangular L with L Lᵀ = A Aᵀ, in the first columns; the other columns are overwritten.
/// Householder reflections from the right form no difference of squares, so L Lᵀ cannot become negative.
pub fn triangularize(columns: &mut [Column]) {
    for row in 0..ROWS.min(columns.len()) {
        let rest = &mut columns[row..];
        let largest = rest.iter().fold(0.0f64, |most, column| most.max(column[row].abs()));
        if largest < NOTHING {
            rest.iter_mut().for_each(|column| column[row] = 0.0);
            continue;
        }
        let norm = largest
            * rest.iter().map(|column| (column[row] / largest) * (column[row] / largest)).sum::<f64>().sqrt();
        // The reflection v of the row onto its first element, with the sign that avoids cancellation.
        let first = rest[0][row];
        let end = if first > 0.0 { -norm } else { norm };
        rest[0][row] = first - end;
        // v·v / 2, relative to the largest element, because squares of tiny numbers would become 0.
        let half_square = (norm / largest) * ((norm + first.abs()) / largest);
        for lower in row + 1..ROWS {
            let product: f64 = rest.iter().map(|column| column[row] / largest * column[lower]).sum();
            let share = product / half_square / largest;
            rest.iter_mut().for_each(|column| column[lower] -= share * column[row]);
        }
        rest[0][row] = end;
        rest[1..].iter_mut().for_each(|column| column[row] = 0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(columns: &[Column]) -> nalgebra::SMatrix<f64, ROWS, ROWS> {
        columns.iter().map(|column| column * column.transpose()).sum()
    }

    #[test]
    fn numbers_too_small_to_divide_by_are_none() {
        let mut columns = [1.25e-312, 1e-300, 0.0].map(|first| {
            Column::from_fn(|row, _| if row == 0 { first } else { 100.0 + (row as f64) * first.signum() })
        });
        triangularize(&mut columns);
        assert!(columns.iter().all(|column| column.iter().all(|number| number.is_finite())));
    }

    #[test]
    fn the_product_stays_and_the_root_is_triangular() {
        // Any numbers, rows of very different size, one of them empty, and fewer independent columns than rows.
        let mut columns: Vec<Column> = (0..40)
            .map(|k| {
                Column::from_fn(|row, _| {
                    let size = [1e-9, 1e-9, 1e-8, 1e-3, 1.0, 0.0, 1e5, 1e5, 3.0, 1e-200, 1e-4][row];
                    size * ((k * 7 + row * 13 + k * k * (row + 1)) % 29) as f64 / 29.0
                })
            })
            .collect();
        let before = product(&columns);
        // Without the squares of its numbers, which can be below the smallest.
        let norms: [f64; ROWS] = core::array::from_fn(|row| {
            let largest = columns.iter().fold(f64::MIN_POSITIVE, |most, column| most.max(column[row].abs()));
            largest * columns.iter().map(|column| (column[row] / largest).powi(2)).sum::<f64>().sqrt()
        });
        triangularize(&mut columns);
        let after = product(&columns[..ROWS]);
        for row in 0..ROWS {
            for column in 0..ROWS {
                let scale = norms[row] * norms[column];
                let apart = (before[(row, column)] - after[(row, column)]).abs();
                assert!(apart <= 1e-14 * scale, "{row} {column}: {apart:e} of {scale:e}");
                assert!(row >= column || columns[column][row] == 0.0);
            }
        }
        assert!(columns[ROWS..].iter().all(|column| *column == Column::zeros()));
    }
}
