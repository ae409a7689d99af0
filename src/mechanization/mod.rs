//! The strapdown mechanization (the paper's equations (7)-(24)): from measured increments to position, velocity and
//! attitude.
//!
//! A body-frame piece ([`BodyMotion`]) and a navigation-frame piece (Earth-fixed or geographic); each scheme is a pair.

mod body;
mod branches;
mod earth_fixed;
mod geographic;
mod lanes;
mod polynomial;
mod vertical;

pub use body::{BodyMotion, MAX_SUBSAMPLES};
pub(crate) use earth_fixed::displaced_vertical;
pub(crate) use lanes::{AidOfEach, NavigatorBlock, Scratch, is_for_lanes};
use vertical::KeptLoop;
pub use vertical::{VerticalAid, VerticalCorrection, VerticalLoop, VerticalMode, VerticalState};

use nalgebra::{Quaternion, Vector3};

use crate::earth::Earth;
use crate::error::{Error, ErrorKind, Rule};
use crate::math::{Compensated, relative_rotation, rotation_vector};
use crate::signal::Increment;
use crate::snapshot::{codes, stored, variants};
use crate::state::{BodyAxes, EarthFixedState, Navigation};
use earth_fixed::EarthFixed;
use geographic::Geographic;

/// In which axes the mechanization navigates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Frame {
    /// Earth-fixed: regular everywhere. Wander azimuth leaves a hundred times the error in a loop, far below that of any sensor,
    /// and takes 1.1 to 1.6 times the time (`benches/src/frames.rs`).
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

/// Heights above the ellipsoid [m] and speed [m/s] beyond which a solution counts as diverged: far outside of what a sample may
/// be, far inside of what the equations can represent.
const HEIGHTS_M: (f64, f64) = (-500e3, 20_000e3);
const MAX_SPEED_M_S: f64 = 100e3;

/// Distances from the centre of any ellipsoid that are within these heights whatever the latitude [m].
const WELL_WITHIN_M: (f64, f64) = (6.0e6, 26.0e6);

/// What the squared norm of an attitude's quaternion may be off 1 by.
const MAX_NORM_ERROR: f64 = 1e-12;

/// What the squared norm lacks to 1, beyond which the first order of the correction is not enough.
const SMALL_NORM_ERROR: f64 = 1e-8;

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
    solution: Solution,
}

/// What changes from one update to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Solution {
    axes: Axes,
    vertical: VerticalLoop,
}

/// A solution to which [`Mechanization::go_back`] goes back, without what follows from the rest.
#[derive(Debug, Clone, Copy)]
pub(crate) struct KeptSolution {
    axes: Axes,
    vertical: KeptLoop,
}

stored!(Mechanization { solution } rebuilt { earth, scheme } then |navigator, _| navigator.check());
stored!(Solution { axes, vertical });

impl Mechanization {
    /// Cosine of the latitude within which the geographic axes turn too fast: 6.4 km from a pole.
    pub const MIN_COS_LATITUDE: f64 = 1e-3;

    /// Turn of the geographic axes about the vertical that an update may make [rad]: up to here it costs less than
    /// 2e-6 of the distance at which a pole is passed (tests/robustness/poles.rs), beyond it grows with the fourth power.
    pub const MAX_TURN_RAD: f64 = 0.01;

    /// Starts from `state`.
    pub fn new(earth: Earth, frame: Frame, scheme: Scheme, state: &EarthFixedState) -> Self {
        let axes = match frame {
            Frame::EarthFixed => Axes::EarthFixed(EarthFixed::new(&earth, state)),
            Frame::Geographic => Axes::Geographic(Geographic::new(&earth, state)),
        };
        Self { earth, scheme, solution: Solution { axes, vertical: VerticalLoop::new() } }
    }

