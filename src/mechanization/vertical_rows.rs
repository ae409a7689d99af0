//! The vertical loops of many runs side by side.

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
    /// The interval and the gains that loops share.
    shared: VerticalLoop,
}

impl VerticalRows {
    /// Loops that have found no error yet.
    pub fn new() -> Self {
        Self { bias_m_s2: [0.0; RUNS], residual_m: [0.0; RUNS], t: [0.0; RUNS], shared: VerticalLoop::new() }
    }

    /// Stores a loop.
    #[inline(always)]
    pub fn put(&mut self, lane: usize, channel: &VerticalLoop) {
        self.bias_m_s2[lane] = channel.bias_m_s2;
        self.residual_m[lane] = channel.residual_m;
        self.t[lane] = channel.t;
        if channel.t != 0.0 && channel.t != self.shared.t {
            self.shared = *channel;
        }
    }

    /// The loop at `lane`.
    #[inline(always)]
    pub fn get(&self, lane: usize) -> VerticalLoop {
        let (bias_m_s2, residual_m, t) = (self.bias_m_s2[lane], self.residual_m[lane], self.t[lane]);
        if t == self.shared.t {
            self.shared.with(bias_m_s2, residual_m)
        } else {
            VerticalLoop::of_interval(t).with(bias_m_s2, residual_m)
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
        self.shared.skip();
        self.t = [self.shared.t; RUNS];
    }

    /// Begins an interval of length `t` [s] of loops that [are alike](Self::are_alike). Returns what [`Self::answer`] needs.
    #[inline(always)]
    pub fn begin(&mut self, t: f64) -> Beginning {
        let is_first = self.shared.begin(t);
        self.t = [self.shared.t; RUNS];
        Beginning { shared: self.shared, is_first }
    }

    /// The corrections of the loop at `lane` for the residual `residual_m` [m].
    #[inline(always)]
    pub fn answer(&mut self, lane: usize, residual_m: f64, beginning: &Beginning) -> VerticalCorrection {
        let before_m = if beginning.is_first { residual_m } else { self.residual_m[lane] };
        let mut channel = beginning.shared.with(self.bias_m_s2[lane], before_m);
        let correction = channel.answer(residual_m);
        self.bias_m_s2[lane] = channel.bias_m_s2;
        self.residual_m[lane] = channel.residual_m;
        correction
    }
}

/// The values that the loops share in an interval. They are passed by value: the compiler cannot assume that rows do not overlap a
/// reference.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Beginning {
    shared: VerticalLoop,
    is_first: bool,
}

/// Aid of the vertical channels of a block.
#[derive(Debug, Clone, Copy)]
pub(crate) enum AidOfEach<'a> {
    /// The same for all: none, or the truth.
    Same(VerticalAid),
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
            Self::Same(aid) => aid,
            Self::Some { is_none, .. } if is_none[lane] => VerticalAid::None,
            Self::Barometer { heights_m } | Self::Some { heights_m, .. } => {
                VerticalAid::Barometer { height_m: heights_m[lane] }
            }
        }
    }
}
