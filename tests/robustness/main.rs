//! Hard cases: places, attitudes and durations that an aircraft does not fly, and input that only a faulty host sends.
#![allow(
    clippy::undocumented_unsafe_blocks,
    reason = "the tests keep the promises of the functions that they call, or break them on purpose"
)]

#[path = "../support/mod.rs"]
mod support;

mod any_use;
mod attitudes;
mod free_vertical;
mod irregular_samples;
mod misaligned_starts;
mod parameters;
mod places;
mod poles;
mod positions;
mod rest;
mod sample_limits;
mod snapshot_damage;
mod struct_fields;
