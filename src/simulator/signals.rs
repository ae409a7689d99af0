//! The increments of the last intervals.

use core::ops::Range;

use crate::base::error::Error;
use crate::base::memory::filled;
use crate::errors::correction::Compensation;
use crate::signal::{Increment, MAX_INCREMENTS};

/// Ideal increments and, unless the INS navigated on these, the increments on which it navigated: measured ones, after the
/// compensation. They are those of the last interval and of the current interval, which use two halves of the memory in turn. On the
/// heap, because 15 KB are large for a stack.
#[derive(Debug, Clone, Default)]
pub(super) struct Signals {
    pub ideal: Box<[Increment]>,
    pub measured: Box<[Increment]>,
}

impl Signals {
    /// Room for both. This is their only allocation.
    pub fn new() -> Result<Self, Error> {
        let increments = || filled(2 * MAX_INCREMENTS, Increment::ZERO);
        Ok(Self { ideal: increments()?, measured: increments()? })
    }

    /// Ideal increments at the places `parts`, and those on which the INS navigated. Ideal sensors measure the ideal increments,
    /// which are not copied.
    #[inline(always)]
    pub fn of(&self, parts: &Range<usize>, on_ideal: bool) -> (&[Increment], &[Increment]) {
        let measured = if on_ideal { &self.ideal } else { &self.measured };
        (&self.ideal[parts.clone()], &measured[parts.clone()])
    }

    /// Compensates the increments at the places `parts`, each over `dt` [s]. Returns their sum before.
    #[cold]
    #[inline(never)]
    pub fn compensate(
        &mut self,
        parts: &Range<usize>,
        on_ideal: bool,
        compensation: &Compensation,
        dt: f64,
    ) -> Increment {
        let measured = &mut self.measured[parts.clone()];
        if on_ideal {
            measured.copy_from_slice(&self.ideal[parts.clone()]);
        }
        compensation.apply(measured, dt)
    }

    /// Place where the increments of an interval begin, if the increments of the interval before begin at `last`.
    #[inline]
    pub fn place_after(last: usize) -> usize {
        if last < MAX_INCREMENTS { MAX_INCREMENTS } else { 0 }
    }
}
