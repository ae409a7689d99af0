//! Attitudes of 0, 0, 0 between others: a source had none for a while.

use super::finding::At;
use super::positions::Largest;
use crate::base::math::{Euler, wrap_angle};
use crate::base::units::DEG;

/// Least difference of an angle from 0 in the rows before and behind [rad].
const AWAY: f64 = 10.0 * DEG;

#[derive(Debug, Clone)]
pub(super) struct Zeros {
    /// Where the attitude is 0 now, and how far it was from it before [rad].
    now: Option<(At, f64)>,
    /// Stretches, and the one that is farthest from the rows beside it [rad].
    pub count: u64,
    pub farthest: Largest,
}

impl Zeros {
    pub const fn new() -> Self {
        const NONE: Largest = Largest { value: 0.0, at: At { row: 0, time_s: 0.0 } };
        Self { now: None, count: 0, farthest: NONE }
    }

    /// Adds the attitude of a row behind another one.
    pub fn add(&mut self, at: At, euler: &Euler, before: &Euler) {
        match (away(before), away(euler)) {
            (from, None) if from.is_some_and(|from| from > AWAY) => {
                self.now = from.map(|from| (at, from));
            }
            (None, Some(to)) => {
                if let Some((at, from)) = self.now.take().filter(|_| to > AWAY) {
                    self.count += 1;
                    self.farthest.take(from.max(to), at);
                }
            }
            _ => {}
        }
    }
}

/// The largest angle of an attitude [rad]; `None`: all are 0.
fn away(Euler { roll, pitch, heading }: &Euler) -> Option<f64> {
    let angles = [*roll, *pitch, *heading];
    let largest = angles.map(|angle| wrap_angle(angle).abs()).into_iter().fold(0.0, f64::max);
    angles.iter().any(|angle| *angle != 0.0).then_some(largest)
}
