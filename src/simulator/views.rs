//! What is read of the present instant: nothing is computed that nobody reads, and nothing twice.

use core::cell::OnceCell;

use crate::state::Navigation;

/// Each view is made when it is read for the first time; the chain forgets both as it moves on. Errors, which are little more than
/// their difference, are made at each read.
#[derive(Debug, Clone, Default)]
pub(super) struct Views {
    pub truth: OnceCell<Navigation>,
    pub navigation: OnceCell<Navigation>,
}
