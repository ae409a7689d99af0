//! Plan of the flights: the blocks of runs, and the samples at which statistics are taken.

use std::ops::Range;

use sins::mechanization::VerticalMode;
use sins::unit::{Mode, State};

use super::command::Order;
use super::requirement::{Measure, Requirement};
use crate::failure::Failure;
use crate::given::Given;
use crate::units::{stamp_text, time_text};

/// Number of runs of a block, the unit of the checkpoint. The results are the same with any size: merging statistics is exact.
pub const BLOCK: u64 = 64;

/// Largest number of blocks that one thread flies at once. Their runs share the truth, but an interruption loses all of them.
const SIDE_BY_SIDE: usize = 4;

/// Smallest number of pieces of work for each thread, so that all threads are busy to the end.
const PIECES: usize = 4;

/// Default and largest number of rows of statistics. Each thread has all rows in memory.
const ROWS: f64 = 200.0;
const MOST_ROWS: usize = 2000;

/// Largest number of runs: the error at the end of each is kept.
pub const MOST_RUNS: u64 = 10_000_000;

/// Number of runs that are drawn one by one: the first runs.
pub const DRAWN_RUNS: u64 = 8;

/// Neighbouring blocks, which one thread flies at once.
pub type Piece = Range<usize>;

/// Data of which there are statistics.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Data {
    /// Error data 1, the error differential equations.
    Model,
    /// Error data 2, navigation minus truth.
    Navigation,
    /// Error data 2 of the runs whose unit shows position, velocity, attitude and heading as valid.
    Shown,
}

/// Plan of an ensemble.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    pub first_run: u64,
    pub runs: u64,
    /// The samples at which statistics are taken, in order: the first one, those nearest to each multiple of `every_s`, those at which
    /// requirements are due, and the last one.
    pub instants: Vec<usize>,
    /// Time between two rows [s].
    pub every_s: f64,
    pub sources: Vec<Data>,
    /// The requirements that apply to the flight.
    pub requirements: Vec<Due>,
}

/// A requirement, and the sample at which it is due.
#[derive(Debug, Clone, PartialEq)]
pub struct Due {
    pub requirement: Requirement,
    pub index: usize,
    /// Time of the sample since the start, and the limit at that time [SI].
    pub time_s: f64,
    pub limit: f64,
    /// Time since the start from which the limit grows [s]; `None`: it does not grow.
    pub grows_from_s: Option<f64>,
}

impl Due {
    /// Whether it is about the horizontal position at the end.
    pub fn is_of_end(&self, plan: &Plan) -> bool {
        self.requirement.measure == Measure::Horizontal(0) && plan.instants.last() == Some(&self.index)
    }
}

impl Plan {
    pub fn new(order: &Order, given: &Given, requirements: Vec<Requirement>) -> Result<Self, Failure> {
        let intervals = |every: f64| every.round() * given.period_s;
        let every_s = match order.every {
            None => intervals(((given.count - 1) as f64 / ROWS).max(1.0)),
            // Intervals of a log may differ.
            Some(every_s) if given.flight().is_none() => every_s,
            Some(every_s) => intervals(every_s / given.period_s),
        };
        if !(every_s > 0.0 && given.duration_s / every_s < MOST_ROWS as f64) {
            let what = format!(
                "--every {}: expected at least the sample interval, {}, and at most {MOST_ROWS} rows, so {}",
                order.every.unwrap_or_default(),
                stamp_text(given.period_s),
                stamp_text(given.duration_s / MOST_ROWS as f64)
            );
            return Err(Failure::new(what));
        }
        let rows = (given.duration_s / every_s) as usize;
        let mut instants: Vec<usize> = (0..=rows).map(|row| given.index_at(row as f64 * every_s)).collect();
        instants.push(given.count - 1);
        let first_run = order.first_run.unwrap_or(given.scene.options.key.run);
        let requirements = due(given, first_run, requirements)?;
        instants.extend(requirements.iter().map(|due| due.index));
        instants.sort_unstable();
        instants.dedup();
        let mut sources = vec![Data::Navigation];
        if given.scene.options.error_model {
            sources.push(Data::Model);
        }
        if given.scene.unit.start.is_some() {
            sources.push(Data::Shown);
        }
        if first_run.checked_add(order.runs - 1).is_none() {
            let what = format!(
                "--runs {}: expected the last run below 2^64, from --first-run {first_run}",
                order.runs
            );
            return Err(Failure::new(what));
        }
        Ok(Self { first_run, runs: order.runs, instants, every_s, sources, requirements })
    }

