//! What every block uses: mathematics, errors, ranges and tables of parameters, snapshots, memory.

#[forbid(unsafe_code)]
pub mod checks;
#[forbid(unsafe_code)]
pub mod error;
#[forbid(unsafe_code)]
pub mod figures;
pub mod instruction_set;
#[forbid(unsafe_code)]
pub mod joined;
#[forbid(unsafe_code)]
pub mod kinds;
#[forbid(unsafe_code)]
pub mod math;
pub mod memory;
#[forbid(unsafe_code)]
pub mod parameter;
#[forbid(unsafe_code)]
pub mod records;
#[forbid(unsafe_code)]
pub mod rows;
#[forbid(unsafe_code)]
pub mod snapshot;
#[cfg(feature = "scenes")]
#[forbid(unsafe_code)]
pub mod text;
#[forbid(unsafe_code)]
pub mod units;
