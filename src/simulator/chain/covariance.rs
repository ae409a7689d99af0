//! The covariance of the errors along the chain's truth.

use super::Chain;
use crate::earth::state::StateErrors;
use crate::errors::covariance::{NavigationCovariance, Propagation, StartErrors};
use crate::errors::{NavigationErrors, are_linear};
use crate::signal::mounting::Block;
use crate::simulator::Imperfections;
use crate::simulator::start::alignment;
use crate::truth::TruthPoint;

impl Chain {
    /// Takes over the propagation, which begins at the truth `first`.
    #[inline(never)]
    pub fn begin_covariance(
        &mut self,
        covariance: Box<[Propagation]>,
        first: &TruthPoint,
        imperfections: &Imperfections,
    ) {
        self.covariance = covariance;
        let state = self.block.as_ref().map_or(first.state, |block: &Block| block.state(first));
        let initial = &imperfections.set().initial;
        for covariance in &mut *self.covariance {
            let truth = state.navigation(&self.earth, self.options.axes);
            let start = StartErrors {
                first,
                v_e: &state.v_e,
                sigma: StateErrors {
                    position_n: initial.position_sigma_n,
                    velocity_n: initial.velocity_sigma_n,
                    misalignment_n: initial.misalignment_sigma_n,
                },
                alignment: alignment(initial.alignment, &self.earth, first, &state, &truth),
                alignment_s: initial.alignment_s,
            };
            covariance.start(&start, &imperfections.parameters());
        }
    }

    /// Time [s], covariance at `truth`, the last point, and whether this point is near a pole.
    #[inline(never)]
    pub fn covariance(
        &mut self,
        truth: &TruthPoint,
        imperfections: &Imperfections,
    ) -> Option<(f64, NavigationCovariance, bool)> {
        let covariance = self.covariance.first_mut()?;
        let matrix = covariance.read(truth, self.block.as_ref(), &imperfections.parameters());
        // The covariance is that about the mean. Of constant errors this run shows the mean.
        let NavigationErrors { position_n, misalignment_n, .. } = self.navigation_errors(truth);
        let is_small = are_linear(position_n.norm_squared(), misalignment_n.norm_squared());
        let matrix = NavigationCovariance {
            outside_validity: matrix.outside_validity || !is_small,
            without_corrections: self.is_corrected,
            ..matrix
        };
        Some((truth.time_s, matrix, truth.is_near_pole()))
    }
}
