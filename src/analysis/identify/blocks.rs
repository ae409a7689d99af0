//! The record as means over blocks of nearly equal length: what the fit reads of it.

use super::path::{Six, six};
use super::unfit::SENSORS;
use crate::base::error::{Error, ErrorKind, Rule, check_range};
use crate::base::memory::{room, room_for_one_more};
use crate::signal::Increment;

/// An increment that real sensors measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RecordedIncrement {
    /// Time of the end of the interval on the clock of the record [s].
    pub time_s: f64,
    /// Length of the interval [s], 1e-6 to 60.
    pub interval_s: f64,
    /// Integrals of the measured angular rate and specific force over the interval, axes of the record.
    pub increment: Increment,
}

/// Fewest increments of a record.
pub const FEWEST_INCREMENTS: usize = 100;

/// Largest number of blocks, and the shortest block [s]: an hour has blocks of 0.9 s.
const MOST_BLOCKS: f64 = 4096.0;
const SHORTEST_S: f64 = 0.2;

/// Longest mean interval, in mean steps of the stamps: stamps scatter, and a clock that goes back loses time.
const LONGEST: f64 = 1.5;

/// Largest signal of a record [rad/s] or [m/s²]: that of the ranges of the sensors.
pub(super) const LARGEST: f64 = 1e6;

/// Mean of consecutive increments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Block {
    /// Begin and end on the clock of the record [s].
    pub start_s: f64,
    pub end_s: f64,
    /// Time without a record before the block [s].
    pub gap_s: f64,
    /// Mean signals.
    pub mean: Six,
}

impl Block {
    pub fn length_s(&self) -> f64 {
        self.end_s - self.start_s
    }

    pub fn middle_s(&self) -> f64 {
        0.5 * (self.start_s + self.end_s)
    }
}

/// The blocks of a record.
pub(super) struct Blocks {
    pub blocks: Vec<Block>,
    /// Mean interval of the record [s].
    pub interval_s: f64,
}

impl Blocks {
    /// Checks the record, and makes blocks of it, at least as long as a period of `cutoff_hz`: faster motion hardly changes their means.
    pub fn new(record: &[RecordedIncrement], cutoff_hz: Option<f64>) -> Result<Self, Error> {
        let count = record.len();
        if count < FEWEST_INCREMENTS {
            let rule = Rule::AtLeast("must be at least", (FEWEST_INCREMENTS as u64).into());
            return Err(Error::invalid("record.count", count, rule));
        }
        check(record)?;
        let span_s = record[count - 1].time_s - record[0].time_s;
        let recorded_s = record.iter().map(|row| row.interval_s).sum::<f64>();
        let interval_s = recorded_s / count as f64;
        let step_s = span_s / (count - 1) as f64;
        if interval_s > LONGEST * step_s {
            let rule = Rule::SentenceWith(
                "mean length of the intervals [s]: they overlap, because the increments are on average apart by [s]",
                step_s.into(),
            );
            return Err(Error::invalid("record.interval_s", interval_s, rule));
        }
        // Of the time with a record, not of its span: a gap may be longer than the record.
        let shortest_s = cutoff_hz.map_or(0.0, |cutoff_hz| 1.0 / cutoff_hz).max(SHORTEST_S);
        let wanted_s = (recorded_s / MOST_BLOCKS).max(shortest_s) * (1.0 - 1e-9);
        let mut blocks: Vec<Block> = room(count.min(2 * MOST_BLOCKS as usize))?;
        let mut open: Option<Block> = None;
        let mut length_s = 0.0;
        for row in record {
            let start_s = row.time_s - row.interval_s;
            let gap_s = open.or(blocks.last().copied()).map_or(0.0, |last| start_s - last.end_s);
            // Stamps scatter: what is less than half an interval is no gap.
            let gap_s = if gap_s > 0.5 * row.interval_s { gap_s } else { 0.0 };
            if gap_s > 0.0 {
                // The end of a piece is shorter than a block, and left out unless it is at least half of one.
                close(&mut blocks, open.take().filter(|_| length_s >= 0.5 * wanted_s), length_s)?;
            }
            if open.is_none() {
                length_s = 0.0;
            }
            let block = open.get_or_insert(Block { start_s, end_s: start_s, gap_s, mean: Six::zeros() });
            block.mean += six(&row.increment);
            block.end_s = row.time_s;
            length_s += row.interval_s;
            if length_s >= wanted_s {
                close(&mut blocks, open.take(), length_s)?;
            }
        }
        if blocks.len() < FEWEST_INCREMENTS / 2 {
            let rule = Rule::SentenceWith(
                "too short: blocks of 0.2 s, or of a 4096th of the record or a period of the cut-off, without a gap, at least",
                50_u64.into(),
            );
            return Err(Error::invalid("record.blocks", blocks.len(), rule));
        }
        Ok(Self { blocks, interval_s })
    }
}

