//! An attitude on another clock than the positions.
//!
//! A roll that is late by τ is the bank of the turns less τ times its rate. A heading that is late turns as the track did before: by the
//! turn of the track less τ times its change. What wind adds is a part of the turn itself, and so not correlated with its change where
//! turns begin and end.

use nalgebra::{Matrix3, Vector3};

use super::regression::Regression;
use crate::base::units::DEG;

/// Blocks that a delay needs, and correlation that shows it: two thirds of the difference are explained.
const LEAST: f64 = 20.0;
const SHOWS: f64 = 0.8;

/// Delays that matter [s]. Good flights have delays of the roll of 0.13 s at most, and headings that are 1.9 s early in slow turns.
const ROLL_S: f64 = 0.5;
const LATE_S: f64 = 1.5;

/// Bank and roll of a vehicle that does not fly on its back \[rad\].
pub(super) const UPRIGHT: f64 = 75.0 * DEG;

/// A difference on the rate of a quantity, where that falls and where it grows: the slope is a delay.
#[derive(Debug, Clone)]
struct Delay([Regression; 2]);

impl Delay {
    const NONE: Self = Self([Regression::NONE; 2]);

    fn add(&mut self, rate: f64, difference: f64) {
        self.0[usize::from(rate > 0.0)].add(-rate, difference);
    }

    /// The delay [s] if it is shown: a slip in a single bend is a delay where the bank grows, and the opposite where it falls.
    fn shown_s(&self) -> Option<f64> {
        let both = self.0[0].with(&self.0[1]);
        let (_, delay_s, correlation) = both.figures();
        let is_of = |part: &Regression| part.xx > 0.1 * both.xx && part.xy / part.xx / delay_s > 0.5;
        let is_shown = both.count >= LEAST && correlation.abs() > SHOWS && self.0.iter().all(is_of);
        is_shown.then_some(delay_s)
    }
}

/// Bank that the turn needs, and roll, between two blocks.
#[derive(Debug, Clone, Copy)]
pub(super) struct Banked {
    pub bank: f64,
    pub roll: f64,
    /// Mean of the roll over both.
    pub mean: f64,
}

#[derive(Debug, Clone)]
pub(super) struct RollDelay {
    /// The two ends of blocks before, if they follow each other.
    before: [Option<Banked>; 2],
    /// Roll less bank, on the rate of the bank.
    delay: Delay,
    /// The same of the mean of the roll: the bank is one too, so a roll that changes at once has no delay by it.
    of_means: Regression,
}

impl RollDelay {
    pub const NONE: Self = Self { before: [None; 2], delay: Delay::NONE, of_means: Regression::NONE };

    /// Forgets the blocks before: the next one does not follow them.
    pub fn pause(&mut self) {
        self.before = [None; 2];
    }

    /// Adds the end of a block whose middle is `between_s` [s] before that of the next.
    pub fn add(&mut self, now: Banked, between_s: f64) {
        let is_upright = |at: &Banked| at.bank.abs().max(at.roll.abs()) < UPRIGHT;
        if let [Some(first), Some(middle)] = self.before
            && [first, middle, now].iter().all(is_upright)
        {
            let rate = (now.bank - first.bank) / (2.0 * between_s);
            self.delay.add(rate, middle.roll - middle.bank);
            self.of_means.add(-rate, middle.mean - middle.bank);
        }
        self.before = [self.before[1], Some(now)];
    }

    /// How late the roll is [s], negative if it is early.
    pub fn delay_s(&self) -> Option<f64> {
        let (_, of_means_s, _) = self.of_means.figures();
        let is_late = |delay_s: &f64| of_means_s / delay_s > 0.5 && delay_s.abs() > ROLL_S;
        self.delay.shown_s().filter(is_late)
    }
}

/// Turns of track and heading between two blocks \[rad\].
type Turns = [f64; 2];

#[derive(Debug, Clone)]
pub(super) struct HeadingDelay {
    before: [Option<Turns>; 2],
    /// Turn of the heading less that of the track, on the change of the latter, where that falls and where it grows.
    parts: [Beside; 2],
}

impl HeadingDelay {
    pub const NONE: Self = Self { before: [None; 2], parts: [Beside::NONE; 2] };

    /// Forgets the blocks before: the next one does not follow them.
    pub fn pause(&mut self) {
        self.before = [None; 2];
    }

    /// Adds the turns between a block and the next, which are `between_s` \[s\] apart.
    pub fn add(&mut self, turns: Turns, between_s: f64) {
        if let [Some(first), Some(middle)] = self.before {
            let change = (turns[0] - first[0]) / (2.0 * between_s);
            self.parts[usize::from(change > 0.0)].add(-change, middle[0], middle[1] - middle[0]);
        }
        self.before = [self.before[1], Some(turns)];
    }

    /// How late the heading is [s]. An early one may be a nose that leads its track.
    pub fn delay_s(&self) -> Option<f64> {
        let both = self.parts[0].with(&self.parts[1]);
        let (delay_s, correlation) = both.figures();
        let is_of = |part: &Beside| part.count > 0.1 * both.count && part.figures().0 / delay_s > 0.5;
        let is_shown = both.count >= LEAST && correlation.abs() > SHOWS && self.parts.iter().all(is_of);
        (is_shown && delay_s > LATE_S).then_some(delay_s)
    }
}

/// Sums of a regression of y on x beside z, without means: a wind makes a part of each turn z.
#[derive(Debug, Clone, Copy)]
struct Beside {
    count: f64,
    /// Products of x, y and z.
    sums: Matrix3<f64>,
}

impl Beside {
    const NONE: Self = Self { count: 0.0, sums: Matrix3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0) };

    fn add(&mut self, x: f64, z: f64, y: f64) {
        let values = Vector3::new(x, y, z);
        *self = self.with(&Self { count: 1.0, sums: values * values.transpose() });
    }

    fn with(&self, other: &Self) -> Self {
        Self { count: self.count + other.count, sums: self.sums + other.sums }
    }

    /// Slope of y on x, and the correlation of what z leaves of both.
    fn figures(&self) -> (f64, f64) {
        let of = |a: usize, b: usize| {
            self.sums[(a, b)] - self.sums[(a, 2)] * self.sums[(b, 2)] / self.sums[(2, 2)]
        };
        let (xx, xy, yy) = (of(0, 0), of(0, 1), of(1, 1));
        (xy / xx, xy / (xx * yy).max(0.0).sqrt())
    }
}
