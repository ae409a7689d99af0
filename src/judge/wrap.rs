//! Angles that were interpolated through their wrap: from 359° to 1° by way of 180°.

use super::finding::At;
use super::positions::Largest;
use crate::base::units::DEG;

/// A sweep is at least that fast [rad/s], turns at least that far [rad], and takes at most that long [s].
const LEAST_RATE: f64 = 60.0 * DEG;
const LEAST_SWEEP: f64 = 270.0 * DEG;
const LONGEST_S: f64 = 4.0;

/// Share of its mean by which the rate of a sweep varies, as it is linear in time; and share of it that is left before and behind.
const LINEAR: f64 = 0.03;
const CALM: f64 = 0.2;

/// Steps of the same sign and rate. The first and the last may be shorter, because the rows need not be those between which the
/// angle was interpolated.
#[derive(Debug, Clone, Copy)]
struct Sweep {
    angle: f64,
    length_s: f64,
    /// Fastest and slowest rate of the steps between the first and the last [rad/s].
    fastest: f64,
    slowest: f64,
    first_rate: f64,
    last_rate: f64,
    steps: u32,
    rate_before: f64,
    begin: At,
}

#[derive(Debug, Clone)]
pub(super) struct Wrap {
    sweep: Option<Sweep>,
    rate: f64,
    /// Sweeps, and the fastest [rad/s].
    pub count: u64,
    pub fastest: Largest,
}

impl Wrap {
    pub const fn new() -> Self {
        const NONE: Largest = Largest { value: 0.0, at: At { row: 0, time_s: 0.0 } };
        Self { sweep: None, rate: 0.0, count: 0, fastest: NONE }
    }

    /// Adds the step of the angle from the row before, by number [rad], and the row before.
    pub fn add(&mut self, step: f64, interval_s: f64, before: At) {
        let rate = step / interval_s;
        let is_fast = rate.abs() > LEAST_RATE && step.abs() < core::f64::consts::PI;
        match &mut self.sweep {
            Some(sweep) if is_fast && (rate < 0.0) == (sweep.angle < 0.0) && sweep.goes_on(rate) => {
                sweep.add(step, interval_s, rate);
            }
            _ => {
                self.end(rate);
                self.sweep = is_fast.then(|| Sweep::new(step, interval_s, self.rate, before));
            }
        }
        self.rate = rate;
    }

    /// Ends the sweep at a step of `rate_behind` [rad/s].
    fn end(&mut self, rate_behind: f64) {
        let Some(sweep) = self.sweep.take() else { return };
        let rate = (sweep.angle / sweep.length_s).abs();
        let is_calm = sweep.rate_before.abs().max(rate_behind.abs()) < CALM * rate;
        let is_turn = (LEAST_SWEEP..=360.0 * DEG).contains(&sweep.angle.abs());
        if is_calm && is_turn && sweep.length_s <= LONGEST_S && sweep.steps >= 2 {
            self.count += 1;
            self.fastest.take(rate, sweep.begin);
        }
    }
}

impl Sweep {
    fn new(step: f64, length_s: f64, rate_before: f64, begin: At) -> Self {
        let rate = (step / length_s).abs();
        Self {
            angle: step,
            length_s,
            fastest: 0.0,
            slowest: f64::INFINITY,
            first_rate: rate,
            last_rate: rate,
            steps: 1,
            rate_before,
            begin,
        }
    }

    /// Whether a step of `rate` [rad/s] goes on at the rate of the steps before.
    fn goes_on(&self, rate: f64) -> bool {
        let rate = rate.abs();
        // The last step so far is now one between.
        if self.steps == 1 {
            return true;
        }
        let (fastest, slowest) = (self.fastest.max(self.last_rate), self.slowest.min(self.last_rate));
        fastest <= (1.0 + LINEAR) * slowest
            && rate <= (1.0 + LINEAR) * slowest
            && self.first_rate <= (1.0 + LINEAR) * slowest
    }

    fn add(&mut self, step: f64, interval_s: f64, rate: f64) {
        if self.steps >= 2 {
            self.fastest = self.fastest.max(self.last_rate);
            self.slowest = self.slowest.min(self.last_rate);
        }
        self.angle += step;
        self.length_s += interval_s;
        self.last_rate = rate.abs();
        self.steps += 1;
    }
}
