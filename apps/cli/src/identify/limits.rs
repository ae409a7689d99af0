//! Rows in which a sensor is at the end of its range.

use sins::analysis::identify::RecordedIncrement;
use sins::units::STANDARD_GRAVITY as G;

/// Rows in which a signal stands at its largest value, in one go: the shortest such stretch.
const SHORTEST: usize = 3;
/// Least change of the signal in a row before or behind it, in least changes of the record: noise does not bring a signal of few steps to
/// its largest value and hold it there.
const STEPS: f64 = 10.0;
/// Part of the largest value by which rows of it differ: increments are products.
const ROUNDING: f64 = 1e-9;

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
        let (count, limit) = mark(&values, &mut is_limited);
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

/// Marks the rows in which the signal is at the end of its range. Their number, and the range.
fn mark(values: &[f64], is_limited: &mut [bool]) -> (usize, f64) {
    let limit = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let is_at = |value: f64| value.abs() >= limit * (1.0 - ROUNDING);
    let changes = values.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let least = changes.filter(|change| *change > ROUNDING * limit).fold(f64::INFINITY, f64::min);
    // The value beside the limit may be near it by chance, and the next one is not.
    let is_steep = |rows: [Option<usize>; 2]| {
        let beside = rows.into_iter().flatten().filter_map(|row| values.get(row));
        beside.map(|value| limit - value.abs()).fold(0.0, f64::max) > STEPS * least
    };
    let mut marked = 0;
    let mut begin = 0;
    for stretch in values.chunk_by(|a, b| is_at(*a) && is_at(*b) && a.signum() == b.signum()) {
        let end = begin + stretch.len();
        let before = [begin.checked_sub(1), begin.checked_sub(2)];
        if stretch.len() >= SHORTEST && is_steep(before) && is_steep([Some(end), Some(end + 1)]) {
            is_limited[begin..end].fill(true);
            marked += stretch.len();
        }
        begin = end;
    }
    (marked, limit)
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
            assert!(is_limited.iter().zip(&values).all(|(is, value)| !is || value.abs() == limit));
            count
        };
        for steps in [1e12, 1024.0] {
            let cut = |k: usize| (swing(k).clamp(-4.0, 4.0) * steps).round() / steps;
            let expected = (0..2000).filter(|k| cut(*k).abs() == 4.0).count();
            assert!(marked(&cut) == expected && expected > 100, "{steps}");
        }
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
