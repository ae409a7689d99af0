//! Calls of a master: corrections, parts of intervals, wrong calls, calls in random order, the URI of the resources, a doubtful truth.
#![allow(
    clippy::undocumented_unsafe_blocks,
    reason = "the tests keep the promises of the functions that they call, or break them on purpose"
)]

mod corrections;
#[allow(dead_code, reason = "these tests use a part of it")]
#[path = "../../../../tests/support/draws.rs"]
mod draws;
#[path = "../../../../tests/support/scenes/mod.rs"]
mod flown_scenes;
#[allow(dead_code, reason = "these tests use a part of it")]
#[path = "../../../../tests/support/fnv.rs"]
mod fnv;
mod misuse;
mod panel;
mod parts;
mod random_calls;
mod scenes;
mod support;
mod uri;
mod watch;
