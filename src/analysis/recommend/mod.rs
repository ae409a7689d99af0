//! Accuracy and its cost: the algorithms in the order of their cost, the error of each against a reference of known
//! uncertainty, and the cheapest one that meets a requirement.

mod choice;
mod growth;
mod ladder;
mod piece;
mod reference;
mod requirement;
mod setup;
mod timing;

pub use choice::{Recommendation, recommend, recommend_by};
pub use growth::Growth;
pub use ladder::{Rung, ladder};
pub use piece::{MAX_SAMPLES, MIN_SAMPLES, Motion, Piece, Refusal};
pub(crate) use reference::fly_looking;
pub use reference::{Reference, SolutionError, Track, track};
pub use requirement::Requirement;
pub use setup::Setup;
pub(crate) use timing::round_ns;
pub use timing::step_time_ns;
