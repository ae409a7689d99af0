//! The error of an algorithm: its solution less a far more accurate solution on the same signals.

use core::ops::ControlFlow;

use super::{Refusal, Rung, Setup};
use crate::base::error::Error;
use crate::base::math::{relative_rotation, rotation_vector};
use crate::base::memory::room;
use crate::earth::state::EarthFixedState;
use crate::mechanization::{Frame, MAX_SUBSAMPLES, Scheme};
use crate::simulator::{MAX_UPDATES, Simulator, Step};
use crate::truth::FlightSample;

/// The largest error of a solution over the instants at which it was compared.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SolutionError {
    /// Distance [m].
    pub position_m: f64,
    /// Speed of the difference in velocity against the Earth [m/s].
    pub velocity_m_s: f64,
    /// Angle between the attitudes against the Earth [rad]. Roll, pitch and heading also differ by the position error over the
    /// Earth's radius.
    pub attitude_rad: f64,
}

impl From<[f64; 3]> for SolutionError {
    fn from([position_m, velocity_m_s, attitude_rad]: [f64; 3]) -> Self {
        Self { position_m, velocity_m_s, attitude_rad }
    }
}

impl SolutionError {
    /// Position, velocity and attitude.
    pub fn parts(&self) -> [f64; 3] {
        [self.position_m, self.velocity_m_s, self.attitude_rad]
    }

    fn with(&self, other: &Self, of: impl Fn(f64, f64) -> f64) -> Self {
        let (one, other) = (self.parts(), other.parts());
        [0, 1, 2].map(|part| of(one[part], other[part])).into()
    }

    /// The sum of two errors.
    pub fn plus(&self, other: &Self) -> Self {
        self.with(other, |one, other| one + other)
    }

    /// This error times a factor.
    pub fn times(&self, factor: f64) -> Self {
        self.with(self, |one, _| one * factor)
    }

    /// The larger of two errors, part by part.
    pub fn max(&self, other: &Self) -> Self {
        self.with(other, f64::max)
    }

    /// The largest ratio of the error to a limit, of the limits that are not 0.
    ///
    /// A limit below 1e-100 counts as 1e-100: no solution is as good, and the ratio of the largest predicted error stays finite.
    pub fn share_of(&self, limits: &Self) -> f64 {
        let share = |error: f64, limit: f64| if limit > 0.0 { error / limit.max(1e-100) } else { 0.0 };
        self.with(limits, share).parts().into_iter().fold(0.0, f64::max)
    }

    /// Keeps the difference of `state` from `reference` if it is larger.
    fn include(&mut self, state: &EarthFixedState, reference: &EarthFixedState) {
        let rotation = rotation_vector(&relative_rotation(&reference.q_eb, &state.q_eb));
        self.position_m = self.position_m.max((state.r_e - reference.r_e).norm_squared().sqrt());
        self.velocity_m_s = self.velocity_m_s.max((state.v_e - reference.v_e).norm_squared().sqrt());
        self.attitude_rad = self.attitude_rad.max(rotation.norm_squared().sqrt());
    }
}

/// A solution at some instants.
#[derive(Debug, Clone, PartialEq)]
pub struct Track {
    /// The states, in order of time.
    pub states: Vec<EarthFixedState>,
}

impl Track {
    /// The largest difference from `other`, which has the same instants.
    pub fn minus(&self, other: &Self) -> SolutionError {
        let mut worst = SolutionError::default();
        for (state, other) in self.states.iter().zip(&other.states) {
            worst.include(state, other);
        }
        worst
    }
}

/// Flies `samples`. Calls `look` after each step, with the index of the sample that ended the step and the simulator, until it breaks.
pub(crate) fn fly_looking(
    simulator: &mut Simulator,
    samples: impl Iterator<Item = Result<FlightSample, Error>>,
    mut look: impl FnMut(usize, &mut Simulator) -> Result<ControlFlow<()>, Error>,
) -> Result<(), Refusal> {
    for (index, sample) in samples.enumerate() {
        let mut step = || {
            simulator.push_sample(&sample?)?;
            Ok(match simulator.step()? {
                Step::Done => look(index, simulator)?,
                Step::NeedSample => ControlFlow::Continue(()),
            })
        };
        if step().map_err(|error| Refusal { error, sample: Some(index), piece: 0 })?.is_break() {
            break;
        }
    }
    Ok(())
}

