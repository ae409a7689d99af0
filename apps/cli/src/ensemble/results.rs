//! Results of the runs: statistics over time, the errors of each run at the end, and the errors of a few runs over time.

use sins::ensemble::statistics::Statistics;

use super::plan::{BLOCK, Piece, Plan};
use crate::failure::{Failure, Kind};

/// Errors of a run, east, north, up: position [m], velocity [m/s], misalignment [rad].
pub type State = [f64; 9];

/// Results of the runs of a piece of work.
pub struct Part {
    /// Statistics of each source at each instant; the sources of an instant are side by side.
    pub statistics: Vec<Statistics>,
    /// Errors of each run at the end; `None` for a run that diverged.
    pub ends: Vec<Option<State>>,
    /// Errors of the runs that are drawn, at each instant; a run that diverged has fewer instants.
    pub drawn: Vec<Vec<State>>,
    /// Numbers of the runs that diverged.
    pub diverged: Vec<u64>,
    /// Direction of the truth's track at each instant [rad].
    pub tracks: Vec<f64>,
    /// Number of runs within the limit of each requirement.
    pub inside: Vec<u64>,
    /// Number of runs in which a gyro was ever beyond its range; likewise an accelerometer.
    pub beyond_range: [u64; 2],
}

/// Results of all blocks that were flown so far.
#[derive(Debug, Clone, PartialEq)]
pub struct Results {
    /// Whether each block is in the results.
    pub done: Vec<bool>,
    /// Statistics in the order of [`Part`].
    pub statistics: Vec<Statistics>,
    /// Errors of each run at the end; `None` for a run that diverged or was not flown yet.
    pub ends: Vec<Option<State>>,
    pub drawn: Vec<Vec<State>>,
    /// Numbers of the runs that diverged, in order.
    pub diverged: Vec<u64>,
    /// Direction of the truth's track at each instant [rad]; empty before the first block.
    pub tracks: Vec<f64>,
    /// Number of runs within the limit of each requirement.
    pub inside: Vec<u64>,
    /// Number of runs in which a gyro was ever beyond its range; likewise an accelerometer.
    pub beyond_range: [u64; 2],
}

impl Part {
    pub fn new(plan: &Plan, piece: &Piece) -> Self {
        // The runs that are drawn are in the first block.
        let drawn = if piece.start == 0 { plan.drawn() } else { 0 };
        Self {
            statistics: Vec::with_capacity(plan.count()),
            ends: Vec::new(),
            drawn: vec![Vec::new(); drawn as usize],
            diverged: Vec::new(),
            tracks: Vec::with_capacity(plan.instants.len()),
            inside: vec![0; plan.requirements.len()],
            beyond_range: [0; 2],
        }
    }

    /// Adds the runs of `next`, which follow those of this part, in the same piece.
    pub fn append(&mut self, next: Self) -> Result<(), Failure> {
        for (sum, more) in self.statistics.iter_mut().zip(&next.statistics) {
            sum.merge(more).map_err(|error| Failure::of_kind(Kind::Failed, error.to_string()))?;
        }
        self.ends.extend(next.ends);
        for (path, more) in self.drawn.iter_mut().zip(next.drawn) {
            path.extend(more);
        }
        self.diverged.extend(next.diverged);
        // A run that diverged early knows less of the truth.
        for (track, other) in self.tracks.iter_mut().zip(next.tracks) {
            *track = if *track == 0.0 { other } else { *track };
        }
        let counts = self.inside.iter_mut().chain(&mut self.beyond_range);
        for (sum, more) in counts.zip(next.inside.into_iter().chain(next.beyond_range)) {
            *sum += more;
        }
        Ok(())
    }
}

impl Results {
    /// Results before any block was flown.
    pub fn new(plan: &Plan) -> Self {
        Self {
            done: vec![false; plan.blocks()],
            statistics: vec![Statistics::default(); plan.count()],
            ends: vec![None; plan.runs as usize],
            drawn: Vec::new(),
            diverged: Vec::new(),
            tracks: Vec::new(),
            inside: vec![0; plan.requirements.len()],
            beyond_range: [0; 2],
        }
    }

    /// The blocks that are not in the results.
    pub fn missing(&self) -> Vec<usize> {
        (0..self.done.len()).filter(|block| !self.done[*block]).collect()
    }

    /// Number of runs in the statistics.
    pub fn runs(&self, plan: &Plan) -> u64 {
        let done = (0..self.done.len()).filter(|block| self.done[*block]);
        done.map(|block| plan.runs_of(&(block..block + 1)).1).sum()
    }

    /// Adds the results of `piece`. The order does not matter: sums of statistics are exact.
    pub fn add(&mut self, piece: &Piece, part: Part) -> Result<(), Failure> {
        for (sum, more) in self.statistics.iter_mut().zip(&part.statistics) {
            sum.merge(more).map_err(|error| Failure::of_kind(Kind::Failed, error.to_string()))?;
        }
        let first = piece.start * BLOCK as usize;
        for (place, end) in self.ends[first..].iter_mut().zip(part.ends) {
            *place = end;
        }
        if piece.start == 0 {
            self.drawn = part.drawn;
        }
        self.tracks = part.tracks;
        let counts = self.inside.iter_mut().chain(&mut self.beyond_range);
        for (sum, more) in counts.zip(part.inside.into_iter().chain(part.beyond_range)) {
            *sum += more;
        }
        self.diverged.extend(part.diverged);
        self.diverged.sort_unstable();
        self.done[piece.clone()].fill(true);
        Ok(())
    }
}
