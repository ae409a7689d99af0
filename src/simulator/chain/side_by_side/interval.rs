//! What an interval brings to all blocks of runs.

use nalgebra::Vector3;

use crate::earth::Earth;
use crate::errors::ModelInterval;
use crate::mechanization::VerticalAid;
use crate::mounting;
use crate::sensors::SharedInput;
use crate::signal::{Increment, IntervalMotion};
use crate::simulator::{Imperfections, Options};
use crate::truth::Recent;

/// What an interval brings to all blocks.
pub(super) struct Interval<'a> {
    pub earth: &'a Earth,
    pub options: &'a Options,
    pub imperfections: &'a Imperfections,
    pub shared: &'a [SharedInput; 2],
    /// Whether a gyro and whether an accelerometer has failed.
    pub have_failed: [bool; 2],
    /// At its start.
    pub last_good: LastGood,
    /// Length [s], and that of its increments.
    pub t: f64,
    pub dt: f64,
    /// Number of increments.
    pub count: usize,
    /// Of altimeters with errors the true height.
    pub aid: VerticalAid,
    /// Whether each run has an altimeter of its own.
    pub has_altimeters: bool,
    /// Where the error model is on.
    pub model: Option<ModelInterval<'a>>,
    pub recent: &'a Recent<'a>,
    pub motion: &'a IntervalMotion<'a>,
    /// Error-free increments, but for gravity beyond the normal field.
    pub ideal: &'a [Increment],
    /// Where there is a mounting, and by how much it shifts the navigators [m/s], Earth-fixed axes.
    pub mounting: Option<&'a mounting::Block>,
    pub shift_e: Option<Vector3<f64>>,
    /// Whether what all runs share is within its limits.
    pub is_shared_good: bool,
}

impl Interval<'_> {
    /// The mounting of a run, as its sensors see it that gave `measured` in the whole interval.
    pub fn mounting_of(&self, measured: &Increment) -> Option<mounting::Block> {
        self.mounting.map(|block| {
            let mut block = *block;
            block.observe(&Increment::sum(self.ideal), measured, self.t);
            block
        })
    }
}

/// The last good solution of a run that has diverged.
#[derive(Debug, Clone, Copy)]
pub(super) struct LastGood {
    /// Time [s].
    pub time_s: f64,
    /// Length of the interval that led to it [s]; 0: it is the start.
    pub interval_s: f64,
}
