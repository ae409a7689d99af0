//! The unit: what a crew and an aircraft see of an INS.

#[path = "../support/mod.rs"]
mod support;

mod aircraft;
mod alignment;
mod attitude;
mod bus;
mod bus_values;
mod entries;
mod faults;
mod in_flight;
mod monkey;
mod north;
mod realignment;
mod saved;
mod states;
