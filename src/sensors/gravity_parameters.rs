//! Parameters of the gravity disturbance, from their table.

use super::gravity_table::GRAVITY;
use crate::base::error::Error;
use crate::base::rows::check;
use crate::base::snapshot::{ANY, stored};

// The checks and numbers, which build.rs writes from the table.
include!(concat!(env!("OUT_DIR"), "/gravity.rs"));

/// One component of the disturbance: a constant part, and a random one with the correlation σ² exp(-d/D) over the distance d.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GravityField {
    /// Constant part [u].
    pub mean: f64,
    /// Standard deviation of the random part [u].
    pub sigma: f64,
    /// D, correlation distance of the random part [m].
    pub distance_m: f64,
}

stored!(GravityField { mean: ANY, sigma: ANY, distance_m: ANY });

/// True gravity less normal gravity. All zero is the normal field.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GravityDisturbanceParameters {
    /// ξ, the deflection of the vertical in the meridian: astronomic less geodetic latitude [rad].
    pub deflection_north: GravityField,
    /// η, the deflection of the vertical in the prime vertical: astronomic less geodetic longitude, times the cosine of latitude
    /// [rad].
    pub deflection_east: GravityField,
    /// Δg, excess of gravity along the vertical [m/s²].
    pub anomaly: GravityField,
}

stored!(GravityDisturbanceParameters { deflection_north, deflection_east, anomaly });

impl GravityDisturbanceParameters {
    pub(crate) fn fields(&self) -> [&GravityField; 3] {
        [&self.deflection_north, &self.deflection_east, &self.anomaly]
    }
}
