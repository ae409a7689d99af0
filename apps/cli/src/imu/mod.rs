//! Records of an IMU, for `sins allan` and `sins identify`.
//!
//! The data flow is `begin` (names and separators of the table) → `quantity` (what its columns are) → `rows` → `stamps`, `uneven` → `log`.
//! With an `[imu]` the library reads the rows. `taken` says how a record was read.

mod begin;
mod log;
mod mapping;
mod quantity;
mod rows;
mod stamps;
mod taken;
mod uneven;

pub use log::{Log, Series};
pub use mapping::{of_file as imu_of_file, of_scene as imu_of_scene};
pub use quantity::{Sensor, Wanted, wanted};
pub use rows::Source;
pub use taken::{reversed, text as imu_text};
