//! Sequences of calls of the C interface with arbitrary arguments, for two drivers: libFuzzer (`calls`), which looks for
//! new paths, and a plain one at full speed (`random_calls`), which does everything often.
//!
//! A sequence is a list of records of 32 bytes; each record is a call. Each call is checked:
//! - it returns a status of the header, never SINS_ERROR_INTERNAL, and all numbers that can be read are finite;
//! - if it fails, it changes nothing that a snapshot stores, and writes no output;
//! - after a step with SINS_OK, the solution is within the limits of the header, and its quaternion has norm 1;
//! - a snapshot loads, and the simulator continues to the same answers, records and bits; altered bytes are rejected;
//! - a text is a scene or a log, or it has faults with their places; a scene that is written or set reads back to the same text;
//! - a run of an ensemble equals the single simulator of its number to the bit;
//! - forged words are rejected, or they make a simulator that passes all these checks;
//! - under a sanitizer: no access to memory of others.

mod calls;
mod ensembles;
mod host;
mod identify;
mod input;
pub mod minimal;
mod motion;
mod scene_calls;
mod scenes;
mod settings;
mod snapshots;
mod texts;
pub mod trace;
mod units;
pub mod words;

pub use host::run;
pub use input::{RECORD, Random, Record, records};
pub use texts::{check_log, parse_scene, set_values, text_of};
