//! Sequences of calls of the C interface with arbitrary arguments, for two drivers: libFuzzer (`calls`), which looks for
//! new paths, and a plain one at full speed (`random_calls`), which does everything often.
//!
//! A sequence is a list of records of 32 bytes, each of which is a call. What every call is held to:
//! - it answers a status of the header, never SINS_ERROR_INTERNAL, and no number that can be read is infinite or none;
//! - when it fails, it changes nothing that a snapshot has, and writes no output;
//! - SINS_OK of a step leaves the solution within the limits of the header, its quaternion of norm 1;
//! - what can be saved loads, and goes on to the same answers, records and bits; altered bytes are refused;
//! - a text is a scene or a log, or has faults with their places; a scene that is written or set reads back to the same text;
//! - a run of an ensemble is the single simulator of its number to the bit;
//! - forged words are refused, or make a simulator that all of this holds for;
//! - under a sanitizer: no touch of memory that is not its own.

mod calls;
mod ensembles;
mod host;
mod input;
pub mod minimal;
mod motion;
mod scene_calls;
mod scenes;
mod settings;
mod snapshots;
mod texts;
pub mod trace;
pub mod words;

pub use host::run;
pub use input::{RECORD, Random, Record, records};
pub use texts::{check_log, parse_scene, set_values, text_of};