/// Flies `samples` with a simulator before its first sample and looks at the navigated solution at each of `instants`, indices
/// of samples that ascend from 1.
pub fn track(
    simulator: &mut Simulator,
    samples: &[FlightSample],
    instants: &[usize],
) -> Result<Track, Refusal> {
    let earth = simulator.options().earth();
    let mut states = room(instants.len())?;
    let mut instants = instants.iter().peekable();
    fly_looking(simulator, samples.iter().copied().map(Ok), |index, simulator| {
        if instants.next_if(|&&instant| instant == index).is_some()
            && let Some(solution) = simulator.navigation()?
        {
            states.push(solution.navigation.earth_fixed(&earth));
        }
        Ok(if instants.peek().is_some() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) })
    })?;
    Ok(Track { states })
}

/// A solution that is far more accurate than the solutions that are compared with it.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// The solution.
    pub track: Track,
    /// The change with half as many updates, plus the rounding of a solution that is read. The error of the reference is smaller by
    /// the scheme's order, down to that rounding.
    pub uncertainty: SolutionError,
}

impl Reference {
    /// Four units in the last place of the Earth's radius, of √(g R) and of a radian.
    const ROUNDING: SolutionError =
        SolutionError { position_m: 5.7e-9, velocity_m_s: 7.1e-12, attitude_rad: 8.9e-16 };

    /// The polynomial scheme with the most subsamples and updates in Earth-fixed axes, on the physical signals; only mounting,
    /// sensor axes, Earth, gravity, vertical channel and time base of `setup` count.
    ///
    /// Geographic axes give the same solution within the uncertainty, at 1.3 times the cost.
    pub fn new(setup: &Setup, samples: &[FlightSample], instants: &[usize]) -> Result<Self, Refusal> {
        let finest =
            Rung { scheme: Scheme::Polynomial, subsamples: MAX_SUBSAMPLES, updates_per_sample: MAX_UPDATES };
        let coarser = Rung { updates_per_sample: MAX_UPDATES / 2, ..finest };
        let mut setup = setup.physical();
        setup.options.frame = Frame::EarthFixed;
        let fly = |rung: &Rung| track(&mut setup.with(rung).simulator()?[0], samples, instants);
        let track = fly(&finest)?;
        let change = fly(&coarser)?.minus(&track);
        Ok(Self { track, uncertainty: change.plus(&Self::ROUNDING) })
    }

    /// [`Self::new`] at the end of each interval of `samples`.
    pub(super) fn everywhere(setup: &Setup, samples: &[FlightSample]) -> Result<Self, Refusal> {
        let mut instants = room(samples.len())?;
        instants.extend(1..samples.len());
        Self::new(setup, samples, &instants)
    }

    /// The worst difference of the solution of `setup` on the physical signals, where this one was looked at at each of
    /// `samples`; the worst until then if `give_up` answers that it is bad enough.
    pub(super) fn error_of(
        &self,
        setup: &Setup,
        samples: &[FlightSample],
        mut give_up: impl FnMut(&SolutionError) -> bool,
    ) -> Result<SolutionError, Refusal> {
        let earth = setup.options.earth();
        let mut memory = setup.physical().simulator()?;
        let mut worst = SolutionError::default();
        let mut states = self.track.states.iter();
        fly_looking(&mut memory[0], samples.iter().copied().map(Ok), |_, simulator| {
            if let (Some(state), Some(solution)) = (states.next(), simulator.navigation()?) {
                worst.include(&solution.navigation.earth_fixed(&earth), state);
            }
            Ok(if give_up(&worst) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) })
        })?;
        Ok(worst)
    }
}
