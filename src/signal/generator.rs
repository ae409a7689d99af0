//! The generator: one interval after the other.

use super::Increment;
use super::derivatives::Stencil;
use super::motion::IntervalMotion;
use crate::truth::TruthPoint;

/// Sub-increments of an interval at the most: 5 subsamples of 16 updates.
pub const MAX_INCREMENTS: usize = 80;

/// Makes the ideal signals of the interval between each sample and the next.
#[derive(Debug, Clone)]
pub struct SignalGenerator {
    stencil: Stencil,
    earth_rate: f64,
    motion: Option<IntervalMotion>,
    increments: [Increment; MAX_INCREMENTS],
    count: usize,
}

impl SignalGenerator {
    /// Starts at the sample `first`, on an Earth that turns at `earth_rate` [rad/s], with `count` sub-increments an
    /// interval (1 to [`MAX_INCREMENTS`]).
    pub fn new(first: TruthPoint, earth_rate: f64, count: usize) -> Self {
        Self {
            stencil: Stencil::new(first, earth_rate),
            earth_rate,
            motion: None,
            increments: [Increment::ZERO; MAX_INCREMENTS],
            count: count.clamp(1, MAX_INCREMENTS),
        }
    }

    /// Moves on to the sample `next`; [`Self::increments`] and [`Self::motion`] then are those of the interval to it.
    pub fn advance(&mut self, next: &TruthPoint) {
        let (start, start_gravity_e) = (self.stencil.newest().state, self.stencil.newest().gravity_e);
        let ends = self.stencil.advance(next);
        let motion = IntervalMotion::new(&start, &start_gravity_e, next, &ends, self.earth_rate);
        motion.integrate(&mut self.increments[..self.count]);
        self.motion = Some(motion);
    }

    /// The newest sample.
    pub fn newest(&self) -> &TruthPoint {
        self.stencil.newest()
    }

    /// The ideal increments of the last interval.
    pub fn increments(&self) -> &[Increment] {
        &self.increments[..self.count]
    }

    /// The motion of the last interval.
    pub fn motion(&self) -> Option<&IntervalMotion> {
        self.motion.as_ref()
    }
}
