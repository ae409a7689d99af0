//! How far apart the records are.

use crate::failure::Failure;
use crate::given::Given;

/// Approximate number of records, if the scene does not state their distance.
const RECORDS: f64 = 2000.0;

/// Intervals from one record to the next.
pub fn intervals(given: &Given) -> Result<u64, Failure> {
    let intervals = match given.scene.output.every_s {
        None => ((given.count - 1) as f64 / RECORDS).round().max(1.0),
        Some(every_s) => (every_s / given.period_s).round(),
    };
    if intervals < 1.0 {
        let every_s = given.scene.output.every_s.unwrap_or_default();
        let what = format!(
            "{}: output.every_s = {every_s}: expected at least the sample interval, {:.6} s",
            given.origin, given.period_s
        );
        return Err(Failure::new(what));
    }
    Ok(intervals as u64)
}
