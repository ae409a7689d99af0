//! Corrections by the host in flight.

use super::Chain;
use crate::base::error::Error;
use crate::earth::state::StateErrors;
use crate::errors::correction::{Compensation, Correction};
use crate::mechanization::Mechanization;
use crate::signal::mounting::Block;
use crate::simulator::chain::view::Views;
use crate::truth::TruthPoint;

impl Chain {
    /// Removes the errors of `correction` from the solution and from the error model, while the truth is at `point`. On an error
    /// nothing has changed.
    #[inline(never)]
    pub fn correct(&mut self, point: &TruthPoint, correction: &Correction) -> Result<(), Error> {
        if *correction == Correction::default() {
            return Ok(());
        }
        let compensation = Compensation::sum(self.compensation.as_ref(), &correction.sensors)?;
        let before = self.mechanization;
        if correction.errors != StateErrors::NONE {
            let belief = self.block.as_ref().map(Block::belief);
            let own = before.state();
            let state = belief.as_ref().map_or(own, |belief| belief.reference_point(&own));
            let state = correction.corrected(&self.earth, &state)?;
            let state = belief.as_ref().map_or(state, |belief| belief.block(&state));
            self.mechanization = before.moved_to(&state);
            if let Err(error) = self.check() {
                self.mechanization = before;
                return Err(error);
            }
            if let Some(model) = &mut self.error_model {
                model.correct(point, self.block.as_ref(), &correction.errors);
            }
            self.views = Views::default();
        }
        self.part_from_shadow(&before);
        self.compensation = compensation;
        self.is_corrected = !self.covariance.is_empty();
        Ok(())
    }

    /// Begins the loops of the vertical channel anew whose estimate is beyond `limit_m_s2`. That of the shadow, which is free of errors, is
    /// not.
    pub fn limit_vertical_bias(&mut self, limit_m_s2: f64) {
        self.mechanization.limit_vertical_bias(limit_m_s2);
        if let Some(model) = &mut self.error_model {
            model.limit_vertical_bias(limit_m_s2);
        }
    }

    /// From now on the navigator has errors of its own: the closed loop needs a shadow, which continues from `navigator`.
    pub fn part_from_shadow(&mut self, navigator: &Mechanization) {
        if let Some(closed_loop) = &mut self.closed_loop {
            closed_loop.shadow(navigator, true);
        }
    }
}
