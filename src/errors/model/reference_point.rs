//! Errors of the reference point, from the errors of a sensor block that is mounted away from it.

use nalgebra::Vector3;

use super::earth_fixed::EarthFixedForm;
use super::geographic::GeographicForm;
use super::geometry::LocalGeometry;
use super::{ErrorModel, Form, states_of};
use crate::base::math::axis_cross;
use crate::earth::state::StateErrors;
use crate::signal::mounting::{Block, MountingErrors};
use crate::truth::TruthPoint;

impl ErrorModel {
    /// Removes `errors` of the reference point at `truth`. With a mounting, the errors of the block that are removed follow from the
    /// equations of [`Self::of_reference_point`].
    pub(crate) fn correct(&mut self, truth: &TruthPoint, block: Option<&Block>, errors: &StateErrors) {
        let local = LocalGeometry::new(&self.earth, &truth.vertical());
        let mut removed = EarthFixedForm::new(&local, &truth.state.v_e, errors);
        let (mut at_block, mut v_e) = (local, truth.state.v_e);
        if let Some(block) = block {
            let (state, mounting) = (block.state(truth), block.errors());
            let displacement = removed.psi.cross(&(truth.to_earth * mounting.arm_b));
            removed.dr -= displacement;
            removed.dv += axis_cross(self.earth.rate_rad_s, &displacement)
                - removed.psi.cross(&(truth.to_earth * mounting.arm_rate_b));
            at_block = LocalGeometry::new(&self.earth, &self.earth.vertical(&state.r_e));
            v_e = state.v_e;
        }
        let mut form = match self.form {
            Form::EarthFixed(_) => Form::EarthFixed(removed),
            Form::Geographic(_) => {
                Form::Geographic(GeographicForm::new(&at_block, &removed.errors(&at_block, &v_e)))
            }
        };
        for (error, removed) in self.state().into_iter().zip(states_of(&mut form)) {
            *error -= *removed;
        }
        self.keep_within();
    }

    /// Errors of the reference point, with the believed arm l~, its velocity u~ relative to inertial axes, and the errors of the
    /// mounting itself (`_m`):
    /// ```text
    /// δr = δr_s + ψ×l~ + δr_m
    /// δv = δv_s + ψ×u~ + δv_m - W×(δr - δr_s)
    /// ψ  = ψ_s + ψ_m
    /// ```
    /// in Earth-fixed terms, because the local axes of a solution lean with its position.
    pub(super) fn of_reference_point(&self, truth: &TruthPoint, block: &Block) -> StateErrors {
        self.of_reference_point_by(truth, block, &block.errors())
    }

    /// Errors of the reference point with the mounting errors `mounting`.
    pub(super) fn of_reference_point_by(
        &self,
        truth: &TruthPoint,
        block: &Block,
        mounting: &MountingErrors,
    ) -> StateErrors {
        let state = block.state(truth);
        let at_block = LocalGeometry::new(&self.earth, &self.earth.vertical(&state.r_e));
        let of_block = self.in_local_terms(&at_block, &state.v_e);
        let mut errors = EarthFixedForm::new(&at_block, &state.v_e, &of_block);

        let from_body = |v_b: &Vector3<f64>| truth.to_earth * v_b;
        let displacement = errors.psi.cross(&from_body(&mounting.arm_b)) + from_body(&mounting.position_b);
        errors.dr += displacement;
        errors.dv += errors.psi.cross(&from_body(&mounting.arm_rate_b)) + from_body(&mounting.velocity_b)
            - axis_cross(self.earth.rate_rad_s, &displacement);
        errors.psi += from_body(&mounting.misalignment_b);
        errors.errors(&LocalGeometry::new(&self.earth, &truth.vertical()), &truth.state.v_e)
    }
}
