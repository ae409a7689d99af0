//! Data of an interval that all blocks of runs share.

use nalgebra::Vector3;

use crate::earth::Earth;
use crate::errors::ModelInterval;
use crate::mechanization::VerticalAid;
use crate::mounting;
use crate::sensors::SharedInput;
use crate::signal::{Increment, IntervalMotion};
use crate::simulator::chain::Chain;
use crate::simulator::{Imperfections, Options};
use crate::truth::{Recent, TruthPoint};

/// Data of an interval that all blocks share.
pub(super) struct Interval<'a> {
    pub earth: &'a Earth,
    pub options: &'a Options,
    pub imperfections: &'a Imperfections,
    pub shared: &'a [SharedInput; 2],
    /// Whether a gyro and whether an accelerometer has failed.
    pub have_failed: [bool; 2],
    /// Solution at the start of the interval.
    pub last_good: LastGood,
    /// Length of the interval [s]; `dt` is the length of its increments [s].
    pub t: f64,
    pub dt: f64,
    /// Number of increments.
    pub count: usize,
    /// Aid of the vertical channel. If the altimeters have errors, it holds the true height.
    pub aid: VerticalAid,
    /// Whether each run has an altimeter of its own.
    pub has_altimeters: bool,
    /// Interval of the error models, if they are on.
    pub model: Option<ModelInterval<'a>>,
    pub recent: &'a Recent<'a>,
    pub motion: &'a IntervalMotion<'a>,
    /// Error-free increments, without gravity beyond the normal field.
    pub ideal: &'a [Increment],
    /// The mounting, if there is one; `shift_e` is by how much it shifts the navigators [m/s], Earth-fixed axes.
    pub mounting: Option<&'a mounting::Block>,
    pub shift_e: Option<Vector3<f64>>,
    /// Whether what all runs share is within its limits.
    pub is_shared_good: bool,
}

impl Interval<'_> {
    /// The mounting of a run whose sensors gave `measured` in the whole interval.
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
    /// Length of the interval that led to this solution [s]; 0: the solution is the start.
    pub interval_s: f64,
}

impl LastGood {
    /// The solution of the runs of `chain` while the truth is at `point`.
    pub fn of(chain: &Chain, point: &TruthPoint) -> Self {
        Self { time_s: point.time_s, interval_s: chain.imu().map_or(0.0, |imu| imu.interval_s) }
    }
}
