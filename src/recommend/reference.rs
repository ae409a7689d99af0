//! What an algorithm leaves: its solution against that of the same signals navigated far more finely.

use crate::error::Error;
use crate::math::{relative_rotation, rotation_vector};
use crate::mechanization::{MAX_SUBSAMPLES, Scheme};
use crate::simulator::{MAX_UPDATES, Options, Simulator};
use crate::state::EarthFixedState;
use crate::truth::FlightSample;

use super::Rung;

/// The error of a solution, the worst over the instants at which it was looked at.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SolutionError {
    /// Distance [m].
    pub position_m: f64,
    /// Speed of the difference in velocity against the Earth [m/s].
    pub velocity_m_s: f64,
    /// Angle between the attitudes [rad].
    pub attitude_rad: f64,
}

/// A solution at some instants.
#[derive(Debug, Clone, PartialEq)]
pub struct Track {
    /// The states, in order of time.
    pub states: Vec<EarthFixedState>,
}

impl Track {
    /// The worst difference from `other`, which has the same instants.
    pub fn minus(&self, other: &Self) -> SolutionError {
        let mut worst = SolutionError::default();
        for (state, other) in self.states.iter().zip(&other.states) {
            let SolutionError { position_m, velocity_m_s, attitude_rad } = &mut worst;
            let rotation = rotation_vector(&relative_rotation(&other.q_eb, &state.q_eb));
            *position_m = position_m.max((state.r_e - other.r_e).norm_squared().sqrt());
            *velocity_m_s = velocity_m_s.max((state.v_e - other.v_e).norm_squared().sqrt());
            *attitude_rad = attitude_rad.max(rotation.norm_squared().sqrt());
        }
        worst
    }
}

/// Flies `samples` with ideal sensors and looks at the navigated solution at each of `instants`, indices of samples that
/// ascend from 1.
pub fn fly(options: &Options, samples: &[FlightSample], instants: &[usize]) -> Result<Track, Error> {
    track(Simulator::new(options)?, samples, instants)
}

/// The same with a simulator that has sensor errors set.
pub fn track(mut simulator: Simulator, samples: &[FlightSample], instants: &[usize]) -> Result<Track, Error> {
    let earth = simulator.options().earth();
    let mut states = Vec::with_capacity(instants.len());
    let mut instants = instants.iter().peekable();
    for (index, sample) in samples.iter().enumerate() {
        simulator.push_sample(sample)?;
        simulator.step()?;
        if instants.next_if(|&&instant| instant == index).is_some()
            && let Some(solution) = simulator.navigation()?
        {
            states.push(solution.navigation.earth_fixed(&earth));
        }
    }
    Ok(Track { states })
}

/// A solution that is far better than those it judges.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// The solution.
    pub track: Track,
    /// What half as many updates change of it: its own error is smaller by the scheme's order, down to rounding.
    pub uncertainty: SolutionError,
}

impl Reference {
    /// The polynomial scheme with the most subsamples and updates; only axes, Earth, gravity, vertical channel and time base
    /// of `options` count.
    pub fn new(options: &Options, samples: &[FlightSample], instants: &[usize]) -> Result<Self, Error> {
        let finest =
            Rung { scheme: Scheme::Polynomial, subsamples: MAX_SUBSAMPLES, updates_per_sample: MAX_UPDATES };
        let coarser = Rung { updates_per_sample: MAX_UPDATES / 2, ..finest };
        let track = fly(&finest.applied_to(options), samples, instants)?;
        let uncertainty = fly(&coarser.applied_to(options), samples, instants)?.minus(&track);
        Ok(Self { track, uncertainty })
    }
}
