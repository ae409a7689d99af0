//! What is flown: which runs in which blocks, and at which samples statistics are taken.

use sins::ErrorSource;

use super::command::Order;
use crate::failure::Failure;
use crate::given::Given;

/// Runs of a block. A block is flown by one thread and goes into the checkpoint as a whole, so it is the work that an interruption
/// costs. The results are the same with any size: [`Statistics::merge`](sins::statistics::Statistics) is exact.
pub const BLOCK: u64 = 64;

/// Rows of statistics in an ordinary order, and at the most: a row of all threads is in memory.
const ROWS: f64 = 200.0;
const MOST_ROWS: usize = 2000;

/// Runs at the most: the error at the end of each is kept.
pub const MOST_RUNS: u64 = 10_000_000;

/// Runs that are drawn one by one: the first ones.
pub const DRAWN_RUNS: u64 = 8;

/// An ensemble.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    pub first_run: u64,
    pub runs: u64,
    /// The samples at which statistics are taken, in order: the first one, each `every` intervals, and the last one.
    pub instants: Vec<usize>,
    /// Intervals between them.
    pub every: usize,
    pub sources: Vec<ErrorSource>,
}

impl Plan {
    pub fn new(order: &Order, given: &Given) -> Result<Self, Failure> {
        let intervals = given.count - 1;
        let every = match order.every {
            None => (intervals as f64 / ROWS).round().max(1.0),
            Some(every_s) => (every_s / given.period_s).round(),
        };
        if !(every >= 1.0 && intervals as f64 / every < MOST_ROWS as f64) {
            let what = format!(
                "--every {}: expected at least the sample interval, {:.6} s, and at most {MOST_ROWS} rows, so {:.6} s",
                order.every.unwrap_or_default(),
                given.period_s,
                given.duration_s / MOST_ROWS as f64
            );
            return Err(Failure::new(what));
        }
        let every = (every as usize).min(intervals);
        let mut instants: Vec<usize> = (0..=intervals).step_by(every).collect();
        if !intervals.is_multiple_of(every) {
            instants.push(intervals);
        }
        let mut sources = vec![ErrorSource::Navigation];
        if given.scene.options.error_model {
            sources.push(ErrorSource::Model);
        }
        let first_run = order.first_run.unwrap_or(given.scene.options.key.run);
        if !(1..=MOST_RUNS).contains(&order.runs) || first_run.checked_add(order.runs).is_none() {
            let what = format!(
                "--runs {}: expected 1 to {MOST_RUNS}, with --first-run {first_run} below 2^64",
                order.runs
            );
            return Err(Failure::new(what));
        }
        Ok(Self { first_run, runs: order.runs, instants, every, sources })
    }

    pub fn blocks(&self) -> usize {
        self.runs.div_ceil(BLOCK) as usize
    }

    /// First run and number of runs of the block `index`.
    pub fn block(&self, index: usize) -> (u64, u64) {
        let before = index as u64 * BLOCK;
        (self.first_run + before, BLOCK.min(self.runs - before))
    }

    /// How many runs are drawn.
    pub fn drawn(&self) -> u64 {
        DRAWN_RUNS.min(self.runs)
    }

    /// Number of statistics: of each source at each instant.
    pub fn count(&self) -> usize {
        self.instants.len() * self.sources.len()
    }
}
