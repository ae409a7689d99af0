//! The strapdown mechanization (the paper's equations (7)-(24)): from measured increments to position, velocity and
//! attitude.
//!
//! It has a body-frame part ([`BodyMotion`]) and a navigation-frame part (Earth-fixed or geographic); each scheme is a pair of
//! them.
//!
//! | equations | what | file |
//! |---|---|---|
//! | (12), (13), (18)-(20) | sums of the increments, rotation vector with its coning term, velocity with its sculling term | `body`; of a polynomial through the increments, `polynomial` |
//! | (7)-(11), (14)-(17) | rates of the navigation axes, attitude | `geographic`; with the rate of the Earth alone, `earth_fixed` |
//! | (21)-(24) | velocity and position, with gravity and Coriolis terms | the same |
//! | none | height and velocity up, kept near the truth or an altimeter | `vertical` |
//! | none | many runs side by side | `lanes`, `vertical_rows` |

mod body;
mod branches;
mod earth_fixed;
mod geographic;
mod lanes;
mod limits;
mod norm;
mod polynomial;
mod scratch;
mod vertical;
mod vertical_rows;

pub use body::{BodyMotion, MAX_SUBSAMPLES};
pub(crate) use earth_fixed::displaced_vertical;
pub(crate) use lanes::NavigatorBatch;
pub(crate) use limits::check_state;
use limits::{WELL_WITHIN_M, check, quick_height};
pub(crate) use scratch::Scratch;
pub use vertical::{VerticalAid, VerticalCorrection, VerticalLoop, VerticalMode, VerticalState};
pub(crate) use vertical_rows::{AidOfEach, VerticalRows};

use nalgebra::{Quaternion, Vector3};

use crate::base::error::Error;
use crate::base::math::{relative_rotation, rotation_vector};
use crate::base::snapshot::{codes, stored, variants};
use crate::earth::Earth;
use crate::earth::state::{BodyAxes, EarthFixedState, Navigation};
use crate::signal::Increment;
use earth_fixed::EarthFixed;
use geographic::Geographic;

/// Axes in which the mechanization integrates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Frame {
    /// Navigation in Earth-fixed axes: regular everywhere, poles included.
    // Wander azimuth axes leave a hundred times the error in a loop, though far less than any sensor causes, and take 1.1 to 1.6
    // times the time (`benches/src/frames.rs`).
    #[default]
    EarthFixed,
    /// Navigation in east-north-up, as in the paper. The mechanization returns SINS_ERROR_SINGULAR within 6.4 km of a pole. It
    /// also returns this error if the vehicle moves in one update by more than 1 % of its distance to the pole. For example, at
    /// 250 m/s with updates of 1 s this is within 25 km.
    Geographic,
}

/// Algorithms of the mechanization.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scheme {
    /// Coning, sculling and exact rotation compensation; Earth terms from the middle of the update.
    #[default]
    Exact,
    /// The paper's equations (7)-(24), misprints corrected, approximations kept.
    Paper,
    /// As SINS_SCHEME_EXACT, with rate and force as polynomials through the subsamples: for large rotations within an update.
    Polynomial,
}

codes!(Frame { EarthFixed = 0 "earth", Geographic = 1 "geographic" });
codes!(Scheme { Exact = 0 "exact", Paper = 1 "paper", Polynomial = 2 "polynomial" });

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
enum FrameState {
    EarthFixed(EarthFixed),
    Geographic(Geographic),
}

variants!(FrameState { EarthFixed, Geographic });

/// The navigator.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mechanization {
    earth: Earth,
    scheme: Scheme,
    solution: MechanizationState,
}

/// The part of the state that changes from one update to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MechanizationState {
    axes: FrameState,
    vertical: VerticalLoop,
}

stored!(Mechanization { solution } rebuilt { earth, scheme } then |navigator, _| navigator.check());
stored!(MechanizationState { axes, vertical });

impl Mechanization {
    /// Cosine of the latitude within which the geographic axes turn too fast: 6.4 km from a pole.
    pub const MIN_COS_LATITUDE: f64 = 1e-3;

    /// Largest turn of the geographic axes about the vertical in an update [rad]. Up to this turn the error is less than 2e-6 of
    /// the distance at which a pole is passed (tests/robustness/poles.rs); beyond it the error grows with the fourth power of the
    /// turn.
    pub const MAX_TURN_RAD: f64 = 0.01;

    /// Starts from `state`.
    pub fn new(earth: Earth, frame: Frame, scheme: Scheme, state: &EarthFixedState) -> Self {
        let axes = match frame {
            Frame::EarthFixed => FrameState::EarthFixed(EarthFixed::new(&earth, state)),
            Frame::Geographic => FrameState::Geographic(Geographic::new(&earth, state)),
        };
        Self { earth, scheme, solution: MechanizationState { axes, vertical: VerticalLoop::new() } }
    }

    /// This navigator with the solution `state`; its vertical channel continues.
    pub(crate) fn moved_to(&self, state: &EarthFixedState) -> Self {
        let axes = match self.solution.axes {
            FrameState::EarthFixed(_) => FrameState::EarthFixed(EarthFixed::new(&self.earth, state)),
            FrameState::Geographic(_) => FrameState::Geographic(Geographic::new(&self.earth, state)),
        };
        Self { solution: MechanizationState { axes, ..self.solution }, ..*self }
    }