    /// The same navigator with the solution `state`; its vertical channel goes on.
    pub(crate) fn moved_to(&self, state: &EarthFixedState) -> Self {
        let axes = match self.solution.axes {
            Axes::EarthFixed(_) => Axes::EarthFixed(EarthFixed::new(&self.earth, state)),
            Axes::Geographic(_) => Axes::Geographic(Geographic::new(&self.earth, state)),
        };
        Self { solution: Solution { axes, ..self.solution }, ..*self }
    }

    /// What [`Self::go_back`] needs.
    #[inline]
    pub(crate) fn kept(&self) -> KeptSolution {
        KeptSolution { axes: self.solution.axes, vertical: self.solution.vertical.kept() }
    }

    /// The solution is again the one that was kept.
    pub(crate) fn go_back(&mut self, kept: &KeptSolution) {
        self.solution.axes = kept.axes;
        self.solution.vertical.go_back(&kept.vertical);
    }

    /// Checks that the solution is within its limits. The comparisons fail for NaN too, which any of the sums keeps.
    #[inline(always)]
    pub fn check(&self) -> Result<(), Error> {
        match &self.solution.axes {
            Axes::EarthFixed(axes) if axes.is_far_within(WELL_WITHIN_M) => Ok(()),
            _ => self.check_closely(),
        }
    }

    #[inline(never)]
    fn check_closely(&self) -> Result<(), Error> {
        let (height, speed2, q) = match &self.solution.axes {
            Axes::EarthFixed(axes) => {
                let state = axes.state();
                (quick_height(&self.earth, &state.r_e), state.v_e.norm_squared(), state.q_eb)
            }
            Axes::Geographic(axes) => {
                axes.check()?;
                (axes.observe_vertical().0, axes.speed2(), axes.q())
            }
        };
        let norm_error = q.norm_squared() - 1.0;
        if is_good(height, speed2) && norm_error.abs() <= MAX_NORM_ERROR {
            return Ok(());
        }
        diverged(height, speed2, norm_error)
    }

    /// One update of length `t` [s] on 1 to [`MAX_SUBSAMPLES`] increments of equal length.
    pub fn update(&mut self, increments: &[Increment], t: f64) {
        let body = BodyMotion::of(self.scheme, increments);
        match (self.scheme, &mut self.solution.axes) {
            (Scheme::Paper, Axes::EarthFixed(axes)) => axes.update_paper(&self.earth, &body, t),
            (Scheme::Paper, Axes::Geographic(axes)) => axes.update_paper(&self.earth, &body, t),
            (_, Axes::EarthFixed(axes)) => axes.update(&self.earth, &body, t),
            (_, Axes::Geographic(axes)) => axes.update(&self.earth, &body, t),
        }
    }

    /// Keeps the vertical channel, at the end of an interval of length `t` [s].
    pub fn aid_vertical(&mut self, aid: &VerticalAid, t: f64) {
        if *aid == VerticalAid::None {
            return self.solution.vertical.skip();
        }
        let Solution { axes, vertical } = &mut self.solution;
        let mut correct = |height: f64, velocity_up: f64| match *aid {
            VerticalAid::None => VerticalCorrection::to_truth(0.0, 0.0, t),
            VerticalAid::Truth { height_m, velocity_up_m_s } => {
                VerticalCorrection::to_truth(height_m - height, velocity_up_m_s - velocity_up, t)
            }
            VerticalAid::Barometer { height_m } => vertical.correct(height - height_m, t),
        };
        match axes {
            Axes::EarthFixed(axes) => {
                let (up, height, velocity_up) = axes.observe_vertical(&self.earth);
                axes.shift_vertical(&self.earth, &up, &correct(height, velocity_up));
            }
            Axes::Geographic(axes) => {
                let (height, velocity_up) = axes.observe_vertical();
                axes.shift_vertical(&self.earth, &correct(height, velocity_up));
            }
        }
    }

    /// Adds `dv_e` [m/s], Earth-fixed axes, to the velocity.
    pub fn shift_velocity(&mut self, dv_e: &Vector3<f64>) {
        match &mut self.solution.axes {
            Axes::EarthFixed(axes) => axes.shift_velocity(dv_e),
            Axes::Geographic(axes) => axes.shift_velocity(dv_e),
        }
    }

