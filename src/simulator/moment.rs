//! Reads of a chain at an instant.

use super::chain::Chain;
use super::{ErrorSource, Solution};
use crate::errors::NavigationErrors;
use crate::mechanization::VerticalMode;
use crate::truth::TruthPoint;

/// A chain while the truth is at `point`.
#[derive(Clone, Copy)]
pub(crate) struct Moment<'a> {
    pub(super) chain: &'a Chain,
    pub(super) point: &'a TruthPoint,
}

impl Moment<'_> {
    /// Time [s].
    pub fn time_s(&self) -> f64 {
        self.point.time_s
    }

    /// Whether the truth is near a pole, where longitude and heading and their errors have no meaning.
    pub fn near_pole(&self) -> bool {
        self.point.is_near_pole()
    }

    /// The solution of the truth.
    #[inline(always)]
    pub fn truth(&self) -> Solution {
        Solution {
            inconsistent: self.chain.closure.last_flagged(),
            ..Solution::new(&self.chain.earth, self.point.time_s, *self.chain.true_view(self.point))
        }
    }

    /// The navigated solution.
    #[inline(always)]
    pub fn navigation(&self) -> Solution {
        let Chain { earth, options, last, north_unknown, .. } = self.chain;
        Solution {
            vertical_unaided: last.vertical_unaided().unwrap_or(options.vertical == VerticalMode::Free),
            north_unknown: *north_unknown,
            inconsistent: self.chain.closure.last_flagged(),
            ..Solution::new(earth, self.point.time_s, *self.chain.navigated_view())
        }
    }

    /// Navigation minus truth.
    #[inline(always)]
    pub fn navigation_errors(&self) -> NavigationErrors {
        self.chain.navigation_errors_inlined(self.point)
    }

    /// Errors of the error model; `None` while the model is off.
    #[inline(always)]
    pub fn model_errors(&self) -> Option<NavigationErrors> {
        let model = self.chain.error_model.as_ref()?;
        let (axes, block) = (self.chain.options.axes, self.chain.block.as_ref());
        Some(model.errors(self.point, self.chain.true_view(self.point), axes, block))
    }

    /// Time [s] and errors of `source`, and whether the truth is near a pole; `None` if the error model is off.
    pub fn errors_and_pole(&self, source: ErrorSource) -> Option<(f64, NavigationErrors, bool)> {
        let errors = match source {
            ErrorSource::Navigation => Some(self.navigation_errors()),
            ErrorSource::Model => self.model_errors(),
        };
        errors.map(|errors| (self.time_s(), errors, self.near_pole()))
    }
}

/// A struct with what the host reads of a moment.
pub(crate) trait View {
    type Struct;

    /// Whether the view reads the truth; `OF_NAVIGATION`: whether it reads the navigated solution.
    const OF_TRUTH: bool;
    const OF_NAVIGATION: bool;

    /// Sets all fields of the struct. It has to be inlined, because it is compiled for each instruction set.
    fn fill(place: &mut Self::Struct, moment: Moment<'_>);
}