    /// The part that [`Self::go_back`] needs.
    #[inline]
    pub(crate) fn solution(&self) -> MechanizationState {
        self.solution
    }

    /// Restores a former solution.
    pub(crate) fn go_back(&mut self, solution: &MechanizationState) {
        self.solution = *solution;
    }

    /// Checks that the solution is within its limits. A NaN in a sum stays there.
    #[inline(always)]
    pub fn check(&self) -> Result<(), Error> {
        match &self.solution.axes {
            FrameState::EarthFixed(axes) if axes.is_far_within(WELL_WITHIN_M) => Ok(()),
            _ => self.check_closely(),
        }
    }

    #[inline(never)]
    fn check_closely(&self) -> Result<(), Error> {
        let (height, speed2, q) = match &self.solution.axes {
            FrameState::EarthFixed(axes) => {
                let state = axes.state();
                (quick_height(&self.earth, &state.r_e), state.v_e.norm_squared(), state.q_eb)
            }
            FrameState::Geographic(axes) => {
                axes.check()?;
                (axes.observe_vertical().0, axes.speed2(), axes.q())
            }
        };
        check(height, speed2, q.norm_squared() - 1.0)
    }

    /// One update of length `t` [s] on 1 to [`MAX_SUBSAMPLES`] increments of equal length.
    pub fn update(&mut self, increments: &[Increment], t: f64) {
        let body = BodyMotion::of(self.scheme, increments);
        match (self.scheme, &mut self.solution.axes) {
            (Scheme::Paper, FrameState::EarthFixed(axes)) => axes.update_paper(&self.earth, &body, t),
            (Scheme::Paper, FrameState::Geographic(axes)) => axes.update_paper(&self.earth, &body, t),
            (_, FrameState::EarthFixed(axes)) => axes.update(&self.earth, &body, t),
            (_, FrameState::Geographic(axes)) => axes.update(&self.earth, &body, t),
        }
    }

    /// Navigates on the increments of an interval of length `t` [s], in updates of `subsamples` subsamples.
    pub(crate) fn navigate(&mut self, increments: &[Increment], subsamples: usize, t: f64) {
        let updates = increments.chunks_exact(subsamples);
        let update_s = t / updates.len() as f64;
        for update in updates {
            self.update(update, update_s);
        }
    }

    /// Corrects the vertical channel at the end of an interval of length `t` [s].
    pub fn aid_vertical(&mut self, aid: &VerticalAid, t: f64) {
        if *aid == VerticalAid::None {
            return self.solution.vertical.skip();
        }
        let MechanizationState { axes, vertical } = &mut self.solution;
        let mut correct = |height: f64, velocity_up: f64| match *aid {
            VerticalAid::None => VerticalCorrection::to_truth(0.0, 0.0, t),
            VerticalAid::Truth { height_m, velocity_up_m_s } => {
                VerticalCorrection::to_truth(height_m - height, velocity_up_m_s - velocity_up, t)
            }
            VerticalAid::Barometer { height_m } => vertical.correct(height - height_m, t),
        };
        match axes {
            FrameState::EarthFixed(axes) => {
                let (up, height, velocity_up) = axes.observe_vertical(&self.earth);
                axes.shift_vertical(&self.earth, &up, &correct(height, velocity_up));
            }
            FrameState::Geographic(axes) => {
                let (height, velocity_up) = axes.observe_vertical();
                axes.shift_vertical(&self.earth, &correct(height, velocity_up));
            }
        }
    }

    /// Begins the loop of the vertical channel anew if its estimate is beyond `limit_m_s2`.
    pub(crate) fn limit_vertical_bias(&mut self, limit_m_s2: f64) {
        self.solution.vertical.limit_bias(limit_m_s2);
    }

    /// Adds `dv_e` [m/s], Earth-fixed axes, to the velocity.
    pub fn shift_velocity(&mut self, dv_e: &Vector3<f64>) {
        match &mut self.solution.axes {
            FrameState::EarthFixed(axes) => axes.shift_velocity(dv_e),
            FrameState::Geographic(axes) => axes.shift_velocity(dv_e),
        }
    }

    /// The solution less `truth`.
    pub fn minus(&self, truth: &EarthFixedState) -> StateDifference {
        match &self.solution.axes {
            FrameState::EarthFixed(axes) => axes.minus(truth),
            FrameState::Geographic(axes) => {
                let state = axes.state(&self.earth);
                StateDifference::new(state.r_e - truth.r_e, state.v_e - truth.v_e, &state.q_eb, truth)
            }
        }
    }

    /// The solution of a navigator in Earth-fixed axes.
    #[inline(always)]
    pub(crate) fn earth_fixed(&self) -> Option<EarthFixedState> {
        match &self.solution.axes {
            FrameState::EarthFixed(axes) => Some(axes.state()),
            FrameState::Geographic(_) => None,
        }
    }

    /// The solution in Earth-fixed axes.
    pub fn state(&self) -> EarthFixedState {
        match &self.solution.axes {
            FrameState::EarthFixed(axes) => axes.state(),
            FrameState::Geographic(axes) => axes.state(&self.earth),
        }
    }

    /// The solution in geographic terms.
    #[inline]
    pub fn navigation(&self, axes: BodyAxes) -> Navigation {
        match &self.solution.axes {
            FrameState::EarthFixed(state) => state.state().navigation(&self.earth, axes),
            FrameState::Geographic(state) => state.navigation(axes),
        }
    }
}
