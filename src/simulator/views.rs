//! What is read of the present instant: nothing is computed that nobody reads, and nothing twice.

use core::cell::OnceCell;

use crate::errors::NavigationErrors;
use crate::state::Navigation;

/// Each view is made when it is read for the first time; the chain forgets them all as it moves on.
#[derive(Debug, Clone, Default)]
pub(super) struct Views {
    pub truth: OnceCell<Navigation>,
    pub navigation: OnceCell<Navigation>,
    /// Navigation minus truth.
    pub difference: OnceCell<NavigationErrors>,
    /// Of the error model.
    pub model: OnceCell<NavigationErrors>,
}
