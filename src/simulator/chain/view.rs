//! What is read of a chain: made when it is read for the first time.

use super::Chain;
use crate::errors::{NavigationErrors, navigation_minus_truth};
use crate::state::Navigation;
use crate::truth::TruthPoint;

impl Chain {
    /// The truth, which is at `point`.
    #[inline(always)]
    pub fn true_view(&self, point: &TruthPoint) -> &Navigation {
        let Self { earth, options, views, .. } = self;
        views.truth.get_or_init(|| point.navigation(earth, options.axes))
    }

    /// What the INS gives out, of the reference point.
    #[inline(always)]
    pub fn navigated_view(&self) -> &Navigation {
        let Self { earth, options, mechanization, block, views, .. } = self;
        views.navigation.get_or_init(|| match block {
            None => mechanization.navigation(options.axes),
            Some(block) => {
                block.belief().reference_point(&mechanization.state()).navigation(earth, options.axes)
            }
        })
    }

    /// Navigation minus truth, which is at `point`.
    #[inline(always)]
    pub fn navigation_errors(&self, point: &TruthPoint) -> NavigationErrors {
        navigation_minus_truth(&self.earth, self.navigated_view(), self.true_view(point))
    }
}
