//! The Allan estimator: on records of known noises, and on what a simulator at rest measures.
//!
//! `cargo test --release --features long-tests -p sins-allan -- --nocapture` prints the figures of the documentation.

mod closure;
mod dependent;
#[allow(dead_code, reason = "these tests use a part of it")]
#[path = "../../../../../tests/support/draws.rs"]
mod draws;
mod grid;
mod intervals;
mod noises;
mod terms;
