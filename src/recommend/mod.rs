//! Accuracy and what it costs: the algorithms in the order of their cost, and the error of each against a reference that
//! knows its own.

mod ladder;
mod reference;

pub use ladder::{Rung, ladder};
pub use reference::{Reference, SolutionError, Track, fly, track};
