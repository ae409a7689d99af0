//! Numbers, single and in arrays. Each has a limit of its size, which is checked when it is read.

use nalgebra::{Quaternion, SMatrix};

use super::{Reader, Writer};
use crate::base::error::{Error, Rule};
use crate::base::math::Compensated;

/// Limit of numbers that are checked elsewhere, or that only must be finite.
pub(crate) const ANY: f64 = f64::MAX;

/// Limit of counters: no run is long enough to reach it.
pub(crate) const COUNT: f64 = 9e15;

/// Limit of clocks [s]: no run is long enough to reach it.
pub(crate) const CLOCK_S: f64 = 1e12;

/// The clock at `time_s` [s], moved by `shift_s` [s] within [`CLOCK_S`].
pub(crate) fn moved_clock(time_s: f64, shift_s: f64) -> f64 {
    (time_s + shift_s).clamp(-CLOCK_S, CLOCK_S)
}

/// Limit of signals, their integrals and the outputs of sensors [u, u s]: larger than all that accepted samples and parameters give,
/// and with finite squares.
pub(crate) const SIGNALS: f64 = 1e120;

/// Limit of values that a sensor moves on from step to step: so large that each step is lost in its rounding. So no step leads beyond
/// it, and its integral over the longest interval is within [`SIGNALS`].
pub(crate) const WALKS: f64 = 1e100;

/// Why a sum of squares is rejected.
pub(crate) const NO_SQUARE: &str = "must be a square";

/// Largest carry of a compensated sum as a share of the sum, with some room: half a unit in the last place is 1.1e-16.
const CARRY_SHARE: f64 = 1e-14;

/// One number or several of a kind.
pub(crate) trait Numbers {
    fn save(&self, to: &mut Writer<'_>);
    /// Each has to be finite and within ±`limit`.
    fn load(&mut self, from: &mut Reader<'_>, limit: f64) -> Result<(), Error>;
}

impl Numbers for f64 {
    #[inline]
    fn save(&self, to: &mut Writer<'_>) {
        to.word(self.to_bits());
    }

    fn load(&mut self, from: &mut Reader<'_>, limit: f64) -> Result<(), Error> {
        let value = Self::from_bits(from.word()?);
        // False for NaN too.
        if value.abs() <= limit {
            *self = value;
            return Ok(());
        }
        let rule = if value.is_finite() { Rule::Between(-limit, limit) } else { Rule::Finite };
        Err(from.refused(value, rule))
    }
}

impl Numbers for u64 {
    fn save(&self, to: &mut Writer<'_>) {
        to.word(*self);
    }

    fn load(&mut self, from: &mut Reader<'_>, limit: f64) -> Result<(), Error> {
        let value = from.word()?;
        if value as f64 > limit {
            return Err(from.refused(value, Rule::BetweenIntegers(0, limit as u64)));
        }
        *self = value;
        Ok(())
    }
}

impl Numbers for usize {
    fn save(&self, to: &mut Writer<'_>) {
        to.count(*self);
    }

    fn load(&mut self, from: &mut Reader<'_>, limit: f64) -> Result<(), Error> {
        *self = from.count(limit as Self)?;
        Ok(())
    }
}

impl<T: Numbers, const N: usize> Numbers for [T; N] {
    #[inline]
    fn save(&self, to: &mut Writer<'_>) {
        self.iter().for_each(|number| number.save(to));
    }

    fn load(&mut self, from: &mut Reader<'_>, limit: f64) -> Result<(), Error> {
        self.iter_mut().try_for_each(|number| number.load(from, limit))
    }
}

impl<const R: usize, const C: usize> Numbers for SMatrix<f64, R, C> {
    #[inline]
    fn save(&self, to: &mut Writer<'_>) {
        self.iter().for_each(|number| number.save(to));
    }

    fn load(&mut self, from: &mut Reader<'_>, limit: f64) -> Result<(), Error> {
        self.iter_mut().try_for_each(|number| number.load(from, limit))
    }
}

impl Numbers for Quaternion<f64> {
    fn save(&self, to: &mut Writer<'_>) {
        self.coords.save(to);
    }

    fn load(&mut self, from: &mut Reader<'_>, limit: f64) -> Result<(), Error> {
        self.coords.load(from, limit)
    }
}

impl<const N: usize> Numbers for Compensated<N> {
    #[inline]
    fn save(&self, to: &mut Writer<'_>) {
        let Self { value, carry } = self;
        Numbers::save(value, to);
        Numbers::save(carry, to);
    }

    fn load(&mut self, from: &mut Reader<'_>, limit: f64) -> Result<(), Error> {
        let Self { value, carry } = self;
        value.load(from, limit)?;
        carry.load(from, limit * CARRY_SHARE)
    }
}

impl<T: Numbers + Default> Numbers for Option<T> {
    fn save(&self, to: &mut Writer<'_>) {
        to.flag(self.is_some());
        if let Some(numbers) = self {
            numbers.save(to);
        }
    }

    fn load(&mut self, from: &mut Reader<'_>, limit: f64) -> Result<(), Error> {
        *self = if from.flag()? {
            let mut numbers = T::default();
            numbers.load(from, limit)?;
            Some(numbers)
        } else {
            None
        };
        Ok(())
    }
}

impl Numbers for (f64, f64) {
    fn save(&self, to: &mut Writer<'_>) {
        [self.0, self.1].save(to);
    }

    fn load(&mut self, from: &mut Reader<'_>, limit: f64) -> Result<(), Error> {
        self.0.load(from, limit)?;
        self.1.load(from, limit)
    }
}
