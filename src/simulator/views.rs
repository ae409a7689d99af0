//! What is read of the present instant: nothing is computed that nobody reads, and nothing twice.

use core::cell::Cell;

use crate::errors::NavigationErrors;
use crate::state::Navigation;

/// The chain forgets them all as it moves on.
#[derive(Debug, Clone, Default)]
pub(super) struct Views {
    pub truth: View<Navigation>,
    pub navigation: View<Navigation>,
    /// Navigation minus truth.
    pub difference: View<NavigationErrors>,
    /// Of the error model.
    pub model: View<NavigationErrors>,
}

/// Made when it is read for the first time.
#[derive(Debug, Clone)]
pub(super) struct View<T: Copy>(Cell<Option<T>>);

impl<T: Copy> Default for View<T> {
    fn default() -> Self {
        Self(Cell::new(None))
    }
}

impl<T: Copy> View<T> {
    /// What `make` makes. A copy, of which only what is used is copied where this is inlined.
    #[inline(always)]
    pub fn get_or_make(&self, make: impl Fn() -> T) -> T {
        loop {
            if let Some(value) = self.0.get() {
                return value;
            }
            self.keep(&make);
        }
    }

    /// Made from now on.
    #[inline(always)]
    pub fn made(&self, make: impl FnOnce() -> T) -> &Self {
        if self.0.get().is_none() {
            self.keep(make);
        }
        self
    }

    /// `None` before it was made.
    #[inline(always)]
    pub fn get(&self) -> Option<T> {
        self.0.get()
    }

    #[inline(never)]
    fn keep(&self, make: impl FnOnce() -> T) {
        self.0.set(Some(make()));
    }
}
