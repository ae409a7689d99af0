//! The strapdown mechanization (the paper's equations (7)-(24)): from measured increments to position, velocity and
//! attitude.
//!
//! A body-frame piece ([`BodyMotion`]) and a navigation-frame piece (Earth-fixed or geographic); each scheme is a pair.

mod body;
mod earth_fixed;
mod geographic;
mod polynomial;
mod vertical;

pub use body::{BodyMotion, MAX_SUBSAMPLES};
pub(crate) use earth_fixed::displaced_vertical;
pub use vertical::{VerticalAid, VerticalCorrection, VerticalLoop, VerticalMode, VerticalState};

use nalgebra::{Quaternion, Vector3};

use crate::earth::Earth;
use crate::error::{Error, ErrorKind, Rule};
use crate::math::{Compensated, relative_rotation, rotation_vector};
use crate::signal::Increment;
use crate::snapshot::{Reader, codes, stored, variants};
use crate::state::{BodyAxes, EarthFixedState, Navigation};
use earth_fixed::EarthFixed;
use geographic::Geographic;

/// In which axes the mechanization navigates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Frame {
    /// Earth-fixed: regular everywhere. Wander azimuth would be as accurate; in 1.1 to 1.6 times the time
    /// (`benches/src/frames.rs`).
    #[default]
    EarthFixed,
    /// East-north-up: the paper's.
    Geographic,
}

/// Which algorithm.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scheme {
    /// Coning, sculling and exact rotation compensation, Earth terms of the middle of the update.
    #[default]
    Exact,
    /// The paper's, misprints mended, approximations kept.
    Paper,
    /// As `Exact`, with rate and force as polynomials through the subsamples.
    Polynomial,
}

codes!(Frame { EarthFixed = 0, Geographic = 1 });
codes!(Scheme { Exact = 0, Paper = 1, Polynomial = 2 });

/// What a solution has to stay within.
struct Bounds {
    /// Height above the ellipsoid [m].
    heights_m: (f64, f64),
    speed_m_s: f64,
    /// Cosine of the latitude, in geographic axes.
    cos_latitude: f64,
}

/// Beyond these the solution counts as diverged, or singular: far outside of what a sample may be, far inside of what the
/// equations can represent.
const LIMITS: Bounds =
    Bounds { heights_m: (-500e3, 20_000e3), speed_m_s: 100e3, cos_latitude: Mechanization::MIN_COS_LATITUDE };

/// From within these an interval of at most [`Mechanization::TAME_CHANGE_M_S`] and [`Mechanization::TAME_INTERVAL_S`] does
/// not lead beyond the limits.
const SAFE: Bounds = Bounds { heights_m: (-100e3, 2100e3), speed_m_s: 40e3, cos_latitude: 0.06 };

/// A solution less the truth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StateDifference {
    /// Position, Earth-fixed axes [m].
    pub r_e: Vector3<f64>,
    /// Velocity, Earth-fixed axes [m/s].
    pub v_e: Vector3<f64>,
    /// Rotation vector from the true to the computed body axes [rad].
    pub rotation_b: Vector3<f64>,
}

impl StateDifference {
    fn new(r_e: Vector3<f64>, v_e: Vector3<f64>, q_eb: &Quaternion<f64>, truth: &EarthFixedState) -> Self {
        Self { r_e, v_e, rotation_b: rotation_vector(&relative_rotation(&truth.q_eb, q_eb)) }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Axes {
    EarthFixed(EarthFixed),
    Geographic(Geographic),
}

variants!(Axes { EarthFixed, Geographic });

/// The navigator.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mechanization {
    earth: Earth,
    scheme: Scheme,
    axes: Axes,
    vertical: VerticalLoop,
}

stored!(Mechanization { axes, vertical } rebuilt { earth, scheme } then |navigator, _| navigator.check());

impl Mechanization {
    /// Cosine of the latitude within which the geographic axes turn too fast: 6.4 km from a pole.
    pub const MIN_COS_LATITUDE: f64 = 1e-3;

