//! The effects of a triad. An effect is a row of the table below, and a file whose name is the row's field.
//!
//! The file has the equation of the effect, its state, and what it does at its stage: [`effect`]. Everything that concerns all
//! effects follows from the table: the order in which they act, what is set, drawn, saved and undone, how a single run, the runs
//! of an ensemble and an alignment sense.

mod asymmetry;
mod bandwidth;
mod bias;
mod dead_zone;
mod effect;
mod flicker;
mod g_sensitivity;
mod gauss_markov;
mod linear;
mod outputs;
mod plan;
mod process;
mod quadratic;
mod quantization;
mod ramp;
mod random_walk;
mod range;
mod rate_random_walk;
mod rows;
mod sense;
mod size_effect;
mod states;
mod temperature;

use nalgebra::Vector3;

use super::parameters::{Sensor, TriadParameters};
use super::stream::{EffectStreams, STREAM_NUMBERS, StreamKey, check_numbers};
use crate::base::snapshot::stored;
use crate::signal::Increment;
use effect::{Added, DrawnOfInput, Effect, OfInput, OnInput, OnOutput};
pub(super) use effect::{Conditions, Input};
pub(super) use outputs::{BatchOutputs, Outputs};
pub use plan::EffectPlace;
use plan::{Plan, Stage};
use rows::{effects, for_active};
pub(crate) use sense::SharedInput;
use states::Aside;
pub(crate) use states::StateRows;
pub(super) use states::{Count, PutLane, States, TakeLane, Visitor};

pub use flicker::PROCESSES as FLICKER_PROCESSES;
pub(crate) use gauss_markov::MarkovStep;
pub(crate) use linear::sigma as element_sigmas;
pub(crate) use process::Kind;
use process::Processes;

// Each row is a file and its effect. Behind a random effect stand the numbers of its streams; each axis has its own stream of a number.
// The numbers are part of the bit-for-bit guarantee: never reuse one.
effects! {
    // Change the input of the sensors.
    OnInput {
        size_effect: SizeEffect,
        bandwidth: Bandwidth,
    }
    // Errors that depend on the input, and differ from run to run.
    DrawnOfInput {
        linear: Linear [5, 6],
    }
    // Errors that depend on the input, and are the same in all runs.
    OfInput {
        asymmetry: Asymmetry,
        quadratic: Quadratic,
        g_sensitivity: GSensitivity,
        temperature: Temperature,
    }
    // Errors that do not depend on the input.
    Added {
        bias: Bias [0],
        gauss_markov: GaussMarkov [1],
        flicker: Flicker [4],
        rate_random_walk: RateRandomWalk [3],
        ramp: Ramp,
        random_walk: RandomWalk [2],
    }
    // Act on the output.
    OnOutput {
        dead_zone: DeadZone,
        range: Range,
        quantization: Quantization,
    }
}
