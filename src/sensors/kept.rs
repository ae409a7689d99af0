//! State of an effect, with its value before the current interval.

use core::ops::{Deref, DerefMut};

use crate::base::error::Error;
use crate::base::snapshot::{Numbers, Reader, Stored, Writer};

/// A state that can go back by one interval. Reads and writes go to the current state.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kept<T> {
    now: T,
    before: T,
}

impl<T: Clone> Kept<T> {
    pub fn new(state: T) -> Self {
        Self { before: state.clone(), now: state }
    }

    /// Begins an interval.
    #[inline(always)]
    pub fn keep(&mut self) {
        self.before.clone_from(&self.now);
    }

    /// Begins an interval. Returns the current state.
    #[inline(always)]
    pub fn kept(&mut self) -> T {
        self.before = self.now.clone();
        self.now.clone()
    }

    /// Restores the state of the last [`Self::keep`].
    pub fn undo(&mut self) {
        self.now.clone_from(&self.before);
    }
}

impl<T> Deref for Kept<T> {
    type Target = T;

    #[inline(always)]
    fn deref(&self) -> &T {
        &self.now
    }
}

impl<T> DerefMut for Kept<T> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut T {
        &mut self.now
    }
}

impl<T: PartialEq> PartialEq for Kept<T> {
    fn eq(&self, other: &Self) -> bool {
        self.now == other.now
    }
}

impl<T: Stored> Stored for Kept<T> {
    fn save(&self, to: &mut Writer<'_>) {
        self.now.save(to);
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        self.now.load(from)
    }
}

impl<T: Numbers> Numbers for Kept<T> {
    fn save(&self, to: &mut Writer<'_>) {
        self.now.save(to);
    }

    fn load(&mut self, from: &mut Reader<'_>, limit: f64) -> Result<(), Error> {
        self.now.load(from, limit)
    }
}