    /// Turn of the geographic axes about the vertical that an update may make [rad]: up to here it costs less than
    /// 2e-6 of the distance at which a pole is passed (tests/hard_poles.rs), beyond it grows with the fourth power.
    pub const MAX_TURN_RAD: f64 = 0.01;

    /// Change of velocity [m/s] and length [s] of an interval that leads from a safe solution to a good one.
    pub const TAME_CHANGE_M_S: f64 = 50e3;
    /// See [`Self::TAME_CHANGE_M_S`].
    pub const TAME_INTERVAL_S: f64 = 2.5;

    /// Starts from `state`.
    pub fn new(earth: Earth, frame: Frame, scheme: Scheme, state: &EarthFixedState) -> Self {
        let axes = match frame {
            Frame::EarthFixed => Axes::EarthFixed(EarthFixed::new(&earth, state)),
            Frame::Geographic => Axes::Geographic(Geographic::new(&earth, state)),
        };
        Self { earth, scheme, axes, vertical: VerticalLoop::new() }
    }

    /// Whether the solution is within its limits.
    pub fn check(&self) -> Result<(), Error> {
        self.check_within(&LIMITS)
    }

    /// Whether the solution is so far within them that no tame interval leads beyond: of length `t` [s], with a change of the
    /// velocity of at most `change_m_s`.
    pub fn is_safe(&self, t: f64, change_m_s: f64) -> bool {
        let turns_slowly = match &self.axes {
            Axes::EarthFixed(_) => true,
            Axes::Geographic(axes) => {
                let distance = (axes.speed2().sqrt() + change_m_s) * t;
                axes.turn_over(&self.earth, distance) < 0.5 * Self::MAX_TURN_RAD
            }
        };
        turns_slowly && self.check_within(&SAFE).is_ok()
    }

    fn check_within(&self, bounds: &Bounds) -> Result<(), Error> {
        let (height, speed2) = match &self.axes {
            Axes::EarthFixed(axes) => {
                let state = axes.state();
                // (r² - a²) / 2a, more than the height outside and less than 50 km from it inside, where it says enough.
                let a = self.earth.equatorial_radius_m;
                let mut height = (state.r_e.norm_squared() - a * a) / (2.0 * a);
                let (low, high) = bounds.heights_m;
                if !(height > low + 50e3 && height < high) {
                    height = self.earth.vertical(&state.r_e).height_m;
                }
                (height, state.v_e.norm_squared())
            }
            Axes::Geographic(axes) => {
                let cos = axes.cos_latitude();
                if cos < bounds.cos_latitude {
                    let words = "the geographic mechanization needs a distance to the pole, as the cosine of latitude, of at least";
                    let rule = Rule::WordsAnd(words, bounds.cos_latitude);
                    return Err(Error::of(
                        ErrorKind::Singular,
                        "cosine of the navigated latitude",
                        cos,
                        rule,
                    ));
                }
                let turn = axes.largest_turn();
                if turn > Self::MAX_TURN_RAD {
                    let words =
                        "this close to a pole needs shorter updates or Earth-fixed axes; must be at most";
                    let rule = Rule::WordsAnd(words, Self::MAX_TURN_RAD);
                    return Err(Error::of(
                        ErrorKind::Singular,
                        "turn of the geographic axes in an update",
                        turn,
                        rule,
                    ));
                }
                (axes.observe_vertical().0, axes.speed2())
            }
        };
        let diverged = |field, value, rule| Err(Error::of(ErrorKind::Diverged, field, value, rule));
        // The comparisons are false for NaN too.
        let (low, high) = bounds.heights_m;
        let (height_is_good, speed_is_good) =
            (height > low && height < high, speed2 < bounds.speed_m_s * bounds.speed_m_s);
        if !height_is_good {
            return diverged("navigated height_m", height, Rule::Between(low, high));
        }
        if !speed_is_good {
            return diverged("navigated speed_m_s", speed2.sqrt(), Rule::Below(bounds.speed_m_s));
        }
        Ok(())
    }

