//! The C ABI: what the headers in `include` declare. One file for each C noun; the raw pointers are in `memory` and `text`, the
//! handles in `registry` and `tables`, panics and the host's floating-point state in `boundary` and `fpu`. Everything behind is safe
//! Rust.
//!
//! The doc comments of the public items are the documentation in the header. That of the fields of `sins_gyro_params` and
//! `sins_accel_params` comes from `src/sensors/table.rs`.
//!
//! # Safety
//!
//! The caller of any function here promises, for the duration of the call: a pointer is null or points to an object of its type,
//! a pointer to an array to as many elements as the call states, a pointer to a string to a terminated string. A function
//! returns an error for a null pointer that is not allowed, an old or foreign handle, and a wrong `struct_size`.

#![allow(non_camel_case_types, reason = "the names are C's")]
#![allow(clippy::missing_safety_doc, reason = "the rules of pointers and handles stand once, above")]

mod accel;
mod accuracy;
mod altimeter;
mod answer;
mod boundary;
mod budget;
mod budget_answer;
mod choice;
mod correction;
mod covariance;
mod ensemble;
mod ensemble_correct;
mod ensemble_read;
mod ensemble_snapshot;
mod errors;
mod failure;
#[cfg(feature = "fault-injection")]
mod fault;
#[cfg(feature = "scenes")]
mod fault_report;
mod flight;
mod fpu;
mod gravity;
mod gyro;
mod handle;
mod imu;
mod initial;
mod key;
mod last_error;
mod lock;
#[cfg(feature = "scenes")]
mod log;
mod manoeuvre;
mod memory;
mod mounting;
mod navigator;
mod options;
mod parameters;
mod preset;
mod process;
mod recommend;
mod record;
mod record_line;
mod refusal;
mod registry;
mod run;
mod sample;
#[cfg(feature = "scenes")]
mod scene;
#[cfg(feature = "scenes")]
mod scene_failure;
#[cfg(feature = "scenes")]
mod scene_flight;
#[cfg(feature = "scenes")]
mod scene_key;
#[cfg(feature = "scenes")]
mod scene_prepare;
#[cfg(feature = "scenes")]
mod scene_samples;
#[cfg(feature = "scenes")]
mod scene_settings;
#[cfg(feature = "scenes")]
mod scene_text;
#[cfg(feature = "scenes")]
mod scene_value;
mod sensor_failure;
mod sensor_params;
mod simulator;
mod snapshot;
mod solution;
mod statistics;
mod tables;
mod text;
mod thread;
mod thread_locals;
mod truth_summary;
mod version;

pub use accel::*;
pub use accuracy::{sins_accuracy, sins_get_accuracy};
pub use altimeter::*;
pub use boundary::shielded;
pub use budget::*;
pub use budget_answer::*;
pub use correction::*;
pub use covariance::{sins_covariance, sins_get_covariance};
pub use ensemble::*;
pub use ensemble_correct::*;
pub use ensemble_read::*;
pub use ensemble_snapshot::*;
pub use errors::*;
pub use failure::*;
#[cfg(feature = "fault-injection")]
pub use fault::sins_inject_panic;
pub use flight::*;
pub use gravity::*;
pub use gyro::*;
pub use imu::*;
pub use initial::*;
pub use last_error::*;
pub use manoeuvre::*;
pub use mounting::*;
pub use navigator::*;
pub use options::*;
pub use preset::*;
pub use recommend::{sins_cost, sins_recommend, sins_requirement};
pub use record::*;
pub use record_line::sins_record_line;
pub use run::sins_run;
pub use sample::*;
pub use sensor_failure::*;
pub use sensor_params::{sins_accel_params, sins_gyro_params};
pub use simulator::*;
pub use snapshot::*;
pub use solution::*;
pub use statistics::*;
pub use truth_summary::{sins_get_truth_summary, sins_truth_summary};
pub use version::*;
#[cfg(feature = "scenes")]
pub use {
    fault_report::sins_fault, log::*, scene::*, scene_failure::*, scene_flight::*, scene_key::*,
    scene_prepare::*, scene_samples::*, scene_settings::*, scene_text::*, scene_value::*,
};

// That the sizes which the header states are those of the structs; a library without scenes lacks some of these.
#[cfg(feature = "scenes")]
include!(concat!(env!("OUT_DIR"), "/sizes.rs"));
