//! Views of the current instant. Only views that are read are computed, and each only once.

use core::cell::OnceCell;

use crate::state::Navigation;

/// Each view is computed when it is read for the first time. The chain drops both views as it moves on. Errors are computed at each
/// read, because they are little more than the difference of the views.
#[derive(Debug, Clone, Default)]
pub(super) struct Views {
    pub truth: OnceCell<Navigation>,
    pub navigation: OnceCell<Navigation>,
}
