//! Truth: the samples of the flight simulator, checked on entry and converted to Earth-fixed axes.

mod intake;
mod point;
mod ring;
mod sample;
mod steps;
mod summary;

pub(crate) use intake::{INTERVALS_S, MAX_GAP_S};
pub use intake::{Intake, IntakeLimits, Pushed};
pub use point::TruthPoint;
pub use ring::{QUEUE_CAPACITY, Recent};
pub use sample::FlightSample;
pub(crate) use sample::check_height;
pub use summary::{Extreme, TruthSummary};
