//! The error budget: the contribution of each effect to the errors of a scene, the part that their sum does not explain,
//! and the effects that can be left out.
//!
//! With e the errors of a run (navigation minus truth: position, velocity and misalignment, each a vector over time), e0
//! those of the same run with nothing set, eE those with the effect E alone, and PE the covariance that E alone makes,
//!
//! ```text
//! contribution   dE(t) = eE(t) - e0(t)
//! deterministic  sE(t) = |dE(t)|
//! random         sE(t) = √(trace of PE(t))                        1σ, exact to first order: crate::errors::covariance
//! remainder      r(t)  = e(t) - e0(t) - Σ dE(t) - l(t)            e: all together, in each of N runs
//! ```
//!
//! A difference of misalignments is the rotation vector between the two attitudes, to first order that of the vectors. Each
//! is reported as its largest value over the scene's instants, and as its value at the end. l is the sum of the
//! random effects of the same run: error data 1 of a flight with them alone. The remainder is not a statistical figure: the
//! random numbers of an effect do not depend on what else is set. So the remainder is the action of effects on each other,
//! of second order.
//!
//! Out of N runs a root mean square of what is random is uncertain by the chi-square distribution of N degrees of freedom, at the
//! most: three axes that vary together have N, independent ones 3 N.
//!
//! What is left out together stays below a limit if √((Σ sE)² + Σ sE²) does, the first sum over the deterministic, the
//! second over the random effects among them. Effects join in the order of the
//! shares of the limits that they take up, smallest first. Then all is flown again without them; if what that changes is
//! beyond a limit (effects that do not add up: dead zones, ranges, quantization), the largest comes back.

mod contribution;
mod costs;
mod flight;
mod interval;
mod request;
mod selection;
mod survey;

pub use crate::simulator::{BudgetEffect, EFFECTS, ErrorParameters};
pub use costs::{Costs, step_costs_ns};
pub use flight::{ComputedSamples, MAX_SAMPLES, MIN_SAMPLES};
pub use interval::SigmaInterval;
pub use request::BudgetRequest;
pub use survey::{Budget, BudgetRow, error_budget};
