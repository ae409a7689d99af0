//! Rows in which a sensor is at the end of its range.

use sins::analysis::identify::RecordedIncrement;
use sins::units::STANDARD_GRAVITY as G;

/// Shortest stretch of rows in which a signal keeps its largest value at an end of its range.
const SHORTEST: usize = 3;
/// Least distance of the signal from the end beside such a stretch, in the smallest changes of the record. At rest a quantized signal may
/// keep its largest value by chance, and is one quantum off beside it.
const STEPS: f64 = 10.0;
/// Part of the largest value by which equal values differ: they are products.
const ROUNDING: f64 = 1e-14;

/// Leaves out the rows in which a sensor is at the end of its range, and says so.
pub fn drop_limited(rows: &mut Vec<RecordedIncrement>) -> Vec<String> {
    let names = ["gyro x", "gyro y", "gyro z", "accelerometer x", "accelerometer y", "accelerometer z"];
    let mut is_limited = vec![false; rows.len()];
    let mut remarks = Vec::new();
    for (sensor, name) in names.into_iter().enumerate() {
        let of = |row: &RecordedIncrement| {
            let triad = if sensor < 3 { &row.increment.angle } else { &row.increment.velocity };
            triad[sensor % 3] / row.interval_s
        };
        let values: Vec<f64> = rows.iter().map(of).collect();
        let mut of_sensor = vec![false; rows.len()];
        let (count, limit) = mark(&values, &mut of_sensor);
        is_limited.iter_mut().zip(of_sensor).for_each(|(is_limited, of_sensor)| *is_limited |= of_sensor);
        if count > 0 {
            let (size, unit) = if sensor < 3 { (limit.to_degrees(), "°/s") } else { (limit / G, "g") };
            remarks.push(format!(
                "{count} rows with {name} at the end of its range, {size:.1} {unit}, are left out"
            ));
        }
    }
    let mut row = 0;
    rows.retain(|_| {
        row += 1;
        !is_limited[row - 1]
    });
    remarks
}

/// Marks the rows in which the signal is at an end of its range, above or below. Their number, and the farther end.
fn mark(values: &[f64], is_limited: &mut [bool]) -> (usize, f64) {
    let most = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let changes = values.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let least = changes.filter(|change| *change > ROUNDING * most).fold(f64::INFINITY, f64::min);
    let (mut marked, mut farthest) = (0, 0.0);
    for sign in [1.0, -1.0] {
        let limit = values.iter().fold(f64::NEG_INFINITY, |limit, value| limit.max(sign * value));
        let is_at = |value: f64| sign * value >= limit - ROUNDING * most;
        // The value beside the limit may be near it by chance, and the next one is not; a record may begin or end there.
        let is_steep = |rows: [Option<usize>; 2]| {
            let beside = rows.map(|row| row.and_then(|row| values.get(row)));
            let off = beside.into_iter().flatten().map(|value| limit - sign * value).fold(0.0, f64::max);
            beside[0].is_none() || off > STEPS * least
        };
        let mut begin = 0;
        let mut is_end = false;
        for stretch in values.chunk_by(|a, b| is_at(*a) && is_at(*b)) {
            let end = begin + stretch.len();
            let before = [begin.checked_sub(1), begin.checked_sub(2)];
            is_end |= (SHORTEST..values.len()).contains(&stretch.len())
                && is_at(stretch[0])
                && is_steep(before)
                && is_steep([Some(end), Some(end + 1)]);
            begin = end;
        }
        // Where it is the end of the range, it is that of each row.
        if is_end {
            for (is_limited, _) in is_limited.iter_mut().zip(values).filter(|(_, value)| is_at(**value)) {
                marked += usize::from(!*is_limited);
                *is_limited = true;
            }
            farthest = if limit > f64::abs(farthest) { sign * limit } else { farthest };
        }
    }
    (marked, farthest)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Motion beyond the range is cut off; a signal of few steps, a single largest value and rest are not.
    #[test]
    fn the_end_of_the_range_is_told_from_a_largest_value() {
        let swing = |k: usize| 5.0 * (0.02 * k as f64).sin();
        let marked = |of: &dyn Fn(usize) -> f64| {
            let values: Vec<f64> = (0..2000).map(of).collect();
            let mut is_limited = vec![false; values.len()];
            let (count, limit) = mark(&values, &mut is_limited);
            assert_eq!(is_limited.iter().filter(|is| **is).count(), count);
            assert!(is_limited.iter().zip(&values).all(|(is, value)| !is || value.abs() <= limit.abs()));
            count
        };
        for steps in [1e12, 1024.0] {
            let cut = |k: usize| (swing(k).clamp(-4.0, 4.0) * steps).round() / steps;
            let expected = (0..2000).filter(|k| cut(*k).abs() == 4.0).count();
            assert!(marked(&cut) == expected && expected > 100, "{steps}");
        }
        // One side alone, an offset behind the range, few steps, and a record that begins at the end of the range.
        let above = (0..2000).filter(|k| swing(*k) >= 4.0).count();
        assert_eq!(marked(&|k| swing(k).min(4.0)), above);
        assert_eq!(
            marked(&|k| 0.3 + swing(k).clamp(-4.0, 4.0)),
            (0..2000).filter(|k| swing(*k).abs() >= 4.0).count()
        );
        let late = |k: usize| swing(k + 75).min(4.0);
        assert_eq!(marked(&late), (0..2000).filter(|k| swing(*k + 75) >= 4.0).count());
        assert!(late(0) == 4.0);
        for whole in [
            &swing as &dyn Fn(usize) -> f64,
            &|k| swing(k).round(),
            &|k| 9.8 + 0.1 * f64::from(u8::from(k % 9 > 3)),
            &|_| 9.8,
            &|k| 0.001 * (swing(k) * 1e3).round(),
        ] {
            assert_eq!(marked(whole), 0);
        }
    }
}
