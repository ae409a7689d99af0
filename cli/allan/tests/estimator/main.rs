//! The Allan estimator: on records of known noises, and on what a simulator at rest measures.
//!
//! `cargo test --release --features long-tests -p sins-allan -- --nocapture` prints the figures of the documentation.

mod closure;
mod dependent;
mod grid;
mod intervals;
mod noises;
mod terms;
