//! Truth: what the flight simulator tells, checked on entry and brought to Earth-fixed axes.

mod intake;
mod point;
mod sample;

pub use intake::{Intake, IntakeLimits, QUEUE_CAPACITY};
pub use point::TruthPoint;
pub use sample::FlightSample;
