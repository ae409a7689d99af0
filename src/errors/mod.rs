//! The two error outputs: navigation minus truth (the paper's error data 2), and the error differential equations driven
//! by the same sensor errors (error data 1); and the accuracy figures computed from navigation minus truth.

mod accuracy;
mod carried;
pub mod correction;
pub mod covariance;
mod difference;
mod model;

pub use accuracy::{Accuracy, AccuracyFigures, SCHULER_S};
pub use carried::CarriedErrors;
pub use difference::navigation_minus_truth;
pub use model::{ErrorModel, SensorErrors};
pub(crate) use model::{ModelBatch, ModelInterval, column};
use model::{VALID_DISPLACEMENT_M, VALID_MISALIGNMENT_RAD};

use nalgebra::Vector3;

/// Whether errors with these squares, of position [m²] and of misalignment [rad²], are small enough for the linear equations.
pub(crate) fn are_linear(position2: f64, misalignment2: f64) -> bool {
    position2 < VALID_DISPLACEMENT_M * VALID_DISPLACEMENT_M
        && misalignment2 < VALID_MISALIGNMENT_RAD * VALID_MISALIGNMENT_RAD
}

/// Errors of a solution, computed less true. Angles are wrapped differences.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct NavigationErrors {
    /// Position [m]: displacement from truth along true east and north, and difference of heights.
    pub position_n: Vector3<f64>,
    /// Latitude [rad].
    pub latitude_rad: f64,
    /// Longitude [rad]; has no meaning near a pole.
    pub longitude_rad: f64,
    /// Velocity [m/s]: difference of the components, each solution in its own axes east-north-up.
    pub velocity_n: Vector3<f64>,
    /// Misalignment φ [rad]: computed C = (I - [φ×]) C for the attitude of sensor axes in east-north-up.
    pub misalignment_n: Vector3<f64>,
    /// Roll [rad].
    pub roll_rad: f64,
    /// Pitch [rad].
    pub pitch_rad: f64,
    /// Heading [rad].
    pub heading_rad: f64,
    /// Whether the states of the linear model are so large that the terms that it drops are no longer small.
    pub outside_validity: bool,
}
