//! Gravity disturbance: true gravity less the normal gravity that the INS computes, along the track, as random fields.

use nalgebra::Vector3;

use super::effects::MarkovStep;
use super::gravity_parameters::GravityDisturbanceParameters;
use super::kept::Kept;
use super::stream::{Purpose, Source, Stream, StreamKey};
use crate::base::error::Error;
use crate::base::snapshot::{Numbers, Reader, Stored, WALKS, Writer, stored};
use crate::earth::Earth;
use crate::truth::TruthPoint;

/// The disturbance along the track of a flight: first-order Gauss-Markov fields, stationary at the start and discretised
/// exactly over the distance flown over ground.
#[derive(Debug, Clone, PartialEq)]
pub struct GravityDisturbance {
    parameters: GravityDisturbanceParameters,
    is_on: bool,
    field: Kept<Field>,
}

/// State of the fields along the flight.
#[derive(Debug, Clone, PartialEq)]
struct Field {
    has_moved: bool,
    /// Fields of unit variance.
    x: [f64; 3],
    streams: [Stream; 3],
}

/// Fields that have not moved are not stored, because they equal new ones.
impl Stored for Field {
    fn save(&self, to: &mut Writer<'_>) {
        let Self { has_moved, x, streams } = self;
        has_moved.save(to);
        if *has_moved {
            Numbers::save(x, to);
            streams.save(to);
        }
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        from.enter("snapshot: GravityDisturbance");
        let Self { has_moved, x, streams } = self;
        has_moved.load(from)?;
        if *has_moved {
            Numbers::load(x, from, WALKS)?;
            streams.load(from)?;
        }
        Ok(())
    }
}

stored!(GravityDisturbance { field } rebuilt { parameters, is_on });

impl GravityDisturbance {
    /// The normal field. Random parts that are set later draw from the streams of `key`.
    pub fn new(key: StreamKey) -> Self {
        let mut streams = Stream::triad(key, Source::Gravity, Purpose::GaussMarkov);
        let x = [0, 1, 2].map(|field| streams[field].normal());
        Self {
            parameters: GravityDisturbanceParameters::default(),
            is_on: false,
            field: Kept::new(Field { has_moved: false, x, streams }),
        }
    }

    /// Takes validated parameters.
    pub fn set(&mut self, parameters: &GravityDisturbanceParameters) {
        self.parameters = *parameters;
        self.is_on = parameters.fields().iter().any(|field| field.mean != 0.0 || field.sigma != 0.0);
    }

    /// Whether true gravity differs from normal gravity.
    #[inline]
    pub fn is_on(&self) -> bool {
        self.is_on
    }

    /// Distance over ground from `current` to `next` [m].
    pub(crate) fn over_ground(earth: &Earth, current: &TruthPoint, next: &TruthPoint) -> f64 {
        let v_e = (current.state.v_e + next.state.v_e) * 0.5;
        let horizontal_e = v_e - next.up_e * next.up_e.dot(&v_e);
        let a = earth.equatorial_radius_m;
        let over_ground = a / (a + next.height_m());
        horizontal_e.norm_squared().sqrt() * next.interval_s * over_ground
    }

    /// Moves the fields on from `current` to `next`, which [`Self::undo`] can undo. The distance over ground follows from the
    /// velocity, because the ideal signals follow from the velocity too. Where nothing moves, the fields do not change.
    pub fn advance(&mut self, earth: &Earth, current: &TruthPoint, next: &TruthPoint) {
        self.field.keep();
        let distance_m = Self::over_ground(earth, current, next);
        if distance_m > 0.0 {
            self.advance_by(distance_m);
        }
    }

    /// Undoes the last interval.
    pub fn undo(&mut self) {
        self.field.undo();
    }

    fn advance_by(&mut self, distance_m: f64) {
        let fields = self.parameters.fields();
        let Field { has_moved, x, streams } = &mut *self.field;
        for ((x, stream), field) in x.iter_mut().zip(streams).zip(fields) {
            if field.sigma > 0.0 {
                *has_moved = true;
                MarkovStep::new(distance_m, field.distance_m).advance(x, stream);
            }
        }
    }

    /// True less normal gravity at `point`, Earth-fixed axes [m/s²]: (-γ η, -γ ξ, -Δg) along east, north and up (Heiskanen and
    /// Moritz 1967, chapter 2: the astronomic zenith is ξ north and η east of the ellipsoid's normal).
    pub fn at(&self, earth: &Earth, point: &TruthPoint) -> Vector3<f64> {
        Self::of_fields(earth, point, self.values())
    }

    /// True less normal gravity at `point`, Earth-fixed axes [m/s²], for given deflections ξ, η [rad] and anomaly [m/s²].
    pub(crate) fn of_fields(earth: &Earth, point: &TruthPoint, [xi, eta, anomaly]: [f64; 3]) -> Vector3<f64> {
        let (east, north, up) = earth.east_north_up(point.place());
        let normal = point.gravity_e.norm_squared().sqrt();
        east * (-normal * eta) + north * (-normal * xi) - up * anomaly
    }

    /// Current ξ, η [rad] and Δg [m/s²].
    fn values(&self) -> [f64; 3] {
        let fields = self.parameters.fields();
        [0, 1, 2].map(|i| fields[i].mean + fields[i].sigma * self.field.x[i])
    }
}