/// Adds a block whose mean is still a sum, over the intervals of its increments: stamps scatter.
fn close(blocks: &mut Vec<Block>, block: Option<Block>, length_s: f64) -> Result<(), Error> {
    if let Some(block) = block {
        room_for_one_more(blocks)?;
        blocks.push(Block { start_s: block.end_s - length_s, mean: block.mean / length_s, ..block });
    }
    Ok(())
}

/// Rejects increments that go back in time, and signals that no sensor has.
pub(super) fn check(record: &[RecordedIncrement]) -> Result<(), Error> {
    let mut last_s = None;
    for (index, row) in record.iter().enumerate() {
        check_row(row, last_s).map_err(|error| error.at(index))?;
        last_s = Some(row.time_s);
    }
    Ok(())
}

/// Checks an increment behind one of time `last_s` [s].
pub(super) fn check_row(row: &RecordedIncrement, last_s: Option<f64>) -> Result<(), Error> {
    check_range("record.interval_s", row.interval_s, 1e-6, 60.0)?;
    check_range("record.time_s", row.time_s, -1e12, 1e12)?;
    if let Some(last_s) = last_s.filter(|last_s| row.time_s <= *last_s) {
        let rule = Rule::SentenceWith("must be later than the increment before, at", last_s.into());
        return Err(Error::of(ErrorKind::TimeOrder, "record.time_s", row.time_s, rule));
    }
    for (part, value) in six(&row.increment).iter().enumerate() {
        check_range(SENSORS[part], value / row.interval_s, -LARGEST, LARGEST)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    fn record(count: usize, time_s: impl Fn(usize) -> f64) -> Vec<RecordedIncrement> {
        let increment = Increment { angle: Vector3::new(0.02, 0.0, 0.0), velocity: Vector3::zeros() };
        (0..count).map(|k| RecordedIncrement { time_s: time_s(k), interval_s: 0.01, increment }).collect()
    }

    #[test]
    fn blocks_are_means_and_end_at_gaps() {
        let gap = |k: usize| 0.01 * (k + if k < 1005 { 0 } else { 500 }) as f64;
        let found = Blocks::new(&record(2005, gap), None).unwrap();
        assert_eq!(found.blocks.len(), 100);
        assert!(found.blocks.iter().all(|block| (block.mean[0] - 2.0).abs() < 1e-9));
        assert!((found.blocks[50].gap_s - 5.0).abs() < 1e-9, "{:?}", found.blocks[50]);
        assert!(found.blocks.iter().all(|block| (block.length_s() - 0.2).abs() < 1e-9));
    }

    /// Blocks are as long as a period of the cut-off, and a record of fewer than 50 periods is too short.
    #[test]
    fn a_block_is_as_long_as_a_period_of_the_cutoff() {
        let found = Blocks::new(&record(20_000, |k| 0.01 * k as f64), Some(0.5)).unwrap();
        assert!(
            found.blocks.iter().all(|block| (block.length_s() - 2.0).abs() < 1e-9)
                && found.blocks.len() == 100
        );
        let error = Blocks::new(&record(20_000, |k| 0.01 * k as f64), Some(0.1)).err().unwrap().to_string();
        assert!(error.starts_with("record.blocks = 20: too short"), "{error}");
    }

    /// The number of blocks is bounded, whatever the stamps and the gaps are, and a long gap leaves the blocks as short as they are.
    #[test]
    fn blocks_are_bounded() {
        for (rows, piece, gap_s) in [(400_000, 400_000, 0.0), (400_000, 120, 1.0), (4000, 1000, 1e9)] {
            let time_s = |k: usize| 0.01 * k as f64 + (k / piece) as f64 * gap_s;
            let blocks = Blocks::new(&record(rows, time_s), None).unwrap().blocks;
            assert!(blocks.len() <= 2 * MOST_BLOCKS as usize, "{}", blocks.len());
            let longest_s = blocks.iter().map(Block::length_s).fold(0.0, f64::max);
            assert!(longest_s < 0.01 + (0.01 * rows as f64 / MOST_BLOCKS).max(SHORTEST_S), "{longest_s}");
        }
    }

    #[test]
    fn what_is_no_record_is_named() {
        let error = |record: &[RecordedIncrement]| Blocks::new(record, None).err().unwrap().to_string();
        assert_eq!(error(&[]), "record.count = 0: must be at least 100");
        // Stamps in another unit than the intervals, which would make a block of every increment.
        let fast = record(200, |k| 1e-5 * k as f64);
        assert!(error(&fast).starts_with("record.interval_s = 0.0"), "{}", error(&fast));
        let back = record(200, |k| if k == 150 { 0.0 } else { 0.01 * k as f64 });
        assert_eq!(error(&back), "record.time_s[150] = 0: must be later than the increment before, at 1.49");
        let mut wild = record(200, |k| 0.01 * k as f64);
        wild[3].increment.velocity.y = f64::NAN;
        assert_eq!(error(&wild), "record.velocity.y[3] = NaN: must be a finite number");
    }
}
