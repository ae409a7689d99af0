//! The parameters beside those of gyros and accelerometers, from their tables.

mod table;

pub use table::{ALTIMETER, GRAVITY, INITIAL, MOUNTING, START};

use nalgebra::Vector3;

use crate::base::checks::check_numbers;
use crate::base::error::Error;
use crate::base::math::Euler;
use crate::base::parameter::Row;
use crate::base::snapshot::{ANY, codes, stored};
use crate::earth::Ellipsoid;

// The structs with their checks and numbers, which build.rs writes from the tables.
include!(concat!(env!("OUT_DIR"), "/surroundings.rs"));

/// How the INS finds its attitude at the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Alignment {
    /// The INS starts with the true attitude, turned by the given and the drawn misalignment.
    #[default]
    Given,
    /// The library computes the attitude that levelling and gyrocompassing at rest would find with the sensor errors at the
    /// start. It does so even if the flight starts in motion. The INS starts with this attitude, turned by the given and the
    /// drawn misalignment. Levelling comes first: it finds the tilt at which the accelerometers sense the reaction to normal gravity. At
    /// height this is not quite along the ellipsoid's normal: its horizontal part is 7.5 micro-g at 9 km and 45 degrees.
    /// Gyrocompassing then finds the heading at which the horizontal gyro rates point north. SINS_NAVIGATION_NORTH_UNKNOWN is set
    /// if the sensor errors hide north. Within 64 km of a pole the start returns SINS_ERROR_SINGULAR.
    LevelAndGyrocompass,
    /// The library computes the attitude that levelling at rest would find with the sensor errors at the start, with the true heading:
    /// the heading of a unit whose gyros cannot find north comes from another sensor. The INS starts with this attitude, turned by the
    /// given and the drawn misalignment, whose part about up is the heading error. Any latitude.
    Level,
}

codes!(Alignment { Given = 0 "given", LevelAndGyrocompass = 1 "gyrocompass", Level = 2 "level" });

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

/// Every row of an error.
pub(crate) fn rows() -> impl Iterator<Item = &'static Row> {
    [ALTIMETER.as_slice(), &INITIAL, &MOUNTING, &GRAVITY].into_iter().flatten()
}

/// Of the numbers of all rows those of the row with the field `path` of the interface; of another field none.
pub(crate) fn of_path<'r, 'n>(
    rows: impl IntoIterator<Item = &'r Row>,
    numbers: impl IntoIterator<Item = &'n mut f64>,
    path: &str,
) -> impl Iterator<Item = &'n mut f64> {
    let found = places(rows.into_iter()).find(|(row, _)| row.field.path == path);
    let (start, count) = found.map_or((0, 0), |(row, start)| (start, row.shape.count()));
    numbers.into_iter().skip(start).take(count)
}

/// The rows, each with the place of its first number.
pub(crate) fn places<'r>(rows: impl Iterator<Item = &'r Row>) -> impl Iterator<Item = (&'r Row, usize)> {
    rows.scan(0, |end, row| {
        *end += row.shape.count();
        Some((row, *end - row.shape.count()))
    })
}

/// Copies the numbers of a struct.
pub(crate) fn copy<const N: usize>(from: [f64; N], to: [&mut f64; N]) {
    to.into_iter().zip(from).for_each(|(to, from)| *to = from);
}

/// Checks the numbers of all rows of a table.
pub(crate) fn check(rows: &[Row], numbers: &[f64]) -> Result<(), Error> {
    let numbers_of = |(row, start): (&Row, usize)| &numbers[start..start + row.shape.count()];
    for (row, start) in places(rows.iter()) {
        check_numbers(&row.field, row.shape, numbers_of((row, start)), |sigma| {
            let of = places(rows.iter()).find(|(row, _)| row.field.path == sigma);
            (sigma, of.map_or(&[], numbers_of))
        })?;
    }
    Ok(())
}
