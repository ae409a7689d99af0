//! Hard cases: places, attitudes and durations that an aircraft does not fly, and input that only a faulty host sends.

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