    pub fn blocks(&self) -> usize {
        self.runs.div_ceil(BLOCK) as usize
    }

    /// First run and number of runs of a piece of work.
    pub fn runs_of(&self, piece: &Piece) -> (u64, u64) {
        let (before, end) = (piece.start as u64 * BLOCK, piece.end as u64 * BLOCK);
        (self.first_run + before, end.min(self.runs) - before)
    }

    /// The blocks of `missing`, in order, in pieces of work for `threads` threads.
    pub fn pieces(missing: &[usize], threads: usize) -> Vec<Piece> {
        let most = (missing.len() / (PIECES * threads)).clamp(1, SIDE_BY_SIDE);
        let neighbours = missing.chunk_by(|one, next| one + 1 == *next);
        let pieces = neighbours.flat_map(|blocks| blocks.chunks(most));
        pieces.map(|blocks| blocks[0]..blocks[0] + blocks.len()).collect()
    }

    /// Number of runs that are drawn.
    pub fn drawn(&self) -> u64 {
        DRAWN_RUNS.min(self.runs)
    }

    /// Number of statistics: of each source at each instant.
    pub fn count(&self) -> usize {
        self.instants.len() * self.sources.len()
    }
}

/// When the unit of a scene begins to navigate in its first run, since the start [s]; 0 if it navigates from the start on.
fn navigation_s(given: &Given, first_run: u64) -> Result<f64, Failure> {
    if given.scene.unit.start != Some(Mode::Off) {
        return Ok(0.0);
    }
    let mut play = given.play_of_run(first_run)?;
    for index in 0..given.count {
        play.push(&given.sample(index)?).map_err(|stopped| given.failure_at(index, &stopped.error))?;
        if play.unit().is_some_and(|unit| unit.status().state == State::Navigation) {
            return Ok(given.time_s(index));
        }
    }
    let what = "--meets: a limit that grows with the time counts from NAV, and the unit does not navigate";
    Err(Failure::new(what))
}

/// Those of `requirements` that apply to the flight, with the samples at which they are due.
fn due(given: &Given, first_run: u64, requirements: Vec<Requirement>) -> Result<Vec<Due>, Failure> {
    let (last, flown) = (given.count - 1, time_text(given.duration_s));
    let is_given = !requirements.is_empty();
    let grows = requirements.iter().any(|one| one.grows);
    let nav_s = if grows { navigation_s(given, first_run)? } else { 0.0 };
    let applying = requirements.into_iter().filter(|one| one.applies(given.duration_s));
    let dues = applying.map(|requirement| {
        let index = requirement.time_s.map_or(last, |time_s| given.index_at(time_s));
        let follows = given.scene.options.vertical == VerticalMode::FollowTruth;
        if follows && matches!(requirement.measure, Measure::State(2 | 5)) {
            let what = format!("--meets: {} has no error: options.vertical is follow", requirement.quantity);
            return Err(Failure::new(what));
        }
        if requirement.time_s.is_some_and(|time_s| time_s > given.duration_s + 0.5 * given.period_s) {
            let what =
                format!("--meets: {} is due after the flight, which lasts {flown}", requirement.quantity);
            return Err(Failure::new(what));
        }
        let time_s = given.sample(index)?.time_s - given.start_s;
        let grows_from_s = requirement.grows.then_some(nav_s);
        if grows_from_s.is_some_and(|from_s| from_s >= time_s) {
            let what = format!(
                "--meets: {} is due before the unit navigates, {nav_s} s after the start: its limit grows from then on",
                requirement.quantity
            );
            return Err(Failure::new(what));
        }
        let limit = requirement.limit_at(time_s - grows_from_s.unwrap_or(0.0));
        Ok(Due { requirement, index, time_s, limit, grows_from_s })
    });
    let dues: Vec<Due> = dues.collect::<Result<_, _>>()?;
    if is_given && dues.is_empty() {
        return Err(Failure::new(format!("--meets: no requirement applies to a flight of {flown}")));
    }
    Ok(dues)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_are_all_that_is_missing() {
        for (missing, threads, pieces) in [
            ((0..16).collect::<Vec<_>>(), 2, 8),
            ((0..16).collect(), 16, 16),
            ((0..1000).collect(), 2, 250),
            (vec![0, 1, 2, 5, 6, 9], 1, 6),
            (vec![3], 8, 1),
            (vec![], 8, 0),
        ] {
            let made = Plan::pieces(&missing, threads);
            assert_eq!(made.len(), pieces, "{missing:?}");
            assert_eq!(made.into_iter().flatten().collect::<Vec<_>>(), missing);
        }
    }
}
