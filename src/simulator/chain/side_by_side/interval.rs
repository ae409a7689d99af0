//! What an interval brings to all blocks of runs, and what they need for it.

use nalgebra::Vector3;

use super::block::{LastGood, Report, failures, models};
use super::disturbed::DisturbedWorkspace;
use crate::earth::Earth;
use crate::error::Error;
use crate::errors::{ModelBlock, ModelInterval};
use crate::mechanization::{NavigatorBlock, Scratch, VerticalAid};
use crate::memory::room;
use crate::mounting;
use crate::sensors::{FailingTriad, SharedInput, StateRows};
use crate::signal::{Increment, IncrementRows, IntervalMotion, MAX_INCREMENTS, RUNS, Row};
use crate::simulator::{Options, SensorSuite};
use crate::truth::Recent;

/// What an interval brings to all blocks.
pub(super) struct Interval<'a> {
    pub earth: &'a Earth,
    pub options: &'a Options,
    pub sensors: &'a SensorSuite,
    pub shared: &'a [SharedInput; 2],
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
    /// Whether a gyro and whether an accelerometer has failed.
    pub fn have_failed(&self) -> [bool; 2] {
        [self.sensors.gyro.has_failed(), self.sensors.accel.has_failed()]
    }

    /// The mounting of a run, as its sensors see it that gave `measured` in the whole interval.
    pub fn mounting_of(&self, measured: &Increment) -> Option<mounting::Block> {
        self.mounting.map(|block| {
            let mut block = *block;
            block.observe(&Increment::sum(self.ideal), measured, self.t);
            block
        })
    }
}

/// What a step needs beside a block, and the block as it was before.
#[derive(Debug)]
pub(super) struct Workspace {
    /// Of the longest interval. By itself, or the compiler fears that it lies over the rest.
    pub measured: Box<[IncrementRows]>,
    pub scratch: Scratch,
    pub heights_m: Row,
    pub is_unaided: [bool; RUNS],
    pub saturated: [[u64; RUNS]; 2],
    pub is_good: [u64; RUNS],
    pub gyro: StateRows,
    pub accel: StateRows,
    pub navigators: NavigatorBlock,
    pub models: Box<[ModelBlock]>,
    pub failures: [Box<[FailingTriad]>; 2],
    pub reports: [Report; RUNS],
    pub sums: IncrementRows,
    pub disturbed: DisturbedWorkspace,
}

impl Workspace {
    /// For blocks with the sensors of `sensors`. On the heap, as it is much of a stack.
    pub fn new(options: &Options, sensors: &mut SensorSuite) -> Result<Box<[Self]>, Error> {
        let (gyro, accel) = (sensors.gyro.rows()?, sensors.accel.rows()?);
        let (mut memory, mut measured) = (room(1)?, room(MAX_INCREMENTS)?);
        measured.resize(MAX_INCREMENTS, [[0.0; RUNS]; 6]);
        memory.push(Self {
            measured: measured.into_boxed_slice(),
            scratch: Scratch::NONE,
            heights_m: [0.0; RUNS],
            is_unaided: [false; RUNS],
            saturated: [[0; RUNS]; 2],
            is_good: [0; RUNS],
            gyro,
            accel,
            navigators: NavigatorBlock::new(options.frame),
            models: models(options)?,
            failures: failures(sensors, RUNS)?,
            reports: [Report::default(); RUNS],
            sums: [[0.0; RUNS]; 6],
            disturbed: DisturbedWorkspace::new(sensors)?,
        });
        Ok(memory.into_boxed_slice())
    }

    /// An altimeter shows `indicated_m` at the true height `height_m` [m], or nothing.
    pub fn put_height(&mut self, lane: usize, height_m: f64, indicated_m: Option<f64>) {
        self.heights_m[lane] = indicated_m.unwrap_or(height_m);
        self.is_unaided[lane] = indicated_m.is_none();
    }
}
