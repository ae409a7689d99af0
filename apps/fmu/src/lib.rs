//! The simulator as a Functional Mock-up Unit: FMI 2.0 for co-simulation.
//!
//! ```text
//!  master          fmi2...        calls                         `interface`, `get_set`, `steps`, `states`
//!    |
//!    v
//!  instance        phases, values, the simulator                `instance`, saved by `saved`
//!    |        \
//!    v         v
//!  scene       sample             parameters, inputs            `parameters`, `inputs`, `corrections`, `panel`
//!    |          |
//!    v          v
//!  sins::Simulator  ->  outputs                                 `outputs`, `parts`, `panel`
//! ```
//!
//! The variables of inputs, parameters and outputs are in one table (`table`), which is made from the keys of a scene. The
//! model description (`description`) is written from the same table.
//!
//! # Time
//!
//! The generator of the simulator needs a sample at both ends of an interval. In a co-simulation, the inputs are given for the
//! start of a step. So `doStep(t, h)` takes the inputs as the truth at `t` and flies the interval that ends at `t`. The outputs
//! after the step belong to `time_of_solution_s` = t. Steps may have any length that the simulator accepts as a sample interval. A
//! step from a time whose sample has been taken changes nothing, if the inputs are the same.
#![deny(missing_docs, unsafe_op_in_unsafe_fn)]

mod corrections;
mod description;
pub mod get_set;
mod inputs;
mod instance;
pub mod interface;
mod logger;
mod outputs;
mod panel;
mod parameters;
mod parts;
mod saved;
mod scene;
pub mod states;
pub mod steps;
mod table;
pub mod uri;
mod values;
mod variable;
mod watch;

/// The text of modelDescription.xml.
pub fn model_description() -> String {
    table::table().xml()
}
