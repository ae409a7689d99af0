//! The sensor models: the outputs of imperfect gyros and accelerometers for the ideal signals (the paper's equations (1)-(3)), the
//! barometric altimeter, and the disturbance of the gravity that acts on accelerometers.
//!
//! # Effects
//!
//! Each effect is one file in `effects`, with its own random streams. When parameters are set, a triad makes a plan of the effects that
//! they call for, and does no work for the others. The effects act along the path of the signal, in this order:
//!
//! | | effect | error |
//! |---|---|---|
//! | what acts on the proof mass | size effect | ω'×r + ω×(ω×r) at each accelerometer, along its axis |
//! | | bandwidth | second-order Butterworth filter, exact for a signal constant over an increment |
//! | scale-type errors of that input | scale factor, misalignment, given and drawn at turn-on | K s |
//! | | asymmetry | a/2 \|s\| |
//! | | nonlinearity, vibration rectification | c s\|s\|, k s² |
//! | | g-sensitivity, g²-sensitivity | G f, k f² of the force along each gyro's own axis |
//! | | temperature | (s1 θ + s2 θ²) s + b1 θ + b2 θ², θ = T - T_ref |
//! | additive | bias, turn-on bias, Gauss-Markov bias | |
//! | | flicker B | stationary from the start on |
//! | | rate random walk K, ramp R | from 0 at the start of the run, or of an alignment that takes time |
//! | | random walk N | white |
//! | | failures: bias step, spikes, noise | |
//! | output | dead zone | 0 where \|s\| ≤ d |
//! | | range | ±r, flagged |
//! | | quantization | whole pulses, the remainder is carried |
//! | | failures: stuck, dead, drop-outs | the last value; 0, flagged |
//!
//! The parameters of all effects are in one table, [`PARAMETERS`]: `table.rs`.
//!
//! Every random process is discretised exactly, whatever the length of the increments.

mod alignment;
mod altimeter;
mod altimeter_table;
mod draw;
mod effects;
mod failing;
mod failure;
mod gravity_disturbance;
mod gravity_parameters;
mod gravity_table;
mod initial;
mod initial_table;
mod kept;
mod parameters;
mod preset;
mod stream;
mod table;
mod triad;
mod validation;
mod xoshiro;

pub use crate::base::parameter::{Field, Parameter, Range as ParameterRange, Row, Shape as ParameterShape};
pub use alignment::{Aligned, Sensed, level, level_and_gyrocompass};
pub use altimeter::{Altimeter, AltimeterParameters};
pub use altimeter_table::ALTIMETER;
pub use draw::StandardNormal;
#[cfg(feature = "identify")]
pub(crate) use effects::MarkovStep;
pub use effects::{EFFECTS, EffectPlace, FLICKER_PROCESSES};
pub(crate) use effects::{Kind, OF_SIGNAL, SharedInput, StateRows, element_sigmas};
pub(crate) use failing::FailingTriad;
pub(crate) use failure::FailureFields;
pub use failure::{Axis, Failure, SensorOutput};
pub use gravity_disturbance::GravityDisturbance;
pub use gravity_parameters::{GravityDisturbanceParameters, GravityField};
pub use gravity_table::GRAVITY;
pub use initial::{Alignment, InitialErrorParameters};
pub use initial_table::INITIAL;
pub use parameters::{Sensor, TriadParameters};
pub use preset::{Grade, paper_simulation2};
pub use stream::StreamKey;
pub use table::PARAMETERS;
pub use triad::Triad;
pub use xoshiro::Xoshiro256PlusPlus;
