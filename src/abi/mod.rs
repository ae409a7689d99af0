//! The C ABI: what the headers in `include` declare. One file for each C noun. `boundary` has what every call passes: handles, locks,
//! threads, panics, the host's floating-point state. `scene` has scenes and flight logs. The raw pointers are in `memory` and `text`.
//! Everything behind is safe Rust.
//!
//! The doc comments of the public items are the documentation in the header. That of the fields of `sins_gyro_params` and
//! `sins_accel_params` comes from `src/sensors/table.rs`, that of the other structs of parameters from the
//! tables that `build/tables.rs` lists, and that of most enumerations from the enumerations of the crate that `build/enumerations.rs`
//! lists.
//!
//! # Safety
//!
//! The caller of any function here promises, for the duration of the call: a pointer is null or points to an object of its type,
//! a pointer to an array to as many elements as the call states, a pointer to a string to a terminated string. A function
//! returns an error for a null pointer that is not allowed, an old or foreign handle, and a wrong `struct_size`.

#![allow(non_camel_case_types, reason = "the names are C's")]
#![allow(clippy::missing_safety_doc, reason = "the rules of pointers and handles stand once, above")]

mod accuracy;
mod answer;
mod boundary;
mod budget;
mod budget_answer;
mod bus;
mod choice;
mod correction;
mod covariance;
mod ensemble;
mod ensemble_read;
mod ensemble_snapshot;
mod errors;
mod failure;
#[cfg(sins_fault_injection)]
mod fault;
mod flight;
#[cfg(feature = "identify")]
mod identify;
mod imu;
mod judge;
mod last_error;
mod manoeuvre;
mod memory;
mod navigator;
mod options;
mod parameters;
mod preset;
mod recommend;
mod record;
mod run;
mod sample;
#[cfg(feature = "scenes")]
mod scene;
mod sensor_failure;
mod sentence;
mod settings;
mod simulator;
mod snapshot;
mod solution;
mod statistics;
mod text;
mod truth_summary;
mod unit;
mod unit_status;
mod version;

pub use accuracy::{sins_accuracy, sins_get_accuracy};
pub use boundary::shielded;
pub use budget::*;
pub use budget_answer::*;
pub use bus::*;
pub use correction::*;
pub use covariance::{sins_covariance, sins_get_covariance};
pub use ensemble::*;
pub use ensemble_read::*;
pub use ensemble_snapshot::*;
pub use errors::*;
pub use failure::*;
#[cfg(sins_fault_injection)]
pub use fault::sins_inject_panic;
pub use flight::*;
#[cfg(feature = "identify")]
pub use identify::*;
pub use imu::*;
pub use judge::*;
pub use last_error::*;
pub use manoeuvre::*;
pub use navigator::*;
pub use options::*;
pub use preset::*;
pub use recommend::{sins_cost, sins_recommend, sins_requirement};
pub use record::*;
pub use run::sins_run;
pub use sample::*;
#[cfg(feature = "scenes")]
pub use scene::*;
pub use sensor_failure::*;
pub use settings::*;
pub use simulator::*;
pub use snapshot::*;
pub use solution::*;
pub use statistics::*;
pub use truth_summary::{sins_get_truth_summary, sins_truth_summary};
pub use unit::*;
pub use unit_status::*;
pub use version::*;

// That the sizes which the header states are those of the structs; a smaller library lacks some of these.
#[cfg(all(feature = "scenes", feature = "identify"))]
include!(concat!(env!("OUT_DIR"), "/sizes.rs"));

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    /// Paths of the files below a folder.
    fn files(folder: &Path) -> Vec<PathBuf> {
        let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        entries.flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] }).collect()
    }

    #[test]
    fn committed_files_are_the_generated_ones() {
        let folder = Path::new(env!("SINS_GENERATED"));
        let generated = files(folder);
        assert!(generated.contains(&folder.join("include/sins_functions.h")), "{generated:?}");
        for path in generated {
            let name = path.strip_prefix(folder).unwrap().to_str().unwrap();
            let project = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
            let committed = std::fs::read_to_string(project.join(name)).unwrap_or_default();
            assert!(
                std::fs::read_to_string(&path).unwrap() == committed,
                "{name} is not what src/abi declares; renew it with: SINS_WRITE_HEADER=1 cargo check -p header"
            );
        }
    }
}
