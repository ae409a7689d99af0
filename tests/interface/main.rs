//! Everything that a host calls and writes: the C functions, the header, the examples, scenes and
//! flight logs.
#![allow(
    clippy::undocumented_unsafe_blocks,
    reason = "the tests keep the promises of the functions that they call, or break them on purpose"
)]

#[path = "../support/mod.rs"]
mod support;

#[cfg(feature = "scenes")]
mod c_side;
mod compatible;
#[cfg(feature = "scenes")]
mod examples;
#[cfg(feature = "scenes")]
mod faulty_texts;
#[cfg(feature = "scenes")]
mod flight_log;
#[cfg(feature = "scenes")]
mod flight_records;
mod header;
#[cfg(feature = "scenes")]
mod host_machine;
#[cfg(feature = "scenes")]
mod log_files;
#[cfg(feature = "scenes")]
mod log_mapping;
#[cfg(feature = "scenes")]
mod play;
#[cfg(feature = "scenes")]
mod scene_functions;
#[cfg(feature = "scenes")]
mod scene_records;
#[cfg(feature = "scenes")]
mod scene_settings;
#[cfg(feature = "scenes")]
mod scene_text;
#[cfg(feature = "scenes")]
mod scene_values;
#[cfg(feature = "scenes")]
mod unread_columns;
#[cfg(feature = "scenes")]
mod unread_records;
mod versions;
