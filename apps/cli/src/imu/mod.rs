//! Records of an IMU, for `sins allan` and `sins identify`.
//!
//! The data flow is `begin` (names and separators of the table) → `quantity` (what its columns are) → `stamps` → `log`.

mod begin;
mod log;
mod quantity;
mod stamps;

pub use log::{Log, Series, Source};
pub use quantity::{Sensor, Wanted, wanted};
