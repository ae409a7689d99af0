//! Overlapping Allan variance, how much it can be trusted, and the noise coefficients that explain it.
//!
//! Nothing here reads a file or draws: the report program and the tests of the simulator include this folder alike. The
//! data flow is `deviation` → `terms`, `lags`, `covariance` → `fit` → `interval`, with the quantiles of `chi_square`.

pub mod chi_square;
pub mod covariance;
pub mod deviation;
pub mod fit;
pub mod interval;
pub mod lags;
pub mod terms;
