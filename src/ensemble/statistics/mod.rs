//! Statistics of the errors of many runs, which do not depend on how the work was split: integer sums, so that merging is exactly
//! associative and commutative.

mod check;
mod figures;
mod layout;
mod meets;
mod radial;

pub use figures::Figures;
pub use layout::sins_statistics as Statistics;
pub use meets::{Decision, Verdict};
pub use radial::RADIAL_ERROR;

use crate::base::error::{Error, check_integer};
use crate::base::math::nearest_integer;
use crate::errors::NavigationErrors;
use radial::bucket_of;

/// Largest number of runs in statistics: with more runs the sums could overflow.
pub const MAX_RUNS: u32 = u32::MAX;

/// Version of the layout that this release writes and reads.
const LAYOUT: u32 = 1;

/// East, north and up of position, velocity and misalignment.
const STATES: usize = 9;

/// Products of two states, each pair once.
const PRODUCTS: usize = STATES * (STATES + 1) / 2;

/// The resolution of each state is 2 to the power of minus this number [m, m/s, rad]; its range is 2^47 resolutions.
const FRACTION_BITS: [u32; STATES] = [22, 22, 22, 29, 29, 29, 45, 45, 45];

/// Bits of the largest state.
const STATE_BITS: u32 = 47;

/// The resolution of a state with `bits` bits behind the binary point.
fn resolution(bits: u32) -> f64 {
    1.0 / (1_u64 << bits) as f64
}

impl Default for Statistics {
    /// Of no run.
    fn default() -> Self {
        Self::EMPTY
    }
}

impl Statistics {
    /// Of no run.
    pub const EMPTY: Self = Self {
        struct_size: size_of::<Self>() as u32,
        layout: 0,
        runs: 0,
        diverged: 0,
        out_of_range: 0,
        outside_validity: 0,
        largest_radial: 0,
        sums: [0; 2 * STATES],
        products: [0; 2 * PRODUCTS],
        histogram: [0; radial::BUCKETS],
        reserved: 0,
    };

    /// Σ x of a state [resolutions].
    fn sum(&self, state: usize) -> i128 {
        wide(&self.sums, state)
    }

    /// Σ x y of two states [resolutions squared].
    fn product(&self, row: usize, column: usize) -> i128 {
        wide(&self.products, place_of(row, column))
    }

    /// Runs within the sums.
    pub fn good(&self) -> u64 {
        self.runs.saturating_sub(self.diverged).saturating_sub(self.out_of_range)
    }

    /// Adds a run with these errors. A run that is out of range is counted and left out of the sums.
    ///
    /// [`ErrorKind::InvalidArgument`]: there are [`MAX_RUNS`] already.
    pub fn add(&mut self, errors: &NavigationErrors) -> Result<(), Error> {
        self.add_run()?;
        match quantized(errors) {
            Some((states, radial)) => self.add_states(&states, radial, errors.outside_validity),
            None => self.out_of_range += 1,
        }
        Ok(())
    }

    /// Adds a run that has diverged.
    ///
    /// [`ErrorKind::InvalidArgument`]: there are [`MAX_RUNS`] already.
    pub fn add_diverged(&mut self) -> Result<(), Error> {
        self.add_run()?;
        self.diverged += 1;
        Ok(())
    }

    fn add_run(&mut self) -> Result<(), Error> {
        check_runs(self.runs + 1)?;
        self.layout = LAYOUT;
        self.runs += 1;
        Ok(())
    }

    fn add_states(&mut self, states: &[i64; STATES], radial: u64, outside_validity: bool) {
        let mut product = 0;
        for (row, &x) in states.iter().enumerate() {
            add(&mut self.sums, row, i128::from(x));
            for &y in &states[row..] {
                add(&mut self.products, product, i128::from(x) * i128::from(y));
                product += 1;
            }
        }
        self.outside_validity += u64::from(outside_validity);
        self.largest_radial = self.largest_radial.max(radial);
        self.histogram[bucket_of(radial)] += 1;
    }

    /// Adds the runs of `from`, none of which may be in these statistics. Any order and any grouping of merges gives the same bits.
    ///
    /// [`ErrorKind::InvalidArgument`]: one of the two is damaged or of another release, or there would be more than
    /// [`MAX_RUNS`] runs; then nothing has changed.
    pub fn merge(&mut self, from: &Self) -> Result<(), Error> {
        self.check()?;
        from.check()?;
        check_runs(self.runs + from.runs)?;
        if from.runs == 0 {
            return Ok(());
        }
        self.layout = LAYOUT;
        self.runs += from.runs;
        self.diverged += from.diverged;
        self.out_of_range += from.out_of_range;
        self.outside_validity += from.outside_validity;
        self.largest_radial = self.largest_radial.max(from.largest_radial);
        for state in 0..STATES {
            add(&mut self.sums, state, from.sum(state));
        }
        for product in 0..PRODUCTS {
            add(&mut self.products, product, wide(&from.products, product));
        }
        for (count, more) in self.histogram.iter_mut().zip(&from.histogram) {
            *count += more;
        }
        Ok(())
    }
}

fn check_runs(runs: u64) -> Result<(), Error> {
    check_integer("statistics.runs", runs, 0, MAX_RUNS.into())
}

/// The states and the horizontal radial error in their resolutions, unless one is out of range.
fn quantized(errors: &NavigationErrors) -> Option<([i64; STATES], u64)> {
    let values = [errors.position_n, errors.velocity_n, errors.misalignment_n];
    let mut states = [0; STATES];
    for (state, (value, bits)) in
        states.iter_mut().zip(values.iter().flat_map(|part| part.iter()).zip(FRACTION_BITS))
    {
        let scaled = value * (1_u64 << bits) as f64;
        let most = (1_u64 << STATE_BITS) as f64;
        if !(-most - 0.5..=most + 0.5).contains(&scaled) {
            return None;
        }
        *state = nearest_integer(scaled) as i64;
    }
    let square = |x: i64| u128::from(x.unsigned_abs()).pow(2);
    let radial = (square(states[0]) + square(states[1])).isqrt() as u64;
    (radial < 1 << STATE_BITS).then_some((states, radial))
}

/// The place of the product of two states among [`PRODUCTS`]: the upper triangle of their matrix, row by row.
fn place_of(row: usize, column: usize) -> usize {
    let (row, column) = (row.min(column), row.max(column));
    row * (2 * STATES - row + 1) / 2 + (column - row)
}

/// Number `index` of `words`, integers of 128 bits in two words, the low one first.
#[inline]
fn wide(words: &[u64], index: usize) -> i128 {
    (u128::from(words[2 * index]) | u128::from(words[2 * index + 1]) << 64) as i128
}

/// Adds to number `index` of `words`.
#[inline]
fn add(words: &mut [u64], index: usize, number: i128) {
    let sum = wide(words, index) + number;
    words[2 * index] = sum as u64;
    words[2 * index + 1] = (sum >> 64) as u64;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_add_up_and_leave_their_neighbours() {
        let mut words = [0; 6];
        let mut sum = 0;
        for number in [1, -3, 1 << 64, (1 << 126) - 12345, -(1 << 126), -(1 << 64)] {
            add(&mut words, 1, number);
            sum += number;
            assert_eq!([0, 1, 2].map(|index| wide(&words, index)), [0, sum, 0]);
        }
        add(&mut words, 0, -2);
        assert_eq!(words[..2], [u64::MAX - 1, u64::MAX]);
    }
}
