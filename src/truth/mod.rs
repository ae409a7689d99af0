//! Truth: the samples of the flight simulator, checked on entry and converted to Earth-fixed axes.

mod answer;
pub mod flight;
mod intake;
mod limits;
mod point;
mod ring;
mod sample;
mod snapshot;
mod steps;
mod summary;

#[cfg(test)]
pub(crate) use answer::STEPS;
pub(crate) use answer::{Answer, SUMS_M};
pub use intake::{Intake, Pushed};
pub use limits::IntakeLimits;
pub(crate) use limits::{INTERVALS_S, MAX_GAP_S, MIN_INTERVAL_S};
pub use point::TruthPoint;
pub use ring::{QUEUE_CAPACITY, Recent};
pub use sample::FlightSample;
pub(crate) use sample::check_height;
pub use summary::{Extreme, TruthSummary};
