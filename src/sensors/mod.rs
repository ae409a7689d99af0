//! The sensor models: what imperfect gyros and accelerometers make of the ideal signals (the paper's equations (1)-(3)),
//! and the barometric altimeter.
//!
//! Each error term is one unit with its own random streams; a triad knows which of them a parameter calls for and
//! does no work for the others.

mod altimeter;
mod bias;
mod gauss_markov;
mod initial;
mod linear;
mod parameters;
mod preset;
mod random_walk;
mod stream;
mod triad;

pub use altimeter::{Altimeter, AltimeterParameters};
pub use initial::{Alignment, InitialErrorParameters, InitialErrors, alignment_error};
pub use parameters::{Sensor, TriadParameters};
pub use preset::paper_simulation2;
pub use stream::StreamKey;
pub use triad::Triad;
