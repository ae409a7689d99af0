//! Attitudes of 0, 0, 0 between others: a source had none for a while.

use super::finding::At;
use super::positions::Largest;
use crate::base::math::{Euler, wrap_angle};
use crate::base::units::DEG;

/// Least difference of an angle from 0 in the rows before and behind [rad].
const AWAY: f64 = 10.0 * DEG;

#[derive(Debug, Clone)]
pub(super) struct Zeros {
    /// Where the attitude is 0 now, and what it was before.
    now: Option<(At, Euler)>,
    /// Stretches, and the one that is farthest from the rows beside it [rad].
    pub count: u64,
    pub farthest: Largest,
}

impl Zeros {
    pub const fn new() -> Self {
        const NONE: Largest = Largest { value: 0.0, at: At { row: 0, time_s: 0.0 } };
        Self { now: None, count: 0, farthest: NONE }
    }

    /// Adds the attitude of a row behind another one. A vehicle without roll and pitch may turn through north: then the rows beside are
    /// farther from each other than from 0.
    pub fn add(&mut self, at: At, euler: &Euler, before: &Euler) {
        match (away(before), away(euler)) {
            (Some(from), None) => self.now = (from > AWAY).then_some((at, *before)),
            (None, Some(to)) => {
                let Some((at, last)) = self.now.take() else { return };
                let [roll, pitch, heading] =
                    [euler.roll - last.roll, euler.pitch - last.pitch, euler.heading - last.heading];
                let across = away(&Euler { roll, pitch, heading }).unwrap_or(0.0);
                let farthest = away(&last).unwrap_or(0.0).max(to);
                if to > AWAY && across < farthest {
                    self.count += 1;
                    self.farthest.take(farthest, at);
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
