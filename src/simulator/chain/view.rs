//! Views of a chain, which are computed when they are read for the first time.

use core::cell::OnceCell;

use super::Chain;
use crate::base::instruction_set::{InstructionSet, Work};
use crate::earth::state::Navigation;
use crate::errors::{NavigationErrors, navigation_minus_truth};
use crate::simulator::{Moment, View};
use crate::truth::TruthPoint;

/// Views of the current instant. Each view is computed when it is read for the first time. The chain drops both views as it moves on.
/// Errors are computed at each read, because they are little more than the difference of the views.
#[derive(Debug, Clone, Default)]
pub(in crate::simulator) struct Views {
    pub truth: OnceCell<Navigation>,
    pub navigation: OnceCell<Navigation>,
}

impl Chain {
    /// The truth, which is at `point`.
    #[inline(always)]
    pub fn true_view(&self, point: &TruthPoint) -> &Navigation {
        let Self { earth, options, views, .. } = self;
        views.truth.get_or_init(|| point.navigation(earth, options.axes))
    }

    /// The INS's output for the reference point.
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

    /// Fills a struct of the host with what `V` reads while the truth is at `point`.
    #[inline(always)]
    pub fn fill<V: View>(&mut self, set: InstructionSet, point: &TruthPoint, place: &mut V::Struct) {
        if V::OF_TRUTH && self.views.truth.get().is_none() {
            set.run(TrueView { chain: self, point });
        }
        if V::OF_NAVIGATION && self.views.navigation.get().is_none() {
            set.run(NavigatedView { chain: self });
        }
        set.run(Filling::<V> { moment: Moment { chain: self, point }, place });
    }

    /// Navigation minus truth, which is at `point`.
    #[inline(never)]
    pub fn navigation_errors(&self, point: &TruthPoint) -> NavigationErrors {
        self.navigation_errors_inlined(point)
    }

    /// Navigation minus truth, which is at `point`; inlined, for the reads of the host.
    #[inline(always)]
    pub fn navigation_errors_inlined(&self, point: &TruthPoint) -> NavigationErrors {
        navigation_minus_truth(&self.earth, self.navigated_view(), self.true_view(point))
    }
}

/// Computes the view of the truth in its final place. [`Chain::true_view`] computes it elsewhere and moves it, which takes 60
/// instructions more.
struct TrueView<'a> {
    chain: &'a mut Chain,
    point: &'a TruthPoint,
}

impl Work for TrueView<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { chain, point } = self;
        match point.given(chain.options.axes) {
            Some(given) => chain.views.truth = OnceCell::from(given),
            None => _ = chain.true_view(point),
        }
    }
}

/// Computes the view of the solution in its final place, for a mechanization in Earth-fixed axes without a mounting.
struct NavigatedView<'a> {
    chain: &'a mut Chain,
}

impl Work for NavigatedView<'_> {
    #[inline(always)]
    fn run(self) {
        let chain = self.chain;
        match (&chain.block, chain.mechanization.earth_fixed()) {
            (None, Some(state)) => {
                let navigation = state.navigation_inlined(&chain.earth, chain.options.axes);
                chain.views.navigation = OnceCell::from(navigation);
            }
            _ => _ = chain.navigated_view(),
        }
    }
}

/// Fills a struct of the host.
struct Filling<'a, V: View> {
    moment: Moment<'a>,
    place: &'a mut V::Struct,
}

impl<V: View> Work for Filling<'_, V> {
    #[inline(always)]
    fn run(self) {
        V::fill(self.place, self.moment);
    }
}
