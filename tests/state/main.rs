//! A run continues to the same bits with any calls, from any snapshot, after a pause or a slew, and in an ensemble.
#![allow(
    clippy::undocumented_unsafe_blocks,
    reason = "the tests keep the promises of the functions that they call, or break them on purpose"
)]

#[path = "../support/mod.rs"]
mod support;

mod corrections;
mod determinism;
mod ensemble;
mod ensemble_widths;
mod host_time;
#[cfg(feature = "scenes")]
mod increments;
mod moved;
mod read_back;
mod snapshots;
#[cfg(feature = "scenes")]
mod updates;
