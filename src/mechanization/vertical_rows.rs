//! The vertical loops of many runs side by side.

use super::vertical::Gains;
use super::{VerticalAid, VerticalCorrection, VerticalLoop};
use crate::signal::{RUNS, Row};

/// The state of each loop. Usually all loops have the gains of one interval; other gains follow from the length of their interval.
#[derive(Debug, Clone)]
#[repr(align(64))]
pub(crate) struct VerticalRows {
    bias_m_s2: Row,
    residual_m: Row,
    /// Length of the interval of a loop's gains [s]; 0: it has none.
    t: Row,
    /// The gains that loops share.
    shared: Gains,
}

impl VerticalRows {
    /// Loops that have found no error yet.
    pub fn new() -> Self {
        Self { bias_m_s2: [0.0; RUNS], residual_m: [0.0; RUNS], t: [0.0; RUNS], shared: Gains::NONE }
    }

    /// Stores a loop.
    #[inline(always)]
    pub fn put(&mut self, lane: usize, channel: &VerticalLoop) {
        let VerticalLoop { bias_m_s2, residual_m, gains } = *channel;
        (self.bias_m_s2[lane], self.residual_m[lane], self.t[lane]) = (bias_m_s2, residual_m, gains.t);
        if gains.t != 0.0 && gains.t != self.shared.t {
            self.shared = gains;
        }
    }

    /// The loop at `lane`.
    #[inline(always)]
    pub fn get(&self, lane: usize) -> VerticalLoop {
        let t = self.t[lane];
        VerticalLoop {
            bias_m_s2: self.bias_m_s2[lane],
            residual_m: self.residual_m[lane],
            gains: if t == self.shared.t { self.shared } else { Gains::new(t) },
        }
    }

    /// Restores the loop at `lane` from `before`.
    pub fn go_back(&mut self, lane: usize, before: &Self) {
        self.put(lane, &before.get(lane));
    }

    /// Whether all loops have the same gains.
    #[inline(always)]
    pub fn are_alike(&self) -> bool {
        self.t.iter().all(|t| *t == self.shared.t)
    }

    /// [`VerticalLoop::skip`] for all loops.
    pub fn skip(&mut self) {
        self.shared.t = 0.0;
        self.t = [0.0; RUNS];
    }

    /// Begins an interval of length `t` [s] of loops that [are alike](Self::are_alike). Returns what [`Self::answer`] needs.
    #[inline(always)]
    pub fn begin(&mut self, t: f64) -> Beginning {
        let is_first = self.shared.begin(t);
        self.t = [self.shared.t; RUNS];
        Beginning { gains: self.shared, is_first }
    }

    /// The corrections of the loop at `lane` for the residual `residual_m` [m].
    #[inline(always)]
    pub fn answer(&mut self, lane: usize, residual_m: f64, beginning: &Beginning) -> VerticalCorrection {
        let &Beginning { gains, is_first } = beginning;
        let before_m = if is_first { residual_m } else { self.residual_m[lane] };
        let mut channel = VerticalLoop { bias_m_s2: self.bias_m_s2[lane], residual_m: before_m, gains };
        let correction = channel.answer(residual_m);
        [self.bias_m_s2[lane], self.residual_m[lane]] = channel.states();
        correction
    }
}

/// The values that the loops share in an interval. They are passed by value: the compiler cannot assume that rows do not overlap a
/// reference.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Beginning {
    gains: Gains,
    is_first: bool,
}

/// Aid of the vertical channels of a batch.
#[derive(Debug, Clone, Copy)]
pub(crate) enum AidOfEach<'a> {
    /// No aid: the channels are free.
    None,
    /// The truth, as [`VerticalAid::Truth`].
    Truth { height_m: f64, velocity_up_m_s: f64 },
    /// A barometric height for each [m].
    Barometer { heights_m: &'a Row },
    /// A barometric height for each [m], or none.
    Some { heights_m: &'a Row, is_none: &'a [bool; RUNS] },
}

impl AidOfEach<'_> {
    /// The aid of the run at `lane`.
    #[inline(always)]
    pub fn at(&self, lane: usize) -> VerticalAid {
        match *self {
            Self::None => VerticalAid::None,
            Self::Truth { height_m, velocity_up_m_s } => VerticalAid::Truth { height_m, velocity_up_m_s },
            Self::Some { is_none, .. } if is_none[lane] => VerticalAid::None,
            Self::Barometer { heights_m } | Self::Some { heights_m, .. } => {
                VerticalAid::Barometer { height_m: heights_m[lane] }
            }
        }
    }
}
