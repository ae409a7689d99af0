//! An attitude that is not that of the path: far off in straight flight, or in turns that the path does not make.

use super::direction::Direction;
use super::regression::Regression;
use crate::base::units::DEG;

/// Blocks that a judgement needs.
const LEAST: f64 = 12.0;

/// Bank and angle of the path of straight flight, and how constant and how large a roll, or a pitch above the path, is there that no
/// vehicle keeps \[rad\].
const STRAIGHT: f64 = 5.0 * DEG;
const STEEP: f64 = 45.0 * DEG;
const CONSTANT: f64 = 0.97;
const FAR: f64 = 60.0 * DEG;

/// Turns of the heading in all \[rad\], how well the roll is the bank that they need, least deviation of that bank \[rad\], and the share
/// of the turns that a mirrored track makes at most.
const TURNED: f64 = 120.0 * DEG;
const FOLLOWS: f64 = 0.9;
const AS_FAR: core::ops::Range<f64> = 0.5..2.0;
const BANKS: f64 = 5.0 * DEG;
const MIRRORED: f64 = 0.5;

#[derive(Debug, Clone)]
pub(super) struct Straight {
    count: f64,
    roll: Direction,
    pitch: Direction,
    /// Σ |turn of the heading|, Σ its square, Σ its product with that of the track, and the roll on the bank that it needs.
    turned: f64,
    turned2: f64,
    mixed: f64,
    rolls: Regression,
}

impl Straight {
    pub const NONE: Self = Self {
        count: 0.0,
        roll: Direction::NONE,
        pitch: Direction::NONE,
        turned: 0.0,
        turned2: 0.0,
        mixed: 0.0,
        rolls: Regression::NONE,
    };

    /// Adds roll, pitch, angle of the path and bank of the turn between two blocks \[rad\].
    pub fn add(&mut self, roll: f64, [pitch, path]: [f64; 2], bank: f64) {
        if bank.abs() < STRAIGHT && path.abs() < STEEP {
            self.count += 1.0;
            self.roll.add(roll);
            self.pitch.add(pitch - path);
        }
    }

    /// Adds the turns of heading and track, the roll of a block, and the bank that the turn of the heading needs \[rad\].
    pub fn add_turn(&mut self, heading: f64, track: f64, roll: f64, bank: f64) {
        self.turned += heading.abs();
        self.turned2 += heading * heading;
        self.mixed += heading * track;
        self.rolls.add(bank, roll);
    }

    /// The angle of a roll, or of a pitch above the path, that straight flight has not \[rad\], and its name.
    pub fn off(&self) -> Option<(f64, &'static str)> {
        let angle = |of: &Direction| {
            of.angle().filter(|angle| {
                let is_constant = of.length() > CONSTANT * self.count;
                self.count >= LEAST && is_constant && angle.abs() > FAR
            })
        };
        angle(&self.roll).map(|angle| (angle, "roll")).or(angle(&self.pitch).map(|angle| (angle, "pitch")))
    }

    /// How well the track follows the heading, 0 to 1, if heading and roll turn together, and the track does not.
    pub fn mirrored(&self) -> Option<f64> {
        let (deviation, slope, correlation) = self.rolls.figures();
        let banks = correlation > FOLLOWS && AS_FAR.contains(&slope) && deviation > BANKS;
        let share = self.mixed / self.turned2;
        let turns = self.rolls.count >= LEAST && self.turned > TURNED;
        (turns && banks && share < MIRRORED).then_some(share.max(0.0))
    }
}