    /// One update of length `t` [s] on 1 to [`MAX_SUBSAMPLES`] increments of equal length.
    pub fn update(&mut self, increments: &[Increment], t: f64) {
        let body = match self.scheme {
            Scheme::Exact => BodyMotion::exact(increments),
            Scheme::Paper => BodyMotion::paper(increments),
            Scheme::Polynomial => BodyMotion::polynomial(increments),
        };
        match (self.scheme, &mut self.axes) {
            (Scheme::Paper, Axes::EarthFixed(axes)) => axes.update_paper(&self.earth, &body, t),
            (Scheme::Paper, Axes::Geographic(axes)) => axes.update_paper(&self.earth, &body, t),
            (_, Axes::EarthFixed(axes)) => axes.update(&self.earth, &body, t),
            (_, Axes::Geographic(axes)) => axes.update(&self.earth, &body, t),
        }
    }

    /// Keeps the vertical channel, at the end of an interval of length `t` [s].
    pub fn aid_vertical(&mut self, aid: &VerticalAid, t: f64) {
        if *aid == VerticalAid::None {
            return self.vertical.skip();
        }
        let (height, velocity_up) = match &mut self.axes {
            Axes::EarthFixed(axes) => axes.observe_vertical(&self.earth),
            Axes::Geographic(axes) => axes.observe_vertical(),
        };
        let correction = match *aid {
            VerticalAid::None => return,
            VerticalAid::Truth { height_m, velocity_up_m_s } => {
                VerticalCorrection::to_truth(height_m - height, velocity_up_m_s - velocity_up, t)
            }
            VerticalAid::Barometer { height_m } => self.vertical.correct(height - height_m, t),
        };
        match &mut self.axes {
            Axes::EarthFixed(axes) => axes.shift_vertical(&self.earth, &correction),
            Axes::Geographic(axes) => axes.shift_vertical(&self.earth, &correction),
        }
    }

    /// Adds `dv_e` [m/s], Earth-fixed axes, to the velocity.
    pub fn shift_velocity(&mut self, dv_e: &Vector3<f64>) {
        match &mut self.axes {
            Axes::EarthFixed(axes) => axes.shift_velocity(dv_e),
            Axes::Geographic(axes) => axes.shift_velocity(dv_e),
        }
    }

    /// The solution less `truth`.
    pub fn minus(&self, truth: &EarthFixedState) -> StateDifference {
        match &self.axes {
            Axes::EarthFixed(axes) => axes.minus(truth),
            Axes::Geographic(axes) => {
                let state = axes.state(&self.earth);
                StateDifference::new(state.r_e - truth.r_e, state.v_e - truth.v_e, &state.q_eb, truth)
            }
        }
    }

    /// The solution in Earth-fixed axes.
    pub fn state(&self) -> EarthFixedState {
        match &self.axes {
            Axes::EarthFixed(axes) => axes.state(),
            Axes::Geographic(axes) => axes.state(&self.earth),
        }
    }

    /// The solution in geographic terms.
    pub fn navigation(&self, axes: BodyAxes) -> Navigation {
        match &self.axes {
            Axes::EarthFixed(state) => state.state().navigation(&self.earth, axes),
            Axes::Geographic(state) => state.navigation(axes),
        }
    }
}

/// Refuses a quaternion that is none of a rotation.
fn check_rotation(q: &Compensated<4>, from: &Reader<'_>) -> Result<(), Error> {
    let norm2 = q.value.norm_squared();
    if (norm2 - 1.0).abs() <= 1e-6 {
        return Ok(());
    }
    Err(from.refused(norm2, Rule::Words("the attitude's quaternion must have the norm 1")))
}

/// Adds what the norm of a quaternion lacks to 1, at once: along the quaternion of the next update, which can be turned by
/// any angle from this one, it would be no correction.
#[inline]
fn renormalize(q: &mut Compensated<4>) {
    let correction = 0.5 * (1.0 - q.value.norm_squared());
    q.add(&(q.value * correction));
}
