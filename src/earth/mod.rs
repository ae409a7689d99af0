//! The Earth: reference ellipsoids, radii of curvature, geodetic coordinates, normal gravity.
//!
//! Earth-fixed axes: x to latitude 0, longitude 0; y to longitude 90° east; z to the north pole.

mod geodetic;
mod gravity;
mod position;
pub mod state;

pub(crate) use geodetic::navigation_axes_from_half_angles;
pub use geodetic::{Geodetic, Vertical, VerticalTrack, navigation_axes};
pub use gravity::GravityModel;

use crate::base::snapshot::codes;
use gravity::NormalField;

/// Ellipsoids.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Ellipsoid {
    /// World Geodetic System 1984.
    #[default]
    Wgs84, // NIMA TR8350.2, 2000
    /// China Geodetic Coordinate System 2000.
    Cgcs2000,
    /// Geodetic Reference System 1980.
    Grs80, // Moritz, 2000
    /// Krassovsky 1940; Earth rate and gravitational constant as WGS-84.
    Krassovsky1940,
}

codes!(Ellipsoid { Wgs84 = 0 "wgs84", Cgcs2000 = 1 "cgcs2000", Grs80 = 2 "grs80", Krassovsky1940 = 3 "krassovsky" });

/// An ellipsoid with its gravity field: the Earth model of every block of the simulator.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Earth {
    /// Equatorial radius a [m].
    pub equatorial_radius_m: f64,
    /// Flattening f.
    pub flattening: f64,
    /// First eccentricity squared e² = f (2 - f).
    pub eccentricity2: f64,
    /// Polar radius b = a (1 - f) [m].
    pub polar_radius_m: f64,
    /// Earth rate W relative to inertial space [rad/s].
    pub rate_rad_s: f64,
    /// Model of the field that [`Earth::gravity`] returns.
    pub gravity_model: GravityModel,
    field: NormalField,
}

/// Radii of curvature of the ellipsoid at a latitude [m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Radii {
    /// Radius in the meridian, RM = a (1 - e²) / (1 - e² sin²L)^1.5.
    pub meridian_m: f64,
    /// Radius in the prime vertical, RN = a / sqrt(1 - e² sin²L).
    pub transverse_m: f64,
}

impl Earth {
    /// The Earth of `ellipsoid` with the field `gravity_model`.
    pub fn new(ellipsoid: Ellipsoid, gravity_model: GravityModel) -> Self {
        // a [m], 1/f, GM [m³/s²], W [rad/s]
        let (a, inverse_flattening, gm, rate_rad_s) = match ellipsoid {
            Ellipsoid::Wgs84 => (6_378_137.0, 298.257_223_563, 3.986_004_418e14, 7.292_115e-5),
            Ellipsoid::Cgcs2000 => (6_378_137.0, 298.257_222_101, 3.986_004_418e14, 7.292_115e-5),
            Ellipsoid::Grs80 => (6_378_137.0, 298.257_222_100_882_7, 3.986_005e14, 7.292_115e-5),
            Ellipsoid::Krassovsky1940 => (6_378_245.0, 298.3, 3.986_004_418e14, 7.292_115e-5),
        };
        let flattening = 1.0 / inverse_flattening;
        let eccentricity2 = flattening * (2.0 - flattening);
        let polar_radius_m = a * (1.0 - flattening);
        Self {
            equatorial_radius_m: a,
            flattening,
            eccentricity2,
            polar_radius_m,
            rate_rad_s,
            gravity_model,
            field: NormalField::new(a, eccentricity2, polar_radius_m, gm, rate_rad_s),
        }
    }

    /// Radii of curvature where the sine of the latitude is `sin_latitude`.
    #[inline]
    pub fn radii(&self, sin_latitude: f64) -> Radii {
        let w2 = 1.0 - self.eccentricity2 * sin_latitude * sin_latitude;
        let transverse_m = self.equatorial_radius_m / w2.sqrt();
        Radii { meridian_m: transverse_m * (1.0 - self.eccentricity2) / w2, transverse_m }
    }
}

impl Default for Earth {
    /// WGS-84 with its closed-form normal gravity.
    fn default() -> Self {
        Self::new(Ellipsoid::default(), GravityModel::default())
    }
}
