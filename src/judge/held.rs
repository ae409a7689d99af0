//! Stretches in which an attitude, or a heading, stays the same to the last bit.

use super::blocks::Block;
use super::finding::At;

/// A stretch in which a value stays the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Held {
    /// Its first row.
    pub begin: At,
    /// What the track turns in it \[rad\].
    pub turn: f64,
}

/// The stretch now, that of the largest turn of the track, and how many turn by more than a limit.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretches {
    now: Option<Held>,
    longest: Option<Held>,
    count: u64,
}

impl Stretches {
    pub const NONE: Self = Self { now: None, longest: None, count: 0 };

    /// Adds the turn of the track between two blocks \[rad\], in which the value stays the same or does not.
    pub fn add(&mut self, first: &Block, is_held: bool, turn: f64, limit: f64) {
        if !is_held {
            self.now = None;
            return;
        }
        let before = self.now.unwrap_or(Held { begin: first.begin, turn: 0.0 });
        let now = Held { turn: before.turn + turn, ..before };
        self.now = Some(now);
        self.count += u64::from(before.turn.abs() <= limit && now.turn.abs() > limit);
        if self.longest.is_none_or(|longest| now.turn.abs() > longest.turn.abs()) {
            self.longest = Some(now);
        }
    }

    /// The stretch in which the track turns farthest, if it turns beyond the limit, and how many such there are.
    pub fn found(&self) -> Option<(Held, u64)> {
        self.longest.filter(|_| self.count > 0).map(|longest| (longest, self.count))
    }
}
