//! Linear covariance analysis: the covariance of the navigation errors along the truth, by the equations of error data 1.
//!
//! The errors x are those of the linear model in Earth-fixed axes, ψ, δv, δr, with the two states of the vertical loop; local
//! terms of either frame follow from them. They are driven by the random quantities of a run: initial errors, among them those that
//! an alignment derives from the sensor errors; constants drawn once a run; Gauss-Markov processes, of which flicker is a sum;
//! random walks; white noise. Each process is independent of the others, so that only x and its covariance with each process need
//! to be propagated:
//! ```text
//! x = S β + L ξ        β processes of unit variance, ξ what was random before
//! β⁺ = a β + s w       a² + s² = 1, exact for any step
//! x⁺ = Φ x + γ β + δ w + what is new
//! S⁺ = a (Φ S + γ) + s δ
//! L⁺ of [Φ L, s (Φ S + γ) - a δ, what is new]     by reflections
//! ```
//! Φ, γ and δ are computed with the linear model itself, on unit columns, over stretches of up to a second. Within a stretch the truth
//! is integrated sample by sample, and each process counts as a straight line of the same integral and first moment (`line`).
//!
//! It is the covariance about the mean, so it does not contain constant errors (given biases, steps and spikes of failures, the
//! constant parts of gravity). An axis whose failure lets through a share of its signal has this share of each column. The mean of
//! what random drop-outs lose is propagated beside it: where it is beyond the linear equations, the covariance is wrong from then on.

mod alignment;
mod factor;
mod figures;
mod line;
mod means;
mod passage;
mod propagation;
mod read;
mod root;
mod snapshot;
mod sources;
mod stretch;

pub(crate) use alignment::SteadyAlignment;
pub use figures::{ErrorEllipse, Matrix9, NavigationCovariance};
pub(crate) use means::{Signals, Variances};
pub(crate) use propagation::{Propagation, StartErrors};
pub(crate) use sources::RandomErrors;
pub(crate) use stretch::FlownInterval;
