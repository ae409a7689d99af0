//! sins
#![deny(missing_docs, unsafe_op_in_unsafe_fn)]

pub mod abi;
#[forbid(unsafe_code)]
pub mod earth;
#[forbid(unsafe_code)]
mod error;
#[forbid(unsafe_code)]
pub mod errors;
#[forbid(unsafe_code)]
pub mod flight;
#[forbid(unsafe_code)]
pub mod math;
#[forbid(unsafe_code)]
pub mod mechanization;
#[forbid(unsafe_code)]
pub mod sensors;
#[forbid(unsafe_code)]
pub mod signal;
#[forbid(unsafe_code)]
mod simulator;
#[forbid(unsafe_code)]
pub mod state;
#[forbid(unsafe_code)]
pub mod truth;

pub use error::{Error, ErrorKind, Rule};
pub use simulator::{
    ClosureFigures, ErrorSource, ImuInterval, MAX_UPDATES, Options, Simulator, Solution, Step,
};
