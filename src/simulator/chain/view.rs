//! What is read of a chain: made when it is read for the first time.

use core::cell::OnceCell;

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
        self.views.navigation.get_or_init(|| self.navigated())
    }

    #[inline(never)]
    fn navigated(&self) -> Navigation {
        let Self { earth, options, mechanization, block, .. } = self;
        match block {
            None => mechanization.navigation(options.axes),
            Some(block) => {
                block.belief().reference_point(&mechanization.state()).navigation(earth, options.axes)
            }
        }
    }

    /// Makes the view of the truth where it is kept: [`Self::true_view`] makes it elsewhere and moves it, which takes
    /// 60 instructions more.
    #[inline(never)]
    pub fn make_true_view(&mut self, point: &TruthPoint) {
        match point.given(self.options.axes) {
            Some(given) => self.views.truth = OnceCell::from(given),
            None => _ = self.true_view(point),
        }
    }

    /// Makes the view of the solution where it is kept, in the default axes and without a mounting.
    #[inline(never)]
    pub fn make_navigated_view(&mut self) {
        match (&self.block, self.mechanization.earth_fixed()) {
            (None, Some(state)) => {
                self.views.navigation = OnceCell::from(state.navigation(&self.earth, self.options.axes));
            }
            _ => _ = self.navigated_view(),
        }
    }

    /// Navigation minus truth, which is at `point`.
    #[inline(never)]
    pub fn navigation_errors(&self, point: &TruthPoint) -> NavigationErrors {
        self.navigation_errors_inlined(point)
    }

    /// The same without a call, for the reads of the host.
    #[inline(always)]
    pub fn navigation_errors_inlined(&self, point: &TruthPoint) -> NavigationErrors {
        navigation_minus_truth(&self.earth, self.navigated_view(), self.true_view(point))
    }
}
