//! What batches of runs need for an interval.

use super::batch::State;
use super::disturbed::DisturbedWorkspace;
use crate::base::error::Error;
use crate::base::memory::{filled, room};
use crate::mechanization::Scratch;
use crate::signal::{Increment, IncrementRows, MAX_INCREMENTS, RUNS, Row};
use crate::simulator::{Imperfections, Options};

/// Memory that a step needs in addition to a batch.
#[derive(Debug)]
pub(super) struct Workspace {
    /// The state of the batch before the step.
    pub before: State,
    /// Measured increments, with room for the longest interval. They have their own allocation: otherwise the compiler
    /// cannot assume that they do not overlap the other fields.
    pub measured: Box<[IncrementRows]>,
    pub scratch: Scratch,
    /// Increments of a run that are compensated.
    pub compensated: Box<[Increment]>,
    pub heights_m: Row,
    pub is_unaided: [bool; RUNS],
    pub saturated: [[u64; RUNS]; 2],
    pub is_good: [u64; RUNS],
    pub disturbed: DisturbedWorkspace,
}

impl Workspace {
    /// For batches of `imperfections`. On the heap, because it is large for a stack.
    pub fn new(options: &Options, imperfections: &mut Imperfections) -> Result<Box<[Self]>, Error> {
        let mut memory = room(1)?;
        memory.push(Self {
            before: State::new(options, imperfections, RUNS)?,
            measured: filled(MAX_INCREMENTS, [[0.0; RUNS]; 6])?,
            scratch: Scratch::NONE,
            compensated: filled(MAX_INCREMENTS, Increment::ZERO)?,
            heights_m: [0.0; RUNS],
            is_unaided: [false; RUNS],
            saturated: [[0; RUNS]; 2],
            is_good: [0; RUNS],
            disturbed: DisturbedWorkspace::new(imperfections)?,
        });
        Ok(memory.into_boxed_slice())
    }

    /// Takes the indication `indicated_m` [m] of an altimeter at the true height `height_m` [m]; `None`: no signal.
    pub fn put_height(&mut self, lane: usize, height_m: f64, indicated_m: Option<f64>) {
        self.heights_m[lane] = indicated_m.unwrap_or(height_m);
        self.is_unaided[lane] = indicated_m.is_none();
    }
}
