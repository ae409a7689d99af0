//! Earth, truth, navigation and its error equations, against closed forms and references.

#[path = "../support/mod.rs"]
mod support;

mod convergence;
mod earth;
mod embedded_flights;
mod error_equations;
mod invariants;
mod logged_flights;
mod mathematics;
#[cfg(feature = "scenes")]
mod misprints;
mod reference_signals;
mod savage;
mod simulation1;
mod simulation2;
mod start_at_rest;
mod start_in_motion;
mod vertical_loop;
