//! sins
#![deny(missing_docs, unsafe_op_in_unsafe_fn)]
#![cfg_attr(
    not(test),
    deny(clippy::disallowed_methods, clippy::unwrap_used, clippy::expect_used, clippy::panic)
)]
#![allow(
    rustdoc::broken_intra_doc_links,
    reason = "units stand in square brackets; rustdoc takes [rad] for a link"
)]

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
