//! Results of the library for a flight without single runs: recommendations, budgets, covariances, statistics.
#![allow(
    clippy::undocumented_unsafe_blocks,
    reason = "the tests keep the promises of the functions that they call, or break them on purpose"
)]

#[path = "../support/mod.rs"]
mod support;

#[cfg(feature = "scenes")]
mod covariance;
#[cfg(feature = "scenes")]
mod covariance_runs;
mod error_budget;
#[cfg(all(feature = "scenes", feature = "identify"))]
mod identify;
#[cfg(feature = "scenes")]
mod judge;
mod recommend;
#[cfg(feature = "scenes")]
mod smooth;
#[cfg(feature = "scenes")]
mod smooth_assumed;
#[cfg(feature = "scenes")]
mod smooth_cep;
#[cfg(feature = "scenes")]
mod smooth_kinds;
mod statistics;
mod truth_summary;