    /// The solution less `truth`.
    pub fn minus(&self, truth: &EarthFixedState) -> StateDifference {
        match &self.solution.axes {
            Axes::EarthFixed(axes) => axes.minus(truth),
            Axes::Geographic(axes) => {
                let state = axes.state(&self.earth);
                StateDifference::new(state.r_e - truth.r_e, state.v_e - truth.v_e, &state.q_eb, truth)
            }
        }
    }

    /// The solution in Earth-fixed axes.
    pub fn state(&self) -> EarthFixedState {
        match &self.solution.axes {
            Axes::EarthFixed(axes) => axes.state(),
            Axes::Geographic(axes) => axes.state(&self.earth),
        }
    }

    /// The solution in geographic terms.
    #[inline]
    pub fn navigation(&self, axes: BodyAxes) -> Navigation {
        match &self.solution.axes {
            Axes::EarthFixed(state) => state.state().navigation(&self.earth, axes),
            Axes::Geographic(state) => state.navigation(axes),
        }
    }
}

/// Checks the height and the speed of `state` as [`Mechanization::check`] does.
pub(crate) fn check_state(earth: &Earth, state: &EarthFixedState) -> Result<(), Error> {
    let (height, speed2) = (quick_height(earth, &state.r_e), state.v_e.norm_squared());
    if is_good(height, speed2) { Ok(()) } else { diverged(height, speed2, 0.0) }
}

/// (r² - a²) / 2a, more than the height outside and less than 50 km from it inside, where it says enough; else the height [m].
#[inline]
fn quick_height(earth: &Earth, r_e: &Vector3<f64>) -> f64 {
    let a = earth.equatorial_radius_m;
    let height = (r_e.norm_squared() - a * a) / (2.0 * a);
    let (low, high) = HEIGHTS_M;
    if height > low + 50e3 && height < high { height } else { earth.vertical(r_e).height_m }
}

#[inline]
fn is_good(height: f64, speed2: f64) -> bool {
    let (low, high) = HEIGHTS_M;
    height > low && height < high && speed2 < MAX_SPEED_M_S * MAX_SPEED_M_S
}

#[cold]
fn diverged(height: f64, speed2: f64, norm_error: f64) -> Result<(), Error> {
    let (low, high) = HEIGHTS_M;
    let (field, value, rule) = if !(height > low && height < high) {
        ("navigated height_m", height, Rule::Between(low, high))
    } else if speed2 < MAX_SPEED_M_S * MAX_SPEED_M_S {
        ("navigated attitude: squared norm of the quaternion", 1.0 + norm_error, Rule::Words("must be 1"))
    } else {
        ("navigated speed_m_s", speed2.sqrt(), Rule::Below(MAX_SPEED_M_S))
    };
    Err(Error::of(ErrorKind::Diverged, field, value, rule))
}

/// Brings the norm of a quaternion to 1: adds what it lacks, at once, as along the quaternion of the next update, which can be
/// turned by any angle from this one, it would be no correction.
///
/// Evidence: rotation vectors of 1e8 rad and more, of accepted sensors, have lost the digits that make a quaternion of them; the
/// first order alone left a squared norm of 0.001.
#[inline]
fn renormalize(q: &mut Compensated<4>) {
    let lack = 1.0 - q.value.norm_squared();
    if lacks_much(lack) {
        *q = Compensated::new(q.value / q.value.norm_squared().sqrt());
    } else {
        correct_norm(q, lack);
    }
}

/// Whether the first order of the correction is not enough.
#[inline(always)]
fn lacks_much(lack: f64) -> bool {
    lack.abs() > SMALL_NORM_ERROR
}

/// Adds what the squared norm lacks, to the first order.
#[inline(always)]
fn correct_norm(q: &mut Compensated<4>, lack: f64) {
    q.add(&(q.value * (0.5 * lack)));
}
