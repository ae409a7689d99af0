//! The program `sins` from its command line to its output and its files.

mod allan;
mod budget;
mod checked;
#[cfg(unix)]
mod columns;
mod complete_files;
mod conditions;
mod curve;
#[cfg(target_os = "linux")]
mod doors;
#[allow(dead_code, reason = "these tests use a part of it")]
#[path = "../../../../tests/support/draws.rs"]
mod draws;
mod ensemble;
mod fdr;
mod flight_records;
mod fly;
mod identify;
mod imu;
mod increments;
mod inputs;
mod judged;
mod live;
mod log;
mod numbers;
mod outputs;
mod pages;
#[cfg(target_os = "linux")]
mod progress;
#[cfg(target_os = "linux")]
mod same_records;
#[cfg(target_os = "linux")]
#[path = "../../../../tests/support/scenes/mod.rs"]
mod scenes;
mod several_files;
mod support;
mod unit;
mod written;
