//! White noise of three components, by the third and the fourth differences of their values.
//!
//! σ₃ = median|Δ³x| / (0.6745 √20), σ₄ = median|Δ⁴x| / (0.6745 √70). For white noise σ₄/σ₃ = 1. For motion of frequency f it is
//! 2 sin(π f Δ) √(20/70), which is below 0.8 up to f = 0.27/Δ.

use nalgebra::Vector3;

use super::histogram::Histogram;
use crate::base::error::Error;
use crate::base::memory::filled;

/// Median of the size of a normal number, over its standard deviation.
const MEDIAN_SIZE: f64 = 0.674_489_750_196_081_7;
const THIRD: f64 = MEDIAN_SIZE * 4.472_135_954_999_58; // √20
const FOURTH: f64 = MEDIAN_SIZE * 8.366_600_265_340_756; // √70

/// Ratio of σ₄ to σ₃ above which the differences are noise.
const NOISE_RATIO: f64 = 0.8;

/// Share of second differences above half a step at which the values really round.
const ROUNDING_SHARE: f64 = 0.01;

/// Differences that a judgement needs.
const LEAST: u64 = 20;

#[derive(Debug, Clone)]
pub(super) struct Noise {
    /// Of each component, as those of the fourth.
    third: Box<[Histogram]>,
    fourth: Box<[Histogram]>,
    /// Sum of the squares of the third differences, of each component.
    third_squares: [f64; 3],
    /// Number of second differences above half a step, of each component.
    above_half_step: [u64; 3],
    /// First, second and third difference at the last value; the number of them that are known.
    differences: [Vector3<f64>; 3],
    known: usize,
    /// Values in a row that have not changed.
    unchanged: u32,
}

impl Noise {
    /// Allocates the histograms, which would be much of a small stack.
    pub fn new() -> Result<Self, Error> {
        Ok(Self {
            third: filled(3, Histogram::new())?,
            fourth: filled(3, Histogram::new())?,
            third_squares: [0.0; 3],
            above_half_step: [0; 3],
            differences: [Vector3::new(0.0, 0.0, 0.0); 3],
            known: 0,
            unchanged: 0,
        })
    }

    /// Adds the rate of change of the values over the last interval, in axes that do not turn. `local` gives the components that are
    /// counted, times the usual interval, and `steps` their steps. Returns the fourth difference of the values.
    pub fn add(
        &mut self,
        first: Vector3<f64>,
        local: impl Fn(&Vector3<f64>) -> Vector3<f64>,
        steps: &[f64; 3],
    ) -> Option<Vector3<f64>> {
        let second = first - self.differences[0];
        let third = second - self.differences[1];
        let fourth = third - self.differences[2];
        self.differences = [first, second, third];
        let known = self.known;
        self.known = (known + 1).min(4);
        let is_unchanged = first == Vector3::zeros();
        self.unchanged = if is_unchanged { self.unchanged.saturating_add(1) } else { 0 };
        // Values that stay exactly the same say nothing about the noise while the vehicle moves.
        if self.unchanged >= 4 {
            return None;
        }
        if known >= 2 {
            let (second, third) = (local(&second), local(&third));
            for axis in 0..3 {
                self.third[axis].add(third[axis].abs());
                self.third_squares[axis] += third[axis] * third[axis];
                self.above_half_step[axis] +=
                    u64::from(steps[axis] > 0.0 && second[axis].abs() > 0.5 * steps[axis]);
            }
        }
        if known < 3 {
            return None;
        }
        let fourth = local(&fourth);
        (0..3).for_each(|axis| self.fourth[axis].add(fourth[axis].abs()));
        Some(fourth)
    }

    /// Number of third differences.
    pub fn count(&self) -> u64 {
        self.third[0].total()
    }

    /// Third differences as if they were noise, the largest horizontal component: an upper limit of the noise.
    pub fn recent(&self) -> f64 {
        self.third[0].recent_median().max(self.third[1].recent_median()) / THIRD
    }

    /// The same of the third component.
    pub fn recent_up(&self) -> f64 {
        self.third[2].recent_median() / THIRD
    }

    /// White noise of a component; 0: none was found, or none can be told from motion.
    pub fn sigma(&self, axis: usize) -> f64 {
        self.sigma_above(axis, NOISE_RATIO)
    }

    /// The same, where the ratio of σ₄ to σ₃ must be above `ratio`.
    pub fn sigma_above(&self, axis: usize, ratio: f64) -> f64 {
        let (third, fourth) = (self.third[axis].median() / THIRD, self.fourth[axis].median() / FOURTH);
        if self.count() >= LEAST && fourth > ratio * third { third } else { 0.0 }
    }

    /// White noise whose third differences have the mean square of those of a component, whose values are multiples of `step`: at most
    /// that of a rounding that is new in each value.
    pub fn of_stairs(&self, axis: usize, step: f64) -> f64 {
        let third = (self.third_squares[axis] / self.count().max(1) as f64).sqrt();
        (third / 20f64.sqrt()).min(step / 12f64.sqrt())
    }

    /// Noise of rounding of a component, whose values are multiples of `step`; 0: rounding does not show.
    pub fn rounding(&self, axis: usize, step: f64) -> f64 {
        let share = self.above_half_step[axis] as f64 / self.count().max(1) as f64;
        if self.count() >= LEAST && step > 0.0 && share > ROUNDING_SHARE { step / 12f64.sqrt() } else { 0.0 }
    }
}
