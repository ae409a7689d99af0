//! Spacing of the records.

use crate::failure::Failure;
use crate::given::Given;

/// Intervals from one record to the next.
pub fn intervals(given: &Given) -> Result<u64, Failure> {
    let every = given.scene.record_every(given.count, given.period_s);
    every.map_err(|error| Failure::new(format!("{}: {error}", given.origin)))
}
